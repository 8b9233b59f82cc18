"""What the baselines start from: one adversary per base scenario, and what it does if nobody disturbs it.

A baseline changes how that adversary starts or moves; who it is, where the ego drives and how scenes are driven,
selected and measured is the same for all, and the same as for ChatScene (decision 0022). So are the routes among the
baselines; a scenario of ChatScene's may ask for another geometry. Speeds and triggers are those of SafeBench's
scenarios, but for the cyclist's speed and the lane-changing car's.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

from chatscene.errors import SettingsError
from chatscene.library.load import load_library
from chatscene.program.assemble import assemble
from chatscene.search.generator import Choice, Written
from chatscene.search.generators.exploring import Exploring
from chatscene.settings import PAPER, RetrievalSettings, SearchSettings
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.scenario import BaseScenario, Component, Scenario, Slots, SubDescriptions
from chatscene.terms.scene import ScenicProgram
from chatscene.terms.snippet import ParameterRange, Snippet, Tried


@dataclass(frozen=True, slots=True, kw_only=True)
class Cited:
    """What SafeBench's baselines vary of it (SafeBench v1, ``convert_actions`` of ``scenario_definition``).

    Its lane-changing adversary leads the ego and has no counterpart here, so that but for the offset the numbers are
    ours; and what it holds fixed, LC varies here too: the trigger of vehicle passing and the speeds of the two
    obstacles, by 5 m and by half.

    Attributes:
        triggers: Of Learning-to-Collide [m].
        speeds: Of Learning-to-Collide [m/s].
        start: How far to either side of the middle it starts there [m]; None where the start is told otherwise, and
            ours is kept.
        offset: How far to either side of its path it strays as an adversarial trajectory [m].
        trigger: When it sets off there [m].
    """

    triggers: tuple[float, float]
    speeds: tuple[float, float]
    start: float | None = None
    offset: float
    trigger: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Nominal:
    """The undisturbed adversary of a base scenario.

    Attributes:
        geometry: Snippet of the ego's route, one that most of ChatScene's scenarios of the base scenario use too.
        path: Name of the way it drives; empty if it goes straight ahead from where it stands at the roadside.
        waits: What it does until it acts, as Scenic.
        left: How far the ego still has to go [m] to where they meet, as Scenic; it acts when that is below a trigger.
        speed: How fast it then is [m/s].
        trigger: That distance [m].
        own: How far it still has to go itself [m] to where it crosses the ego's way, as Scenic; empty if it does not.
        leads: Whether it is ahead of the ego on the same way, in the end.
        once: What else must hold before it acts, as Scenic; empty for nothing.
        turns: Where it goes at a junction, best first; empty if it meets none.
        cited: What SafeBench's baselines vary of it.
    """

    adversary: AdversaryKind
    geometry: str
    spawn: str
    path: str = "advTrajectory"
    waits: str = "Halt()"
    left: str
    speed: float
    trigger: float
    own: str = ""
    leads: bool = False
    once: str = ""
    turns: tuple[str, ...] = ()
    cited: Cited

    def moves(self, speed: str, aside: str = "") -> str:
        """Scenic that lets it move on at a speed; `aside`: to the left of its path [m], or of its course [rad]."""
        more = f", {aside}" if aside else ""
        return f"DrivePath({self.path}, {speed}{more})" if self.path else f"MoveAhead({speed}{more})"

    def acts(self, trigger: str) -> str:
        """Scenic condition: the ego is near enough, and nothing else holds it back."""
        near = f"{self.left} < {trigger}"
        return f"{self.once} and {near}" if self.once else near


TO_ADVERSARY = "headway(egoRoute, ego, self)"
_TO_MEETING = "distanceLeft(egoRoute, ego, egoMeeting)"
_OWN_TO_MEETING = "distanceLeft(advTrajectory, self, advMeeting)"
_OWN_TO_ROUTE = "abs(offsetFrom(egoRoute, self))"
_CROSSES = ("straight", "left-turn", "right-turn")

NOMINAL: dict[BaseScenario, Nominal] = {
    BaseScenario.STRAIGHT_OBSTACLE: Nominal(
        adversary=AdversaryKind.PEDESTRIAN, geometry="straight-road", spawn="roadside-right", path="",
        left=TO_ADVERSARY, own=_OWN_TO_ROUTE, speed=2.5, trigger=20.0,
        cited=Cited(triggers=(15.0, 50.0), speeds=(1.25, 3.75), offset=1.0, trigger=35.0),
    ),
    BaseScenario.TURNING_OBSTACLE: Nominal(
        adversary=AdversaryKind.BICYCLE, geometry="left-turn", spawn="exit-corner-right", path="",
        left=TO_ADVERSARY, own=_OWN_TO_ROUTE, speed=5.0, trigger=17.0,
        cited=Cited(triggers=(10.0, 50.0), speeds=(2.5, 7.5), offset=1.0, trigger=17.0),
    ),
    BaseScenario.LANE_CHANGING: Nominal(
        adversary=AdversaryKind.CAR, geometry="lane-change-left", spawn="adjacent-lane-ahead-leader",
        waits="KeepStation(advTrajectory, ego)", leads=True, left="distanceLeft(egoRoute, ego, egoRoute.eventAt)",
        speed=3.0, trigger=15.0,
        cited=Cited(triggers=(5.0, 30.0), speeds=(1.5, 4.5), offset=2.0, trigger=15.0),  # but for the offset ours
    ),
    BaseScenario.VEHICLE_PASSING: Nominal(
        adversary=AdversaryKind.CAR, geometry="bypass", spawn="oncoming-beyond-blocker",
        left="gap(self, ego)", speed=8.0, trigger=45.0,
        cited=Cited(triggers=(40.0, 50.0), speeds=(6.0, 10.0), offset=2.0, trigger=45.0),
    ),
    BaseScenario.RED_LIGHT_RUNNING: Nominal(
        adversary=AdversaryKind.CAR, geometry="straight-signalised", spawn="crossing-from-left",
        speed=10.0, trigger=35.0, once='crossSignal == "red"', left=_TO_MEETING, own=_OWN_TO_MEETING, turns=_CROSSES,
        cited=Cited(triggers=(30.0, 40.0), speeds=(5.0, 15.0), start=5.0, offset=3.0, trigger=40.0),
    ),
    BaseScenario.UNPROTECTED_LEFT_TURN: Nominal(
        adversary=AdversaryKind.CAR, geometry="left-turn-four-way", spawn="oncoming-at-junction",
        speed=12.0, trigger=45.0, left=_TO_MEETING, own=_OWN_TO_MEETING, turns=_CROSSES,
        cited=Cited(triggers=(40.0, 50.0), speeds=(7.0, 17.0), start=5.0, offset=3.0, trigger=50.0),
    ),
    BaseScenario.RIGHT_TURN: Nominal(
        adversary=AdversaryKind.CAR, geometry="right-turn", spawn="crossing-from-left",
        speed=12.0, trigger=35.0, left=_TO_MEETING, own=_OWN_TO_MEETING, turns=_CROSSES,
        cited=Cited(triggers=(30.0, 40.0), speeds=(7.0, 17.0), start=5.0, offset=3.0, trigger=45.0),
    ),
    BaseScenario.CROSSING_NEGOTIATION: Nominal(
        adversary=AdversaryKind.CAR, geometry="straight-junction-unsignalised", spawn="crossing-from-right",
        speed=10.0, trigger=35.0, left=_TO_MEETING, own=_OWN_TO_MEETING, turns=_CROSSES,
        cited=Cited(triggers=(30.0, 40.0), speeds=(5.0, 15.0), start=5.0, offset=3.0, trigger=40.0),
    ),
}  # fmt: skip


class Baseline(Exploring):
    """What the baselines share; see `chatscene.search.generator.Generator` for the contract.

    Attributes:
        sampler: Who searches; empty for whom the settings name, as in ChatScene's own search.
        objective: What it searches for; empty for what the settings name.
        reference: As the reference describes it: what its search ends with is kept, whatever comes of it.
        starts: Whether it also moves where the adversary starts.
    """

    name: str
    title: str
    sampler: str = ""
    objective: str = ""
    reference: SearchSettings = replace(PAPER, scenes=100, keep=10, selection="last")
    starts: bool = False

    def behavior(self, nominal: Nominal) -> tuple[str, tuple[ParameterRange, ...]]:
        """The body of the adversary's behavior, as Scenic, and the parameters that it names."""
        raise NotImplementedError

    def texts(self, base: BaseScenario) -> tuple[str, ...]:
        """One scenario for each base scenario."""
        return (f"{self.title}: {base.value}",)

    def read(self, text: str, settings: RetrievalSettings) -> Scenario:  # noqa: ARG002 - nothing is retrieved
        """The scenario of one of `texts`; nothing was said, so nothing is held against it."""
        base = next((base for base in BaseScenario if text in self.texts(base)), None)
        if base is None:
            raise SettingsError(f"{self.name} has scenarios of its own alone, such as {self._example()!r}")
        texts = self.texts(base)
        number = f"-{texts.index(text) + 1}" if len(texts) > 1 else ""
        parts = SubDescriptions(behavior=text, geometry=text, spawn=text)
        return Scenario(id=f"{self.name}-{base}{number}", text=text, base=base, parts=parts, slots=Slots())

    def _example(self) -> str:
        return self.texts(BaseScenario.STRAIGHT_OBSTACLE)[0]

    def write(self, scenario: Scenario, settings: RetrievalSettings, tried: Sequence[Tried] = ()) -> Written:  # noqa: ARG002
        """The nominal adversary with this baseline's behavior."""
        if scenario.base is None:
            raise SettingsError(f"{self.name} needs a base scenario, such as in {self._example()!r}")
        nominal = NOMINAL[scenario.base]
        # Its parts are no choice of a retrieval, so that none of them is blamed and replaced.
        program = replace(assemble(scenario, self.triple(scenario, nominal), nominal.adversary), snippet_ids=())
        return Written(program=program, retrieval=None)

    def triple(self, scenario: Scenario, nominal: Nominal) -> tuple[Snippet, Snippet, Snippet]:  # noqa: ARG002
        """Behavior, geometry and spawn: what this baseline does, where the nominal adversary would."""
        library = load_library()
        spawn = library.get(f"spawn/{nominal.spawn}")
        return self._snippet(nominal), library.get(f"geometry/{nominal.geometry}"), self.start(spawn, nominal)

    def start(self, spawn: Snippet, nominal: Nominal) -> Snippet:  # noqa: ARG002 - SafeBench's differ by it
        """Where the adversary starts: anywhere that its snippet says, or in the middle of that."""
        return spawn if self.starts else _fixed(spawn)

    def write_again(self, scenario: Scenario, choice: Choice | None, settings: RetrievalSettings) -> ScenicProgram:  # noqa: ARG002
        """The same as before: it depends on the base scenario alone."""
        return self.write(scenario, settings).program

    def _snippet(self, nominal: Nominal) -> Snippet:
        body, parameters = self.behavior(nominal)
        lines = [f"param {p.name} = Range({p.low:g}, {p.high:g})" for p in parameters]
        turns = f"advTurn = {nominal.turns}\n\n" if nominal.turns else ""
        code = "\n".join(f"    {line}" for line in body.splitlines())
        return Snippet(
            id=f"behavior/{self.name}",
            component=Component.BEHAVIOR,
            description=self.title,
            rephrasings=(),
            slots=Slots(),
            adversaries=(nominal.adversary,),
            requires=(),
            provides=("AdvBehavior", "advTurn"),
            parameters=parameters,
            source="\n".join(lines) + f"\n\n{turns}behavior AdvBehavior():\n{code}",
        )

    def is_trusted(self, settings: RetrievalSettings) -> bool:  # noqa: ARG002
        """Always: the code is ours."""
        return True

    def searching(self, settings: SearchSettings) -> SearchSettings:
        """Its own sampler and objective, if it has them; those of the settings are ChatScene's."""
        return replace(
            settings, sampler=self.sampler or settings.sampler, objective=self.objective or settings.objective
        )


def narrowed(spawn: Snippet, room: float) -> Snippet:
    """A spawn whose adversary starts no farther than so many metres from the middle of each range."""
    source, parameters = spawn.source, list[ParameterRange]()
    for p in spawn.parameters:
        middle = (p.low + p.high) / 2
        low, high = max(p.low, round(middle - room, 3)), min(p.high, round(middle + room, 3))
        source = re.sub(
            rf"^param {p.name} = .*$", f"param {p.name} = Range({low:g}, {high:g})", source, flags=re.MULTILINE
        )
        parameters.append(replace(p, low=low, high=high))
    return replace(spawn, parameters=tuple(parameters), source=source)


def _fixed(spawn: Snippet) -> Snippet:
    """A spawn whose adversary starts in the middle of every range."""
    source = spawn.source
    for p in spawn.parameters:
        source = re.sub(rf"^param {p.name} = .*\n", "", source, flags=re.MULTILINE)
        source = re.sub(rf"\bglobalParameters\.{p.name}\b", f"{round((p.low + p.high) / 2, 3):g}", source)
    return replace(spawn, parameters=(), source=source)
