"""How far each physics is from a car of others at the speeds of traffic: braking, a step of the wheel, a lane change.

    python benchmarks/manoeuvres.py [--speed 50] [--speed 80] [--speed 120]

Beside `kinematic` and `lagged` drives CommonRoad's multi-body car of 29 states (Althoff, Koschi and Manzinger,
"CommonRoad: Composable benchmarks for motion planning on roads", IV 2017; its vehicle 2, a BMW 320i;
`commonroad-vehicle-models`, an extra of the tests). All share the wheelbase and the wheel's rate. The multi-body car
has besides tyres by the magic formula, suspension, load transfer and wheels that turn. Its tyres are as stiff as their
load, so that it hardly understeers; so `lagged` is there twice, with the understeer of our car and without any.

    braking             the pedal is pressed to its end; the multi-body car's wheels get what a first-order lag makes of
                        it. The way until as slow as the multi-body car is at its end
    step of the wheel   the wheel angle that turns a neutral car with 2, 4 and 6 m/s²; after 4 s
    double lane change  ISO 3888-1 has one at 80 km/h, by 3.5 m, in 30 m there and 25 m back, 25 m apart. Its lengths
                        grow with the speed here, so that it takes as long at each; *wide* is twice as long. The driver
                        is the one that everybody's behavior has here (`chatscene.world.control.wheel_to`) and looks at
                        the car that he drives. He is no test driver: he leaves the line by a metre, with any car

    bend                straight on for 2 s, then a bend that takes 3 m/s² (with which `idm` takes bends) for 4 s, by
                        the same driver

Nothing is drawn, so there is no seed. *Beside* is how far the multi-body car is beside a path of ours [m]: after a step
of the wheel at the end, else the most. *Off the line* is how far each is from the bend at its end.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import click
import numpy as np
from numpy.typing import NDArray

from chatscene.simulate.embedded.dynamics import VehicleBody
from chatscene.simulate.embedded.lagged import LaggedVehicle
from chatscene.terms.actors import LIMITS
from chatscene.terms.polyline import Polyline
from chatscene.world.control import wheel_to

DT = 0.1
WHEEL_RATE = 0.4  # [rad/s], of the BMW
SLOW = 2.0  # [m/s] under which the slip of the multi-body tyres divides by nearly nothing
SPEEDS = (50.0, 80.0, 120.0)  # [km/h]
ACROSS = (2.0, 4.0, 6.0)  # [m/s²]
ISO = (15.0, 30.0, 25.0, 25.0, 30.0)  # [m], of ISO 3888-1 at 80 km/h: before, there, beside, back, after
LANE = 3.5  # [m]
BEND = 3.0  # [m/s²], with which `idm` takes bends
PHYSICS = ("kinematic", "lagged", "lagged, neutral")

Wheel = Callable[[float, float, float, float, float], float]
"""The wheel angle [rad] that is asked for: of the time, x, y, heading and speed, at the beginning of a step."""


@dataclass(frozen=True)
class Drive:
    """Per step, at its end; the yaw rate is the mean over it, so the lateral acceleration is, too."""

    x: NDArray[np.float64]
    y: NDArray[np.float64]
    speed: NDArray[np.float64]
    yaw_rate: NDArray[np.float64]

    @property
    def across(self) -> NDArray[np.float64]:
        """Lateral acceleration [m/s²]."""
        return self.speed * self.yaw_rate

    def way_to(self, speed: float) -> float:
        """[m] driven straight on until as slow as that."""
        return float(np.interp(-speed, -self.speed, np.hypot(self.x, self.y)))

    def beside(self, other: Drive) -> NDArray[np.float64]:
        """How far another is beside the path of this one at each step [m], whoever of them is ahead."""
        path = Polyline(((0.0, 0.0), *zip(self.x, self.y, strict=True)))
        return np.array([path.project(x, y)[1] for x, y in zip(other.x, other.y, strict=True)])


def _bmw() -> Any:
    from vehiclemodels.parameters_vehicle2 import parameters_vehicle2  # type: ignore[import-not-found]

    return parameters_vehicle2()


def wheelbase() -> float:
    """Of the BMW [m]."""
    return float(_bmw().a + _bmw().b)


def multibody(
    speed: float, seconds: float, wheel: Wheel, acceleration: Callable[[float], float] = lambda _: 0.0
) -> Drive:
    """The multi-body car under a wheel angle and an acceleration [m/s²] asked of its wheels at a time [s].

    Args:
        speed: At first [m/s].
        seconds: How long, unless it is slow before.
        wheel: What is asked of its wheel.
        acceleration: What is asked of its drive and brakes.
    """
    from scipy.integrate import odeint  # type: ignore[import-untyped]
    from vehiclemodels.init_mb import init_mb  # type: ignore[import-not-found]
    from vehiclemodels.vehicle_dynamics_mb import vehicle_dynamics_mb  # type: ignore[import-not-found]

    parameters: Any = _bmw()
    state: Any = init_mb([0.0, 0.0, 0.0, speed, 0.0, 0.0, 0.0], parameters)
    rows: list[tuple[float, float, float, float]] = []
    for step in range(round(seconds / DT)):
        x, y, angle, now, heading = state[:5]
        rate = (wheel(step * DT, x, y, heading, now) - angle) / DT
        rate = max(-WHEEL_RATE, min(WHEEL_RATE, rate))

        def derivative(state: NDArray[np.float64], t: float, rate: float = rate) -> list[float]:
            return vehicle_dynamics_mb(state.tolist(), [rate, acceleration(t)], parameters)

        state = odeint(derivative, state, [step * DT, (step + 1) * DT], rtol=1e-6, atol=1e-8)[-1]
        rows.append((state[0], state[1], state[3], (state[4] - heading) / DT))
        if state[3] < SLOW:
            break
    return Drive(*np.array(rows).T)


def ours(physics: str, speed: float, seconds: float, wheel: Wheel, brake: float = 0.0) -> Drive:
    """Our car, with the wheelbase and the wheel of the BMW.

    Args:
        physics: One of `PHYSICS`.
        speed: At first [m/s]; held where it does not brake.
        seconds: How long.
        wheel: What is asked of its wheel.
        brake: The pedal, from 0 to 1.
    """
    of_theirs = replace(LIMITS["Car"], wheelbase=wheelbase(), wheel_rate=WHEEL_RATE, drag=0.0)
    if physics == "lagged, neutral":
        of_theirs = replace(of_theirs, characteristic_speed=math.inf)
    cls = VehicleBody if physics == "kinematic" else LaggedVehicle
    body = cls(0.0, 0.0, 0.0, of_theirs, speed)
    body.brake = brake
    body.target_speed = None if brake else speed
    rows: list[tuple[float, float, float, float]] = []
    for step in range(round(seconds / DT)):
        heading = body.heading
        body.steer = -wheel(step * DT, body.x, body.y, heading, body.speed) / of_theirs.wheel_angle
        body.step(DT)
        rows.append((body.x, body.y, body.speed, (body.heading - heading) / DT))
    return Drive(*np.array(rows).T)


def straight(_t: float, _x: float, _y: float, _heading: float, _speed: float) -> float:
    """The wheel is left alone."""
    return 0.0


def braking(speed: float) -> dict[str, Drive]:
    """Full braking from a speed [m/s], by physics; the multi-body car's is `multi-body`."""
    brake, lag = LIMITS["Car"].brake, LIMITS["Car"].brake_lag
    theirs = multibody(speed, 9.0, straight, lambda t: -brake * (1.0 - math.exp(-t / lag)))
    return {"multi-body": theirs} | {physics: ours(physics, speed, 9.0, straight, brake=1.0) for physics in PHYSICS}


