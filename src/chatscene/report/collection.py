"""`report.html` of egos on scenarios that were imported: how each fared, and in which program."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from chatscene.imports.collection import CollectedProgram, Collection
from chatscene.report.templates import asset, fill, policy, scripts

Row = Mapping[str, Any]


def collection_page(
    collection: Collection,
    fared: Sequence[Row],
    own: Mapping[str, Sequence[Row]],
    lost: Mapping[str, str],
    failures: Mapping[str, str],
) -> str:
    """The page: one file that needs nothing but a browser.

    Args:
        collection: What was driven.
        fared: How each ego fared in all its drives.
        own: The drives of each ego.
        lost: Why programs, or scenes of theirs, were not driven, by the program's name.
        failures: Why egos were given up, by ego.
    """
    script = scripts("sort", "table", "evaluation")
    egos = [one["ego"] for one in fared]
    programs = [_program(one, {ego: own[ego] for ego in egos}, lost) for one in collection.programs]
    return fill(
        "collection.html",
        title=", ".join(egos) or "no drive",
        policy=policy(script),
        style=asset("viewer.css") + asset("evaluation.css"),
        script=script,
        folder=str(collection.folder),
        egos=egos,
        fared=fared,
        failures=failures,
        drives=sum(map(len, own.values())),
        lost=lost,
        refused=collection.refused,
        programs=sorted(programs, key=lambda one: -one["fails"]),
    )


def _program(one: CollectedProgram, own: Mapping[str, Sequence[Row]], lost: Mapping[str, str]) -> dict[str, Any]:
    """What became of a program under each ego."""
    cells = [_cell([row for row in rows if row["program"] == one.name]) for rows in own.values()]
    shares = [cell["collided"] / cell["drives"] for cell in cells if cell]
    return {
        "name": one.name,
        "about": one.about,
        "lost": lost.get(one.name, ""),
        "cells": cells,
        "fails": sum(shares),
        "differ": len(set(shares)) > 1,
    }


def _cell(rows: Sequence[Row]) -> dict[str, Any] | None:
    """What became of the drives of one ego; None where there are none."""
    if not rows:
        return None
    crashes = [row for row in rows if row["collision"]]
    return {
        "drives": len(rows),
        "collided": len(crashes),
        "hardest": max((row["impact_speed"] for row in crashes), default=None),
        "avoidable": sum(row["avoidable"] is True for row in crashes),
        "nearest": min((row["distance"] for row in rows if row["distance"] is not None), default=None),
        "unplayed": any(row["unplayed"] for row in rows),
    }
