"""What counts as right is right: the judges of `library evaluate` on cases with known answers."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from chatscene.errors import SettingsError
from chatscene.library.load import load_library
from chatscene.settings import RetrievalSettings
from chatscene.studies.reading import (
    Judged,
    Sentence,
    beside,
    confusions,
    essential,
    flipped,
    judge,
    load_sentences,
    measure,
    right,
    serves,
    slot_table,
    summary_table,
)
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.scenario import Component, Control, Distance, Maneuver, Occluder, Place, Position, Side, Slots
from chatscene.terms.snippet import Snippet

B, G, S = Component.BEHAVIOR, Component.GEOMETRY, Component.SPAWN


def part(component: Component, **slots: object) -> Snippet:
    return Snippet(id="x/y", component=component, description="", rephrasings=(), slots=Slots(**slots))  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("does", "said", "expected"),
    [
        (part(G, maneuver=Maneuver.STRAIGHT, place=Place.FOUR_WAY), Slots(place=Place.JUNCTION), True),
        (part(G, maneuver=Maneuver.STRAIGHT, place=Place.JUNCTION), Slots(place=Place.FOUR_WAY), False),
        (part(G, maneuver=Maneuver.LEFT_TURN), Slots(maneuver=Maneuver.RIGHT_TURN), False),
        (part(G, maneuver=Maneuver.LEFT_TURN), Slots(control=Control.SIGNAL), False),
        (part(S, side=Side.LEFT, position=Position.ROADSIDE), Slots(side=Side.LEFT), True),
        (part(S, side=Side.LEFT), Slots(side=Side.RIGHT), False),
        (part(S, occluder=Occluder.KIOSK), Slots(), False),
        (part(S, distance=Distance.FAR), Slots(), True),
        (part(S, position=Position.AHEAD), Slots(distance=Distance.NEAR), False),
        (part(B, actions=(Action.CROSS, Action.STOP)), Slots(actions=(Action.STOP, Action.CROSS)), True),
        (part(B, actions=(Action.CROSS,)), Slots(actions=(Action.CROSS, Action.STOP)), False),
        (part(B, actions=(Action.CUT_IN, Action.CHANGE_LANE)), Slots(actions=(Action.CUT_IN,)), True),
    ],
)
def test_a_snippet_is_right_if_it_does_all_that_was_said_and_brings_nothing(
    does: Snippet, said: Slots, expected: bool
) -> None:
    assert serves(does, said, does.component) is expected


def test_coming_toward_the_ego_is_no_deed_of_its_own_where_the_position_says_so() -> None:
    one = Slots(actions=(Action.ONCOMING, Action.SWERVE), position=Position.ONCOMING)
    assert essential(one) == {Action.SWERVE}


def test_left_for_right_is_a_flip() -> None:
    assert flipped(Slots(side=Side.LEFT), [part(S, side=Side.RIGHT)])
    assert not flipped(Slots(side=Side.LEFT), [part(S, side=Side.LEFT)])
    assert flipped(Slots(maneuver=Maneuver.LEFT_TURN), [part(G, maneuver=Maneuver.RIGHT_TURN)])
    assert not flipped(Slots(maneuver=Maneuver.LEFT_TURN), [part(G, maneuver=Maneuver.STRAIGHT)])
    assert flipped(Slots(actions=(Action.TURN_LEFT,)), [part(B, actions=(Action.TURN_RIGHT,))])


def judged(said: Slots, read: Slots, *, right: bool = True, style: str = "plain") -> Judged:
    hits = dict.fromkeys(Component, right)
    sentence = Sentence(text="t", style=style, slots=said)
    return Judged(sentence=sentence, slots=read, first=hits, among_three=hits, ran=True, failures=())


def test_rates_are_of_the_sentences_in_scope_and_refusals_are_apart() -> None:
    out = Judged(
        sentence=Sentence(text="t", style="plain", in_scope=False),
        refusal="no",
        slots=Slots(),
        first=dict.fromkeys(Component, False),
        among_three=dict.fromkeys(Component, False),
    )
    lost = replace(judged(Slots(), Slots(), right=False), refusal="no")
    table = summary_table([judged(Slots(), Slots()), judged(Slots(), Slots(), right=False), lost, out])
    row = dict(zip(table.columns, table.rows[0][1], strict=True))
    assert row["in scope"].value == 3
    assert row["refused"].value == pytest.approx(1 / 3)
    assert row["behavior"].value == 0.5
    assert row["means it"].value == 1.0
    assert row["out of scope refused"].value == 1.0


def test_a_fact_read_wrongly_is_a_confusion_and_lowers_its_row() -> None:
    rows = [judged(Slots(side=Side.LEFT), Slots(side=Side.RIGHT)), judged(Slots(side=Side.LEFT), Slots(side=Side.LEFT))]
    assert confusions(rows) == [("side: left read as right", 1)]
    side = dict(slot_table(rows).rows)["side"]
    assert side[0].value == 0.5
    assert side[1].value is None


def test_a_sentence_with_an_unknown_fact_names_its_line(tmp_path: Path) -> None:
    path = tmp_path / "mine.jsonl"
    good = {"text": "a", "style": "plain", "slots": {"side": "left"}}
    path.write_text(json.dumps(good) + "\n" + json.dumps(good | {"slots": {"side": "up"}}), encoding="utf-8")
    with pytest.raises(SettingsError, match="line 2"):
        load_sentences(path)
    with pytest.raises(SettingsError, match="cannot be read"):
        load_sentences(tmp_path / "none.jsonl")


HELD_OUT = pytest.mark.parametrize(("name", "least"), [("held-out", 300), ("second", 250)])


@HELD_OUT
def test_the_held_out_sentences_are_many_and_written_for_snippets_that_exist(name: str, least: int) -> None:
    held = load_sentences(name)
    ids = {snippet.id for snippet in load_library()}
    inside = [s for s in held if s.in_scope]
    assert len(inside) >= least
    assert len(held) - len(inside) >= 60
    assert {s.behavior for s in inside} <= ids
    assert len({s.text for s in held}) == len(held)


@HELD_OUT
def test_nothing_leaks_from_the_sentences_that_the_reader_learned_from(name: str, least: int) -> None:
    held, learned = load_sentences(name), load_sentences("fitting")
    assert not {s.style for s in held if s.in_scope} & {s.style for s in learned if s.in_scope}
    assert not {s.behavior for s in held if s.in_scope} & {s.behavior for s in learned if s.in_scope}


def test_a_text_that_is_not_english_is_refused_and_the_others_are_judged() -> None:
    settings, german = RetrievalSettings(), "Ein Radfahrer kommt von rechts und nimmt uns die Vorfahrt."
    refused = judge(Sentence(style="other", text=german, in_scope=False), settings, drive=False)
    assert "English" in refused.refusal
    assert refused.slots == Slots()


def test_the_very_snippet_that_a_sentence_was_written_for_is_right() -> None:
    turning = load_library().get("behavior/lead-u-turn")
    said = Slots(actions=(Action.SLOW, Action.U_TURN), position=Position.AHEAD)
    for behavior, expected in (("behavior/lead-u-turn", True), ("behavior/oncoming-u-turn", False)):
        sentence = Sentence(text="It slowed and came round.", style="plain", slots=said, behavior=behavior)
        assert right(turning, sentence, B) is expected


def test_the_neighbouring_lane_has_the_side_that_the_geometry_gives_it() -> None:
    library = load_library()
    spawn = library.get("spawn/adjacent-lane-behind")
    sides = {
        name: beside(spawn, library.get(f"geometry/{name}")).slots.side
        for name in ("lane-change-left", "wide-road-lane-on-right", "straight-multi-lane")
    }
    assert sides == {"lane-change-left": Side.LEFT, "wide-road-lane-on-right": Side.RIGHT, "straight-multi-lane": None}
    assert beside(library.get("spawn/ahead-in-lane"), library.get("geometry/lane-change-left")).slots.side is None


def silent(what: str, done: int, total: int) -> None:
    """Nobody watches."""


def test_a_sentence_is_read_found_and_driven() -> None:
    sentence = Sentence(
        text="A pedestrian crosses from the right.",
        style="plain",
        slots=Slots(
            adversary=AdversaryKind.PEDESTRIAN,
            actions=(Action.CROSS,),
            side=Side.RIGHT,
            position=Position.ROADSIDE,
        ),
    )
    nonsense = Sentence(text="Stir the soup for ten minutes.", style="plain", in_scope=False)
    one, other = measure([sentence, nonsense], settings=RetrievalSettings(), progress=silent)
    assert (one.refusal, one.ran, one.failures) == ("", True, ())
    assert all(one.first.values())
    assert other.refusal