def step_steer(speed: float, across: float) -> dict[str, Drive]:
    """A step of the wheel that turns a neutral car with a lateral acceleration [m/s²], likewise."""
    angle = wheelbase() * across / speed**2

    def wheel(_t: float, _x: float, _y: float, _heading: float, _speed: float) -> float:
        return angle

    theirs = multibody(speed, 4.0, wheel)
    return {"multi-body": theirs} | {physics: ours(physics, speed, 4.0, wheel) for physics in PHYSICS}


def driven(line: Polyline, speed: float, seconds: float) -> dict[str, Drive]:
    """A line that is followed at a speed [m/s], likewise; by the driver of all behaviors."""
    base = wheelbase()

    def wheel(_t: float, x: float, y: float, heading: float, now: float) -> float:
        return -wheel_to(line, line.project(x, y)[0], (x, y, heading, now), 0.0, base, 1.0)

    theirs = multibody(speed, seconds, wheel)
    return {"multi-body": theirs} | {physics: ours(physics, speed, seconds, wheel) for physics in PHYSICS}


def lane_changes(speed: float, longer: float = 1.0) -> dict[str, Drive]:
    """A double lane change at a speed [m/s], `longer` times as long as ISO's at 80 km/h takes, likewise."""
    ends = np.cumsum(ISO) * longer * speed * 3.6 / 80.0
    line = Polyline(((-10.0, 0.0), *zip(ends, (0.0, LANE, LANE, 0.0, 0.0), strict=True), (ends[-1] + 200.0, 0.0)))
    return driven(line, speed, math.ceil((ends[-1] / speed + 1.0) / DT) * DT)


