"""A scene as a GIF, for a chat or a slide: fixed camera, drawn with Pillow."""

from __future__ import annotations

import io
import warnings
from collections.abc import Callable, Mapping
from itertools import chain
from pathlib import Path
from typing import Any, TypeVar
from urllib.parse import quote

from PIL import Image, ImageDraw, ImageFont

from chatscene.errors import RunError
from chatscene.maps.picture import (
    GROUND,
    HEIGHT,
    INK,
    OVERSAMPLE,
    PAINT,
    ROLES,
    WIDEST,
    WIDTH,
    Camera,
    draw_frame,
    draw_ground,
    reduced,
)
from chatscene.report.span import AFTER, span
from chatscene.report.tracks import called
from chatscene.report.viewer import best
from chatscene.runs import note, open_run, read_drawing, read_episode, read_record
from chatscene.runs.atomic import write_bytes
from chatscene.terms.actors import noun_of
from chatscene.terms.episode import Episode, Role
from chatscene.terms.scene import CAR

FRAMES = 75  # at most; what happened
BEFORE = 40  # steps that a still leads up to
WIDE = 64.0  # [m] that a still shows at most, so that bodies can be made out
LAST = 1500  # [ms] that the last frame stands

T = TypeVar("T")


def if_drawn(what: str, draw: Callable[[], T]) -> T | None:
    """What a drawing gives; None, with a warning, where it fails: the drives that it would show are done, and stand."""
    try:
        return draw()
    except Exception as error:  # noqa: BLE001 - whatever it is, it is told
        warnings.warn(
            f"{what} could not be drawn ({type(error).__name__}: {error}); all else is kept",
            RuntimeWarning,
            stacklevel=2,
        )
        return None


def write_gif(folder: Path, scene_id: str | None = None) -> Path:
    """Draw a scene of a run as an animated GIF in the run folder.

    Returns:
        The path: ``<scenario>-<route>-<scene>.gif``.

    Raises:
        RunError: There is no such scene, or it was not driven, or the folder cannot be written.
    """
    run = open_run(folder)
    if scene_id is None:
        first = best(run)
        if first is None:
            raise RunError(f"{folder} has no scene that was driven, so there is nothing to animate")
        scene_id = str(first["scene_id"])
    record = read_record(run)
    content = animate(read_episode(run, scene_id), read_drawing(run), said=record.title, ego=record.ego)
    path = run.file(f"{quote(scene_id.replace('/', '-'), safe='')}.gif")
    write_bytes(path, content)
    note(run, path)
    return path


