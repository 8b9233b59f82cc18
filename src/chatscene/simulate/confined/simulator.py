"""A simulator for strangers' programs: another one, hosted behind both walls.

The ego stays on this side: what it sees comes out of the confined process and its action goes in, step by step. So any
ego drives, and a program never meets it.
"""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import replace
from pathlib import Path
from typing import Any

from chatscene.ego.observation import OBSERVATIONS, Observation, check_preset
from chatscene.ego.policy import PEDALS, controls
from chatscene.errors import EgoError, ForeignCodeRefused, SettingsError
from chatscene.settings import SIMULATOR, SimulationSettings
from chatscene.simulate.confined.allow_list import check_foreign, refused
from chatscene.simulate.confined.confinement import Limits
from chatscene.simulate.confined.nursery import Confined, shared_nursery
from chatscene.simulate.confined.wire import (
    Message,
    episode_from_json,
    nonsense,
    number,
    numbers,
    route_from_json,
    scene_to_json,
    words,
)
from chatscene.simulate.simulator import load_simulator
from chatscene.terms.episode import Ending, Episode
from chatscene.terms.route import Route
from chatscene.terms.scene import Rejected, Scene, ScenicProgram

KEPT = 4  # confined processes at a time, one per program and who drives its ego
MOST_ROUTES = 10
NAME = "confined"

_Key = tuple[str, bool]


class ConfinedSimulator:
    """Runs scenes of strangers' programs in confined processes, one per program.

    Besides what the contract of a simulator names (`chatscene.simulate.simulator.Simulator`), every method may raise
    `ForeignCodeRefused` (the program uses what strangers may not use; nothing was run) and `SandboxError` (it was
    stopped).

    Args:
        map_path: The map everything runs on.
        settings: Step and limits, and what is hosted; if they name this one itself, or the one of runs where none is
            named, whose engine cannot come behind the walls, the embedded one is, with the same numbers.
        limits: What a program may use up.

    Attributes:
        identity: That of the hosted simulator, under a name of its own.

    Raises:
        SettingsError: There is no such simulator to host, or it cannot be confined.
    """

    def __init__(self, map_path: Path, settings: SimulationSettings, limits: Limits | None = None) -> None:
        if settings.simulator in (NAME, SIMULATOR):
            settings = replace(settings, simulator=SimulationSettings().simulator)
        hosted = load_simulator(map_path, settings).identity
        if not hosted.confinable:
            raise SettingsError(
                f"the simulator {settings.simulator!r} cannot run in the sandbox, and only there is run what is not "
                f"packaged; choose --simulator {SimulationSettings().simulator}, or --trust for a program of your own"
            )
        self.identity = replace(hosted, name=NAME)
        self._settings = settings
        self._nursery = shared_nursery(map_path, settings, limits or Limits())
        self._confined: OrderedDict[_Key, Confined] = OrderedDict()
        self._routes: dict[tuple[_Key, int], Route] = {}

    def __enter__(self) -> ConfinedSimulator:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """End the processes of its programs; the simulator can still be used and starts new ones then."""
        while self._confined:
            self._confined.popitem()[1].close()

    def route(self, program: ScenicProgram, index: int) -> Route:
        """The route a program's geometry picks under this index."""
        key = (_key(program), index)
        if key not in self._routes:
            self._routes[key] = route_from_json(self._at(program).ask("route", index=index))
        return self._routes[key]

    def routes(self, program: ScenicProgram) -> int:
        """How many routes the map has for a program's geometry, at most ten."""
        count = number(self._at(program).ask("routes"), "routes")
        if count not in range(MOST_ROUTES + 1):
            raise nonsense("the number of routes")
        return int(count)

    def route_in(self, program: ScenicProgram, scene: Scene) -> Route:
        """The route of the ego in a scene."""
        if not program.drawn:
            return self.route(program, scene.route)
        return route_from_json(self._at(program).ask("route_in", scene=scene_to_json(scene)))

    def layers(self, program: ScenicProgram) -> tuple[str, ...]:
        """The layers of the second wall that are in force for a program."""
        return self._at(program).layers

    def open(
        self,
        program: ScenicProgram,
        scene: Scene,
        *,
        observation: str = "safebench",
        pedals: str = "safebench",
        through_collisions: bool = False,
    ) -> ConfinedSession | Rejected:
        """Start a session; one at a time per program."""
        if pedals not in PEDALS:
            raise EgoError(f"there are no pedals {pedals!r}; known: {', '.join(PEDALS)}")
        size = OBSERVATIONS[check_preset(observation)]
        self._renew(program)
        confined = self._at(program)
        state = confined.ask(
            "open", scene=scene_to_json(scene), observation=observation, pedals=pedals, through=through_collisions
        )
        if "rejected" in state:
            draws, spent = int(number(state, "draws")), number(state, "spent")
            reason, without = words(state["rejected"]), state.get("without") is True
            return Rejected(scene=scene, reason=reason, draws=draws, spent=spent, without=without)
        return ConfinedSession(confined, state, size, self._settings)

    def _at(self, program: ScenicProgram) -> Confined:
        """The confined process of a program, a new one if it has none."""
        key = _key(program)
        held = self._confined.get(key)
        if held is None or not held.alive:
            if refusals := check_foreign(program.source):
                raise ForeignCodeRefused(refused(program.called, refusals, program.source, own=bool(program.own)))
            held = self._nursery.confine(program)
            self._confined[key] = held
            while len(self._confined) > KEPT:
                self._confined.popitem(last=False)[1].close()
        self._confined.move_to_end(key)
        return held

    def _renew(self, program: ScenicProgram) -> None:
        """Let a process go that has done half of what it may do in its life; the next scene gets a new one."""
        held = self._confined.get(_key(program))
        if held is not None and held.spent:
            held.close()
            del self._confined[_key(program)]


