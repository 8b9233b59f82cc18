"""Light, weather and road in a scenario file."""

from __future__ import annotations

import math
import re

from chatscene.imports.given import Given, Refused
from chatscene.imports.stranger_xml import Element
from chatscene.terms.surroundings import Light, Surface, Surroundings, Weather

_FOG = 200.0  # [m] of sight, below which it is foggy
_SLIPPERY = 0.75  # of a dry road's friction


def surroundings_of(actions: Element, given: Given) -> Surroundings:
    """Light, weather and road, as Init tells them.

    Raises:
        Refused: It tells more of the world.
    """
    environment = actions.find("GlobalAction", "EnvironmentAction", "Environment")
    for one in actions.all("GlobalAction"):
        if one.find("EnvironmentAction") is None:
            raise Refused(one.inside[0] if one.inside else one, "of the world only its weather is told in Init")
    if environment is None:
        return Surroundings()
    g = given
    oclock, weather = environment.find("TimeOfDay"), environment.find("Weather")
    light = Light.DAY
    if oclock is not None and (hour := re.search(r"T(\d\d):(\d\d)", g.text(oclock, "dateTime", ""))):
        at = int(hour[1]) + int(hour[2]) / 60
        light = Light.NIGHT if at < 5 or at >= 21 else Light.DUSK if at < 7 or at >= 18 else Light.DAY
    falls = weather.find("Precipitation") if weather else None
    fog = weather.find("Fog") if weather else None
    kind = g.text(falls, "precipitationType", "dry") if falls else "dry"
    sky = {"rain": Weather.RAIN, "snow": Weather.SNOW}.get(kind, Weather.CLEAR)
    if sky is Weather.CLEAR and fog is not None and g.number(fog, "visualRange", "100000") < _FOG:
        sky = Weather.FOG
    road = environment.find("RoadCondition")
    wetness, grip = (g.text(road, "wetness", ""), g.number(road, "frictionScaleFactor", "1")) if road else ("", 1.0)
    known = [surface for surface in Surface if math.isfinite(surface.row.friction)]
    surface = min(known, key=lambda one: abs(one.row.friction - grip)) if grip < _SLIPPERY else Surface.DRY
    if wetness not in ("", "dry") and surface is Surface.DRY:
        surface = Surface.WET
    return Surroundings(light=light, weather=sky, surface=surface)
