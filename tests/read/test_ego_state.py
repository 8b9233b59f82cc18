"""What the ego does at the pedals, and that how it reacts is none of that."""

from __future__ import annotations

import json
from collections import Counter
from importlib.resources import files

import pytest

from chatscene.read.decompose import hear
from chatscene.read.reading import read
from chatscene.terms.acts import Action
from chatscene.terms.scenario import Control, EgoState, Position

SAYS = {
    "While we wait at a red light, a car drives into us from behind.": EgoState.STANDS,
    "We are standing in a queue when a truck hits us from behind.": EgoState.STANDS,
    "The ego vehicle is stationary at the traffic lights; a van from behind does not stop.": EgoState.STANDS,
    "A car rear-ends us while we are stopped at the stop sign.": EgoState.STANDS,
    "Stopped at a red light, the ego is hit by a motorcycle from behind.": EgoState.STANDS,
    "Our car has broken down on the road and a truck runs into us from behind.": EgoState.STANDS,
    "The AV in autonomous mode was stopped at a red light when a car struck it from behind.": EgoState.STANDS,
    "A van backs into our stationary car.": EgoState.STANDS,
    "We set off at green and a car from the left runs the red light.": EgoState.SETS_OFF,
    "As we pull away from the lights, a cyclist crosses from the right.": EgoState.SETS_OFF,
    "We were stopped at the lights, they turned green, and a car from the left ran the red.": EgoState.SETS_OFF,
    "We crawl along the road and a car behind overtakes us.": EgoState.SLOW,
    "We are driving very slowly when a car from behind overtakes us.": EgoState.SLOW,
    "We slow down for a pedestrian and a car runs into us from behind.": EgoState.SLOWS_DOWN,
    "A van hits us from behind as we slow down.": EgoState.SLOWS_DOWN,
    "As we brake for a crossing, the van behind us drives into us.": EgoState.BRAKES,
    "We brake hard at the lights and a car crashes into us from behind.": EgoState.BRAKES,
    "We stop at a stop sign and a motorcycle hits us from behind.": EgoState.STOPS,
    "We were coming to a stop behind a bus when a car rear-ended us.": EgoState.STOPS,
    "I'm just sitting there at the lights and a pickup runs into the back of me.": EgoState.STANDS,
    "im queueing at the lights, a moped hits me from behind": EgoState.STANDS,
    "Light turned green, I started to go, and the car behind bumped me.": EgoState.SETS_OFF,
    "I stopped at the sign, then I went, and a van came from the right.": EgoState.SETS_OFF,
    "Ego stopped at a stop sign, goes straight; a motorcycle from the right does not stop.": EgoState.SETS_OFF,
    "We stop at a red light. A truck next to us turns right and scrapes us.": EgoState.STOPS,
    "We stop at the light and turn off the engine. The car behind us hits us.": EgoState.STOPS,
    "We stopped at the lights, pulled out a map, and a van rear-ended us.": EgoState.STOPS,
    "I braked cause some kids ran about and the car behind hit me.": EgoState.BRAKES,
}
SAYS_NOTHING = (
    "The car ahead brakes hard, which makes us brake.",
    "A car cuts in ahead of us and we brake.",
    "We brake when a pedestrian steps out from the right.",
    "We turn left and stop because a pedestrian crosses.",
    "A cyclist crosses from the right and we cannot stop in time.",
    "We brake for a cyclist who swerves in front of us.",
    "A motorbike comes past as if we were standing still.",
    "A pedestrian steps out from behind the parked car.",
    "The car in front of the ego sets off and stops again.",
    "We follow a slow car and turn left at the stop sign.",
    "A car waits at the junction to our right and pulls out.",
)


@pytest.mark.parametrize(("text", "state"), SAYS.items())
def test_a_state_of_the_ego_is_read(text: str, state: EgoState) -> None:
    assert hear(text).outright.ego is state


@pytest.mark.parametrize("text", SAYS_NOTHING)
def test_what_the_ego_does_in_answer_to_somebody_is_no_state(text: str) -> None:
    assert hear(text).outright.ego is None


def test_a_state_survives_beside_what_the_classifier_believes() -> None:
    frame = read("While we wait at a red light, a car drives into us from behind.")
    said = frame.outright
    assert (said.ego, said.control, said.position) == (EgoState.STANDS, Control.SIGNAL, Position.BEHIND)
    assert said.actions == (Action.FOLLOW,)
    assert frame.whole


def test_few_of_the_texts_at_hand_say_a_state() -> None:
    texts = [
        json.loads(line)["text"]
        for name in ("held-out", "second")
        for line in files("chatscene.studies").joinpath("sentences", f"{name}.jsonl").read_text("utf-8").splitlines()
    ]
    found = Counter(hear(text).outright.ego for text in texts)
    del found[None]
    assert found == {EgoState.SETS_OFF: 3, EgoState.SLOW: 1, EgoState.STANDS: 3}
