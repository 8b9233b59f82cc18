"""The conflicts in a report of any length: passages in which somebody does something to the ego, with what leads to it.

The project's own reader cuts it into conflicts and sentences that belong to none, whoever reads the conflicts then. A
conflict reaches over an empty line, and not into the next item, which begins with a number or a mark.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from itertools import groupby
from pathlib import Path

from chatscene.errors import NothingFits, SettingsError
from chatscene.files.bounded import check_file
from chatscene.read.learned.reader import LearnedReader
from chatscene.read.reader import LONGEST, Reader, check_english, is_english
from chatscene.terms.conflict import Conflict
from chatscene.terms.reading import SituationReading, Verdict
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import Act

MOST_BYTES = 2**20  # of a report
SENTENCES = 6  # in a row that are tried as one conflict
MAY_TELL = 0.05  # how likely the first and the last sentence of a conflict tell a situation at least

_IMPOSSIBLE = 1e-9
_GAP = re.compile(r"\n[ \t]*\n|\n(?=[ \t]*(?:\d{1,3}[.)]|[-*•])[ \t])")
_MARK = re.compile(r"^(?:\d{1,3}[.)]|[-*•])\s+")
_SENTENCE_ENDS = re.compile(r"(?<=[.!?])\s+(?=[A-Z\"'“(])")


@dataclass(frozen=True, slots=True)
class _Passage:
    """A passage of a report."""

    text: str
    tells: bool
    paragraph: int


@dataclass(frozen=True, slots=True)
class _Way:
    """A way to cut the beginning of a report.

    Attributes:
        last: Its last passage; none of an empty one.
    """

    likely: float
    last: _Passage | None = None
    before: _Way | None = None

    def passages(self) -> tuple[_Passage, ...]:
        """All passages, in order."""
        found, way = list[_Passage](), self
        while way is not None and way.last is not None:
            found.append(way.last)
            way = way.before
        return tuple(reversed(found))


def read_report(path: Path) -> str:
    """The text of a report.

    Raises:
        SettingsError: There is no such file, it is empty, too large, or no text in UTF-8.
    """
    try:
        check_file(path)
        written = path.read_bytes()
    except (OSError, ValueError) as error:
        raise SettingsError(f"the report {path} cannot be read: {getattr(error, 'strerror', None) or error}") from error
    if len(written) > MOST_BYTES:
        raise SettingsError(
            f"the report {path} has {len(written) / 2**20:.1f} MB, and at most {MOST_BYTES // 2**20} MB are read; "
            "give the part that tells what happened"
        )
    try:
        text = written.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise SettingsError(f"the report {path} is not UTF-8 text; save it as plain text") from None
    if "\0" in text:
        raise SettingsError(f"the report {path} is not text; save it as plain text in UTF-8")
    if not text.strip():
        raise SettingsError(f"the report {path} is empty; write what happened, such as a crash narrative")
    return text


def conflicts_in(
    text: str,
    name: str = "the text",
    told: Callable[[str, int, int], None] | None = None,
) -> tuple[Conflict, ...]:
    """The conflicts that a report tells, in its order.

    Raises:
        NothingFits: It tells none, or is not English.
    """
    check_english(text)
    passages = _cut(text, LearnedReader(), told or (lambda _what, _done, _of: None))
    texts = [one.text for one in passages if one.tells]
    if not texts:
        raise NothingFits(
            f"no conflict was found in {name}: nothing in it tells what a road user does to us",
            reasons=("nothing tells what a road user does to us",),
        )
    rest = (one for one in passages if not one.tells)
    left_out = tuple(" ".join(one.text for one in some) for _, some in groupby(rest, key=lambda one: one.paragraph))
    return tuple(
        Conflict(text=one, report=name, number=number, of=len(texts), left_out=left_out)
        for number, one in enumerate(texts, 1)
    )


def _cut(text: str, reader: Reader, told: Callable[[str, int, int], None]) -> tuple[_Passage, ...]:
    """A report in conflicts and sentences that belong to none: what is likeliest by the reader's probabilities.

    Likely is the product over the parts: of a conflict how sure it is of it, of a sentence without one that it tells
    no situation. That there is no conflict at all is no likelier than that the report as a whole tells none.
    """
    paragraphs = _paragraphs(text)
    sentences = [(one, i) for i, (part, _) in enumerate(paragraphs) for one in _SENTENCE_ENDS.split(part)]
    paragraph_of = [i for _, i in sentences]
    items = {paragraph_of.index(i) for i, (_, item) in enumerate(paragraphs) if item}  # where each begins

    @cache
    def read(one: str) -> SituationReading:
        if is_english(one):
            return reader.read(one)
        return SituationReading(text=one, reader=reader.name, verdict=Verdict.NO_SITUATION, tells=0.0)  # such as names

    empty = list[float]()
    for number, (one, _) in enumerate(sentences):
        told("looking for conflicts", number, len(sentences))
        empty.append(math.log(max(_IMPOSSIBLE, 1.0 - read(one).tells)))
    may_tell = [one < math.log(1.0 - MAY_TELL) for one in empty]
    best = [_Way(0.0)]  # up to each sentence
    some = _Way(-math.inf)  # of those that have a conflict, up to the last one
    for end in range(1, len(sentences) + 1):
        sentence, paragraph = sentences[end - 1]
        found = list[_Way]()
        for first in range(end - 1, max(-1, end - 1 - SENTENCES), -1):
            if may_tell[first] and may_tell[end - 1]:
                together = " ".join(one for one, _ in sentences[first:end])
                found.append(_told(best[first], together, paragraph, read))
            if first in items:
                break
        alone = _Passage(sentence, tells=False, paragraph=paragraph)
        some = max([_and(some, alone, empty[end - 1]), *found], key=_likely)
        best.append(max([_and(best[-1], alone, empty[end - 1]), some], key=_likely))
    whole = " ".join(part for part, _ in paragraphs)
    tells = read(whole).tells if len(whole) <= LONGEST else 0.0
    nothing = min(sum(empty), math.log(max(_IMPOSSIBLE, 1.0 - tells)))
    return some.passages() if some.likely > nothing else ()


def _likely(way: _Way) -> float:
    return way.likely


def _and(way: _Way, passage: _Passage, likely: float) -> _Way:
    return _Way(way.likely + likely, passage, way)


def _told(way: _Way, text: str, paragraph: int, read: Callable[[str], SituationReading]) -> _Way:
    sure = _conflict(read(text)) if len(text) <= LONGEST else 0.0
    return _and(way, _Passage(text, tells=True, paragraph=paragraph), math.log(sure) if sure > 0.0 else -math.inf)


def _conflict(read: SituationReading) -> float:
    """How sure a reader is of the conflict that a text tells; 0 if it tells none."""
    first = next(iter(read.ranked), None)
    return first.probability if first is not None and _happens(first.situation) else 0.0


def _happens(situation: Situation) -> bool:
    """Whether somebody does more than go along, where the ego does nothing either: else it only says who is there."""
    acts = {deed.act for one in situation.others for deed in one.does}
    return bool(acts - {Act.GO_ALONG}) or bool(situation.ego.does) or situation.contact is not None


def _paragraphs(text: str) -> list[tuple[str, bool]]:
    """The paragraphs of a text, none longer than a text may be, and whether each is an item; with letters in it."""
    written = [part.strip() for part in _GAP.split(text.replace("\r", ""))]
    parts = [(" ".join(_MARK.sub("", part).split()), _MARK.match(part) is not None) for part in written]
    return [(one, item) for part, item in parts for one in _short(part) if re.search(r"[^\W\d_]", one)]


def _short(paragraph: str) -> list[str]:
    """A paragraph in parts of whole sentences, none longer than a text may be."""
    parts: list[str] = []
    for sentence in _SENTENCE_ENDS.split(paragraph):
        pieces = [sentence[at : at + LONGEST] for at in range(0, len(sentence), LONGEST)]
        for piece in pieces:
            if parts and len(parts[-1]) + 1 + len(piece) <= LONGEST:
                parts[-1] = f"{parts[-1]} {piece}"
            else:
                parts.append(piece)
    return parts
