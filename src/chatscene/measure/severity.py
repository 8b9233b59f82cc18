"""How likely somebody is badly hurt in a crash: published injury-risk curves, a row each (decision 0125).

A curve is a logistic regression over crashes of a kind, and says nothing of others: it is asked only where who struck
whom with what fits, and followed no further than to its middle, above which few of its crashes lie. It is of an average
person of its sample, and of crashes in which somebody was hurt or a car was towed. It is no verdict on a scene.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from enum import StrEnum

from chatscene.terms.actors import BY_CLASS, AdversaryKind, Manner

KMH = 3.6
HALF = 0.5  # where curves end, and what then stands for "half or more"
NO_CURVE = "no published injury-risk curve is of such a crash"


class Outcome(StrEnum):
    """What a curve is of, and how it is said of several people."""

    INJURY = "are seriously injured or die"  # MAIS 3+, one of the injuries being serious (AIS 3) or worse
    DEATH = "die"

    @property
    def column(self) -> str:
        """What `Speeds` calls it, after who it is of."""
        return "death_risk" if self is Outcome.DEATH else "injury_risk"


class By(StrEnum):
    """What speed a curve takes, as it is said."""

    IMPACT = "at an impact speed of"  # the relative speed of the two just before
    STRIKER = "when struck at"  # the speed of the car that strikes
    DELTA_V = "at a change of velocity of"


@dataclass(frozen=True, slots=True, kw_only=True)
class Curve:
    """A published injury-risk curve: P = 1 / (1 + exp(-(intercept + slope v))).

    Attributes:
        who: Who is hurt, in words, of several.
        kinds: What they are in or on, or are.
        parts: The part of their own vehicle that is struck; empty of who has none around.
        outcome: What of.
        by: Which speed it takes.
        intercept: With the age of the median person of the sample, where it is a variable.
        slope: Per m/s.
        least: Below this speed [m/s] it says nothing.
        source: Whose it is, in a few words; decision 0125 has it in full.
    """

    who: str
    kinds: frozenset[AdversaryKind]
    parts: frozenset[str] = frozenset()
    outcome: Outcome
    by: By
    intercept: float
    slope: float
    least: float = 0.0
    source: str

    @property
    def middle(self) -> float:
        """The speed at which it is a half [m/s], up to which it is followed."""
        return -self.intercept / self.slope

    def at(self, speed: float) -> float | None:
        """The probability at a speed [m/s]; `HALF` stands for a half or more, None for too slow to say."""
        if speed < self.least:
            return None
        return HALF if speed >= self.middle else 1.0 / (1.0 + math.exp(-self.intercept - self.slope * speed))


def in_kmh(speed: float) -> str:
    """A speed [m/s] as people say it."""
    return f"{KMH * speed:.0f} km/h"


def near_in_words(gap: float) -> str:
    """How near [m] two came, of whom nobody is to think that they touched."""
    return f"{gap:.1f} m" if gap >= LEAST else f"less than {LEAST:g} m"


LEAST = 0.1  # [m] below which a gap is as good as none, and is none all the same
LIGHT = 3500.0  # [kg]: categories M1 and N1 (Regulation (EU) 2018/858)
VEHICLES = frozenset(kind for kind in AdversaryKind if kind.row.motorised and kind.row.manner is Manner.DRIVES)
_CARS = frozenset(kind for kind in VEHICLES if kind.row.mass <= LIGHT)
_ON_FOOT = frozenset({AdversaryKind.PEDESTRIAN})
_ROSEN, _LUBBE, _GEISSLINGER = "Rosén and Sander 2009", "Lubbe et al. 2022", "Geisslinger et al. 2023"
OCCUPANT_LEAST = 7 / KMH  # [m/s] of change of velocity, below which SAE J2980 expects no injury (decision 0012)

CURVES = (
    # Adults hit by the front of a passenger car, GIDAS 1999-2007: P = 1 / (1 + exp(6.9 - 0.090 v)), v in km/h.
    Curve(
        who="pedestrians",
        kinds=_ON_FOOT,
        outcome=Outcome.DEATH,
        by=By.STRIKER,
        intercept=-6.9,
        slope=0.090 * KMH,
        source=_ROSEN,
    ),
    # Those who meet the front of a passenger car, GIDAS 1999-2020, MAIS 3+F: tables 2 to 4, v in km/h, age in years.
    Curve(
        who="pedestrians",
        kinds=_ON_FOOT,
        outcome=Outcome.INJURY,
        by=By.IMPACT,
        intercept=-6.190 + 0.038 * 46,
        slope=0.078 * KMH,
        source=_LUBBE,
    ),
    Curve(
        who="cyclists",
        kinds=frozenset({AdversaryKind.BICYCLE}),
        outcome=Outcome.INJURY,
        by=By.IMPACT,
        intercept=-7.467 + 0.047 * 39,
        slope=0.079 * KMH,
        source=_LUBBE,
    ),
    Curve(
        who="motorcyclists",
        kinds=frozenset({AdversaryKind.MOTORCYCLE}),
        outcome=Outcome.INJURY,
        by=By.IMPACT,
        intercept=-4.555 + 0.011 * 40,
        slope=0.040 * KMH,
        source=_LUBBE,
    ),
    # Occupants of cars that met a vehicle, crashes of the NHTSA, MAIS 3+: four areas of impact, both sides alike.
    *(
        Curve(
            who="people in a car",
            kinds=_CARS,
            parts=frozenset(parts.split()),
            outcome=Outcome.INJURY,
            by=By.DELTA_V,
            intercept=-4.457 + area,
            slope=0.177,
            least=OCCUPANT_LEAST,
            source=_GEISSLINGER,
        )
        for parts, area in (("front", 0.0), ("left right", 0.244), ("rear", -0.431))
    ),
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Hurt:
    """Somebody in a crash, as a curve is asked of it.

    Attributes:
        kind: What it is; None for a thing.
        part: Where on it the other touches it: ``front``, ``rear``, ``left``, ``right``; empty of a walker.
        speed: How fast it went just before [m/s].
        delta_v: By how much its velocity changes [m/s]; None of a thing.
    """

    kind: AdversaryKind | None
    part: str
    speed: float
    delta_v: float | None


@dataclass(frozen=True, slots=True, kw_only=True)
class Found:
    """What a curve says of somebody.

    Attributes:
        curve: Which.
        risk: The probability, as `Curve.at` gives it.
        speed: Of what [m/s].
    """

    curve: Curve
    risk: float
    speed: float

    def in_words(self) -> str:
        """What it says of a hundred people, in a clause with its source."""
        curve = self.curve
        return f"{self.share} {curve.who} {curve.outcome} {curve.by} {in_kmh(self.speed)} ({curve.source})"

    @property
    def share(self) -> str:
        """How many of a hundred, in words before what they are."""
        if self.risk >= HALF:
            return "half or more of"
        return f"{100 * self.risk:.0f} in 100" if self.risk >= 0.005 else "fewer than 1 in 100"


def curves_for(one: Hurt, other: Hurt, *, impact_speed: float, closing_speed: float) -> Iterator[Found]:
    """The curves that hold of somebody in a crash, and what each says.

    Args:
        one: Who is hurt.
        other: Whom it meets.
        impact_speed: Their relative speed just before [m/s].
        closing_speed: Its part along the line of contact [m/s]. Where that is less than half, one grazes the other, and
            no curve by the speed is of that.
    """
    for curve in CURVES:
        if one.kind not in curve.kinds:
            continue
        if curve.by is By.DELTA_V:
            fits, speed = one.part in curve.parts and other.kind in VEHICLES, one.delta_v or 0.0
        else:
            fits = other.part == "front" and other.kind is AdversaryKind.CAR and closing_speed >= impact_speed / 2
            speed = impact_speed if curve.by is By.IMPACT else other.speed
        if fits and (risk := curve.at(speed)) is not None:
            yield Found(curve=curve, risk=risk, speed=speed)


def none_told(kinds: Iterable[str | None], delta_vs: Iterable[float | None]) -> str:
    """Why no curve says anything of a crash.

    Args:
        kinds: The classes of both.
        delta_vs: By how much the velocity of each changes [m/s].
    """
    mild = all(change is not None and change < OCCUPANT_LEAST for change in delta_vs)
    between = all(BY_CLASS.get(kind or "") in VEHICLES for kind in kinds)
    return "milder than those of which there are injury-risk curves" if mild and between else NO_CURVE


def told(ego: Sequence[Found], other: Sequence[Found]) -> tuple[str, ...]:
    """What curves say of the two in a crash, in clauses, of the other first; people in two cars share one."""
    mine, theirs = (next((found for found in of if found.curve.by is By.DELTA_V), None) for of in (ego, other))
    if mine is None or theirs is None:
        return tuple(found.in_words() for found in (*other, *ego))
    curve = mine.curve
    changes = " and ".join(dict.fromkeys((in_kmh(mine.speed), in_kmh(theirs.speed))))
    both = f"{mine.share} people in the ego and {theirs.share} people in the other"
    if mine.share == theirs.share:
        both = f"{mine.share} people in either car"
    return (f"{both} {curve.outcome} {curve.by} {changes} ({curve.source})",)
