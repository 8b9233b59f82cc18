"""Who is behind the ego, and answers to it: it sees that the ego loses speed, and then brakes or swerves."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from chatscene.build.asked import Meets
from chatscene.build.contact import all_but_strikes, is_held_up
from chatscene.build.relations import grip_of
from chatscene.terms.situation import EGO
from chatscene.terms.vocabulary import GOES_ON, LOSES, Act, Heads, Tempo, Where, acts_of

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

REACTS = 0.85  # of the speed that the ego wants: who is behind it sees it brake
REACTS_CLOSE = 0.93  # the same, of who is close to it
ALL_BUT = 1.2  # [m] that is left, about, between the ego and who all but runs into it
STOPS_AT = 7.0  # [m/s²] with which an ego may come to a stand before somebody
ALL_BUT_STANDS = 1.5  # [m/s] of an ego behind which who follows it stops
CLOSING = 1.0  # [m/s] slower than the ego before it, from which on who has braked follows that again
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


def is_late(actor: Actor) -> bool:
    """Whether somebody who follows the ego all but runs into it."""
    drives = actor.stand.meets is Meets.ALONG and not (actor.stand.rolls or actor.ego.stands or actor.walks)
    return drives and all_but_strikes(actor.ledger.situation, actor.one)


def late_for_ego(actor: Actor) -> str:
    """The phase in which who all but runs into the ego goes on as fast as it was, until it can only just stop."""
    hard = min(actor.limits.brake, grip_of(actor.ledger.situation))
    own, ego = f"self.pose[3] * self.pose[3] / {2 * hard:.3g}", f"ego.pose[3] * ego.pose[3] / {2 * STOPS_AT:.3g}"
    room = "headway({p}, self, ego) - (ego.length + self.length) / 2"
    return f"DrivePath({{p}}, {actor.along_speed:.4g}) until {room} < {ALL_BUT:g} + max(0, {own} - {ego})"


def late_then(actor: Actor, k: int) -> Iterator[str]:
    """The same, of who went on in its k-th deed until the ego slows, and loses speed by the next."""
    if goes_until_ego_slows(actor, k) and is_late(actor) and actor.then(k) in LOSES:
        yield late_for_ego(actor)


def closes_up(actor: Actor, k: int, phases: tuple[str, ...], *, last: bool) -> tuple[str, ...]:
    """The phases of who all but runs into the ego: it brakes, closes up as the ego gets on, and stops if it was to.

    Args:
        actor: Who.
        k: The number of its deed.
        phases: How it would follow, or stop, else.
        last: Whether it does nothing then.
    """
    deed = actor.deeds[k]
    follows, stops = deed.act in acts_of(Heads.BEHIND), deed.act in acts_of(Tempo.HALTS) and reacts(actor, k)
    if not (is_late(actor) and last and deed.done_to == EGO and (follows or stops)):
        return phases
    share = "1" if follows else "$BRAKE"
    brakes = f"BrakeOnPath({{p}}, {share}) until self.pose[3] < max(0.3, ego.pose[3] - {CLOSING:g})"
    close = f"PaceOnPath({{p}}, ego, -(ego.length + self.length) / 2 - {ALL_BUT:g}, {actor.along_speed:.4g})"
    if stops:
        return brakes, f"{close} until ego.pose[3] < {ALL_BUT_STANDS:g}", *phases
    return f"{phases[0]} until {ego_slows(actor)}", late_for_ego(actor), brakes, close