def _key(program: ScenicProgram) -> _Key:
    """What a process is of: a text, and who drives its ego, of which the process is told once."""
    return program.digest, program.as_written


class ConfinedSession:
    """A session in a confined process; see `chatscene.simulate.simulator.Session` for the contract.

    Attributes:
        observation: What the ego sees now.
        ending: Why it ended, or None while it goes on.
        rejection: Why the program itself rejects it, or empty.
        step_number: How many steps were made.
        along: Arc length of the ego on its route [m].
        offset: Lateral offset of the ego from its route [m, positive = left].
        speed: Of the ego [m/s].
        draws: How many draws the scene took to place.
    """

    def __init__(self, confined: Confined, state: Message, size: int, settings: SimulationSettings) -> None:
        self._confined = confined
        self._size = size
        self._settings = settings
        self.step_number = -1
        self.draws = int(number(state, "draws"))
        self.observation: Observation
        self.ending: Ending | None
        self.rejection: str
        self.along: float
        self.offset: float
        self.speed: float
        self._take(state)

    def step(self, action: Any) -> None:
        """Go on by one step with an action, acceleration and steering in [-1, 1].

        Raises:
            EgoError: The action is not two finite numbers.
            ProgramError: The program's own code fails.
            StuckBehavior: A behavior never yields.
            SandboxError: The program was stopped.
        """
        controls(action)  # refuses what is no action where the ego is
        acceleration, steering = action
        self._take(self._confined.ask("step", action=[float(acceleration), float(steering)]))
        if self.step_number >= self._settings.max_steps and self.ending is None and not self.rejection:
            raise nonsense("a drive without an end")

    def episode(self, scene_id: str, ego: str) -> Episode:
        """Everything that happened so far."""
        return episode_from_json(
            self._confined.ask("episode"),
            scene_id=scene_id,
            ego=ego,
            dt=self._settings.dt,
            steps=self.step_number + 1,
        )

    def close(self) -> None:
        """Give the process free for another session."""
        if self._confined.alive:
            self._confined.ask("close")

    def _take(self, state: Message) -> None:
        ending, rejection = state.get("ending"), words(state.get("rejection"))
        if ending is not None and ending not in Ending.__members__.values():
            raise nonsense("the ending")
        # A step is made, unless the program gave the drive up or a behavior ended it.
        step = number(state, "step")
        if step != self.step_number + 1 and not (step == self.step_number and (ending or rejection)):
            raise nonsense("the number of steps")
        self.step_number = int(step)
        self.ending = None if ending is None else Ending(ending)
        self.rejection = rejection
        self.observation = numbers(state.get("observation"), self._size)
        self.along, self.offset, self.speed = (number(state, name) for name in ("along", "offset", "speed"))
