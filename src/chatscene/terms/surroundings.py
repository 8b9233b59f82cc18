"""What surrounds a scene: light, weather and the state of the road. The one table of each: words, and what follows.

Of a condition only what drives show is a number: how far others are seen, and how well the road holds.

*Friction* is the largest share of its weight that a body can push, brake or steer with. Textbooks on vehicle dynamics
give as peak values 0.5 to 0.7 on wet asphalt, 0.2 on packed snow and 0.1 on ice (J. Y. Wong, "Theory of Ground
Vehicles", table of road adhesion; second hand), a maker of tyres 0.45 to 0.55 on wet asphalt, 0.25 to 0.35 on packed
snow and 0.05 to 0.15 on ice (bohnenkamp.by, "Koeffitsienty stsepleniya shin"). UN R13-H calls a road one of low
adhesion up to 0.3. Ours lie between. On a dry road bodies do what the table of road users says, which is of a dry road.

*Sight*: a pedestrian in dark clothes is seen from 25 m in headlights at night, in light ones from 40 to 80 m (Deutscher
Verkehrssicherheitsrat, as newspapers quote it); vehicles and cycles have lamps, which the law asks of them, and are
seen as by day. Fog is such as the rear fog lamp is for, which German law (StVO, section 17) allows below 50 m; 40 m is
our choice. At dusk, in rain and in snowfall others are seen farther than any ego here looks (50 m).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, fields
from enum import StrEnum
from typing import Self, TypeVar

from chatscene.errors import ProgramError, no_such

GRAVITY = 9.81  # [m/s²]
DRY = 0.9  # friction coefficient of dry asphalt, of which 0.8 to 1.0 are published


@dataclass(frozen=True, slots=True, kw_only=True)
class Condition:
    """What holds of a light, a weather or a state of the road.

    Attributes:
        words: Regular expression of the words that name it.
        sight: How far others are seen [m].
        unlit: How far those are seen who carry no lamps [m].
        friction: Coefficient of the road; infinite where it is not what limits a body.
    """

    said: str
    words: str
    sight: float = math.inf
    unlit: float = math.inf
    friction: float = math.inf


class _Row(StrEnum):
    """A member with its row."""

    _value_: str
    row: Condition

    def __new__(cls, value: str, row: Condition) -> Self:
        """A member of a name, with its row."""
        member = str.__new__(cls, value)
        member._value_, member.row = value, row
        return member


class Light(_Row):
    """How light it is, from light to dark."""

    DAY = ("day", Condition(said="day", words=r"(?:broad )?daylight|daytime|sunny"))
    DUSK = (
        "dusk",  # or dawn
        Condition(
            said="dusk",
            words=r"dusk|dawn|twilight|nightfall|sunset|sunrise|(?:at|in) (?:the )?(?:late )?evening",
        ),
    )
    NIGHT = (
        "night",
        Condition(
            said="night",
            words=(
                r"(?:(?:at|by|in the|one|late at|dead of|middle of the|this|that|the other) )?"
                r"night(?! (?:bus|buses|coach|club|shift))|night-?time|after dark|(?:in|into) the dark|pitch[- ]dark|"
                r"darkness|moonlight|moonlit|unlit (?:road|street)|no street ?lights?|"
                r"it(?: is|'s| was)(?: already| getting| very)? dark|"
                r"(?:getting|already) dark|(?:road|street) (?:is|was) dark|dark (?:road|street|night)"
            ),
            unlit=25.0,
        ),
    )


class Weather(_Row):
    """What falls or hangs in the air."""

    CLEAR = ("clear", Condition(said="clear", words=r"clear (?:weather|conditions|sky|skies)"))
    RAIN = ("rain", Condition(said="rain", words=r"rain(?:s|ing|y|ed|storm|fall)?|drizzl\w*|downpours?|showers"))
    SNOW = ("snow", Condition(said="snowfall", words=r"snow(?:s|ing|y|ed|fall|storm)?|blizzard"))
    FOG = ("fog", Condition(said="fog", words=r"fog(?:gy|s)?", sight=40.0))
    OVERCAST = ("overcast", Condition(said="overcast sky", words=r"overcast|cloudy|gr[ae]y sky"))
    DUST = ("dust", Condition(said="dust", words=r"dust ?storm|sand ?storm|dusty air|clouds? of dust", sight=40.0))


_ROADS = r"(?:roads?|streets?|roadway|surface|asphalt|tarmac|pavement|conditions?|carriageway|lanes?|bend|curve)"


def on_the_road(words: str) -> str:
    """Regular expression of what says of a road that it is so, or of something that it is on such a road."""
    told = rf"(?<![\w'] )(?:the )?{_ROADS} (?:{words})(?= *(?:[,;:.]|$))"  # a clause of its own: "Road wet."
    return rf"(?:{words}) (?:and \w+ )?(?:\w+ )?{_ROADS}|{_ROADS} (?:is|are|was|were|being) (?:\w+ )?(?:{words})|{told}"


class Surface(_Row):
    """The state of the road, from what holds best to what holds least."""

    DRY = ("dry", Condition(said="dry road", words=rf"{on_the_road('dry')}|dry"))
    WET = (
        "wet",
        Condition(
            said="wet road",
            words=(
                rf"{on_the_road('wet|damp|rain-soaked')}|(?:it|everything) (?:is|was) wet|in the wet|"
                r"after (?:the |a |some |heavy )*(?:rain(?:fall|storm)?|showers?|downpour)|"
                r"rain (?:has |had )?(?:just )?stopped"
            ),
            friction=0.5,
        ),
    )
    SNOW = (
        "snow",
        Condition(
            said="snow on the road",
            words=(
                rf"{on_the_road('snowy|snow-?covered|covered (?:in|with|by) (?:fresh )?snow')}|"
                rf"(?:packed|compacted|trodden) snow|on (?:the )?snow|"
                rf"(?:there (?:is|was) )?snow (?:all over|on) (?:the |our )?{_ROADS}"
            ),
            friction=0.25,
        ),
    )
    ICE = (
        "ice",
        Condition(
            said="ice on the road",
            words=(
                rf"{on_the_road('icy|frozen|iced')}|icy|black ice|freezing rain|(?:sheet of|on|over) (?:the )?ice|"
                rf"(?:there (?:is|was) )?ice (?:all over|on) (?:the |our )?{_ROADS}"
            ),
            friction=0.1,
        ),
    )


FOLLOWS: Mapping[Weather, Surface] = {Weather.RAIN: Surface.WET, Weather.SNOW: Surface.SNOW}
"""What a weather makes of the road, unless it is said otherwise."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Surroundings:
    """What surrounds a scene, all of it and at all times the same."""

    light: Light = Light.DAY
    weather: Weather = Weather.CLEAR
    surface: Surface = Surface.DRY

    @classmethod
    def named(cls, names: Mapping[str, str]) -> Self:
        """Those of some names, whatever else the mapping has.

        Raises:
            ValueError: There is no such light, weather or surface.
        """
        light, weather, surface = (names[field.name] for field in fields(cls))
        return cls(light=Light(light), weather=Weather(weather), surface=Surface(surface))

    @property
    def grip(self) -> float:
        """The largest acceleration [m/s²] that the road lets any body have; infinite where it does not limit it."""
        return self.surface.row.friction * GRAVITY

    def sight(self, lit: bool) -> float:
        """How far somebody is seen [m]; infinite where nothing limits it.

        Args:
            lit: Whether he carries lamps.
        """
        seen = min(self.light.row.sight, self.weather.row.sight)
        return seen if lit else min(seen, self.light.row.unlit, self.weather.row.unlit)

    def said(self) -> dict[str, Light | Weather | Surface]:
        """What is not as it is where nothing is said, by name."""
        own = {field.name: (getattr(self, field.name), field.default) for field in fields(self)}
        return {name: now for name, (now, usual) in own.items() if now is not usual}

    def __str__(self) -> str:
        """What is not as it is where nothing is said, in words; empty if all is."""
        return ", ".join(one.row.said for one in self.said().values())


Member = TypeVar("Member", Light, Weather, Surface)


def surroundings_of(parameters: Mapping[str, object]) -> Surroundings:
    """The surroundings that a program's parameters ask for: `light`, `weather`, and `surface` or what follows from it.

    Programs that were written for another world model have no `light`, mean something else by `weather`, and drive by
    day on a dry road.

    Raises:
        ProgramError: There is no such light, weather or surface.
    """
    if "light" not in parameters:
        return Surroundings()
    light, weather = _member(Light, parameters, "light"), _member(Weather, parameters, "weather")
    surface = _member(Surface, parameters, "surface") if parameters.get("surface") else FOLLOWS.get(weather)
    return Surroundings(light=light, weather=weather, surface=surface or Surface.DRY)


def _member(kind: type[Member], parameters: Mapping[str, object], name: str) -> Member:
    asked = str(parameters[name])
    if asked not in kind.__members__.values():
        raise ProgramError(no_such(name, asked, list(kind)))
    return kind(asked)
