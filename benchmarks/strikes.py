"""Who strikes whom: minimal pairs in ten grammatical forms, in which only who strikes is another.

    python benchmarks/strikes.py

Of each text the likeliest situation is taken, whatever its probability. Right is a striker as written beside the text,
and the part that is struck and where the other begins, where these are written. A text of which the situation has no
contact, or a contact without a striker, is open: wrong for nobody, and not right. Reading has no seed.
"""

from __future__ import annotations

import json
from collections import Counter, defaultdict
from pathlib import Path

import click

from chatscene.read.learned.reader import LearnedReader
from chatscene.situations.words import told
from chatscene.terms.situation import Situation

PAIRS = Path(__file__).parent / "reading" / "strikes.jsonl"


def verdict(row: dict[str, str], situation: Situation | None) -> str:
    """How a situation fares beside what is written."""
    contact = situation.contact if situation is not None else None
    if situation is None or contact is None or contact.striker is None:
        return "open"
    if contact.striker.value != row["striker"]:
        return "wrong"
    parts = {"ego": contact.ego, "other": contact.other}
    misread = [whose for whose, part in parts.items() if part is not None and part.value != row.get(whose)]
    elsewhere = "where" in row and situation.others[0].starts.where.value != row["where"]
    return "part" if misread or elsewhere else "right"


@click.command()
@click.option("--verbose", is_flag=True, help="Print what is not right.")
def main(verbose: bool) -> None:
    """Measure."""
    reader, of_form = LearnedReader(), defaultdict[str, Counter[str]](Counter)
    for line in PAIRS.read_text(encoding="utf-8").splitlines():
        row = json.loads(line)
        ranked = reader.read(row["text"]).ranked
        situation = ranked[0].situation if ranked else None
        came = verdict(row, situation)
        of_form[row["form"]][came] += 1
        of_form["all"][came] += 1
        of_form["all, served"][came] += bool(ranked) and ranked[0].probability >= 0.5
        if verbose and came != "right" and situation is not None:
            click.echo(f"{came}: {row['text']}\n    {ranked[0].probability:.0%} {told(situation)}")
    for form, came in of_form.items():
        click.echo(f"{form}: {dict(came.most_common())}")


if __name__ == "__main__":
    main()
