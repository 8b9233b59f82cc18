"""Plain values are taken and given as pydantic takes and gives them, and all that is not plain is left to it."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml
from pydantic import TypeAdapter

from chatscene.situations.form import NotPlain, plain, situation_in
from chatscene.terms.amount import Length, Speed
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import UserKind

ROOT = Path(__file__).parents[2]
FORM: TypeAdapter[Situation] = TypeAdapter(Situation)
CAR: dict[str, Any] = {"id": "A", "kind": "car", "starts": {"where": "ahead"}, "does": [{"act": "brake"}]}


def _written() -> Iterator[dict[str, Any]]:
    for path in sorted((ROOT / "benchmarks" / "texts").glob("*.jsonl")):
        for line in path.read_text(encoding="utf-8").splitlines():
            row = json.loads(line)
            yield from (row[name] for name in ("situation", "after") if isinstance(row.get(name), dict))
    for row in yaml.safe_load((ROOT / "tests" / "build" / "written.yaml").read_text(encoding="utf-8")):
        yield {name: one for name, one in row.items() if name != "name"}


def test_what_is_written_is_taken_and_given_as_pydantic_does() -> None:
    taken = 0
    for written in _written():
        whole = FORM.validate_python(written)
        assert plain(whole) == FORM.dump_python(whole, mode="json", exclude_defaults=True)
        assert situation_in(plain(whole)) == whole
        assert situation_in(plain(whole)).evidence == whole.evidence
        taken += 1
    assert taken > 1000


def test_words_and_amounts_are_taken_as_they_are() -> None:
    written = {"ego": {"speed": Speed(10.0, 10.0)}, "others": [CAR | {"kind": UserKind.TRUCK}]}
    assert situation_in(written) == FORM.validate_python(written)


@pytest.mark.parametrize(
    "written",
    [
        {"others": [CAR | {"count": "2"}]},
        {"others": [CAR | {"count": True}]},
        {"others": [CAR | {"kind": "dragon"}]},
        {"others": [CAR | {"wings": 2}]},
        {"others": [{"id": "A", "kind": "car"}]},
        {"others": "nobody"},
        {"ego": {"speed": "fast"}},
        {"ego": {"speed": 13.9}},
        {"ego": {"speed": Length(1.0, 1.0)}},
        {"road": {"two_way": "yes"}},
        {"ego": {"does": [{"act": "brake", "when": {"ego_within": "5"}}]}},
        {"evidence": {"quoted": {"ego": 3}}},
    ],
)
def test_what_is_not_plain_is_left_to_pydantic(written: dict[str, Any]) -> None:
    with pytest.raises(NotPlain):
        situation_in(written)
