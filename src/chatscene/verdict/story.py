"""What happened in a drive, in words, with times and speeds: who was where, who did what when, and how it ended.

Nothing is compared with what was said. Deeds are those that the judge sees on the tracks.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from chatscene.errors import SettingsError
from chatscene.measure.criticality import part_struck
from chatscene.measure.happening import happened
from chatscene.measure.severity import in_kmh, near_in_words
from chatscene.measure.struck import struck_in_words
from chatscene.program.deeds import STANDING, runs
from chatscene.program.watching import Seen, watch
from chatscene.runs.trust import Repeated
from chatscene.settings import VerifySettings
from chatscene.simulate.boxes import gaps
from chatscene.simulate.striking import strike
from chatscene.terms.actors import named
from chatscene.terms.episode import Episode, Event, EventKind, Role, Track
from chatscene.terms.mirroring import mirrored_drive, mirrored_route, mirrored_words
from chatscene.terms.route import Route
from chatscene.terms.scenario import Maneuver, Site
from chatscene.terms.vocabulary import Act as Said
from chatscene.terms.vocabulary import UserKind
from chatscene.verdict.moves import moves
from chatscene.verdict.paces import paces
from chatscene.verdict.page import picture
from chatscene.verdict.sources import watching
from chatscene.verdict.told import Told
from chatscene.verdict.watched import Drawing
from chatscene.verdict.who import between

LEFT = 1.0  # [m] from its way, from which the ego is told to have left it
NEAREST = 6  # road users that are told of: those to whom the ego comes nearest
_ENDINGS = {
    "collision": "the collision ends it",
    "arrived": "the ego arrives",
    "timeout": "its time limit is reached",
    "scenario-done": "the program ends it",
    "over": "no encounter is possible any more",
}
_WAYS = {
    Maneuver.STRAIGHT: "goes straight on",
    Maneuver.LEFT_TURN: "is to turn left",
    Maneuver.RIGHT_TURN: "is to turn right",
    Maneuver.LANE_CHANGE_LEFT: "is to change lanes to the left",
    Maneuver.LANE_CHANGE_RIGHT: "is to change lanes to the right",
    Maneuver.BYPASS: "is to go around what blocks its lane",
}
_EVENTS = {
    EventKind.RED_LIGHT: "runs a red light",
    EventKind.STOP_SIGN: "runs a stop sign",
    EventKind.OFF_ROAD: "leaves the road",
    EventKind.LANE_INVASION: "leaves its lane",
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Story:
    """What happened in one drive.

    Attributes:
        what: Of what it is a drive, as it was named.
        scene: Its id.
        seconds: How long it is.
        ending: Why it ended.
        notes: What else is to be known, such as who drove.
        told: What happened, in order of time.
    """

    what: str
    scene: str
    seconds: float
    ending: str
    notes: tuple[str, ...]
    told: tuple[Told, ...]
    _episode: Episode = field(repr=False, compare=False)
    _moment: float = field(repr=False, compare=False)
    _drawing: Drawing | None = field(default=None, repr=False, compare=False)

    def picture(self, at: float | None = None) -> bytes:
        """A moment seen from above, as PNG.

        Args:
            at: When [s]; None for the contact, or when the ego was nearest to somebody.

        Raises:
            SettingsError: The drive is not as long.
        """
        if at is not None and not 0.0 <= at <= self.seconds + self._episode.dt:
            raise SettingsError(f"there is no picture at {at:g} s: the drive is from 0.0 to {self.seconds:.1f} s")
        return picture(self._episode, self._moment if at is None else at, self._drawing, "PNG")

    def as_dict(self) -> dict[str, Any]:
        """For a script."""
        return {
            "what": self.what,
            "scene": self.scene,
            "seconds": self.seconds,
            "ending": self.ending,
            "notes": list(self.notes),
            "told": [one.as_dict() for one in self.told],
        }

    def __str__(self) -> str:
        """For a person."""
        end = f"{self.seconds:5.1f} s  the drive ends: {_ENDINGS.get(self.ending, self.ending)}"
        return "\n".join((f"{self.scene}: {self.seconds:.1f} s", *self.notes, *map(str, self.told), end))


def story(what: Path, settings: VerifySettings, repeated: Repeated | None = None) -> Story:
    """What happened in the first drive of a run, a program or a recording.

    Args:
        what: Anything that `chatscene.verdict.sources` has a row for.
        settings: Which scene, and who drives.
        repeated: What a run names and the user trusts.

    Raises:
        SettingsError: There is no such file, or no drive of it.
        ChatSceneError: It cannot be read or driven.
    """
    found = watching(what, replace(settings, draws=1), repeated)
    if not found.drives:
        why = "; ".join(dict.fromkeys(found.rejected)) or "nothing was driven"
        raise SettingsError(f"{what} has no drive: {why}; try another seed")
    one = found.drives[0]
    episode, there = one.episode, met(one.episode)
    nearest = _nearest(there)
    more = len(there) - len(nearest)
    others = (f"not described: {more} farther from the ego",) if more > 0 else ()
    return Story(
        what=str(what),
        scene=episode.scene_id,
        seconds=round(episode.duration, 3),
        ending=episode.ending.value,
        notes=(*found.notes, *_absent(episode, there), *others, *one.unplayed),
        told=told_of(episode, one.route, there),
        _episode=episode,
        _moment=_moment(episode, nearest),
        _drawing=found.drawing,
    )


@dataclass(frozen=True, slots=True, eq=False)
class Met:
    """Somebody beside the ego.

    Attributes:
        part: The drive from when to when it is there, with the ego and nobody else, and with what befell both.
        first: The step at which it is there first.
    """

    part: Episode
    first: int

    @property
    def track(self) -> Track:
        """Its track while it is there."""
        return self.part.tracks[1]


def met(episode: Episode) -> tuple[Met, ...]:
    """Everybody who is there for two steps at least, each for as long as it is there."""
    found = list[Met]()
    for track in episode.tracks[1:]:
        steps = np.flatnonzero(np.isfinite(track.x))
        if len(steps) > 1:
            first, end = int(steps[0]), int(steps[-1]) + 1
            part = between(episode, (episode.ego_track, track), first, end)
            events = tuple(one for one in part.events if one.other == track.actor)
            found.append(Met(replace(part, events=events), first))
    return tuple(found)


def told_of(episode: Episode, route: Route, there: Sequence[Met]) -> tuple[Told, ...]:
    """What happened in a drive, in order of time.

    Args:
        episode: The drive.
        route: The ego's.
        there: Who is in it beside the ego, as `met` gives them.
    """
    if route.mirrored:
        seen, way = mirrored_drive(episode), replace(mirrored_route(route), mirrored=False)
        lines = told_of(seen, way, [replace(one, part=mirrored_drive(one.part)) for one in there])
        return tuple(replace(one, what=mirrored_words(one.what)) for one in lines)
    contact = episode.collision.step if episode.collision is not None else None
    ego, others = episode.ego_track, _nearest(there)
    way = f"{_pace(ego)}; it {_way(route)}"
    lines = [Told(at=0.0, who="the ego", what=way)]
    own = watch(episode, route, ego, contact)
    lines += [*paces("the ego", own), *_leaves(own)]
    for one in others:
        begin = one.first * episode.dt
        lines += [
            replace(line, at=line.at + begin, until=None if line.until is None else line.until + begin)
            for line in _of(one, route, contact, episode.kinds, begin > 0.0)
        ]
        lines += _goes(one, episode)
    lines += [_event(event, episode, there) for event in episode.events]
    if contact is None and others:
        lines.append(_nearest_gap(others, there, episode.kinds))
    lines.sort(key=lambda one: one.at)
    return tuple(
        replace(one, at=round(one.at, 3), until=None if one.until is None else round(one.until, 3)) for one in lines
    )


def _of(one: Met, route: Route, contact: int | None, kinds: Mapping[str, str], comes: bool) -> Iterator[Told]:
    """What is told of somebody else, until the first contact of the drive; times are from when it is there."""
    until = None if contact is None else contact - one.first
    if until is not None and until < 1:
        return
    seen, who = watch(one.part, route, one.track, until), _name(one.track, kinds)
    yield _first(seen, who, comes)
    if one.track.role is not Role.OCCLUDER:
        yield from moves(who, _may(one.track), seen, route)
        yield from paces(who, seen)


def _goes(one: Met, episode: Episode) -> Iterator[Told]:
    """That somebody is not there any more, of one who is not until the end."""
    end = one.first + len(one.track.x)
    if end < len(episode.ego_track.x):
        yield Told(at=end * episode.dt, who=_name(one.track, episode.kinds), what="is no longer there")


def _absent(episode: Episode, there: Sequence[Met]) -> Iterator[str]:
    """Who is in a drive for so short that nothing can be told."""
    told = {one.track.actor for one in there}
    names = [track.actor for track in episode.tracks[1:] if track.actor not in told]
    if names:
        yield f"not described: {', '.join(names)}, present only for a moment"


def _nearest(there: Sequence[Met]) -> list[Met]:
    def apart(one: Met) -> float:
        ego = one.part.ego_track
        return float(np.min(np.hypot(one.track.x - ego.x, one.track.y - ego.y)))

    return sorted(there, key=apart)[:NEAREST]


def _nearest_of(others: Sequence[Met]) -> tuple[Met, int, float]:
    """To whom the ego comes nearest, at which step of theirs, and how near [m]."""
    apart = [gaps(one.part.ego_track, one.track) for one in others]
    least = min(range(len(others)), key=lambda number: float(apart[number].min()))
    step = int(apart[least].argmin())
    return others[least], step, float(apart[least][step])


def _moment(episode: Episode, others: Sequence[Met]) -> float:
    """The contact, or when the ego is nearest to somebody [s]; the end, where there is nobody."""
    if episode.collision is not None:
        return episode.collision.step * episode.dt
    if not others:
        return episode.duration
    nearest, step, _ = _nearest_of(others)
    return (nearest.first + step) * episode.dt


def _may(track: Track) -> frozenset[Said]:
    """What somebody of a kind can do."""
    kinds = [kind for kind in UserKind if kind.scenic == track.kind]
    return frozenset(act for act in Said if any(kind.can(act) for kind in kinds))


def _name(track: Track, kinds: Mapping[str, str]) -> str:
    return named(track.actor, track.kind, kinds)


def _pace(track: Track) -> str:
    speed = float(track.speed[0])
    if abs(speed) < STANDING:
        return "is stationary"
    return f"goes backwards at {in_kmh(-speed)}" if speed < 0.0 else f"goes at {in_kmh(speed)}"


def _way(route: Route) -> str:
    """Where the ego is bound for."""
    if route.site is Site.ROUNDABOUT:
        return "goes through a roundabout"
    return _WAYS[route.maneuver]


def _first(seen: Seen, who: str, comes: bool) -> Told:
    """Where somebody is at first, as the ego sees it, and how fast."""
    along, across = float(seen.along[0]), float(seen.across[0])
    where = f"{abs(along):.0f} m {'ahead of' if along >= 0.0 else 'behind'} the ego"
    if abs(across) >= 0.5:
        where += f" and {abs(across):.1f} m to its {'left' if across > 0.0 else 'right'}"
    begins = "is there from now on," if comes else "is"
    return Told(at=0.0, who=who, what=f"{begins} {where}, and {_pace(seen.track)}")


def _leaves(seen: Seen) -> Iterator[Told]:
    """When the ego is off its way, and how far at most."""
    aside = np.abs(seen.offset)
    for first, end in runs(aside > LEFT):
        peak = first + int(np.argmax(aside[first:end]))
        side = "left" if seen.offset[peak] > 0.0 else "right"
        what = f"is off its way, by up to {aside[peak]:.1f} m to the {side}"
        yield Told(at=first * seen.dt, until=(end - 1) * seen.dt, who="the ego", what=what)


def _event(event: Event, episode: Episode, there: Sequence[Met]) -> Told:
    at = event.step * episode.dt
    if event.kind is not EventKind.COLLISION:
        return Told(at=at, who="the ego", what=_EVENTS[event.kind])
    ego, hard = episode.ego_track, f"impact speed {in_kmh(event.impact_speed)}"
    mine = f"the ego at {in_kmh(abs(float(ego.speed[max(event.step - 1, 0)])))}"
    one = next((one for one in there if one.track.actor == event.other), None)
    if one is None:
        return Told(at=at, who="", what=f"COLLISION: the ego and {event.other}, who has no track; {mine}, {hard}")
    their = replace(event, step=event.step - one.first)
    other, before = one.track, max(their.step - 1, 0)
    theirs = _name(other, episode.kinds)
    fast = f"{mine}, the other at {in_kmh(abs(float(other.speed[before])))}, {hard}"
    how = strike(one.part) if event is episode.collision else None
    parts = ("the ego", event.side), (theirs, part_struck(other, one.part.ego_track, their))
    met = f"the ego and {theirs} touch" if how is None else struck_in_words(how, *parts)
    return Told(at=at, who="", what=f"COLLISION: {met}; {fast}")


def _nearest_gap(others: Sequence[Met], there: Sequence[Met], kinds: Mapping[str, str]) -> Told:
    """When the ego is nearest to whom, where nobody touches it."""
    one, step, apart = _nearest_of(others)
    every = (found for found in (happened(each.part).seconds for each in there) if found is not None)
    soon = min(every, default=None)
    seconds = "" if soon is None else f"; the smallest time gap to an adversary is {soon:.1f} s"
    fast = f"the ego at {in_kmh(abs(float(one.part.ego_track.speed[step])))}"
    what = f"closest: {near_in_words(apart)} between the ego and {_name(one.track, kinds)}, {fast}{seconds}"
    return Told(at=(one.first + step) * one.part.dt, who="", what=what)
