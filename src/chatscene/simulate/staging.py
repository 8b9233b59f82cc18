"""From a scene's concrete values to Scenic's scene.

In a program for our own world model nothing is drawn, everything is set. What a program for another model draws beside
its parameters, places above all, it draws with the scene's seed, again and again until its requirements hold.
"""

from __future__ import annotations

import random
import re
import time
from collections import Counter, OrderedDict
from contextlib import nullcontext, suppress
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from scenic.core.distributions import RejectionException, needsSampling
from scenic.core.dynamics.scenarios import DynamicScenario
from scenic.core.sample_checking import SampleChecker

from chatscene.errors import MapError, ProgramError
from chatscene.maps.loading import load_roads
from chatscene.maps.network import load_network, map_digest
from chatscene.simulate.choices import Choices, choices_of, is_not_there, not_there
from chatscene.simulate.heading_for import route_of_ego
from chatscene.simulate.placing import NoFunction, Placement
from chatscene.simulate.simulation import SteppedSimulation
from chatscene.simulate.watchdog import time_limit
from chatscene.terms.scene import AS_WRITTEN, OWN_MODEL, Rejected, Scene, ScenicProgram
from chatscene.world.compilation import compile_program
from chatscene.world.ego_route import EgoRoute

NO_PLACE = "a place that the program asks for, such as the edge of the road, is not there"
COMPILED = 512  # programs on a route kept per process that share a world model, some 0.1 MB each; a benchmark has 400
COMPILED_APART = 16  # of those that have one of their own, a few MB each
PLACED = 64  # drawn scenes kept per process, since many egos drive the same
NEVER = 25  # draws, after which it is looked for what is not there, if half of them ask for that
DRAWING = 15.0  # [s] of processor time in which a scene is to be drawn
_Key = tuple[object, ...]
_SETS_NAMES = re.compile(r"^\s*global\s|\bglobals\(", re.MULTILINE)  # in a module: names may be set in a drive


class _InOrder(SampleChecker):
    """Checks the program's own requirements in the order they are written.

    Scenic's checker orders them by measured time, which would make the reason of a rejection a matter of luck;
    overlaps are checked on the bodies instead (`chatscene.simulate.session`).

    Args:
        drawn: Whether places are drawn, so that what Scenic requires of every thing is checked too, after the
            program's own: that it stands in its region, is seen where it must be, and overlaps nothing.
    """

    def __init__(self, drawn: bool) -> None:
        super().__init__()
        self.reason = ""
        self._drawn = drawn

    def setRequirements(self, requirements: Any) -> None:  # noqa: N802 - Scenic's name
        own = [req for req in requirements if hasattr(req, "prob")]
        others = [req for req in requirements if not hasattr(req, "prob") and not req.optional]
        super().setRequirements([*own, *others] if self._drawn else own)

    def checkRequirementsInner(self, sample: Any) -> Any:  # noqa: N802
        for req in self.requirements or ():
            if req.active and req.falsifiedBy(sample):
                self.reason = str(req.violationMsg)
                return self.reason
        return None


@dataclass(slots=True)
class _Compiled:
    """A program on one of its routes of a map.

    Attributes:
        scenario: Scenic's.
        placement: How its scenes are placed without Scenic, once one was: None where Scenic has to place each.
        learned: Whether one was.
        choices: What of the map it can choose at all; None where that is not known.
        counted: Whether that was looked for.
    """

    scenario: Any
    placement: Placement | None = None
    learned: bool = False
    choices: Choices | None = None
    counted: bool = False


@dataclass(slots=True)
class _Failed:
    """The draws of a scene that did not meet the requirements.

    Attributes:
        reasons: Why, and how often.
        places: How many asked for what is not there.
        nothing: What Python said of the last of these, if it read something of nothing.
    """

    reasons: Counter[str]
    places: int = 0
    nothing: AttributeError | None = None


_compiled: OrderedDict[_Key, _Compiled] = OrderedDict()
_compiled_apart: OrderedDict[_Key, _Compiled] = OrderedDict()
"""What this process has compiled: each of its simulators is asked for the same programs."""


def _kept_with(program: ScenicProgram) -> tuple[OrderedDict[_Key, _Compiled], int]:
    """Where a program is kept once it is compiled, and beside how many."""
    apart = program.own or program.model != OWN_MODEL
    return (_compiled_apart, COMPILED_APART) if apart else (_compiled, COMPILED)


