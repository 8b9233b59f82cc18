"""Where somebody stands at first, by where it was said to be: a row for each place, and one of five ways to meet."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

from chatscene.build.arriving import (
    comes_along,
    comes_back,
    out_of_driveway,
    roundabout,
    slow_enough,
    so_far_back,
    through,
)
from chatscene.build.asked import ROOM, Asked, Meets, Stand, bolts, goes_slowly, stands_first, stops_ahead
from chatscene.build.backing import comes_by, out_of, parked_beside
from chatscene.build.brushed import brushed
from chatscene.build.contact import all_but_strikes, comes_to_stand, is_held_up, strikes_from_behind, touches
from chatscene.build.cutting_in import begins_beside, room_to_avoid
from chatscene.build.doors import opens_in_lane, stands_in_lane
from chatscene.build.facing import faces, slanting, turned
from chatscene.build.flank import level_as_said
from chatscene.build.gaps import BACKS_FAR
from chatscene.build.halting import NOSE, line_before
from chatscene.build.parts import into_lane
from chatscene.build.place import (
    AT_JUNCTION,
    DRIVEWAYS,
    LANE,
    NEXT_LANE,
    Found,
    at_junction,
    at_roundabout,
    beside_lane,
    between_bays,
    between_lanes,
    changed_at,
    comes_across,
    filters,
    has_crosswalks,
    is_marked,
    lane_beside,
    turns_in_ahead,
    turns_out,
    turns_round_from_opposite,
)
from chatscene.build.relations import falls_behind, goes_with, slows_on_its_way, speed_of
from chatscene.build.screening import AT_EDGE, IN_SHADOW, from_its_lane, shadowed
from chatscene.build.standing_before import stop_behind
from chatscene.build.struck import behind_by
from chatscene.build.timing import Body
from chatscene.build.turning_round import so_far_ahead
from chatscene.errors import NoSuchPlace, NotBuilt, NothingBuilds
from chatscene.maps.equipment import bus_bay
from chatscene.maps.ways_off import IN_AT, NARROWEST, OUT_AT
from chatscene.terms.backing import backs
from chatscene.terms.conclusions import LANE_CHANGES
from chatscene.terms.nouns import with_article
from chatscene.terms.route import Beside
from chatscene.terms.scenario import Site
from chatscene.terms.situation import EGO, Situation
from chatscene.terms.vocabulary import (
    CHANGES,
    PLAIN,
    STOPS,
    Act,
    EgoRoute,
    Facing,
    Feature,
    Heads,
    Role,
    Side,
    Striker,
    Where,
    acts_of,
)
from chatscene.world.places import lanes_beside

BACKS = 1.5, 3.0  # [m/s], from and to, that somebody comes backwards onto the road
DRIVES = 1.5  # [s] that the ego is longer on its way to whom somebody hides who comes driving and stops there
BEFORE_NOSE = (1.5, 5.0)  # [m] from the nose of an ego that stands, from and to, that somebody crosses
EDGE, CROSSES_FROM, MEDIAN = 1.2, 1.55, 1.9  # [m] from the ego's line, in its lane and between the directions
COMES_UP, FARTHEST = (3.0, 4.0), 52.0  # [s] behind an ego that stands, from and to, who comes by; [m] at most
TOO_CLOSE, CLOSEST = (0.4, 0.7), 2.0  # [s] behind the ego who all but runs into it is, from and to; [m] at least
HEADWAY = 0.9, 1.7  # [s] behind whom it follows an ego is, from and to
STOPPING = 3.0  # [m/s²] that an ego loses at least which comes to a stand
STOOD = 1.0, 3.0  # [s] that it has stood, from and to, when somebody from behind is there
LEADS_UP = 80.0  # [m] of road at least that lead to where the ego begins
ABOUT = 1.5  # [m] sooner or later on its way somebody is who goes along to where the ego leaves the road
OFF_LANE = 5.0  # [m] on its way off the road, at which the ego goes over that of who is beside it
ENDS_BESIDE = (Beside.DRIVEWAY, Beside.DRIVEWAY_ACROSS, Beside.KERB)
SWINGS_OUT = "the ego swings out round who is"
SHORT_OF = 3.0  # [m] of a junction
IN_ITS_LANE = 18.0, 30.0  # [m] beyond where an ego comes into the lane from beside it, of who is ahead in that
IN_QUEUE = 1.5, 4.0  # [m], nose to tail, between two who stand, from and to
PASSED_WITHIN = 10.0  # [m] of where it has changed lanes, that the ego passes who stood in its own
CAREFUL = 1.5, 2.5  # [s] behind the ego, from and to, is who is careful, and lets it into its lane


def _over(asked: Asked, aside: float, side: str) -> Stand:
    """On foot on the road, so many metres to a side of the ego's line, on its way over to the other."""
    asked.ahead(34, 50)
    there = f"level{{i}}{asked.more}"
    return Stand(
        meets=Meets.ACROSS,
        point=f"pointOn(egoRoute, {there}, {-aside if side == Side.RIGHT else aside:g})",
        facing=faces(asked, there, Facing.ACROSS, side),
        faces=True,
        lines=("level{i} = $Y",),
        ego_meets="progressOn(egoRoute, self)[0]",
        left="max(0, abs(offsetFrom(egoRoute, self)) - 1)",
        anywhere=True,
    )