def bend(speed: float, across: float = BEND) -> tuple[Polyline, dict[str, Drive]]:
    """A bend to the left that takes a lateral acceleration [m/s²], likewise; and its line."""
    radius, straight_on = speed**2 / across, 2.0 * speed
    angles = np.arange(0.0, 6.0 * speed / radius, 1.0 / radius)
    arc = zip(straight_on + radius * np.sin(angles), radius * (1.0 - np.cos(angles)), strict=True)
    line = Polyline(((-10.0, 0.0), *arc))
    return line, driven(line, speed, 6.0)


def peak(values: NDArray[np.float64]) -> float:
    """The largest magnitude."""
    return float(np.abs(values).max())


@click.command()
@click.option("--speed", "speeds", multiple=True, type=float, default=SPEEDS, show_default=True, help="[km/h]")
def main(speeds: tuple[float, ...]) -> None:
    """Print the table."""
    click.echo("| km/h | manoeuvre | | multi-body | " + " | ".join(PHYSICS) + " |")
    click.echo("|---:|---|---|---:|" + "---:|" * len(PHYSICS))

    def row(kmh: float, manoeuvre: str, what: str, values: dict[str, float], digits: int) -> None:
        cells = [f"{values[name]:.{digits}f}" if name in values else "" for name in ("multi-body", *PHYSICS)]
        click.echo(f"| {kmh:g} | {manoeuvre} | {what} | " + " | ".join(cells) + " |")

    for kmh in speeds:
        speed = kmh / 3.6
        braked = braking(speed)
        end = float(braked["multi-body"].speed[-1])
        row(kmh, "braking", "way [m]", {name: one.way_to(end) for name, one in braked.items()}, 1)
        line, bent = bend(speed)
        drives = {f"step, {across:g} m/s²": step_steer(speed, across) for across in ACROSS}
        drives |= {"double lane change, wide": lane_changes(speed, 2.0), "double lane change": lane_changes(speed)}
        for manoeuvre, each in (drives | {f"bend, {BEND:g} m/s²": bent}).items():
            theirs = each["multi-body"]
            beside = {name: np.abs(one.beside(theirs)) for name, one in each.items() if one is not theirs}
            most = {name: float(off[-1] if "step" in manoeuvre else off.max()) for name, off in beside.items()}
            row(
                kmh,
                manoeuvre,
                "peak yaw rate [°/s]",
                {n: math.degrees(peak(one.yaw_rate)) for n, one in each.items()},
                1,
            )
            row(kmh, manoeuvre, "peak lateral [m/s²]", {n: peak(one.across) for n, one in each.items()}, 1)
            row(kmh, manoeuvre, "beside [m]", most, 2)
        off = {name: -line.project(float(one.x[-1]), float(one.y[-1]))[1] for name, one in bent.items()}
        row(kmh, f"bend, {BEND:g} m/s²", "off the line [m], right", off, 2)


if __name__ == "__main__":
    main()
