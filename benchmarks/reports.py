"""How reports of several conflicts in one running text are cut.

    python benchmarks/reports.py benchmarks/texts/reports-kept.jsonl

A file has a line for each part of a report: the `report` that it belongs to, its `text`, and the `verdict`. A conflict
is told apart if one text that was found has sentences of it and of no other conflict; it is halved if several have,
merged if one that has them has sentences of another conflict as well, and missed if none has. A text that was found
and has no sentence of a conflict is made up.
"""

from __future__ import annotations

import json
import re
from collections import Counter
from itertools import groupby
from pathlib import Path

import click

from chatscene.errors import NothingFits
from chatscene.interpret.conflicts import conflicts_in
from chatscene.terms.reading import Verdict

_ENDS = re.compile(r"(?<=[.!?])\s+")
SHORT = 12  # characters of a sentence that may stand in a report several times


def cut(parts: list[tuple[str, bool]]) -> Counter[str]:
    """How many conflicts of a report, given in its parts and whether each tells one, are told apart, and else."""
    report = " ".join(text for text, _ in parts)
    try:
        found = [one.text for one in conflicts_in(report)]
    except NothingFits:
        found = []
    told = [[one for one in _ENDS.split(text) if len(one) > SHORT] or [text] for text, tells in parts if tells]
    said = [{i for i, sentences in enumerate(told) if any(one in text for one in sentences)} for text in found]
    counts = Counter(made_up=sum(not one for one in said))
    for i in range(len(told)):
        those = [one for one in said if i in one]
        if not those:
            counts["missed"] += 1
        elif any(len(one) > 1 for one in those):
            counts["merged"] += 1
        else:
            counts["told apart" if len(those) == 1 else "halved"] += 1
    return counts


@click.command()
@click.argument("file", type=click.Path(path_type=Path, exists=True, dir_okay=False))
def main(file: Path) -> None:
    """Print the counts."""
    rows = [json.loads(line) for line in file.read_text().splitlines()]
    counts, whole, reports = Counter[str](), 0, 0
    for _, parts in groupby(rows, key=lambda row: row["report"]):
        told = [(row["text"], Verdict(row["verdict"]) is Verdict.SITUATION) for row in parts]
        one = cut(told)
        counts += one
        reports += 1
        whole += one["told apart"] == sum(tells for _, tells in told) and not one["made_up"]
    click.echo(
        f"{file}: {whole} of {reports} reports cut into their conflicts; conflicts: {dict(sorted(counts.items()))}"
    )


if __name__ == "__main__":
    main()
