"""A moment of an episode as a picture: the map and who is on it from above, drawn with Pillow."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from PIL import Image, ImageChops, ImageDraw

from chatscene.terms.actors import Manner, manner_of
from chatscene.terms.arrays import Array
from chatscene.terms.episode import Episode, Role, Track, contact_point

WIDTH, HEIGHT = 640, 360  # [px]
OVERSAMPLE = 2  # drawn larger and scaled down, for smooth edges
TILE = 40  # [px], by which frames are compared with the ground; divides both sides
SIDE, WIDEST = 6.0, 120.0  # [m] smallest margin around the actors, largest width of what is shown
SLIT = 1.0  # [m²]; a hole in the road that is smaller is none
NEAR = 80.0  # [m] width of what is shown around one actor

GROUND, PAINT, CENTRE = "#e9ebe4", "#ffffff", "#f2d27a"
AREAS = {
    "sidewalks": "#d9d7cf",
    "shoulders": "#cfd1cf",
    "driveways": "#c4c8cc",
    "cycle_lanes": "#d9b5a8",
    "roads": "#c4c8cc",
    "junctions": "#c4c8cc",
}
INK, STAR, STAR_EDGE = "#1c2024", "#ffd23f", "#c23a12"
ROLES = {
    Role.EGO: "#2a66e0",
    Role.ADVERSARY: "#c23c12",
    Role.BACKGROUND: "#646e77",
    Role.OCCLUDER: "#7e6843",
}
SIGNALS = {"r": "#d3282f", "y": "#e0a100", "g": "#1b9e50"}

Points = Sequence[Sequence[float]]


@dataclass(frozen=True, slots=True)
class Camera:
    """A fixed view from above: its turn [rad], then its centre [m], and its scale [px/m] in the large picture."""

    x: float
    y: float
    scale: float
    turn: float = 0.0

    @classmethod
    def on(cls, episode: Episode, shown: Sequence[int], largest: float) -> Camera:
        """Hold the ego and its adversaries over the steps shown; if they go too far, the ego alone, or its end.

        The ego sets out to the right, along the longer side of the picture.
        """
        ego, turn = episode.ego_track, -float(episode.ego_track.heading[shown[0]])
        actors = (ego, *episode.adversaries)
        x, y = _turned(
            np.concatenate([track.x[shown] for track in actors]),
            np.concatenate([track.y[shown] for track in actors]),
            turn,
        )
        width = max(np.ptp(x), np.ptp(y) * WIDTH / HEIGHT) + 2 * SIDE
        middle_x, middle_y = float(x.min() + x.max()) / 2, float(y.min() + y.max()) / 2
        if width > largest:
            reach = largest / 2 - 2 * SIDE
            middle_x = _holding(x[: len(shown)], reach, middle_x)
            middle_y = _holding(y[: len(shown)], reach * HEIGHT / WIDTH, middle_y)
        return cls(middle_x, middle_y, WIDTH * OVERSAMPLE / float(min(max(width, 40.0), largest)), turn)

    @classmethod
    def around(cls, x: float, y: float) -> Camera:
        """Hold one place [m]."""
        return cls(x, y, WIDTH * OVERSAMPLE / NEAR)

    def points(self, line: Points) -> list[tuple[float, float]]:
        """Points of the map [m] as pixels of the large picture."""
        left, top = WIDTH * OVERSAMPLE / 2, HEIGHT * OVERSAMPLE / 2
        cos, sin = math.cos(self.turn), math.sin(self.turn)
        seen = [(p[0] * cos - p[1] * sin - self.x, p[0] * sin + p[1] * cos - self.y) for p in line]
        return [(left + u * self.scale, top - v * self.scale) for u, v in seen]

    def pixels(self, metres: float) -> int:
        """A width [m] in pixels of the large picture, at least one of the small one."""
        return max(round(metres * self.scale), OVERSAMPLE)


def _holding(way: Array, reach: float, middle: float) -> float:
    """Of middles from which one sees so far [m], the nearest to another from which a way is seen, or its end is."""
    low, high = float(way.max()) - reach, float(way.min()) + reach
    if low > high:
        low, high = float(way[-1]) - reach, float(way[-1]) + reach
    return min(max(middle, low), high)


def _turned(x: Array, y: Array, turn: float) -> tuple[Array, Array]:
    """Points of the map [m], turned about its origin."""
    return x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn)


def draw_ground(camera: Camera, drawing: Mapping[str, Any]) -> Image.Image:
    """The map as a large picture."""
    picture = Image.new("RGB", (WIDTH * OVERSAMPLE, HEIGHT * OVERSAMPLE), GROUND)
    brush = ImageDraw.Draw(picture)
    for kind, colour in AREAS.items():
        for rings in drawing.get(kind, ()):
            # One path through all rings and back each time: Pillow fills by the even-odd rule, so holes stay open.
            # Slits between pieces of a lane are left out, since Pillow draws the way to them.
            wide = [rings[0], *(hole for hole in rings[1:] if _area(hole) > SLIT)]
            brush.polygon(camera.points([p for ring in wide for p in (*ring, wide[0][0])]), fill=colour)
    for line in drawing.get("lane_boundaries", ()):
        colour = CENTRE if line["kind"] == "centre" else PAINT
        pieces = _dashes(line["points"]) if line["kind"] == "dashed" else [line["points"]]
        for piece in pieces:
            brush.line(camera.points(piece), fill=colour, width=camera.pixels(0.15))
    for rings in (*drawing.get("crosswalks", ()), *drawing.get("rails", ())):
        brush.polygon(camera.points(rings[0]), fill=PAINT)
    for line in drawing.get("stop_lines", ()):
        brush.line(camera.points(line["points"]), fill=PAINT, width=camera.pixels(0.4))
    return picture


def _area(ring: Points) -> float:
    """The area [m²] inside a closed ring."""
    return abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in pairwise(ring))) / 2


def _dashes(line: Points, dash: float = 3.0, gap: float = 4.5) -> list[list[tuple[float, float]]]:
    """A dashed line [m] as its dashes, corners inside a dash cut."""
    x, y = np.array([p[0] for p in line], float), np.array([p[1] for p in line], float)
    along = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(x), np.diff(y)))])
    starts = np.arange(0.0, along[-1], dash + gap)
    ends = np.minimum(starts + dash, along[-1])
    return [
        [(float(np.interp(s, along, x)), float(np.interp(s, along, y))) for s in pair]
        for pair in zip(starts, ends, strict=True)
    ]


def draw_frame(
    camera: Camera, ground: Image.Image, episode: Episode, step: int, small: Image.Image | None = None
) -> Image.Image:
    """One step of an episode, `WIDTH` by `HEIGHT` [px].

    Args:
        camera: Where it is seen from.
        ground: The map, seen from there.
        episode: Who is on it.
        step: Which moment.
        small: The map alone as `reduced` has it, for one of many frames: what is as there is not scaled anew.
    """
    picture = ground.copy()
    brush = ImageDraw.Draw(picture)
    for signal in episode.signals:
        line = camera.points([(signal.x0, signal.y0), (signal.x1, signal.y1)])
        colour = SIGNALS.get(signal.state[min(step, len(signal.state) - 1)], PAINT)
        brush.line(line, fill=colour, width=camera.pixels(0.7))
    for track in (episode.ego_track, *episode.adversaries):
        trail = camera.points(np.stack([track.x[: step + 1], track.y[: step + 1]], axis=1).tolist())
        if len(trail) > 1:
            brush.line(trail, fill=ROLES[track.role], width=camera.pixels(0.2))
    _draw_crash(camera, brush, episode, step)
    for track in reversed(episode.tracks):
        _draw_actor(camera, brush, track, step)
    brush.text(
        (10 * OVERSAMPLE, 8 * OVERSAMPLE),
        f"{step * episode.dt:.1f} s   ego {episode.ego_track.speed[step]:.1f} m/s",
        fill=INK,
        font_size=14 * OVERSAMPLE,
    )
    return reduced(picture) if small is None else _reduced_on(picture, ground, small)


def reduced(picture: Image.Image) -> Image.Image:
    """A large picture, or a part of one, as a small one."""
    return picture.resize((picture.width // OVERSAMPLE, picture.height // OVERSAMPLE), Image.Resampling.BOX)


def _reduced_on(picture: Image.Image, ground: Image.Image, small: Image.Image) -> Image.Image:
    """`reduced` of a large picture that is the ground but for some tiles: each small pixel is that of four large."""
    frame, differs, side = small.copy(), ImageChops.difference(picture, ground), TILE * OVERSAMPLE
    for top in range(0, picture.height, side):
        if bounds := differs.crop((0, top, picture.width, top + side)).getbbox():
            left, right = bounds[0] // side * side, math.ceil(bounds[2] / side) * side
            frame.paste(reduced(picture.crop((left, top, right, top + side))), (left // OVERSAMPLE, top // OVERSAMPLE))
    return frame


def _draw_crash(camera: Camera, brush: ImageDraw.ImageDraw, episode: Episode, step: int) -> None:
    crash = episode.collision
    if crash is None or step < crash.step:
        return
    x, y = contact_point(episode, crash)
    radii = [2.6 if i % 2 == 0 else 1.3 for i in range(20)]
    star = [(x + r * math.cos(i * math.pi / 10), y + r * math.sin(i * math.pi / 10)) for i, r in enumerate(radii)]
    brush.polygon(camera.points(star), fill=STAR, outline=STAR_EDGE, width=2 * OVERSAMPLE)


def _draw_actor(camera: Camera, brush: ImageDraw.ImageDraw, track: Track, step: int) -> None:
    x, y, heading = float(track.x[step]), float(track.y[step]), float(track.heading[step])
    cos, sin = math.cos(heading), math.sin(heading)

    def placed(shape: Points) -> list[tuple[float, float]]:
        return camera.points([(x + u * cos - v * sin, y + u * sin + v * cos) for u, v in shape])

    half, side = track.length / 2, track.width / 2
    if manner_of(track.kind) is Manner.WALKS:
        radius = max(0.45, 5 * OVERSAMPLE / camera.scale)
        brush.polygon(placed([(2 * radius, 0), (0, radius), (0, -radius)]), fill=ROLES[track.role])
        ((u, v),), wide = camera.points([(x, y)]), radius * camera.scale
        brush.ellipse([u - wide, v - wide, u + wide, v + wide], fill=ROLES[track.role], outline=PAINT)
        return
    corners = placed([(half, side), (-half, side), (-half, -side), (half, -side)])
    brush.polygon(corners, fill=ROLES[track.role], outline=PAINT, width=OVERSAMPLE)
    if track.role is not Role.OCCLUDER and manner_of(track.kind) is not Manner.LIES:
        tip, base = 0.75 * half, 0.75 * half - 0.8 * side
        brush.polygon(placed([(tip, 0), (base, 0.6 * side), (base, -0.6 * side)]), fill=PAINT)
