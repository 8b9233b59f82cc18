"""Step 1 of 9, second half: typed facts to an English sentence or two. The way back from `decompose`.

A grammar with several phrases for every value of every slot, several orders of clauses, and five styles. It needs no
language model, says only what it is given, and reports what it said: facts may be left out at random, so that the
sentences can train and test readers.
"""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Sequence
from dataclasses import replace

from chatscene.sentences.grammar.adversary_clause import Adversary, acts, adversary
from chatscene.sentences.grammar.ego_clause import ego_clause, ego_does
from chatscene.sentences.grammar.voice import Voice
from chatscene.situations.inflection import Form, conjugated
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.conclusions import JUNCTIONS, LANE_CHANGES, TURNS
from chatscene.terms.description import Rendered, Style
from chatscene.terms.scenario import Control, Maneuver, Place, Position, Slots, includes
from chatscene.terms.slots import SLOTS

LEAVABLE = tuple(  # a blocker is what is gone around
    name for name, slot in SLOTS.items() if slot.taught and name not in ("adversary", "blocker")
)


def render(
    slots: Slots,
    behavior_texts: Sequence[str] = (),
    kind: AdversaryKind | None = None,
    *,
    rng: random.Random,
    style: Style = Style.PLAIN,
    omit: float = 0.0,
) -> Rendered:
    """Say facts in English.

    Args:
        slots: What is to be said; unfilled slots are not spoken of.
        behavior_texts: Wordings of the behavior's snippet; where one fits, it may say what the adversary does.
        kind: Who the adversary is; taken from `slots` if not given. None on both says "a road user".
        rng: All chance comes from it; the same state gives the same sentence.
        style: How it is told.
        omit: Chance in [0, 1] with which each fact is left out, or made less exact ("an intersection").

    Returns:
        The text, and the facts it says.
    """
    kept = _left_out(replace(slots, adversary=kind or slots.adversary), rng, omit)
    said = implied(kept)
    voice = Voice(kept, rng, style)
    one = adversary(voice, behavior_texts, said.place in JUNCTIONS)
    return Rendered(text=_written(voice, one, ego_does(voice, said.place in JUNCTIONS)), said=said)


def _left_out(slots: Slots, rng: random.Random, omit: float) -> Slots:
    """The slots without what chance leaves out, and without what is not there, of which nobody speaks."""
    gone: dict[str, object] = {name: None for name in ("leader", "blocker", "group") if getattr(slots, name) is False}
    if omit > 0.0:
        gone |= {name: None for name in LEAVABLE if rng.random() < omit}
        for general in (Place.JUNCTION, Place.CURVE):
            exact = slots.place if slots.place is not general else None
            if exact is not None and includes(general, exact) and rng.random() < omit:
                gone.setdefault("place", general)
        if len(slots.actions) > 1 and rng.random() < omit / 2:
            gone["actions"] = slots.actions[:-1]
        if rng.random() < omit / 6:
            gone["adversary"] = None
    return replace(slots, **gone) if gone else slots  # type: ignore[arg-type]


def implied(slots: Slots) -> Slots:
    """Facts with those that are said along with them: whoever turns does so at a junction."""
    place, control, blocker = slots.place, slots.control, slots.blocker
    if slots.maneuver is Maneuver.BYPASS:
        blocker = True
    if Action.RUN_LIGHT in slots.actions:
        control = control or Control.SIGNAL
    if place is None and (slots.maneuver in TURNS or slots.position is Position.CROSSING):
        place = Place.JUNCTION
    if control is not None and place not in JUNCTIONS:
        place = Place.JUNCTION
    over = slots.maneuver in LANE_CHANGES or slots.maneuver is Maneuver.BYPASS
    if place is None and (over or slots.lanes is not None or slots.two_way is not None):
        place = Place.ROAD
    return replace(slots, place=place, control=control, blocker=blocker)


# How the two clauses stand to each other

_Shape = Callable[[Voice, Adversary, str], str]


def _written(voice: Voice, one: Adversary, does: str) -> str:
    if voice.style is Style.TELEGRAM:
        return _telegram(voice, one, does)
    if not does:
        return _finished(f"{one.subject} {acts(voice, one, one.many)}.")
    return _finished(voice.pick(_SHAPES[voice.style])(voice, one, does))


