"""The other side of the second wall: a process that warms up on our own code, then forks a confined one per program.

Started as ``python -I -m`` with its name, a file descriptor and an empty environment. Importing Scenic and reading the
map takes seconds and is done once, before anything of a stranger's is seen; this process never sees it. For each
program it forks: the copy gives up all it could do harm with (`confinement.confine`), and only then reads the program.
"""

from __future__ import annotations

import builtins
import gc
import json
import os
import shutil
import signal
import socket
import sys
from collections.abc import Callable
from contextlib import suppress
from dataclasses import astuple, replace
from pathlib import Path
from typing import Any, NoReturn

from scenic.core.geometry import triangulatePolygon
from shapely.geometry import box

from chatscene.errors import ChatSceneError
from chatscene.maps.loading import load_roads
from chatscene.maps.network import load_network
from chatscene.plane import whole
from chatscene.settings import SimulationSettings
from chatscene.simulate.confined.confinement import Limits, confine
from chatscene.simulate.confined.wire import (
    Message,
    decode,
    encode,
    episode_to_json,
    program_from_json,
    route_to_json,
    scene_from_json,
)
from chatscene.simulate.native.lines import engine
from chatscene.simulate.simulator import Session, Simulator, load_simulator
from chatscene.terms.pointing import place_in
from chatscene.terms.scene import Rejected, Scene, ScenicProgram
from chatscene.world import compilation

WATCHMAN = 77  # exit status of a process that the watchman ended
CHUNK = 1 << 16
TRIED = 300  # characters that are told of what a program tried

# One of everything a program does, so that all that is loaded late is loaded before the walls stand.
WARM_UP = """
model chatscene.world.model
param OPT_SPEED = Range(1, 2)
egoRoute = selectRoute(maneuver="straight")
behavior AdvBehavior():
    try:
        do MoveAhead(globalParameters.OPT_SPEED) until headway(egoRoute, ego, self) < 5
    interrupt when (distance from self to ego) < 2:
        do Halt() for 1 seconds
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute
AdvAgent = new Pedestrian at besideRoad(egoRoute, 30, "right", 1), facing crossingDirection(egoRoute, 30, "right"),
    with behavior AdvBehavior()
require (distance from ego to AdvAgent) > 1
"""


# The model that loads all others: only compiled, since it may have no place on a map.
WARM_UP_DRAWN = "model scenic.simulators.carla.model\nego = new Car"


def main() -> None:
    """Warm up, then fork on demand until the other end closes."""
    control = socket.socket(fileno=int(sys.argv[1]))
    setup = json.loads(control.recv(CHUNK))
    with suppress(ConnectionError):
        _serve(control, setup)
    shutil.rmtree(setup["folder"], ignore_errors=True)  # whoever made it may have been killed


def _serve(control: socket.socket, setup: Message) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # a keyboard interrupt is the parent's to handle
    limits = Limits(**setup["limits"])
    map_path = Path(setup["map"])
    try:
        simulator = _warm_up(map_path, SimulationSettings(**setup["settings"]), setup["cache"])
    except ChatSceneError as error:
        control.send(json.dumps({"error": type(error).__name__, "message": str(error)}).encode())
        return
    control.send(b'{"ready":true}')
    gc.freeze()
    while True:
        request, channels, _, _ = socket.recv_fds(control, CHUNK, 1)
        if not request:
            return
        if request == b"fork":
            pid = os.fork()
            if pid == 0:
                control.close()
                _live(channels[0], simulator, limits, str(map_path))
            os.close(channels[0])
            control.send(b"%d" % pid)
        else:
            _, status = os.waitpid(int(request), 0)
            control.send(b"%d" % os.waitstatus_to_exitcode(status))


def _warm_up(map_path: Path, settings: SimulationSettings, cache: str) -> Simulator:
    os.environ["XDG_CACHE_HOME"] = cache
    try:
        return _warmed_up(map_path, settings)
    finally:
        del os.environ["XDG_CACHE_HOME"]
        compilation.keeping = False


def _warmed_up(map_path: Path, settings: SimulationSettings) -> Simulator:
    whole()  # no module can be loaded once the walls are up, nor the engine, which finds who crosses a stop line
    engine()
    load_network(map_path)
    load_roads(map_path)
    simulator = load_simulator(map_path, settings)
    program = ScenicProgram(scenario_id="warm-up", source=WARM_UP, parameters=(), snippet_ids=())
    drawn = replace(program, source=WARM_UP_DRAWN, model="scenic.simulators.carla.model")
    simulator.routes(drawn)
    triangulatePolygon(box(0, 0, 1, 1))  # as the first draw from an area does, with a module that is imported only then
    scene = Scene(id="warm-up", scenario_id="warm-up", route=0, block=0, seed=0, values={"OPT_SPEED": 1.5})
    try:
        session = simulator.open(program, scene)
    except ChatSceneError:
        return simulator  # a map without such a road; what is loaded late must then be readable
    if not isinstance(session, Rejected):
        for _ in range(3):
            session.step((0.0, 0.0))
        encode(episode_to_json(session.episode("warm-up", "warm-up")))
        session.close()
    return simulator


