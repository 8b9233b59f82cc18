"""The conflicts in a report of any length: passages in which somebody does something to the ego, with what leads to it.

Paragraphs are parted by empty lines or by the number or mark that an item begins with; one that is longer than a text
may be is cut between sentences. The project's own reader cuts each into conflicts and sentences that belong to none,
whoever reads the conflicts then.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

from chatscene.errors import NothingFits, SettingsError
from chatscene.files.bounded import check_file
from chatscene.read.canonical import canonical
from chatscene.read.learned.reader import LearnedReader
from chatscene.read.reader import LONGEST, Reader
from chatscene.terms.conflict import Conflict
from chatscene.terms.reading import SituationReading
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import Act

MOST_BYTES = 2**20  # of a report
SENTENCES = 5  # in a row that are tried as one conflict
MAY_TELL = 0.05  # how likely a sentence tells a situation for which those around it are tried with it

_IMPOSSIBLE = 1e-9
_GAP = re.compile(r"\n[ \t]*\n|\n(?=[ \t]*(?:\d{1,3}[.)]|[-*•])[ \t])")
_MARK = re.compile(r"^(?:\d{1,3}[.)]|[-*•])\s+")
_SENTENCE_ENDS = re.compile(r"(?<=[.!?])\s+(?=[A-Z\"'“(])")


@dataclass(frozen=True, slots=True)
class _Passage:
    """A passage of a report.

    Attributes:
        text: Its words.
        tells: Whether it tells a conflict.
        leads: Whether it stands in a paragraph without a conflict that speaks of the ego.
    """

    text: str
    tells: bool
    leads: bool = False


_Way = tuple[float, tuple[_Passage, ...]]  # how likely it is, in nats, and its parts


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
        raise SettingsError(f"the report {path} is no text in UTF-8; save it as plain text") from None
    if "\0" in text:
        raise SettingsError(f"the report {path} is no text; save it as plain text in UTF-8")
    if not text.strip():
        raise SettingsError(f"the report {path} is empty; write what happened, such as a crash narrative")
    return text


def conflicts_in(
    text: str,
    name: str = "the text",
    told: Callable[[str, int, int], None] | None = None,
) -> tuple[Conflict, ...]:
    """The conflicts that a report tells, in its order.

    A paragraph that tells none, and says how or where the ego drives, belongs to the next conflict; behind the last, to
    that one.

    Args:
        text: The report.
        name: What it is called.
        told: Told how many of its paragraphs are read.

    Raises:
        NothingFits: It tells none.
    """
    passages: list[_Passage] = []
    written = _paragraphs(text)
    reader = LearnedReader()
    for number, paragraph in enumerate(written):
        if told is not None:
            told("looking for conflicts", number, len(written))
        passages.extend(_cut(paragraph, reader))
    texts: list[str] = []
    leading, left_out = list[str](), list[str]()
    for passage in passages:
        if passage.tells:
            texts.append(_joined(leading, passage.text, left_out))
            leading = []
        else:
            (leading if passage.leads else left_out).append(passage.text)
    if not texts:
        raise NothingFits(
            f"no conflict was found in {name}: none of its {len(written)} paragraphs tells what a road user does to us",
            reasons=("no paragraph tells what a road user does to us",),
        )
    if leading:
        texts[-1] = _joined([texts[-1]], " ".join(leading), left_out)
    found = (Conflict(text=one, report=name, number=number, of=len(texts)) for number, one in enumerate(texts, 1))
    in_order = tuple(one.text for one in passages if one.text in left_out)
    return tuple(replace(one, left_out=in_order) for one in found)


def _joined(before: list[str], passage: str, left_out: list[str]) -> str:
    """A passage with what leads to it, as far back as a text may be long; the rest is left out."""
    for number in range(len(before)):
        together = " ".join((*before[number:], passage))
        if len(together) <= LONGEST:
            return together
        left_out.append(before[number])
    return passage


def _cut(paragraph: str, reader: Reader) -> list[_Passage]:
    """A paragraph in conflicts and sentences that belong to none: what is likeliest by the reader's probabilities.

    Likely is the product over the parts: of a conflict how sure it is of it, of a sentence without one that it tells
    no situation. That there is no conflict at all is no likelier than that the paragraph as a whole tells none.
    """
    sentences = _SENTENCE_ENDS.split(paragraph)
    read = cache(reader.read)
    empty = [math.log(max(_IMPOSSIBLE, 1.0 - read(one).tells)) for one in sentences]
    may_tell = [one < math.log(1.0 - MAY_TELL) for one in empty]
    best: list[_Way] = [(0.0, ())]  # up to each sentence
    some: list[_Way] = [(-math.inf, ())]  # of those that have a conflict
    for end in range(1, len(sentences) + 1):
        alone = _Passage(sentences[end - 1], tells=False)
        starts = [at for at in range(max(0, end - SENTENCES), end) if any(may_tell[at:end])]
        if end == len(sentences) > SENTENCES:
            starts.insert(0, 0)
        found = [_told(best[at], " ".join(sentences[at:end]), read) for at in starts]
        some.append(max([_and(some[-1], alone, empty[end - 1]), *found], key=_likely))
        best.append(max([_and(best[-1], alone, empty[end - 1]), some[-1]], key=_likely))
    nothing = min(sum(empty), math.log(max(_IMPOSSIBLE, 1.0 - read(paragraph).tells)))
    likely, parts = some[-1]
    return list(parts) if likely > nothing else [_Passage(paragraph, tells=False, leads=_says_of_ego(paragraph))]


def _likely(way: _Way) -> float:
    return way[0]


def _and(way: _Way, passage: _Passage, likely: float) -> _Way:
    return way[0] + likely, (*way[1], passage)


def _told(way: _Way, text: str, read: Callable[[str], SituationReading]) -> _Way:
    sure = _conflict(read(text)) if len(text) <= LONGEST else 0.0
    return _and(way, _Passage(text, tells=True), math.log(sure) if sure > 0.0 else -math.inf)


def _conflict(read: SituationReading) -> float:
    """How sure a reader is of the conflict that a text tells; 0 if it tells none."""
    first = next(iter(read.ranked), None)
    return first.probability if first is not None and _happens(first.situation) else 0.0


def _happens(situation: Situation) -> bool:
    """Whether somebody does more than go along, where the ego does nothing either: else it only says who is there."""
    acts = {deed.act for one in situation.others for deed in one.does}
    return bool(acts - {Act.GO_ALONG}) or bool(situation.ego.does) or situation.contact is not None


_OF_EGO = re.compile(r"\b(?:we|us|our|ours)\b")


def _says_of_ego(passage: str) -> bool:
    """Whether a passage speaks of the ego."""
    return _OF_EGO.search(canonical(passage)) is not None


def _paragraphs(text: str) -> tuple[str, ...]:
    """The paragraphs of a text, none longer than a text may be; one without a letter says nothing."""
    paragraphs = (" ".join(_MARK.sub("", part.strip(), count=1).split()) for part in _GAP.split(text.replace("\r", "")))
    return tuple(one for part in paragraphs for one in _short(part) if re.search(r"[^\W\d_]", one))


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
