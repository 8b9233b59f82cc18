"""Light, weather and road in a scenario file."""

from __future__ import annotations

import math
import re

from chatscene.imports.given import Given, Refused
from chatscene.imports.stranger_xml import Element
from chatscene.terms.nouns import with_article
from chatscene.terms.surroundings import Light, Surface, Surroundings, Weather

_FOG = 200.0  # [m] of sight, below which it is foggy
_OVERCAST = frozenset(("sevenOktas", "eightOktas", "overcast"))
"""How much of the sky is covered where it is overcast, as newer and older files say it."""
_FALLS = {"dry": Weather.CLEAR, "rain": Weather.RAIN, "snow": Weather.SNOW}
_ELSEWHERE = frozenset(("EntityAction", "ParameterAction", "VariableAction"))  # what other readers see to
NO_MONITORS = "there are no monitors here"
_SAME = 1e-6  # between frictions
_SLIPPERY = 0.75  # of a dry road's friction


def surroundings_of(actions: Element, given: Given) -> Surroundings:
    """Light, weather and road, as Init tells them.

    Raises:
        Refused: It tells more of the world.
    """
    worlds: list[Element] = []
    for one in actions.all("GlobalAction"):
        inner = one.inside[0] if one.inside else one
        if inner.tag == "EnvironmentAction":
            if inner.find("CatalogReference") is None:  # else its catalog is not there, which is noted
                worlds.append(one)
        elif inner.tag == "SetMonitorAction":
            given.note(inner, NO_MONITORS)
        elif inner.tag not in _ELSEWHERE:
            raise Refused(inner, "of the world only its weather and who is there is told in Init")
    if not worlds:
        return Surroundings()
    if len(worlds) > 1:
        raise Refused(worlds[1], "there is one weather; write one EnvironmentAction")
    environment = worlds[0].find("EnvironmentAction", "Environment")
    if environment is None:
        raise Refused(worlds[0], "its Environment is not there; write it here")
    weather = environment.find("Weather")
    return Surroundings(
        light=_light(environment.find("TimeOfDay"), given),
        weather=_weather(weather, given) if weather else Weather.CLEAR,
        surface=_surface(environment.find("RoadCondition"), given),
    )


def _light(oclock: Element | None, given: Given) -> Light:
    if oclock is None or (hour := re.search(r"T(\d\d):(\d\d)", given.text(oclock, "dateTime", ""))) is None:
        return Light.DAY
    at = int(hour[1]) + int(hour[2]) / 60
    return Light.NIGHT if at < 5 or at >= 21 else Light.DUSK if at < 7 or at >= 18 else Light.DAY


def _weather(weather: Element, given: Given) -> Weather:
    """What falls, or else fog; what of it a scene has not, is noted."""
    falls, fog = weather.find("Precipitation"), weather.find("Fog")
    kind = given.text(falls, "precipitationType", "dry") if falls else "dry"
    strengths = [name for name in ("intensity", "precipitationIntensity") if falls and name in falls.attributes]
    if falls and strengths and not any(given.number(falls, name) for name in strengths):
        kind = "dry"  # nothing falls
    sky = _FALLS.get(kind)
    if falls and kind not in _FALLS:
        given.note(falls, f"{kind[:40]!r} falls in no scene and is left away")
    sight = given.limit(fog, "visualRange") if fog else math.inf
    foggy = sight < _FOG
    if fog and foggy and sky not in (None, Weather.CLEAR):
        given.note(fog, f"a scene has one weather: {sky} is shown, and its fog is left away")
    elif fog and foggy:
        sky = Weather.FOG
        if sight != Weather.FOG.row.sight:
            seen = f"{Weather.FOG.row.sight:g} m, where it says {sight:g} m"
            given.note(fog, f"there is one fog, in which others are seen from {seen}")
    wind = weather.find("Wind")
    if wind and given.number(wind, "speed", "0"):
        given.note(wind, "there is no wind here")
    clouds = given.text(weather, "fractionalCloudCover", given.text(weather, "cloudState", ""))
    if sky in (None, Weather.CLEAR) and clouds in _OVERCAST:
        sky = Weather.OVERCAST
    return sky or Weather.CLEAR


def _surface(road: Element | None, given: Given) -> Surface:
    """The road whose friction is nearest; how far off it is, is noted."""
    if road is None:
        return Surface.DRY
    wetness, grip = given.text(road, "wetness", ""), given.number(road, "frictionScaleFactor", "1")
    known = [surface for surface in Surface if math.isfinite(surface.row.friction)]
    surface = min(known, key=lambda one: abs(one.row.friction - grip)) if grip < _SLIPPERY else Surface.DRY
    if wetness not in ("", "dry") and surface is Surface.DRY:
        surface = Surface.WET
    friction = surface.row.friction if math.isfinite(surface.row.friction) else 1.0
    if abs(friction - grip) > _SAME and not (wetness and grip == 1.0):
        given.note(road, f"a friction of {grip:g} is shown as {with_article(surface.row.said)}, of {friction:g}")
    return surface
