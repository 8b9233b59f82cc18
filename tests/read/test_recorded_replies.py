"""Each reply that a language model once gave, to a text of others, is still read as what it holds."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

from chatscene.errors import NoUsableReply
from chatscene.models.language.checked import CheckedModel
from chatscene.models.language.protocol import Limits
from chatscene.models.language.scripted import Scripted
from chatscene.read.by_model import ModelReader
from chatscene.situations.form import from_plain
from chatscene.terms.reading import SituationReading
from chatscene.terms.situation import Evidence

BENCHMARKS = Path(__file__).parents[2] / "benchmarks"
ROWS = [json.loads(line) for line in (BENCHMARKS / "reading" / "replies.jsonl").read_text().splitlines()]
SENT_BACK = {  # the first replies that have faults of form, with what the model is told
    "kept/142": "others.A.does.0.distance: keep-level has no distance",
    "kept-second/91": "ego.does.0.distance: brake has no distance",
    "kept-third/151": "ego.speed: 'about 20 mph' is not a speed",
    "kept-fourth/77": "ego.speed: 'about 110 km/h' is not a speed",
}


def texts() -> dict[str, str]:
    found: dict[str, str] = {}
    for name in {row["id"].split("/")[0] for row in ROWS}:
        lines = (BENCHMARKS / "texts" / f"{name}.jsonl").read_text().splitlines()
        found |= {f"{name}/{i}": json.loads(line)["text"] for i, line in enumerate(lines)}
    return found


TEXTS = texts()


def read(row: dict[str, Any]) -> SituationReading | str:
    model = CheckedModel(Scripted([row["replies"][0]]), limits=Limits(reasks=0))
    try:
        return ModelReader(model).read(TEXTS[row["id"]])
    except NoUsableReply as error:
        return str(error)


def test_there_are_the_replies_of_hundreds_of_texts_each_once() -> None:
    assert len({row["id"] for row in ROWS}) == len(ROWS) >= 300


def test_each_recorded_reply_is_read_as_the_situation_that_it_holds_or_is_told_its_known_fault() -> None:
    wrong: list[str] = []
    for row in ROWS:
        met, reply = read(row), row["replies"][0]
        if isinstance(met, str):
            if SENT_BACK.get(row["id"], "no fault") not in met:
                wrong.append(f"{row['id']}: {met}")
            continue
        held = [from_plain(reply["situation"])] if reply["situation"] else []
        situations = [one.situation for one in met.ranked]
        same = [replace(one, about="", evidence=Evidence()) for one in situations] == [
            replace(one, about="", evidence=Evidence()) for one in held
        ]
        quoted = [one.evidence.quoted for one in situations] == [one.evidence.quoted for one in held]
        if not (same and quoted and met.verdict == reply["verdict"]):
            wrong.append(f"{row['id']}: read as {met}")
        if row["id"] in SENT_BACK:
            wrong.append(f"{row['id']}: it has no fault any more")
    assert not wrong
