"""How texts are read that the reader's authors neither wrote nor tuned on.

    python benchmarks/others.py --narratives FOLDER/dev.jsonl [--reader paper] [--styles] [NAMES…]

`kept`, `kept-second`, `kept-third` and `kept-fourth`: 150, 160, 194 and 178 texts by four writers who knew the facts to
tell and not the reader; of the last two, a second reader labelled all again, and what both could not agree on is left
out. `classes-second` is asked for by name: ten texts for each class of mistakes, by a fifth writer.
`narratives-kept`: crash narratives, labelled twice by people who did not know it either; their texts are in FOLDER.
Nothing is driven. Prints of those in scope how many are served with every fact right, with a wrong one, and refused,
and for how many of these one of the readings that are offered is right; of the others how many are refused; and how
well the confidence tells right from wrong among the served.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from pathlib import Path

import click
from labelled import auc, labelled
from slots_read import differing

from chatscene.errors import NothingFits
from chatscene.search.generators.retrieved import Retrieved
from chatscene.settings import READ_AS, RetrievalSettings

KEPT = ("kept", "kept-second", "kept-third", "kept-fourth", "narratives-kept")


@click.command()
@click.option("--narratives", type=click.Path(exists=True, dir_okay=False, path_type=Path))
@click.argument("names", nargs=-1)
@click.option("--reader", type=click.Choice(READ_AS[:2]), default=READ_AS[0])
@click.option("--styles", is_flag=True, help="Of each style right, wrong and refused, too.")
def main(narratives: Path | None, names: tuple[str, ...], reader: str, styles: bool) -> None:
    generator, settings = Retrieved(), RetrievalSettings(reader=reader)
    for name in names or KEPT:
        counts = dict.fromkeys(("right", "wrong", "refused", "a reading right", "out of scope", "of them refused"), 0)
        of_styles: defaultdict[str, Counter[str]] = defaultdict(Counter)
        sure: list[tuple[float, bool]] = []
        for style, text, in_scope, said in labelled(name, narratives):
            scenario = generator.read(text, settings)
            try:
                confidence = generator.write(scenario, settings).retrieval.confidence
            except NothingFits:
                confidence = None
            if not in_scope:
                counts["out of scope"] += 1
                counts["of them refused"] += confidence is None
            elif confidence is None:
                counts["refused"] += 1
                of_styles[style]["refused"] += 1
                counts["a reading right"] += any(not differing(said, one.slots) for one in scenario.readings)
            else:
                right = not differing(said, scenario.slots)
                counts["right" if right else "wrong"] += 1
                of_styles[style]["right" if right else "wrong"] += 1
                sure.append((confidence, right))
        print(name, counts, f"AUC {auc(sure):.2f}" if {r for _, r in sure} == {True, False} else "")
        for style, found in of_styles.items() if styles else ():
            print(f"  {style}: {found['right']} right, {found['wrong']} wrong, {found['refused']} refused")


if __name__ == "__main__":
    main()
