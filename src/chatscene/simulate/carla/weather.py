"""How light, weather and road look in CARLA, which has no snow or ice, and where tyres hold the same on all roads."""

from __future__ import annotations

from typing import Any

import carla  # pyright: ignore[reportMissingTypeStubs]

from chatscene.terms.surroundings import Light, Surface, Surroundings, Weather

SUN = {Light.DAY: 60.0, Light.DUSK: 2.0, Light.NIGHT: -60.0}  # [degrees] above the horizon; below it street lamps burn
FALLING = 60.0  # [%] of the heaviest rain there is
FOG = 80.0  # [%] of the densest fog
WETNESS = 80.0  # [%]


def weather_of(around: Surroundings) -> Any:
    """What the wheel is asked for; the numbers are chosen by eye from its presets, and move nothing."""
    rain, fog = around.weather is Weather.RAIN, around.weather in (Weather.FOG, Weather.DUST)
    wet = 0.0 if around.surface is Surface.DRY else WETNESS
    return carla.WeatherParameters(
        sun_altitude_angle=SUN[around.light],
        cloudiness=10.0 if around.weather is Weather.CLEAR else 80.0,
        precipitation=FALLING if rain else 0.0,
        precipitation_deposits=wet / 2,
        wetness=wet,
        fog_density=FOG if fog else 0.0,
        fog_distance=0.0,
    )
