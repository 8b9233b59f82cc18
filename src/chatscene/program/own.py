"""What the ego does, as it was said: at its pedals, with its wheel, and against which rules."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from chatscene.program.contacts import is_of
from chatscene.program.deeds import MOVING, STANDING
from chatscene.program.deeds import Act as Once
from chatscene.program.doing import DRIFTED, ON_LINE, accelerates
from chatscene.program.finding import Finding, not_judged
from chatscene.program.meaning import EGO_STATES, TOGETHER
from chatscene.program.watching import watch
from chatscene.terms.arrays import Array
from chatscene.terms.backing import backs
from chatscene.terms.changing import changes_later
from chatscene.terms.episode import Episode, EventKind
from chatscene.terms.route import Route
from chatscene.terms.scenario import EgoState
from chatscene.terms.situation import EGO, Deed, Situation
from chatscene.terms.vocabulary import CHANGES, Act, Breach, Heads, Side, acts_of

OVER = 5  # [steps] at the end of which an ego that is hit is seen to lose speed
LOST_AT_ONCE = 0.5  # [m/s] that it has lost then, if it was losing speed when it was hit
CHANGED = 2.2  # [m] from its line: an ego that is farther has changed lanes
BACK = 0.3  # [m/s] from which on an ego is seen to go back
OFF_ROAD = 2.2  # [m] from its line at least an ego that has left the road
EDGE = 1.0  # [m] from its line at least an ego that stands at the edge
_STATES = {Act.STOP: EgoState.STOPS, Act.SLOW_DOWN: EgoState.SLOWS_DOWN, Act.BRAKE: EgoState.BRAKES}
_ASIDE = {Act.SWERVE: DRIFTED, Act.DRIFT: DRIFTED, Act.LANE_CHANGE: CHANGED, Act.PARK: EDGE, Act.LEAVE_ROAD: OFF_ROAD}
BROKEN = {Breach.RED_LIGHT: EventKind.RED_LIGHT, Breach.STOP_SIGN: EventKind.STOP_SIGN}


def of_ego(
    situation: Situation, episode: Episode, route: Route, contact: int | None, done: dict[str, Once]
) -> Iterator[Finding]:
    """What a drive shows of the ego's deeds.

    Args:
        situation: What was said.
        episode: What happened.
        route: The ego's.
        contact: The step of the first contact, after which nothing is judged; None if there was none.
        done: When others did what they do, by who does each and its number or act; when the ego steers is added.
    """
    until = None if contact is None else contact + 1
    speed = np.abs(episode.ego_track.speed[:until])
    for k, deed in enumerate(situation.ego.does):
        path = f"ego.does.{k}"
        if deed.act is Act.REVERSE and not backs(situation):
            yield _backs_up(f"{path}.act", episode, until)
        elif deed.act is Act.LANE_CHANGE and situation.ego.route in CHANGES and not changes_later(situation.ego):
            yield not_judged(f"{path}.act")  # which its way is, and is judged as that
        elif deed.act is Act.OVERTAKE:
            yield from _passes(path, deed, situation, episode, route, contact)
        elif deed.act in _ASIDE:
            back = any(one.act is deed.act is Act.LANE_CHANGE for one in situation.ego.does[:k])
            waits = None if deed.when is None else done.get(deed.when.after or deed.when.during or "")
            since = 0 if waits is None else max(waits.began - round(TOGETHER / episode.dt), 0)
            found = _aside(path, deed, episode, route, contact, since, back=back or since > 0)
            if found.at is not None:
                at = round(found.at / episode.dt)
                done[f"{EGO}.{deed.act}"] = Once(at, at)
            yield found
        else:
            left = situation.answered(deed) is not None  # to whoever drives it
            yield from _pedals(f"{path}.act", deed, speed, episode, route, contact, first=k == 0, left=left)
        if deed.breaks is not None and (kind := BROKEN.get(deed.breaks)) is not None:
            broken = any(one.kind is kind and (until is None or one.step < until) for one in episode.events)
            shown = broken or (None if contact is not None else False)
            told = f"said {deed.breaks}, it {'breaks' if broken else 'keeps'} that rule"
            yield Finding(path=f"{path}.breaks", shown=shown, told=told)
        elif deed.breaks is not None:
            yield not_judged(f"{path}.breaks")


def _pedals(
    path: str,
    deed: Deed,
    speed: Array,
    episode: Episode,
    route: Route,
    contact: int | None,
    *,
    first: bool,
    left: bool,
) -> Iterator[Finding]:
    dt = episode.dt
    stood = bool(speed[: round(1.0 / dt)].max() < STANDING)
    course = f"it drives at {speed[0]:.1f} m/s at first and {speed.max():.1f} at most"
    if deed.act is Act.STAND and first:
        yield Finding(path=path, shown=stood, told=f"said stand, {course}", at=0.0)
    elif deed.act is Act.SET_OFF:
        still = np.flatnonzero(speed < STANDING)
        off = bool(still.size and (speed[still[0] :] > MOVING).any())
        yield Finding(path=path, shown=off or None, told=f"said set-off, {course}")
    elif deed.act in _STATES:
        state = _STATES[deed.act]
        if deed.act is Act.BRAKE and (deed.speed is not None or deed.time is not None):
            state = EgoState.SLOWS_DOWN  # as much as was said, which may be less than half
        begun = contact is not None and speed[-1] < speed[-OVER:].max() - LOST_AT_ONCE  # and is cut short
        shown = EGO_STATES[state](speed, dt) or (None if begun or left else False)
        rolls = deed.act is Act.STOP and contact is not None and float(speed[-1]) > MOVING
        cut = not left and (shown is None or rolls)
        yield Finding(path=path, shown=shown, told=f"said {deed.act}, {course}", cut=cut)
    elif deed.act is Act.ACCELERATE:
        seen = watch(episode, route, episode.ego_track, contact)
        said = deed.speed.high if deed.speed is not None and not deed.speed.than_ego else math.inf
        shown = any(True for _ in accelerates(seen, said)) or (None if contact is not None else False)
        yield Finding(path=path, shown=shown, told=f"said accelerate, {course}")
    else:
        yield not_judged(path)


def _backs_up(path: str, episode: Episode, until: int | None) -> Finding:
    """Whether an ego that drives forwards goes back some way."""
    speed = episode.ego_track.speed[:until]
    shown = bool((speed < -BACK).any()) or (None if until is not None else False)
    return Finding(path=path, shown=shown, told=f"said reverse, its least speed is {speed.min():.1f} m/s")


def _passes(
    path: str, deed: Deed, situation: Situation, episode: Episode, route: Route, contact: int | None
) -> Iterator[Finding]:
    """Whether the ego gets by whom it overtakes: first behind that one, and then before it."""
    names = {one.id for one in situation.others if deed.whom in (None, one.id)}
    shown = False
    for track in episode.tracks[1:]:
        if any(is_of(track.actor, name) for name in names):
            lead = watch(episode, route, track, contact).lead
            shown |= bool((lead > 0.0).any() and lead[int(np.argmax(lead > 0.0)) :].min() < 0.0)
    told = f"said {deed.act}, it {'gets' if shown else 'does not get'} by"
    yield Finding(path=f"{path}.act", shown=shown or (None if contact is not None else False), told=told)


def _aside(
    path: str, deed: Deed, episode: Episode, route: Route, contact: int | None, since: int, *, back: bool
) -> Finding:
    """Whether the ego leaves its line since a step, and to the side that was said; one that was hit may yet have.

    Of one that had been aside before, whether it leaves where it was then (`back`).
    """
    seen = watch(episode, route, episode.ego_track, contact)
    left = seen.offset if deed.to is not Side.RIGHT else -seen.offset
    aside = (left if deed.to is not None else np.abs(seen.offset))[since:]
    if back:
        aside = aside - np.minimum.accumulate(aside)
    most, least = float(aside.max(initial=0.0)), _ASIDE[deed.act]
    shown = most > least
    if deed.act in acts_of(Heads.EDGE):
        still = np.abs(episode.ego_track.speed[since : since + len(aside)]) < STANDING
        shown = bool((still & (aside > least)).any())
    at = (since + int(np.argmax(aside > min(least, ON_LINE)))) * episode.dt
    told = f"said {deed.act}{'' if deed.to is None else f' to the {deed.to}'}, it leaves its way by {most:.1f} m so"
    begun = contact is not None and most > ON_LINE
    return Finding(path=f"{path}.act", shown=shown or (None if begun else False), told=told, at=at if shown else None)