def _ahead(asked: Asked) -> Stand:
    if bolts(asked.one):
        return _over(asked, EDGE, Side.RIGHT)
    if asked.walks and (over := next((one for one in asked.one.does if one.act in acts_of(Heads.ACROSS)), None)):
        return _over(asked, CROSSES_FROM, Side.LEFT if over.to is Side.RIGHT else Side.RIGHT)
    if asked.walks:
        return _ahead_on_foot(asked)
    aside = -0.9 if asked.rides else 0.0
    before = asked.swings_out or asked.ego.stands or asked.situation.ego.route in CHANGES
    if asked.stands and (before or stop_behind(asked) is not None):
        return _stands_ahead(asked, aside)
    if asked.swings_out:  # who is passed while it goes: it is there when the ego is
        asked.ahead(22, 30)
        return Stand(meets=Meets.ALONG, way=_within("ownLane(egoRoute)", aside), at=f"$Y{asked.more}")
    at, turns = f"$Y{asked.more}", _turns_in(asked)
    if turns:
        asked.reach(*BEFORE_DRIVEWAY, "how far beyond 6 m before the driveway it is")
        at = f"egoRoute.eventAt - 6 + {at}"
    elif line := _at_line(asked):
        at = line + asked.more
    elif asked.stands:  # so far that it has done what it does when the ego is there
        asked.ahead(38, 56)
    else:
        asked.headway(*HEADWAY, caught_up=_caught_up(asked))
    return Stand(
        meets=Meets.ALONG, way=_within(asked.lane, aside), at=at, anywhere=asked.stands and at.startswith("$Y")
    )


def _at_line(asked: Asked) -> str:
    """Where somebody stands who stands first before the line of the junction, or before the rails; else empty."""
    line = line_before(asked.situation, asked.found) if asked.stands and asked.one.starts.distance is None else None
    if line is None:
        return ""
    half = 0.5 * asked.numbers.row.limits.length
    low, high = (-(line + half + far) for far in reversed(NOSE))
    return asked.at_event(low, high, "the line is", "how far before the junction or the rails its middle is")


def _turns_in(asked: Asked) -> bool:
    """Whether somebody stands where it then turns into a driveway."""
    turns = any(turns_in_ahead(asked.one, k) for k in range(len(asked.one.does)))
    return asked.stands and turns and asked.found.query.get("site") in DRIVEWAYS.values()


def _ahead_on_foot(asked: Asked) -> Stand:
    passed = asked.swings_out and asked.stands
    level = asked.at_event(-2, 2, SWINGS_OUT, "how far beyond where the ego swings out it is") if passed else "$Y"
    if not passed:
        asked.ahead(30, 50)
    return Stand(
        meets=Meets.ACROSS,
        point=f"pointOn({'ownLane(egoRoute)' if passed else 'egoRoute'}, level{{i}})",
        facing=faces(asked, "level{i}", Facing.ALONG, Side.RIGHT),
        lines=(f"level{{i}} = {level}{asked.more}",),
        ego_meets="progressOn(egoRoute, self)[0]",
        faces=True,
        anywhere=not passed,
    )


