"""What every reader owes; see `chatscene.read.reader.Reader`."""

from __future__ import annotations

from collections.abc import Callable

from chatscene.errors import SettingsError
from chatscene.read.quotes import faults_of_quotes
from chatscene.read.reader import LONGEST, Reader, load_reader
from chatscene.situations.check import faults_of
from chatscene.terms.reading import SituationReading, Verdict
from chatscene.testing.contract import maker, require

TEXTS = (
    "A car ahead of us brakes hard.",
    "At dusk a cyclist crosses from the left, 20 m ahead, while we drive at 50 km/h.",
    "We turn left at a junction.\nAn oncoming truck goes straight on.",
    "I like cheese.",
)
ROUNDING = 1e-6


def check_reader(reader: str | Callable[[], Reader]) -> None:
    """Hold a reader to the contract of all.

    Args:
        reader: Its name, ``package.module:factory``, or what makes one.

    Raises:
        ContractBroken: It breaks a rule; the message says which.
        SettingsError: There is none of that name.
        MissingExtra: Its package is missing.
    """
    make = maker(reader, load_reader)
    one = make()
    require(bool(one.name.strip()), "a reader has a name", one.name)
    for text, wrong in (("", "empty"), (" \n", "empty"), ("a" * (LONGEST + 1), "too long")):
        require(_refuses(one, text), f"a text that is {wrong} is refused with a SettingsError")
    for text in TEXTS:
        found = one.read(text)
        _check_reading(found, one.name, text)
        again = (one.read(text), make().read(text))
        require(again == (found, found), "the same text gives the same reading, whatever was read before", text)


def _refuses(reader: Reader, text: str) -> bool:
    try:
        reader.read(text)
    except SettingsError:
        return True
    return False


def _check_reading(found: SituationReading, name: str, text: str) -> None:
    require(found.text == text, "a reading has its text, as it was given", found.text)
    require(found.reader == name, "a reading has the name of its reader", found.reader)
    require(0.0 <= found.tells <= 1.0, "how likely it is that a text tells a situation is in [0, 1]", found.tells)
    told = found.verdict is Verdict.SITUATION
    require(bool(found.ranked) == told, "a reading has situations if its verdict says so, and only then", found.verdict)
    likely = [one.probability for one in found.ranked]
    require(likely == sorted(likely, reverse=True), "the likeliest situation comes first", likely)
    rightly = all(0.0 <= one <= 1.0 for one in likely) and sum(likely) <= 1.0 + ROUNDING
    require(rightly, "probabilities are in [0, 1], and all of them together", likely)
    in_parts = [one.probability for one in found.parts]
    require(in_parts == sorted(in_parts), "what is left of a situation is surer, the more is left open", in_parts)
    for one in (*found.ranked, *found.parts):
        wrong = [str(fault) for fault in faults_of(one.situation)]
        require(not wrong, "a situation is not against itself", wrong)
        unsaid = list(faults_of_quotes(one.situation, text))
        require(not unsaid, "the words that gave a fact are words of the text, and the fact is there", unsaid)
    require(all(words in text for words in found.unread), "what was not read stands in the text", found.unread)
