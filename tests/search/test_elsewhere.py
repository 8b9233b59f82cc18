"""Which other maps have the place that a program asks for."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from chatscene.errors import ProgramError
from chatscene.maps.network import PACKAGED
from chatscene.search import elsewhere as module
from chatscene.search.elsewhere import elsewhere
from chatscene.terms.scene import Rejected, ScenicProgram

PROGRAM = ScenicProgram(
    scenario_id="theirs", source="", parameters=(), snippet_ids=(), model="scenic.domains.driving.model", own="x"
)


def test_each_other_map_is_tried_and_told_with_what_is_sure(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "towns_at_hand", lambda: ((), ("Town12",)))
    told = list[str]()

    def tell(what: str, *_: int) -> None:
        told.append(what)

    found = elsewhere(PROGRAM, PACKAGED["region"], answering(town=None, outskirts=True), tell)
    assert (found.there, found.without, found.not_drawn, found.left) == (("town",), ("outskirts",), (), ("Town12",))
    assert told == ["looking for such a place on town", "looking for such a place on outskirts"]
    assert str(found) == (
        "\n  it can be drawn on these maps at hand: town; run it there with --map town"
        "\n  no such place: outskirts"
        "\n  not tried, as they are large: Town12"
    )


def test_a_map_on_which_a_program_fails_or_is_not_drawn_is_not_said_to_have_no_such_place(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(module, "towns_at_hand", lambda: ((), ()))
    found = elsewhere(PROGRAM, PACKAGED["town"], answering(outskirts=False, region=ProgramError("road69")), ignore)
    assert found.not_drawn == ("outskirts", "region")
    assert (
        str(found) == "\n  it can be drawn on no other map that was tried\n  not drawn in 2 scenes: outskirts, region"
    )


def answering(**answers: bool | ProgramError | None) -> Any:
    """Simulators that open a scene (None), reject it, surely or not, or fail."""

    def on(path: Path) -> Any:
        answer = answers[path.stem]

        def open_scene(_program: ScenicProgram, scene: Any) -> Any:
            if isinstance(answer, ProgramError):
                raise answer
            if answer is None:
                return SimpleNamespace(close=lambda: None)
            return Rejected(scene=scene, reason="", without=answer)

        return SimpleNamespace(open=open_scene)

    return on


def ignore(*_: object) -> None:
    """Tell nobody."""
