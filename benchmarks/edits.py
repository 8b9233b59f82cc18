"""How many edits change just the fact that they name.

    python benchmarks/edits.py [FILE] [--wrong]

FILE has a line of JSON for each: `base`, a sentence; `edit`; and `changed`, the facts that are others afterwards with
their values, "*" where any other will do, or none at all where the edit ought to be refused. If no file is named, it is
`benchmarks/texts/edits.jsonl`, by the same pen as the reader of edits.

An edit is *right* if the facts that it was read to name are those, with these values, or if it is refused where it
ought to be; *exact* if moreover nothing else changed, not even what follows. *served*: of the right ones that ought to
be read, those of which the library makes a program. Nothing is driven.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click

from chatscene.errors import EditRefused, NothingFits
from chatscene.interpret.amend import Amended, amended
from chatscene.search.generators.retrieved import Retrieved
from chatscene.settings import RetrievalSettings

OWN = Path(__file__).parent / "texts" / "edits.jsonl"


@click.command()
@click.argument("file", type=click.Path(exists=True, dir_okay=False, path_type=Path), default=OWN)
@click.option("--wrong", is_flag=True, help="Show those that are not right or not served.")
def main(file: Path, wrong: bool) -> None:
    generator, settings, counts = Retrieved(), RetrievalSettings(), Counter[str]()
    for line in file.read_text(encoding="utf-8").splitlines():
        row = json.loads(line)
        counts["edits"] += 1
        scenario = generator.read(row["base"], settings)
        try:
            made = amended(scenario, row["edit"], settings)
        except EditRefused as error:
            counts["right" if not row["changed"] else "refused"] += 1
            counts["refused as it ought to be"] += not row["changed"]
            if row["changed"] and wrong:
                click.echo(f"REFUSED {row['base']!r} + {row['edit']!r}: {error}")
            continue
        right, exact = judged(made, row["changed"])
        counts["right" if right else "wrong"] += 1
        counts["exact"] += exact
        try:
            generator.write(made.scenario, settings)
        except NothingFits as error:
            counts["not served"] += right
            if right and wrong:
                click.echo(f"NOT SERVED {row['base']!r} + {row['edit']!r}: {error}")
        else:
            counts["served"] += right
        if wrong and not right:
            click.echo(f"WRONG {row['base']!r} + {row['edit']!r}: {'; '.join(made.in_words())}, not {row['changed']}")
    click.echo(", ".join(f"{name}: {count}" for name, count in counts.items()))


def judged(made: Amended, wanted: Mapping[str, Any]) -> tuple[bool, bool]:
    """Whether the facts that changed and were named are those that were wanted, and whether no others changed."""
    named = {one.fact: one.after for one in made.changes if one.fact in made.edit.named or one.fact in wanted}
    right = bool(wanted) and set(named) == set(wanted) and all(_is(named[name], wanted[name]) for name in wanted)
    return right, right and len(named) == len(made.changes)


def _is(value: Any, wanted: Any) -> bool:
    plain = [str(one) for one in value] if isinstance(value, tuple) and isinstance(wanted, list) else value
    return wanted in ("*", plain)


if __name__ == "__main__":
    main()
