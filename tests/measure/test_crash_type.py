"""What kind of crash a crash is, and what is only waiting."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from chatscene.measure.crash_type import crash_type, waits
from chatscene.terms.episode import Ending, Episode, Event, EventKind, Role, Track

DT = 0.1


def track(actor: str, role: Role, x: float, y: float, heading: float, speed: float, steps: int = 60) -> Track:
    """Somebody who goes straight on, from a pose at step 0."""
    time = np.arange(steps) * DT
    return Track(
        actor=actor,
        role=role,
        kind="Car",
        length=4.9,
        width=2.1,
        x=np.asarray(x + speed * time * math.cos(heading), dtype=np.float64),
        y=np.asarray(y + speed * time * math.sin(heading), dtype=np.float64),
        heading=np.full(steps, heading),
        speed=np.full(steps, speed),
    )


def episode(ego_speed: float, *others: Track, crash_at: int | None = None, side: str = "front") -> Episode:
    crash = Event(kind=EventKind.COLLISION, step=crash_at or 0, other="adversary", side=side, impact_speed=8.0)
    return Episode(
        scene_id="s",
        ego="toy",
        dt=DT,
        tracks=(track("ego", Role.EGO, 0.0, 0.0, 0.0, ego_speed), *others),
        events=() if crash_at is None else (crash,),
        signals=(),
        ending=Ending.TIMEOUT if crash_at is None else Ending.COLLISION,
        route_completion=0.5,
        distance_to_route=np.zeros(60),
        off_road=np.zeros(60, dtype=bool),
    )


def ahead(gap: float, speed: float = 0.0, heading: float = 0.0) -> Track:
    return track("adversary", Role.ADVERSARY, 4.9 + gap, 0.0, heading, speed)


def test_a_crash_type_says_who_struck_whom_with_what_which_way_how_hard_and_where() -> None:
    driven = episode(8.0, ahead(12.0, speed=2.0), crash_at=20)
    assert crash_type(driven) == "ego-into-adversary, front and Car rear, same way, S1, after 10 m"


def test_a_crash_with_somebody_who_comes_the_other_way_is_of_another_type() -> None:
    driven = episode(8.0, ahead(12.0, speed=1.0, heading=math.pi), crash_at=14)
    assert crash_type(driven) == "ego-into-adversary, front and Car front, oncoming, S1, after 10 m"


def test_values_alone_make_no_other_type() -> None:
    one, other = (episode(8.0, ahead(gap, speed=2.0), crash_at=20) for gap in (12.0, 11.95))
    assert crash_type(one) == crash_type(other)


def test_without_a_crash_there_is_no_type() -> None:
    assert not crash_type(episode(8.0, ahead(80.0)))


def test_an_ego_that_stands_behind_somebody_who_stands_waits() -> None:
    assert waits(episode(0.0, ahead(3.0)))


def test_an_ego_that_drives_or_stands_alone_or_behind_somebody_who_moves_does_not_wait() -> None:
    assert not waits(episode(1.0, ahead(3.0)))
    assert not waits(episode(0.0))
    assert not waits(episode(0.0, ahead(30.0)))
    assert not waits(episode(0.0, ahead(3.0, speed=1.0)))


def test_somebody_who_stood_for_less_than_three_seconds_is_not_yet_waited_for() -> None:
    stops = ahead(3.0)
    late = replace(stops, speed=np.where(np.arange(60) < 40, 2.0, 0.0))
    early = replace(stops, speed=np.where(np.arange(60) < 20, 2.0, 0.0))
    assert not waits(episode(0.0, late))
    assert waits(episode(0.0, early))


def test_a_crash_is_no_waiting() -> None:
    assert not waits(episode(0.0, ahead(0.0), crash_at=30))
