"""Who comes driving: so far back on its way as it starts that it is where the ways meet when the ego is."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from chatscene.build.asked import Asked, Meets, Stand, passes_with
from chatscene.build.chain import in_terms_of
from chatscene.build.coming import Coming
from chatscene.build.deeds import GO
from chatscene.build.numbers import Numbers
from chatscene.build.place import AT_JUNCTION, Found, arm_of, at_roundabout, from_left, ring_arms, room_against, ways_of
from chatscene.build.timing import Body, Course, Meeting, course
from chatscene.errors import NoSuchPlace, NotBuilt
from chatscene.maps.crossings import MEETING, CrossingPath, conflicting_paths, passing_path
from chatscene.maps.ring_ways import ROUND
from chatscene.maps.ways_off import ways_out
from chatscene.terms.scenario import Maneuver
from chatscene.terms.situation import Other, Situation
from chatscene.terms.vocabulary import Act, Heads, Side, Where, acts_of
from chatscene.world.control import curve_speeds
from chatscene.world.places import lastLane, ownLane, ringTraffic, trafficFrom, wayOf

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

EARLIEST, LATEST = 1.5, 1.5  # [s] sooner or later than the ego at most, of whom a distance or a speed was said
FAR_OFF = 1.4, 1.8  # of the ego's speed: who comes so fast is so far off that who waits before it hides it
AT_MOUTH, INSIDE = (0.5, 2.0), (4.0, 8.0)  # [m] from the road to the nose of who waits in a driveway, or comes out
AT_LINE = 1.0, 3.0  # [m] before the junction, from nose to line, that somebody stands who waits there
THROUGH = acts_of(Heads.THROUGH)
_HALF_TURN = 14.0  # [m] of turning round
_ROUNDS = 6  # in which a way back is found


def through(asked: Asked) -> Stand:
    """On an arm of the ego's junction, or of its roundabout."""
    if from_left(asked.situation, asked.one):
        return comes_along(asked)
    if at_roundabout(asked.situation):
        return roundabout(asked)
    arm = arm_of(asked.situation, asked.one, asked.found.sides)
    turn = _turn(asked.situation, asked.found, asked.one, arm)
    found = way_through(asked.situation, asked.found, asked.one)
    assert found is not None  # or the place would not have been found
    way = f'wayOf(trafficFrom(egoRoute, "{arm}"), "{turn}"{_lane(asked.situation, asked.one, text=True)})'
    if _lane(asked.situation, asked.one) and not asked.numbers.is_said("SPEED"):
        fast = asked.numbers.row.limits.fastest
        asked.numbers.narrow("SPEED", *(min(share * asked.ego.speed, fast) for share in FAR_OFF))
    if not _meets(asked.found, arm, turn):
        way = "opposite(egoRoute)"
    return _on_its_way(asked, way, found, f"maximum(2, way{{i}}.entry - $Y{asked.less})")


def out_of_driveway(asked: Asked, turn: Maneuver) -> Stand:
    """In a driveway out of which it turns onto the road: some way inside, so that it does not stop at its mouth.

    Raises:
        NotBuilt: The road has no driveway there, or nobody who turns so crosses the ego's way.
    """
    route, side = asked.found.route, asked.side
    ways = {way.turn: way for way in ways_out(route.network, route.route, side)}
    if (found := ways.get(turn)) is None:
        raise NoSuchPlace(
            f"no map has such a place: others.{asked.one.id} needs a driveway on our {side} from which its"
            f" {turn} crosses our way"
        )
    half = 0.5 * asked.numbers.row.limits.length
    near, far = (half + end for end in (AT_MOUTH if asked.stands else INSIDE))
    deepest = found.entry - 1.0
    asked.numbers.measure("Y", min(near, deepest - 0.5), min(far, deepest), "m", "how far from the road its middle is")
    level = route.line.project(*found.line.point_at(0.0))[0] - route.eventAt
    return Stand(
        meets=Meets.THROUGH,
        way=f'wayOf(outOfDriveway(egoRoute, "{side}"), "{turn}")',
        at="maximum(1, way{i}.entry - $Y)",
        lines=(
            "meet{i} = way{i}.meets_at",
            "egoMeet{i} = way{i}.ego_meets_at",
            f"level{{i}} = egoRoute.eventAt + {level:.3g}",
        ),
        ego_meets="egoMeet{i}",
        left="distanceLeft(way{i}, {first}, meet{i})",
        found=found,
    )


def way_through(situation: Situation, found: Found, one: Other) -> CrossingPath | None:
    """The way of somebody through the ego's junction; None where nobody from there comes so.

    Who comes from the arm opposite and goes straight on need not come over the ego's way.
    """
    arm = arm_of(situation, one, found.sides)
    turn = _turn(situation, found, one, arm)
    if _meets(found, arm, turn):
        return wayOf(trafficFrom(found.route, arm), turn, _lane(situation, one))
    passes = arm == "oncoming" and turn is Maneuver.STRAIGHT
    return passing_path(found.route.network, found.route.route) if passes else None


