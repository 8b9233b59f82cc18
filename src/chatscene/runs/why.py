"""Why a scene of a run crashed: who struck whom, what the crash needed, and what the ego could have done."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import asdict, dataclass
from heapq import nsmallest
from pathlib import Path
from typing import Any

from chatscene.ego.asking import fitted
from chatscene.errors import RunError
from chatscene.measure.avoidability import braking_step, crashes_braking_from
from chatscene.measure.counterfactual import (
    LEAST_SHARE,
    Braking,
    Came,
    NeededValue,
    Slower,
    Thing,
    Trial,
    highest_speed,
    in_words,
    last_moment,
    latest_braking,
    things_needed,
    values_needed,
    with_whom,
)
from chatscene.measure.severity import KMH
from chatscene.program.sample import scene_at
from chatscene.runs.blocks import each_scene, read_scenes
from chatscene.runs.crash import Contact, Pace, braking_in_words, last_moment_in_words
from chatscene.runs.rebuild import Remade, remade
from chatscene.runs.record import RunRecord
from chatscene.runs.tables import scene_of
from chatscene.runs.trust import Repeated, follow
from chatscene.runs.workspace import open_run
from chatscene.simulate.simulator import simulate
from chatscene.terms.actors import named
from chatscene.terms.scene import Rejected, Scene, ScenicProgram
from chatscene.terms.snippet import ParameterRange

CANDIDATES = 3  # how many of the nearest scenes without a crash are driven again, until one does not crash
MIDDLE = "middle"  # of every range


@dataclass(frozen=True, slots=True, kw_only=True)
class Back:
    """Where parameters are set back to.

    Attributes:
        name: The id of a scene, or `MIDDLE`.
        came: What comes with all of them set back.
    """

    name: str
    values: Mapping[str, float]
    came: Came


@dataclass(frozen=True, slots=True, kw_only=True)
class Why:
    """Why a scene crashed. Times are those of the scene [s].

    Attributes:
        pace: How fast both were, at which moment.
        risk: From when on a careful driver sees the crash coming; None if never.
        careful_brakes: When such a driver would begin to brake; None without a risk.
        avoidable: Whether that avoids it (decision 0013); None where it is not asked.
        last_moment: The last moment at which such braking avoids it; None if there is none.
        things: Whom and what else the program places, and whether the crash needs them.
        back: Where parameters are set back to; None if there is nowhere, so that nothing is known of values.
        values: The parameters that the crash needs.
        free: The parameters that it does not: set back together, it still crashes.
        ranges: The parameters of the program, by name.
        braking: The latest braking of the ego's own that avoids it; None if there is none.
        slower: The highest speed to keep to that avoids it; None if there is none.
        changeable: Whether the ego under test has the wheel, so that it could do otherwise.
        kinds: The class of everybody in the scene but the ego, by name.
        dt: Length of a step [s].
        drives: How often the scene was driven to find out.
    """

    scene_id: str
    contact: Contact
    pace: Pace
    risk: float | None
    careful_brakes: float | None
    avoidable: bool | None
    last_moment: float | None
    things: tuple[Thing, ...]
    back: Back | None
    values: tuple[NeededValue, ...]
    free: tuple[str, ...]
    ranges: Mapping[str, ParameterRange]
    braking: Braking | None
    slower: Slower | None
    changeable: bool
    kinds: Mapping[str, str]
    dt: float
    drives: int

    def as_dict(self) -> dict[str, Any]:
        """For a script."""
        return {
            "scene_id": self.scene_id,
            "contact": {name: value for name, value in asdict(self.contact).items() if name != "strike"}
            | {"fault": self.contact.fault.value},
            "speeds": asdict(self.pace.speeds),
            "harm": list(self.pace.harm),
            "moments": {name: self.pace.moment(time) for name, time in self._moments().items()},
            "risk": self.risk,
            "careful_brakes": self.careful_brakes,
            "avoidable": self.avoidable,
            "last_moment": self.last_moment,
            "things": [asdict(thing) for thing in self.things],
            "set_back_to": self.back and {"name": self.back.name, "then": in_words(self.back.came)},
            "values": [
                {"name": one.name, "value": one.value, "back": one.back, "unit": self.ranges[one.name].unit}
                | {"then": in_words(one.came)}
                for one in self.values
            ],
            "free": list(self.free),
            "braking": self.braking
            and {
                "from": self._at(self.braking.step),
                "before_contact": self._before(self.braking.step),
                "earlier": None if self.braking.own is None else round(self._earlier(self.braking), 6),
                "deceleration": self.braking.deceleration,
            },
            "slower": self.slower
            and {
                "limit": self.slower.limit,
                "by": round(self.slower.highest - self.slower.limit, 6),
            },
            "drives": self.drives,
        }

    def in_words(self) -> str:
        """A few lines for a person."""
        lines = [f"{self.scene_id}: {self.contact.in_words(self.kinds)}.", self.pace.in_words(), self._careful()]
        lines += self._of_things()
        lines += self._of_values()
        lines += self._of_ego()
        return "\n".join([*lines, f"Found by driving the scene {self.drives} times."])

    def _careful(self) -> str:
        if not self.changeable:
            return "The program's own ego drives, so other drivers were not tried."
        if self.risk is None or self.careful_brakes is None:
            seen = "Nobody could see the crash coming for long enough to judge it."
        else:
            seen = f"The crash could be seen coming from {self.risk:.1f} s on ({self.pace.at(self.risk)}). "
            seen += f"The careful driver of UN R157 brakes at {self.careful_brakes:.1f} s"
            seen += ", and avoids the crash." if self.avoidable else ", which does not avoid the crash."
        return f"{seen} {last_moment_in_words(self.last_moment, self.contact.time, self.risk, self.pace)}"

    def _all_named(self, thing: Thing) -> str:
        pairs = zip(thing.actors, thing.kinds, strict=True)
        return " and ".join(named(actor, kind, self.kinds) for actor, kind in pairs)

    def _of_things(self) -> list[str]:
        lines: list[str] = []
        for thing in self.things:
            told = self._all_named(thing)
            if thing.needed is None:
                lines.append(f"Whether {told} matters is unknown: {thing.why}.")
            elif thing.needed:
                lines.append(f"The crash needs {told}; without: {thing.why}.")
        if spare := [self._all_named(thing) for thing in self.things if thing.needed is False]:
            lines.append(f"Irrelevant: {', '.join(spare)}. Without, the same crash happens.")
        return lines

    def _of_values(self) -> list[str]:
        if not self.ranges:
            return ["The program has no parameters."]
        if self.back is None:
            return ["It is unknown which parameters matter: in the middle of the ranges the scene is rejected."]
        if self.back.came.crashed:
            return [
                "No parameter is decisive: no scene without a crash was found to compare with, and with every "
                "parameter in the middle of its range the same crash happens."
            ]
        where = f"as in {self.back.name}, the nearest scene without a crash"
        if self.back.name == MIDDLE:
            where = "in the middle of their ranges (no scene without a crash was found)"
            if self.back.came.other:
                where += f", where it is a crash with {with_whom(self.back.came)}"
        many = len(self.values)
        these = "One parameter is" if many == 1 else f"{many} parameters together are"
        lines = [f"{these} decisive: with all others {where}, the same crash happens:"]
        for one in self.values:
            unit = "" if (given := self.ranges[one.name].unit) == "1" else f" {given}"
            meaning = f" ({text})" if (text := self.ranges[one.name].meaning) else ""
            then = f"with {one.back:.4g}{unit}: {in_words(one.came)}"
            lines.append(f"  {one.name} = {one.value:.4g}{unit}{meaning}; {then}")
        return [*lines, f"Irrelevant: {', '.join(self.free)}."] if self.free else lines

    def _of_ego(self) -> list[str]:
        if not self.changeable:
            return []
        if self.braking is None and self.slower is None:
            return [
                "The ego avoids the crash neither by braking as hard as it can from any moment on, nor by driving "
                f"slower, down to {LEAST_SHARE:g} of its highest speed."
            ]
        return [self._of_braking(), self._of_slower()]

    def _of_braking(self) -> str:
        return braking_in_words(self.braking, self.contact.time, self.risk, self.pace)

    def _of_slower(self) -> str:
        if self.slower is None:
            return f"The ego does not avoid the crash by driving slower, down to {LEAST_SHARE:g} of its highest speed."
        by = self.slower.highest - self.slower.limit
        return (
            f"The ego avoids the crash if it drives at no more than {KMH * self.slower.limit:.1f} km/h, "
            f"{KMH * by:.1f} km/h slower than its highest speed before the contact."
        )

    def _moments(self) -> dict[str, float]:
        """The turning points of the scene that there are [s], by name, in no order."""
        braking = self.braking
        times = {
            "encounter": self.pace.speeds.encounter_time,
            "risk": self.risk,
            "careful_brakes": self.careful_brakes,
            "last_moment": self.last_moment,
            "braking": None if braking is None else self._at(braking.step),
            "own_braking": None if braking is None or braking.own is None else self._at(braking.own),
        }
        return {name: time for name, time in times.items() if time is not None}

    def _at(self, step: int) -> float:
        return round(step * self.dt, 6)

    def _before(self, step: int) -> float:
        return round(self.contact.time - self._at(step), 6)

    def _earlier(self, braking: Braking) -> float:
        return (braking.own or 0) * self.dt - braking.step * self.dt


def why(folder: Path, scene_id: str, *, repeated: Repeated | None = None) -> Why:
    """Say why a scene of a run crashed, by driving it otherwise.

    Raises:
        RunError: The run has no such scene, or it did not crash, or does not crash any more; or it names what must be
            repeated (`chatscene.runs.trust.follow`).
    """
    trial, rows = trial_of(folder, scene_id, repeated=repeated)
    episode, dt, crash = trial.episode, trial.episode.dt, trial.crash
    changeable = not trial.program.as_written
    risk = trial.risk
    careful = None if risk is None else braking_step(risk, dt)
    things = things_needed(trial)
    back = back_of(trial, rows)
    values = () if back is None or back.came.crashed else values_needed(trial, back.values)
    needed = {one.name for one in values}
    last = last_moment(trial) if changeable else None
    braking = latest_braking(trial) if changeable else None
    slower = highest_speed(trial) if changeable else None
    avoidable = None
    if changeable:
        avoidable = (
            careful is not None
            and careful < crash.step
            and not crashes_braking_from(careful, trial.ego, trial.program, trial.scene, trial.simulator, dt)
        )
    return Why(
        scene_id=scene_id,
        contact=Contact.of(trial),
        pace=Pace.of(trial),
        risk=None if risk is None else round(risk * dt, 6),
        careful_brakes=None if careful is None else round(careful * dt, 6),
        avoidable=avoidable,
        last_moment=None if last is None else round(last * dt, 6),
        things=things,
        back=back,
        values=values,
        free=tuple(name for name in trial.scene.values if back and name not in needed),
        ranges={p.name: p for p in trial.program.parameters},
        braking=braking,
        slower=slower,
        changeable=changeable,
        kinds=episode.kinds,
        dt=dt,
        drives=trial.drives,
    )


def trial_of(
    folder: Path, scene_id: str, *, repeated: Repeated | None = None
) -> tuple[Trial, Iterator[Mapping[str, Any]]]:
    """A scene of a run that crashed, driven again, and the rows of all scenes of the run, read as they are asked for.

    Raises:
        RunError: As `why`.
    """
    run = open_run(folder, RunRecord)
    follow(repeated or Repeated(), egos_of=[run], simulators_of=[run], joining_of=[run])
    row = next(iter(read_scenes(run, ids=[scene_id])), None)
    if row is None or row["status"] != "ran":
        raise RunError(f"{folder} has no scene {scene_id!r} that was driven")
    if not row["collision"]:
        raise RunError(f"scene {scene_id!r} ended without a collision, so there is nothing to explain")
    return trial_in(remade(run), row), each_scene(run)


def trial_in(made: Remade, row: Mapping[str, Any]) -> Trial:
    """A scene that crashed, driven again with what its run was made of.

    Raises:
        RunError: It does not crash any more.
    """
    program, simulator = made.program, made.simulator
    scene = scene_of(row, program)
    ego = fitted(made.ego, program)
    episode = simulate(simulator, program, scene, ego)
    if isinstance(episode, Rejected) or episode.collision is None:
        raise RunError(f"scene {scene.id!r} crashed when it was made and does not now; `chatscene replay` says more")
    route = simulator.route_in(program, scene).line
    return Trial(program=program, scene=scene, ego=ego, simulator=simulator, episode=episode, route=route)


def back_of(trial: Trial, rows: Iterable[Mapping[str, Any]]) -> Back | None:
    """Where the parameters of a scene are set back to.

    The nearest scene of the run on the same route that did not crash and does not; else the middle of every range,
    whatever comes of that. Near is by the root mean square of differences, each as a share of its declared range.

    Returns:
        None if the program has no parameters, or cannot be driven in the middle either.
    """
    mine, program = trial.scene, trial.program
    if not mine.values:
        return None
    same = (row for row in rows if row["status"] == "ran" and not row["collision"])
    scenes = (scene for scene in (scene_of(row, program) for row in same) if scene.route == mine.route)
    for scene in nsmallest(CANDIDATES, scenes, key=lambda scene: (_far(program, mine, scene), scene.id)):
        if (came := trial.drive(values=scene.values)).harmless:
            return Back(name=scene.id, values=scene.values, came=came)
    values = scene_at(program, mine.route, 0.5, name=MIDDLE).values
    came = trial.drive(values=values)
    return None if came.rejected else Back(name=MIDDLE, values=values, came=came)


def _far(program: ScenicProgram, a: Scene, b: Scene) -> float:
    shares = [(a.values[p.name] - b.values[p.name]) / (p.high - p.low) for p in program.parameters if p.high > p.low]
    return math.sqrt(sum(share * share for share in shares))
