"""The ego of a program: the speed it wants, where it begins, and the orders by which it does what was said of it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from chatscene.build.ledger import Ledger
from chatscene.build.place import Found, at_junction
from chatscene.errors import NotBuilt
from chatscene.terms.pace import NOMINAL
from chatscene.terms.situation import Deed
from chatscene.terms.vocabulary import Act, EgoLight, Manner, RightOfWay

LINE = 3.5  # [m] before the junction the centre of an ego stands whose nose is at the line
STAND = 4.0  # [s] that somebody stands who sets off again
SLOW = 3.0  # [m/s]


@dataclass(frozen=True, slots=True, kw_only=True)
class BuiltEgo:
    """What a program says of its ego.

    Attributes:
        params: Lines before the route is chosen.
        speed: What it drives at where nothing holds it [m/s].
        properties: What stands behind its place.
    """

    params: tuple[str, ...]
    speed: float
    properties: str


def ego_of(ledger: Ledger, found: Found, at_most: float = NOMINAL.speed) -> BuiltEgo:
    """What a program says of its ego.

    Args:
        ledger: What was said.
        found: Where it happens.
        at_most: The speed [m/s] that it wants if none was said.

    Raises:
        NotBuilt: It is to do something that no order brings about.
    """
    situation = ledger.situation
    ego, junction = situation.ego, at_junction(situation)
    speed = at_most
    if ego.speed is not None:
        speed = ego.speed.high if ego.speed.high < float("inf") else ego.speed.low
        ledger.take("ego.speed")
    else:  # others are timed by it, so that it is wanted of every ego
        ledger.assume(f"the ego wants {3.6 * speed:.0f} km/h, which was not said")
    wanted = f", with wantedSpeed {speed:.4g}"
    stop = found.route.eventAt - (LINE if junction else 0.0)
    orders = list(_orders(ledger, ego.does, stop, speed))
    stands = bool(ego.does) and ego.does[0].act is Act.STAND
    params = ["param egoStart = 'at-line'"] if stands and junction else []
    params += _lights(ledger, found)
    moving = "" if stands else f", with speed {speed:.4g}"
    given = f", with orders ({', '.join(orders)},)" if orders else ""
    return BuiltEgo(params=tuple(params), speed=speed, properties=moving + wanted + given)


def _lights(ledger: Ledger, found: Found) -> list[str]:
    road = ledger.situation.road
    if road.control is not RightOfWay.SIGNAL and road.ego_light is None:
        return []
    if found.query.get("control") != "signal":
        return []
    lights = {None: "ego-green", EgoLight.GREEN: "ego-green", EgoLight.RED: "ego-red"}
    if road.ego_light not in lights:
        raise NotBuilt(f"nothing builds yet: road.ego_light: {road.ego_light}")
    ledger.take("road.ego_light")
    return [f"param signals = '{lights[road.ego_light]}'"]


def _orders(ledger: Ledger, deeds: tuple[Deed, ...], stop: float, speed: float) -> Iterator[str]:
    for k, deed in enumerate(deeds):
        at, then = f"ego.does.{k}", deeds[k + 1].act if k + 1 < len(deeds) else None
        ledger.take(f"{at}.act")
        if deed.when is not None and deed.when.after is not None and deed.when.after.startswith("ego."):
            ledger.take(f"{at}.when.after")  # its deeds come one after the other
        again = then in (Act.SET_OFF, Act.GO_ALONG, Act.ACCELERATE)
        match deed.act:
            case Act.STAND:
                wait = _seconds(ledger, deed, at)
                yield f"Order(at_most=0, till={wait:g})" if again or deed.time is not None else "Order(at_most=0)"
            case Act.STOP:
                till = max(stop, 0.0) / speed + speed / 6.0 + _seconds(ledger, deed, at)
                braking = _braking(ledger, deed, at, 3.0)
                ending = f", till={till:.1f}" if again or deed.time is not None else ""
                yield f"Order(at_most=0, place={stop:.1f}{braking}{ending})"
            case Act.SLOW_DOWN | Act.BRAKE:
                hard = deed.act is Act.BRAKE
                to = deed.speed.high if deed.speed is not None else 1.0 if hard else SLOW
                if deed.speed is not None:
                    ledger.take(f"{at}.speed")
                braking = _braking(ledger, deed, at, 6.0 if hard else 2.5)
                yield f"Order(at_most={to:.4g}, place={stop:.1f}{braking})"
            case Act.GO_ALONG if deed.manner is Manner.SLOW or deed.speed is not None:
                ledger.take(f"{at}.speed" if deed.speed is not None else f"{at}.manner")
                yield f"Order(at_most={deed.speed.high if deed.speed is not None else SLOW:.4g})"
            case Act.GO_ALONG | Act.SET_OFF | Act.YIELD | Act.FOLLOW:
                pass  # which is left to the ego
            case _:
                raise NotBuilt(f"nothing builds yet: {at}.act: {deed.act}")


def _seconds(ledger: Ledger, deed: Deed, at: str) -> float:
    if deed.time is None:
        return STAND
    ledger.take(f"{at}.time")
    return deed.time.low if deed.time.low > 0 else deed.time.high


def _braking(ledger: Ledger, deed: Deed, at: str, usual: float) -> str:
    if deed.acceleration is None:
        return f", braking={usual:g}"
    ledger.take(f"{at}.acceleration")
    return f", braking={deed.acceleration.within(0.5, max(usual, deed.acceleration.low))[0]:.4g}"
