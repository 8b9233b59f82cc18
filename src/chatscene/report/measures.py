"""A scene in words: its name, and each of its numbers with its unit and whether more of it is better for the ego."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

from chatscene.measure.score import (
    MOST_ACCELERATION,
    MOST_DISTANCE,
    MOST_INVASIONS,
    MOST_OFF_ROAD,
    MOST_TIME,
    MOST_YAW_RATE,
)
from chatscene.terms.criticality import CRITICALITY

GRAVITY = 9.81  # [m/s²]; no tyre on a dry road brakes harder


_CURVE = "by a published curve, MAIS 3+ or death; 0.5 stands for a half or more"


class InWords(NamedTuple):
    """A number of a scene: its name, its unit or what it is a share of, and what more of it means, if for the ego."""

    name: str
    more: str
    unit: str = ""
    of: str = ""

    @property
    def in_one(self) -> str:
        """All that is said of it but its unit, in one line."""
        told = ": ".join(filter(None, (self.name, self.of)))
        return "; ".join(filter(None, (told, self.more and f"more is {self.more}")))


MEASURES: dict[str, InWords] = {
    "cr": InWords("collision rate (CR)", "worse", of="1 if it collided"),
    "rr": InWords("red light (RR)", "worse", of="red lights run"),
    "ss": InWords("stop sign (SS)", "worse", of="stop signs ignored"),
    "or": InWords("off road (OR)", "worse", of=f"share of {MOST_OFF_ROAD:g} m"),
    "rf": InWords("route following (RF)", "better", of=f"1 less the mean distance as a share of {MOST_DISTANCE:g} m"),
    "comp": InWords("completion (Comp)", "better", of="share of the route that counts as driven"),
    "ts": InWords("time spent (TS)", "worse", of=f"share of {MOST_TIME:g} s, 0 if it did not arrive"),
    "acc": InWords("acceleration (ACC)", "worse", of=f"mean, share of {MOST_ACCELERATION:g} m/s²"),
    "yv": InWords(
        "yaw velocity (YV)", "worse", of=f"mean, share of {MOST_YAW_RATE:g} rad/s, a step over ±180° taken for a turn"
    ),
    "li": InWords("lane invasion (LI)", "worse", of=f"markings crossed, share of {MOST_INVASIONS:g}"),
    "overall_score": InWords("overall score (OS)", "better", of="at most 1"),
    **{column: InWords(one.name, one.more, one.unit) for column, one in CRITICALITY.items()},
    "encounter_time": InWords("the encounter begins at", "", "s", of="just before either brakes for it"),
    "ego_speed_before": InWords("the ego's speed then", "", "m/s"),
    "other_speed_before": InWords("the other's speed then", "", "m/s"),
    "ego_speed_most": InWords("the ego's highest speed", "", "m/s", of="up to the nearest moment"),
    "other_speed_most": InWords("the other's highest speed", "", "m/s", of="up to the nearest moment"),
    "ego_braking_most": InWords("the ego's hardest braking", "worse", "m/s²"),
    "other_braking_most": InWords("the other's hardest braking", "", "m/s²"),
    "ego_speed_at_impact": InWords("the ego's speed at the impact", "worse", "m/s"),
    "other_speed_at_impact": InWords("the other's speed at the impact", "", "m/s"),
    "closing_speed": InWords("closing speed", "worse", "m/s", of="along the line of contact"),
    "impact_angle": InWords("angle of the impact", "", "rad", of="0 is the same way, ±π oncoming"),
    "ego_delta_v": InWords("the ego's change of velocity", "worse", "m/s", of="if the two go on as one"),
    "other_delta_v": InWords("the other's change of velocity", "worse", "m/s", of="if the two go on as one"),
    "ego_injury_risk": InWords("risk of serious injury in or on the ego", "worse", of=_CURVE),
    "other_injury_risk": InWords("risk of serious injury of the other", "worse", of=_CURVE),
    "ego_death_risk": InWords("risk of death on the ego", "worse", of=_CURVE),
    "other_death_risk": InWords("risk of death of the other", "worse", of=_CURVE),
    "friction_demand": InWords("friction demand", "", of="share of what the road holds; above 1 tyres slide"),
}


def scene_label(scene_id: str) -> str:
    """A scene's name without its scenario: ``route 00 · scene 017``."""
    return " · ".join(part.replace("-", " ") for part in scene_id.split("/")[-2:])


def in_words(values: Mapping[str, float]) -> list[dict[str, str]]:
    """Each number with its name, its unit, and a note that says how to read it; what is not finite is left out."""
    return [
        {"name": one.name, "value": f"{values[column]:.4g} {one.unit}".strip(), "note": _note(column, values[column])}
        for column, one in MEASURES.items()
        if math.isfinite(values.get(column, math.nan))
    ]


def _note(column: str, value: float) -> str:
    measure = MEASURES[column]
    if column == "deceleration_required" and value > GRAVITY:
        said = "more than any tyre can do: braking could no longer avoid it"
    elif column in CRITICALITY and CRITICALITY[column].touched and value == 0.0:
        said = "they touched"
    else:
        said = measure.of
    return "; ".join(filter(None, (said, measure.more and f"more is {measure.more}")))
