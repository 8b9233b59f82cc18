"""The words that a situation was read from, held against its text: which are not in it, and which gave no fact."""

from __future__ import annotations

import re
from collections.abc import Iterator

from chatscene.read.ego_named import Span, ego_named
from chatscene.read.kinds import is_named
from chatscene.read.learned.words import tells
from chatscene.read.without_effect import without_effect
from chatscene.situations.facts import GAP, is_said, said_in, within
from chatscene.situations.phrases import KINDS
from chatscene.terms.frame import Word
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import UserKind

# The closed classes of English words: alone none of them tells a fact. Negations are not among them.
_FUNCTION = """
    a an the this that these those such
    i me my mine myself we us our ours ourselves you your yours he him his she her hers it its they them their theirs
    who whom whose which what itself himself herself themselves one
    am is are was were be been being do does did have has had having will would shall should can could may might must
    's 'm 're 've 'd 'll
    and or but so if because although though while when whenever where whereas as than then until till
    of to in on at by for from with into onto upon about off out up down over through
    just also too very there here
"""
MIRRORED = "mirrored: the text is of left-hand traffic, and here traffic keeps right, so left and right are swapped"
_FUNCTION_WORDS = frozenset(_FUNCTION.split())
_PREPOSITIONS = re.compile(r"(?i)\bin front of\b|\bbecause of\b|\bnext to\b|\bin spite of\b|\binstead of\b|\bdue to\b")
"""Those of several words, of which one is not of a closed class by itself."""
# The closed class of English modal verbs that say a duty. "There must be no contact" is told of the scene, not a duty.
_DUTY = re.compile(r"(?i)(?<!\bthere )\b(?:shall|must|should|ought to)\b(?! have\b)")
_CLAUSE_ENDS = re.compile(r"(?i)[.,;:!?\n]|\b(?:and|or|but|so)\b")
_JOINS = re.compile(r"(?i),?\s*\b(?:and|or)\s+$")  # what follows is done by the same
_DENIES = re.compile(r"(?i)^(?:['\u2019]t|not|never|no)$")
_WORD = re.compile(r"[^\W_]+(?:[-.,:/][^\W_]+)*|['\u2019][^\W\d_]+")
_APOSTROPHES = "['\u2019\u2018]"


def faults_of_quotes(situation: Situation, text: str) -> Iterator[str]:
    """What is wrong with the evidence of a situation that was read from a text, in words; nothing if all is well."""
    evidence = situation.evidence
    if not evidence.quoted:
        yield "evidence.quoted is empty; give for each fact its path and the words of the text"
    for path, words in evidence.quoted.items():
        if path != "evidence.mirrored" and not is_said(situation, path):
            yield f"evidence.quoted: {path!r} leads to no fact of the situation; write paths as in others.A.kind"
        if not spans_of(words, text):
            yield f"evidence.quoted.{path}: {words!r} is not in the text; copy its words exactly"


def without_words(situation: Situation) -> tuple[str, ...]:
    """The paths of facts for which no words are quoted."""
    return tuple(path for path, _ in said_in(situation) if not within(path, situation.evidence.quoted))


def unread(situation: Situation, text: str) -> tuple[str, ...]:
    """The words of a text that are in no quote of a situation, each run of them as it stands.

    First are those that most often told a fact where they stood in what was learned from, by the word that did so most.
    Function words and prepositions are left away, and what is known to be without effect, such as a colour.

    Words that stand in the text several times are read wherever they stand: nobody says which of them was meant.
    """
    told = dict.fromkeys(" ".join(text[start:end].split()) for start, end in unread_spans(situation, text))
    return tuple(sorted(told, key=lambda run: -max(tells(word) for word in run.split())))


def unread_spans(situation: Situation, text: str) -> list[Span]:
    """Where the words that are in no quote of a situation stand, each run of them; see `unread`."""
    read = bytearray(len(text))
    quoted = (span for words in situation.evidence.quoted.values() for span in spans_of(words, text))
    for start, end in (*quoted, *_units_read(situation, text)):
        read[start:end] = b"\1" * (end - start)
    prepositions = _prepositions(text)
    runs: list[tuple[int, int]] = []
    open_run = False  # whether all words since the last run are unread and only white space lies between
    end, denied = 0, False
    for word in _WORD.finditer(text):
        told = all(read[word.start() : word.end()])
        open_run = open_run and not told and not text[end : word.start()].strip()
        end = word.end()
        besides = without_effect(text, word.span()) and not (
            open_run and denied
        )  # "seen" tells nothing, "not seen" does
        denied = _DENIES.search(word[0]) is not None
        if told or says_nothing(word[0]) or word.start() in prepositions or besides:
            continue
        if open_run:
            runs[-1] = (runs[-1][0], end)
        else:
            runs.append(word.span())
        open_run = True
    return runs


def _units_read(situation: Situation, text: str) -> tuple[Span, ...]:
    """Where a text names the ego, and numbered units that are in a situation if there are as many."""
    named = ego_named(text)
    if not named.unit:
        return named.spans
    all_there = len({which for which, _ in named.others}) <= len(situation.others)
    return (*named.spans, *(span for _, span in named.others if all_there))


