"""ScenarioRunner, unmodified, against the stand-in for CARLA: one line for each scenario, with its result.

    python benchmarks/carla_scenario_runner.py SCENARIO_RUNNER AGENTS MAPS PYTHON [NAME ...]

SCENARIO_RUNNER is its source at tag v0.9.16, AGENTS a folder that has CARLA's package `agents`, MAPS one with CARLA's
towns (`Town01.xodr` and others), PYTHON the interpreter of an environment with its requirements and the wheel
carla 0.9.16. None of these is ours, and none is in this repository. This program needs the extra 'carla'.
The heroes of OpenSCENARIO files and of example scenarios are under external control: `benchmarks/carla_hero.py` drives
them, at the speed in the table below. Routes are driven by ScenarioRunner's own `npc_agent`, or by
`benchmarks/carla_privileged_agent.py`. With names, only those are run.

A scenario has come to a result where ScenarioRunner writes its table of criteria; whether the table says SUCCESS or
FAILURE is the hero's conduct, not the server's. A run is killed after 150 s.
"""

from __future__ import annotations

import os
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import carla  # pyright: ignore[reportMissingImports]

HERE = Path(__file__).parent
LONGEST = 150.0  # [s] of the clock
OPEN_SCENARIOS = {
    "CyclistCrossing": 30,
    "FollowLeadingVehicle": 30,
    "InitAddEntityAction": 30,
    "InitDeleteEntityAction": 30,
    "LaneChangeSimple": 60,
    "PedestrianCrossingFront": 30,
    "Slalom": 30,
    "StoryAddEntityAction": 30,
    "StoryDeleteEntityAction": 30,
    "VehicleLateralDistance": 30,
}
"""Files in srunner/examples, and how fast their hero is driven [km/h]."""
NO_RESULT = {
    "CatalogExample": "its catalogue has a date that its schema refuses",
    "ChangingWeather": "it waits for 10,000,000 s of simulated time",
    "IntersectionCollisionAvoidance": "ScenarioRunner takes the length of times that it passes none of",
    "LaneOffsetActionExample": "its hero has to go 20 km",
    "OscControllerExample": "its hero has to go 20 km",
    "SyncArrivalIntersection": "ScenarioRunner takes the length of times that it passes none of",
}
"""Files there that come to no result by what is in them, with any server, and why."""
EXAMPLES = {
    "FollowLeadingVehicle_1": 30,
    "ControlLoss_1": 30,
    "VehicleTurningRight_1": 30,
    "DynamicObjectCrossing_1": 30,
    "CutInFrom_left_Lane": 60,
    "OtherLeadingVehicle_1": 60,
    "ChangeLane_1": 60,
}
"""Scenarios named in the XML files there."""


@dataclass(frozen=True, slots=True)
class Way:
    """A route in the leaderboard's format.

    Attributes:
        points: x, y [m] that it goes through, in Town01.
        scenarios: Type, trigger x, y [m] and yaw [degrees], and further elements.
        agent: Who drives.
    """

    points: tuple[tuple[float, float], ...]
    scenarios: tuple[tuple[str, float, float, float, str], ...]
    agent: str


SOUTH = ((392.4, 20.0), (392.4, 305.0))
LOOP = ((110.0, 133.4), (300.0, 133.4), (334.8, 165.0), (300.0, 195.2), (130.0, 195.1))
ROUTES = {
    "route_empty": Way(SOUTH, (), "npc"),
    "route_control_loss": Way(SOUTH, (("ControlLoss", 392.4, 80.0, 90.0, ""),), "npc"),
    "route_object_crossing": Way(
        SOUTH,
        (
            (
                "DynamicObjectCrossing",
                392.4,
                80.0,
                90.0,
                '<distance value="40"/><blocker_model value="static.prop.vendingmachine"/><crossing_angle value="0"/>',
            ),
        ),
        "npc",
    ),
    "route_hard_break": Way(SOUTH, (("HardBreakRoute", 392.4, 80.0, 90.0, ""),), "npc"),
    "route_turns": Way(LOOP, (), "npc"),
    "route_privileged": Way(
        LOOP,
        (("ControlLoss", 150.0, 133.4, 0.0, ""),),
        "privileged",
    ),
}


def written(way: Way, file: Path) -> None:
    """The route as a file."""
    points = "".join(f'<position x="{x}" y="{y}" z="0.0"/>' for x, y in way.points)
    scenarios = "".join(
        f'<scenario name="{kind}_1" type="{kind}"><trigger_point x="{x}" y="{y}" z="0.0" yaw="{yaw}"/>{more}</scenario>'
        for kind, x, y, yaw, more in way.scenarios
    )
    file.write_text(
        '<routes><route id="0" town="Town01"><weathers><weather route_percentage="0" cloudiness="10"/></weathers>'
        f"<waypoints>{points}</waypoints><scenarios>{scenarios}</scenarios></route></routes>"
    )


def free_port(ports: int) -> int:
    """The first of so many free ports in a row."""
    while True:
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            first: int = probe.getsockname()[1]
        try:
            for port in range(first, first + ports):
                with socket.socket() as probe:
                    probe.bind(("127.0.0.1", port))
        except (OSError, OverflowError):
            continue
        return first


