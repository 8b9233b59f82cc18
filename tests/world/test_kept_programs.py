"""The code of the programs that were compiled last is kept between processes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from chatscene.files.caches import cache_folder
from chatscene.maps.network import resolve_map
from chatscene.world import compilation
from chatscene.world.compilation import compile_program

SOURCE = """model chatscene.world.model
param OPT_AHEAD = Range(20, 30)
egoRoute = selectRoute(maneuver="straight")
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute
A = new Truck at pointOn(egoRoute, globalParameters.OPT_AHEAD), facing directionOn(egoRoute, 30)
"""


@pytest.fixture(autouse=True)
def _own_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))


def _placed(monkeypatch: pytest.MonkeyPatch, source: str = SOURCE) -> list[tuple[float, float]]:
    """Where everybody stands if the program is compiled by a process that has compiled nothing."""
    with monkeypatch.context() as patch:
        patch.setattr(compilation, "_code", {})
        scenario: Any = compile_program(source, map_path=resolve_map("town"), route=0, filename="<kept>")
    scenario.conditionOn(params={"OPT_AHEAD": 25.0})
    scene, _ = scenario.generate(maxIterations=1)
    return [(one.position.x, one.position.y) for one in scene.objects]


def _kept() -> list[Path]:
    return sorted(cache_folder("programs").glob("*"))


def test_a_program_is_parsed_once(monkeypatch: pytest.MonkeyPatch) -> None:
    first = _placed(monkeypatch)
    assert len(_kept()) == 1

    def parse(*_given: object) -> None:
        pytest.fail("a program is parsed again")

    monkeypatch.setattr(compilation, "_parsed", parse)
    assert _placed(monkeypatch) == first


def test_a_program_with_requirements_is_translated_each_time(monkeypatch: pytest.MonkeyPatch) -> None:
    _placed(monkeypatch, f"{SOURCE}require A.width > 0\n")
    assert _kept() == []


def test_those_that_were_kept_first_go(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(compilation, "PROGRAMS", 2)
    for kind in ("Truck", "Bus", "Tram"):
        _placed(monkeypatch, SOURCE.replace("Truck", kind))
    assert len(_kept()) == 2


def test_a_confined_process_keeps_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(compilation, "keeping", False)
    _placed(monkeypatch)
    assert _kept() == []
