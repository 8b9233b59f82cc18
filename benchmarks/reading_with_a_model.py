"""How well a language model reads sentences, next to the offline reader.

    CHATSCENE_LLM_URL=http://127.0.0.1:8080/v1 python benchmarks/reading_with_a_model.py openai:NAME [--count 24]

Both read the same sentences, of those written by hand and held out; nothing is driven.
"""

from __future__ import annotations

import argparse
import random
import time

from chatscene.report.tables import as_text
from chatscene.settings import OFFLINE, RetrievalSettings
from chatscene.studies.reading import HELD_OUT, load_sentences, measure, summary_table
from chatscene.terms.results import ResultTable


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("model")
    parser.add_argument("--count", type=int, default=24)
    parser.add_argument("--seed", type=int, default=0)
    arguments = parser.parse_args()
    unseen = load_sentences(HELD_OUT)
    chosen = random.Random(arguments.seed).sample(unseen, arguments.count)
    rows: list[tuple[str, ResultTable]] = []
    for model in (OFFLINE, arguments.model):
        began = time.perf_counter()
        settings = RetrievalSettings(language_model=model)
        table = summary_table(measure(chosen, settings=settings, drive=False, progress=lambda *_: None))
        seconds = (time.perf_counter() - began) / len(chosen)
        rows.append((f"{model}, {seconds:.2f} s each", table))
    print(
        as_text(
            ResultTable(
                title=f"{len(chosen)} sentences",
                columns=rows[0][1].columns,
                rows=tuple((name, table.rows[0][1]) for name, table in rows),
                notes=rows[0][1].notes,
            )
        )
    )


if __name__ == "__main__":
    main()
