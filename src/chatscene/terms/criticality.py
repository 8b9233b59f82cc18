"""How close a scene came to harm, and who ran into whom."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum


class Severity(StrEnum):
    """Severity classes of ISO 26262-3, by impact speed."""

    S0 = "S0"
    S1 = "S1"
    S2 = "S2"
    S3 = "S3"


class Fault(StrEnum):
    """Whose own motion closed the gap at impact."""

    ADVERSARY_INTO_EGO = "adversary-into-ego"
    EGO_INTO_ADVERSARY = "ego-into-adversary"
    EGO_INTO_STATIC = "ego-into-static"
    BACKGROUND_INTO_EGO = "background-into-ego"
    EGO_INTO_BACKGROUND = "ego-into-background"


@dataclass(frozen=True, slots=True, kw_only=True)
class Criticality:
    """The measures of one scene, the worst over its adversaries."""

    time_to_collision: float | None
    post_encroachment_time: float | None
    time_headway: float | None
    deceleration_required: float | None
    distance: float | None
    impact_speed: float | None
    severity: Severity | None
