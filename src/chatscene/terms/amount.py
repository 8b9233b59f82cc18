"""Amounts as people say them: a number or a range with a unit, at most, at least, or measured against the ego's.

Each quantity is a type of its own, so that a field says what it takes and a time is never read as a distance.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar, Self

from chatscene.terms.nouns import with_article
from chatscene.terms.pointing import nearest

if TYPE_CHECKING:
    from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
    from pydantic.json_schema import JsonSchemaValue
    from pydantic_core import CoreSchema

_NUMBER = r"[-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?"
_FORM = re.compile(
    rf"""\s*(?P<bound>at\ most|at\ least|up\ to|less\ than|more\ than|under|over|<=|>=|≤|≥|<|>)?\s*
    (?P<low>{_NUMBER})\s*(?:(?:to|\.\.|\u2013|-)\s*(?P<high>{_NUMBER}))?\s*
    (?P<unit>(?:car|bike|truck)\ lengths?|[^\s\d]*(?:2(?!\S))?)\s*
    (?P<than>(?:more|less|faster|slower)\ than\ the\ ego)?\s*""",
    re.VERBOSE,
)
_BOUNDS: Mapping[str, str] = {
    "at most": "<=", "up to": "<=", "less than": "<=", "under": "<=", "≤": "<=", "<": "<=",
    "at least": ">=", "more than": ">=", "over": ">=", "≥": ">=", ">": ">=",
}  # fmt: skip
"""What each says; that a bound itself is in or out is no difference that anybody could see."""
CAR_LENGTH, BIKE_LENGTH, TRUCK_LENGTH = 4.5, 1.8, 10.0  # [m], as people measure by them
_DIGITS = 6  # significant ones of a number that somebody said


@dataclass(frozen=True, slots=True)
class Amount:
    """A quantity that was said; a number alone is in the SI unit.

    Attributes:
        low: The least it may be, in SI units; minus infinity where only a most was said.
        high: The most it may be; the same as `low` where one number was said.
        than_ego: Whether it is what somebody has more (negative: less) than the ego.
    """

    low: float
    high: float
    than_ego: bool = False

    QUANTITY: ClassVar[str] = ""
    UNITS: ClassVar[Mapping[str, float]] = {}  # best first; the empty one is the SI unit
    EXAMPLES: ClassVar[tuple[str, ...]] = ()
    RELATIVE: ClassVar[bool] = False  # whether people measure it against the ego's

    def __post_init__(self) -> None:
        if math.isnan(self.low) or math.isnan(self.high):
            raise ValueError("it is not a number")
        if self.low > self.high:
            raise ValueError(f"the least {self.QUANTITY} is more than the most")
        if self.than_ego and not self.RELATIVE:
            raise ValueError("only a speed is measured against the ego's")
        if not self.than_ego and (self.high < 0 or -math.inf < self.low < 0):
            raise ValueError(f"{self.QUANTITY} is never below 0")
        if self.than_ego and self.low < 0 < self.high:
            raise ValueError(f"{with_article(self.QUANTITY)} cannot be more and less than the ego's")
        if math.isinf(self.low) and math.isinf(self.high):
            raise ValueError(f"{self.QUANTITY} without a number")

    @classmethod
    def of(cls, said: object) -> Self:
        """An amount as somebody writes it: ``50 km/h``, ``10 to 20 m``, ``at least 2 s``, or a number in SI units.

        Raises:
            ValueError: It is none; the message says what one looks like.
        """
        if isinstance(said, cls):
            return said
        if isinstance(said, int | float) and not isinstance(said, bool):
            try:
                return cls(float(said), float(said))
            except OverflowError as error:
                raise ValueError("it is not a number") from error
        form = _FORM.fullmatch(said) if isinstance(said, str) else None
        if form is None:
            raise ValueError(
                f"{said!r} is not {with_article(cls.QUANTITY)}; write it as in {', '.join(map(repr, cls.EXAMPLES))}"
            )
        if (scale := cls.UNITS.get(form["unit"])) is None:
            named = ", ".join(unit for unit in cls.UNITS if unit)
            near = nearest(form["unit"], cls.UNITS)
            meant = f"; did you mean {near}?" if near else ""
            raise ValueError(
                f"{form['unit']!r} is not a unit of {with_article(cls.QUANTITY)}, which has {named}{meant}"
            )
        return cls._of_form(form, scale)

    @classmethod
    def _of_form(cls, form: re.Match[str], scale: float) -> Self:
        low = float(form["low"]) * scale
        high = float(form["high"]) * scale if form["high"] else low
        than = form["than"] or ""
        bound = _BOUNDS.get(form["bound"] or "", form["bound"])
        if bound and (form["high"] or than):
            raise ValueError(f"{form[0].strip()!r} has a bound and another number; write a range, as in '10 to 20'")
        if than.startswith(("less", "slower")):
            low, high = -high, -low
        if bound:
            low, high = (-math.inf, low) if bound == "<=" else (low, math.inf)
        return cls(low, high, bool(than))

    @staticmethod
    def has_unit(said: object) -> bool:
        """Whether a text for an amount has a unit; a text that is no amount counts as one that has."""
        form = _FORM.fullmatch(said) if isinstance(said, str) else None
        return isinstance(said, str) and (form is None or bool(form["unit"]))

    @property
    def exact(self) -> bool:
        """Whether one number was said."""
        return self.low == self.high

    @property
    def least(self) -> float:
        """The least that was said [SI]: of "at most" the most, as there is no other number."""
        return self.low if math.isfinite(self.low) else self.high

    @property
    def most(self) -> float:
        """The most that was said [SI]: of "at least" the least."""
        return self.high if math.isfinite(self.high) else self.low

    def near(self, usual: float) -> float:
        """What it is where one number is needed: the usual one [SI], or the one nearest to that which it allows."""
        return min(max(usual, self.low), self.high)

    def drawn(self, low: float, high: float) -> tuple[float, float]:
        """From where to where it is drawn of which a range is usual [SI].

        It is what of that range it allows. If it allows nothing of it, it is the range that was said, or the bound.
        """
        least, most = max(self.low, low), min(self.high, high)
        return (least, most) if least <= most else (self.least, self.most)

    def __str__(self) -> str:
        """As `of` reads it, in the first of its units in which the number is short; else in SI units, to the bit."""
        finite = [end for end in (self.low, self.high) if math.isfinite(end)]
        for unit, scale in self.UNITS.items():
            sayable = unit and all(math.isfinite(end / scale) for end in finite)
            if sayable and type(self).of(said := self._in(unit, scale)) == self:
                return said
        return self._in(next((unit for unit, scale in self.UNITS.items() if unit and scale == 1.0), ""))

    def _in(self, unit: str, scale: float | None = None) -> str:
        less = self.than_ego and self.low < 0
        ends = (-self.high, -self.low) if less else (self.low, self.high)
        low, high = (f"{end / scale:.{_DIGITS}g}" if scale else repr(end) for end in ends)
        number = low if self.exact else f"{low} to {high}"
        if math.isinf(self.low):
            number = f"at most {high}"
        elif math.isinf(self.high):
            number = f"at least {low}"
        than = "" if not self.than_ego else " less than the ego" if less else " more than the ego"
        return f"{number} {unit}{than}".strip()

    @classmethod
    def __get_pydantic_core_schema__(cls, source: type[Any], handler: GetCoreSchemaHandler) -> CoreSchema:
        """As `of` reads it and ``str`` writes it, for files."""
        from pydantic_core import core_schema

        return core_schema.no_info_plain_validator_function(
            cls.of, serialization=core_schema.plain_serializer_function_ser_schema(str)
        )

    @classmethod
    def __get_pydantic_json_schema__(cls, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """A string with a unit."""
        return {"type": "string", "title": cls.__name__, "examples": list(cls.EXAMPLES)}


class Speed(Amount):
    """How fast [m/s]."""

    __slots__ = ()
    QUANTITY = "speed"
    RELATIVE = True
    UNITS: ClassVar[Mapping[str, float]] = {
        "km/h": 1 / 3.6, "kph": 1 / 3.6, "kmh": 1 / 3.6, "mph": 0.44704, "m/s": 1.0, "": 1.0,
    }  # fmt: skip
    EXAMPLES = ("50 km/h", "20 to 30 km/h", "at most 30 mph", "20 km/h more than the ego")

    def beside(self, ego: float) -> Speed:
        """The same as a speed of its own, beside an ego at a speed [m/s]; the same object where it is one.

        Nobody is slower than 0, which is what less than that becomes.
        """
        if not self.than_ego:
            return self
        scale = self.UNITS["km/h"]  # rounded in it, so that messages tell a short number
        low, high = (max(0.0, round((end + ego) / scale, _DIGITS) * scale) for end in (self.low, self.high))
        return Speed(low, high)


class Length(Amount):
    """How far [m]."""

    __slots__ = ()
    QUANTITY = "length"
    UNITS: ClassVar[Mapping[str, float]] = {
        "m": 1.0, "km": 1000.0, "cm": 0.01, "mile": 1609.344, "miles": 1609.344, "ft": 0.3048, "foot": 0.3048,
        "feet": 0.3048, "in": 0.0254, "inch": 0.0254, "inches": 0.0254, "yd": 0.9144, "yard": 0.9144, "yards": 0.9144,
        "car length": CAR_LENGTH, "car lengths": CAR_LENGTH, "bike length": BIKE_LENGTH, "bike lengths": BIKE_LENGTH,
        "truck length": TRUCK_LENGTH, "truck lengths": TRUCK_LENGTH, "": 1.0,
    }  # fmt: skip
    EXAMPLES = ("20 m", "10 to 20 m", "at least 50 ft")


class Duration(Amount):
    """How long [s]."""

    __slots__ = ()
    QUANTITY = "duration"
    UNITS: ClassVar[Mapping[str, float]] = {"s": 1.0, "ms": 0.001, "min": 60.0, "": 1.0}
    EXAMPLES = ("2 s", "1 to 3 s", "at least 0.5 s")


class Acceleration(Amount):
    """How hard speed changes [m/s²]; how much, without a sign."""

    __slots__ = ()
    QUANTITY = "acceleration"
    UNITS: ClassVar[Mapping[str, float]] = {"m/s²": 1.0, "m/s2": 1.0, "m/s^2": 1.0, "g": 9.81, "": 1.0}
    EXAMPLES = ("4 m/s²", "3 to 5 m/s²", "at least 0.5 g")


class Share(Amount):
    """Which part of a whole, in [0, 1]."""

    __slots__ = ()
    QUANTITY = "share"
    UNITS: ClassVar[Mapping[str, float]] = {"%": 0.01, "": 1.0}
    EXAMPLES = ("50 %", "25 to 50 %", "at most 30 %")

    def __post_init__(self) -> None:
        super().__post_init__()
        if 1.0 < self.high < math.inf or self.low > 1.0:
            raise ValueError("a share is 100 % at most")
