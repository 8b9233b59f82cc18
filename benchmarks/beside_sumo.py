"""How many steps of vehicles SUMO makes a second of processor time, to stand beside `native_speed.py`.

    python -m venv /tmp/sumo && /tmp/sumo/bin/pip install libsumo eclipse-sumo
    /tmp/sumo/bin/python benchmarks/beside_sumo.py [--rounds 3]

Neither is an extra of ours for this: this file needs them alone, and nothing of chatscene.

SUMO in this process, without its socket (`libsumo`), at 10 Hz. *Straight*: a road of four lanes, everybody by IDM and
SUMO's own lane changes. *Grid*: a town of 5 by 5 junctions, in which all go round the same streets. *Asked* also asks
for the pose and speed of each vehicle at each step, as of a scene that is judged. A step of one vehicle counts one.
"""

from __future__ import annotations

import argparse
import statistics
import subprocess
import tempfile
import time
from importlib.metadata import version
from pathlib import Path

import libsumo  # pyright: ignore[reportMissingImports]
import sumo  # pyright: ignore[reportMissingImports]

TOOLS = Path(sumo.SUMO_HOME) / "bin"
STEPS = 600
LANES, LONG = 4, 20_000.0  # [m]
TYPE = '<vType id="car" carFollowModel="IDM" speedFactor="1"/>'
POSE = (0x42, 0x43, 0x40)  # position, angle, speed: libsumo's numbers for what is subscribed to


def straight(folder: Path, vehicles: int) -> tuple[Path, Path]:
    """A long road of four lanes with vehicles 20 m apart."""
    net, routes = folder / "straight.net.xml", folder / f"straight-{vehicles}.rou.xml"
    (folder / "a.nod.xml").write_text(f'<nodes><node id="a" x="0" y="0"/><node id="b" x="{LONG}" y="0"/></nodes>')
    edge = f'<edge id="e" from="a" to="b" numLanes="{LANES}" speed="13.9"/>'
    (folder / "a.edg.xml").write_text(f"<edges>{edge}</edges>")
    _call("netconvert", "-n", folder / "a.nod.xml", "-e", folder / "a.edg.xml", "-o", net)
    each = "".join(
        f'<vehicle id="v{i}" type="car" route="r" depart="0" departSpeed="10" departLane="{i % LANES}"'
        f' departPos="{10 + 20 * (i // LANES)}"/>'
        for i in range(vehicles)
    )
    routes.write_text(f'<routes>{TYPE}<route id="r" edges="e"/>{each}</routes>')
    return net, routes


def grid(folder: Path, vehicles: int) -> tuple[Path, Path]:
    """A town of streets at right angles in which vehicles go round and round."""
    net, routes = folder / "grid.net.xml", folder / f"grid-{vehicles}.rou.xml"
    _call("netgenerate", "--grid", "--grid.number=5", "--grid.length=150", "-L", "2", "-o", net)
    ring = ["A0B0", "B0C0", "C0C1", "C1B1", "B1A1", "A1A0"]
    each = "".join(
        f'<vehicle id="v{i}" type="car" depart="{i * 2}"><route edges="{" ".join(ring * 60)}"/></vehicle>'
        for i in range(vehicles)
    )
    routes.write_text(f"<routes>{TYPE}{each}</routes>")
    return net, routes


def _call(tool: str, *told: object) -> None:
    subprocess.run([TOOLS / tool, *map(str, told)], check=True, capture_output=True)


def rate(net: Path, routes: Path, vehicles: int, *, asked: bool) -> float:
    """Steps of a vehicle a second of processor time, once all have set off."""
    libsumo.start(["sumo", "-n", str(net), "-r", str(routes), "--step-length", "0.1", "--no-step-log", "--no-warnings"])
    try:
        while libsumo.vehicle.getIDCount() < vehicles and libsumo.simulation.getTime() < 4 * vehicles:
            libsumo.simulationStep()
        if asked:
            for vehicle in libsumo.vehicle.getIDList():
                libsumo.vehicle.subscribe(vehicle, POSE)
        made = 0
        began = time.process_time()
        for _ in range(STEPS):
            libsumo.simulationStep()
            made += libsumo.vehicle.getIDCount()
            if asked:
                libsumo.vehicle.getAllSubscriptionResults()
        return made / (time.process_time() - began)
    finally:
        libsumo.close()


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--rounds", type=int, default=3)
    rounds = parser.parse_args().rounds
    print(f"SUMO {version('libsumo')}")
    with tempfile.TemporaryDirectory() as made:
        for make in (straight, grid):
            for vehicles in (3, 20, 50):
                net, routes = make(Path(made), vehicles)
                for asked in (False, True):
                    rates = [rate(net, routes, vehicles, asked=asked) for _ in range(rounds)]
                    each = ", ".join(f"{one:,.0f}" for one in rates)
                    what = f"{make.__name__}, {vehicles} vehicles{', asked' if asked else ''}"
                    print(f"{what}: {statistics.median(rates):,.0f} agent-steps/s ({each})")


if __name__ == "__main__":
    main()
