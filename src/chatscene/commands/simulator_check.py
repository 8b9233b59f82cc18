"""Does a simulator do what scenes need? Tried with its own bodies, and beside the default."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from pathlib import Path

from chatscene.commands.doctor import Check, attempt
from chatscene.ego.policy import EgoPolicy, load_ego
from chatscene.errors import SimulationError
from chatscene.maps.network import load_network, resolve_map
from chatscene.runs.replay import WITHIN
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator
from chatscene.studies.agreement import Compared, compared, everyday_programs, same_sizes
from chatscene.terms.scene import ScenicProgram

DEFAULT = SimulationSettings().simulator


def examine_simulator(name: str, map_name: str, scenes: int = 10) -> Iterator[Check]:
    """Try a simulator: is it there, has it what scenes need, does it repeat one, do they end as in the default?

    Yields:
        What was tried; no more after what is needed for the rest and does not work.

    Raises:
        MapError: The map cannot be used, by any simulator.
    """
    path, settings = resolve_map(map_name), SimulationSettings(simulator=name)
    load_network(path)
    made: list[Simulator] = []

    def there() -> str:
        simulator = load_simulator(path, settings)
        made.append(simulator)
        identity = simulator.identity
        return f"{identity.name} {identity.version}: {identity.physics}"

    yield attempt("simulator", there)
    if not made:
        return
    simulator = made[0]
    if (survey := getattr(simulator, "survey", None)) is not None:
        yield (surveyed := attempt("its world", survey))
        if not surveyed.ok:
            return
    ego, programs = load_ego("sac"), list(islice(everyday_programs(simulator), scenes))
    if not programs:
        yield Check(what="scenes", ok=False, found=f"the map {map_name!r} has no place for any of ours")
        return
    yield attempt("one scene, twice", lambda: _twice(simulator, programs[0], ego))
    yield attempt(f"{scenes} scenes, beside {DEFAULT}", lambda: _beside(simulator, path, settings, programs, ego))


def _twice(simulator: Simulator, program: ScenicProgram, ego: EgoPolicy) -> str:
    ((again,),) = compared(program, 1, route=0, seed=0, ego=ego, simulators=(simulator, simulator))
    tolerance = 0.0 if simulator.identity.exact else WITHIN
    if again.apart > tolerance or again.difference:
        raise SimulationError(f"actors are {again.apart:.2f} m apart, {tolerance:g} m is allowed; {again.difference}")
    return f"actors are {again.apart:.3f} m apart at most"


def _beside(
    simulator: Simulator, path: Path, settings: SimulationSettings, programs: list[ScenicProgram], ego: EgoPolicy
) -> str:
    size_of = getattr(simulator, "size_of", None)
    default = same_sizes(path, settings, size_of) if size_of else load_simulator(path, SimulationSettings())
    found: list[Compared] = []
    for program in programs:
        for (one,) in compared(program, 1, route=0, seed=0, ego=ego, simulators=(simulator, default)):
            found.append(one)
    if not found:
        raise SimulationError("neither could place one")
    differing = [one for one in found if one.difference]
    words = f"{len(found) - len(differing)} of {len(found)} end alike, actors are "
    words += f"{max(one.apart for one in found):.2f} m apart at most"
    told: list[str] = getattr(simulator, "disagreements", [])
    return "; ".join([words, *(f"{one.scene.id}: {one.difference}" for one in differing), *told])
