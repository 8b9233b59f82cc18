"""A scene as a GIF, for a chat or a slide: fixed camera, drawn with Pillow."""

from __future__ import annotations

import io
import warnings
from collections.abc import Callable, Mapping
from itertools import chain
from pathlib import Path
from typing import Any, TypeVar
from urllib.parse import quote

from PIL import Image

from chatscene.errors import RunError
from chatscene.maps.picture import HEIGHT, WIDEST, WIDTH, Camera, draw_frame, draw_ground, reduced
from chatscene.report.caption import above, below, between
from chatscene.report.span import AFTER, span
from chatscene.report.viewer import best
from chatscene.runs import note, open_run, read_drawing, read_episode, read_record
from chatscene.runs.atomic import write_bytes
from chatscene.terms.episode import Episode

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
