"""`report.html` of egos on scenarios that were imported: how each fared, and in which program."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from chatscene.imports.collection import CollectedProgram, Collection
from chatscene.report.templates import asset, fill, policy, scripts

Row = Mapping[str, Any]
Drives = dict[str, dict[str, list[Row]]]
"""What was driven: by ego, by program."""


def collection_page(
    collection: Collection,
    fared: Sequence[Row],
    drives: Drives,
    lost: Mapping[str, str],
    partly: Mapping[str, str],
    failures: Mapping[str, str],
) -> str:
    """The page: one file that needs nothing but a browser."""
    script = scripts("sort", "table", "evaluation")
    egos = [one["ego"] for one in fared]
    why = {**lost, **partly}
    programs = [_program(one, [drives[ego].get(one.name, []) for ego in egos], why) for one in collection.programs]
    return fill(
        "collection.html",
        title=", ".join(egos) or "no drive",
        policy=policy(script),
        style=asset("viewer.css") + asset("evaluation.css"),
        script=script,
        folder=collection.folder.resolve().name,
        egos=egos,
        fared=fared,
        failures=failures,
        drives=sum(len(rows) for own in drives.values() for rows in own.values()),
        lost=lost,
        partly=partly,
        refused=collection.refused,
        programs=sorted(programs, key=lambda one: -one["fails"]),
    )


def _program(one: CollectedProgram, own: Sequence[Sequence[Row]], why: Mapping[str, str]) -> dict[str, Any]:
    """What became of a program under each ego, and why not all of it was driven."""
    cells = list(map(_cell, own))
    shares = [cell["collided"] / cell["drives"] for cell in cells if cell]
    return {
        "name": one.name,
        "about": one.about,
        "lost": why.get(one.name, ""),
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
