"""Who of a scene is who of a situation: names of others are theirs, so those are taken of whom most is shown."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, islice, product

import numpy as np

from chatscene.program.contacts import is_of
from chatscene.program.judge import judge
from chatscene.situations.facts import said_in
from chatscene.terms.actors import manner_of
from chatscene.terms.episode import Episode, Track
from chatscene.terms.situation import SEVERAL, Other, Situation
from chatscene.terms.vocabulary import LETS_GO
from chatscene.verdict.watched import Watched

TRIED = 200  # ways in which some may be who was said
LOOKED_AT = 3  # drives of which each way is judged
Cast = Mapping[str, tuple[str, ...]]
"""The names in a scene of each road user of a situation, by id."""


@dataclass(frozen=True, slots=True)
class _Way:
    """One way in which some are who was said, and how much of that is not shown."""

    cast: Cast
    failing: int


def cast_of(situation: Situation, drives: Sequence[Watched]) -> Cast:
    """Who is who: as they are named, if that shows all or nobody else shows more of it.

    Args:
        situation: What was said.
        drives: Of one program, in all of which road users have the same names; or one that was recorded.
    """
    first = drives[0].episode
    named = {one.id: tuple(t.actor for t in first.tracks[1:] if is_of(t.actor, one.id)) for one in situation.others}
    best = _Way(named, _failing(situation, drives, named))
    if not best.failing:
        return named
    for cast in islice(_casts(situation, first), TRIED):
        failing = _failing(situation, drives, cast)
        if failing < best.failing:
            best = _Way(cast, failing)
        if not best.failing:
            break
    return best.cast


@dataclass(frozen=True, slots=True, kw_only=True)
class Played:
    """A drive in which everybody has the name of who is meant in a situation.

    Attributes:
        episode: The drive, as long as all of them are there.
        begin: When that begins [s].
        cut: Whether somebody is not there all the time.
        left_out: Who else is there for a part of that, and not judged.
    """

    episode: Episode
    begin: float = 0.0
    cut: bool = False
    left_out: tuple[str, ...] = ()


def as_cast(episode: Episode, cast: Cast) -> Played:
    """A drive in which everybody has the name of who is meant in a situation; nobody else has one of these."""
    names = {
        actor: name if len(actors) == 1 else f"{name}-{number}"
        for name, actors in cast.items()
        for number, actor in enumerate(actors, 1)
    }

    def called(actor: str) -> str:
        for whose, name in names.items():
            if actor == whose or _is_part_of(actor, whose):
                return name + actor.removeprefix(whose)
        return f"another {actor}" if any(is_of(actor, one) for one in cast) else actor

    ego, *others = episode.tracks
    tracks = (ego, *(replace(track, actor=called(track.actor)) for track in others))
    events = tuple(replace(event, other=called(event.other)) if event.other else event for event in episode.events)
    return _while_there(replace(episode, tracks=tracks, events=events), names.values())


def _while_there(episode: Episode, names: Collection[str]) -> Played:
    """The part of a drive in which all of some are there; of others those stay that are there all of it.

    Who is never there together with the ones before is not there at all.
    """
    if all(np.isfinite(track.x).all() for track in episode.tracks):
        return Played(episode=episode)
    there = np.isfinite(episode.ego_track.x)
    for track in episode.tracks[1:]:
        if track.actor in names and (there & np.isfinite(track.x)).sum() > 1:
            there &= np.isfinite(track.x)
    first, end = int(np.argmax(there)), len(there) - int(np.argmax(there[::-1]))
    stay, left_out = list[Track](), list[str]()
    for track in episode.tracks:
        here = np.isfinite(track.x[first:end])
        if here.all():
            stay.append(track)
        elif here.any():
            left_out.append(track.actor)
    return Played(
        episode=between(episode, stay, first, end),
        begin=first * episode.dt,
        cut=end - first < len(there),
        left_out=tuple(left_out),
    )


def between(episode: Episode, tracks: Sequence[Track], first: int, end: int) -> Episode:
    """The part of a drive from one step to before another, with some of those who are there, the ego first."""

    def part(track: Track) -> Track:
        x, y, heading, speed = (row[first:end] for row in (track.x, track.y, track.heading, track.speed))
        return replace(track, x=x, y=y, heading=heading, speed=speed)

    return replace(
        episode,
        tracks=tuple(map(part, tracks)),
        events=tuple(replace(one, step=one.step - first) for one in episode.events if first < one.step < end),
        signals=tuple(replace(one, state=one.state[first:end]) for one in episode.signals),
        distance_to_route=episode.distance_to_route[first:end],
        off_road=episode.off_road[first:end],
    )


def _failing(situation: Situation, drives: Sequence[Watched], cast: Cast) -> int:
    """How many facts are not shown, of all drives that are looked at; of who is not there, none is."""
    absent = {name for name, actors in cast.items() if not actors}
    lost = sum(path.startswith("others.") and path.split(".")[1] in absent for path, _ in said_in(situation))
    looked_at = drives[:LOOKED_AT]
    return lost * len(looked_at) + sum(
        finding.shown is False
        for one in looked_at
        for finding in judge(situation, as_cast(one.episode, cast).episode, one.route)
    )


def _casts(situation: Situation, episode: Episode) -> Iterator[Cast]:
    """Every way in which some may be who was said, nobody twice; first those to whom the ego comes nearest."""
    ego = episode.ego_track
    actors = [track for track in episode.tracks[1:] if np.isfinite(track.x).any() and not _is_part(track, episode)]
    actors.sort(key=lambda track: float(np.nanmin(np.hypot(track.x - ego.x, track.y - ego.y))))
    choices = [list(_choices(one, actors)) or [()] for one in situation.others]
    if len(actors) < len(choices):  # somebody is not there
        choices = [[*names, ()] for names in choices]
    for chosen in product(*choices):
        everybody = [name for names in chosen for name in names]
        if len(everybody) == len(set(everybody)):
            yield {one.id: names for one, names in zip(situation.others, chosen, strict=True)}


def _choices(one: Other, actors: Sequence[Track]) -> Iterator[tuple[str, ...]]:
    """Who may be somebody: of the kind that was said; where there is nobody of it, anybody."""
    fitting = [track.actor for track in actors if is_kind(one, track)]
    if one.count == 1:
        yield from ((name,) for name in fitting or [track.actor for track in actors])
    elif one.count == SEVERAL or len(fitting) <= one.count:
        yield tuple(fitting)
    else:
        yield from combinations(fitting, one.count)


def is_kind(one: Other, track: Track) -> bool:
    """Whether a track is of the kind that was said, which may leave open what it is."""
    row = one.kind.row
    return track.kind == one.kind.scenic or (row.general and manner_of(track.kind) in (one.kind.moves, None))


def _is_part(track: Track, episode: Episode) -> bool:
    return any(_is_part_of(track.actor, other.actor) for other in episode.tracks[1:])


def _is_part_of(actor: str, whose: str) -> bool:
    """Whether somebody lets go of it: a door, a load."""
    return any(is_of(actor, f"{whose}-{part}") for part in LETS_GO.values())