def _stands_ahead(asked: Asked, aside: float) -> Stand:
    """Who stands before an ego that stands, swings out round it, or changes to the lane beside it."""
    way = _within("ownLane(egoRoute)", aside)
    if (stop := stop_behind(asked)) is not None:
        nose = stop + asked.middles
        asked.reach(nose + IN_QUEUE[0], nose + IN_QUEUE[1])
        return Stand(meets=Meets.ALONG, way=_within(asked.lane, aside), at=f"$Y{asked.more}")
    if asked.swings_out:
        queue = sum(one.kind.row.body.row.limits.length + ROOM for one in asked.situation.others if stops_ahead(one))
        level = asked.at_event(-2, 2, SWINGS_OUT, "how far beyond where the ego swings out it stands", 2 + queue)
        free = asked.one.starts.distance is None
        more = asked.more + (f" + {queue:g}" if queue and free else "")  # of whom it swings out round first
        return Stand(meets=Meets.ALONG, way=way, at=f"{level}{more}")
    if asked.ego.stands:
        asked.reach(asked.middles + IN_QUEUE[0], asked.middles + IN_QUEUE[1])
        return Stand(meets=Meets.ALONG, way=_within(asked.lane, aside), at=f"$Y{asked.more}")
    over = changed_at(asked.found.route) + 0.5 * asked.numbers.row.limits.length
    asked.reach(over, over + PASSED_WITHIN)
    return Stand(meets=Meets.ALONG, way=way, at=f"$Y{asked.more}", anywhere=True)


def _caught_up(asked: Asked) -> float:
    """How far [m] an ego comes up to who goes before it before anything is done.

    It does until it changes lanes, and to who cannot be as fast. Who is to back up has as much room besides.
    """
    ways = (deed.distance for deed in asked.one.does if deed.act is Act.REVERSE)
    backs = sum(said.drawn(*BACKS_FAR)[1] for said in ways if said is not None)
    if asked.ego.stands or asked.stands:
        return backs
    if asked.situation.ego.route not in CHANGES:
        slower = asked.ego.speed - Body(asked.numbers.row.limits, asked.walks).fastest
        motorised = asked.one.kind.row.body.row.motorised
        steady = asked.numbers.range_of("STEADY")[1]
        return backs + (room_to_avoid(slower) + slower * steady if motorised and slower > 0.0 else 0.0)
    slow = goes_slowly(asked.one)
    own = asked.numbers.range_of("SPEED")[0] if slow else speed_of(asked.situation, asked.one.id, asked.ego.speed)
    slower = asked.ego.speed - own
    return backs + max(0.0, slower) * asked.ego.time_at(asked.found.route.eventAt)


def _within(way: str, aside: float) -> str:
    """A line so far [m] to the left of a way."""
    return f"{way}.offset({aside:g})" if aside else way


def _through_point(point: str) -> str:
    """The line through a point, beside the ego's lane all along."""
    return f"ownLane(egoRoute).offset(ownLane(egoRoute).project(*{point}.coordinates[:2])[1])"


def _keeps_behind(asked: Asked) -> tuple[float, float] | None:
    """How far [m] behind the ego somebody keeps that follows it first, by what was said or as is usual."""
    first = asked.one.does[0] if asked.one.does else None
    if first is None or first.act not in acts_of(Heads.BEHIND, Heads.CLOSE) or first.whom not in (None, EGO):
        return None
    if first.distance is not None:
        return first.distance.drawn(*asked.numbers.range_of("ROOM" if first.act is Act.FOLLOW else "GAP")[:2])
    drives = asked.one.role is Role.ADVERSARY and not (asked.ego.stands or asked.stands)
    follows = first.act is Act.FOLLOW and drives and not touches(asked.situation, asked.one)
    if follows and all_but_strikes(asked.situation, asked.one):
        asked.numbers.narrow("ROOM", *(max(share * asked.ego.speed, CLOSEST) for share in TOO_CLOSE))
    return asked.numbers.range_of("ROOM")[:2] if follows else None


