"""Texts with the facts that people wrote down for them, for the benchmarks beside this file.

    python benchmarks/labelled.py FOLDER/dev.jsonl > narratives.jsonl

writes the narratives, which are labelled by their ids alone, with their texts from FOLDER, to learn from.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from pydantic import TypeAdapter

from chatscene.terms.scenario import Slots

TEXTS = Path(__file__).parent / "texts"
_SLOTS = TypeAdapter(Slots)


def labelled(name: str, narratives: Path | None) -> Iterator[tuple[str, str, bool, Slots]]:
    """Style, text, whether it is in scope, and its facts; narratives are labelled by id, and left out without texts."""
    texts = {}
    if narratives:
        texts = {row["id"]: row["text"] for row in map(json.loads, narratives.read_text().splitlines())}
    for row in map(json.loads, (TEXTS / f"{name}.jsonl").read_text().splitlines()):
        if text := row.get("text") or texts.get(row["id"]):
            yield row.get("style", name), text, row["in_scope"], _SLOTS.validate_python(row.get("slots") or {})


def auc(sure: list[tuple[float, bool]]) -> float:
    """How often what is right is trusted more than what is wrong."""
    right, wrong = (np.array([p for p, is_right in sure if is_right is which]) for which in (True, False))
    return float(np.mean((right[:, None] > wrong) + 0.5 * (right[:, None] == wrong)))


if __name__ == "__main__":
    for style, text, in_scope, slots in labelled("narratives", Path(sys.argv[1])):
        row = {"text": text, "style": style, "in_scope": in_scope, "slots": _SLOTS.dump_python(slots, mode="json")}
        print(json.dumps(row))
