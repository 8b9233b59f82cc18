"""Who is behind the ego, and answers to it: it sees that the ego loses speed, and then brakes or swerves."""

from __future__ import annotations

from typing import TYPE_CHECKING

from chatscene.build.contact import is_held_up
from chatscene.terms.vocabulary import GOES_ON, LOSES, Act, Heads, Where, acts_of

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

REACTS = 0.85  # of the speed that the ego wants: who is behind it sees it brake
REACTS_CLOSE = 0.93  # the same, of who is close to it
LOCKS = (0.3, 0.5)  # [s] that somebody brakes who then swerves round an ego that brakes harder
SLOWED = 0.5  # of its speed, that somebody has left who brakes and then swerves
_ANSWERS = LOSES | acts_of(Heads.ASIDE, Heads.OVER)


def ego_slows(actor: Actor) -> str:
    """When somebody sees that the ego before it loses speed; who is close sees it sooner."""
    close = any(deed.act is Act.TAILGATE for deed in actor.deeds)
    return f"ego.pose[3] < {REACTS_CLOSE if close else REACTS:g} * {actor.ego_speed:.4g}"


def reacts(actor: Actor, k: int) -> bool:
    """Whether the k-th deed of somebody is its answer to an ego that loses speed before it."""
    situation, behind = actor.ledger.situation, actor.one.starts.where is Where.BEHIND
    if not (behind and actor.stand.behind) or actor.stand.rolls or actor.deeds[k].when is not None:
        return False
    loses = is_held_up(situation) or any(deed.act in LOSES for deed in situation.ego.does)
    return loses and actor.deeds[k].act in _ANSWERS


def swerves_slowed(actor: Actor, k: int) -> bool:
    """Whether somebody behind the ego swerves round it when it has lost speed itself."""
    return k > 0 and actor.deeds[k].act is Act.SWERVE and actor.deeds[k - 1].act in LOSES and reacts(actor, k)


def goes_until_ego_slows(actor: Actor, k: int) -> bool:
    """Whether somebody goes on in its k-th deed until the ego loses speed, to which it answers by the next."""
    deed = actor.deeds[k]
    goes = deed.act in GOES_ON | acts_of(Heads.CLOSE) and deed.time is None
    return goes and k + 1 < len(actor.deeds) and reacts(actor, k + 1)
