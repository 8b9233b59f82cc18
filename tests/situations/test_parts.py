"""What is left of a situation if some of it is left open."""

from __future__ import annotations

from typing import Any

from chatscene.situations.form import from_plain
from chatscene.situations.main_facts import within_the_main
from chatscene.situations.parts import left_open, parts_of
from chatscene.terms.situation import Situation

VAN = {"id": "A", "kind": "van", "starts": {"where": "beside", "side": "left"}}
BUS = {"id": "B", "kind": "bus", "role": "supporting", "starts": {"where": "behind"}, "does": [{"act": "tailgate"}]}


def situation(*others: dict[str, Any], **ego: Any) -> Situation:
    return from_plain({"ego": ego, "others": list(others)})


def doing(one: dict[str, Any], *does: dict[str, Any]) -> dict[str, Any]:
    return one | {"does": list(does)}


def said(part: Situation) -> str:
    return "; ".join(f"{who} {' '.join(deed.act for deed in does)}" for who, does in part.everybody() if does)


WHOLE = situation(doing(VAN, {"act": "cut-in"}, {"act": "brake"}), BUS, does=[{"act": "lane-change", "to": "left"}])


def test_what_is_left_is_in_the_whole_and_the_whole_comes_first() -> None:
    first, *others = parts_of(WHOLE)
    assert first == WHOLE
    assert {"ego lane-change; A cut-in brake", "A cut-in brake; B tailgate", "A cut-in"} <= set(map(said, others))
    assert all(within_the_main(part, WHOLE) for part in others)


def test_somebody_meets_the_ego_in_every_part() -> None:
    assert all(part.adversaries for part in parts_of(WHOLE))


def test_nobody_is_left_open_whom_another_deed_needs() -> None:
    waits = {"act": "brake", "when": {"after": "B.tailgate"}}
    shorter = parts_of(situation(doing(VAN, {"act": "cut-in"}, waits), BUS))
    assert set(map(said, shorter)) == {"A cut-in brake; B tailgate", "A cut-in; B tailgate"}
    assert {len(part.others) for part in parts_of(situation(doing(VAN, waits), BUS))} == {2}


def test_what_is_left_open_is_told_in_sentences() -> None:
    part = next(part for part in parts_of(WHOLE) if said(part) == "ego lane-change; A cut-in brake")
    assert left_open(part, WHOLE) == ("A bus is behind us in our lane.", "It is not the danger.", "It tailgates us.")
    assert left_open(WHOLE, WHOLE) == ()