def _behind(asked: Asked) -> Stand:
    if asked.begins_beside:
        return comes_along(asked)
    close = asked.one.role is Role.ADVERSARY or any(deed.act is Act.TAILGATE for deed in asked.one.does)
    waits = [deed.act for deed in asked.situation.ego.does[:1]] == [Act.STAND]
    if (room := behind_by(asked) or _keeps_behind(asked)) is not None:
        asked.reach(asked.middles + room[0], asked.middles + room[1], "how far behind the ego it is")
    elif (asked.ego.stands or waits) and not asked.stands:
        stops = asked.ego.stands and bool(asked.one.does) and asked.one.does[0].act in STOPS
        braked = asked.ego.speed**2 / asked.numbers.row.limits.brake  # with half its brakes
        stopping = asked.middles + max(0.0, braked - 8.0)
        low, high = (stopping + 8.0, stopping + 13.0) if stops else (28.0 + asked.longer, 45.0 + asked.longer)
        asked.reach(low, high, "how far behind the ego it is")
    elif asked.ego.stands:
        asked.reach(asked.middles + IN_QUEUE[0], asked.middles + IN_QUEUE[1], "how far behind the ego it is")
    elif strikes_from_behind(asked.situation, asked.one) and comes_to_stand(asked.situation):
        stops = 0.5 * asked.ego.speed / STOPPING
        asked.headway(*(stops + after for after in STOOD))  # so that the ego stands when it is there
    elif all_but_strikes(asked.situation, asked.one):
        low, high = (asked.middles + max(share * asked.ego.speed, CLOSEST) for share in TOO_CLOSE)
        asked.reach(low, max(high, low + 0.5), "how far behind the ego it is")
    elif close and _slows_before(asked):
        asked.headway(*HEADWAY)  # so that the ego has slowed down when it is there
    elif close:
        asked.reach(9.0 + asked.longer, 17.0 + asked.longer, "how far behind the ego it is")
    else:
        asked.headway(*CAREFUL)
    stays = asked.situation.ego.route in CHANGES and not goes_with(asked.one)  # and does not change lanes with it
    way = "ownLane(egoRoute)" if stays or beside_lane(asked.situation) else "egoRoute"
    back = max(LEADS_UP, 10.0 * math.ceil(0.1 * (asked.numbers.range_of("Y")[1] + asked.room + ROOM)))
    return Stand(meets=Meets.ALONG, way=f"extended({way}, {back:g})", at=f"{back:g} - $Y{asked.less}", behind=True)


def _slows_before(asked: Asked) -> bool:
    """Whether the ego loses speed by what was said of it, or for whom it meets before who is to strike it does."""
    strikes = strikes_from_behind(asked.situation, asked.one)
    return slows_on_its_way(asked.situation) or (strikes and is_held_up(asked.situation))


BESIDE_TO_STRIKE = {Striker.EGO: (2.5, 5.0), Striker.OTHER: (-2.5, 0.8)}
"""How far [m] ahead of the ego somebody beside it is who comes over, by who runs into whom."""
_INTO = {EgoRoute.LANE_CHANGE_LEFT: Side.LEFT, EgoRoute.LANE_CHANGE_RIGHT: Side.RIGHT, EgoRoute.MERGE: Side.LEFT}


def _changes_to(situation: Situation, side: str) -> bool:
    """Whether the ego changes to the lane on a side."""
    return situation.ego.route is not None and _INTO.get(situation.ego.route) == side


def _next_lane(asked: Asked) -> Stand:
    if asked.begins_beside:
        if asked.one.starts.where is Where.BESIDE and backs(asked.situation) and asked.stands:
            return parked_beside(asked)
        if asked.one.starts.where is Where.BEHIND_BESIDE:
            return comes_along(asked)
        if asked.one.starts.where is Where.AHEAD_BESIDE and asked.side == Side.LEFT and not backs(asked.situation):
            asked.reach(*IN_ITS_LANE, "how far beyond where the ego comes into its lane it is")
            return Stand(meets=Meets.ALONG, at=f"egoRoute.eventAt + $Y{asked.more}")
        raise NothingBuilds(
            f"cannot be built yet: others.{asked.one.id}.starts.where: {asked.one.starts.where} with a parked ego"
        )
    back = asked.one.starts.where is Where.BEHIND_BESIDE
    if asked.walks and not back:
        stand = _over(asked, LANE / 2, asked.side)  # which turns when it crosses
        over = "1.5708" if asked.side == Side.RIGHT else "-1.5708"
        return replace(stand, facing=faces(asked, f"level{{i}}{asked.more}", Facing.ALONG, asked.side), over=over)
    low, high = _level(asked)
    asked.reach(low, high, "how far behind the ego it is" if back else "how far ahead of the ego it is")
    at = f"60 - $Y{asked.less}" if back else f"60 + $Y{asked.more}"
    if asked.rides:
        sign = "-" if asked.side == Side.RIGHT else ""
        return Stand(meets=Meets.ALONG, way=f"extended(straightOn(egoRoute), 60).offset({sign}2.3)", at=at, behind=back)
    if asked.side not in lanes_beside(asked.found.route):
        raise NotBuilt(f"no map has such a place: others.{asked.one.id} needs a lane to the {asked.side} of ours")
    way = lane_beside(asked.side)
    if _filters(asked):
        way = _within(way, between_lanes(asked.side))
    return Stand(meets=Meets.ALONG, way=way, at=at, behind=back)


