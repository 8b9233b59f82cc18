"""How fast who was in a drive, and how hard the two met."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Speeds:
    """The speeds of the ego and of whom it meets; `docs/metrics.md` defines each.

    Whom it meets is whom it collides with first, else the adversary that comes nearest. Speeds are without a sign. All
    but the ego's own are None where it meets nobody; all from `ego_speed_at_impact` on are None without a collision.

    Attributes:
        other_kind: The class of whom it meets; None if it meets nobody.
        encounter_time: When the encounter begins: the last moment before either of them brakes for it [s].
        ego_speed_before: The ego's speed then [m/s]; of an ego that meets nobody, its highest.
        other_speed_before: The other's speed then [m/s].
        ego_speed_most: The ego's highest speed up to the nearest moment [m/s].
        other_speed_most: The other's [m/s].
        ego_braking_most: The ego's hardest braking up to then [m/s²].
        other_braking_most: The other's [m/s²].
        ego_speed_at_impact: Before the step that ended in contact [m/s].
        other_speed_at_impact: The same [m/s].
        closing_speed: The part of the impact speed along the line of contact [m/s].
        impact_angle: Heading of the other less that of the ego, in (-π, π] [rad]; 0 is the same way.
        ego_delta_v: By how much the impact changes the ego's velocity, if it is wholly inelastic [m/s].
        other_delta_v: The other's [m/s]; None of a thing that stands.
        ego_injury_risk: Probability that who is in or on the ego is seriously injured or dies (MAIS 3+); None where no
            curve holds.
        ego_death_risk: Probability that who is on the ego dies; None where no curve holds.
        friction_demand: The largest share of the road's friction that anybody on wheels took before a contact, along
            and across together; above 1 it is more than tyres hold. None where nobody on wheels moved.
    """

    ego_kind: str
    other_kind: str | None = None
    encounter_time: float | None = None
    ego_speed_before: float
    other_speed_before: float | None = None
    ego_speed_most: float
    other_speed_most: float | None = None
    ego_braking_most: float
    other_braking_most: float | None = None
    ego_speed_at_impact: float | None = None
    other_speed_at_impact: float | None = None
    closing_speed: float | None = None
    impact_angle: float | None = None
    ego_delta_v: float | None = None
    other_delta_v: float | None = None
    ego_injury_risk: float | None = None
    other_injury_risk: float | None = None
    ego_death_risk: float | None = None
    other_death_risk: float | None = None
    friction_demand: float | None = None
