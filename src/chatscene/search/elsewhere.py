"""Which other maps at hand have the place that a program asks for, where the one that it ran on has none."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import closing, nullcontext
from dataclasses import dataclass
from pathlib import Path

from chatscene.errors import ChatSceneError
from chatscene.maps.carla_towns import towns_at_hand
from chatscene.maps.network import PACKAGED, map_digest, resolve_map
from chatscene.program.check import probe_scenes
from chatscene.simulate.simulator import Simulator
from chatscene.terms.scene import Rejected, ScenicProgram

TRIED = 2  # scenes on each map, as one may fail by its values alone


@dataclass(frozen=True, slots=True)
class Elsewhere:
    """Which maps have what a program asks for."""

    there: tuple[str, ...]
    without: tuple[str, ...]
    not_drawn: tuple[str, ...]
    left: tuple[str, ...]

    def __str__(self) -> str:
        if self.there:
            begins = f"\n  it can be drawn on these maps at hand: {', '.join(self.there)}; run it there with --map"
            found = f"{begins} {self.there[0]}"
        else:
            found = "\n  it can be drawn on no other map that was tried"
        parts = (
            ("no such place", self.without),
            (f"not drawn in {TRIED} scenes", self.not_drawn),
            ("not tried, as they are large", self.left),
        )
        return found + "".join(f"\n  {what}: {', '.join(names)}" for what, names in parts if names)


def elsewhere(
    program: ScenicProgram,
    but: Path,
    simulator_on: Callable[[Path], Simulator],
    tell: Callable[[str, int, int], None],
) -> Elsewhere:
    """Try a program on every other map at hand: the packaged ones, and CARLA's towns where they are installed."""
    towns, left = towns_at_hand()
    content = map_digest(but)
    names = [name for name in (*towns, *PACKAGED) if map_digest(resolve_map(name)) != content]
    sorts: dict[str, list[str]] = {"there": [], "without": [], "not_drawn": []}
    for number, name in enumerate(names):
        tell(f"looking for such a place on {name}", number, len(names))
        sorts[_on(program, simulator_on(resolve_map(name)))].append(name)
    return Elsewhere(**{sort: tuple(found) for sort, found in sorts.items()}, left=left)


def _on(program: ScenicProgram, simulator: Simulator) -> str:
    """Whether a program can be drawn on a map, and if not, whether that is sure."""
    with closing(simulator) if hasattr(simulator, "close") else nullcontext():  # type: ignore[type-var]
        for scene in probe_scenes(program, 0)[:TRIED]:
            try:
                opened = simulator.open(program, scene)
            except ChatSceneError:  # such as where it names a road by its number
                return "not_drawn"
            if not isinstance(opened, Rejected):
                opened.close()
                return "there"
            if opened.without:
                return "without"
    return "not_drawn"
