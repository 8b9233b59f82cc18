"""A verdict as a page: what is shown of each fact, with a picture of the moment at which it is."""

from __future__ import annotations

import base64
from collections.abc import Iterable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from chatscene.errors import SettingsError
from chatscene.files.atomic import write_whole
from chatscene.report.animation import if_drawn, still
from chatscene.report.templates import asset, fill, policy
from chatscene.terms.episode import Episode, Track
from chatscene.verdict.result import in_a_line
from chatscene.verdict.verdict import VERDICTS, Answer, Fact, Seen, Verdict
from chatscene.verdict.watched import Drawing

MARGIN = 60.0  # [m] of map about a drive
_CHIPS = {Answer.SHOWN: "kept", Answer.NOT_SHOWN: "hit", Answer.IN_PART: "hit"}


def write_page(path: Path, verdict: Verdict, drawing: Drawing | None) -> None:
    """Write the page; it needs nothing but a browser.

    Raises:
        SettingsError: It cannot be written there.
    """
    if not path.name or path.is_dir():
        raise SettingsError(f"cannot write {path}: it is a folder; name a file")
    try:
        write_whole(path, verdict_page(verdict, drawing).encode())
    except OSError as error:
        raise SettingsError(f"cannot write {path}: {error.strerror}") from error


def verdict_page(verdict: Verdict, drawing: Drawing | None) -> str:
    """The page.

    Args:
        verdict: What is told.
        drawing: The map; None where there is none.
    """
    moments = _moments([*verdict.facts, *verdict.encounters, *verdict.unasked])
    result = in_a_line(verdict)
    return fill(
        "verdict.html",
        title=f"{VERDICTS[verdict.status]}: {verdict.told}",
        policy=policy(),
        style=asset("viewer.css") + asset("coverage.css"),
        heading=f"{result[0].upper()}{result[1:]}",
        what=verdict.what,
        kind=verdict.kind,
        told=verdict.told,
        lines=[*verdict.dead, *verdict.notes, *dict.fromkeys(verdict.rejected)],
        facts=[_row(one, moments) for one in verdict.facts],
        encounters=[_row(one, moments) for one in verdict.encounters],
        unasked=[_row(one, moments) for one in verdict.unasked],
        moments=[
            {
                "id": _name(*place),
                "at": f"{place[1]:.1f} s",
                "draw": place[0],
                "lines": lines,
                "picture": base64.b64encode(_picture(verdict, *place, drawing)).decode(),
            }
            for place, lines in sorted(moments.items())
        ],
    )


def _picture(verdict: Verdict, draw: int, at: float, drawing: Drawing | None) -> bytes:
    """The picture of a moment; empty where it cannot be drawn, which is told."""
    episode, since = verdict.played[draw], verdict.draws[draw].begin
    return if_drawn(f"drive {draw} at {at:.1f} s", lambda: picture(episode, at - since, drawing)) or b""


def _row(fact: Fact, moments: dict[tuple[int, float], list[str]]) -> dict[str, Any]:
    place = next(((one.draw, one.at) for one in _timed(fact)), None)
    at = fact.at if fact.at is not None or place is None else place[1]
    return {
        "answer": fact.answer.value,
        "chip": "" if fact.assumed else _CHIPS.get(fact.answer, ""),
        "count": f"{fact.shown}/{len(fact.judged)}" if fact.judged else "",
        "at": "" if at is None else f"{at:.1f} s",
        "moment": _name(*place) if place in moments else "",
        "path": fact.path,
        "said": fact.said + (" (assumed)" if fact.assumed else ""),
        "instead": fact.instead,
    }


def _moments(facts: Iterable[Fact]) -> dict[tuple[int, float], list[str]]:
    """Of each fact the first moment at which it is seen, or is seen not to hold, by drive and time [s]."""
    found: dict[tuple[int, float], list[str]] = {}
    for fact in facts:
        one = next(_timed(fact), None)
        if one is not None and one.at is not None:
            told = fact.instead or one.told
            found.setdefault((one.draw, one.at), []).append(f"{fact.path}: {told}")
    return found


def _timed(fact: Fact) -> Iterator[Seen]:
    wanted = fact.shown > 0 and not fact.path.startswith("unasked.")
    yield from (one for one in fact.seen if one.at is not None and one.shown is wanted)


def picture(episode: Episode, at: float, drawing: Drawing | None, form: str = "WEBP") -> bytes:
    """A moment of a drive from above, with those who are there then.

    Args:
        episode: The drive; somebody has no numbers (nan) while it is not there.
        at: When, from its begin [s]; after its end, the end.
        drawing: The map; None where there is none.
        form: ``WEBP`` or ``PNG``.
    """
    step = min(round(at / episode.dt), len(episode.ego_track.x) - 1)
    there = tuple(_since(track) for track in episode.tracks if np.isfinite(track.x[step]))
    gone = {track.actor for track in episode.tracks} - {track.actor for track in there}
    events = tuple(one for one in episode.events if one.other not in gone)
    shown = replace(episode, tracks=there, events=events)
    return still(shown, drawing(shown.scene_id, box_of(shown)) if drawing else {}, step, form)


def _since(track: Track) -> Track:
    """A track whose way begins where somebody first is, if that is later than the drive does."""
    first = int(np.argmax(np.isfinite(track.x)))
    x, y = (np.concatenate([np.full(first, row[first]), row[first:]]) for row in (track.x, track.y))
    return replace(track, x=x, y=y) if first else track


def box_of(episode: Episode) -> tuple[float, float, float, float]:
    """What is drawn of the map about a drive: west, south, east and north [m]."""
    x, y = episode.ego_track.x, episode.ego_track.y
    west, south, east, north = (float(one) for one in (np.min(x), np.min(y), np.max(x), np.max(y)))
    return west - MARGIN, south - MARGIN, east + MARGIN, north + MARGIN


def _name(draw: int, at: float | None) -> str:
    return f"drive-{draw}-at-{at or 0.0:.1f}".replace(".", "-")
