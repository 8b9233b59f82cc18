"""Edits in words of situations, whoever made them: what is named changes, and what follows from it; the rest stays."""

from __future__ import annotations

from dataclasses import replace

import pytest

from chatscene.errors import EditRefused
from chatscene.interpret.edited import edited
from chatscene.interpret.offline import OfflineReader
from chatscene.situations.edited import Edited
from chatscene.situations.file import read_text
from chatscene.situations.form import from_plain
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import Act, Role, UserKind

WALKS = "A pedestrian crosses the road from the right."
BRAKES = "The car ahead of us brakes hard."
WRITTEN = """\
about: a van pulls out while a truck stops
ego: {speed: 25 km/h}
road: {kind: road, has: [school]}
others:
- id: V
  kind: van
  starts: {where: kerb, side: right}
  does:
  - {act: stand}
  - {act: pull-out, speed: 15 km/h, when: {after: T.stop}}
- {id: T, kind: truck, role: supporting, starts: {where: ahead}, does: [{act: stop, acceleration: 5 m/s²}]}
contact: {whom: V, ego: front}
"""


def said(text: str) -> Situation:
    return OfflineReader().read(text).ranked[0].situation


def changed(made: Edited) -> dict[str, tuple[object, object]]:
    return {path: (was, now) for path, was, now in made.changes}


@pytest.mark.parametrize(
    ("text", "edit", "changes"),
    [
        (WALKS, "from the left", {"others.A.starts.side": ("right", "left")}),
        (WALKS, "make it a child", {"others.A.kind": ("pedestrian", "child")}),
        (WALKS, "make it two pedestrians", {"others.A.count": (None, 2)}),
        (WALKS, "faster", {"others.A.does.0.manner": (None, "fast")}),
        (WALKS, "we drive at 45 km/h", {"ego.speed": (None, "45 km/h")}),
        ("We drive at 45 km/h. A deer crosses.", "we drive 10 km/h faster", {"ego.speed": ("45 km/h", "55 km/h")}),
        (WALKS, "slower", {"others.A.does.0.manner": (None, "slow")}),
        (WALKS, "at 3 m/s", {"others.A.does.0.speed": (None, "3 m/s")}),
        (WALKS, "it stops in the middle", {"others.A.does.1.act": (None, "stop")}),
        (WALKS, "30 m ahead", {"others.A.starts.distance": (None, "30 m")}),
        (WALKS, "when we are 10 m away", {"others.A.does.0.when.ego_within": (None, "10 m")}),
        (WALKS, "while we turn left", {"ego.route": (None, "left-turn"), "road.kind": (None, "junction")}),
        (
            WALKS,
            "at night in the rain",
            {
                "around.light": (None, "night"),
                "around.weather": (None, "rain"),  # in which the road is wet without a word
            },
        ),
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


def test_what_hides_somebody_comes_with_an_id_and_is_what_it_is_called() -> None:
    made = edited(said(WALKS), "hidden by a hedge")
    assert made.after["A"].hidden_by == "H"
    assert made.after["H"].starts == replace(made.after["A"].starts)
    assert made.after["H"].kind is UserKind.HEDGE
    stop = edited(made.after, "behind a bus stop")
    assert changed(stop) == {"others.H.kind": ("hedge", "bus-shelter")}


@pytest.mark.parametrize(
    ("edit", "changes"),
    [
        ("make it a bus", {"others.V.kind": ("van", "bus")}),
        ("from the left", {"others.V.starts.side": ("right", "left")}),
        ("5 km/h faster", {"others.V.does.1.speed": ("15 km/h", "20 km/h")}),
        ("at night", {"around.light": (None, "night")}),
    ],
)
def test_an_edit_of_a_file_leaves_what_no_edit_can_name(edit: str, changes: dict[str, tuple[object, object]]) -> None:
    made = edited(read_text(WRITTEN), edit)
    assert changed(made) == changes
    assert [one.id for one in made.after.others] == ["V", "T"]
    when = made.after["V"].does[1].when
    assert when is not None
    assert when.after == "T.stop"
    assert made.after.contact == made.before.contact
    assert made.after.road == made.before.road


def test_what_a_model_read_is_edited_as_well_and_keeps_the_words_of_what_stays() -> None:
    quoted = {"others.A": "a tram on the left", "others.A.does": "brakes"}
    tram = {"id": "A", "kind": "tram", "starts": {"where": "ahead-beside", "side": "left"}, "does": [{"act": "brake"}]}
    read = from_plain({"about": "a tram on the left brakes", "others": [tram], "evidence": {"quoted": quoted}})
    made = edited(read, "from the right")
    assert changed(made) == {"others.A.starts.side": ("left", "right")}
    kept = made.after.evidence.quoted
    assert kept["others.A.kind"] == "a tram on the left"
    assert kept["others.A.does"] == "brakes"
    assert "others.A.starts.side" not in kept  # no word of the text says so any more
    assert made.after.evidence.assumed == ()  # and whoever edits states it


def test_words_whose_fact_is_gone_stay_read() -> None:
    made = edited(said(WALKS), "from the left")
    assert made.after.evidence.quoted["about"] == "from the right"
    again = edited(made.after, "make it a cyclist")
    assert again.after.evidence.quoted["about"] == "from the right … A pedestrian"


def test_edits_add_up_and_an_edit_back_is_what_was() -> None:
    first = said(BRAKES)
    there = edited(edited(first, "make it a truck").after, "at night").after
    back = edited(edited(there, "make it a car").after, "by day").after
    assert replace(back, evidence=first.evidence) == first


def test_what_is_done_instead_takes_the_place_of_what_was_done() -> None:
    made = edited(said("A cyclist ahead of us swerves to the right."), "it stops instead of swerving")
    assert [deed.act for deed in made.after["A"].does] == [Act.STOP]


@pytest.mark.parametrize(
    ("edit", "why"),
    [
        ("make it a dragon", "not understood: 'dragon'"),
        ("from the right", "this is so already"),
        ("make it a pedestrian", "this is so already"),
        ("from the left and from the right", "left"),
        ("", "say what is to be changed"),
        ("2 m/s slower", "its speed was not said"),
    ],
)
def test_what_is_refused_says_why(edit: str, why: str) -> None:
    with pytest.raises(EditRefused, match=why):
        edited(said(WALKS), edit)


def test_where_nobody_meets_the_ego_nobody_is_edited() -> None:
    read = said(BRAKES)
    alone = replace(read, others=tuple(replace(one, role=Role.SUPPORTING) for one in read.others))
    with pytest.raises(EditRefused, match="nobody meets the ego"):
        edited(alone, "make it a truck")
