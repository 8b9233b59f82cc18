"""Between our frame and CARLA's: y and the angle change their sign.

Ours is right-handed, in radians counter-clockwise from +x. CARLA's is left-handed, in degrees clockwise from +x.
"""

from __future__ import annotations

import math
from typing import Any

import carla  # pyright: ignore[reportMissingTypeStubs]


def transform(x: float, y: float, z: float, heading: float) -> Any:
    """CARLA's transform of a point [m] and a heading [rad] of ours."""
    return carla.Transform(carla.Location(x=x, y=-y, z=z), carla.Rotation(yaw=-math.degrees(heading)))


def direction(x: float, y: float) -> Any:
    """CARLA's vector of one of ours along the ground."""
    return carla.Vector3D(x=x, y=-y, z=0.0)


def turned(yaw: float, before: float) -> float:
    """Our heading [rad] of a yaw [degrees], less than half a turn from the one `before`."""
    return before + math.remainder(-math.radians(yaw) - before, math.tau)
