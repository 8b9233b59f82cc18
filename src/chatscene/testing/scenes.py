"""A sentence, or the kept scenes of a run, as tests of an ego; no test runner is needed.

::

    @chatscene.scene("a child runs out behind a van", ego="my_stack.driving:make_ego")
    def test_my_planner(): ...

What pytest makes of it is in `chatscene.pytest_plugin`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from chatscene import runs
from chatscene.ego.policy import EgoPolicy, name_of
from chatscene.errors import RunError, SettingsError, no_such
from chatscene.maps.network import map_with, resolve_map
from chatscene.measure.criticality import criticality, fault
from chatscene.program.sample import scene_seed
from chatscene.report.filled import explain_text
from chatscene.report.stated import Stated
from chatscene.runs.rebuild import map_of, rebuild
from chatscene.runs.trust import Repeated, follow
from chatscene.search.climb import simulator_of
from chatscene.search.generator import load_generator
from chatscene.search.sampler import load_sampler
from chatscene.settings import Settings, SimulationSettings
from chatscene.simulate.simulator import Simulator, routes_of, simulate
from chatscene.terms.actors import named
from chatscene.terms.episode import Episode
from chatscene.terms.outcome import Outcome
from chatscene.terms.scene import Rejected, Scene, ScenicProgram
from chatscene.testing.solvable import SLOW, Solvable, Unfit, hindered, solvable

if TYPE_CHECKING:
    from chatscene.api.results import Run

MUST = ("avoid", "no-fault")
"""What an ego must: have no collision at all, or run into nobody."""
SETTINGS = Settings(simulation=SimulationSettings(simulator="native"))
ROUTES = 3  # places of a sentence among which its scenes are
BLOCKS = 4  # of ten draws, in which scenes are looked for on a route
ASKED = "__chatscene__"  # where a function has what it was marked with

Ego = str | EgoPolicy | Callable[[], EgoPolicy]
Test = TypeVar("Test", bound=Callable[..., Any])


@dataclass(frozen=True, slots=True, kw_only=True)
class Asked:
    """What a test says of its scenes.

    Attributes:
        scenes: How many of the sentence; of a run folder, how many at most.
        scene_id: The only one of the run folder; empty for all that it keeps.
        map_name: The map; empty for the one that has what the sentence names.
    """

    of: str | Path
    scenes: int = 5
    scene_id: str = ""
    seed: int = 0
    map_name: str = ""
    settings: Settings = SETTINGS


@dataclass(frozen=True, slots=True, kw_only=True)
class Marked:
    """What a test is marked with.

    Attributes:
        ego: Who is under test; None for what the fixture ``ego`` gives.
        must: One of `MUST`.
    """

    asked: Asked
    ego: Ego | None
    must: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Found:
    """The scenes of a test."""

    text: str
    scenes: tuple[Solvable, ...]
    unfit: dict[str, int]
    simulator: Simulator
    map_path: Path

    def why_fewer(self) -> str:
        """Why there are no more, for a reader."""
        reasons = (f"{count} times {reason}" for reason, count in sorted(self.unfit.items(), key=lambda one: -one[1]))
        tried = len(self.scenes) + sum(self.unfit.values())
        return f"of {tried} scenes of {self.text!r} {len(self.scenes)} are tests; {'; '.join(reasons)}"


@dataclass(frozen=True, slots=True, kw_only=True)
class Driven:
    """An ego in a scene and in its twin.

    Attributes:
        failures: What went wrong, a sentence each; empty if nothing did.
    """

    text: str
    solvable: Solvable
    ego: str
    episode: Episode
    twin: Episode
    failures: tuple[str, ...]

    @property
    def scene(self) -> Scene:
        """The concrete values."""
        return self.solvable.scene

    @property
    def properties(self) -> dict[str, str | int | float]:
        """For a machine: the sentence, the seed, what came of it."""
        crash, harmless = self.episode.collision, self.twin.collision
        return {
            "sentence": self.text,
            "scene": self.scene.id,
            "seed": self.scene.seed,
            "ego": self.ego,
            "verdict": "failed" if self.failures else "passed",
            "impact_speed": round(crash.impact_speed, 3) if crash else 0.0,
            "fault": str(fault(self.episode) or "none"),
            "twin_impact_speed": round(harmless.impact_speed, 3) if harmless else 0.0,
            "twin_completion": round(self.twin.completion, 3),
            "twin": self.solvable.twin.told,
            "survivor": self.solvable.survivor,
        }

    def in_words(self) -> str:
        """What happened, for a person."""
        values = ", ".join(f"{name.removeprefix('OPT_')}={value:g}" for name, value in self.scene.values.items())
        crash = self.solvable.oblivious.collision
        assert crash is not None
        return "\n".join(
            [
                *self.failures,
                f"  sentence  {self.text}",
                f"  scene     {self.scene.id} (its seed {self.scene.seed})",
                f"  values    {values}",
                f"  ego       {self.ego}",
                f"  survived  by {self.solvable.survivor}; whoever does not react crashes at "
                f"{crash.impact_speed:.1f} m/s after {crash.step * self.episode.dt:.1f} s",
                f"  twin      the same place and start, but the adversary {self.solvable.twin.told}",
            ]
        )


def scene(
    of: str | Path | Run,
    *,
    ego: Ego | None = None,
    must: str = "avoid",
    scenes: int = 5,
    seed: int = 0,
    scene_id: str = "",
    map: str | Path = "",  # noqa: A002 - the word of the command line
    settings: Settings | None = None,
) -> Callable[[Test], Test]:
    """Mark a function as a test of an ego in scenes of a sentence, or in those that a run keeps.

    pytest runs it once for each scene. Before its body runs, the ego drives the scene, where it must do as `must`
    says, and the scene's twin, in which the adversary is harmless, where it must neither crash nor stop. A body may be
    ``...``; if it has a parameter ``scene``, it gets the `Driven`.

    Args:
        of: The sentence; or a run folder as a `Path` or a `chatscene.Run`.
        ego: A name, a file, ``package.module:factory``, an ego, or what makes one; None for the fixture ``ego``.
        must: ``avoid`` any collision, or ``no-fault``: run into nobody.
        scenes: How many of a sentence; of a run folder, how many at most.
        seed: What the values of a sentence's scenes derive from.
        scene_id: The only scene of the run folder.
        map: Packaged map or ``.xodr`` file of a sentence; that which has what the sentence names, if not said.
        settings: Of reading and simulation; the simulator is ``native`` if not said.

    Raises:
        SettingsError: There is no such `must`, or a number is out of range.
    """
    if must not in MUST:
        raise SettingsError(no_such("must", must, MUST))
    if scenes < 1:
        raise SettingsError(f"scenes must be at least 1, not {scenes}")
    asked = Asked(
        of=of if isinstance(of, str | Path) else of.folder,
        scenes=scenes,
        scene_id=scene_id,
        seed=seed,
        map_name=str(map),
        settings=settings or SETTINGS,
    )

    def mark(test: Test) -> Test:
        setattr(test, ASKED, Marked(asked=asked, ego=ego, must=must))
        return test

    return mark


@lru_cache(maxsize=64)
def find(asked: Asked) -> Found:
    """The scenes of a test; in any process the same ones.

    Raises:
        NothingFits: The library cannot serve the sentence.
        RunError: There is no such run, or no such scene in it.
        ChatSceneError: Anything else that is wrong with what is asked.
    """
    return _of_text(asked, asked.of) if isinstance(asked.of, str) else _of_run(asked, asked.of)


def judge(found: Found, one: Solvable, ego: EgoPolicy, *, must: str = "avoid") -> Driven:
    """Let an ego drive a scene and its twin, and say what went wrong.

    Raises:
        EgoError: The ego fails.
    """
    episode = _drive(found.simulator, one.program, one.scene, ego)
    twin = _drive(found.simulator, one.twin.program, one.scene, ego)
    failures: list[str] = []
    if (crash := _crash(episode)) and (must == "avoid" or _struck_by_ego(episode)):
        failures.append(crash)
    if crash := _crash(twin):
        failures.append(f"In the harmless twin: {crash}")
    elif why := hindered(twin, least=SLOW * one.completion, standing=one.standing):
        failures.append(
            f"In the harmless twin the ego does not get on: {why}; the driver that survives the scene comes "
            f"{100 * one.completion:.0f} % of the way there and stands for {one.standing:.1f} s."
        )
    return Driven(text=found.text, solvable=one, ego=name_of(ego), episode=episode, twin=twin, failures=tuple(failures))


def gif_of(found: Found, driven: Driven) -> bytes:
    """What went wrong as an animated GIF: the drive in the scene, or in the twin if all was well in the scene."""
    from chatscene.maps.drawing import routes_drawing
    from chatscene.maps.loading import load_roads
    from chatscene.report.animation import animate

    route = found.simulator.route_in(driven.solvable.program, driven.scene)
    drawing = routes_drawing(load_roads(found.map_path), {route.id: route})
    shown = driven.twin if driven.episode.collision is None else driven.episode
    return animate(shown, drawing, said=driven.text, ego=driven.ego)


def _drive(simulator: Simulator, program: ScenicProgram, one: Scene, ego: EgoPolicy) -> Episode:
    episode = simulate(simulator, program, one, ego)
    if isinstance(episode, Rejected):
        raise RunError(f"scene {one.id!r} was placed once and is now rejected: {episode.reason}")
    return episode


def _crash(episode: Episode) -> str:
    """Who struck whom, when, where and how fast; empty if nobody did."""
    crash = episode.collision
    if crash is None:
        return ""
    other = next(track for track in episode.tracks if track.actor == crash.other)
    called = named(other.actor, other.kind, episode.kinds)
    ego = float(episode.ego_track.speed[max(crash.step - 1, 0)])
    theirs = float(other.speed[min(max(crash.step - 1, 0), len(other.speed) - 1)])
    struck = (
        f"The ego runs into {called}"
        if _struck_by_ego(episode)
        else f"{called[0].upper()}{called[1:]} runs into the ego"
    )
    return (
        f"{struck} after {crash.step * episode.dt:.1f} s, at {crash.impact_speed:.1f} m/s "
        f"({3.6 * crash.impact_speed:.0f} km/h) of approach, on the ego's {crash.side}; "
        f"the ego drives {ego:.1f} m/s then, the other {theirs:.1f} m/s."
    )


def _struck_by_ego(episode: Episode) -> bool:
    striker = fault(episode)
    return striker is not None and striker.by_ego


def _of_text(asked: Asked, text: str) -> Found:
    understood = explain_text(text, asked.settings, map_name=asked.map_name or None)
    program, scenario = understood.program, understood.scenario
    built_on = understood.built.map if isinstance(understood, Stated) else map_with(scenario.slots.site)
    path = resolve_map(asked.map_name or built_on)
    simulator = simulator_of(load_generator(understood.generator), path, asked.settings)
    routes = list(routes_of(simulator, program, min(asked.scenes, ROUTES)))
    found: list[Solvable] = []
    unfit: dict[str, int] = {}
    for number, route in enumerate(routes):
        wanted = math.ceil((asked.scenes - len(found)) / (len(routes) - number))
        fit: list[Solvable] = []
        for block in _blocks(program, route, simulator, asked):
            fit += [one for one in block if isinstance(one, Solvable)]
            for one in block:
                if isinstance(one, Unfit):
                    unfit[one.reason] = unfit.get(one.reason, 0) + 1
            if len(fit) >= wanted:
                break
        found += sorted(fit, key=lambda one: one.spare)[:wanted]
    return Found(text=text, scenes=tuple(found), unfit=unfit, simulator=simulator, map_path=path)


def _blocks(program: ScenicProgram, route: int, simulator: Simulator, asked: Asked) -> Iterator[list[Solvable | Unfit]]:
    """Scenes of a route, block by block, each drawn from where whoever does not react crashed in those before."""
    search = replace(asked.settings.search, seed=asked.seed)
    sampler = load_sampler(search.sampler)
    history: list[Sequence[Outcome]] = []
    for block in range(BLOCKS):
        stem = f"{program.scenario_id}/route-{route:02d}"
        seed = scene_seed(search.seed, f"{stem}/block-{block:03d}")
        proposal = sampler.propose(program.parameters, history, count=search.block, seed=seed)
        tried: list[Solvable | Unfit] = []
        came: list[Outcome] = []
        for index in range(block * search.block, (block + 1) * search.block):
            name = f"{stem}/scene-{index:03d}"
            drawn = scene_seed(search.seed, name)
            one = Scene(
                id=name,
                scenario_id=program.scenario_id,
                route=route,
                block=block,
                seed=drawn,
                values=proposal.draw(drawn),
            )
            outcome = solvable(program, one, simulator)
            drive = outcome.oblivious if isinstance(outcome, Solvable) else outcome.drive
            if drive is not None:
                measured = criticality(drive)
                came.append(
                    Outcome(
                        values=dict(one.values),
                        collided=drive.collision is not None,
                        distance=measured.distance,
                        impact_speed=measured.impact_speed or 0.0,
                        completion=drive.completion,
                    )
                )
            tried.append(outcome)
        yield tried
        history.append(came)


def _of_run(asked: Asked, folder: Path) -> Found:
    run = runs.open_run(folder, runs.RunRecord)
    follow(Repeated(library=_own(asked)), joining_of=[run])
    record = runs.read_record(run)
    settings = runs.settings_of(record)
    simulation = replace(settings.simulation, simulator=asked.settings.simulation.simulator)
    path = map_of(record)
    made = rebuild(run)
    simulator = simulator_of(load_generator(made.generator), path, replace(settings, simulation=simulation))
    rows = [row for row in runs.read_scenes(run) if row["scene_id"] == asked.scene_id or not asked.scene_id]
    rows = [row for row in rows if row["status"] == "ran" and (row["selected"] or asked.scene_id)]
    if not rows:
        raise RunError(
            f"{folder} has no scene {asked.scene_id!r} that was driven"
            if asked.scene_id
            else f"{folder} keeps no scene"
        )
    found: list[Solvable] = []
    unfit: dict[str, int] = {}
    for row in rows[: asked.scenes]:
        outcome = solvable(made.program, runs.scene_of(row, made.program), simulator)
        if isinstance(outcome, Unfit):
            unfit[outcome.reason] = unfit.get(outcome.reason, 0) + 1
        else:
            found.append(outcome)
    return Found(text=record.title, scenes=tuple(found), unfit=unfit, simulator=simulator, map_path=path)


def _own(asked: Asked) -> tuple[str, ...]:
    return (asked.settings.retrieval.library,) if asked.settings.retrieval.library else ()
