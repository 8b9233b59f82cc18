"""The judge sees on the tracks what was said, and sees that what was not done was not."""

from __future__ import annotations

from functools import cache
from typing import Any

import pytest
from test_building import WRITTEN, built, drive, simulator, situation

from chatscene.program.doing import ACTS
from chatscene.program.judge import Finding, failures, judge
from chatscene.program.starting import STARTS
from chatscene.situations.facts import with_fact
from chatscene.terms.episode import Episode
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import Act, Where

SEEDS = (1, 2, 3)
LEADER = "a leader stops, the one behind it swerves"
CHILD = "a child runs out from behind a parked car"
TWO = "two pedestrians step out from the right and stop"
LEFT = "an oncoming car turns left while we go straight on at a green light"
RED = "a truck runs a red light from the left, we want 30 km/h"
BRAKES = "the car ahead brakes with 4 m/s²"


@cache
def driven(name: str, seed: int = 1) -> Episode:
    episode = drive(built(name), seed=seed)
    assert isinstance(episode, Episode), episode
    return episode


def judged(name: str, said: Situation, seed: int = 1) -> tuple[Finding, ...]:
    one = built(name)
    return judge(said, driven(name, seed), simulator(one.map, "native").route(one.program, 0))


TO_MEND = {
    "we wait at a red light and set off, a scooter comes from the right": "it comes seconds after the ego",
    "we turn right, a cyclist beside us goes straight on": "it falls back before the ego turns",
    "a leader stops, the one behind it swerves": "it brakes at first, and is driven through",
}
"""What drives show of situations that are not built as they were said: seen by the judge, and not yet mended."""


@pytest.mark.parametrize("name", WRITTEN)
def test_what_is_built_is_seen(name: str) -> None:
    for seed in SEEDS:
        assert failures(judged(name, situation(name), seed), met=name not in TO_MEND) == ()


@pytest.mark.parametrize("name", WRITTEN)
def test_every_deed_that_tracks_can_tell_has_a_finding_with_its_moment(name: str) -> None:
    said = situation(name)
    found = {one.path: one for one in judged(name, said)}
    for other in said.others:
        for k, deed in enumerate(other.does):
            if deed.act in ACTS:
                assert found[f"others.{other.id}.does.{k}.act"].at is not None


@pytest.mark.parametrize(
    ("name", "path", "value", "told"),
    [
        (BRAKES, "others.A.does.0.act", "accelerate", "said accelerate, but it never does"),
        (BRAKES, "others.A.does.0.acceleration", "8 m/s²", "said 8 m/s², it changes speed by"),
        (BRAKES, "others.A.kind", "truck", "said truck, it is a car"),
        (BRAKES, "others.A.starts.distance", "40 m", "said 40 m, it starts this far:"),
        (BRAKES, "others.A.starts.where", "behind", "said behind, it starts"),
        (BRAKES, "ego.route", "left-turn", "said left-turn, its route goes straight"),
        (BRAKES, "ego.speed", "60 km/h", "said 60 km/h, it drives at"),
        (BRAKES, "others.A.count", 2, "said 2, there are 1"),
        (RED, "others.A.starts.side", "right", "said right, it starts"),
        (RED, "others.A.does.0.speed", "70 km/h", "said 70 km/h, it goes at"),
        (LEFT, "road", {"kind": "four-way", "control": "none"}, "the junction has signal"),
        (TWO, "others.A.does.0.act", "turn-back", "said turn-back, but it never does"),
        (CHILD, "others.A.does.0.speed", "3 m/s", "said 3 m/s, it goes at 2.2"),
        (LEADER, "others.A.does.0.to", "right", "said right, it goes to the left"),
    ],
)  # fmt: skip
def test_what_was_not_done_is_not_seen(name: str, path: str, value: Any, told: str) -> None:
    other = with_fact(situation(name), path, value)
    assert [one for one in failures(judged(name, other)) if one.startswith(path) and told in one]


def test_deeds_in_the_other_order_are_not_what_was_said() -> None:
    name = "a car from behind overtakes, cuts in and brakes"
    swapped = with_fact(situation(name), "others.A.does", [{"act": "brake"}, {"act": "overtake"}])
    assert failures(judged(name, swapped)) == (
        "others.A.does.1.act: said brake, then overtake, but it does it the other way round",
    )


def test_somebody_who_is_not_there_is_missed() -> None:
    name = BRAKES
    both = with_fact(situation(name), "others.B", {"id": "B", "kind": "dog", "starts": {"where": "roadside"}})
    assert "others.B.kind: there is no B" in failures(judged(name, both))


def test_a_contact_is_held_against_who_touches_whom_and_not_asked_of_a_drive_without_one() -> None:
    name = "a car comes over into our lane"
    seeds = [seed for seed in range(1, 12) if driven(name, seed).collision is not None]
    assert seeds
    said = with_fact(situation(name), "contact", {"ego": "front", "whom": "A"})
    assert failures(judged(name, said, seeds[0])) == ()
    rear = with_fact(said, "contact.ego", "rear")
    assert "contact.ego: said rear, it is the front" in failures(judged(name, rear, seeds[0]))
    none = with_fact(situation(name), "contact", {"happens": False})
    assert "contact.happens: said that there is no contact, there is one" in failures(judged(name, none, seeds[0]))
    calm = "a car tailgates us"
    wanted = with_fact(situation(calm), "contact", {"ego": "rear"})
    found = {one.path: one.shown for one in judged(calm, wanted) if one.path.startswith("contact")}
    assert found == {"contact.happens": None, "contact.ego": None}


def test_what_no_track_tells_is_a_short_list() -> None:
    assert set(Act) <= set(ACTS)
    unseen = {Where.OFF_RAMP, Where.IN_ROUNDABOUT, Where.ROUNDABOUT_ENTRY}
    assert set(Where) - set(STARTS) == unseen
