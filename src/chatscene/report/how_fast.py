"""How fast who was, in a sentence or two: for the head of the page and for the terminal."""

from __future__ import annotations

from array import array
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import chain
from statistics import median
from typing import Any

from chatscene.measure.severity import CURVES, KMH, By, Found, Outcome, in_kmh, near_in_words, none_told, told
from chatscene.terms.actors import BY_CLASS, noun_of
from chatscene.terms.criticality import LONGEST

Row = Mapping[str, Any]

KINDS = 2  # of those whom the ego meets, named at most
NARROW = 1.05  # how far apart speeds are at most that are told as one
STILL = 0.1  # [m/s]


TOLD_BY = (
    *("scene_id", "status", "collision", "ego_speed_before", "other_kind", "other_speed_most"),
    *("distance", "time_to_collision", "impact_speed", "closing_speed"),
)
"""The columns of `scenes.parquet` that `how_fast` reads of every scene."""


def how_fast(rows: Iterable[Row], *, whole: Callable[[Row], Row] = lambda row: row) -> str:
    """How fast the ego and whom it met were, how near the nearest miss was, and how hard the hardest crash.

    Returns:
        Sentences; empty where nothing was driven, or before speeds were kept.
    """
    egos = array("d")
    others: dict[str, array[float]] = {}
    nearest: Row | None = None
    hardest: Row | None = None
    crashes, fastest = 0, 0.0
    for row in rows:
        if row["status"] != "ran" or row.get("ego_speed_before") is None:
            continue
        egos.append(row["ego_speed_before"])
        if (kind := row["other_kind"]) is not None:
            others.setdefault(kind, array("d")).append(row["other_speed_most"])
        if row["collision"]:
            crashes, fastest = crashes + 1, max(fastest, row["impact_speed"] or 0.0)
            hardest = row if hardest is None or hardness(row) > hardness(hardest) else hardest
        elif row["distance"] is not None:
            nearest = row if nearest is None or row["distance"] < nearest["distance"] else nearest
    if not egos:
        return ""
    lines = [", ".join([f"The ego drove at {_about(egos)}", *_others(others)])]
    if nearest is not None:
        lines.append(f"In the closest near miss they came within {_within(nearest)}")
    if hardest is not None:
        lines.append(_hardest(whole(hardest), crashes, fastest))
    return " ".join(f"{line}." for line in lines)


def harm(row: Row) -> tuple[list[Found], list[Found]]:
    """What published curves say of the crash in a row of `scenes.parquet`: of the ego, and of whom it struck first."""
    ego, other = ([_found(row, *who, outcome) for outcome in Outcome] for who in (("ego", "other"), ("other", "ego")))
    return [one for one in ego if one is not None], [one for one in other if one is not None]


def harm_in_words(row: Row) -> str:
    """What they say, in clauses; empty without a collision, or before risks were kept."""
    if not row["collision"] or row.get("closing_speed") is None:
        return ""
    return "; ".join(told(*harm(row))) or none_told(
        (row["ego_kind"], row["other_kind"]), (row["ego_delta_v"], row["other_delta_v"])
    )


def scene_in_words(row: Row) -> str:
    """How fast both were as the encounter began, and how near they came if they did not touch; empty without one."""
    if row.get("encounter_time") is None:
        return ""
    ego, other = in_kmh(row["ego_speed_before"]), in_kmh(row["other_speed_before"])
    noun = noun_of(row["other_kind"])
    begins = f"As the encounter began, at {row['encounter_time']:.1f} s: ego at {ego}, {noun} at {other}."
    near = "" if row["collision"] or row["distance"] is None else f" They came within {_within(row)}."
    return begins + near


def _others(met: Mapping[str, Sequence[float]]) -> Iterator[str]:
    """How fast whom it met were at their fastest, kind by kind, the most frequent first."""
    for kind, fast in sorted(met.items(), key=lambda one: -len(one[1]))[:KINDS]:
        where = f" in {len(fast)}" if len(met) > 1 else ""
        yield f"the {noun_of(kind)}{where} " + ("stood" if max(fast) < STILL else f"at up to {_about(fast)}")


def _about(values: Sequence[float]) -> str:
    """The middle of some speeds, and from where to where they are if that is more than a little."""
    least, most = min(values), max(values)
    middle = in_kmh(median(values))
    if in_kmh(least) == in_kmh(most) or most <= NARROW * least:
        return middle
    return f"{middle} ({KMH * least:.0f} to {KMH * most:.0f})"


def _within(row: Row) -> str:
    """How near two came that did not touch."""
    left = row["time_to_collision"]
    near = left is not None and left <= LONGEST
    return near_in_words(row["distance"]) + (f", and within {left:.1f} s of a collision" if near else "")


def _hardest(row: Row, count: int, fastest: float) -> str:
    """How hard the hardest of so many crashes was, and how fast [m/s] the fastest, if that was another."""
    hard = f"an impact speed of {in_kmh(row['impact_speed'] or 0.0)}"
    if in_kmh(hardness(row)) != in_kmh(row["impact_speed"] or 0.0):
        hard += f" and a closing speed, straight against each other, of {in_kmh(hardness(row))}"
    if in_kmh(fastest) != in_kmh(row["impact_speed"] or 0.0):
        hard += f" (the fastest, less straight, one of {in_kmh(fastest)})"
    crash = f"{'The crash' if count == 1 else 'The hardest crash'} had {hard}"
    worst = max(chain(*harm(row)), key=lambda one: (one.curve.outcome is Outcome.DEATH, one.risk), default=None)
    said = harm_in_words(row) if worst is None else worst.in_words()
    return f"{crash}: {said}" if said else crash


def hardness(row: Row) -> float:
    """How hard a crash was [m/s]: how fast they closed along the line of contact; in older folders, the whole speed."""
    closing = row.get("closing_speed")
    return (row["impact_speed"] or 0.0) if closing is None else closing


def _found(row: Row, who: str, whom: str, outcome: Outcome) -> Found | None:
    """What a curve of an outcome says of one of the two."""
    kind, risk = BY_CLASS.get(row[f"{who}_kind"] or ""), row[f"{who}_{outcome.column}"]
    curve = next((one for one in CURVES if kind in one.kinds and one.outcome is outcome), None)
    if risk is None or curve is None:
        return None
    takes = {By.STRIKER: f"{whom}_speed_at_impact", By.IMPACT: "impact_speed", By.DELTA_V: f"{who}_delta_v"}
    return Found(curve=curve, risk=risk, speed=row[takes[curve.by]] or 0.0)
