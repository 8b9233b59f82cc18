"""Whether what was read of a text is what people wrote down for it, fact by fact.

One wrong fact, or one that nobody said, makes a reading wrong. Lanes, distances, groups and numbers are not compared,
and of others only how many act.
"""

from __future__ import annotations

from dataclasses import replace

from chatscene.terms.acts import BRINGS, Action
from chatscene.terms.conclusions import JUNCTIONS, TURNS, leaving_first
from chatscene.terms.scenario import EgoState, Maneuver, Place, Position, Side, Site, Slots, includes

_BESIDE = {Position.BESIDE, Position.AHEAD_BESIDE}
_ALIKE = (
    _BESIDE,  # "in the next lane" leaves open how far on
    {Position.ROADSIDE, Position.FAR_CORNER},
)
_NEXT_LANE = (*_BESIDE, Position.BEHIND_BESIDE)
_IN_NEXT_LANE = (*_NEXT_LANE, Position.BEHIND)
_TOWARDS = {Maneuver.LANE_CHANGE_LEFT: Side.LEFT, Maneuver.LANE_CHANGE_RIGHT: Side.RIGHT}
_SLOWER = {EgoState.SLOWS_DOWN, EgoState.BRAKES, EgoState.STOPS}  # people seldom say how far
_STANDING = {EgoState.STANDS, EgoState.STOPS}  # nor when it stopped
_PAST = {Site.PAST_ON_RAMP: Site.ON_RAMP, Site.PAST_OFF_RAMP: Site.OFF_RAMP}  # the ego's way says which
_SHOWN = (Site.ROUNDABOUT, Site.MOTORWAY, Site.ON_RAMP, Site.OFF_RAMP, Site.CROSSWALK)


def differing(said: Slots, read: Slots) -> tuple[str, ...]:
    """The slots in which a reading is not what was said.

    What goes without saying may be read or not: an ego that drives straight on, a road that is none but a road, who
    drives on while doing something else. A place may be read as one of its kinds, a lane change beside the ego as a
    cut-in. Of two of whom one leaves the lane before the other, either may be called the adversary. A side that nobody
    said is no fault, since somebody has to be on one.
    """
    said, read = _in_target_lane(leaving_first(said)), _in_target_lane(leaving_first(read))
    wrong = {
        "adversary": said.adversary not in (None, read.adversary),
        "actions": _deeds(said) != _deeds(read),
        "position": said.position is not None and not _same_position(said, read),
        "side": said.side is not None and said.side is not read.side,
        "maneuver": (said.maneuver or Maneuver.STRAIGHT) is not (read.maneuver or Maneuver.STRAIGHT),
        "place": not _same_place(said, read),
        "control": said.control is not read.control and (said.control is not None or said.place is not None),
        "ego": not any({said.ego, read.ego} <= alike for alike in ({said.ego}, _SLOWER, _STANDING)),
        "occluder": said.occluder is not read.occluder,
        "leader": said.leader != read.leader,
        "site": said.site in _SHOWN and _main_site(read.site) is not said.site,
        "others": len(said.others) != len(read.others),
    }
    return tuple(name for name, is_wrong in wrong.items() if is_wrong)


def _in_target_lane(slots: Slots) -> Slots:
    """Whoever is in the lane that the ego changes to is on that side, said or not."""
    side = _TOWARDS.get(slots.maneuver or Maneuver.STRAIGHT)
    beside = slots.position in _IN_NEXT_LANE and slots.side is None
    return replace(slots, side=side) if beside and side is not None else slots


def _main_site(site: Site | None) -> Site | None:
    return None if site is None else _PAST.get(site, site)


def _deeds(slots: Slots) -> frozenset[Action]:
    """What is done, without what others bring along or what only says how."""
    acts = {Action.STAND if act is Action.BLOCK else act for act in slots.actions}
    acts = acts.difference(*(BRINGS[act] for act in acts))
    if slots.position is Position.ONCOMING:
        acts -= {Action.ONCOMING, Action.FOLLOW, Action.FAST}
    if len(acts) > 1:
        acts -= {Action.FOLLOW, Action.FAST}
    if Action.STOP in acts:
        acts -= {Action.BRAKE}
    if {Action.RUN_LIGHT, Action.TURN_BACK} & acts:  # either is done on the way across
        acts -= {Action.CROSS}
    if Action.CHANGE_LANE in acts and slots.position in (None, *_IN_NEXT_LANE):
        acts = (acts - {Action.CHANGE_LANE}) | {Action.CUT_IN}
    return frozenset(acts)


def _same_position(said: Slots, read: Slots) -> bool:
    pair = {said.position, read.position}
    if len(pair) == 1 or any(pair <= alike for alike in _ALIKE):
        return True
    if {Action.OVERTAKE, Action.CHANGE_LANE, Action.CUT_IN, Action.FAST} & set(said.actions):
        return pair <= {Position.BEHIND, Position.BEHIND_BESIDE}  # from behind, past the ego
    return Action.WRONG_WAY in said.actions and pair <= {Position.AHEAD, Position.ONCOMING}


def _same_place(said: Slots, read: Slots) -> bool:
    if said.place in (None, Place.ROAD):
        return said.place is None or said.maneuver in TURNS or read.place not in JUNCTIONS
    return read.place is not None and (includes(said.place, read.place) or includes(read.place, said.place))
