"""What happened in the scenes that are kept, in words."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from chatscene.measure.severity import KMH
from chatscene.terms.criticality import Happening

_OF_ONE = {
    Happening.NEAR_IN_TIME: ("smallest gap", "gap_in_time", "s"),
    Happening.NEAR: ("smallest gap", "distance", "m"),
    Happening.BRAKING: ("braked hard, smallest gap", "distance", "m"),
    Happening.STEERING: ("steered clear, smallest gap", "distance", "m"),
    Happening.NOTHING: ("smallest gap", "distance", "m"),
}
_OTHERWISE = {
    Happening.BRAKING: "with hard braking",
    Happening.STEERING: "with evasive steering",
    Happening.NOTHING: "without a near miss",
}


def outcome_in_words(row: Mapping[str, Any]) -> str:
    """What came of a drive, in a few words: a collision, the nearest gap, or how it ended where that was not kept."""
    if row["collision"]:
        return "collision"
    if row.get("happened") not in frozenset(Happening):  # or a folder that somebody changed
        return str(row["ending"])
    words, column, unit = _OF_ONE[Happening(row["happened"])]
    return str(row["ending"]) if row[column] is None else f"{words} {row[column]:.1f} {unit}"


def kept_in_words(rows: Sequence[Mapping[str, Any]]) -> str:
    """What the kept scenes are, such as ``1 collision with an impact speed of 9 km/h, 1 with a gap of 1.1 s``."""
    kept = [row for row in rows if row["selected"]]
    if not kept or any(row.get("happened") is None for row in kept):
        return ""
    by = {kind: [row for row in kept if row["happened"] == kind] for kind in Happening}
    crashes, soon, near = by[Happening.COLLISION], by[Happening.NEAR_IN_TIME], by[Happening.NEAR]
    told: list[str] = []
    if crashes:
        many = (
            "1 collision with an impact speed" if len(crashes) == 1 else f"{len(crashes)} collisions with impact speeds"
        )
        told.append(f"{many} of {_span(crashes, 'impact_speed', 'km/h')}")
    told += [
        f"{len(some)} with {'smallest gaps' if len(some) > 1 else 'a smallest gap'} of {_span(some, column, unit)}"
        for some, column, unit in ((soon, "gap_in_time", "s"), (near, "distance", "m"))
        if some
    ]
    told += [f"{len(by[kind])} {words}" for kind, words in _OTHERWISE.items() if by[kind]]
    return ", ".join(told)


def _span(rows: Iterable[Mapping[str, Any]], column: str, unit: str) -> str:
    """From the least to the greatest of a column."""
    scale, digits = (KMH, 0) if unit == "km/h" else (1.0, 1)
    numbers = [f"{scale * value:.{digits}f}" for value in sorted(float(row[column]) for row in rows)]
    return f"{numbers[0]} {unit}" if numbers[0] == numbers[-1] else f"{numbers[0]} to {numbers[-1]} {unit}"
