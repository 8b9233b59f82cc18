"""How close a scene came to harm, and who ran into whom."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from enum import StrEnum
from typing import Any, NamedTuple

LONGEST = 10.0  # [s], beyond which a time to collision says nothing, and is not shown


class Severity(StrEnum):
    """Severity classes of ISO 26262-3, from no injuries to fatal ones; decision 0012 says where each begins."""

    S0 = "S0"
    S1 = "S1"
    S2 = "S2"
    S3 = "S3"


class Fault(StrEnum):
    """Who struck whom: the party whose own motion closed more of the gap at contact. Not a matter of law."""

    ADVERSARY_INTO_EGO = "adversary-into-ego"
    EGO_INTO_ADVERSARY = "ego-into-adversary"
    EGO_INTO_STATIC = "ego-into-static"
    BACKGROUND_INTO_EGO = "background-into-ego"
    EGO_INTO_BACKGROUND = "ego-into-background"

    @property
    def by_ego(self) -> bool:
        """Whether it was the ego that struck."""
        return self in (Fault.EGO_INTO_ADVERSARY, Fault.EGO_INTO_STATIC, Fault.EGO_INTO_BACKGROUND)


class Happening(StrEnum):
    """The gravest of what happened to an ego in a drive; `chatscene.measure.happening` says from when on it counts."""

    COLLISION = "collision"
    NEAR_IN_TIME = "near-in-time"
    NEAR = "near"
    BRAKING = "hard-braking"
    STEERING = "evasive-steering"
    NOTHING = "nothing"


@dataclass(frozen=True, slots=True, kw_only=True)
class Happened:
    """What happened to an ego in a drive.

    Attributes:
        kind: The gravest of it.
        step: When: of the contact, of the nearest gap, or at the end of what the ego did.
        seconds: The nearest gap in time [s] between the ego and an adversary; None where there was none.
    """

    kind: Happening
    step: int
    seconds: float | None


class Measure(NamedTuple):
    """A number of a drive, in words.

    Attributes:
        name: What it is called.
        meaning: What it is, as the tables of `chatscene sql` have it.
        unit: Its unit.
        more: What more of it means for the ego, ``better`` or ``worse``.
        touched: Whether a contact makes it 0.
    """

    name: str
    meaning: str
    unit: str
    more: str
    touched: bool = False


class OnPage(NamedTuple):
    """What the page of measures says of one.

    Attributes:
        unit: Its unit.
        defined: What it is, in full, with its source.
        null: Where there is none, besides where there is no adversary.
    """

    unit: str
    defined: str
    null: str


def _measured(
    name: str, meaning: str, unit: str, more: str, *, defined: str, null: str = "", touched: bool = False
) -> Any:
    measure = Measure(name, meaning, unit, more, touched)
    return field(metadata={"measure": measure, "page": OnPage(unit, defined, null)})


def _of_crash(unit: str, defined: str) -> dict[str, OnPage]:
    return {"page": OnPage(unit, defined, "no collision")}


@dataclass(frozen=True, slots=True, kw_only=True)
class Criticality:
    """The measures of one drive: a field each, of which columns, pages and the viewer are made; None for what is not.

    A field that is `_measured` compares the ego with the adversaries and is the worst over them and over time. One that
    is `_of_crash` is about the first collision, whoever it was with.
    """

    time_to_collision: float | None = _measured(
        "shortest time to collision",
        "shortest time until the ego and an adversary would touch if both carried on",
        *("s", "better"),
        touched=True,
        defined="shortest time until the boxes would touch at constant velocity and heading; 0 at contact (Hayward "
        "1972, in two dimensions)",
        null="never on a collision course",
    )
    post_encroachment_time: float | None = _measured(
        "post-encroachment time",
        "shortest time between one leaving an area and the other reaching it",
        *("s", "better"),
        touched=True,
        defined="shortest time between one road user leaving an area and the other reaching it, in either order; 0 at "
        "contact (Allen, Shin and Cooper 1978)",
        null="their paths share no area",
    )
    time_headway: float | None = _measured(
        "shortest time headway",
        "shortest time to the position of an adversary ahead",
        *("s", "better"),
        defined="shortest time from the ego's front to an adversary ahead, at the ego's speed",
        null="no adversary is ever ahead while the ego is faster than 0.1 m/s",
    )
    deceleration_required: float | None = _measured(
        "deceleration required",
        "greatest braking that just avoids an adversary ahead",
        *("m/s²", "worse"),
        defined="greatest v²/2d; v is the closing speed to an adversary ahead along the ego's heading, d the gap "
        "(DRAC; Jansson 2005)",
        null="the ego never closes in on one",
    )
    distance: float | None = _measured(
        "smallest distance",
        "smallest gap between the ego and an adversary; 0 at contact",
        *("m", "better"),
        touched=True,
        defined="smallest gap between the boxes; 0 at contact",
    )
    impact_speed: float | None = field(metadata=_of_crash("m/s", "relative speed just before the first collision"))
    severity: Severity | None = field(
        metadata=_of_crash("S0 to S3", "severity class for that speed, after ISO 26262-3")
    )


CRITICALITY: Mapping[str, Measure] = {
    one.name: one.metadata["measure"] for one in fields(Criticality) if "measure" in one.metadata
}
"""The measures, each by its column."""
