"""Who goes round in the lane outside of the ego's, and stays in the roundabout: level with it until it leaves.

It is at its exit that an ego meets who is beside it there; on its way to that it slows down in bends, and nobody knows
by how much.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from chatscene.build.asked import Meets, stands_first
from chatscene.terms.scenario import Site
from chatscene.terms.vocabulary import GOES_ON, Role, Side, Where

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

LEAVES = 22.0  # [m] before it has left the ring, from where on an ego comes over the lanes outside of its own
_GAINS, _LEAST = 1.4, 1.0  # of the ego's speed, the most, and [m/s] the least of who keeps level with it
_AS_FAST = 0.95, 1.1  # of the ego's speed there, that who is beside it drives on at


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
