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


def _measured(name: str, meaning: str, unit: str, more: str, *, touched: bool = False) -> Any:
    return field(metadata={"measure": Measure(name, meaning, unit, more, touched)})


@dataclass(frozen=True, slots=True, kw_only=True)
class Criticality:
    """The measures of one drive; `docs/metrics.md` defines each.

    A field with words is a measure: columns, pages and the viewer are made from it. It may not apply to a drive.

    The first five compare the ego with the adversaries and are the worst over them and over time; all are None where
    there is no adversary. The last two are about the first collision, whoever it was with.

    Attributes:
        time_to_collision: Least time until the boxes would touch if both went on as they are [s]; lower is worse, 0
            in a contact. None if they never were on such a course.
        post_encroachment_time: Least time between one leaving a place and the other coming to it [s]; lower is worse,
            0 in a contact. None if no place was taken by both.
        time_headway: Least time the ego needed to where an adversary ahead was [s]; lower is worse. None if no
            adversary was ever ahead of the moving ego.
        deceleration_required: Greatest braking that just avoids contact with an adversary ahead [m/s²]; higher is
            worse, and without bound shortly before a contact. None if the ego never closed in on one ahead.
        distance: Least gap between the boxes [m]; lower is worse, 0 in a contact.
        impact_speed: Speed of approach at the first collision [m/s]; higher is worse. None without a collision.
        severity: Its class, by that speed and by what was struck. None without a collision.
    """

    time_to_collision: float | None = _measured(
        "least time to collision",
        "least time until the ego and an adversary would touch if both carried on",
        *("s", "better"),
        touched=True,
    )
    post_encroachment_time: float | None = _measured(
        "post-encroachment time",
        "least time between one leaving a place and the other coming to it",
        *("s", "better"),
        touched=True,
    )
    time_headway: float | None = _measured(
        "least time headway", "least time to the position of an adversary ahead", "s", "better"
    )
    deceleration_required: float | None = _measured(
        "deceleration required", "greatest braking that just avoids an adversary ahead", "m/s²", "worse"
    )
    distance: float | None = _measured(
        "least distance", "least gap between the ego and an adversary; 0 at contact", "m", "better", touched=True
    )
    impact_speed: float | None
    severity: Severity | None


CRITICALITY: Mapping[str, Measure] = {
    one.name: one.metadata["measure"] for one in fields(Criticality) if "measure" in one.metadata
}
"""The measures, each by its column."""
