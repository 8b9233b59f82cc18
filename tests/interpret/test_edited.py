"""Edits in words of situations, whoever made them: what is named changes, and what follows from it; the rest stays."""

from __future__ import annotations

from dataclasses import replace

import pytest

from chatscene.errors import EditRefused
from chatscene.interpret.edited import edited
from chatscene.read.learned.reader import LearnedReader
from chatscene.situations.edited import Edited
from chatscene.situations.file import read_text
from chatscene.situations.form import from_plain
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import UserKind

WALKS = "A pedestrian crosses the road from the right."
BRAKES = "The car ahead of us brakes hard."
WRITTEN = """\
about: a van pulls out while a truck stops
ego: {speed: 25 km/h}
others:
- id: V
  kind: van
  starts: {where: kerb, side: right}
  does:
  - {act: pull-out, speed: 15 km/h}
- {id: T, kind: truck, role: supporting, starts: {where: ahead}, does: [{act: stop}]}
contact: {whom: V, ego: front}
"""


def said(text: str) -> Situation:
    return LearnedReader().read(text).ranked[0].situation


def changed(made: Edited) -> dict[str, tuple[object, object]]:
    return {path: (was, now) for path, was, now in made.changes}


@pytest.mark.parametrize(
    ("text", "edit", "changes"),
    [
        (WALKS, "from the left", {"others.A.starts.side": ("right", "left")}),
        (WALKS, "make it a child", {"others.A.kind": ("pedestrian", "child")}),
        (WALKS, "faster", {"others.A.does.0.manner": (None, "fast")}),
        (WALKS, "we drive at 45 km/h", {"ego.speed": (None, "45 km/h")}),
        ("We drive at 45 km/h. A deer crosses.", "we drive 10 km/h faster", {"ego.speed": ("45 km/h", "55 km/h")}),
        (WALKS, "at 3 m/s", {"others.A.does.0.speed": (None, "3 m/s")}),
        (WALKS, "then he stops", {"others.A.does.1.act": (None, "stop")}),
        (WALKS, "30 m ahead", {"others.A.starts.distance": (None, "30 m")}),
        (WALKS, "at night in the rain", {"around.light": (None, "night"), "around.weather": (None, "rain")}),
        (WALKS, "there is no contact", {"contact.happens": (None, False)}),
        (BRAKES, "make it a truck", {"others.A.kind": ("car", "truck")}),
        (BRAKES, "make it a van", {"others.A.kind": ("car", "van")}),
    ],
)
def test_what_an_edit_names_changes_and_nothing_else(
    text: str, edit: str, changes: dict[str, tuple[object, object]]
) -> None:
    made = edited(said(text), edit)
    assert changed(made) == changes
    assert made.after.about == made.before.about


def test_what_hides_somebody_comes_with_it() -> None:
    made = edited(said(WALKS), "hidden by a hedge")
    hider = made.after["A"].hidden_by
    assert hider is not None
    assert made.after[hider].kind is UserKind.HEDGE


@pytest.mark.parametrize(
    ("edit", "changes"),
    [
        ("make the van a bus", {"others.V.kind": ("van", "bus")}),
        ("the van pulls out 5 km/h faster", {"others.V.does.0.speed": ("15 km/h", "20 km/h")}),
        ("at night", {"around.light": (None, "night")}),
    ],
)
def test_an_edit_of_a_file_leaves_what_it_does_not_name(edit: str, changes: dict[str, tuple[object, object]]) -> None:
    made = edited(read_text(WRITTEN), edit)
    assert changed(made) == changes
    assert [one.id for one in made.after.others] == ["V", "T"]
    assert made.after.contact == made.before.contact
    assert made.after.road == made.before.road


def test_what_a_model_read_is_edited_as_well_and_keeps_the_words_of_what_stays() -> None:
    quoted = {"others.A": "a tram on the left", "others.A.does": "brakes"}
    tram = {"id": "A", "kind": "tram", "starts": {"where": "ahead-beside", "side": "left"}, "does": [{"act": "brake"}]}
    read = from_plain({"about": "a tram on the left brakes", "others": [tram], "evidence": {"quoted": quoted}})
    made = edited(read, "on the right")
    assert changed(made) == {"others.A.starts.side": ("left", "right")}
    kept = made.after.evidence.quoted
    assert kept["others.A.kind"] == "a tram on the left"
    assert kept["others.A.does"] == "brakes"
    assert "others.A.starts.side" not in kept  # no word of the text says so any more
    assert made.after.evidence.assumed == ()  # and whoever edits states it


def test_words_whose_fact_is_gone_stay_read() -> None:
    made = edited(said(WALKS), "from the left")
    assert "right" in made.after.evidence.quoted["about"]


def test_edits_add_up_and_an_edit_back_is_what_was() -> None:
    first = said(BRAKES)
    there = edited(edited(first, "make it a truck").after, "at night").after
    back = edited(edited(there, "make it a car").after, "in daylight").after
    around = replace(back.around, light=first.around.light)
    assert replace(back, evidence=first.evidence, around=around) == first


@pytest.mark.parametrize("edit", ["from the right", "make it a pedestrian", "thank you very much", "2 m/s slower"])
def test_what_changes_nothing_is_refused(edit: str) -> None:
    with pytest.raises(EditRefused):
        edited(said(WALKS), edit)


AHEAD = {"id": "A", "kind": "car", "starts": {"where": "ahead", "distance": "30 m"}, "does": [{"act": "brake"}]}
FOLLOWER = {"id": "B", "kind": "truck", "role": "supporting", "starts": {"where": "behind", "distance": "15 m"}}
TWO = from_plain({"others": [AHEAD, FOLLOWER | {"does": [{"act": "follow"}]}]})


@pytest.mark.parametrize(
    ("edit", "change"),
    [
        ("the car is 40 m ahead of us", ("others.A.starts.distance", "30 m", "40 m")),
        ("the truck is 25 m behind us", ("others.B.starts.distance", "15 m", "25 m")),
        ("the lorry is a bus", ("others.B.kind", "truck", "bus")),
    ],
)
def test_an_edit_that_names_somebody_changes_nobody_else_and_not_who_is_the_danger(
    edit: str, change: tuple[str, object, object]
) -> None:
    assert list(edited(TWO, edit).changes) == [change]


@pytest.mark.parametrize("edit", ["remove the truck", "Without the lorry."])
def test_who_is_removed_by_its_noun_is_gone(edit: str) -> None:
    assert [one.id for one in edited(TWO, edit).after.others] == ["A"]


def test_an_edit_that_says_more_than_a_kind_is_not_refused_for_the_kind() -> None:
    with pytest.raises(EditRefused, match="it is already a car"):
        edited(TWO, "make it a car")
    with pytest.raises(EditRefused) as refused:
        edited(TWO, "the truck is very polite")
    assert "already" not in str(refused.value)