def _filters(asked: Asked) -> bool:
    """Whether somebody goes between the lanes, since others are in the next one past whom it is to go."""
    others = (one for one in asked.situation.others if one.id != asked.one.id)
    lane = [one.starts for one in others if one.starts.where in NEXT_LANE]
    goes_by = all(deed.act in PLAIN | acts_of(Heads.BY) for deed in asked.one.does)
    taken = any((start.side or asked.one.starts.side) is asked.one.starts.side for start in lane)
    return filters(asked.one) and not asked.stands and goes_by and taken


def _level(asked: Asked) -> tuple[float, float]:
    """How far [m] ahead of the ego, or behind it, somebody in the next lane is, from and to, if that was not said."""
    where, stands = asked.one.starts.where, asked.stands
    if (before := begins_beside(asked.situation, asked.one, asked.middles)) is not None:
        return before
    if where is Where.BESIDE:
        return _beside(asked)
    if (before := so_far_ahead(asked)) is not None:
        low, high = before
    elif where is Where.AHEAD_BESIDE:
        low, high = (38.0 * asked.found.further, 56.0 * asked.found.further) if stands else (8.0, 18.0)
    elif asked.one.role is Role.SUPPORTING and _changes_to(asked.situation, asked.side):
        return asked.middles + CAREFUL[0] * asked.ego.speed, asked.middles + CAREFUL[1] * asked.ego.speed
    elif where is Where.BEHIND_BESIDE and asked.ego.stands and not stands:
        low, high = (min(seconds * asked.ego.speed, FARTHEST) for seconds in COMES_UP)
        return low, max(high, low + 2.0)
    else:
        low, high = 7.0, 16.0
    return low + asked.longer, high + asked.longer


def _beside(asked: Asked) -> tuple[float, float]:
    """How far [m] ahead of the ego somebody level with it is, from and to."""
    if any(deed.act is Act.OVERTAKE for deed in asked.one.does[:1]):
        return -5.0, -0.5  # not yet ahead of it
    if any(deed.act is Act.KEEP_LEVEL for deed in asked.one.does[:1]):
        low, high, *_ = asked.numbers.range_of("LEVEL")
        return low, high
    if (level := level_as_said(asked.situation, asked.one, asked.numbers.row.limits.length)) is not None:
        return level
    contact = asked.situation.contact
    if contact is None or contact.striker is None or not touches(asked.situation, asked.one):
        ahead = min(falls_behind(asked.situation, asked.one, asked.ego.speed) * LEVEL_FOR, LEVEL - 4.5)
        return -2.0 + ahead, 4.5 + ahead
    low, high = BESIDE_TO_STRIKE[contact.striker]
    longer = asked.longer if contact.striker is Striker.EGO else 0.0
    return low + longer, high + longer


LEVEL = 7.5  # [m] ahead of the ego, middle to middle, that somebody is at most who is beside it
LEVEL_FOR = 2.0  # [s] after which who cannot be as fast as the ego has fallen back to be level with it
POINTED = 3.5, 4.5  # [m] behind the junction, of whom a point of the ego's width meets: there it has come about
ON_CROSSWALK = (0.7, 3.3)  # [m] from where a crosswalk begins
IN_DRIVEWAY = (1.5, 3.5)  # [m] from where a driveway begins
IN_BAY = (0.1, 0.4)  # [m] outside the lanes is the end of who stands across the way in a bay of a car park
BEHIND_KERB = 2.0  # [m] farther than at the kerb is who comes out of an alley, on foot or on two wheels
ABREAST = 0.2  # [m] to either side of where it is, who is in a driveway into which another turns
BEFORE_DRIVEWAY = (0.0, 2.0)  # [m] from 6 m before one, where who turns into it begins to
ON_RAILS = (0.6, 0.8)  # [m] from where a track begins


def _against(found: Found) -> str:
    """The way of who comes against the ego in its lane; it does not change lanes with an ego that does."""
    if found.query["maneuver"] not in LANE_CHANGES:
        return "against(egoRoute)"
    return "lastLane(egoRoute)" if found.query.get("opposite") else "against(lastLane(egoRoute))"


