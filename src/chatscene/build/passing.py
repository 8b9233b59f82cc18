"""Who comes against the ego in the lane in which another passes it: it is there when that one is back in its own."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from chatscene.build.actor import Actor
from chatscene.build.asked import Meets
from chatscene.build.chain import in_terms_of
from chatscene.build.deeds import OWN
from chatscene.build.gaps import seconds_to_get_by
from chatscene.build.place import NEXT_LANE, room_against
from chatscene.build.sideways import USUAL
from chatscene.errors import NotBuilt
from chatscene.terms.situation import EGO
from chatscene.terms.vocabulary import Act, Side, Where
from chatscene.world.places import lanes_beside

SPREAD = 5.0  # [m] by which where somebody begins is drawn
BEHIND = 30.0  # [m] of road behind who comes against the ego
_PASSES = NEXT_LANE | {Where.BEHIND}


def come_after_who_passes(actors: Sequence[Actor]) -> None:
    """Let who comes against the ego begin so far off that another which passes it is back before the two meet.

    Raises:
        NotBuilt: No road is so long.
    """
    for actor in actors:
        start = actor.one.starts
        comes = start.where is Where.ONCOMING and actor.stand.meets is Meets.TOWARD and "$Y" in actor.stand.at
        if not comes or start.distance is not None or actor.first is not None:
            continue
        for by, k in _passing(actors):
            actor.phases()
            _begin_at(actor, by, k)


def _passing(actors: Sequence[Actor]) -> Iterator[tuple[Actor, int]]:
    """Those who pass the ego where others come against it, and then come back; with the number of that deed."""
    for actor in actors:
        passes = (k for k, deed in enumerate(actor.deeds) if deed.act is Act.OVERTAKE and deed.whom in (None, EGO))
        k = next(passes, None)
        side = actor.named.get("side") or str(actor.one.starts.side or Side.LEFT)
        against = lanes_beside(actor.found.route).get(side) is not False and side == Side.LEFT
        if k is not None and against and actor.one.starts.where in _PASSES and OWN in " ".join(actor.phases()):
            yield actor, k


def _seconds(actor: Actor, k: int) -> float:
    """After how many seconds [s] somebody who passes the ego in its k-th deed is back in the ego's lane."""
    return actor.numbers.middle("STEADY") + seconds_to_get_by(actor, k) + USUAL


def _begin_at(actor: Actor, by: Actor, k: int) -> None:
    """Let somebody begin so far off that it comes to who passes the ego in its k-th deed once that is back."""
    lengths = 0.5 * (by.ego_limits.length + actor.limits.length) + by.limits.length
    comes = actor.numbers.range_of("SPEED")[1]

    def needed() -> float:
        seconds = _seconds(by, k)
        return (by.ego_speed + comes) * seconds + lengths + by.numbers.middle(f"AHEAD_{k}")

    usual = 0.5 * (needed() + _at_slowest(by, f"FAST_{k}", needed))  # it takes more than in proportion longer then
    low, _, unit, meaning = actor.numbers.range_of("Y")
    if low >= usual + SPREAD:
        return
    actor.takes = max(actor.takes, usual + SPREAD + BEHIND)
    most = room_against(actor.found.route)
    if most < usual and actor.found.route.line.length > usual:
        raise NotBuilt(
            f"others.{actor.one.id}: the road leads {most:.0f} m ahead; {by.one.id} is back in our lane after"
            f" {_seconds(by, k):.0f} s, when {actor.one.id} would have to have begun {usual:.0f} m ahead"
        )
    actor.numbers.measure("Y", usual, usual + SPREAD, unit, meaning)
    middle = needed()
    more = in_terms_of(by.numbers, ("$STEADY", f"$FAST_{k}", f"$AHEAD_{k}", "$Y"), lambda: needed() - middle)
    actor.stand = replace(actor.stand, at=actor.stand.at.replace("$Y", f"$Y {by.filled(more)}"))


def _at_slowest(actor: Actor, name: str, metres: Callable[[], float]) -> float:
    """A distance [m] where a parameter is the least."""
    kept = actor.numbers.range_of(name)
    actor.numbers.narrow(name, kept[0], kept[0])
    far = metres()
    actor.numbers.ranges[name] = kept
    return far