def _turn(situation: Situation, found: Found, one: Other, arm: str) -> Maneuver:
    """What somebody from an arm does: the first of what it may do that leads over the ego's way."""
    ways = ways_of(situation, one, arm)
    return next((way for way in ways if _meets(found, arm, way)), ways[0])


def _meets(found: Found, arm: str, turn: Maneuver) -> bool:
    """Whether somebody from an arm comes over the ego's way by a turn."""
    paths = conflicting_paths(found.route.network, found.route.route)
    return any((path.from_side, path.turn) == (arm, turn) for path in paths)


def _lane(situation: Situation, one: Other, *, text: bool = False) -> str:
    """The lane in which somebody comes who is hidden by another beside it; empty for any."""
    by = situation[one.hidden_by] if one.hidden_by is not None else None
    if by is None or passes_with(by, one) or not by.starts.where is one.starts.where is Where.ONCOMING:
        return ""
    return ', "outer"' if text else "outer"


def roundabout(asked: Asked) -> Stand:
    """In the ego's roundabout, or on its way into that."""
    arms = ring_arms(asked.one, asked.found.sides)
    found = ringTraffic(asked.found.route, *arms)
    circles = found.from_side != ROUND and found.turn is not Maneuver.STRAIGHT
    if circles and any(deed.act in THROUGH for deed in asked.one.does):
        raise NotBuilt(
            f"others.{asked.one.id}: from there straight on, it leaves the roundabout before it meets"
            f" the ego; say {Act.GO_ALONG}, which stays in the roundabout"
        )
    way = f"ringTraffic(egoRoute, {', '.join(repr(arm) for arm in arms)})"
    waits = (
        f"meet{{i}} - $Y{asked.less}" if found.from_side == ROUND else f"maximum(2, way{{i}}.entry - $Y{asked.less})"
    )
    return _on_its_way(asked, way, found, waits)


def _on_its_way(asked: Asked, way: str, found: CrossingPath, waits_at: str) -> Stand:
    """On a way that meets the ego's: driving from the first, so far back that it is there in time, else waiting."""
    nose = 0.5 * asked.one.kind.row.body.row.limits.length
    crossed = any(one.starts.where is Where.EXIT_CROSSING for one in asked.situation.others)
    line = nose + (AT_JUNCTION[1] if crossed else 0.0)  # before the crosswalk that somebody crosses
    near, far = (line + AT_LINE[0], line + AT_LINE[1]) if asked.stands else (10, 25)
    asked.reach(near, far, "how far before the junction it is")
    stand = Stand(
        meets=Meets.THROUGH,
        way=way,
        at=waits_at,
        lines=("meet{i} = way{i}.meets_at", "egoMeet{i} = way{i}.ego_meets_at"),
        ego_meets="egoMeet{i}",
        left="distanceLeft(way{i}, {first}, meet{i})",
        found=found,
    )
    said = asked.one.starts
    drives = asked.rolls and said.speed is not None  # and so does not wait before the junction, whatever it then does
    if not (asked.comes or drives) or (said.distance is not None and said.speed is None):
        return stand
    seconds = asked.ego.time_at(found.ego_meets_at) + asked.ego.late_at(found.ego_meets_at)
    if said.distance is not None:
        return replace(stand, rolls=_in_time(asked, found, seconds))
    (low, high), most = asked.numbers.range_of("SPEED")[:2], found.meets_at / (seconds + LATEST)
    if high > most:
        if asked.numbers.is_said("SPEED") and asked.one.hidden_by is None:
            raise NotBuilt(
                f"others.{asked.one.id}: the road that it comes from is too short for more than {most:.1f} m/s"
            )
        if low > most or asked.numbers.is_said("SPEED"):  # it waits where it is hidden
            return stand
        asked.numbers.narrow("SPEED", low, most)
    return replace(so_far_back(asked, stand, way_back(asked.one, asked.numbers, asked.ego, found)), rolls=True)


def so_far_back(asked: Asked, stand: Stand, metres: str) -> Stand:
    """The same, so far back from where it meets the ego; who is in a row stands behind the first of that."""
    if asked.first is not None:
        return replace(stand, at=f"back{{row}}{asked.less}")
    back = f"back{{i}} = backFrom(meet{{i}}, {metres})"
    return replace(stand, at="back{i}", lines=(*stand.lines, back))


def way_back(one: Other, numbers: Numbers, ego: Coming, found: CrossingPath, does: Sequence[str] = (GO,)) -> str:
    """How far [m] somebody has to where it meets the ego, as fast as it is on its way: slower in curves and in time.

    Args:
        one: Who.
        numbers: Its parameters.
        ego: How the ego gets on.
        found: Its way.
        does: The phases in which it comes.
    """
    body = Body(one.row.limits, walks=False)
    seconds = ego.time_at(found.ego_meets_at) + ego.late_at(found.ego_meets_at)
    caps = curve_speeds(found.line)

    def later() -> float:
        speed = numbers.middle("SPEED")
        metres = speed * seconds
        for _ in range(_ROUNDS):
            begins = found.meets_at - metres
            meeting = Meeting(
                metres=metres, beyond=MEETING, allowed=lambda gone, at=begins: caps[found.line.segment_at(at + gone)]
            )
            takes = course(does, numbers, body, Course(speed=speed), meeting).met
            if takes < 0.0:  # it stands before it is there
                return metres / speed - seconds
            metres = max(metres + speed * (seconds - takes), 1.0)
        return metres / speed - seconds

    slower = in_terms_of(numbers, ("$SPEED", *(text for text in does if text != GO)), later)
    return f"$SPEED * ({ego.seconds('egoMeet{i}', found.ego_meets_at)} {slower} - $OFFSET)"