def _oncoming(asked: Asked) -> Stand:
    if asked.one.starts.where is Where.ONCOMING and (at_junction(asked.situation) or at_roundabout(asked.situation)):
        return through(asked)
    ours = asked.one.starts.where is Where.ONCOMING_IN_OUR_LANE
    if asked.situation.ego.route is EgoRoute.U_TURN and not ours and asked.rolls and not asked.one.starts.distance:
        return comes_back(asked)
    across = not lanes_beside(asked.found.route).get("left", False)
    if not ours and across and not comes_across(asked.found):
        raise NoSuchPlace(f"no map has such a place: others.{asked.one.id} needs an oncoming lane to the left of ours")
    theirs = "oncomingPath(egoRoute)" if comes_across(asked.found) else 'neighbourPath(egoRoute, "left")'
    way = _against(asked.found) if ours else theirs
    if asked.stands:
        asked.ahead(38, 56)
        return Stand(meets=Meets.TOWARD, way=way, at=f"levelOn(way{{i}}, egoRoute, $Y{asked.more})")
    route = asked.found.route
    if ours and route.route.junction is not None and not asked.ends_straight:
        asked.reach(0.75 * route.eventAt, route.eventAt - SHORT_OF)  # before the junction at which the ego turns off
    else:
        asked.ahead(75, 95)
    stand = Stand(
        meets=Meets.TOWARD,
        way=way,
        at=f"levelOn(way{{i}}, egoRoute, $Y{asked.more})",
        lines=("meet{i} = levelOn(way{i}, egoRoute, egoRoute.eventAt)",),
        left="distanceLeft(way{i}, {first}, meet{i})",
        rolls=asked.rolls and asked.one.kind.row.body.row.motorised,
    )
    if not asked.swings_out or asked.one.starts.distance is not None or not asked.comes:
        return stand
    slow_enough(asked)
    return so_far_back(asked, stand, asked.way_back("egoRoute.eventAt", ""))  # there when the ego swings out


def _walks_at_crosswalk(asked: Asked) -> bool:
    """Whether it crosses on foot where the road has a crosswalk, which nobody said to be elsewhere."""
    crosses = any(deed.act is Act.CROSS for deed in asked.one.does)
    at_side = asked.one.starts.where is Where.ROADSIDE and asked.one.starts.distance is None
    return is_marked(asked.found) and asked.walks and crosses and at_side


def _level_beside(asked: Asked) -> tuple[float, float]:
    """Where [m] along the ego's way somebody beside the road starts, from and to.

    Who goes along the road on foot, off which the ego turns, is there when the ego is.
    """
    way = {Facing.ALONG: -1.0, Facing.AGAINST: 1.0}.get(asked.one.starts.facing or Facing.ACROSS)
    if way is None or asked.stands or not asked.walks or asked.found.query.get("ends") not in ENDS_BESIDE:
        return 34.0 * asked.found.further, 34.0 * asked.found.further + 16.0
    leaves = asked.found.route.eventAt + OFF_LANE
    far = asked.numbers.middle("SPEED") * (asked.ego.time_at(leaves) + asked.ego.late_at(leaves))
    return leaves + way * far - ABOUT, leaves + way * far + ABOUT


def _level_of(asked: Asked) -> str:
    """Where along the ego's way somebody beside the road is: at a crosswalk, at rails, or anywhere.

    Nobody is shifted from the place that was said.
    """
    where = asked.one.starts.where
    if where is Where.CROSSING or _walks_at_crosswalk(asked):
        asked.numbers.held.add("Y")
    if where is Where.EXIT_CROSSING:
        contact = asked.situation.contact
        pointed = contact is not None and contact.at is not None and contact.whom in (None, asked.one.id)
        anywhere = AT_JUNCTION if has_crosswalks(asked.found) else (2, 6)
        asked.reach(*(POINTED if pointed else anywhere), "how far behind the junction it is")
        return "egoRoute.exitAt + $Y"
    if where is Where.CROSSING and at_junction(asked.situation):
        near, far = AT_JUNCTION if has_crosswalks(asked.found) else (1, 4)
        return asked.at_event(-far, -near, "the crosswalk is", "how far before the junction it is")
    if asked.found.query.get("site") == Site.RAIL_CROSSING and not asked.walks:
        return asked.at_event(*ON_RAILS, "the rails are", "how far beyond the first rail it is")
    if where is Where.CROSSING or _walks_at_crosswalk(asked):
        ends = ON_CROSSWALK if is_marked(asked.found) else (-2, 2)
        return asked.at_event(*ends, "the crosswalk is", "how far beyond the crosswalk's edge it is")
    in_driveway = where is Where.DRIVEWAY and asked.found.query.get("site") in DRIVEWAYS.values()
    return _in_driveway(asked) if in_driveway else _anywhere_beside(asked)


def _anywhere_beside(asked: Asked) -> str:
    """Where along the ego's way somebody beside the road is whom nothing there holds to a place."""
    asked.reach(*(_before_nose(asked) if asked.ego.stands else _level_beside(asked)))
    return "shortOfJunction(egoRoute, $Y)"


