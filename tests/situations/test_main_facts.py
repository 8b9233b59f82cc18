"""When two situations are the same but for details."""

from __future__ import annotations

from typing import Any

import pytest

from chatscene.situations.form import from_plain
from chatscene.situations.main_facts import same_in_the_main


def situation(*others: dict[str, Any], **ego: Any) -> Any:
    named = [{"id": name, **one} for name, one in zip("ABC", others, strict=False)]
    return from_plain({"ego": ego, "others": named})


VAN = {"kind": "van", "starts": {"where": "ahead"}, "does": [{"act": "brake"}]}
CHILD = {"kind": "child", "starts": {"where": "roadside", "side": "right"}, "does": [{"act": "cross"}]}


def test_amounts_and_manners_are_details() -> None:
    hard = VAN | {"does": [{"act": "brake", "manner": "sudden", "acceleration": "6 m/s²"}]}
    assert same_in_the_main(situation(VAN), situation(hard, speed="50 km/h"))


def test_the_order_of_the_others_does_not_count() -> None:
    assert same_in_the_main(situation(VAN, CHILD), situation(CHILD, VAN))


@pytest.mark.parametrize("open_", [{"where": "roadside"}, {"where": "roadside", "side": "right"}])
def test_a_side_that_is_left_open_is_no_other_side(open_: dict[str, str]) -> None:
    assert same_in_the_main(situation(CHILD), situation(CHILD | {"starts": open_}))


@pytest.mark.parametrize(
    "other",
    [
        situation(CHILD | {"starts": {"where": "roadside", "side": "left"}}),
        situation(CHILD | {"kind": "pedestrian"}),
        situation(CHILD | {"does": [{"act": "stand"}]}),
        situation(CHILD, VAN),
        situation(CHILD, does=[{"act": "brake"}]),
    ],
    ids=["side", "kind", "act", "one more", "the ego's act"],
)
def test_who_where_and_what_are_the_main_facts(other: Any) -> None:
    assert not same_in_the_main(situation(CHILD), other)


def test_the_way_of_the_ego_is_a_main_fact() -> None:
    assert not same_in_the_main(situation(VAN, route="left-turn"), situation(VAN, route="straight"))
    assert same_in_the_main(situation(VAN, route="left-turn"), situation(VAN))
