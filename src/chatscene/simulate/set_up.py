"""What a scene that was set up says of itself: what its ego sees, wants and is held to, and who everybody is."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chatscene.ego.observation import RouteView
from chatscene.errors import ProgramError, no_such
from chatscene.simulate.contact import touch
from chatscene.simulate.roadside import RouteSurroundings
from chatscene.terms.episode import Role
from chatscene.terms.order import Order
from chatscene.terms.route import Route
from chatscene.terms.scene import ScenicProgram
from chatscene.world.bodies import Body


def view_of(
    observation: str, route: Route, around: RouteSurroundings, program: ScenicProgram, grip: float
) -> tuple[NDArray[np.float64] | None, RouteView]:
    """The speeds allowed on a route, where a preset shows them, and the ego's view of it; `grip` in m/s²."""
    room = around.room if observation in ("road", "traffic") else None
    allowed = around.allowed(keeps_limits=program.keeps_limits, grip=grip) if observation == "traffic" else None
    return allowed, RouteView(route.line, room, allowed)


def check_wanted(ego: Any, program: ScenicProgram, label: str) -> None:
    """Hold that what is wanted of the ego's speed is what is read in the program's text.

    Raises:
        ProgramError: It is computed, or no number.
    """
    own = not program.drawn
    wanted, keeps = (getattr(ego, "wantedSpeed", None), getattr(ego, "keepsLimits", False)) if own else (None, False)
    if wanted != program.wanted_speed:
        raise ProgramError(
            f"{label} fails: `with wantedSpeed` takes a plain number of metres per second and stands where the ego is "
            f"placed, as in `ego = new Car …, with wantedSpeed 20`, not {wanted!r}"
        )
    if keeps is not program.keeps_limits:
        raise ProgramError(
            f"{label} fails: `with keepsLimits` takes `True` or `False` and stands where the ego is placed, as in "
            f"`ego = new Car …, with wantedSpeed 20, with keepsLimits True`, not {keeps!r}"
        )


def orders_of(ego: Any, label: str) -> tuple[Order, ...]:
    """What a program orders the ego under test; nothing, in one for another world model.

    Raises:
        ProgramError: It is no order.
    """
    orders = getattr(ego, "orders", ())
    if not isinstance(orders, tuple) or not all(isinstance(order, Order) for order in orders):
        raise ProgramError(f"{label} fails: `with orders` takes orders, as in `(Order(at_most=0),)`, not {orders!r}")
    return orders


def awaited_by(orders: tuple[Order, ...], objects: list[Any], bodies: list[Body], label: str) -> dict[int, Body]:
    """For each order that waits for somebody, by its number, who that is.

    Raises:
        ProgramError: There is nobody of that label.
    """
    labels = {getattr(one, "label", ""): body for one, body in reversed(list(zip(objects, bodies, strict=True)))}
    found = {number: labels.get(order.whom) for number, order in enumerate(orders) if order.whom}
    if None in found.values():
        raise ProgramError(f"{label} fails: an order waits for somebody whose label nobody has")
    return {number: body for number, body in found.items() if body is not None}


TOLD_ROLES = (Role.ADVERSARY, Role.BACKGROUND, Role.OCCLUDER)


def names_of(objects: list[Any], drawn: bool) -> list[tuple[str, Role]]:
    """A unique name and the role of each object: the ego comes first, whoever runs `AdvBehavior` is the adversary.

    Who has a `role` is what that says, under its own label.

    In a program that was not written for our world model, that is whoever acts; where nobody does, whatever there is.
    """
    acting = [obj for obj in objects[1:] if obj.behavior is not None]
    adversaries = acting or objects[1:]
    named: list[tuple[str, Role]] = []
    seen: dict[str, int] = {}
    for i, obj in enumerate(objects):
        own = getattr(obj, "label", "") or type(obj).__name__.lower()
        if i == 0:
            name, role = "ego", Role.EGO
        elif drawn and obj in adversaries:
            name, role = own, Role.ADVERSARY
        elif told := getattr(obj, "role", ""):
            if told not in TOLD_ROLES:
                raise ProgramError(no_such("role", str(told), TOLD_ROLES))
            name, role = own, Role(told)
        elif type(obj.behavior).__name__ == "AdvBehavior":
            name, role = "adversary", Role.ADVERSARY
        elif obj.behavior is not None:
            name, role = own, Role.BACKGROUND
        else:
            name, role = own, Role.OCCLUDER
        seen[name] = seen.get(name, 0) + 1
        named.append((name if seen[name] == 1 else f"{name}-{seen[name]}", role))
    return named


def overlap(objects: list[Any], bodies: list[Body], names: list[tuple[str, Role]]) -> str:
    """Which two actors stand in each other at the start and may not, in words; empty if none do."""
    for (i, a), (j, b) in itertools.combinations(enumerate(bodies), 2):
        if touch(a, b) and not (objects[i].allowCollisions or objects[j].allowCollisions):
            return f"{names[j][0]} overlaps {names[i][0]} at the start"
    return ""