def _before_nose(asked: Asked) -> tuple[float, float]:
    """Where [m] along its way somebody is who crosses just before an ego that stands all along, from and to."""
    nose = 0.5 * asked.situation.ego.body.row.limits.length
    return nose + BEFORE_NOSE[0], nose + BEFORE_NOSE[1]


def _in_driveway(asked: Asked) -> str:
    """Where along the ego's way a driveway is, which is as far on each route."""
    if asked.one.starts.distance is not None:
        return asked.at_event(*IN_DRIVEWAY, "the driveway is", "how far beyond the driveway's edge it is")
    event, (low, high), laid = asked.found.route.eventAt, IN_DRIVEWAY, asked.found.laid
    if laid is not None and laid.mouth > NARROWEST:  # in its right half, seen from there
        own = laid.mouth * (OUT_AT if asked.side == Side.RIGHT else IN_AT)
        low, high = own - ABREAST, own + ABREAST
    asked.reach(event + low, event + high)
    return "$Y"


def _beside_road(asked: Asked) -> Stand:
    """On foot or on two wheels beside the road, or in a driveway: it faces the road."""
    if backs(asked.situation) and out_of(asked.situation):
        return comes_by(asked)
    if asked.one.starts.where is Where.DRIVEWAY:  # none of it is in the lane, and who is narrow is not at the kerb
        narrow = asked.walks or not asked.one.kind.row.body.row.motorised
        half = 0.5 * asked.numbers.row.limits.length
        if between_bays(asked.found):
            asked.numbers.narrow("X", *(half + end for end in IN_BAY))
        else:
            asked.numbers.move("X", half + (BEHIND_KERB if narrow else 0.0))
    level = _level_of(asked)
    there = f"level{{i}}{asked.more}"
    point = f'besideRoad(egoRoute, {there}, "{asked.side}", $X)'
    if rolls := asked.comes and asked.one.starts.speed is not None and asked.one.starts.facing in (None, Facing.ACROSS):
        point = f'asideOf(egoRoute, {there}, "{asked.side}", {asked.way_back(there, "1 + ")})'
    away = ""
    if asked.backs:
        if not asked.numbers.is_said("SPEED"):
            asked.numbers.narrow("SPEED", *BACKS)
        away = " + 3.14159"
    stand = Stand(
        meets=Meets.ACROSS,
        point=point,
        rolls=rolls,
        facing=faces(asked, there, Facing.ACROSS, asked.side) + away,
        faces=True,
        lines=(f"level{{i}} = {level}",),
        ego_meets="progressOn(egoRoute, self)[0]",
        left="max(0, abs(offsetFrom(egoRoute, self)) - 1)",
        anywhere=level.startswith("shortOf"),
    )
    stand = stand if rolls else slanting(asked, stand, asked.side)
    by = asked.hidden_by
    if by is None or not from_its_lane(asked.situation, by, asked.one):
        return stand
    behind = shadowed(stand, by, by.kind.row.body.row.limits.width)
    if stand.anywhere and asked.one.starts.distance is None and not stands_first(by):
        asked.numbers.move("Y", DRIVES * asked.ego.speed)
    asked.numbers.narrow("X", *(AT_EDGE if behind is stand else IN_SHADOW))
    return behind


def _driveway(asked: Asked) -> Stand:
    turn = None if backs(asked.situation) else turns_out(asked.one)
    return _beside_road(asked) if turn is None else out_of_driveway(asked, turn)


def _kerb(asked: Asked) -> Stand:
    if asked.walks or asked.rides:
        return _beside_road(asked)
    level = asked.at_event(-2, 2, SWINGS_OUT, "how far ahead of the ego it is") if asked.swings_out else "$Y"
    if not asked.swings_out:
        asked.ahead(30, 44)
    if asked.side == Side.RIGHT:
        opens = any(deed.act is Act.OPEN_DOOR for deed in asked.one.does)  # into the lane, at whose edge it is then
        door = 0.5 * asked.numbers.row.limits.width - into_lane(asked.situation)
        edge = f'besideRoad(egoRoute, 20, "right", {door if opens else 1.3:.3g})'
    elif asked.side in {side for side, against in lanes_beside(asked.found.route).items() if not against}:
        edge = f'besideRoad(egoRoute, 20, "{asked.side}", 1.3)'  # beyond the lanes that go the ego's way
    else:
        beside = 'neighbourPath(egoRoute, "left")'
        edge = f"pointOn({beside}, levelOn({beside}, egoRoute, 20), -2.1)"
    against = turns_round_from_opposite(asked.found, asked.one)
    return Stand(
        meets=Meets.KERB,
        way=_through_point(edge),
        at=f"{level}{asked.more}",
        ego_meets="progressOn(egoRoute, self)[0]",
        anywhere=not asked.swings_out,
        turn=math.pi if against else 0.0,
        faces=against,
    )


