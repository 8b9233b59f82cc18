"""The conflicts in a report of any length: passages in which somebody does something to the ego, with what leads to it.

Passages are paragraphs, parted by empty lines or by the number or mark that an item begins with; one that is longer
than a text may be is cut between sentences.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from chatscene.errors import NothingFits, SettingsError
from chatscene.files.bounded import check_file
from chatscene.interpret.asked import reader_of
from chatscene.read.canonical import canonical
from chatscene.read.reader import LONGEST, Reader
from chatscene.settings import RetrievalSettings
from chatscene.terms.conflict import Conflict
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import Act

MOST_BYTES = 2**20  # of a report
TELLS = 0.2  # how likely the likeliest situation of a passage is that tells a conflict

_GAP = re.compile(r"\n[ \t]*\n|\n(?=[ \t]*(?:\d{1,3}[.)]|[-*•])[ \t])")
_MARK = re.compile(r"(?:\d{1,3}[.)]|[-*•])\s+")
_SENTENCE_ENDS = re.compile(r"(?<=[.!?])\s+(?=[A-Z\"'“(])")


@dataclass(frozen=True, slots=True)
class _Passage:
    """A passage of a report: whether it tells a conflict, or at least where the ego drives and how."""

    text: str
    tells: bool
    leads: bool


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
    settings: RetrievalSettings,
    name: str = "the text",
    told: Callable[[str, int, int], None] | None = None,
) -> tuple[Conflict, ...]:
    """The conflicts that a report tells, in its order.

    A passage that tells none, and says how or where the ego drives, belongs to the next that does; behind the last, to
    that one.

    Args:
        text: The report.
        settings: Who reads it.
        name: What it is called.
        told: Told how many of its passages are read.

    Raises:
        NothingFits: It tells none.
    """
    passages: list[_Passage] = []
    written = _passages(text)
    reader = reader_of(settings)
    for number, passage in enumerate(written):
        if told is not None:
            told("looking for conflicts", number, len(written))
        passages.append(_read(passage, reader))
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
            f"no conflict was found in {name}: none of its {len(written)} passages tells what a road user does to us",
            reasons=("no passage tells what a road user does to us",),
        )
    if leading:
        texts[-1] = _joined([texts[-1]], " ".join(leading), left_out)
    found = (Conflict(text=one, report=name, number=number, of=len(texts)) for number, one in enumerate(texts, 1))
    in_order = tuple(one for one in written if one in left_out)
    return tuple(replace(one, left_out=in_order) for one in found)


def _joined(before: list[str], passage: str, left_out: list[str]) -> str:
    """A passage with what leads to it, as far back as a text may be long; the rest is left out."""
    for number in range(len(before)):
        together = " ".join((*before[number:], passage))
        if len(together) <= LONGEST:
            return together
        left_out.append(before[number])
    return passage


def _read(passage: str, reader: Reader) -> _Passage:
    read = reader.read(passage)
    situation = next(iter(read.ranked), None)
    tells = situation is not None and situation.probability >= TELLS and _happens(situation.situation)
    return _Passage(passage, tells, _says_of_ego(passage))


def _happens(situation: Situation) -> bool:
    """Whether somebody does more than go along, where the ego does nothing either: else it only says who is there."""
    acts = {deed.act for one in situation.others for deed in one.does}
    return bool(acts - {Act.GO_ALONG}) or bool(situation.ego.does) or situation.contact is not None


_OF_EGO = re.compile(r"\b(?:we|us|our|ours)\b")


def _says_of_ego(passage: str) -> bool:
    """Whether a passage speaks of the ego."""
    return _OF_EGO.search(canonical(passage)) is not None


def _passages(text: str) -> tuple[str, ...]:
    """The paragraphs of a text, none longer than a text may be; one without a letter says nothing."""
    paragraphs = (" ".join(_MARK.sub("", part.strip(), count=1).split()) for part in _GAP.split(text.replace("\r", "")))
    return tuple(one for part in paragraphs for one in _cut(part) if re.search(r"[^\W\d_]", one))


def _cut(paragraph: str) -> list[str]:
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
