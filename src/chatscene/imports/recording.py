"""A drive that somebody else recorded: who was where and when, in whatever file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from chatscene.errors import ScenarioError
from chatscene.terms.actors import BY_CLASS, LIMITS, PROPS
from chatscene.terms.arrays import Array
from chatscene.terms.episode import Role, Track
from chatscene.terms.nouns import with_article
from chatscene.terms.vocabulary import UserKind

DT = 0.1  # [s], the step at which drives are judged
ROUNDING = 1e-6  # of a step
GAP = 0.5  # [s] without a row, from which somebody who has one at every step is not there,
MOST_MISSING = 3.5  # if that is more than so many steps
REGULAR, FEWEST = 0.9, 10  # such a share of all steps, of so many at least, is as long as the usual one
LONGEST = 600.0  # [s] of a recording
MOST = 200  # road users in it


@dataclass(frozen=True, slots=True, kw_only=True)
class Poses:
    """One road user as a file has it.

    Attributes:
        kind: A class of our world model, or a word of a situation for what it is.
        time: (T,) [s], growing.
        x, y: (T,) [m], of its centre.
        heading: (T,) [rad, 0 = +x, counter-clockwise].
        speed: (T,) [m/s], along the heading.
        length, width: [m]; None for those of its kind.
    """

    name: str
    kind: str
    time: Array
    x: Array
    y: Array
    heading: Array
    speed: Array
    ego: bool = False
    length: float | None = None
    width: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Recording:
    """A drive that was recorded.

    Attributes:
        tracks: The ego's first; all of one length, at steps of `DT` from where the ego begins to where it ends, and
            without a number (nan) where somebody is not there.
    """

    tracks: tuple[Track, ...]
    notes: tuple[str, ...] = ()


def recording(found: Sequence[Poses], path: object, ego_id: str = "") -> Recording:
    """The drive of some road users, at even steps, for as long as the ego is there.

    Raises:
        ScenarioError: Nobody is the ego, or several are; a kind is not known; or it is too long, or too short.
    """
    if len(found) > MOST:
        raise ScenarioError(f"{path} has {len(found)} road users; at most {MOST} are read: cut it down")
    ego = _ego(found, path, ego_id)
    begin, end = float(ego.time[0]), float(ego.time[-1])
    if not DT <= end - begin <= LONGEST:
        raise ScenarioError(
            f"{path} has {end - begin:.1f} s in which the ego is there; from {DT} to {LONGEST:g} s are read"
        )
    steps = np.minimum(np.arange(int((end - begin) / DT + ROUNDING) + 1) * DT + begin, end)
    others, notes = list[Track](), list[str]()
    for one in found:
        if one is ego:
            continue
        track = _track(one, one.name, None, steps, path)
        if np.isfinite(track.x).sum() > 1:
            others.append(track)
        else:
            notes.append(f"left out: {one.name}, which is not there while the ego is")
    return Recording(tracks=(_track(ego, "ego", Role.EGO, steps, path), *others), notes=tuple(notes))


def _ego(found: Sequence[Poses], path: object, ego_id: str) -> Poses:
    named = [one for one in found if (one.name == ego_id if ego_id else one.ego)]
    if len(named) == 1:
        return named[0]
    names = ", ".join(one.name for one in found[:20]) or "nobody"
    if ego_id:
        raise ScenarioError(f"{path} has {len(named)} road users called {ego_id!r}; there are: {names}")
    raise ScenarioError(
        f"{path} marks {len(named)} road users as the ego, and one is judged; name it with --ego-id. There are: {names}"
    )


def _track(one: Poses, actor: str, role: Role | None, steps: Array, path: object) -> Track:
    kind = _class_of(one.kind, path)
    away = _away(one.time)
    if role is Role.EGO and away:
        raise ScenarioError(
            f"{path}: the ego, {one.name}, is not there from {away[0][0]:g} to {away[0][1]:g} s; cut the drive there"
        )
    limits = LIMITS.get(kind) or PROPS.get(kind)
    length, width = one.length or (limits.length if limits else None), one.width or (limits.width if limits else None)
    if length is None or width is None:
        raise ScenarioError(
            f"{path}: {one.name} is {with_article(one.kind)}, whose size is not known; say its length and width"
        )
    x, y, heading, speed = (
        np.interp(steps, one.time, values, left=np.nan, right=np.nan)
        for values in (one.x, one.y, np.unwrap(one.heading), one.speed)
    )
    for last, first in away:
        for values in (x, y, heading, speed):
            values[(steps > last + ROUNDING) & (steps < first - ROUNDING)] = np.nan
    moves = kind in BY_CLASS and not BY_CLASS[kind].lies
    return Track(
        actor=actor,
        role=role or (Role.ADVERSARY if moves else Role.OCCLUDER),
        kind=kind,
        length=length,
        width=width,
        x=x,
        y=y,
        heading=heading,
        speed=speed,
    )


def _away(time: Array) -> list[tuple[float, float]]:
    """From when to when somebody is not there [s] who else has a row at every step.

    Of few rows, at times of their own, somebody is there between them too, as a table of turning points has it.
    """
    steps = np.diff(time)
    usual = float(np.median(steps)) if len(steps) >= FEWEST else np.inf
    if not np.isfinite(usual) or (np.abs(steps - usual) < usual / 2).mean() < REGULAR:
        return []
    gaps = np.flatnonzero(steps > max(GAP, MOST_MISSING * usual))
    return [(float(time[i]), float(time[i + 1])) for i in gaps]


def _class_of(kind: str, path: object) -> str:
    """The class of our world model for a kind, which may be one, or a word of a situation."""
    if kind in LIMITS or kind in PROPS:
        return kind
    named = kind.strip().lower().replace("_", "-").replace(" ", "-")
    if named in _WORDS:
        return _WORDS[named]
    raise ScenarioError(f"{path}: there is no kind of road user {kind[:40]!r}; known: {', '.join(sorted(_WORDS))}")


_WORDS: Mapping[str, str] = {kind.value: kind.scenic for kind in UserKind}
