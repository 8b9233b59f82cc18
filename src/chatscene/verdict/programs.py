"""Drives of a program: anybody's Scenic as it is written, confined, or a file of OpenSCENARIO."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from contextlib import closing, nullcontext
from dataclasses import dataclass, replace
from functools import partial
from itertools import pairwise
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from chatscene.ego.asking import fitted
from chatscene.ego.policy import load_ego
from chatscene.errors import (
    ChatSceneError,
    ForeignCodeRefused,
    MapError,
    ProgramError,
    ProgramStopped,
    ScenarioError,
    SettingsError,
    StuckBehavior,
)
from chatscene.imports.collection import map_for
from chatscene.maps.network import PACKAGED, TOWN, resolve_map
from chatscene.measure.avoidability import avoidable_if_driven
from chatscene.measure.unplayed import unplayed
from chatscene.program.sample import drawn_scene
from chatscene.search.generators.foreign import ForeignProgram, read_foreign
from chatscene.search.generators.left_out import left_out
from chatscene.search.generators.their_map import their_map
from chatscene.settings import EGO, SimulationSettings, VerifySettings
from chatscene.simulate.confined.simulator import ConfinedSimulator
from chatscene.simulate.simulator import Simulator, fails_in_its_scene, load_simulator, simulate
from chatscene.simulate.watchdog import PATIENCE
from chatscene.terms.scene import Rejected, Scene
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
    own = read_foreign(
        path, trusted=settings.trust, as_written=_as_written(settings), searched_with=False, given=settings.given
    )
    if settings.within:
        own.check_map(Path(settings.within))
    named = map_for(own, settings.map_name or None, shut_in=bool(settings.within))
    settings = replace(settings, map_name=named or "")
    driver = "its own ego drives" if own.program.as_written else f"{settings.ego or EGO} drives the ego"
    notes = (*own.changed(), driver, *left_out(own.program))
    drives = range(settings.draws if own.varies() else 1)  # more would be the same
    return _watched([_Part(own, drives)], "Scenic program", settings, notes, _Variants())


def watch_openscenario(path: Path, settings: VerifySettings) -> Watching:
    """Drives of a file of OpenSCENARIO, as the program that it is imported as; of a file of variants as those.

    A variant that cannot be imported or driven is told, and the others are judged.

    Raises:
        ScenarioError: It cannot be read, or says what cannot be said here, as does each of its variants.
        SettingsError: It has no such variant, or declares no such parameter.
    """
    from chatscene.imports.import_file import import_scenario

    within, as_written = Path(settings.within) if settings.within else None, _as_written(settings) is True
    with TemporaryDirectory(prefix="chatscene-") as folder:
        made = import_scenario(
            path,
            out=Path(folder) / "scenario.scenic",
            map_name=settings.map_name or None,
            variant=settings.variant or None,
            at_most=settings.draws,
            given=settings.given,
            within=within,
            partly=True,
        )
        parts, untold = list[_Part](), list[str]()
        shares = _shares(settings.draws, len(made.programs))
        for program, lies, numbers, variant, not_as_written in zip(
            made.programs, made.maps, shares, made.variants or (0,), made.not_as_written, strict=True
        ):
            try:
                own = read_foreign(program, searched_with=False, as_written=as_written)
            except ForeignCodeRefused as error:  # all else was held against it when it was imported
                why = _tells_nothing(path, not_as_written)
                untold.append(f"variant {variant} of {why}")
                if len(untold) == len(made.programs):
                    raise ScenarioError(why) from error
                continue
            # Resolved, since it is read in a process that works elsewhere.
            parts.append(_Part(replace(own, map_path=lies.resolve()), numbers, variant))
        notes = (
            *map(_not_judged, (*made.refused, *untold)),
            "its own ego drives" if as_written else f"{settings.ego or EGO} drives the ego",
            *(made.notes_as_written if as_written else made.notes),
        )
        left = made.count - len(made.programs) - len(made.refused)
        variants = _Variants() if settings.variant or not made.count else _Variants(made.count, left)
        # Within, since the map of a file without roads lies in this folder; each part has its map by now.
        return _watched(parts, "OpenSCENARIO file", replace(settings, map_name=""), notes, variants)


def _as_written(settings: VerifySettings) -> bool | None:
    """Whether the program's own ego drives; None where that is not asked for.

    Raises:
        SettingsError: Another ego is named, too.
    """
    if settings.as_written and settings.ego:
        raise SettingsError("with --as-written the program's own ego drives; name no other with --ego")
    return settings.as_written or (False if settings.ego else None)


def _tells_nothing(path: Path, not_as_written: Sequence[str]) -> str:
    """That a file cannot be driven as it is written, and why."""
    told = "\n  ".join(("", *not_as_written)) or " it gives its ego no speed and no action"
    return f"{path} cannot be driven as it is written:{told}; leave out --as-written"


@dataclass(frozen=True, slots=True)
class _Part:
    """A program of which some drives are judged: which of all, by their numbers, and which variant it is."""

    own: ForeignProgram
    drives: range
    variant: int = 0


def _shares(drives: int, programs: int) -> list[range]:
    """Which of so many drives are of each program: as many of one as of another, the first ones have one more."""
    ends = [-(-drives * k // programs) for k in range(programs + 1)]
    return [range(begin, end) for begin, end in pairwise(ends)]


@dataclass(frozen=True, slots=True)
class _Variants:
    """How many variants a file has, and of how many of them none of the drives is."""

    count: int = 1
    left: int = 0

    def judged(self, drives: Sequence[Watched]) -> Iterator[str]:
        """Which are judged, and how the others are."""
        judged = Counter(one.variant for one in drives)
        if self.count == 1 or not judged:
            return
        more = "; for others give more --draws, or --variant N" if self.left else ""
        if len(judged) == 1:
            yield f"variant {drives[0].variant} of {self.count} is judged{more}"
        else:
            told = ", ".join(f"{variant} ({many})" for variant, many in judged.items())
            yield f"judged, with how many drives, of {self.count} variants: {told}{more}"


def _not_judged(refused: str) -> str:
    """Why a variant is not judged, in one line."""
    return f"NOT judged: {' '.join(line.strip() for line in refused.splitlines())}"


def _watched(
    parts: Sequence[_Part], kind: str, settings: VerifySettings, notes: Sequence[str], variants: _Variants
) -> Watching:
    """Drives of programs, each on the first of its maps that has what it asks for.

    Of several, one that has none, or of which no drive comes to its end, is told; where all are such, the error is that
    of the first.

    Args:
        parts: The programs, and which drives are made of each.
        kind: What they are, in words.
        settings: How they are driven.
        notes: What is known before.
        variants: Of what file they are.
    """
    trying, more, lost = _Trying(settings), list[str](), list[ChatSceneError]()
    for part in parts:
        maps, told = _maps(part.own, settings)
        more += told
        try:
            _drive(part, maps, trying, settings)
        except (MapError, ProgramError, StuckBehavior, ProgramStopped) as error:
            lost.append(error)
            if len(lost) == len(parts):
                raise lost[0] from None
            more.append(_not_judged(f"variant {part.variant}: {error}"))
    return Watching(
        kind=kind,
        drives=tuple(trying.drives),
        rejected=tuple(trying.rejected),
        failed=trying.failed,
        notes=tuple(dict.fromkeys((*notes, *variants.judged(trying.drives), *more, *trying.notes()))),
        drawing=partial(_drawing, trying.ran),
    )


def _drive(part: _Part, maps: Sequence[Path], trying: _Trying, settings: VerifySettings) -> None:
    """Make the drives of a program, on the first map that has what it asks for.

    Raises:
        MapError: No map has it.
        ProgramError: It does not compile, or its own code fails in each drive that can be placed.
        StuckBehavior: It does not come to its end in any.
        ProgramStopped: The sandbox stops it in each.
    """
    for number, map_path in enumerate(maps, 1):
        simulator = _simulator(map_path, settings)
        with closing(simulator) if isinstance(simulator, ConfinedSimulator) else nullcontext():
            try:
                if not part.own.program.drawn:
                    simulator.route(part.own.program, 0)
            except MapError:
                if number == len(maps):
                    raise
                continue
            trying.drive(part, simulator, map_path)
            return


def _maps(own: ForeignProgram, settings: VerifySettings) -> tuple[list[Path], tuple[str, ...]]:
    """The map that a program or its user names, else each packaged one, the town first; and what there is to say."""
    named, notes = their_map(own.map_path, settings.map_name or None)
    if named is not None or own.program.drawn:
        return [resolve_map(named or TOWN)], notes
    return [resolve_map(name) for name in PACKAGED], notes


def _simulator(map_path: Path, settings: VerifySettings) -> Simulator:
    simulation = SimulationSettings()
    return load_simulator(map_path, simulation) if settings.trust else ConfinedSimulator(map_path, simulation)


class _Trying:
    """Drives that are made until there are enough, or until scenes that cannot be driven have cost too much.

    Attributes:
        drives: Those that were made.
        rejected: Why others were not.
        failed: How many of these the program itself failed in.
        ran: The map of each that was made, by its scene.
    """

    def __init__(self, settings: VerifySettings) -> None:
        self._settings, self._ego = settings, load_ego(settings.ego or EGO)
        self.drives, self.rejected, self.failed = list[Watched](), list[str](), 0
        self.ran = dict[str, Path]()
        self._tried_on = dict[str, None]()
        self._spent, self._tried, self._placed, self._draws = 0.0, 0, 0, 0

    def drive(self, part: _Part, simulator: Simulator, map_path: Path) -> None:
        """Make the drives of a program; one in which it fails is told, and costs as one that cannot be placed.

        Raises:
            ProgramError: It does not compile, or there is no drive but such in which its own code fails.
            StuckBehavior: The same, and the first of them does not come to its end.
            ProgramStopped: The same, and the first of them is one in which the sandbox stops it.
        """
        made, failed = len(self.drives), list[ChatSceneError]()
        for number in part.drives:
            if self._over():
                break
            self._tried += 1
            self._tried_on[map_path.stem] = None
            try:
                self._make(part, drawn_scene(part.own.program, number, seed=self._settings.seed), simulator, map_path)
            except (ProgramError, StuckBehavior, ProgramStopped) as error:
                self.failed += 1
                if not fails_in_its_scene(error):
                    raise
                failed.append(error)
                self._spent += 0.0 if isinstance(error, ProgramError) else PATIENCE
        if failed and len(self.drives) == made:
            raise failed[0]
        self.rejected += [str(error).partition("\n")[0] for error in failed]

    def _make(self, part: _Part, scene: Scene, simulator: Simulator, map_path: Path) -> None:
        program = part.own.program
        ego = fitted(self._ego, program)
        before = self._draws
        episode = simulate(simulator, program, scene, ego, placed=self._count)
        if isinstance(episode, Rejected):
            self.rejected.append(episode.reason)
            self._spent += episode.spent
            self._draws = max(self._draws, before + episode.draws)
            return
        careful, unknown = avoidable_if_driven(episode, program, scene, ego, simulator)
        self.drives.append(
            Watched(
                episode=episode,
                route=simulator.route_in(program, scene),
                tested=not program.as_written,
                avoidable=careful,
                unplayed=(*unplayed(program, episode), *unknown),
                variant=part.variant,
            )
        )
        self.ran[scene.id] = map_path

    def notes(self) -> Iterator[str]:
        """On which maps, how many draws met no requirement, and whether it was stopped."""
        there = dict.fromkeys(one.stem for one in self.ran.values())
        yield from (f"on map {stem}" for stem in there)
        yield from (f"tried on map {stem}" for stem in self._tried_on if not there)
        if self._draws > self._tried:
            for_them = f"{self._draws} draws for {self._placed} drive{'s' * (self._placed != 1)}"
            yield f"{for_them}: {self._draws - self._placed} met no requirement or had no place"
        if self._over() and self._tried < self._settings.draws:
            yield (
                f"stopped after {self._tried} of {self._settings.draws} drives: scenes that could not be driven took "
                f"{self._spent:.0f} s of processor time, and --budget allows {self._settings.budget:g} s"
            )

    def _count(self, draws: int) -> None:
        self._placed += 1
        self._draws += draws

    def _over(self) -> bool:
        return self._spent > 0.0 and self._spent >= self._settings.budget


def _drawing(ran: Mapping[str, Path], scene: str, box: tuple[float, float, float, float]) -> Mapping[str, Any]:
    from chatscene.maps.drawing import map_drawing
    from chatscene.maps.loading import load_roads

    return map_drawing(load_roads(ran[scene]), box)
