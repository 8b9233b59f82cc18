"""Who ran into whom, and where: what a watcher tells of a collision."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator

import numpy as np

from chatscene.program.deeds import MOVING
from chatscene.program.finding import Finding
from chatscene.simulate.contact import side_touched, sides_touched
from chatscene.terms.episode import Episode, Track, contact_point
from chatscene.terms.situation import Contact, Situation
from chatscene.terms.vocabulary import LETS_GO, NOSE, SIDES_OF, Act, Striker

AT_SLACK = 0.15  # of the ego's width
TURNED_IN = 30  # steps before they touch, in which somebody is seen to turn toward the other …
TURNED = 0.01  # [rad] … by so much at least
SAME_WAY = math.cos(math.radians(25.0))  # of the angle between two who go the same way


def striker_of(episode: Episode, other: Track) -> Striker:
    """Who runs into whom: whose nose touches a flank or a tail, else who comes nearer by the own motion."""
    collision, ego = episode.collision, episode.ego_track
    assert collision is not None
    before = max(collision.step - 2, 0)
    if any(_is_door_of(other.actor, track.actor) for track in episode.tracks):
        return Striker.EGO if _at_front(episode) else Striker.OTHER
    noses = collision.side == "front", _touches_with_nose(episode, other)
    if noses == (True, False) and ego.speed[before] > MOVING:
        return Striker.EGO
    if noses == (False, True) and abs(other.speed[before]) > MOVING:
        return Striker.OTHER
    if not any(noses) and (over := _who_came_over(ego, other, collision.step)) is not None:
        return over
    dx, dy = float(other.x[before] - ego.x[before]), float(other.y[before] - ego.y[before])
    far = math.hypot(dx, dy) or 1.0

    def toward(track: Track, sign: float) -> float:
        heading, speed = float(track.heading[before]), float(track.speed[before])
        return sign * speed * (math.cos(heading) * dx + math.sin(heading) * dy) / far

    return Striker.EGO if toward(ego, 1.0) >= toward(other, -1.0) else Striker.OTHER


def _head_on(episode: Episode, other: Track) -> bool:
    """Whether two touch nose to nose, both under way: each runs into the other."""
    collision = episode.collision
    assert collision is not None
    before, noses = max(collision.step - 2, 0), collision.side == "front" and _touches_with_nose(episode, other)
    return noses and min(float(track.speed[before]) for track in (episode.ego_track, other)) > MOVING


def _who_came_over(ego: Track, other: Track, step: int) -> Striker | None:
    """Who turned toward the other of two who went the same way side by side; None of others."""
    since = max(step - TURNED_IN, 0)
    turned = [float(track.heading[step] - track.heading[since]) for track in (ego, other)]
    along = math.cos(float(ego.heading[step] - other.heading[step]))
    if along < SAME_WAY or max(map(abs, turned)) < TURNED:
        return None
    dx, dy = float(other.x[step] - ego.x[step]), float(other.y[step] - ego.y[step])
    heading = float(ego.heading[step])
    left = 1.0 if dy * math.cos(heading) - dx * math.sin(heading) > 0.0 else -1.0
    return Striker.EGO if left * turned[0] > -left * turned[1] else Striker.OTHER


def _at_front(episode: Episode) -> bool:
    """Whether the ego is touched in the front half: it drives into a door that is open, and else one opens into it."""
    collision, ego = episode.collision, episode.ego_track
    assert collision is not None
    x, y = contact_point(episode, collision)
    own_x, own_y, heading = ego.pose(collision.step, collision.earlier)
    return (x - own_x) * math.cos(heading) + (y - own_y) * math.sin(heading) > 0.0


def _touches_with_nose(episode: Episode, other: Track) -> bool:
    """Whether the nose of the other is where it touches the ego."""
    collision = episode.collision
    assert collision is not None
    x, y = contact_point(episode, collision)
    other_x, other_y, heading = other.pose(collision.step, collision.earlier)
    ahead = (x - other_x) * math.cos(heading) + (y - other_y) * math.sin(heading)
    return ahead > other.length / 2 - NOSE


def of_contact(situation: Situation, episode: Episode) -> Iterator[Finding]:
    """What a drive shows of the contact that was said: whether there is one, with whom, and which parts touch."""
    said, collision = situation.contact, episode.collision
    if said is None:
        return
    if collision is None:
        told = "said a contact, there is none" if said.happens else "there is none"
        yield Finding(path="contact.happens", shown=None if said.happens else True, told=told)
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
        striker = striker_of(episode, other)
        right = striker is said.striker or _head_on(episode, other)
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
