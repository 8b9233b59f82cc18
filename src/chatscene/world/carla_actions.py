"""The actions of Scenic's model for CARLA: what each does to our bodies, or why nothing does it.

Actions that only a picture would show are taken and do nothing. Actions that move an actor without driving it are
refused when they are made: nothing jumps here.
"""

from __future__ import annotations

from typing import Any

from scenic.core.simulators import Action
from scenic.domains.driving.actions import SetPositionAction, Steers, Walks

from chatscene.world.lights import setClosestTrafficLightStatus, state_of
from chatscene.world.pilots import Autopilot, Stroll

SetLocationAction = SetPositionAction

_NOT_HERE = "what moves an actor without driving it is not simulated; set its pedals, its wheel, its speed or its way"


class VehicleAction(Action):
    """What only vehicles do."""

    def canBeTakenBy(self, agent: Any) -> Any:  # noqa: N802 - Scenic's name
        """Whether it is one."""
        return isinstance(agent, Steers)


class PedestrianAction(Action):
    """What only people on foot do."""

    def canBeTakenBy(self, agent: Any) -> Any:  # noqa: N802 - Scenic's name
        """Whether it is one."""
        return isinstance(agent, Walks)


class SetAutopilotAction(VehicleAction):
    """Have a vehicle drive by itself, or not any more: `chatscene.world.pilots.Autopilot`.

    Args:
        enabled: Whether it does.
        speed: How fast at most [m/s].
        vehicle_percentage_speed_difference: By how many hundredths less than the usual speed.
        ignore_lights_percentage: 100 to pass red lights; less is taken for 0.
        ignore_walkers_percentage: 100 to heed nobody on foot; less is taken for 0.
        other: Of CARLA's traffic manager, which has no meaning here: ``ignore_signs_percentage`` (signs are not heeded
            anyhow), ``auto_lane_change`` (lanes are kept).

    Raises:
        ValueError: It is given a path, or both of the speeds.
    """

    def __init__(
        self,
        enabled: bool,
        *,
        speed: float | None = None,
        vehicle_percentage_speed_difference: float | None = None,
        ignore_lights_percentage: float = 0,
        ignore_walkers_percentage: float = 0,
        path: Any = None,
        **other: Any,
    ) -> None:
        if path is not None:
            raise ValueError("an autopilot follows lanes and takes no path; use FollowTrajectoryBehavior")
        if speed is not None and vehicle_percentage_speed_difference is not None:
            raise ValueError("an autopilot takes a speed or a difference of speeds, not both")
        if unknown := set(other) - {"ignore_signs_percentage", "auto_lane_change"}:
            raise ValueError(f"an autopilot has no option {', '.join(sorted(unknown))}")
        self.enabled = enabled
        self.speed = speed
        self.slower = vehicle_percentage_speed_difference or 0.0
        self.heeds_lights = ignore_lights_percentage < 100
        self.heeds_walkers = ignore_walkers_percentage < 100

    def applyTo(self, agent: Any, simulation: Any) -> None:  # noqa: N802 - Scenic's name
        """Give the vehicle a pilot, or take it away."""
        pilot = Autopilot(
            agent,
            simulation,
            speed=self.speed,
            slower=self.slower,
            heeds_lights=self.heeds_lights,
            heeds_walkers=self.heeds_walkers,
        )
        simulation.set_pilot(agent, pilot if self.enabled else None)


class SetWalkAction(PedestrianAction):
    """Have somebody walk by themselves, or stand: `chatscene.world.pilots.Stroll`.

    Args:
        enabled: Whether they do.
        maxSpeed: [m/s].
    """

    def __init__(self, enabled: bool, maxSpeed: float = 1.4) -> None:  # noqa: N803 - Scenic's name
        self.enabled = enabled
        self.speed = maxSpeed

    def applyTo(self, agent: Any, simulation: Any) -> None:  # noqa: N802
        """Give them a way, or take it away."""
        simulation.set_pilot(agent, Stroll(agent, simulation, self.speed) if self.enabled else None)
        if not self.enabled:
            agent.setWalkingSpeed(0.0)


class SetTrafficLightAction(VehicleAction):
    """Set the light that a vehicle comes to.

    Args:
        color: ``red``, ``yellow`` or ``green``.
        distance: Within which it is looked for [m].
        group: Has no effect, as in Scenic's own.
    """

    def __init__(self, color: str, distance: float = 100, group: bool = False) -> None:  # noqa: ARG002
        state_of(color)
        self.color = color
        self.distance = distance

    def applyTo(self, agent: Any, simulation: Any) -> None:  # noqa: N802, ARG002
        """Set it, if there is one."""
        setClosestTrafficLightStatus(agent, self.color, self.distance)


class _Unseen(VehicleAction):
    """Takes whatever it is given and does nothing."""

    def __init__(self, *_: Any, **__: Any) -> None:
        pass

    def applyTo(self, agent: Any, simulation: Any) -> None:  # noqa: N802
        """Do nothing."""


class SetVehicleLightStateAction(_Unseen):
    """Lamps are not drawn."""


class SetManualGearShiftAction(_Unseen):
    """There are no gears but the reverse one."""


class SetGearAction(_Unseen):
    """There are no gears but the reverse one."""


class SetManualFirstGearShiftAction(_Unseen):
    """There are no gears but the reverse one."""


class SetJumpAction(PedestrianAction):
    """People on foot stay on the ground.

    Raises:
        ValueError: It is asked for.
    """

    def __init__(self, jump: bool) -> None:
        if jump:
            raise ValueError("nobody jumps here: the world is flat; leave out SetJumpAction")

    def applyTo(self, agent: Any, simulation: Any) -> None:  # noqa: N802
        """Do nothing."""


class _Refused(Action):
    """What no body here does.

    Raises:
        ValueError: Always.
    """

    def __init__(self, *_: Any, **__: Any) -> None:
        raise ValueError(f"{type(self).__name__}: {_NOT_HERE}")

    def applyTo(self, agent: Any, simulation: Any) -> None:  # noqa: N802
        """Never reached."""


class SetTransformAction(_Refused):
    """A jump."""


class SetAngularVelocityAction(_Refused):
    """A turn without a wheel."""


class TrackWaypointsAction(_Refused):
    """A controller of CARLA's own; `FollowTrajectoryBehavior` follows lanes."""
