"""The command line, continued: reports, which are read for the conflicts that they tell."""

from __future__ import annotations

import json
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click

import chatscene
from chatscene.commands.output import progress, say
from chatscene.commands.refusal import REFUSED, refuse, refusing
from chatscene.commands.situations import say_understood
from chatscene.errors import MeansSomethingElse, NothingFits
from chatscene.report.refused import refusal
from chatscene.terms.conflict import Conflict


def found_in(report: Path, reading: Mapping[str, Any], as_json: bool) -> tuple[Conflict, ...]:
    """The conflicts of a report, and a word on what it is read as; ends with status 3 if there is none."""
    with refusing("", reading["embedder"], as_json):
        found = chatscene.conflicts(report, progress=progress())
    if len(found) > 1 and (reading["reading"] or reading["set"]):
        raise click.UsageError(f"{report} has {len(found)} conflicts; --reading and --set need one: give its text")
    if not as_json:
        for line in in_words(found):
            say(line, err=True)
    return found


def in_words(found: tuple[Conflict, ...]) -> list[str]:
    """What a report is read as, in lines."""
    first = found[0]
    lines = [f"{first.report} has {'a conflict' if len(found) == 1 else f'{len(found)} conflicts'}:"]
    lines += [f"  {one.number}  {one.text}" for one in found]
    return [*lines, *(f"  left out: {passage}" for passage in first.left_out)]


def explain_report(report: Path, reading: Mapping[str, Any], *, program: bool, as_json: bool) -> None:
    """Show how each conflict of a report is understood; ends with status 3 if one is refused."""
    found = found_in(report, reading, as_json)
    told: list[dict[str, Any]] = []
    refused = False
    for one in found:
        try:
            understood = chatscene.explain(one, **reading)
        except (NothingFits, MeansSomethingElse) as error:
            refused = True
            if as_json:
                told.append(refusal(error, one.text, reading["embedder"]))
            else:
                say(f"\n{one.number}  {one.text}")
                refuse(error, one.text, reading["embedder"], as_json)
            continue
        told.append(understood.as_dict())
        if not as_json:
            say(f"\n{one.number}  {one.text}\n")
            say_understood(understood, program=program)
    if as_json:
        say(json.dumps({"report": found[0].report, "left_out": found[0].left_out, "conflicts": told}, indent=1))
    if refused:
        sys.exit(REFUSED)
