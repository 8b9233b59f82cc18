"""Drives of a program: anybody's Scenic as it is written, confined, or a file of OpenSCENARIO."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import closing, nullcontext
from dataclasses import replace
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from chatscene.ego.policy import EgoPolicy, fitted, load_ego
from chatscene.errors import MapError
from chatscene.maps.network import PACKAGED, TOWN, resolve_map
from chatscene.measure.avoidability import avoidable
from chatscene.measure.unplayed import unplayed
from chatscene.program.sample import draw, scene_seed
from chatscene.search.generators.foreign import ForeignProgram, drives_itself, read_foreign
from chatscene.search.generators.left_out import left_out
from chatscene.search.generators.their_map import their_map
from chatscene.settings import EGO, SimulationSettings, VerifySettings
from chatscene.simulate.confined.simulator import ConfinedSimulator
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.terms.scene import OWN_MODEL, Rejected, Scene, ScenicProgram
from chatscene.verdict.watched import Watched, Watching


def watch_program(path: Path, settings: VerifySettings) -> Watching:
    """Drives of a Scenic program.

    Its own ego drives where it is for another world model, or has a behavior of its own; else, and where an ego is
    named, that one.

    Raises:
        ForeignCodeRefused: It cannot be read, or uses what strangers may not use.
        ProgramError: It does not compile, or its own code fails.
        MapError: No map has what it asks for.
        SettingsError: Its map lies where it may not.
    """
    own = read_foreign(path, trusted=settings.trust, as_written=not settings.ego, searched_with=False)
    if settings.within:
        own.check_map(Path(settings.within))
    if own.program.as_written and own.program.model == OWN_MODEL and not drives_itself(own.program.source):
        own = replace(own, program=replace(own.program, as_written=False))
    driver = "its own ego drives" if own.program.as_written else f"{settings.ego or EGO} drives the ego"
    return _watched(own, "Scenic program", settings, (*own.changed(), driver, *left_out(own.program)))


def watch_openscenario(path: Path, settings: VerifySettings) -> Watching:
    """Drives of a file of OpenSCENARIO, as the program that it is imported as.

    Raises:
        ScenarioError: It cannot be read, or says what cannot be said here.
    """
    from chatscene.imports.import_file import import_scenario

    within = Path(settings.within) if settings.within else None
    with TemporaryDirectory(prefix="chatscene-") as folder:
        out = Path(folder) / "scenario.scenic"
        made = import_scenario(path, out=out, map_name=settings.map_name or None, within=within)
        own = read_foreign(made.program, searched_with=False)
        own = replace(own, map_path=made.map_path.resolve())  # read in a process that works elsewhere
        notes = [f"{settings.ego or EGO} drives the ego", *made.notes]
        if len(made.programs) > 1:
            notes.append(
                f"variant 1 of {len(made.programs)} is judged; for another: chatscene import {path} --variant N, and "
                "judge its program"
            )
        return _watched(own, "OpenSCENARIO file", settings, notes)


def _watched(own: ForeignProgram, kind: str, settings: VerifySettings, notes: Sequence[str]) -> Watching:
    maps, more = _maps(own, settings)
    notes = (*notes, *more)
    for number, map_path in enumerate(maps, 1):
        simulator = _simulator(map_path, settings)
        with closing(simulator) if isinstance(simulator, ConfinedSimulator) else nullcontext():
            try:
                if not own.program.drawn:
                    simulator.route(own.program, 0)
            except MapError:
                if number == len(maps):
                    raise
                continue
            drives, rejected = _drives(own.program, simulator, load_ego(settings.ego or EGO), settings)
            where = f"on map {map_path.stem}"
            drawing = partial(_drawing, map_path)
            return Watching(kind=kind, drives=drives, rejected=rejected, notes=(*notes, where), drawing=drawing)
    raise AssertionError("there is a map")


def _maps(own: ForeignProgram, settings: VerifySettings) -> tuple[list[Path], tuple[str, ...]]:
    """The map that a program or its user names, else each packaged one, the town first; and what there is to say."""
    named, notes = their_map(own.map_path, settings.map_name or None)
    if named is not None or own.program.drawn:
        return [resolve_map(named or TOWN)], notes
    return [resolve_map(name) for name in PACKAGED], notes


def _simulator(map_path: Path, settings: VerifySettings) -> Simulator:
    simulation = SimulationSettings()
    return load_simulator(map_path, simulation) if settings.trust else ConfinedSimulator(map_path, simulation)


def _drives(
    program: ScenicProgram, simulator: Simulator, ego: EgoPolicy, settings: VerifySettings
) -> tuple[tuple[Watched, ...], tuple[str, ...]]:
    """As many drives as are asked for, and why some were not made."""
    drives, rejected = list[Watched](), list[str]()
    ego = fitted(ego, program)
    for number in range(settings.draws):
        name = f"{program.scenario_id}/route-00/draw-{number:03d}"
        seed = scene_seed(settings.seed, name)
        values = draw(program.parameters, seed=seed)
        scene = Scene(id=name, scenario_id=program.scenario_id, route=0, block=0, seed=seed, values=values)
        episode = simulate(simulator, program, scene, ego)
        if isinstance(episode, Rejected):
            rejected.append(episode.reason)
            continue
        drives.append(
            Watched(
                episode=episode,
                route=simulator.route_in(program, scene),
                tested=not program.as_written,
                avoidable=avoidable(episode, program, scene, ego, simulator),
                unplayed=unplayed(program, episode),
            )
        )
    return tuple(drives), tuple(rejected)


def _drawing(map_path: Path, box: tuple[float, float, float, float]) -> Mapping[str, Any]:
    from chatscene.maps.drawing import map_drawing
    from chatscene.maps.network import load_network

    return map_drawing(load_network(map_path), box)