def words_of(situation: Situation, text: str) -> tuple[Word, ...]:
    """What became of each word of a text: the path of the fact that it gave, or why it is without effect."""
    facts: dict[int, str] = {}
    prepositions = _prepositions(text)
    quotes = [(span, path) for path, words in situation.evidence.quoted.items() for span in spans_of(words, text)]
    for (start, end), path in sorted(quotes, key=lambda one: one[0][0] - one[0][1]):  # the longest first
        facts |= {at: path for at in range(start, end) if at not in facts or within(path, (facts[at],))}
    units = [at for start, end in _units_read(situation, text) for at in range(start, end)]
    told: list[Word] = []
    for word in _WORD.finditer(text):
        start, end = word.span()
        idle = says_nothing(word[0]) or start in prepositions
        besides = without_effect(text, (start, end)) or ("says nothing alone" if idle else "")
        besides = "names who it is" if start in units else besides
        fact = facts.get(start, "")
        told.append(Word(text=word[0], start=start, end=end, fact=fact, besides="" if fact else besides))
    return tuple(told)


def words_told(situation: Situation) -> tuple[Word, ...]:
    """What became of each word of the text that a situation is called by; none where it was not read in that text."""
    quoted, text = situation.evidence.quoted.values(), situation.about
    return words_of(situation, text) if quoted and all(spans_of(words, text) for words in quoted) else ()


def says_nothing(word: str) -> bool:
    """Whether a word is one of the closed classes, which alone tells no fact."""
    return word.lower().replace("\u2019", "'") in _FUNCTION_WORDS


def _prepositions(text: str) -> frozenset[int]:
    """Where the prepositions of several words stand in a text."""
    return frozenset(at for found in _PREPOSITIONS.finditer(text) for at in range(*found.span()))


def left_over(situation: Situation) -> tuple[str, ...]:
    """The words that gave no fact, of a situation that is called by the text it was read in; else none."""
    return unread(situation, situation.about) if words_told(situation) else ()


def not_in_words(situation: Situation) -> tuple[str, ...]:
    """What a situation lacks of its text, and what it has beyond it, in lines for a person."""
    over = ", ".join(map(repr, left_over(situation)))
    besides = ", ".join(f"“{one}”" for one in situation.evidence.open)
    facts = ", ".join(f"{path}: {value}" for path, value in said_in(situation) if path in situation.evidence.assumed)
    return (
        *([MIRRORED] if situation.evidence.mirrored else []),
        *_who_is_who(situation),
        *([f"left open, since it is not sure enough: {besides}"] if besides else []),
        *(f"left out, since it cannot be built: {one}" for one in situation.evidence.unbuilt),
        *([f"not read: {over}"] if over else []),
        *otherwise_named(situation),
        *([f"no words of the text say {facts}"] if facts else []),
    )


def _who_is_who(situation: Situation) -> Iterator[str]:
    """Who tells the text where that is not the ego, and which of numbered units the ego is."""
    ego = KINDS[situation.ego.kind or UserKind.CAR].one
    for one in situation.others:
        if situation.evidence.quoted.get(f"others.{one.id}", "").lower() in ("i", "we"):
            yield f"you are {KINDS[one.kind].one} here ({one.id}), and not the ego, which is {ego}"
    if words_told(situation) and (unit := ego_named(situation.about).unit):
        yield f"{unit!r} is taken for the ego, {ego}"


def is_a_duty(words: str, text: str) -> bool:
    """Whether words of a text are said of what somebody shall do: behind a modal verb of duty in the same clause."""
    spans = spans_of(words, text)
    clauses = [_CLAUSE_ENDS.split(_JOINS.sub(" ", text[:start]))[-1] + text[start:end] for start, end in spans]
    return any(_DUTY.search(clause) for clause in clauses)


def otherwise_named(situation: Situation) -> Iterator[str]:
    """Whose words name no kind that they are, and which name no light, weather or state of the road that is."""
    quoted = situation.evidence.quoted
    for one in situation.others:
        path = f"others.{one.id}"
        words = quoted.get(f"{path}.kind", quoted.get(path, ""))
        if words and not is_named(one.kind, words):
            yield f"{words!r} is read as {KINDS[one.kind].one}"
    around, text = situation.around, situation.about
    for name in ("light", "weather", "surface"):
        one, words = getattr(around, name), quoted.get(f"around.{name}", "")
        if one is None:
            continue
        named = [found.span() for found in re.finditer(one.row.words, text, re.IGNORECASE)] + _stands(one.value, text)
        spans = spans_of(words, text)
        if spans and not any(low < end and start < high for low, high in named for start, end in spans):
            yield f"{words!r} is read as {one.row.said}"


def spans_of(words: str, text: str) -> list[tuple[int, int]]:
    """Where the words of a quote stand in a text, parted by gaps; none unless all are there."""
    parts = [_stands(part, text) for part in words.split(GAP)]
    return [span for part in parts for span in part] if all(parts) else []


def _stands(words: str, text: str) -> list[tuple[int, int]]:
    """Where words stand in a text as whole words, in whatever case, and with whatever white space and apostrophes."""
    pieces = [re.sub(_APOSTROPHES, _APOSTROPHES, re.escape(piece)) for piece in words.split()]
    if not pieces:
        return []
    begins = r"(?<!\w)" if pieces[0][0].isalnum() else ""
    ends = r"(?!\w)" if pieces[-1][-1].isalnum() else ""
    return [found.span() for found in re.finditer(begins + r"\s+".join(pieces) + ends, text, re.IGNORECASE)]
