"""Facts that a user says beside a text, by name: ``side=left``. They count as said, and are sure."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, replace
from typing import Any

from chatscene.errors import SettingsError, no_such
from chatscene.interpret.situation_of import in_a_situation
from chatscene.interpret.slots_of import ACTIONS, facts_of, parties_of
from chatscene.situations.facts import still_evident
from chatscene.situations.renamed import renamed
from chatscene.situations.words import told
from chatscene.terms.acts import Action
from chatscene.terms.amount import Amount
from chatscene.terms.conclusions import concluded
from chatscene.terms.edit import Facts
from chatscene.terms.situation import Deed, Other, Situation
from chatscene.terms.slots import SLOTS
from chatscene.terms.surroundings import Light, Surface, Weather

AROUND: dict[str, tuple[Any, ...]] = {"light": tuple(Light), "weather": tuple(Weather), "surface": tuple(Surface)}
"""What each fact of what is about may be."""
FACTS: dict[str, tuple[Any, ...]] = {
    **{name: slot.values for name, slot in SLOTS.items()},
    "actions": tuple(Action),
    **AROUND,
}
"""What each fact may be, by its name; of acts, several in their order."""
_YES_AND_NO = {"yes": "True", "true": "True", "no": "False", "false": "False"}


def facts_stated(stated: str) -> dict[str, Any]:
    """Facts by name, of ``name=value`` parted by white space; acts are parted by commas, in their order.

    Raises:
        SettingsError: There is no such fact, or it cannot be that, or it is said twice; the message names what can be.
    """
    found: dict[str, Any] = {}
    for fact in stated.split():
        name, equals, value = fact.partition("=")
        name = name.replace("-", "_")
        if not equals or not value:
            raise SettingsError(f"say a fact as NAME=VALUE, such as side=left, not {fact!r}")
        if name not in FACTS:
            raise SettingsError(no_such("fact", name, FACTS))
        if name in found:
            raise SettingsError(f"{name} is set twice")
        if name == "actions":
            found[name] = tuple(dict.fromkeys(_value(name, one) for one in value.split(",")))
        elif "," in value:
            raise SettingsError(f"{name} can be one thing only, not {value!r}")
        else:
            found[name] = _value(name, value)
    return found


def _value(name: str, said: str) -> object:
    """What a fact is set to."""
    known = {str(value): value for value in FACTS[name]}
    wanted = _YES_AND_NO.get(said.lower(), said.lower())
    if wanted not in known:
        shown = ["yes" if one == "True" else "no" if one == "False" else one for one in known]
        raise SettingsError(no_such(name.replace("_", " "), said, shown))
    return known[wanted]


def in_text(facts: Mapping[str, object]) -> str:
    """Facts by name in the form that `facts_stated` reads; a fact may be one value or, of acts, several."""
    return " ".join(f"{name}={_said(value)}" for name, value in facts.items())


def _said(value: object) -> str:
    if isinstance(value, list | tuple):
        several: list[object] = [*value]  # type: ignore[reportUnknownArgumentType]
        return ",".join(map(str, several))
    return {True: "yes", False: "no"}.get(value, str(value)) if isinstance(value, bool) else str(value)


def with_named(situation: Situation, facts: Mapping[str, Any]) -> Situation:
    """A situation in which facts that a user stated by name are as was said; what follows from them follows.

    Raises:
        SettingsError: A fact has no place in it, such as the side of somebody straight ahead.
    """
    if not facts:
        return situation
    parties = parties_of(situation)
    if parties is None:
        raise SettingsError("nobody meets the ego here, so no fact about another road user can be stated")
    was = facts_of(situation, parties)
    before = replace(was, slots=concluded(was.slots))
    after = _stated(before, facts)
    made = with_changes(situation, before, after)
    for name, value in facts.items():
        _require_placed(made, after, name, value)
    return made


def _stated(facts: Facts, said: Mapping[str, Any]) -> Facts:
    slots = {name: value for name, value in said.items() if name not in AROUND}
    around = {name: value for name, value in said.items() if name in AROUND}
    return replace(
        facts,
        slots=concluded(replace(facts.slots, **slots)),
        surroundings=replace(facts.surroundings, **around),
        quantities=tuple(one for one in facts.quantities if one.measure.value not in said),
    )


_IMPLIED = frozenset((Action.FOLLOW, Action.BRAKE, Action.CHANGE_LANE, Action.DIAGONAL))
"""Acts that another one may have in it."""


def _require_placed(made: Situation, facts: Facts, name: str, value: Any) -> None:
    """Hold a situation to a fact that a user stated: what has no place in it would be gone without a word."""
    if name == "actions":
        lost = [act for act in value if not _acts(facts, act)]
    else:
        read = getattr(facts.surroundings if name in AROUND else facts.slots, name)
        lost = [] if read == value and _matters(facts, name) else [value]
    for one in lost:
        raise SettingsError(f"{in_text({name: one})} has no place in what was read: {told(made)}")


def _matters(facts: Facts, name: str) -> bool:
    """Whether a situation is another with another value of a fact."""
    values = FACTS[name] if name in AROUND else (None, *FACTS[name])
    first, *others = (_made(facts, name, value) for value in values)
    return any(one != first for one in others)


def _acts(facts: Facts, act: Action) -> bool:
    """Whether a situation is another without an act, or has it in what follows."""
    acts = facts.slots.actions
    rest = tuple(one for one in acts if one is not act)
    return act in _IMPLIED or not rest or _made(facts, "actions", rest) != _made(facts, "actions", acts)


def _made(facts: Facts, name: str, value: Any) -> Situation:
    if name in AROUND:
        facts = replace(facts, surroundings=replace(facts.surroundings, **{name: value}))
    else:
        facts = replace(facts, slots=replace(facts.slots, **{name: value}))
    return in_a_situation(facts.slots, facts.quantities, facts.surroundings)


# Facts by name that are others, put into a situation that may have more than these facts can say


def with_changes(situation: Situation, before: Facts, after: Facts) -> Situation:
    """A situation with what differs between facts of it and others; all else stays as it is."""
    parties = parties_of(situation)
    if parties is None:
        return situation
    names = parties.names
    ours = _with_changes(renamed(situation, names), _as_situation(before), _as_situation(after))
    made = renamed(ours, {name: one for one, name in names.items()})
    return replace(made, about=situation.about, evidence=still_evident(situation, made))


def _as_situation(facts: Facts) -> Situation:
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
