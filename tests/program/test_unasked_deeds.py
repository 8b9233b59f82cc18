"""A deed that nobody said and that a watcher cannot miss is told: a hard brake for nobody, a turn off or round."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import pytest

from chatscene.build.build import build
from chatscene.ego.policy import load_ego
from chatscene.maps.network import resolve_map
from chatscene.program.judge import failures, judge
from chatscene.program.sample import scene_at
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import load_simulator, simulate
from chatscene.situations.form import from_plain
from chatscene.terms.episode import Episode
from chatscene.terms.route import Route
from chatscene.terms.situation import Deed, Situation
from chatscene.terms.vocabulary import Act


def said(where: str, *does: dict[str, Any]) -> Situation:
    return from_plain({"others": [{"id": "A", "kind": "car", "starts": {"where": where}, "does": list(does)}]})


BRAKES = said("behind", {"act": "overtake"}, {"act": "cut-in"}, {"act": "brake", "manner": "hard"})
TAILGATES = said("behind", {"act": "tailgate"}, {"act": "overtake"}, {"act": "lane-change", "to": "left"})
SWERVES = said("ahead", {"act": "go-along"}, {"act": "swerve"})
GOES_BACK = from_plain(
    {
        "others": [
            {
                "id": "A",
                "kind": "pedestrian",
                "starts": {"where": "roadside", "side": "right"},
                "does": [{"act": "hesitate"}, {"act": "turn-back"}],
            }
        ]
    }
)
BRAKES_ON_THE_WAY = said("ahead", {"act": "go-along", "speed": "50 km/h", "time": "3 s"}, {"act": "brake"})
TURNS_ROUND = said("ahead", {"act": "u-turn"})


@cache
def driven(situation: Situation) -> tuple[Episode, Route]:
    made = build(situation)
    simulator = load_simulator(resolve_map(made.map), SimulationSettings(simulator="native"))
    episode = simulate(simulator, made.program, scene_at(made.program, 0, 0.5, name="middle"), load_ego("planner"))
    assert isinstance(episode, Episode)
    return episode, simulator.route(made.program, 0)


def only(situation: Situation, *acts: Act) -> Situation:
    (one,) = situation.others
    return replace(situation, others=(replace(one, does=tuple(Deed(act=act) for act in acts)),))


def unasked(claimed: Situation, done: Situation) -> tuple[str, ...]:
    found = failures(judge(claimed, *driven(done)))
    return tuple(one for one in found if one.startswith("unasked."))


@pytest.mark.parametrize("situation", [BRAKES, TURNS_ROUND, TAILGATES, SWERVES, GOES_BACK, BRAKES_ON_THE_WAY])
def test_what_was_said_is_not_told_as_unasked(situation: Situation) -> None:
    assert unasked(situation, situation) == ()


def test_a_car_that_brakes_hard_for_nobody_after_it_cut_in_does_what_nobody_said() -> None:
    claimed = only(BRAKES, Act.OVERTAKE, Act.CUT_IN)
    assert unasked(claimed, BRAKES) == ("unasked.A.brakes: A brakes hard for nobody, which the text does not say",)


def test_a_car_that_turns_round_does_what_nobody_said() -> None:
    claimed = only(TURNS_ROUND, Act.GO_ALONG)
    assert "unasked.A.turn: A turns off or turns round, which the text does not say" in unasked(claimed, TURNS_ROUND)


@pytest.mark.parametrize("act", [Act.TURN_LEFT, Act.EXIT])
def test_who_turns_round_neither_turns_off_nor_exits(act: Act) -> None:
    told = failures(judge(only(TURNS_ROUND, act), *driven(TURNS_ROUND)))
    assert [one for one in told if one.startswith("others.A.does.0.act")]


def test_who_is_to_stay_behind_and_gets_past_does_what_nobody_said() -> None:
    claimed = only(TAILGATES, Act.TAILGATE, Act.LANE_CHANGE)
    assert "unasked.A.past: A gets past the ego, which the text does not say" in unasked(claimed, TAILGATES)


def test_who_is_to_go_along_and_swerves_does_what_nobody_said() -> None:
    (told,) = unasked(only(SWERVES, Act.GO_ALONG), SWERVES)
    assert told.startswith("unasked.A.lane: A leaves its line by ")


def test_a_car_that_brakes_below_the_speed_that_was_said_does_what_nobody_said() -> None:
    (one,) = BRAKES_ON_THE_WAY.others
    claimed = replace(BRAKES_ON_THE_WAY, others=(replace(one, does=one.does[:1]),))
    assert unasked(claimed, BRAKES_ON_THE_WAY) == (
        "unasked.A.brakes: A brakes hard for nobody, which the text does not say",
    )


def test_a_pedestrian_who_only_hesitates_and_goes_back_does_what_nobody_said() -> None:
    assert unasked(only(GOES_BACK, Act.HESITATE), GOES_BACK) == (
        "unasked.A.back: A moves backwards, which the text does not say",
    )
