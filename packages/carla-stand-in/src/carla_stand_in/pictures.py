"""Cameras: a drawing of the world from above, not a picture of it.

Whatever way a camera looks, it draws lanes and boxes as seen from straight above its place, with its own direction of
view upwards. Its opening angle says how much of the world is in it, as if it hung at `HEIGHT`.
"""

from __future__ import annotations

import math
import struct
from typing import Any

from PIL import Image, ImageDraw

from carla_stand_in.actors import Actor, BodyActor
from carla_stand_in.world import TAGS, World

HEIGHT = 25.0  # [m]
_LARGEST = 4096  # pixels to a side
_HEADER = struct.Struct("<IIf")
_LANE_EVERY = 2.0  # [m]
_GRASS, _ASPHALT = (52, 70, 48), (96, 96, 96)
_VEHICLE, _WALKER, _THING = (17, 37, 103), (214, 120, 40), (150, 130, 90)
_NO_TAG, _ROAD_TAG = 0, 1

Colour = tuple[int, int, int]


def size_of(camera: Actor) -> tuple[int, int, float]:
    """Width and height [pixels] and opening angle [degrees] of a camera.

    Raises:
        ValueError: They are no numbers that a picture can have.
    """
    wide, high = (int(camera.attribute(f"image_size_{axis}", size)) for axis, size in (("x", "800"), ("y", "600")))
    angle = float(camera.attribute("fov", "90"))
    if not (1 <= wide <= _LARGEST and 1 <= high <= _LARGEST and 1.0 <= angle < 180.0):
        raise ValueError(f"a picture of {wide} by {high} pixels, {angle:g} degrees wide")
    return wide, high, angle


def drawn(world: World, camera: Actor, tags: bool) -> bytes:
    """What a camera sends: size, opening angle, and four bytes for each pixel, blue first.

    Args:
        world: What is drawn.
        camera: From where.
        tags: Whether pixels bear CARLA's labels in red, in place of colours.
    """
    wide, high, angle = size_of(camera)
    scale = wide / (2 * HEIGHT * math.tan(math.radians(angle) / 2))  # [pixels/m]
    picture = Image.new("RGB", (wide, high), (_NO_TAG, 0, 0) if tags else _GRASS)
    draw = ImageDraw.Draw(picture)
    x, y, _ = camera.location
    yaw = math.radians(camera.rotation[1])
    c, s = math.cos(yaw), math.sin(yaw)

    def pixel(px: float, py: float) -> tuple[float, float]:
        dx, dy = px - x, py - y
        return wide / 2 + scale * (c * dy - s * dx), high / 2 - scale * (c * dx + s * dy)

    reach = math.hypot(wide, high) / 2 / scale
    for px, py, radius in world.roads.discs(_LANE_EVERY):
        if abs(px - x) < reach + radius and abs(py - y) < reach + radius:
            u, v = pixel(px, py)
            r = scale * radius
            draw.ellipse((u - r, v - r, u + r, v + r), fill=(_ROAD_TAG, 0, 0) if tags else _ASPHALT)
    for body in world.bodies():
        if math.dist(body.location[:2], (x, y)) < reach + body.body.radius:
            draw.polygon([pixel(*corner) for corner in _corners(body)], fill=_colour(body, tags))
    return _HEADER.pack(wide, high, angle) + picture.convert("RGBA").tobytes("raw", "BGRA")


def _corners(body: BodyActor) -> list[tuple[float, float]]:
    (x, y, _), (length, width, _) = body.location, body.blueprint.extent
    yaw = math.radians(body.rotation[1])
    c, s = math.cos(yaw), math.sin(yaw)
    return [
        (x + c * a * length - s * b * width, y + s * a * length + c * b * width)
        for a, b in ((1, 1), (1, -1), (-1, -1), (-1, 1))
    ]


def _colour(body: BodyActor, tags: bool) -> Colour:
    group = body.blueprint.group
    if tags:
        return TAGS[group], 0, 0
    if group != "vehicle":
        return _WALKER if group == "walker" else _THING
    parts: list[Any] = body.attribute("color").split(",")
    try:
        red, green, blue = (min(255, max(0, int(part))) for part in parts)
    except ValueError:
        return _VEHICLE
    return red, green, blue