def _live(channel: int, simulator: Simulator, limits: Limits, map_path: str) -> NoReturn:
    """The life of a confined process."""
    try:
        os.setsid()
        os.environ.clear()
        builtins.print = _unheard
        sys.dont_write_bytecode = True  # an installation may have none, and behind the walls nothing can be written
        end = _last_words(channel)
        layers = confine(limits, (map_path, str(Path.cwd())), end)
        os.write(channel, encode({"layers": layers}))
        _Confined(channel, simulator).serve()
    except BaseException:  # noqa: BLE001 - whatever it was, this process is not to go on as the one it was forked from
        os._exit(1)
    os._exit(0)


def _unheard(*_said: Any, **_how: Any) -> None:
    """What `print` does behind the walls, where nothing can be written; that it does is told by `left_out`."""


def _last_words(channel: int) -> Callable[[str], Any]:
    """What the watchman does: says what was tried, and ends the process."""
    # Bound now: a stranger may put something else in their places.
    write, leave, string = os.write, os._exit, json.encoder.encode_basestring_ascii

    def end(tried: str) -> None:
        write(channel, b'{"stopped":%s}\n' % string(tried[:TRIED]).encode())
        leave(WATCHMAN)

    return end


class _Confined:
    """Answers requests about one program."""

    def __init__(self, channel: int, simulator: Simulator) -> None:
        self._channel = channel
        self._simulator = simulator
        self._program: ScenicProgram | None = None
        self._session: Session | None = None

    def serve(self) -> None:
        """Answer until the other end closes."""
        rest = b""
        while True:
            while b"\n" not in rest:
                more = os.read(self._channel, CHUNK)
                if not more:
                    return
                rest += more
            line, _, rest = rest.partition(b"\n")
            view = memoryview(self._answer(decode(line)))
            while view:
                view = view[os.write(self._channel, view) :]

    def _answer(self, request: Message) -> bytes:
        try:
            return encode(getattr(self, f"_do_{request.pop('do')}")(**request))
        except MemoryError:
            return encode({"error": "MemoryError", "message": "out of memory"})
        except BaseException as error:  # noqa: BLE001 - a stranger's program may raise anything
            place = place_in(error, self._program.filename) if self._program else None
            message = f"{error}".partition("\n    ")[0]  # the other side has the text, and shows the place itself
            return encode({"error": type(error).__name__, "message": message[:2000], "place": place and astuple(place)})

    def _do_load(self, program: Message) -> Message:
        self._program = program_from_json(program)
        return {}

    def _loaded(self) -> ScenicProgram:
        assert self._program is not None
        return self._program

    def _do_routes(self) -> Message:
        return {"routes": self._simulator.routes(self._loaded())}

    def _do_route(self, index: int) -> Message:
        return route_to_json(self._simulator.route(self._loaded(), index))

    def _do_route_in(self, scene: Message) -> Message:
        return route_to_json(self._simulator.route_in(self._loaded(), scene_from_json(scene)))

    def _do_open(self, scene: Message, observation: str, pedals: str, through: bool) -> Message:
        session = self._simulator.open(
            self._loaded(), scene_from_json(scene), observation=observation, pedals=pedals, through_collisions=through
        )
        if isinstance(session, Rejected):
            told = {"draws": session.draws, "spent": session.spent, "without": session.without}
            return {"rejected": session.reason, **told}
        self._session = session
        return {**_state(session), "draws": getattr(session, "draws", 1)}

    def _open_session(self) -> Session:
        assert self._session is not None
        return self._session

    def _do_step(self, action: list[float]) -> Message:
        session = self._open_session()
        session.step(action)
        return _state(session)

    def _do_episode(self) -> Message:
        return episode_to_json(self._open_session().episode("", ""))

    def _do_close(self) -> Message:
        session, self._session = self._open_session(), None
        session.close()
        return {}


def _state(session: Session) -> Message:
    return {
        "observation": session.observation.tolist(),
        "ending": session.ending,
        "rejection": session.rejection,
        "step": session.step_number,
        "along": session.along,
        "offset": session.offset,
        "speed": session.speed,
    }


if __name__ == "__main__":
    main()