class Runner:
    """Where everything is, and how it is started.

    Args:
        source: ScenarioRunner's.
        agents: The folder that has `agents`.
        python: Of the environment for both.
        folder: To work in.
        port: Of the server.
    """

    def __init__(self, source: Path, agents: Path, python: Path, folder: Path, port: int) -> None:
        self._source, self._python, self._folder, self._port = source, python, folder, port
        root = str(source)
        self._environment = {
            **os.environ,
            "PYTHONPATH": f"{root}:{agents}",
            "SCENARIO_RUNNER_ROOT": root,
        }

    def run(self, name: str) -> tuple[str, float]:
        """Run one scenario; gives what became of it, and how long it took [s]."""
        hero = None
        if name in OPEN_SCENARIOS:
            what = ["--openscenario", str(self._source / "srunner" / "examples" / f"{name}.xosc")]
            hero = OPEN_SCENARIOS[name]
        elif name in EXAMPLES:
            what = ["--scenario", name]
            hero = EXAMPLES[name]
        else:
            file = self._folder / f"{name}.xml"
            written(ROUTES[name], file)
            agent = (
                self._source / "srunner" / "autoagents" / "npc_agent.py"
                if ROUTES[name].agent == "npc"
                else HERE / "carla_privileged_agent.py"
            )
            what = ["--route", str(file), "--route-id", "0", "--agent", str(agent)]
        command = [str(self._python), str(self._source / "scenario_runner.py"), *what, "--sync", "--reloadWorld"]
        command += ["--output", "--port", str(self._port), "--trafficManagerPort", str(free_port(1)), "--timeout", "60"]
        log = self._folder / f"{name}.log"
        clear(self._port)
        start = time.perf_counter()
        with log.open("w") as to:
            runner = self._started(command, to)
            driver = None
            try:
                if hero is not None:
                    drive = [str(self._python), str(HERE / "carla_hero.py"), str(self._port), str(hero)]
                    driver = self._started(drive, to)
                try:
                    runner.wait(LONGEST)
                except subprocess.TimeoutExpired:
                    to.write("killed\n")
            finally:
                for process in filter(None, (runner, driver)):
                    process.kill()
                    process.wait()
        return told(log.read_text(errors="replace")), time.perf_counter() - start

    def _started(self, command: list[str], to: object) -> subprocess.Popen[bytes]:
        return subprocess.Popen(command, cwd=self._folder, env=self._environment, stdout=to, stderr=to)  # type: ignore[arg-type]


def clear(port: int) -> None:
    """A fresh world, so that nobody drives the hero that a killed run left behind."""
    client = carla.Client("127.0.0.1", port)
    client.set_timeout(60.0)
    client.reload_world()


def told(log: str) -> str:
    """What ScenarioRunner's output says of a run."""
    result = re.search(r"GLOBAL RESULT\s*│\s*(\w+)", log)
    if result is None:
        last = [line for line in log.splitlines() if re.match(r"\w*(Error|Exception)\b", line)]
        return f"no result: {last[-1][:80] if last else 'it did not end' if 'killed' in log else 'see its log'}"
    rows = re.findall(r"│ (\w+)(?: \(\w+\.\))? +│ (SUCCESS|FAILURE)", log)
    failed = [name for name, verdict in rows if verdict == "FAILURE"]
    why = f" ({', '.join(failed)})" if failed else ""
    return f"{result[1]}{why}"


def main() -> None:
    if len(sys.argv) < 5:
        raise SystemExit(__doc__)
    source, agents, maps, python = (Path(arg).absolute() for arg in sys.argv[1:5])
    absent = [
        str(path) for path in (source / "scenario_runner.py", agents / "agents", maps, python) if not path.exists()
    ]
    if absent:
        print(f"skipped: {', '.join(absent)} is not there; the head of this file says what is needed")
        return
    names = sys.argv[5:] or [*OPEN_SCENARIOS, *EXAMPLES, *ROUTES]
    folder = Path(tempfile.mkdtemp(prefix="scenario-runner-"))
    port = free_port(2)
    options = [part for town in sorted(maps.glob("*.xodr")) for part in ("--map", str(town))]
    command = [sys.executable, "-m", "chatscene", "serve-carla", "--port", str(port), *options]
    with (
        (folder / "server.log").open("w") as log,
        subprocess.Popen(command, stdout=subprocess.PIPE, stderr=log, text=True) as server,
    ):
        try:
            assert server.stdout is not None
            print(server.stdout.readline().strip(), flush=True)
            runner = Runner(source, agents, python, folder, port)
            ended = 0
            for name in names:
                verdict, seconds = runner.run(name)
                ended += not verdict.startswith("no result")
                print(f"{name:32} {verdict:60} {seconds:5.0f} s", flush=True)
            for name, why in NO_RESULT.items():
                print(f"{name:32} not run: {why}")
            print(f"{ended} of {len(names)} came to a result; logs are in {folder}")
            if ended == len(names):
                shutil.rmtree(folder)
        finally:
            server.terminate()


if __name__ == "__main__":
    main()
