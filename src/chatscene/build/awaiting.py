"""What the ego waits for: a deed of somebody else, by the phase of that one's plan.

The ego is built before all others, so that an order names the deed at first, and the phase once the plans are there.
For what somebody ahead does from the start it waits until it is near to that one.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

from chatscene.build.coming import Coming
from chatscene.errors import NotBuilt
from chatscene.terms.order import Order
from chatscene.terms.situation import EGO, Deed, Situation

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

UNDER_WAY = 1.0  # [s] after which a deed by which somebody's plan ends is taken for done


def awaited(deed: Deed) -> tuple[str, str] | None:
    """The deed of somebody else that a deed of the ego waits for: ``after`` or ``during``, and which; or None."""
    when = deed.when
    for name, reference in () if when is None else (("after", when.after), ("during", when.during)):
        if reference is not None and not reference.startswith(f"{EGO}."):
            return name, reference
    return None


def waiting(order: Order, name: str, reference: str) -> Order:
    """An order that waits for a deed of somebody else.

    Args:
        order: What begins, or ends, then.
        name: ``after`` or ``during``.
        reference: Which deed.
    """
    return replace(order, whom=reference, phase=1 if name == "after" else 0)


def met_by(who: str, coming: Coming, orders: Iterable[Order]) -> Coming:
    """How the ego gets on before somebody: it stands before whom it waits for, so that nobody waits for the other."""
    waits = any(one.ends and one.at_most <= 0.0 and one.whom.partition(".")[0] == who for one in orders)
    return replace(coming, late=None, stands=True, held=0.0) if waits else coming


def in_phases(orders: Iterable[Order], situation: Situation, actors: Mapping[str, Actor]) -> tuple[Order, ...]:
    """Orders that wait for the phases of plans, of such as wait for deeds.

    Args:
        orders: The ego's.
        situation: What was said.
        actors: All others, with their plans.

    Raises:
        NotBuilt: Somebody has no plan in which the deed begins.
    """
    return tuple(_in_phase(one, situation, actors) if one.phase >= 0 else one for one in orders)


def _in_phase(order: Order, situation: Situation, actors: Mapping[str, Actor]) -> Order:
    who, k = order.whom.partition(".")[0], situation.number_of(order.whom)
    phases = actors[who].begins
    if k >= len(phases) or (phase := phases[k]) < 1:
        if order.within > 0.0:
            return replace(order, whom=who, phase=-1)
        raise NotBuilt(f"cannot be built yet: that the ego waits for {order.whom}, which {who} does from the start")
    order = replace(order, within=0.0)
    if order.phase and k + 1 < len(phases):
        return replace(order, whom=who, phase=phase + 1)
    later = UNDER_WAY if order.phase and not order.ends else 0.0
    return replace(order, whom=who, phase=phase, since=order.since + later, till=order.till + later)
