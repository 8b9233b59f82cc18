"""What several acts of a situation have in common follows from their rows; no other file lists acts."""

from __future__ import annotations

import re

import pytest

from chatscene.errors import ChatSceneError
from chatscene.program import doing
from chatscene.program.measured import MEASURED
from chatscene.situations.phrases import ACTS, inflected
from chatscene.terms.vocabulary import LETS_GO, LOSES, SLOWS, Act, Heads, Tempo, acts_of, by_act
from listed import members
from places import ROOT

SOURCE = ROOT / "src" / "chatscene"
ELSEWHERE = {
    "build/deeds.py": "how each is driven",
    "build/rates.py": "how each is driven at a rate that was said",
    "build/own.py": "how far and how long the ego is steered by each",
    "build/parts.py": "what each is that somebody lets go of",
    "build/place.py": "which of those that stay in a lane are done before who is ahead turns off",
    "build/waiting.py": "what is seen of a body that was let go of",
    "interpret/situation_rows.py": "which act of a situation each act of a snippet is",
    "interpret/slots_of.py": "which act of a snippet each of these is, for an edit",
    "program/doing.py": "a test on tracks for each",
    "program/own.py": "what is seen of an ego that was told to",
    "situations/phrases.py": "the phrases of those that are not said as they are named",
    "verdict/moves.py": "which of those that look alike is told",
}
"""Where acts are listed, and why no trait could give the list."""
UNMEASURED = {
    "go-straight.time": "how long before the ego meets it, which is a time of two",
    "turn-left.time": "the same",
    "turn-right.time": "the same",
    "accelerate.distance": "the way over which speed is gained has no test yet",
    "lane-change.distance": "the way within which lanes are changed has no test yet",
}
"""Amounts that an act may have and no test on tracks tells."""
EITHER_SIDE = frozenset(("TURN_LEFT", "TURN_RIGHT"))

every_act = pytest.mark.parametrize("act", Act)


def listed(source: str) -> list[int]:
    """The lines of a Python file where a list, a set or a table has more than one act in it."""
    return [line for line, names in members(source, ("Act", "Said")) if names != EITHER_SIDE]


def test_no_other_file_lists_acts() -> None:
    found = {
        str(path.relative_to(SOURCE)): lines for path in SOURCE.rglob("*.py") if (lines := listed(path.read_text()))
    }
    said = (
        "give the acts a trait in their rows (terms/vocabulary.py) and ask for it by acts_of, or name the reason here"
    )
    assert set(found) == set(ELSEWHERE), f"{said}: { ({one: found[one] for one in found if one not in ELSEWHERE}) }"


def test_a_list_of_acts_is_recognised_as_one() -> None:
    head = "from chatscene.terms.vocabulary import Act, Where\n"
    for source in (
        "X = frozenset((Act.STOP, Act.PARK))",
        "x in (Act.STOP, Act.PARK)",
        "X = {Act.STOP: 1, Act.PARK: 2}",
    ):
        assert listed(head + source) == [2]
    assert not listed(head + "f(Act.STOP, Act.PARK); x = [Act.STOP, Act.STOP, Where.ARM]")


@every_act
def test_an_act_says_what_comes_of_its_speed_or_where_it_heads(act: Act) -> None:
    said = act.row.tempo is not Tempo.ANY or act.row.heads is not Heads.ANY or act in LETS_GO
    assert said, f"terms/vocabulary.py: the row of {act} has neither a Tempo nor a Heads: no rule of any of them holds"


@pytest.mark.parametrize("trait", [one for one in (*Tempo, *Heads) if one.name != "ANY"])
def test_a_trait_is_one_of_some_act(trait: Tempo | Heads) -> None:
    assert acts_of(trait)


def test_what_holds_of_acts_is_said_by_their_own_row_first_then_by_where_they_head() -> None:
    assert acts_of(Tempo.PAUSES, Heads.BY) == {Act.HESITATE, Act.OVERTAKE}
    assert {Act.HESITATE} == LOSES - SLOWS
    rows = {Act.TURN_LEFT: 1, Heads.TURNS: 2, Tempo.HALTS: 3}
    assert by_act(rows) == {Act.TURN_LEFT: 1, Act.TURN_RIGHT: 2, Act.STOP: 3}


@every_act
def test_a_phrase_begins_with_a_verb_in_its_three_forms(act: Act) -> None:
    verb = re.match(r"\[([\w-]+)/([\w-]+)/([\w-]+)\]", ACTS[act].does)
    assert verb or ACTS[act].does.startswith("{goes}")
    if verb is not None:
        assert verb.groups() == inflected(verb[1]), "write its phrase in phrases.py"


@every_act
def test_an_act_has_a_test_on_tracks(act: Act) -> None:
    doing.seen_by(act)


def test_an_act_without_a_test_on_tracks_is_refused_with_the_place_of_its_row(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(doing, "ACTS", {act: sees for act, sees in doing.ACTS.items() if act is not Act.WEAVE})
    with pytest.raises(ChatSceneError, match=r"does weave: give ACTS in program/doing\.py a row"):
        doing.seen_by(Act.WEAVE)


@every_act
def test_an_amount_that_an_act_may_have_is_measured_on_tracks_or_said_not_to_be(act: Act) -> None:
    unmeasured = {f"{act}.{name}" for name in act.row.takes if act not in MEASURED[name]}
    said = "give its act or its trait a row in LONG (time) or FAR (distance), program/amounts.py, or name it here"
    assert unmeasured == {one for one in UNMEASURED if one.startswith(f"{act}.")}, said
