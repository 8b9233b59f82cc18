"""When two situations are the same but for details."""

from __future__ import annotations

from typing import Any

import pytest

from chatscene.situations.form import from_plain
from chatscene.situations.main_facts import same_in_the_main, within_the_main


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


HIDDEN = CHILD | {"hidden_by": "B"}
BUS = {"kind": "bus", "role": "hides", "starts": {"where": "kerb", "side": "right"}, "does": [{"act": "stand"}]}


def test_what_hides_somebody_is_a_detail_and_that_it_is_hidden_is_not() -> None:
    shelter = BUS | {"kind": "bus-shelter", "starts": {"where": "roadside", "side": "right"}, "does": []}
    assert same_in_the_main(situation(HIDDEN, BUS), situation(HIDDEN, shelter))
    assert not same_in_the_main(situation(HIDDEN, BUS), situation(CHILD))


@pytest.mark.parametrize("act", ["go-along", "go-straight"])
def test_that_somebody_goes_on_goes_without_saying(act: str) -> None:
    oncoming = {"kind": "car", "starts": {"where": "oncoming"}}
    assert same_in_the_main(situation(oncoming), situation(oncoming | {"does": [{"act": act}]}))
    turns = [{"act": act}, {"act": "turn-left"}]
    assert same_in_the_main(situation(oncoming | {"does": turns}), situation(oncoming | {"does": turns[1:]}))


def test_who_stands_before_it_sets_off_need_not_be_said_to_and_who_only_stands_is() -> None:
    car = {"kind": "car", "starts": {"where": "kerb", "side": "right"}}
    pulls_out = [{"act": "stand"}, {"act": "pull-out"}]
    assert same_in_the_main(situation(car | {"does": pulls_out}), situation(car | {"does": pulls_out[1:]}))
    assert not same_in_the_main(situation(VAN | {"does": [{"act": "stand"}]}), situation(VAN | {"does": []}))


def test_who_comes_in_from_the_next_lane_is_beside_or_ahead_there_and_not_behind() -> None:
    beside, ahead, behind = (
        situation(VAN | {"starts": {"where": where, "side": "left"}, "does": [{"act": "cut-in"}]})
        for where in ("beside", "ahead-beside", "behind-beside")
    )
    assert same_in_the_main(beside, ahead)
    assert not same_in_the_main(beside, behind)


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


def test_where_who_crosses_our_way_does_so_is_a_detail_and_where_who_waits_there_is_not() -> None:
    at_crossing = CHILD | {"starts": {"where": "exit-crossing", "side": "right"}}
    assert same_in_the_main(situation(CHILD), situation(at_crossing))
    waits = {"does": [{"act": "stand"}]}
    assert not same_in_the_main(situation(CHILD | waits), situation(at_crossing | waits))


def test_a_part_has_no_fact_that_the_whole_has_not() -> None:
    cuts_in = VAN | {"starts": {"where": "beside", "side": "left"}, "does": [{"act": "cut-in"}, {"act": "brake"}]}
    whole = situation(cuts_in, CHILD, does=[{"act": "brake"}])
    assert within_the_main(situation(cuts_in | {"does": [{"act": "cut-in"}]}), whole)
    assert within_the_main(situation(CHILD), whole)
    assert not within_the_main(situation(cuts_in | {"does": [{"act": "brake"}]}), whole)
    assert not within_the_main(situation(CHILD, does=[{"act": "stop"}]), whole)
    assert not within_the_main(whole, situation(CHILD))
