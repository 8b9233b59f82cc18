"""An edit in words of a situation: what it names changes, and all else stays as it is.

The reader reads the situation at hand, told in words, with the edit behind it; what differs from the telling alone is
put into the situation. So whatever can be said in a situation can be edited, whoever read or wrote it.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from chatscene.errors import EditRefused, SituationError
from chatscene.read.kinds import nouns_of
from chatscene.read.learned.edits import Change, Step, likely_changes
from chatscene.read.reader import LONGEST
from chatscene.situations.check import faults_of
from chatscene.situations.edited import Edited
from chatscene.situations.facts import with_facts
from chatscene.situations.phrases import KINDS
from chatscene.terms.situation import Other, Situation

SHOWN, SHOWN_FROM = 3, 0.1
"""Facts that may change, of which as many are told in a refusal, and by how much they are likelier then."""


_MAKES = frozenset(("make", "it", "be", "is", "a", "an", "the", "should", "let", "turn", "into", "now", "change", "to"))
"""Words by which an edit says of which kind somebody is."""
_DOES = re.compile(r"others\.\w+\.(?:does\.|hidden_by)")
_REMOVED = re.compile(
    r"(?i)\W*(?:please )?(?:remove|delete|drop|leave out|take (?:away|out)|get rid of|without) (?:the|that|this) "
    r"(?P<who>[\w -]+?)\W*"
)


def _removed(situation: Situation, text: str) -> str:
    """Whom an edit takes out, by the id; empty if it says more, or names nobody or several."""
    words = _REMOVED.fullmatch(" ".join(text.split()))
    named = [] if words is None else [one.id for one in situation.others if words["who"].lower() in nouns_of(one.kind)]
    return named[0] if len(named) == 1 else ""


def _only_names(one: Other, text: str) -> bool:
    """Whether an edit says nothing but of which kind somebody is to be."""
    nouns = sorted(nouns_of(one.kind), key=len, reverse=True)
    rest = re.sub(rf"(?i)\b(?:{'|'.join(map(re.escape, nouns))})\b", " ", text) if nouns else text
    return rest != text and all(word in _MAKES for word in re.findall(r"\w+", rest.lower()))


def _meant(situation: Situation, found: Sequence[Change]) -> dict[str, object]:
    """The facts that an edit means.

    Who is the danger is none by itself: it changes with what somebody does, and with who is struck or hides another.
    """
    meant = {one.path: one.now for one in found if one.is_meant}
    there = {one.id for one in situation.others}
    does = {path.split(".")[1] for path in meant if _DOES.match(path)}
    stays = set[str]() if any(path.startswith("contact.") for path in meant) else there - does
    return {path: now for path, now in meant.items() if path not in {f"others.{one}.role" for one in stays}}


def edited(situation: Situation, text: str) -> Edited:
    """Apply an edit in words.

    Raises:
        EditRefused: It was not understood, contradicts what stays, or changes nothing.
    """
    if not text.strip() or len(text) > LONGEST:
        raise EditRefused(f"say what is to be changed, in at most {LONGEST} characters, such as 'make it a truck'")
    gone = _removed(situation, text)
    found = () if gone else likely_changes(situation, text)
    meant = {f"others.{gone}.kind": None} if gone else _meant(situation, found)
    if not meant:
        doubted = [one for one in found if not one.path.endswith(".role")][:SHOWN]
        unsure = "; ".join(str(one) for one in doubted if one.after - one.before >= SHOWN_FROM)
        if so := [KINDS[one.kind].one for one in situation.others if _only_names(one, text)]:
            raise EditRefused(f"no fact changes by {text!r}: it is already {so[0]}")
        why = f"not sure what that changes: {unsure}" if unsure else f"{text!r} was not understood, so no fact changes"
        raise EditRefused(f"{why}; say what is to be another, such as 'make it a truck', or --set a fact")
    for path, now in meant.items():
        if isinstance(now, Step):
            raise EditRefused(f"{path} is not stated, so it cannot change by {now.by}")
    try:
        made = with_facts(situation, meant)
    except SituationError as error:
        raise EditRefused(f"what stays contradicts that: {error}") from None
    if faults := tuple(faults_of(made)):
        raise EditRefused(f"what stays contradicts that: {'; '.join(map(str, faults))}")
    if made == situation:
        raise EditRefused("nothing to change: this is so already")
    return Edited(text=" ".join(text.split()), before=situation, after=made)
