"""Facts by name that are others, put into a situation that may have more than these facts can say."""

from __future__ import annotations

from dataclasses import fields, replace
from typing import Any

from chatscene.interpret.situation_of import in_a_situation
from chatscene.interpret.slots_of import ACTIONS, parties_of
from chatscene.situations.facts import still_evident
from chatscene.situations.renamed import renamed
from chatscene.terms.amount import Amount
from chatscene.terms.edit import Facts
from chatscene.terms.situation import Deed, Other, Situation


def with_changes(situation: Situation, before: Facts, after: Facts) -> Situation:
    """A situation with what differs between facts of it and others; all else stays as it is."""
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
