"""An edit in words of a situation: what it names changes, what follows from that follows, all else stays as it is.

The words are read against the facts that they can name; what of these is another then, as a situation, is put into the
one at hand. So whatever can be said in a situation can be edited, whoever read or wrote it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import fields, replace
from typing import Any

from chatscene.errors import EditRefused
from chatscene.interpret.situation_of import as_named, in_a_situation
from chatscene.interpret.situation_rows import WHO
from chatscene.interpret.slots_of import ACTIONS, POSITIONS, facts_of, parties_of
from chatscene.read.edit import hear_edit
from chatscene.situations.edited import Edited
from chatscene.situations.facts import still_evident
from chatscene.terms.amount import Amount, Length
from chatscene.terms.conclusions import concluded
from chatscene.terms.edit import Edit, Facts
from chatscene.terms.scenario import Distance, Measure, Quantity, Shift
from chatscene.terms.situation import Deed, Other, Situation
from chatscene.terms.vocabulary import Manner


def edited(situation: Situation, text: str) -> Edited:
    """Apply an edit in words.

    Args:
        situation: What it is about.
        text: The edit, such as ``make it a truck, from the left``.

    Raises:
        EditRefused: It was not understood, contradicts itself or what stays, or changes nothing.
    """
    parties = parties_of(situation)
    if parties is None:
        raise EditRefused("nobody meets the ego here, so that there is nobody an edit could be about")
    facts = facts_of(situation, parties)
    edit = hear_edit(text, facts, may_stay=True)
    names = parties.names
    settled, shifts = _settled(edit)
    was = replace(facts, slots=concluded(facts.slots))  # what followed before is no change
    ours = _with_changes(_renamed(situation, names), _made(was), _made(settled))
    for shift in shifts:
        at = next(i for i, one in enumerate(ours.others) if one.id == WHO)
        shown = _WITHOUT_NUMBER[shift.measure](ours.others[at], more=shift.more)
        ours = replace(ours, others=(*ours.others[:at], shown, *ours.others[at + 1 :]))
    made = _renamed(_as_called(ours, edit), {name: one for one, name in names.items()})
    made = replace(made, about=situation.about, evidence=still_evident(situation, made))
    if made == situation:
        raise EditRefused(f"nothing to change: this is so already ({', '.join(edit.named)})")
    return Edited(text=edit.text, before=situation, after=made, unused=tuple(str(one.said) for one in edit.unused))


def _as_called(made: Situation, edit: Edit) -> Situation:
    """A situation in which whom an edit names is what it says, where that is more than the facts: a van, three."""
    if not {"adversary", "group"} & set(edit.named):
        return made
    others = tuple(
        as_named(one, edit.text, anew="adversary" in edit.named) if one.id == WHO else one for one in made.others
    )
    return replace(made, others=others)


def _made(facts: Facts) -> Situation:
    return in_a_situation(facts.slots, facts.quantities, facts.surroundings)


def _settled(edit: Edit) -> tuple[Facts, tuple[Shift, ...]]:
    """The facts after an edit, with what follows from them; and the shifts, by nobody says how much, of no number."""
    after = edit.facts
    slots = concluded(after.slots)
    numbers: dict[Measure, tuple[Quantity | Shift, ...]] = {}
    open_shifts: list[Shift] = []
    for measure, several in after.numbers.items():
        number: Quantity | None = None
        for one in several:
            if isinstance(one, Quantity):
                number = one
            elif number is not None:
                number = _shifted(number, one)
            elif one.by is None and one.times is None and measure in _WITHOUT_NUMBER:
                open_shifts.append(one)
            else:
                raise EditRefused(
                    f"{one.said!r}: its {measure} was not said, so that there is nothing to change by that; say the "
                    f"{measure}"
                )
        if number is not None:
            numbers[measure] = (number,)
    return replace(after, slots=slots, numbers=numbers), tuple(open_shifts)


def _faster(who: Other, *, more: bool) -> Other:
    return _in_a_manner(who, Manner.FAST if more else Manner.SLOW, lambda deed: "speed" in deed.act.row.takes)


def _harder(who: Other, *, more: bool) -> Other:
    return _in_a_manner(who, Manner.HARD if more else Manner.SLIGHT, lambda deed: "acceleration" in deed.act.row.takes)


def _farther(who: Other, *, more: bool) -> Other:
    low, high = (Distance.FAR if more else Distance.NEAR).bounds(POSITIONS.get(who.starts.where))
    distance = Length(low, high) if more else Length(-float("inf"), high)
    return replace(who, starts=replace(who.starts, distance=distance))


def _in_a_manner(who: Other, manner: Manner, fits: Callable[[Deed], bool]) -> Other:
    at = next((i for i, deed in enumerate(who.does) if fits(deed)), None)
    if at is None:
        raise EditRefused(f"nothing that {who.id} does is done in such a manner; say a number, or what it does")
    does = (*who.does[:at], replace(who.does[at], manner=manner), *who.does[at + 1 :])
    return replace(who, does=does)


_WITHOUT_NUMBER: Mapping[Measure, Callable[..., Other]] = {
    Measure.SPEED: _faster,
    Measure.DECELERATION: _harder,
    Measure.DISTANCE: _farther,
}
"""What more or less of a measure is, of which no number was said."""


USUAL_SHIFT = 1.25
"""How many times more a number is of which only *more* was said."""


def _shifted(number: Quantity, shift: Shift) -> Quantity:
    more = 1 if shift.more else -1
    if shift.by is not None:
        value = number.value + more * shift.by
    elif shift.times is not None:
        value = number.value * shift.times
    else:
        value = number.value * USUAL_SHIFT**more
    if value <= 0:
        raise EditRefused(f"{shift.said!r}: nothing is left of {number.said!r}")
    return replace(number, value=value, said=f"{shift.said} (before: {number.said})")


def _renamed(situation: Situation, names: Mapping[str, str]) -> Situation:
    """A situation in which others have other ids, and whoever speaks of them speaks of these."""

    def of(name: str | None) -> str | None:
        return names.get(name, name) if name is not None else None

    def of_deed(name: str | None) -> str | None:
        if name is None:
            return None
        who, dot, number = name.rpartition(".")
        return f"{of(who)}{dot}{number}"

    def deed(one: Deed) -> Deed:
        when = one.when and replace(one.when, after=of_deed(one.when.after), during=of_deed(one.when.during))
        return replace(one, whom=of(one.whom), when=when)

    others = tuple(
        replace(one, id=of(one.id) or one.id, hidden_by=of(one.hidden_by), does=tuple(map(deed, one.does)))
        for one in situation.others
    )
    contact = situation.contact and replace(situation.contact, whom=of(situation.contact.whom))
    ego = replace(situation.ego, does=tuple(map(deed, situation.ego.does)))
    return replace(situation, ego=ego, others=others, contact=contact)


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