def _bus_bay(asked: Asked) -> Stand:
    """In a bay beside the lane, some way into it."""
    ends = bus_bay(asked.found.route.network, asked.found.route.route) - 0.5 * asked.numbers.row.limits.length
    level = asked.at_event(6, 14, "in the bay it is", "how far into the bay it is", ends)
    edge = 'besideRoad(egoRoute, egoRoute.eventAt + 10, "right", 1.6)'
    return Stand(
        meets=Meets.KERB,
        way=_through_point(edge),
        at=f"{level}{asked.more}",
        ego_meets="progressOn(egoRoute, self)[0]",
    )


def _exit(asked: Asked) -> Stand:
    asked.reach(6, 14, "how far behind the junction it is")
    return Stand(meets=Meets.ALONG, at=f"egoRoute.exitAt + $Y{asked.more}")


def _median(asked: Asked) -> Stand:
    stand = _over(asked, MEDIAN, Side.LEFT)
    facing = faces(asked, f"level{{i}}{asked.more}", Facing.ACROSS, Side.LEFT)
    return slanting(asked, replace(stand, facing=facing), Side.LEFT)


def _on_ramp(asked: Asked) -> Stand:
    asked.reach(-2, 8)
    ego = asked.ego.speed
    said = asked.numbers.range_of("SPEED")[1] if asked.numbers.is_said("SPEED") else ego
    goes = min(said, Body(asked.numbers.row.limits, asked.walks).fastest)
    free = asked.one.starts.distance is None
    lead = max(0.0, 1.0 - goes / ego) if free else 0.0  # who is slower has so much of a start that both are level then
    return Stand(
        meets=Meets.ALONG,
        way=lane_beside(Side.RIGHT),
        at="60 +" + (f" {lead:.3g} * egoRoute.eventAt +" if lead else "") + f" $Y{asked.more}",
    )


STARTS: dict[Where, Callable[[Asked], Stand]] = {
    Where.AHEAD: _ahead,
    Where.AHEAD_BESIDE: _next_lane,
    Where.BESIDE: _next_lane,
    Where.BEHIND: _behind,
    Where.BEHIND_BESIDE: _next_lane,
    Where.ONCOMING: _oncoming,
    Where.ONCOMING_IN_OUR_LANE: _oncoming,
    Where.ARM: through,
    Where.ROADSIDE: _beside_road,
    Where.KERB: _kerb,
    Where.DRIVEWAY: _driveway,
    Where.CROSSING: _beside_road,
    Where.BUS_BAY: _bus_bay,
    Where.EXIT: _exit,
    Where.EXIT_CROSSING: _beside_road,
    Where.MEDIAN: _median,
    Where.ON_RAMP: _on_ramp,
    Where.IN_ROUNDABOUT: roundabout,
    Where.ROUNDABOUT_ENTRY: roundabout,
}


ON_FOOT = frozenset(
    (Where.AHEAD, Where.AHEAD_BESIDE, Where.BESIDE, Where.ROADSIDE, Where.KERB, Where.DRIVEWAY, Where.CROSSING)
) | {Where.EXIT_CROSSING, Where.MEDIAN}
"""Where somebody on foot can be."""
NEAREST = {Where.OFF_RAMP: f"{Where.AHEAD_BESIDE}, on the right, where the road has {with_article(Feature.OFF_RAMP)}"}
"""For places where nobody is put yet: what can be said in their place."""


def start_of(asked: Asked) -> Stand:
    """Where somebody stands at first.

    Raises:
        NotBuilt: Nobody is placed there yet.
    """
    where = asked.one.starts.where
    if asked.walks and where not in ON_FOOT:
        raise NothingBuilds(
            f"cannot be built yet: others.{asked.one.id}.starts.where: {where} for a pedestrian; the nearest is"
            f" {Where.EXIT_CROSSING if where is Where.ARM else Where.ROADSIDE}"
        )
    if where not in STARTS:
        near = f"; the nearest is {NEAREST[where]}" if where in NEAREST else ""
        raise NothingBuilds(f"cannot be built yet: others.{asked.one.id}.starts.where: {where}{near}")
    if (there := brushed(asked)) is not None:
        return there
    return turned(asked, stands_in_lane(asked) if opens_in_lane(asked) else STARTS[where](asked))
