"""The learned reader: one model from a text to ranked situations."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from pathlib import Path

from chatscene.read.blows import settled
from chatscene.read.ego_named import owned_kind
from chatscene.read.kinds import finer, is_named
from chatscene.read.learned.decoder import Decoder, Written
from chatscene.read.learned.evidence import marked_in, quoted_of
from chatscene.read.learned.grammar import NAMES
from chatscene.read.learned.narrator import DRIVES, MOST, ON_FOOT, SOMEBODY, SURE, clauses, of_somebody, told_by
from chatscene.read.learned.numbers import is_gap, lasts
from chatscene.read.learned.sequence import path_of, situation_of, verdict_of
from chatscene.read.learned.text import Read, prepared
from chatscene.read.learned.weights import PACKAGED, load
from chatscene.read.quotes import is_a_duty, spans_of, unread, without_words
from chatscene.read.reader import check_english, check_text
from chatscene.read.users_unread import users_unread
from chatscene.settings import OFFLINE
from chatscene.situations.facts import is_said, with_fact
from chatscene.situations.faults import Malformed
from chatscene.situations.main_facts import same_in_the_main, within_the_main
from chatscene.situations.parts import fullness, left_open, parts_of
from chatscene.terms.reading import Ranked, SituationReading, Verdict
from chatscene.terms.situation import Evidence, Situation
from chatscene.terms.surroundings import Weather
from chatscene.terms.vocabulary import Feature, Heads, UserKind, acts_of

PLUGIN = {
    "name": "offline",
    "makes": "LearnedReader",
    "what": "networks that are packaged, on this machine",
}

YOU_ON_FOOT = (
    "you are on foot in it, but the ego drives or rides; write it as the driver who meets you, as in 'a pedestrian "
    "crosses from the right while we turn left'"
)
_KIND = "Other.kind"
_LEAVES_A_GAP = acts_of(Heads.BEFORE, Heads.MERGES, Heads.BEHIND)
"""Acts whose time is the gap to somebody."""
_ROWS = ((Feature.PARKED_CARS,), (Feature.PARKED_BOTH_SIDES,))
"""What a road has that is a row of road users, if it has nothing else."""
_LEFT = 3
"""Readings of which parts are looked at."""
_SURE, _IMPOSSIBLE = 1.0 - 1e-6, 1e-6


@dataclass(frozen=True, slots=True)
class LearnedReader:
    """Reads with what was learned; see `chatscene.read.reader.Reader` for the contract."""

    weights: Path = field(default=PACKAGED)

    @property
    def name(self) -> str:
        """``offline``."""
        return OFFLINE

    def read(self, text: str) -> SituationReading:
        """What a text tells.

        The probability of a situation is that of all sequences that come to its main facts.

        Raises:
            SettingsError: The text is empty or too long.
            NothingFits: It is not English.
            SnippetError: The file of what was learned is missing or damaged.
        """
        check_text(text)
        check_english(text)
        read = prepared(text)
        written = written_of(read, self.weights)
        verdicts = dict.fromkeys(Verdict, 0.0)
        for one in written:
            verdicts[verdict_of(one.steps)] += math.exp(one.likely)
        on_foot = _tells_on_foot(read, ways_of(written), self.weights)
        ranked = ranked_of(read, written, on_foot=on_foot, weights=self.weights)
        tells = verdicts[Verdict.SITUATION] / sum(verdicts.values())
        verdict = max(verdicts, key=lambda one: verdicts[one])
        if verdict is not Verdict.SITUATION or not ranked:
            refused = max((one for one in Verdict if one is not Verdict.SITUATION), key=lambda one: verdicts[one])
            return SituationReading(text=text, reader=self.name, verdict=refused, tells=tells)
        if on_foot and not (ranked := tuple(one for one in ranked if _is_met_on_foot(one.situation))):
            return SituationReading(
                text=text, reader=self.name, verdict=Verdict.OUT_OF_REACH, reason=YOU_ON_FOOT, tells=tells
            )
        trust = load(self.weights)
        sure = _trusted(ranked, *trust.trust)
        return SituationReading(
            text=text,
            reader=self.name,
            verdict=Verdict.SITUATION,
            ranked=sure,
            parts=_trusted(parts_read(ranked), *trust.trust_in_parts),
            unread=unread(sure[0].situation, text),
            tells=tells,
        )


def written_of(read: Read, weights: Path) -> tuple[Written, ...]:
    """The likeliest sequences of a text, the likeliest first."""
    return _decoder(weights).written(read)


@lru_cache(maxsize=2)
def _decoder(weights: Path) -> Decoder:
    return Decoder(load(weights))


@dataclass(frozen=True, slots=True, eq=False)
class Way:
    """A situation that a text may tell.

    Attributes:
        situation: The situation, whose others are called A, B, C….
        probability: That of all sequences that come to it, in [0, 1].
    """

    situation: Situation
    probability: float
    written: Written


def ways_of(written: Sequence[Written]) -> tuple[Way, ...]:
    """The situations that sequences come to and that are not against themselves, the likeliest first."""
    likely: dict[Situation, float] = {}
    first: dict[Situation, Written] = {}
    for one in written:
        if verdict_of(one.steps) is not Verdict.SITUATION:
            continue
        try:
            situation = situation_of(one.steps)
        except Malformed:
            continue
        if situation.others:
            likely[situation] = likely.get(situation, 0.0) + math.exp(one.likely)
            first.setdefault(situation, one)
    return tuple(Way(one, likely[one], first[one]) for one in sorted(likely, key=lambda one: -likely[one]))


def ranked_of(
    read: Read, written: Sequence[Written], *, on_foot: bool = False, weights: Path = PACKAGED
) -> tuple[Ranked, ...]:
    """The situations that differ in the main, the likeliest first.

    The probability of one is that of all sequences that come to a situation with the same main facts, of which it
    is the likeliest.
    """
    told: dict[Way, float] = {}
    never = [kind for kind in _never_learned(weights) if is_named(kind, read.text)]
    for one in (_by_nouns(_by_grammar(way, read), read, never) for way in ways_of(written)):
        same = next((way for way in told if same_in_the_main(one.situation, way.situation)), one)
        told[same] = told.get(same, 0.0) + one.probability  # each counts for one of them
    ranked = (Ranked(situation=_evident(one, read, on_foot=on_foot), probability=p) for one, p in told.items())
    return tuple(sorted(ranked, key=lambda one: -one.probability))


@lru_cache(maxsize=2)
def _never_learned(weights: Path) -> tuple[UserKind, ...]:
    """The kinds that came after a reader was trained."""
    known = {word for key, word in load(weights).tokens if key == _KIND}
    return tuple(kind for kind in UserKind if kind.value not in known)


def _by_nouns(way: Way, read: Read, never: Sequence[UserKind]) -> Way:
    """A way whose road users are of the kinds that were never learned, where the text calls them by a noun of one."""
    if not never:
        return way
    marked = marked_in(read, way.written)

    def of(kind: UserKind, path: str) -> UserKind:
        found = (finer(kind, place, read.text, never) for place in marked.get(path, ()))
        return next((one for one in found if one is not kind), kind)

    situation = way.situation
    ego = situation.ego
    if ego.kind is not None and (one := of(ego.kind, "ego.kind")).may_be_ego:
        ego = replace(ego, kind=one)
    others = tuple(replace(one, kind=of(one.kind, f"others.{one.id}.kind")) for one in situation.others)
    return replace(way, situation=replace(situation, ego=ego, others=others))


def _by_grammar(way: Way, read: Read) -> Way:
    """A way whose ego is what is said to be the narrator's, and whose contact is as the grammar of the text has it.

    It has no contact that is denied only since somebody has to avoid it: what a driver shall do is not told. Nor has it
    a gap where the text says how long something lasts, or the reverse, or parked cars of the road that are somebody of
    their own.
    """
    situation, owned = _under_its_sky(_once(way, read), quoted_of(read, way.written)), owned_kind(read.text)
    if owned is not None and situation.ego.kind is None and not _told_by(way, read):
        situation = replace(situation, ego=replace(situation.ego, kind=owned[0]))
    contact = situation.contact
    if contact is not None and contact.happens is False:
        words = quoted_of(read, way.written).get("contact.happens", "")
        situation = replace(situation, contact=None if is_a_duty(words, read.text) else contact)
    return replace(way, situation=settled(situation, read.text, marked_in(read, way.written)))


def _under_its_sky(situation: Situation, quoted: Mapping[str, str]) -> Situation:
    """A situation whose weather is what its words name, where that was never learned and it was taken for another."""
    was, words = situation.around.weather, quoted.get("around.weather", "")
    if was is None or re.search(was.row.words, words, re.IGNORECASE):
        return situation
    named = next((one for one in Weather if re.search(one.row.words, words, re.IGNORECASE)), was)
    return replace(situation, around=replace(situation.around, weather=named))


def _once(way: Way, read: Read) -> Situation:
    """The situation of a way without what the words of something else were taken for."""
    situation, steps = way.situation, way.written.steps
    for at, found in way.written.found:
        path = path_of(steps, at)
        who, _, field = path.rpartition(".does.")
        if field.endswith(".time"):
            deed = situation.does(who.removeprefix("others."))[int(field.partition(".")[0])]
            of_another = lasts if deed.act in _LEAVES_A_GAP else is_gap
            situation = with_fact(situation, path, None) if of_another(read.text, found) else situation
    quoted = quoted_of(read, way.written)
    row = quoted.get("road.has", "")
    if situation.road.has in _ROWS and len(spans_of(row, read.text)) == 1:
        whose = (quoted.get(f"others.{one.id}.kind", "") for one in situation.others)
        if any(row in words for words in whose):
            situation = replace(situation, road=replace(situation.road, has=()))
    return situation


def _evident(way: Way, read: Read, *, on_foot: bool) -> Situation:
    situation, owned = way.situation, owned_kind(read.text)
    said = {**quoted_of(read, way.written), **_told_by(way, read, on_foot=on_foot)}
    if owned is not None and situation.ego.kind is owned[0]:
        said.setdefault("ego.kind", owned[1])
    quoted = {path: words for path, words in said.items() if is_said(situation, path)}
    made = replace(situation, about=read.text, evidence=Evidence(quoted=quoted))
    return replace(made, evidence=replace(made.evidence, assumed=without_words(made)))


def _told_by(way: Way, read: Read, *, on_foot: bool = False) -> dict[str, str]:
    return told_by(way.situation, read.text, marked_in(read, way.written), on_foot=on_foot)


def _tells_on_foot(read: Read, ways: Sequence[Way], weights: Path) -> bool:
    """Whether who tells a text is on foot: the reader takes somebody who does the same for one who is."""
    marked = marked_in(read, ways[0].written) if ways else {}
    driven = [span for path in DRIVES for span in marked.get(path, ())]
    told = tuple(clauses(read.text))
    if any(low <= start and end <= high for low, high in told for start, end in driven):
        return False
    sentences = dict.fromkeys(of_somebody(read.text[low:high]) for low, high in told[:MOST])
    return any(_share_on_foot(sentence, weights) >= SURE for sentence in sentences)


@lru_cache(maxsize=256)
def _share_on_foot(sentence: str, weights: Path) -> float:
    """How likely the somebody of a sentence, who is alone in it, is on foot."""
    read, share = prepared(sentence), 0.0
    for way in ways_of(written_of(read, weights)):
        spans = marked_in(read, way.written).get(f"others.{NAMES[0]}.kind", ())
        if len(way.situation.others) == 1 and any(start < len(SOMEBODY) for start, _ in spans):
            share += way.probability * (way.situation.others[0].kind in ON_FOOT)
    return share


def _is_met_on_foot(situation: Situation) -> bool:
    return any(one.kind in ON_FOOT for one in situation.adversaries)


def parts_read(ranked: Sequence[Ranked]) -> tuple[Ranked, ...]:
    """What is left of the likeliest readings if some of each is left open: the fullest first, each surer than before.

    A part is as likely as all readings together that have its facts.
    """
    found: list[Ranked] = []
    for one in ranked[:_LEFT]:
        for part in parts_of(one.situation):
            likely = sum(each.probability for each in ranked if within_the_main(part, each.situation))
            found.append(Ranked(situation=part, probability=likely))
    surest: list[Ranked] = []
    for one in sorted(found, key=lambda one: (-fullness(one.situation), -one.probability)):
        if not surest or one.probability > surest[-1].probability:
            surest.append(one)
    return tuple(replace(one, situation=_told_in_part(one.situation, ranked[0].situation)) for one in surest)


def _told_in_part(part: Situation, whole: Situation) -> Situation:
    """A part with its own evidence, and with what is left open: whom neither has, and what else the whole tells."""
    quoted = {path: words for path, words in part.evidence.quoted.items() if is_said(part, path)}
    nobody = set(users_unread(whole, whole.about))
    named = (word for word in users_unread(part, part.about) if word in nobody)
    made = replace(part, evidence=Evidence(quoted=quoted, open=(*named, *left_open(part, whole))))
    return replace(made, evidence=replace(made.evidence, assumed=without_words(made)))


def _trusted(ranked: Sequence[Ranked], scale: float, offset: float) -> tuple[Ranked, ...]:
    """Readings whose probabilities are as often right as they say."""

    def of(likely: float) -> float:
        sure = min(max(likely, _IMPOSSIBLE), _SURE)
        return 1 / (1 + math.exp(-(scale * math.log(sure / (1 - sure)) + offset)))

    return tuple(replace(one, probability=of(one.probability)) for one in ranked)
