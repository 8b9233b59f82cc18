"""An edit in words of a situation: what it names changes, and all else stays as it is.

The reader reads the situation at hand, told in words, with the edit behind it; what differs from the telling alone is
put into the situation. So whatever can be said in a situation can be edited, whoever read or wrote it.
"""

from __future__ import annotations

from chatscene.errors import EditRefused, SituationError
from chatscene.read.kinds import is_named
from chatscene.read.learned.edits import Step, likely_changes
from chatscene.read.reader import LONGEST
from chatscene.situations.check import faults_of
from chatscene.situations.edited import Edited
from chatscene.situations.facts import with_facts
from chatscene.situations.phrases import KINDS
from chatscene.terms.situation import Situation

SHOWN, SHOWN_FROM = 3, 0.1
"""Facts that may change, of which as many are told in a refusal, and by how much they are likelier then."""


def edited(situation: Situation, text: str) -> Edited:
    """Apply an edit in words.

    Raises:
        EditRefused: It was not understood, contradicts what stays, or changes nothing.
    """
    if not text.strip() or len(text) > LONGEST:
        raise EditRefused(f"say what is to be changed, in at most {LONGEST} characters, such as 'make it a truck'")
    found = likely_changes(situation, text)
    meant = {one.path: one.now for one in found if one.is_meant}
    if not meant:
        unsure = "; ".join(str(one) for one in found[:SHOWN] if one.after - one.before >= SHOWN_FROM)
        if so := [KINDS[one.kind].one for one in situation.others if is_named(one.kind, text)]:
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
