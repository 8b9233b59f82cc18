"""Lesser facts that cannot be built are left out and told; a situation that needs them is refused."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from chatscene.build.build import build
from chatscene.build.in_part import build_in_part, lesser
from chatscene.errors import NotBuilt
from chatscene.read.quotes import not_in_words
from chatscene.report.stated import explain_stated
from chatscene.situations.facts import with_fact
from chatscene.situations.form import from_plain
from chatscene.terms.situation import Evidence, Situation


def situation(*does: dict[str, Any], **more: Any) -> Situation:
    """A car ahead that does something, with what else is said, as if all of it was read in a text."""
    others = [{"id": "A", "kind": "car", "starts": {"where": "ahead"}, "does": list(does)}, *more.pop("others", [])]
    quoted = {f"others.{one['id']}": "so" for one in others} | {"ego": "so"}
    return from_plain({"others": others, "evidence": {"quoted": quoted}, **more})


def test_what_can_be_built_is_built_whole() -> None:
    said = situation({"act": "brake"})
    made, _ = build_in_part(said)
    assert made is said
    assert not made.evidence.unbuilt


def test_a_number_that_nobody_can_do_is_left_out_with_the_reason() -> None:
    said = situation({"act": "brake", "acceleration": "30 m/s²"})
    made, built = build_in_part(said)
    assert made.others[0].does[0].acceleration is None
    (told,) = made.evidence.unbuilt
    assert told == "others.A.does.0.acceleration: 30 m/s² (30 m/s² is more than a car can do: at most 8 m/s²)"
    assert "left out, since it cannot be built: " + told in not_in_words(made)
    assert built.program.source


def test_what_somebody_stated_is_refused_as_it_is() -> None:
    said = situation({"act": "brake", "acceleration": "30 m/s²"})
    written = with_fact(replace(said, evidence=Evidence()), "ego.route", "straight")
    changed = with_fact(situation({"act": "brake"}), "others.A.does.0.acceleration", "30 m/s²")
    for one in (written, changed):
        with pytest.raises(NotBuilt, match="at most 8 m/s²"):
            build_in_part(one)


def test_it_is_told_first_and_the_run_keeps_it() -> None:
    stated = explain_stated(situation({"act": "brake", "acceleration": "30 m/s²"}))
    assert stated.told_first[0].startswith("left out, since it cannot be built: others.A.does.0.acceleration: 30 m/s²")
    assert "unbuilt" in stated.record.text


def test_a_main_deed_that_cannot_be_done_is_refused() -> None:
    with pytest.raises(NotBuilt, match="impossible"):
        build_in_part(situation({"act": "cross"}))


def test_somebody_who_is_not_met_is_left_out_before_the_situation_is_refused() -> None:
    beside = {"id": "B", "kind": "car", "role": "supporting", "starts": {"where": "off-ramp"}, "does": []}
    made, _ = build_in_part(situation({"act": "brake"}, others=[beside]))
    assert [one.id for one in made.others] == ["A"]
    assert made.evidence.unbuilt[0].startswith("others.B: car off-ramp")


def test_nobody_is_left_out_who_meets_the_ego_or_is_waited_for() -> None:
    beside = {"id": "B", "kind": "car", "starts": {"where": "ahead-beside"}, "does": [{"act": "cut-in"}]}
    waits = situation({"act": "brake", "when": {"after": "B.cut-in"}}, others=[beside | {"role": "supporting"}])
    met = situation({"act": "brake"}, others=[beside])
    for said in (waits, met):
        assert all(len(one.situation.others) == 2 for one in lesser(said))


def test_deeds_behind_one_that_is_left_out_keep_who_waits_for_them() -> None:
    ego = {"does": [{"act": "slow-down"}, {"act": "stop"}]}
    said = situation({"act": "brake"}, {"act": "set-off", "when": {"after": "ego.1"}}, ego=ego)
    less = next(one for one in lesser(said) if one.path == "ego.does.0")
    when = less.situation.others[0].does[1].when
    assert when is not None
    assert when.after == "ego.0"


def test_the_last_deed_goes_only_if_what_it_is_there_for_is_done() -> None:
    said = situation({"act": "brake"}, {"act": "set-off"}, {"act": "exit"})
    assert {one.path for one in lesser(said)} == {"others.A.does.2"}


def test_all_facts_that_a_refusal_names_are_left_out_at_once() -> None:
    overtake = {"act": "overtake", "whom": "A", "distance": "2 m", "lateral": {"clearance": "1.5 m"}}
    said = situation({"act": "go-along"}, ego={"does": [{"act": "follow", "whom": "A"}, overtake]})
    with pytest.raises(NotBuilt, match="; ") as refused:
        build(said)
    made, _ = build_in_part(said)
    assert made.evidence.unbuilt == ("ego.does.1.distance: 2 m", "ego.does.1.lateral.clearance: 1.5 m")
    assert all(one in str(refused.value) for one in made.evidence.unbuilt)


def test_what_was_left_out_and_is_stated_then_is_told_no_more() -> None:
    made, _ = build_in_part(situation({"act": "brake", "acceleration": "30 m/s²"}))
    assert not with_fact(made, "others.A.does.0.acceleration", "6 m/s²").evidence.unbuilt
    assert with_fact(made, "ego.speed", "40 km/h").evidence.unbuilt == made.evidence.unbuilt
