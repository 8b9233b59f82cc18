"""Whether texts that mean the same are read the same, and whether of a flipped fact just that fact is read anew.

    python benchmarks/pairs.py

`pairs`: 99 pairs by a writer who knew the facts to tell and not the reader, labelled again by a second reader: 50 of
the same meaning in other words, 49 of which the second differs in one fact. Nothing is driven or refused: what is
compared are the facts that are decided on (`slots_read.py`), right or wrong, and, in brackets, those pairs of which
both texts are served.
"""

from __future__ import annotations

import json
from collections import Counter

from labelled import TEXTS
from slots_read import differing

from chatscene.errors import NothingFits
from chatscene.search.generators.retrieved import Retrieved
from chatscene.settings import RetrievalSettings
from chatscene.terms.scenario import Slots


def main() -> None:
    generator, settings = Retrieved(), RetrievalSettings()

    def read(text: str) -> tuple[Slots, bool]:
        scenario = generator.read(text, settings)
        try:
            generator.write(scenario, settings)
        except NothingFits:
            return scenario.slots, False
        return scenario.slots, True

    counts: Counter[str] = Counter()
    for row in map(json.loads, (TEXTS / "pairs.jsonl").read_text(encoding="utf-8").splitlines()):
        (one, first), (other, second) = read(row["text"]), read(row["other"])
        changed = {*differing(one, other), *differing(other, one)}
        holds = changed == ({row["flipped"]} if row["kind"] == "flip" else set[str]())
        for kind in (row["kind"], f"{row['kind']} served") if first and second else (row["kind"],):
            counts[kind] += 1
            counts[f"{kind} holds"] += holds
    for kind in ("same", "flip"):
        print(
            f"{kind}: {counts[f'{kind} holds']} of {counts[kind]} "
            f"({counts[f'{kind} served holds']} of {counts[f'{kind} served']})"
        )


if __name__ == "__main__":
    main()