def _telegram(voice: Voice, one: Adversary, does: str) -> str:
    ego = f"{voice.ego.subject} {conjugated(does, Form.ING)}" if does else ""
    clauses = (ego, f"{one.subject} {acts(voice, one, one.many)}")
    return _finished(_ARTICLES.sub("", voice.pick(("; ", ". ")).join(c for c in clauses if c)) + ".")


def _ego_first(voice: Voice, one: Adversary, does: str) -> str:
    word = voice.pick(("as", "while", "just as", "when"))
    clause = ego_clause(voice, does, under_way=word == "while" or voice.chance(0.6))
    return f"{word} {clause}, {one.subject} {acts(voice, one, one.many)}."


def _ego_last(voice: Voice, one: Adversary, does: str) -> str:
    word = voice.pick(("as", "while"))
    clause = ego_clause(voice, does, under_way=word == "while" or voice.chance(0.6))
    return f"{one.subject} {acts(voice, one, one.many)} {word} {clause}."


def _joined(between: str, *, under_way: float) -> _Shape:
    """The ego's clause, then the adversary's."""

    def write(voice: Voice, one: Adversary, does: str) -> str:
        ego = ego_clause(voice, does, under_way=voice.chance(under_way))
        return f"{ego}{between}{one.subject} {acts(voice, one, one.many)}."

    return write


def _stands_then_acts(voice: Voice, one: Adversary, does: str) -> str:
    if not one.stands or one.quoted:
        return _TWO(voice, one, does)
    there = f"{one.noun} {voice.be(one.many)} {one.where}".rstrip(",")
    does_it = acts(voice, one, one.many or one.pronoun == "they")
    return f"{ego_clause(voice, does, under_way=voice.chance(0.6))}. {there}. {one.pronoun} {does_it}."


def _meets(voice: Voice, one: Adversary, does: str) -> str:
    slots = voice.slots
    if slots.adversary is None or slots.position in (Position.BEHIND, Position.BEHIND_BESIDE, Position.BESIDE):
        return _TWO(voice, one, does)
    meets = voice.finite(voice.pick(("[encounter]", "[meet]", "[face]")), voice.ego.many)
    who = f"{one.subject} {'that' if one.pronoun == 'it' else 'who'} {acts(voice, one, one.many)}"
    return f"{conjugated(does, Form.ING)}, {voice.ego.subject} {meets} {who}."


def _headed(heads: tuple[str, ...], shape: _Shape) -> _Shape:
    def write(voice: Voice, one: Adversary, does: str) -> str:
        return f"{voice.pick(heads)}{shape(voice, one, does)}"

    return write


_TWO = _joined(". ", under_way=0.6)
_WHEN = _joined(" when ", under_way=1.0)
_AND = _joined(", and ", under_way=0.5)
_SEMICOLON = _joined("; ", under_way=0.5)
_WITNESSES = ("according to the report, ", "the driver stated that ", "witnesses reported that ")
_TESTS = ("scenario: ", "test case: ", "test scenario: ")
_SHAPES: dict[Style, tuple[_Shape, ...]] = {
    Style.PLAIN: (_ego_first, _ego_first, _ego_last, _ego_last, _TWO, _WHEN, _AND, _stands_then_acts, _meets),
    Style.REPORT: (_TWO, _TWO, _ego_first, _ego_last, _WHEN, _stands_then_acts, _headed(_WITNESSES, _ego_first)),
    Style.PROTOCOL: (_TWO, _TWO, _stands_then_acts, _SEMICOLON, _ego_first, _headed(_TESTS, _SEMICOLON)),
    Style.COLLOQUIAL: (_ego_first, _ego_last, _AND, _WHEN, _WHEN, _TWO, _stands_then_acts),
}

_ARTICLES = re.compile(r"\b(?:the|an?) (?!(?:few|long|great|snail)\b)")
_BEFORE_STOP = re.compile(r"\s*,(?=\s*[,.;])|\s+(?=[,.;])")
_SPACES = re.compile(r" {2,}")
_STARTS = re.compile(r"(?:^|(?<=\. )|(?<=: ))[a-z]")


def _finished(text: str) -> str:
    """A text with its spaces and commas put right and its sentences capitalised."""
    text = _BEFORE_STOP.sub("", _SPACES.sub(" ", text.strip()))
    return _STARTS.sub(lambda m: m[0].upper(), text)
