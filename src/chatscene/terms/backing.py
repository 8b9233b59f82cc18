"""An ego that drives backwards: the same situation and the same drive as of one whose nose is where it goes to.

Sides and parts of a situation are the ego's own, seen from its seat. Who builds or judges the way of an ego that backs
takes it as it goes: its rear is ahead then, and what is on its left lies on the right of its way.
"""

from __future__ import annotations

import math
from dataclasses import replace

from chatscene.terms.actors import Manner as Moves
from chatscene.terms.episode import Episode, Event
from chatscene.terms.route import Beside
from chatscene.terms.situation import Deed, Other, Situation
from chatscene.terms.vocabulary import WAITING, Act, EgoRoute, Part, Side, Where

BACKWARDS: dict[EgoRoute | None, Beside] = {
    EgoRoute.REVERSE: Beside.BACKWARDS,
    EgoRoute.LEAVE_DRIVEWAY: Beside.BACK_FROM_DRIVEWAY,
    EgoRoute.LEAVE_PARKING: Beside.BACK_FROM_BAY,
}
"""How the ways of an ego begin that it can drive backwards."""

_OPPOSITE = {"left": "right", "right": "left", "front": "rear", "rear": "front"}
_COMES_ALONG = {Where.BEHIND: Where.ONCOMING_IN_OUR_LANE, Where.AHEAD: Where.BEHIND}
"""Where somebody is on the way of an ego that backs along its lane."""
BEHIND_ON_FOOT = {True: Where.AHEAD, False: Where.ROADSIDE}
"""Where who is behind it and no vehicle is on that way: in its lane; beside the road, if it backs out onto that."""


def backs(situation: Situation) -> bool:
    """Whether the ego drives its way backwards: along the road, or out of a driveway or a bay."""
    ego = situation.ego
    if ego.route is EgoRoute.REVERSE:
        return True
    first = next((deed.act for deed in ego.does if deed.act not in WAITING), None)
    return ego.route in BACKWARDS and first is Act.REVERSE


def as_it_backs(situation: Situation) -> Situation:
    """A situation with sides, places and parts as they lie on the ego's way; the same, unless it backs."""
    if not backs(situation):
        return situation
    along = situation.ego.route is EgoRoute.REVERSE
    contact = situation.contact
    if contact is not None and contact.ego is not None:
        contact = replace(contact, ego=Part(turned_about(contact.ego)))
    return replace(situation, others=tuple(_turned(one, along=along) for one in situation.others), contact=contact)


def turned_about(part: str) -> str:
    """A side or a part as it is called by whoever looks the other way: ``left-front`` is then ``right-rear``."""
    return "-".join(_OPPOSITE.get(one, one) for one in part.split("-"))


def _turned(one: Other, *, along: bool) -> Other:
    start = one.starts
    where = _COMES_ALONG.get(start.where, start.where) if along else start.where
    if start.where is Where.BEHIND and one.kind.moves in (Moves.WALKS, Moves.LIES):
        where = BEHIND_ON_FOOT[along]
    side = None if start.side is None else Side(turned_about(start.side))
    return replace(one, starts=replace(start, where=where, side=side), does=tuple(map(_deed_turned, one.does)))


def _deed_turned(deed: Deed) -> Deed:
    return deed if deed.to is None else replace(deed, to=Side(turned_about(deed.to)))


def drive_as_it_backs(episode: Episode) -> Episode:
    """A drive whose ego is where it was, and looks where it goes to."""
    ego = episode.ego_track
    about = replace(ego, heading=ego.heading + math.pi, speed=0.0 - ego.speed)
    events = tuple(_event_turned(event) for event in episode.events)
    return replace(episode, tracks=(about, *episode.tracks[1:]), events=events)


def _event_turned(event: Event) -> Event:
    return replace(event, side=_OPPOSITE[event.side]) if event.side else event
