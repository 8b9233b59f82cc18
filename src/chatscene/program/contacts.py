"""Who ran into whom, and where: what a watcher tells of a collision."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator

import numpy as np

from chatscene.program.finding import Finding
from chatscene.simulate.contact import side_touched, sides_touched
from chatscene.simulate.striking import strike
from chatscene.terms.episode import Episode, Track
from chatscene.terms.situation import Contact, Situation
from chatscene.terms.vocabulary import LETS_GO, SIDES_OF, Act, Striker

AT_SLACK = 0.15  # of the ego's width
HOW = ("whom", "ego", "other", "striker", "at", "behind_nose")
"""What is said of how two touch, to which a drive without a contact does not come."""


def of_contact(situation: Situation, episode: Episode) -> Iterator[Finding]:
    """What a drive shows of the contact that was said: whether there is one, with whom, and which parts touch."""
    said, collision = situation.contact, episode.collision
    if said is None:
        return
    if collision is None:
        told = "said a contact, there is none" if said.happens else "there is none"
        yield Finding(path="contact.happens", shown=None if said.happens else True, told=told)
        how = (name for name in HOW if getattr(said, name) is not None)
        yield from (Finding(path=f"contact.{name}", shown=None, told=told) for name in how if said.happens)
        return
    if not said.happens:
        another = said.whom is not None and not is_with(collision.other, said.whom)
        told = f"said that there is no contact, there is one{f' with {collision.other}' if another else ''}"
        yield Finding(path="contact.happens", shown=None if another else False, told=told)
        return
    whom = said.whom or next(one.id for one in situation.adversaries)
    right = is_with(collision.other, whom)
    yield Finding(path="contact.happens", shown=True, told="said a contact", at=collision.step * episode.dt)
    yield Finding(path="contact.whom", shown=right, told=f"said {whom}, it is {collision.other}")
    other = next((t for t in episode.tracks if t.actor == collision.other), None)
    if said.ego is not None:
        corner = sides_touched(episode.ego_track, other, collision.step, collision.earlier) if other else frozenset()
        right = not (corner | {collision.side}).isdisjoint(SIDES_OF[said.ego])
        yield Finding(path="contact.ego", shown=right, told=f"said {said.ego}, it is the {collision.side}")
    if other is None:
        return
    yield from _at_point(said, episode, other)
    if said.other is not None:
        whose = next((t for t in episode.tracks if _is_door_of(other.actor, t.actor)), other)  # it is a part of it
        sides = sides_touched(whose, episode.ego_track, collision.step, collision.earlier)
        side = side_touched(whose, episode.ego_track, collision.step, collision.earlier)
        right = not sides.isdisjoint(SIDES_OF[said.other])
        yield Finding(path="contact.other", shown=right, told=f"said {said.other}, it is the {side}")
    if said.striker is not None:
        struck = strike(episode)
        assert struck is not None
        striker = Striker.EGO if struck.by_ego else Striker.OTHER
        right = striker is said.striker or struck.each
        yield Finding(path="contact.striker", shown=right, told=f"said {said.striker}, it is {striker}")


def _at_point(said: Contact, episode: Episode, other: Track) -> Iterator[Finding]:
    """Whether the point of the other that was said is where on the ego's width it was said to be."""
    if said.at is None or episode.collision is None:
        return
    behind = None if said.behind_nose is None else 0.5 * sum(said.behind_nose.drawn(0.0, 1.0))
    share = _on_width(episode.ego_track, other, episode.collision.step, behind)
    low, high = said.at.drawn(0.0, 1.0)
    right = low - AT_SLACK <= share <= high + AT_SLACK
    for path in ("contact.at", *(["contact.behind_nose"] if behind is not None else [])):
        yield Finding(path=path, shown=right, told=f"said {said.at}, it is {100 * share:.0f} % of the width")


def _on_width(ego: Track, other: Track, step: int, behind: float | None = None) -> float:
    """Where on the ego's width a point of the other is, as a share from the side that it comes from.

    The point is its middle, or lies on its side that faces the ego so far behind its nose, as a share of its length.
    """
    steps = np.arange(min(step, len(other.x) - 1) + 1)
    heading = ego.heading[steps]
    left = (other.y[steps] - ego.y[steps]) * np.cos(heading) - (other.x[steps] - ego.x[steps]) * np.sin(heading)
    from_left = left[np.abs(left).argmax()] > 0.0
    at, aside = int(steps[-1]), float(left[-1])
    if behind is not None:
        its, turned = float(other.heading[at]), float(other.heading[at] - ego.heading[at])
        dx, dy = float(ego.x[at] - other.x[at]), float(ego.y[at] - other.y[at])
        facing = math.copysign(0.5 * other.width, dy * math.cos(its) - dx * math.sin(its))
        aside += (0.5 - behind) * other.length * math.sin(turned) + facing * math.cos(turned)
    return 0.5 - (1.0 if from_left else -1.0) * aside / ego.width


def _is_door_of(door: str, actor: str) -> bool:
    """Whether somebody has a door that is open."""
    return is_of(door, f"{actor}-{LETS_GO[Act.OPEN_DOOR]}")


def is_of(actor: str, name: str) -> bool:
    """Whether a track is of somebody, or of one of several who have a name together."""
    return re.fullmatch(rf"{re.escape(name)}(-\d+)?", actor) is not None


def is_with(actor: str, name: str) -> bool:
    """Whether a track is of somebody, or of what it lets go: its door, its load."""
    return any(is_of(actor, one) for one in (name, *(f"{name}-{part}" for part in LETS_GO.values())))