class Stage:
    """The compiled programs of one map, ready to have values set in them.

    Attributes:
        draws: How many draws the scene took that was placed last.
    """

    def __init__(self, map_path: Path) -> None:
        self._map_path = map_path
        self._placed: OrderedDict[tuple[object, ...], tuple[Any | Rejected, int]] = OrderedDict()
        self.draws = 1

    @cached_property
    def _map(self) -> str:
        return map_digest(self._map_path)

    def _key_of(self, program: ScenicProgram, route: int) -> _Key:
        """By what a program is kept: the map, its text, who drives its ego, and its route.

        The behavior of an ego under test is taken away, and so the program as written is another one.
        """
        text = program.digest, program.filename, program.model, program.own
        return self._map, str(self._map_path), *text, program.as_written, 0 if program.drawn else route

    def compiled(self, program: ScenicProgram, route: int) -> Any:
        """Scenic's scenario for a program on one of its routes.

        Raises:
            DoesNotCompile: Scenic refuses the program.
            MapError: The map has no such route.
            StuckBehavior: It does not come to its end.
        """
        key, (compiled, most) = self._key_of(program, route), _kept_with(program)
        if key not in compiled:
            # A large map takes its time, which is not the program's.
            (load_network if program.own or program.model != OWN_MODEL else load_roads)(self._map_path)
            with time_limit(f"{program.called}, being compiled,"):
                scenario = compile_program(
                    program.source,
                    map_path=self._map_path,
                    route=route,
                    filename=program.filename,
                    called=program.called if program.own else "",
                    model=program.model,
                    own=bool(program.own),
                )
            scenario.setSampleChecker(_InOrder(program.drawn))
            scenario.behaviorNamespaces = {  # of a module that is imported Scenic keeps the text in it
                name: names if _SETS_NAMES.search(names.get("_source", program.source)) else _Drawn(names)
                for name, names in scenario.behaviorNamespaces.items()
            }
            compiled[key] = _Compiled(scenario)
            while len(compiled) > most:
                compiled.popitem(last=False)
        compiled.move_to_end(key)
        return compiled[key].scenario

    def learn(self, program: ScenicProgram, route: int, placed: SteppedSimulation) -> None:
        """Take in a scene that was placed, as it began; the next may be placed by `placement`."""
        there = _kept_with(program)[0].get(self._key_of(program, route))
        if there is not None and not there.learned:
            there.learned = True
            with suppress(NoFunction):
                there.placement = Placement(there.scenario, placed)

    def placement(self, program: ScenicProgram, scene: Scene) -> Placement | None:
        """Where things stand, for the values of such a scene; None where `place` has to say it."""
        key, (compiled, _) = self._key_of(program, scene.route), _kept_with(program)
        found = there.placement if (there := compiled.get(key)) is not None else None
        if found is None or program.drawn or program.as_written or found.parameters != set(scene.values):
            return None
        self.draws = 1
        compiled.move_to_end(key)
        return found

    def place(self, program: ScenicProgram, scene: Scene) -> Any | Rejected:
        """Scenic's scene with the values of ours, or why there is none.

        Raises:
            ProgramError: The scene has not a value for every parameter, or the program cannot be evaluated.
        """
        scenario = self.compiled(program, scene.route)
        if program.drawn and _is_spent(scenario):
            del _kept_with(program)[0][self._key_of(program, scene.route)]
            self._placed.clear()
            scenario = self.compiled(program, scene.route)
        declared = {name for name in scenario.params if name.startswith("OPT_")}
        if declared != set(scene.values):
            raise ProgramError(
                f"scene {scene.id!r} has values for {sorted(scene.values)}, its program tunes {sorted(declared)}"
            )
        if scene.values:
            scenario.conditionOn(params=dict(scene.values))
        if program.drawn:
            return self._draw(program, scenario, scene)
        self.draws = 1
        random.seed(scene.seed)  # nothing of ours draws from it; a stranger's program might
        scenario.checker.reason = NO_PLACE
        try:
            placed = scenario.generate(maxIterations=1)[0]
        except RejectionException:
            return Rejected(scene=scene, reason=scenario.checker.reason)
        ego = placed.egoObject
        if not program.as_written and type(ego.behavior).__name__ == AS_WRITTEN:  # the ego under test drives
            object.__setattr__(ego, "behavior", None)
        return placed

    def _draw(self, program: ScenicProgram, scenario: Any, scene: Scene) -> Any | Rejected:
        """A scene whose places Scenic draws; the same for the same seed and values."""
        key = (program.digest, program.as_written, scene.seed, *sorted(scene.values.items()))
        if key not in self._placed:
            with time_limit(f"{program.called}, being drawn,"):
                self._placed[key] = self._drawn(program, scenario, scene)
            while len(self._placed) > PLACED:
                self._placed.popitem(last=False)
        self._placed.move_to_end(key)
        _seed(scene.seed, 1)  # whatever was drawn until here, and by whom, the drive draws from its own beginning
        found, self.draws = self._placed[key]
        return replace(found, scene=scene) if isinstance(found, Rejected) else found

    def _choices(self, program: ScenicProgram, scenario: Any, scene: Scene) -> Choices | None:
        """What of the map a program can choose at all: counted once, by itself, whatever its parameters are."""
        there = _kept_with(program)[0][self._key_of(program, scene.route)]
        if not there.counted:
            there.counted = True
            _seed(0, 0)
            told = [scenario.params[name] for name in scene.values]
            given = [one._conditioned for one in told]
            for one in told:
                one.conditionTo(one)
            try:
                there.choices = choices_of(scenario)
            finally:
                for one, value in zip(told, given, strict=True):
                    one.conditionTo(value)
        return there.choices

    def _once(self, scenario: Any, choices: Choices | None, failed: _Failed) -> Any | None:
        """A scene whose ego has a route, drawn once; None where it does not meet the requirements, which is counted."""
        scenario.checker.reason = NO_PLACE
        try:
            with choices.chosen() if choices else nullcontext():
                drawn = scenario.generate(maxIterations=1)[0]
            route = route_of_ego(drawn, self._map_path.stem)
        except RejectionException:
            failed.places += scenario.checker.reason == NO_PLACE
            failed.reasons[scenario.checker.reason] += 1
        except MapError as error:
            failed.reasons[str(error)] += 1
        except AttributeError as error:  # of nothing, as where a lane has none beside it
            if not is_not_there(error):
                raise
            failed.places, failed.nothing = failed.places + 1, error
            failed.reasons[not_there(error)] += 1
        else:
            object.__setattr__(drawn.egoObject, "route", EgoRoute(route, drawn.workspace.network, 1))
            return drawn
        return None

    def _without(self, scene: Scene, none: str, spent: float) -> Rejected:
        """A scene that the map has no place for, and why."""
        why = f"{self._map_path.stem} has no such place: {none}; another map may have one"
        return Rejected(scene=scene, reason=why, draws=NEVER, spent=spent, without=True)

    def _drawn(self, program: ScenicProgram, scenario: Any, scene: Scene) -> tuple[Any | Rejected, int]:
        """The first scene that Scenic draws and that meets the requirements, its ego with a route; how many it drew."""
        _seed(scene.seed, 0)
        failed = _Failed(Counter())
        choices: Choices | None = None
        began = time.process_time()
        while (spent := time.process_time() - began) < DRAWING:
            drawn = self._once(scenario, choices, failed)
            if drawn is not None:
                if not program.as_written:  # the ego under test drives in its place
                    object.__setattr__(drawn.egoObject, "behavior", None)
                return drawn, failed.reasons.total() + 1
            if failed.reasons.total() == NEVER and 2 * failed.places >= NEVER:
                choices = self._choices(program, scenario, scene)
                if choices is None and failed.nothing is not None and len(failed.reasons) == 1:
                    raise failed.nothing  # it is the program that is at fault
                if choices is not None and choices.none:
                    return self._without(scene, choices.none, spent), NEVER
                _seed(scene.seed, 2)
        reasons = failed.reasons
        why = "; ".join(f"{times} times: {reason}" for reason, times in reasons.most_common(3))
        reason = f"none of {reasons.total()} draws in {spent:.0f} s of processor time meets the requirements ({why})"
        rejected = Rejected(scene=scene, reason=reason, draws=reasons.total(), spent=spent)
        return rejected, rejected.draws


def _is_spent(scenario: Any) -> bool:
    """Whether a drive has begun a sub-scenario that stands at a program's top level; it can be begun once."""
    first = scenario.dynamicScenario
    names = getattr(first._setup or first._compose, "__globals__", {})
    subs: list[Any] = [one for one in names.values() if isinstance(one, DynamicScenario) and one is not first]
    return any(one._prepared and not one._dummyNamespace for one in subs)


class _Drawn(dict[str, Any]):
    """What of a module's names is drawn; Scenic's way to put every name of it in anew for each scene is long.

    Args:
        module: All its names, none of which is set while a scene runs.

    Attributes:
        module: As above.
    """

    def __init__(self, module: dict[str, Any]) -> None:
        super().__init__((name, value) for name, value in module.items() if needsSampling(value))
        self.module = module

    def clear(self) -> None:
        """Nothing is taken out: all that is there is put in again."""

    def update(self, *drawn: Any, **named: Any) -> None:
        """Put them into the module."""
        self.module.update(*drawn, **named)


def _seed(seed: int, part: int) -> None:
    """Begin the random numbers of a part of a scene, those of Python and of numpy, which Scenic both draws from."""
    random.seed(f"{seed}/{part}")
    np.random.seed((seed + part) % 2**32)
