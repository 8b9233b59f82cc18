"""Situations that were once answered with an error of ours."""

from __future__ import annotations

from typing import Any

import pytest
from test_towards import car, deed, others

from chatscene.build.build import build
from chatscene.errors import SituationError

CAME_OVER = car("B", "ahead-beside", deed("cut-in", speed="36 km/h"), deed("yield"), kind="tractor", side="left")


@pytest.mark.parametrize(
    "said",
    [
        {"others": [car("A", "ahead", deed("brake")), CAME_OVER]},
        {
            "ego": {"does": [{"act": "overtake", "whom": "A"}]},
            "others": [car("A", "ahead", deed("stand"), kind="cone")],
        },
        {
            "ego": {"route": "leave-parking"},
            "others": [car("A", "behind-beside", deed("overtake"), deed("cut-in"), side="left")],
        },
    ],
)
def test_it_is_built(said: dict[str, Any]) -> None:
    assert build(others(*said["others"], ego=said.get("ego", {}))).program.source


def test_nobody_does_something_to_itself() -> None:
    with pytest.raises(SituationError, match="nobody does this to itself: overtake"):
        others(car("A", "oncoming", deed("overtake", whom="A")))
