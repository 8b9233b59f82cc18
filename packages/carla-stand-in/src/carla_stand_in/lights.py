"""Traffic lights: the lights of a junction take turns by axis, until somebody sets or freezes them.

The order is that of `chatscene.world.signals`; the times are CARLA's defaults and can be set for each light.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from carla_stand_in.roads import Signal, apart

RED, YELLOW, GREEN, OFF = 0, 1, 2, 3
_GREEN_TIME, _YELLOW_TIME, _RED_TIME = 10.0, 3.0, 2.0  # [s]
_AXIS = 45.0  # [degrees]; lights whose directions differ by less, either way round, share an axis
_ZONE = 12.0  # [m] before the line within which a vehicle waits at its light
_BEYOND = 1.5  # [m] behind the line that still count
_BESIDE = 2.0  # [m] to either side
_AGAINST = 60.0  # [degrees]


@dataclass(slots=True)
class Light:
    """One traffic light.

    Attributes:
        signal: Where it stands.
        state: Red, yellow, green or off.
        times: Green, yellow and red time [s]; the red time is how long the whole junction has red after yellow.
        elapsed: Since the state began [s].
    """

    signal: Signal
    state: int = RED
    times: list[float] = field(default_factory=lambda: [_GREEN_TIME, _YELLOW_TIME, _RED_TIME])
    elapsed: float = 0.0

    def set(self, state: int) -> None:
        """Show a state from now on."""
        self.state = state
        self.elapsed = 0.0

    def holds(self, x: float, y: float, yaw: float) -> bool:
        """Whether a vehicle whose front is at `x`, `y` [m], turned by `yaw` [degrees], waits at this light."""
        for at_x, at_y, along in self.signal.stops:
            dx, dy = at_x - x, at_y - y
            if abs(dx) > _ZONE or abs(dy) > _ZONE or apart(yaw, along) > _AGAINST:
                continue
            c, s = math.cos(math.radians(along)), math.sin(math.radians(along))
            if -_BEYOND <= dx * c + dy * s <= _ZONE and abs(dy * c - dx * s) <= _BESIDE:
                return True
        return False


class Junction:
    """The lights of one junction; its axes have green one after the other.

    Args:
        lights: All of them, at least one.
    """

    def __init__(self, lights: Sequence[Light]) -> None:
        self.lights = tuple(lights)
        self._axes = _axes(self.lights)
        self.reset()

    def reset(self) -> None:
        """Begin anew: the first axis has green."""
        self._turn = 0
        self._show(GREEN)

    def step(self, dt: float) -> None:
        """Advance by `dt` [s]."""
        for light in self.lights:
            light.elapsed += dt
        self._since += dt
        first = self._axes[self._turn][0]
        if self._since < first.times[{GREEN: 0, YELLOW: 1, RED: 2}[self._phase]] - 1e-9:
            return
        if self._phase == RED:
            self._turn = (self._turn + 1) % len(self._axes)
        self._show({GREEN: YELLOW, YELLOW: RED, RED: GREEN}[self._phase])

    def _show(self, phase: int) -> None:
        self._phase = phase
        self._since = 0.0
        for number, axis in enumerate(self._axes):
            state = phase if number == self._turn else RED
            for light in axis:
                if light.state != state:
                    light.set(state)


class Lights:
    """All traffic lights of a map.

    Args:
        lights: By the id of their actor.

    Attributes:
        frozen: Whether all keep what they show; CARLA freezes none alone.
    """

    def __init__(self, lights: dict[int, Light]) -> None:
        self.by_actor = lights
        self.frozen = False
        self._junctions = [Junction(group) for group in _by_junction(lights.values())]

    def step(self, dt: float) -> None:
        """Advance by `dt` [s]."""
        if not self.frozen:
            for junction in self._junctions:
                junction.step(dt)

    def reset(self, actor: int | None = None) -> None:
        """Begin anew, everywhere or at the junction of one light."""
        for junction in self._junctions if actor is None else [self._junction(actor)]:
            junction.reset()

    def group(self, actor: int) -> list[int]:
        """The ids of the lights at the same junction."""
        there = self._junction(actor).lights
        return [other for other, light in self.by_actor.items() if any(light is one for one in there)]

    def _junction(self, actor: int) -> Junction:
        mine = self.by_actor[actor]
        return next(junction for junction in self._junctions if any(light is mine for light in junction.lights))

    def waits_at(self, x: float, y: float, yaw: float) -> int | None:
        """The light that a vehicle whose front is at `x`, `y` [m] waits at."""
        return next((actor for actor, light in self.by_actor.items() if light.holds(x, y, yaw)), None)


def _by_junction(lights: Iterable[Light]) -> list[list[Light]]:
    groups: dict[object, list[Light]] = {}
    for light in lights:
        junction = light.signal.junction
        groups.setdefault(light.signal.id if junction < 0 else junction, []).append(light)
    return list(groups.values())


def _axes(lights: Sequence[Light]) -> list[list[Light]]:
    """Lights that have green together: those that face the same way or opposite ways."""
    axes: list[tuple[float, list[Light]]] = []
    for light in lights:
        yaw = light.signal.stops[0][2] if light.signal.stops else light.signal.rotation[1]
        for direction, axis in axes:
            if min(apart(yaw, direction), apart(yaw + 180.0, direction)) < _AXIS:
                axis.append(light)
                break
        else:
            axes.append((yaw, [light]))
    return [axis for _, axis in axes]
