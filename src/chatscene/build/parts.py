"""What somebody has with it and lets go: a load that it drops onto the road, a door that it opens into the lane.

Each is a body of its own. Until its deed is due it does nothing but be carried: it waits for all that whoever has it
waits for, phase by phase.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from chatscene.build.asked import Meets
from chatscene.build.doors import away, door_side
from chatscene.build.naming import name_of
from chatscene.errors import NotBuilt, NothingBuilds
from chatscene.terms.actors import LIMITS
from chatscene.terms.scene import CAR
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import LETS_GO, Act, Side, Where

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

OPENS = 1.5  # [m/s] that a door comes out
HINGE = 0.8  # [m] ahead of the middle of a car that its front door is hinged
_ENDS = re.compile(r" (until|for) .*$", re.DOTALL)


@dataclass(frozen=True, slots=True, kw_only=True)
class Part:
    """What is let go by an act.

    Attributes:
        scenic: The class of the world that it is.
        told: What is told of it; ``{}`` is whose it is.
    """

    scenic: str
    told: str


BUILT_AS = {
    Act.OPEN_DOOR: Part(scenic="Door", told="the door of {} slides out, and does not swing"),
    Act.DROP_LOAD: Part(scenic="Load", told="the load of {} slides to a stand on the road"),
}
"""As what is built what is let go, by the act."""


def parts_of(actor: Actor, sign: str, apart: float) -> Iterator[str]:
    """The lines of a program for all that somebody lets go; of several in a row each does.

    Args:
        actor: Who.
        sign: Whether the next in its row is farther along its way (``+``) or less far (``-``).
        apart: How far that is from it [m].

    Raises:
        NotBuilt: It cannot be let go from there.
    """
    for k, deed in enumerate(actor.deeds):
        if (part := BUILT_AS.get(deed.act)) is None:
            continue
        opens = deed.act is Act.OPEN_DOOR
        earlier = sum(other.act is deed.act for other in actor.deeds[:k])
        for n in range(actor.count):
            one = name_of(actor.one.id) + (f"_{n}" if n else "")
            called, number = f"{one}_{LETS_GO[deed.act]}_{k}", earlier * actor.count + n
            does = _opens(actor, k) if opens else _dropped(actor, k, one)
            yield f"behavior Does{called}():"
            yield from (f"    do {text}" for text in does)
            label = f"{actor.one.id}-{LETS_GO[deed.act]}" + (f"-{number + 1}" if number else "")
            place = _beside(actor) if opens else _behind(actor, f" {sign} {n * apart:g}" if n else "")
            yield (
                f"{called} = new {part.scenic} at {place}, with label '{label}'{actor.role()}"
                f"{'' if opens else actor.moving(actor.phases())}, with behavior Does{called}()"
            )
        actor.ledger.assume(part.told.format(actor.one.id))


def _dropped(actor: Actor, k: int, one: str) -> Iterator[str]:
    """What a load does: it is carried by one until that lets it go in its k-th deed, and slides to a stand."""
    way = f"way{name_of(actor.one.id)}"
    meanwhile = f"PaceOnPath({way}, {one}, {_carried(actor):.3g}, 60)"
    yield from (_waits(text, meanwhile, one) for text in actor.phases()[: actor.begins[k]])
    yield f"BrakeOnPath({way})"


def into_lane(situation: Situation) -> float:
    """How far [m] somebody stands in the ego's lane whose door is to reach the ego: as near to its side as to a car's.

    Beside a car it stands at the edge of the lane; beside what is wider, as far outside that.
    """
    return 0.5 * (LIMITS[CAR].width - situation.ego.body.row.limits.width)


def _waits(text: str, meanwhile: str, one: str) -> str:
    """A phase of whoever has it, as that which is carried waits it out."""
    end = _ENDS.search(text)
    if end is None:
        raise NotBuilt(f"cannot be built yet: what {one} releases after {text.partition('(')[0]}")
    return meanwhile + re.sub(r"\bself\b", one, end[0])


def _carried(actor: Actor) -> float:
    """How far [m] ahead of the middle of who has it a load is: at its tail."""
    return 0.5 * (LIMITS["Load"].length - actor.limits.length)


def _opens(actor: Actor, k: int) -> tuple[str, ...]:
    """What a door does: it waits until it is opened.

    Raises:
        NotBuilt: It does not reach the ego's lane.
    """
    at_left = actor.one.starts.where is Where.KERB and actor.one.starts.side is not Side.RIGHT
    if actor.stand.meets is not Meets.KERB or at_left or actor.count > 1:
        raise NothingBuilds(
            f"cannot be built yet: {actor.path}.does.{k}: open-door, except by a vehicle that stands at the right"
            " kerb or in a lane"
        )
    if actor.deeds[k].to is away(actor.one):
        raise NotBuilt(f"{actor.path}.does.{k}.to: {actor.deeds[k].to}: that door opens away from our lane")
    door = LIMITS["Door"]
    out = 0.5 * (actor.limits.width + door.length) - OPENS**2 / (2.0 * door.brake)
    there = f"abs(offsetFrom(way{name_of(actor.one.id)}, self)) > {out:.3g}"
    one = name_of(actor.one.id)
    waits = (_waits(text, "Halt()", one) for text in actor.phases()[: actor.begins[k]])
    return *waits, f"MoveAhead({OPENS:g}) until {there}", "Halt()"


def _behind(actor: Actor, further: str) -> str:
    """Where a load is at first, of one so much further on in its row."""
    way, at = f"way{name_of(actor.one.id)}", actor.filled(actor.stand.at) + further
    return f"pointOn({way}, {at} + {_carried(actor):.3g}), facing directionOn({way}, {at})"


def _beside(actor: Actor) -> str:
    """Where a door is at first."""
    way, at = f"way{name_of(actor.one.id)}", actor.filled(actor.stand.at)
    sign = 1 if door_side(actor.one) is Side.LEFT else -1
    aside = sign * 0.5 * (actor.limits.width - LIMITS["Door"].length)
    facing = f"directionOn({way}, {at} + {HINGE:g}, {sign * 1.5708:g})"
    return f"pointOn({way}, {at} + {HINGE:g}, {aside:.3g}), facing {facing}"