def still(episode: Episode, drawing: Mapping[str, Any], step: int | None = None, form: str = "WEBP") -> bytes:
    """A moment of a drive as a small picture.

    Args:
        episode: The drive.
        drawing: The map around it, as `chatscene.maps.drawing.map_drawing` makes it.
        step: Which; None for that at which the ego crashes, or comes nearest to its adversary.
        form: ``WEBP``, or ``PNG``, which every reader of pictures knows.
    """
    step = span(episode).moment if step is None else step
    camera = Camera.on(episode, range(max(0, step - BEFORE), step + 1), WIDE)
    frame = draw_frame(camera, draw_ground(camera, drawing), episode, step)
    sink = io.BytesIO()
    small = frame.resize((WIDTH * 2 // 3, HEIGHT * 2 // 3), Image.Resampling.LANCZOS)
    small.save(sink, format=form, quality=80)
    return sink.getvalue()


def animate(
    episode: Episode,
    drawing: Mapping[str, Any],
    *,
    said: str = "",
    ego: str = "",
    frames: int = FRAMES,
    widest: float = WIDEST,
) -> bytes:
    """A drive as an animated GIF.

    Args:
        episode: The drive.
        drawing: The map around it, as `chatscene.maps.drawing.map_drawing` makes it.
        said: What stands above, with who is who and a scale below; without it the picture stands by itself.
        ego: Who drives, for that.
        frames: At most; those up to shortly after what happened (`chatscene.report.span`).
        widest: Width of the picture [m] at most; a longer way is shown to its end.
    """
    part = span(episode)
    stride = max(1, round(0.1 / episode.dt))
    last = min(part.last, max(part.first + (frames - 1) * stride, part.moment + round(AFTER / episode.dt)))
    shown = list(range(last, part.first - 1, -stride))[:frames][::-1]
    camera = Camera.on(episode, shown, widest)
    ground = draw_ground(camera, drawing)
    small = reduced(ground)
    bands = (above(said), below(episode, camera, ego)) if said else None

    def drawn(step: int) -> Image.Image:
        frame = draw_frame(camera, ground, episode, step, small)
        return frame if bands is None else between(bands[0], frame, bands[1])

    # One palette for all frames: colours do not flicker, and what does not move costs nothing. A frame in full colour
    # is four times as large, so that there is one at a time beside the last.
    end = drawn(shown[-1])
    palette = end.quantize(colors=64, method=Image.Quantize.MEDIANCUT)
    others = map(drawn, shown[:-1])
    indexed = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in chain(others, [end])]
    duration = round(stride * episode.dt * 1000)
    sink = io.BytesIO()
    indexed[0].save(
        sink,
        format="GIF",
        save_all=True,
        append_images=indexed[1:],
        duration=[duration] * (len(indexed) - 1) + [LAST],
        loop=0,
        optimize=False,
    )
    return sink.getvalue()


# What stands above and below a moving picture, so that it is understood alone: the sentence, who is who, a
# scale


FONT, LINE, EDGE = 13, 18, 10  # [px]
LINES = 3  # of the sentence, at most
SCALES = (5, 10, 20, 50)  # [m]
WIDEST_SCALE = WIDTH / 5  # [px]


def above(said: str) -> Image.Image:
    """A band with the sentence, as much of it as has room."""
    lines = _wrapped(" ".join(said.split()))
    band = Image.new("RGB", (WIDTH, len(lines) * LINE + EDGE), PAINT)
    ImageDraw.Draw(band).multiline_text((EDGE, EDGE / 2), "\n".join(lines), fill=INK, font=_font(), spacing=LINE - FONT)
    return band


def below(episode: Episode, camera: Camera, ego: str) -> Image.Image:
    """A band with who is who and how long some metres are."""
    band = Image.new("RGB", (WIDTH, LINE + EDGE), PAINT)
    brush, font = ImageDraw.Draw(band), _font()
    left = float(EDGE)
    for role, name in _who(episode, ego):
        brush.rectangle((left, EDGE / 2 + 4, left + 12, EDGE / 2 + 14), fill=ROLES[role])
        brush.text((left + 18, EDGE / 2), name, fill=INK, font=font)
        left += 18 + font.getlength(name) + 2 * EDGE
    metres = max((m for m in SCALES if m * camera.scale / OVERSAMPLE <= WIDEST_SCALE), default=SCALES[0])
    length, right, low = metres * camera.scale / OVERSAMPLE, WIDTH - EDGE, LINE + EDGE / 2 - 6
    text = f"{metres} m"
    brush.rectangle((right - length - font.getlength(text) - 4 * EDGE, 0, WIDTH, LINE + EDGE), fill=PAINT)
    brush.text((right - length - font.getlength(text) - EDGE, EDGE / 2), text, fill=INK, font=font)
    ends = [(right - length, low - 5), (right - length, low), (right, low), (right, low - 5)]
    brush.line(ends, fill=INK, width=2)
    return band


def between(top: Image.Image, frame: Image.Image, bottom: Image.Image) -> Image.Image:
    """A frame with the bands above and below it."""
    whole = Image.new("RGB", (WIDTH, top.height + frame.height + bottom.height), GROUND)
    for part, y in ((top, 0), (frame, top.height), (bottom, top.height + frame.height)):
        whole.paste(part, (0, y))
    return whole


def _who(episode: Episode, ego: str) -> list[tuple[Role, str]]:
    kinds = dict.fromkeys(
        (track.role, called(track.role, track.kind)) for track in episode.tracks if track.role is not Role.EGO
    )
    own = episode.ego_track.kind
    what = "ego" if own == CAR else f"ego ({noun_of(own)})"
    return [(Role.EGO, f"{what}: {ego}" if ego else what), *kinds]


def _wrapped(said: str) -> list[str]:
    """Lines that fit; the last one ends with an ellipsis if there is more."""
    font, lines = _font(), [""]
    for word in said.split():
        longer = f"{lines[-1]} {word}".strip()
        if font.getlength(f"{longer} …") <= WIDTH - 2 * EDGE or not lines[-1]:
            lines[-1] = longer
        elif len(lines) < LINES:
            lines.append(word)
        else:
            lines[-1] += " …"
            break
    return lines


def _font() -> ImageFont.FreeTypeFont | ImageFont.ImageFont:
    return ImageFont.load_default(FONT)
