"""An edit in words of a situation: what it names changes, and all else stays as it is.

The reader reads the situation at hand, told in words, with the edit behind it; what differs from the telling alone is
put into the situation. So whatever can be said in a situation can be edited, whoever read or wrote it.
"""

from __future__ import annotations

from dataclasses import fields, replace
from typing import Any

from chatscene.errors import EditRefused, SituationError
from chatscene.interpret.situation_of import in_a_situation
from chatscene.interpret.slots_of import ACTIONS, parties_of
from chatscene.read.learned.edits import changes
from chatscene.read.reader import LONGEST
from chatscene.situations.check import faults_of
from chatscene.situations.edited import Edited
from chatscene.situations.facts import still_evident, with_facts
from chatscene.situations.renamed import renamed
from chatscene.terms.amount import Amount
from chatscene.terms.edit import Facts
from chatscene.terms.situation import Deed, Other, Situation

SHOWN, SHOWN_FROM = 3, 0.1
"""Facts that may change, of which as many are told in a refusal, and by how much they are likelier then."""


def edited(situation: Situation, text: str) -> Edited:
    """Apply an edit in words.

    Args:
        situation: What it is about.
        text: The edit, such as ``make it a truck, from the left``.

    Raises:
        EditRefused: It was not understood, contradicts what stays, or changes nothing.
    """
    if not text.strip() or len(text) > LONGEST:
        raise EditRefused(f"say what is to be changed, in at most {LONGEST} characters, such as 'make it a truck'")
    found = changes(situation, text)
    meant = {one.path: one.now for one in found if one.is_meant}
    if not meant:
        unsure = "; ".join(str(one) for one in found[:SHOWN] if one.after - one.before >= SHOWN_FROM)
        why = f"it is not sure enough what that changes: {unsure}" if unsure else "no fact changes by that"
        raise EditRefused(f"{why}; say what is to be another, such as 'make it a truck', or --set a fact")
    if unsaid := next((path for path, now in meant.items() if str(now)[:1] in "+-"), ""):
        raise EditRefused(f"{unsaid} was not said, so that there is nothing to change by {str(meant[unsaid])[1:]}")
    try:
        made = with_facts(situation, meant)
    except SituationError as error:
        raise EditRefused(f"what stays contradicts that: {error}") from None
    if faults := tuple(faults_of(made)):
        raise EditRefused(f"what stays contradicts that: {'; '.join(map(str, faults))}")
    if made == situation:
        raise EditRefused("nothing to change: this is so already")
    return Edited(text=" ".join(text.split()), before=situation, after=made)


def with_changes(situation: Situation, before: Facts, after: Facts) -> Situation:
    """A situation with what differs between facts of it and others; all else stays as it is.

    Args:
        situation: What it was.
        before: The facts of it that have names.
        after: What they are to be.
    """
    parties = parties_of(situation)
    if parties is None:
        return situation
    names = parties.names
    ours = _with_changes(renamed(situation, names), _made(before), _made(after))
    made = renamed(ours, {name: one for one, name in names.items()})
    return replace(made, about=situation.about, evidence=still_evident(situation, made))


def _made(facts: Facts) -> Situation:
    return in_a_situation(facts.slots, facts.quantities, facts.surroundings)


def _with_changes(ours: Situation, before: Situation, after: Situation) -> Situation:
    """A situation with what differs between two others."""
    changed = {
        name: _part(getattr(ours, name), getattr(before, name), getattr(after, name))
        for name in ("ego", "road", "around")
    }
    was, now = ({one.id: one for one in whole.others} for whole in (before, after))
    others = [
        _part(one, was[one.id], now[one.id]) if one.id in was and one.id in now else one
        for one in ours.others
        if one.id not in was or one.id in now
    ]
    others += [one for name, one in now.items() if name not in was]
    return replace(ours, **changed, others=tuple(others))


def _part(ours: Any, before: Any, after: Any) -> Any:
    """A noun with the fields that differ between two others."""
    changed: dict[str, Any] = {}
    for name in (one.name for one in fields(ours) if one.name != "id"):
        mine, was, now = getattr(ours, name), getattr(before, name), getattr(after, name)
        if was == now:
            continue
        if name == "does":
            changed[name] = _deeds(mine, was, now)
        elif name == "has":
            kept = tuple(one for one in mine if one not in was or one in now)
            changed[name] = (*kept, *(one for one in now if one not in kept))
        elif hasattr(now, "__dataclass_fields__") and not isinstance(now, Amount) and was is not None:
            changed[name] = _part(mine, was, now)
        else:
            changed[name] = now
    made = replace(ours, **changed)
    if isinstance(made, Other) and not made.starts.where.row.sided and made.starts.side is not None:
        return replace(made, starts=replace(made.starts, side=None))
    return made


def _deeds(mine: tuple[Deed, ...], was: tuple[Deed, ...], now: tuple[Deed, ...]) -> tuple[Deed, ...]:
    """Deeds with what differs between two others; those of which neither knows stay behind what they stood behind."""
    at = _matched(was, mine)  # where each that was stands in them
    there = _matched(now, was)
    known = {*at.values()}
    unknown = [i for i in range(len(mine)) if i not in known]
    made: list[tuple[int, Deed]] = []
    for k, one in enumerate(now):
        if k in there and there[k] in at:
            place = at[there[k]]
            made.append((place, _part(mine[place], was[there[k]], one)))
        else:
            same = next((i for i in unknown if _action(mine[i]) == _action(one)), None)
            made.append((len(mine), one) if same is None else (same, mine[same]))
            unknown = [i for i in unknown if i != same]
    for i in unknown:
        behind = max((n for n, (place, _) in enumerate(made) if place < i), default=-1)
        made.insert(behind + 1, (i, mine[i]))
    return tuple(deed for _, deed in made)


def _matched(some: tuple[Deed, ...], among: tuple[Deed, ...]) -> dict[int, int]:
    """Where each of some deeds stands among others, by its act."""
    found: dict[int, int] = {}
    for k, one in enumerate(some):
        fits = (i for i, deed in enumerate(among) if _action(deed) == _action(one) and i not in found.values())
        if (place := next(fits, None)) is not None:
            found[k] = place
    return found


def _action(deed: Deed) -> object:
    return ACTIONS.get(deed.act, deed.act)