def back_by_deeds(actor: Actor, bodies: Sequence[Sequence[str]]) -> None:
    """Let who comes through a junction and changes its speed on the way begin so far back that it is there in time."""
    found = actor.stand.found
    kept = [line for line in actor.stand.lines if not line.startswith("back{i} = ")]
    if found is None or not actor.stand.rolls or len(kept) == len(actor.stand.lines):
        return
    does = (*(text for body in bodies for text in body), GO)
    back = f"back{{i}} = backFrom(meet{{i}}, {way_back(actor.one, actor.numbers, actor.ego, found, does)})"
    actor.stand = replace(actor.stand, lines=(*kept, back))


def _in_time(asked: Asked, found: CrossingPath, seconds: float) -> bool:
    """Whether who comes from so far at such a speed is where the ways meet when the ego is.

    Raises:
        NotBuilt: It is there much sooner or later.
    """
    (near, far), (low, high) = (asked.numbers.range_of(name)[:2] for name in ("Y", "SPEED"))
    within = found.meets_at - found.entry
    soonest, latest = (near + within) / high, (far + within) / low
    if latest < seconds - EARLIEST or soonest > seconds + LATEST:
        raise NotBuilt(
            f"others.{asked.one.id}.starts.distance: {asked.one.starts.distance}: at that speed it reaches the place"
            f" where they meet after {soonest:.1f} s, the ego after {seconds:.1f} s; it would have to start"
            f" {max(seconds * low - within, 0.0):.0f} to {seconds * high - within:.0f} m before the junction"
        )
    return True


def comes_along(asked: Asked) -> Stand:
    """In the lane that the ego comes into, from behind: where the ego is in it when it is."""
    if asked.side == Side.RIGHT or not asked.rolls or asked.one.starts.distance is not None:
        raise NotBuilt(
            f"cannot be built yet: others.{asked.one.id}.starts, with an ego that comes from beside its lane: only a"
            " moving vehicle in that lane, without a stated distance, can be timed"
        )
    stand = Stand(
        meets=Meets.ALONG,
        way="wholeLane(egoRoute)",
        lines=("meet{i} = levelOn(way{i}, egoRoute, egoRoute.eventAt)",),
        left="distanceLeft(way{i}, {first}, meet{i})",
        behind=True,
        rolls=True,
    )
    return so_far_back(asked, stand, asked.way_back("egoRoute.eventAt", ""))


def comes_back(asked: Asked) -> Stand:
    """In the lane that the ego turns round into, there when the ego is."""
    level, at = f"egoRoute.eventAt + {_HALF_TURN:g}", asked.found.route.eventAt + _HALF_TURN
    stand = Stand(
        meets=Meets.TOWARD,
        way="lastLane(egoRoute)",
        lines=(f"meet{{i}} = levelOn(way{{i}}, egoRoute, {level})",),
        left="distanceLeft(way{i}, {first}, meet{i})",
        rolls=True,
    )
    _on_the_road(asked, lastLane(asked.found.route).project(*asked.found.route.line.point_at(at))[0], at)
    return so_far_back(asked, stand, asked.way_back(f"({level})", ""))


def slow_enough(asked: Asked) -> None:
    """Let who comes against an ego that swings out be no faster than the road behind it is long for.

    Raises:
        NotBuilt: It was said to be.
    """
    route = asked.found.route
    room = room_against(route) or ownLane(route).length  # the ego's own lane, where none of the others' lies beside it
    _on_the_road(asked, room - route.eventAt, route.eventAt)


def _on_the_road(asked: Asked, room: float, meets_at: float) -> None:
    """Let somebody be no faster than the road is long on which it comes.

    Args:
        asked: Who.
        room: How long that is [m], to where the two meet.
        meets_at: Where that is on the ego's way [m].

    Raises:
        NotBuilt: It was said to be faster.
    """
    most = room / (asked.ego.time_at(meets_at) + asked.ego.late_at(meets_at) + LATEST)
    low, high, *_ = asked.numbers.range_of("SPEED")
    if low <= most:
        asked.numbers.narrow("SPEED", low, min(high, most))
    elif asked.numbers.is_said("SPEED"):
        raise NotBuilt(f"others.{asked.one.id}: the road that it comes from is too short for more than {most:.1f} m/s")
    else:
        asked.numbers.narrow("SPEED", 0.85 * most, most)
