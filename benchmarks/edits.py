"""How many edits change just the fact that they name.

    python benchmarks/edits.py [FILE] [--wrong]

FILE has a line of JSON for each: `base`, a sentence; `edit`; and `changed`, the facts that are others afterwards with
their values, "*" where any other will do, or none at all where the edit ought to be refused. If no file is named, it is
`benchmarks/texts/edits.jsonl`, by the same pen as the reader of edits.

An edit is *right* if the facts that it changes are those, with these values, or if it is refused where it ought to be;
*exact* if moreover nothing else changed, not even what follows. *served*: of the right ones that ought to be read,
those that are built. Facts are those that `chatscene.interpret.slots_of` names. Nothing is driven.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click

from chatscene.build.build import build
from chatscene.errors import EditRefused, NotBuilt
from chatscene.interpret.edited import edited
from chatscene.interpret.slots_of import facts_of, parties_of
from chatscene.read.learned.reader import LearnedReader
from chatscene.terms.edit import Facts
from chatscene.terms.scenario import QuantityKind
from chatscene.terms.situation import Situation
from chatscene.terms.slots import SLOTS

OWN = Path(__file__).parent / "texts" / "edits.jsonl"
FOLLOWS = frozenset(("place", "control", "maneuver", "position", "blocker", "occluder", "surface"))
"""Facts that may change because of others (`chatscene.terms.conclusions`)."""


@click.command()
@click.argument("file", type=click.Path(exists=True, dir_okay=False, path_type=Path), default=OWN)
@click.option("--wrong", is_flag=True, help="Show those that are not right or not served.")
def main(file: Path, wrong: bool) -> None:
    reader, counts = LearnedReader(), Counter[str]()
    for line in file.read_text(encoding="utf-8").splitlines():
        row = json.loads(line)
        counts["edits"] += 1
        before = reader.read(row["base"]).ranked[0].situation
        try:
            after = edited(before, row["edit"]).after
        except EditRefused as error:
            counts["right" if not row["changed"] else "refused"] += 1
            counts["refused as it ought to be"] += not row["changed"]
            if row["changed"] and wrong:
                click.echo(f"REFUSED {row['base']!r} + {row['edit']!r}: {error}")
            continue
        right, exact = judged(before, after, row["changed"])
        counts["right" if right else "wrong"] += 1
        counts["exact"] += exact
        try:
            build(after)
        except NotBuilt as error:
            counts["not served"] += right
            if right and wrong:
                click.echo(f"NOT SERVED {row['base']!r} + {row['edit']!r}: {error}")
        else:
            counts["served"] += right
        if wrong and not right:
            click.echo(f"WRONG {row['base']!r} + {row['edit']!r}: {_changed(before, after)}, not {row['changed']}")
    click.echo(", ".join(f"{name}: {count}" for name, count in counts.items()))


def judged(before: Situation, after: Situation, wanted: Mapping[str, Any]) -> tuple[bool, bool]:
    """Whether the facts that changed are those that were wanted or follow, and whether no others changed."""
    made = _changed(before, after)
    if wanted.get("speed") == "*" and before != after:  # faster, of which no number is said, is a manner
        made = {"speed": "*", **{name: value for name, value in made.items() if name not in ("actions", "speed")}}
    if wanted.get("deceleration") == "*" and before != after:  # and so is harder
        made = {"deceleration": "*", **made}
    if wanted.get("distance") == "*" and _starts(before) != _starts(after):
        made = {"distance": "*", **made}
    right = bool(wanted) and set(wanted) <= set(made) <= {*wanted, *FOLLOWS}
    right = right and all(_is(made[name], wanted[name]) for name in wanted)
    return right, right and set(made) == set(wanted)


def _changed(before: Situation, after: Situation) -> dict[str, Any]:
    was, now = parties_of(before), parties_of(after)
    if was is None or now is None:
        return {}
    earlier, later = _by_name(facts_of(before, was)), _by_name(facts_of(after, now))
    return {name: value for name, value in later.items() if value != earlier[name]}


def _by_name(facts: Facts) -> dict[str, Any]:
    """Every fact by its name; how far off it starts may be a number or near or far."""
    slots = {name: getattr(facts.slots, name) for name in ("adversary", "actions", *SLOTS, "others")}
    around = {name: getattr(facts.surroundings, name) for name in ("light", "weather", "surface")}
    said = {one: tuple(each for each in facts.quantities if each.measure is one) for one in QuantityKind}
    return {**slots, **around, **{str(one): numbers or slots.get(one) or () for one, numbers in said.items()}}


def _starts(situation: Situation) -> list[object]:
    return [one.starts.distance for one in situation.others]


def _is(value: Any, wanted: Any) -> bool:
    plain = [str(one) for one in value] if isinstance(value, tuple) and isinstance(wanted, list) else value
    return wanted in ("*", plain)


if __name__ == "__main__":
    main()
