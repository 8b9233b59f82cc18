"""Who goes on beside the ego, over whose way the ego comes: it is there when the ego is, whatever holds that.

An ego that only turns is timed. One that changes lanes, or that others may hold, is kept up with until it comes over.
So is one in a roundabout, that leaves over the lane outside of its own: on its way to its exit it slows down in bends,
and nobody knows by how much.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from chatscene.build.arriving import EARLIEST, LATEST
from chatscene.build.asked import Meets, stands_first
from chatscene.build.coming import goes_over
from chatscene.build.contact import misses
from chatscene.build.deeds import GO, OWN
from chatscene.build.flank import level_as_said, parts_at_flank
from chatscene.build.place import GOES_OVER, NEXT_LANE
from chatscene.build.timing import Body
from chatscene.errors import NotBuilt
from chatscene.terms.scenario import Site
from chatscene.terms.vocabulary import CHANGES, GOES_ON, LOSES, Act, Heads, Role, Side, Tempo, Where, acts_of

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

_ANSWERS = LOSES | acts_of(Tempo.LIES, Tempo.GAINS, Heads.ASIDE, Heads.SWINGS)
"""What somebody does then over whose way the ego comes."""
_HAS_COME = {True: f"abs(offsetFrom({OWN}, ego)) > 0.3", False: "progressOn(egoRoute, ego)[0] > egoRoute.eventAt"}
"""What is seen of an ego that comes over, by whether it changes lanes."""
_GAINS, _LEAST = 1.4, 1.0  # of the ego's speed, the most, and [m/s] the least of who keeps up with it
LEAVES = 22.0  # [m] before it has left the ring, from where on an ego comes over the lanes outside of its own
_AS_FAST = 0.95, 1.1  # of the ego's speed there, that who is beside it drives on at
_BEHIND = 1.5, 5.0  # [m], nose to tail, that somebody is behind who is to lose speed for an ego that comes over
_AT_ONCE = 0.1, 0.4  # [s] after which it does


def goes_on_beside(actor: Actor) -> bool:
    """Whether somebody goes on, on the side on which the ego goes over its way, and answers to that at most."""
    route, start = actor.ledger.situation.ego.route, actor.one.starts
    beside = actor.stand.meets is Meets.ALONG and start.where in NEXT_LANE and not stands_first(actor.one)
    on, then = actor.deeds[:1], actor.deeds[1:]
    only = all(deed.act in GOES_ON | {Act.GO_STRAIGHT} for deed in on)
    only = only and all(deed.act in GOES_ON | {Act.GO_STRAIGHT} | _ANSWERS for deed in then)
    free = all(deed.when is None and deed.whom is None for deed in on)
    return beside and only and free and route is not None and GOES_OVER.get(route) is start.side


def _must_be_there(actor: Actor) -> bool:
    return actor.one.role is Role.ADVERSARY and goes_on_beside(actor) and not actor.numbers.is_said("SPEED")


def keeps_up(actor: Actor) -> bool:
    """Whether somebody keeps up with the ego until that comes over, since nobody knows when that is."""
    situation, near = actor.ledger.situation, actor.one.starts.where is not Where.AHEAD_BESIDE
    held = situation.ego.route in CHANGES or any(one.starts.where is Where.AHEAD for one in situation.others)
    motorised = actor.one.kind.row.body.row.motorised
    return _must_be_there(actor) and near and held and motorised and bool(actor.deeds) and not actor.stand.rolls


def set_pace(actor: Actor) -> None:
    """Let who only goes on beside the ego be where the ego goes over its way when the ego is there.

    Else it is far off by then, and nothing comes of it. An ego whose speed was not said slows down for who cannot.

    Raises:
        NotBuilt: It is not there, at the speed that was said of it.
    """
    situation, numbers = actor.ledger.situation, actor.numbers
    _check_there(actor)
    if not _must_be_there(actor):
        return
    lengths = actor.limits.length + actor.ego_limits.length
    there, seconds = goes_over(actor.found.route, actor.ego)
    seconds += actor.ego.late or 0.0
    ahead = numbers.middle("Y") * (-1 if actor.stand.behind else 1)
    if misses(actor.ledger.situation, actor.one):
        there += 0.75 * lengths  # by before the ego's nose
    level = level_as_said(situation, actor.one, actor.limits.length)
    spare = 0.25 * lengths  # so that the two are level with it
    if level is not None:
        there, spare = there + 0.5 * sum(level), min(spare, 0.25 * (level[1] - level[0]))
    way = there - ahead
    usual, top = numbers.range_of("SPEED")[1], actor.limits.fastest
    if way > usual * seconds and situation.ego.speed is None:
        actor.given, actor.needs = seconds, way / usual
    needed = min(Body(actor.limits, actor.walks).wish_for(way / seconds), top)
    share = spare / way
    numbers.narrow("SPEED", (1 - share) * needed, min((1 + share) * needed, top))
    if not numbers.is_said("Y"):
        low, high, *_ = numbers.range_of("Y")
        numbers.narrow("Y", max(low, numbers.middle("Y") - spare), min(high, numbers.middle("Y") + spare))
    actor.ledger.take(*parts_at_flank(actor))


def _check_there(actor: Actor) -> None:
    """Hold that who goes on beside an ego that turns over its way, at a speed that was said, is there when the ego is.

    Raises:
        NotBuilt: It is there long before or after.
    """
    said, changes = actor.numbers.is_said("SPEED"), actor.ledger.situation.ego.route in CHANGES
    meets = actor.one.role is Role.ADVERSARY and goes_on_beside(actor)
    if not (said and meets) or changes or len(actor.deeds) > 1 or actor.ego.late is None:
        return
    there, seconds = goes_over(actor.found.route, actor.ego)
    seconds += actor.ego.late
    sign = -1.0 if actor.stand.behind else 1.0
    least, most = sorted(sign * one for one in actor.numbers.range_of("Y")[:2])
    slow, fast = actor.numbers.range_of("SPEED")[:2]
    soonest, latest = (there - most) / fast, (there - least) / slow
    if soonest > seconds + LATEST and actor.ledger.situation.ego.speed is None:  # a slower one is there with it
        actor.given, actor.needs = seconds, latest
    elif latest < seconds - EARLIEST or soonest > seconds + LATEST:
        far = there - 0.5 * (slow + fast) * seconds
        raise NotBuilt(
            f"{actor.path}.does.0: at {3.6 * fast:.0f} km/h it is where we turn across its way after {soonest:.1f} s,"
            f" and we are after {seconds:.1f} s; it would have to start {abs(far):.0f} m"
            f" {'ahead' if far > 0.0 else 'behind'}"
        )


def until_it_comes(actor: Actor) -> Iterator[str]:
    """What somebody does who goes on beside the ego until that comes over its way, if it then does something else."""
    situation = actor.ledger.situation
    comes = _HAS_COME[situation.ego.route in CHANGES]
    if not keeps_up(actor):
        if len(actor.deeds) > 1:
            actor.numbers.narrow("GO_TIME", *_AT_ONCE)
            yield f"{GO} until {comes}"
        return
    lengths = 0.5 * (actor.limits.length + actor.ego_limits.length)
    ahead = f"$Y + {actor.room:g}"
    if any(deed.act in LOSES for deed in actor.deeds):
        low, high = (lengths + gap for gap in _BEHIND)
        actor.numbers.measure("CLOSE", low, high, "m", "how far behind the ego it comes up to it")
        ahead = "-$CLOSE"
    elif misses(actor.ledger.situation, actor.one):
        ahead = f"{1.5 * lengths:.3g}"
    elif actor.stand.behind:
        low, high = level_as_said(actor.ledger.situation, actor.one, actor.limits.length) or (-0.6 * lengths, 0.0)
        actor.numbers.measure("CLOSE", -high, -low, "m", "how far behind the ego it comes up to it")
        ahead = "-$CLOSE"
    top = min(_GAINS * actor.ego_speed, actor.limits.fastest)
    yield f"PaceOnPath({{p}}, ego, {ahead}, {top:.4g}, {_LEAST:g}) until {comes}"
    if all(deed.time is None for deed in actor.deeds):
        actor.numbers.narrow("GO_TIME", *_AT_ONCE)


# In a roundabout


def goes_round_beside(actor: Actor) -> bool:
    """Whether somebody only goes round in a roundabout, in the lane outside of the ego's, over which the ego leaves."""
    one, stand = actor.one, actor.stand
    beside = one.starts.where in (Where.BESIDE, Where.BEHIND_BESIDE) and one.kind.row.body.row.motorised
    outside = beside and (one.starts.side or actor.found.sides.get(one.id)) is Side.RIGHT
    drives = stand.meets is Meets.ALONG and not stand.rolls and not stands_first(one) and bool(actor.deeds)
    goes_on = drives and all(deed.act in GOES_ON and deed.when is None for deed in actor.deeds)
    ring = actor.found.query.get("site") == Site.ROUNDABOUT
    return ring and outside and goes_on and one.role is Role.ADVERSARY


def set_round(actor: Actor) -> None:
    """Let who goes round beside the ego drive on as fast as the ego is there, if its speed was not said."""
    if goes_round_beside(actor) and not actor.numbers.is_said("SPEED"):
        speed = _speed_there(actor)
        actor.numbers.narrow("SPEED", *(share * speed for share in _AS_FAST))


def until_it_leaves(actor: Actor) -> str:
    """What it does until the ego is about to leave the ring."""
    ahead = f"-$Y - {actor.room:g}" if actor.stand.behind else f"$Y + {actor.room:g}"
    top = min(_GAINS * actor.ego_speed, actor.limits.fastest)
    till = f"progressOn(egoRoute, ego)[0] > egoRoute.exitAt - {LEAVES:g}"
    return f"PaceOnPath({{p}}, ego, {ahead}, {top:.4g}, {_LEAST:g}) until {till}"


def _speed_there(actor: Actor) -> float:
    """How fast the ego is [m/s] where it is about to leave the ring, if nothing holds it."""
    return actor.ego.table.speed_at(actor.found.route.exitAt - LEAVES)
