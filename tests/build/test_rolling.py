"""Things that roll over the road, and animals that shy."""

from __future__ import annotations

from typing import Any

import pytest
from test_contacts import driven
from test_towards import car, deed, others, track

from chatscene.build.build import build
from chatscene.errors import SituationError
from chatscene.terms.vocabulary import Act, UserKind

SEEDS = (0, 1)


def beside(kind: str, *does: dict[str, Any]) -> dict[str, Any]:
    return car("A", "roadside", *does, kind=kind, side="right")


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("kind", ["object", "debris"])
def test_a_thing_that_rolls_over_the_road_moves_as_a_ball_does_which_is_told(kind: str, seed: int) -> None:
    said = others(beside(kind, deed("cross")))
    assert "A rolls, so it is built as a ball, which may be smaller" in build(said).assumed
    assert track(driven(said, seed)).kind == "Ball"


def test_what_only_stands_beside_the_road_rolls_nowhere() -> None:
    assert UserKind.DEBRIS.can(Act.ENTER) and not UserKind.HEDGE.can(Act.CROSS) and not UserKind.CONE.can(Act.CROSS)
    with pytest.raises(SituationError, match="hedge only lies there"):
        others(beside("hedge", deed("cross")))


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("kind", ["animal", "pedestrian"])
def test_who_goes_along_the_road_on_foot_swerves(kind: str, seed: int) -> None:
    ahead = car("A", "ahead", deed("go-along"), deed("swerve", to="left"), kind=kind, facing="along")
    driven(others(ahead), seed)
    driven(others(car("A", "beside", deed("swerve"), kind=kind, side="right")), seed)


def test_no_contact_with_somebody_is_not_refuted_by_one_with_another() -> None:
    ball = beside("ball", deed("cross")) | {"id": "B"}
    said = others(car("A", "ahead", deed("go-along")), ball, contact={"whom": "A", "happens": False})
    driven(said, 0)


def test_the_left_side_of_who_turns_round_before_the_ego_faces_it() -> None:
    contact = {"ego": "front", "other": "left", "striker": "ego"}
    one = car("A", "ahead", deed("u-turn"))
    assert not build(others(one, road={"two_way": True}, contact=contact)).left_out
