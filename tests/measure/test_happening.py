"""What happened in a drive, from its tracks."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from chatscene.measure.happening import happened
from chatscene.report.span import span
from chatscene.report.what_happened import kept_in_words, outcome_in_words
from chatscene.terms.arrays import Array
from chatscene.terms.criticality import Happening
from chatscene.terms.episode import Ending, Episode, Event, EventKind, Role, Track

STEPS, DT = 201, 0.1
TIME = np.arange(STEPS) * DT


def track(name: str, x: object, y: object, speed: object, *, heading: float = 0.0) -> Track:
    def rows(values: object) -> Array:
        return np.broadcast_to(np.asarray(values, dtype=float), STEPS).copy()

    role = Role.EGO if name == "ego" else Role.ADVERSARY
    return Track(actor=name, role=role, kind="Car", length=4.5, width=2.0, x=rows(x), y=rows(y), heading=rows(heading),
                 speed=rows(speed))  # fmt: skip


def drive(ego: Track, *others: Track, events: tuple[Event, ...] = (), aside: object = 0.0) -> Episode:
    return Episode(
        scene_id="s", ego="idm", dt=DT, tracks=(ego, *others), events=events, signals=(), ending=Ending.OVER,
        route_completion=0.5, distance_to_route=np.broadcast_to(np.asarray(aside, dtype=float), STEPS).copy(),
        off_road=np.zeros(STEPS, dtype=bool),
    )  # fmt: skip


EVEN = track("ego", 8.0 * TIME, 0.0, 8.0)
FAR = track("other", 500.0, 50.0, 0.0)
STOPS_AT = 10.0
BRAKES = np.where(TIME < STOPS_AT, 8.0, np.maximum(8.0 - 6.0 * (TIME - STOPS_AT), 0.0))
STOPPING = track("ego", np.cumsum(BRAKES) * DT, 0.0, BRAKES)


@pytest.mark.parametrize(
    ("episode", "kind", "at"),
    [
        (drive(EVEN, FAR), Happening.NOTHING, 20.0),
        (drive(EVEN, track("other", 80.0, 3.0, 0.0)), Happening.NEAR, 10.4),
        (drive(EVEN, track("other", 80.0, 20.0 - 2.0 * TIME, 2.0, heading=-np.pi / 2)), Happening.NEAR_IN_TIME, 9.5),
        (drive(STOPPING, FAR), Happening.BRAKING, 10.4),
        (drive(EVEN, FAR, aside=np.clip(TIME - 5.0, 0.0, 1.5)), Happening.STEERING, 6.5),
        (drive(EVEN, FAR, events=(Event(kind=EventKind.COLLISION, step=70, other="other"),)), Happening.COLLISION, 7.0),
    ],
)
def test_the_gravest_is_told_and_when(episode: Episode, kind: Happening, at: float) -> None:
    found = happened(episode)
    assert (found.kind, found.step * DT) == (kind, pytest.approx(at, abs=0.6))


def test_to_follow_at_the_same_speed_is_no_encounter() -> None:
    follows = drive(EVEN, track("other", 8.0 * TIME + 12.0, 0.0, 8.0))
    assert (happened(follows).kind, happened(follows).seconds) == (Happening.NOTHING, None)


def test_what_is_shown_begins_shortly_before_and_ends_shortly_after_and_before_all_stand() -> None:
    shown = span(drive(EVEN, track("other", 80.0, 3.0, 0.0)))
    assert 5.0 <= shown.first * DT < shown.moment * DT < 11.0 <= shown.last * DT < 13.0
    standing = span(drive(STOPPING, track("other", float(STOPPING.x[-1]) + 6.0, 0.0, 0.0)))
    assert standing.last * DT < STOPS_AT + 2.0


ROW = {"selected": True, "collision": False, "ending": "over", "distance": 2.46, "gap_in_time": 1.12,
       "impact_speed": None}  # fmt: skip


def test_kept_scenes_are_told_by_what_happened_in_them() -> None:
    soon, dull = ROW | {"happened": "near-in-time"}, ROW | {"happened": "nothing"}
    crash = ROW | {"happened": "collision", "collision": True, "impact_speed": 5.2}
    assert kept_in_words([soon, dull, crash, ROW | {"selected": False}]) == (
        "1 collision with an impact speed of 19 km/h, 1 with a smallest gap of 1.1 s, 1 without a near miss"
    )
    assert kept_in_words([soon, soon | {"gap_in_time": 0.4}]) == "2 with smallest gaps of 0.4 to 1.1 s"
    assert kept_in_words([ROW]) == "", "a folder of before does not tell"
    assert [outcome_in_words(row) for row in (crash, soon, dull, ROW)] == [
        "collision",
        "smallest gap 1.1 s",
        "smallest gap 2.5 m",
        "over",
    ]


def test_a_drive_that_is_cut_short_by_a_collision_is_shown_to_that() -> None:
    crash = drive(EVEN, FAR, events=(Event(kind=EventKind.COLLISION, step=200, other="other"),))
    assert span(replace(crash)).last == 200


def test_who_comes_before_an_ego_as_fast_as_itself_is_near_in_time() -> None:
    over = track("other", 15.0 + 8.0 * TIME, np.clip(3.5 - (TIME - 5.0), 0.0, 3.5), 8.0)
    found = happened(drive(EVEN, over))
    assert found.kind is Happening.NEAR_IN_TIME
    assert found.seconds == pytest.approx((15.0 - 4.5) / 8.0, abs=0.05)
    assert found.step * DT == pytest.approx(6.5, abs=0.3)
