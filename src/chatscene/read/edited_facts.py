"""Facts as an edit wishes them: what was named is set, what follows from it follows, and all else stays."""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from typing import Any

from chatscene.errors import EditRefused
from chatscene.read.edit_words import Mark
from chatscene.read.parse import in_order, start_of
from chatscene.read.phrases import Where
from chatscene.terms.actors import Manner
from chatscene.terms.acts import BRINGS, Action
from chatscene.terms.conclusions import JUNCTIONS, LANE_CHANGES, TURNS, concluded
from chatscene.terms.edit import Facts, in_words
from chatscene.terms.scenario import (
    EgoState,
    Maneuver,
    Measure,
    Place,
    Position,
    Quantity,
    Shift,
    Side,
    Site,
    Slots,
    Unused,
    includes,
)
from chatscene.terms.surroundings import FOLLOWS, Light, Surface, Surroundings, Weather

_MORE, _LESS = 1.25, 0.8  # what "faster" and "slower" make of a number that was said

_ON_THE_WAY = frozenset(
    (Action.STOP, Action.HESITATE, Action.TURN_BACK, Action.DIAGONAL, Action.ACCELERATE, Action.FAST, Action.SLOW)
)  # without another word these come on top of what somebody does: who is to stop while crossing still crosses
_ENTERS = frozenset((Action.CUT_IN, Action.CHANGE_LANE, Action.PULL_OUT, Action.OVERTAKE))  # and brakes then
_IDLE = frozenset((Action.FOLLOW, Action.STAND, Action.BLOCK, Action.NARROW))
_STARTS: dict[Action, tuple[Position, ...]] = {
    Action.OVERTAKE: (Position.BEHIND, Position.BEHIND_BESIDE),
    Action.TAILGATE: (Position.BEHIND, Position.BEHIND_BESIDE),
    Action.ONCOMING: (Position.ONCOMING,),
    Action.WRONG_WAY: (Position.ONCOMING,),
    Action.RUN_LIGHT: (Position.CROSSING, Position.ONCOMING, Position.ROADSIDE, Position.FAR_CORNER),
    Action.PULL_OUT: (Position.KERB, Position.ROADSIDE),
    Action.CUT_IN: (Position.BESIDE, Position.AHEAD_BESIDE, Position.BEHIND_BESIDE, Position.KERB),
}  # where whoever does it can start
_IN_LANE = {Position.AHEAD: Where.AHEAD, Position.BEHIND: Where.BEHIND}
_CONSISTENT = {
    Where.NEXT_LANE: (Position.BESIDE, Position.AHEAD_BESIDE, Position.BEHIND_BESIDE),
    Where.BEHIND: (Position.BEHIND, Position.BEHIND_BESIDE),
    Where.EDGE: (Position.ROADSIDE, Position.KERB, Position.FAR_CORNER),
    Where.FROM_SIDE: (Position.CROSSING, Position.ROADSIDE),
}  # where somebody who starts there is already
_PAUSES = (Action.HESITATE, Action.TURN_BACK)
_USUAL = {"light": Light.DAY, "weather": Weather.CLEAR, "surface": Surface.DRY}


@dataclass(frozen=True, slots=True, kw_only=True)
class ActWish:
    """An act that an edit names.

    Attributes:
        action: Which.
        said: The words.
        order: Where it goes; None if no word says it.
        of: Whose it is: 0 for the adversary, 1 for the other.
    """

    action: Action
    said: str
    order: Mark | None = None
    of: int = 0


@dataclass
class Wishes:
    """What an edit names.

    Attributes:
        facts: New values by fact, with the words.
        olds: Values that are to go.
        acts: Acts in order.
        where: Words on where somebody starts, by whose they are.
        numbers: By measure; None where there is to be none.
        mirrored: The words that mirror everything; empty if none do.
        other: Who joins; None if nobody does.
        dropped: The words by which the other goes; empty if it stays.
        left: The words by which the adversary goes, where somebody else is left; empty if it stays.
        unused: What was said and no scene has.
        repaired: Whether what is named from here on takes the place of what was named before: "a van, no, a bus".
    """

    facts: dict[str, tuple[Any, str]] = field(default_factory=dict[str, tuple[Any, str]])
    olds: list[tuple[str, Any, str]] = field(default_factory=list[tuple[str, Any, str]])
    acts: list[ActWish] = field(default_factory=list[ActWish])
    where: dict[int, list[tuple[Where, str]]] = field(default_factory=dict[int, list[tuple[Where, str]]])
    numbers: dict[Measure, tuple[Quantity | Shift | None, str]] = field(
        default_factory=dict[Measure, tuple[Quantity | Shift | None, str]]
    )
    mirrored: str = ""
    other: tuple[Slots, str] | None = None
    dropped: str = ""
    left: str = ""
    unused: list[Unused] = field(default_factory=list[Unused])
    repaired: bool = False

    def wish(self, fact: str, value: Any, said: str) -> None:
        """A fact is to have a value.

        Raises:
            EditRefused: It is to have another one, too.
        """
        if self.repaired or (fact, value) == ("ego", EgoState.SETS_OFF):  # who sets off stood before
            self.facts.pop(fact, None)
        known = self.facts.setdefault(fact, (value, said))
        if fact == "place" and known[0] != value:
            if value is not None and known[0] is not None and includes(known[0], value):
                self.facts[fact] = (value, said)
                return
            if value is not None and known[0] is not None and includes(value, known[0]):
                return
        if known[0] != value:
            raise EditRefused(f"it cannot be both {known[1]!r} and {said!r}; say one of them")

    def old(self, fact: str, value: Any, said: str) -> None:
        """A value is to go."""
        self.olds.append((fact, value, said))

    def place(self, where: Where, said: str, of: int = 0) -> None:
        """Somebody is to start somewhere."""
        self.where.setdefault(of, []).append((where, said))

    def take_back(self, where: Where) -> bool:
        """Forget that the adversary is to start somewhere; whether it was."""
        kept = [one for one in self.where.get(0, []) if one[0] is not where]
        found = len(kept) < len(self.where.get(0, []))
        self.where = {**self.where, 0: kept} if kept else {of: said for of, said in self.where.items() if of != 0}
        return found

    def number(self, measure: Measure, number: Quantity | Shift | None, said: str) -> None:
        """A number is to be another one, or none.

        Raises:
            EditRefused: It is to be yet another one.
        """
        known = self.numbers.setdefault(measure, (number, said))
        if (
            isinstance(known[0], Shift)
            and isinstance(number, Shift)
            and known[0] == replace(number, said=known[0].said)
        ):
            return  # "faster, much faster"
        if isinstance(known[0], Shift) and isinstance(number, Quantity):
            self.numbers[measure] = number, said  # "slower, at 20 km/h"
        elif known[0] != number and not (isinstance(known[0], Quantity) and isinstance(number, Shift)):
            raise EditRefused(f"it cannot be both {known[1]!r} and {said!r}; say one of them")

    def mirror(self, said: str) -> None:
        """Left and right are to change places."""
        self.mirrored = said

    def add_other(self, other: Slots, said: str) -> None:
        """Somebody joins."""
        self.other = other, said

    def drop_other(self, said: str) -> None:
        """The other is to go."""
        self.dropped = said

    def dont(self, slots: Slots, said: str, *, of: int) -> None:
        """Somebody is not to stop, brake or yield: what of that it does goes; else it drives on."""
        acts = (slots if of == 0 else slots.others[0]).actions
        found = [a for a in acts if a in (Action.STOP, Action.BRAKE, *_PAUSES) and _named_in(a, said)]
        for action in found:
            self.acts.append(ActWish(action=action, said=said, order=Mark.OLD, of=of))
        if not found:
            self.acts.append(ActWish(action=Action.FOLLOW, said=said, order=Mark.INSTEAD, of=of))

    def named(self) -> dict[str, str]:
        """The facts that are named, with the words."""
        found = {name: said for name, (_, said) in self.facts.items() if not name.startswith("other ")}
        found |= {name: said for name, _, said in self.olds if name not in found and not name.startswith("other ")}
        if own := [one for one in self.acts if one.of == 0]:
            found["actions"] = ", ".join(one.said for one in own)
        if 0 in self.where:
            found["position"] = ", ".join(said for _, said in self.where[0])
        found |= {str(measure): said for measure, (_, said) in self.numbers.items()}
        besides = [said for name, (_, said) in self.facts.items() if name.startswith("other ")]
        besides += [one.said for one in self.acts if one.of == 1] + [said for _, said in self.where.get(1, [])]
        besides += [self.dropped] if self.dropped else []
        besides += [self.other[1]] if self.other else []
        if besides:
            found["others"] = ", ".join(besides)
        if self.left:
            found |= dict.fromkeys(("adversary", "actions", "side", "position", "others"), self.left)
        if self.mirrored:
            found["side"] = self.mirrored
        return found


def _named_in(action: Action, said: str) -> bool:
    words = {Action.STOP: "stop", Action.BRAKE: "brak", Action.HESITATE: "stop", Action.TURN_BACK: "stop"}
    return words[action] in said


def edited(facts: Facts, wishes: Wishes) -> Facts:
    """The facts after an edit.

    Raises:
        EditRefused: What is named contradicts what stays, or is not there to go.
    """
    before = facts.slots
    aside = facts.numbers.get(Measure.ASIDE, ())
    slots = before
    if wishes.mirrored:
        slots = _mirrored(before, "" if aside else wishes.mirrored)
    slots = _with_facts(slots, facts, wishes)
    slots = _with_acts(slots, wishes, 0)
    slots = replace(slots, position=_start(before, slots, wishes, 0))
    if Where.OWN_LANE in {where for where, _ in wishes.where.get(0, [])}:
        slots = replace(slots, side=None)
    slots = _with_others(slots, wishes)
    numbers = dict(facts.numbers)
    for measure, (number, _) in wishes.numbers.items():
        made = _numbers(numbers.pop(measure, ()), number)
        if made:
            numbers[measure] = made
    if Measure.DISTANCE in wishes.numbers:
        slots = replace(slots, distance=None)
    elif "distance" in wishes.facts:
        numbers.pop(Measure.DISTANCE, None)
    after = concluded(slots)
    _hold(wishes, before, after)
    if wishes.mirrored:
        numbers[Measure.ASIDE] = tuple(_to_the_other_side(one) for one in aside)
    elif (after.side, after.position) != (before.side, before.position):
        numbers.pop(Measure.ASIDE, None)  # it was said of who started elsewhere
    if Action.SWERVE not in after.actions or not numbers.get(Measure.ASIDE):
        numbers.pop(Measure.ASIDE, None)
    return Facts(slots=after, surroundings=_surroundings(facts.surroundings, wishes), numbers=numbers)


# Left and right

_SWAPPED = {
    Maneuver.LEFT_TURN: Maneuver.RIGHT_TURN,
    Maneuver.LANE_CHANGE_LEFT: Maneuver.LANE_CHANGE_RIGHT,
    Place.LEFT_CURVE: Place.RIGHT_CURVE,
    Action.TURN_LEFT: Action.TURN_RIGHT,
    Side.LEFT: Side.RIGHT,
}
_OTHER: dict[Any, Any] = {**_SWAPPED, **{value: key for key, value in _SWAPPED.items()}}


def _mirrored(slots: Slots, said: str) -> Slots:
    swapped = replace(
        slots,
        side=_OTHER.get(slots.side, slots.side),
        maneuver=_OTHER.get(slots.maneuver, slots.maneuver),
        place=_OTHER.get(slots.place, slots.place),
        actions=tuple(_OTHER.get(action, action) for action in slots.actions),
        others=tuple(_mirrored(one, "") for one in slots.others),
    )
    if said and swapped == slots:
        raise EditRefused(f"{said!r}: nothing was said of left or right so far")
    return swapped


def _to_the_other_side(one: Quantity | Shift) -> Quantity | Shift:
    if not isinstance(one, Quantity):
        return one
    said = re.sub(r"\b(?:left|right)\b", lambda side: "right" if side[0] == "left" else "left", one.said)
    return replace(one, value=-one.value, said=said)


# Facts with one value


def _with_facts(slots: Slots, facts: Facts, wishes: Wishes) -> Slots:
    if slots.others and "adversary" not in wishes.facts and any(name == "adversary" for name, _, _ in wishes.olds):
        one = slots.others[0]  # who is left is the adversary
        wishes.left = next(said for name, _, said in wishes.olds if name == "adversary")
        wishes.olds = [old for old in wishes.olds if old[0] != "adversary"]
        slots = replace(
            slots,
            adversary=one.adversary,
            actions=one.actions,
            side=one.side,
            position=one.position,
            occluder=None,
            group=None,
            others=slots.others[1:],
        )
    for name, value, said in wishes.olds:
        _is_there(slots, facts.surroundings, name, value, said)
        if name not in wishes.facts and name in _NEEDED:
            raise EditRefused(f"{said!r} cannot go without another in its place; say which")
    made: dict[str, Any] = {name: _GONE.get(name) for name, _, _ in wishes.olds}
    made |= {name: value for name, (value, _) in wishes.facts.items()}
    own = {name: value for name, value in made.items() if not name.startswith("other ") and name not in _USUAL}
    slots = replace(slots, **own)
    if made.get("place") is not None:
        slots = _at_place(slots, made["place"], made)
    if made.get("site") is not None:
        slots = _at_site(slots, made["site"], made)
    if made.get("maneuver", Maneuver.BYPASS) is not Maneuver.BYPASS:
        slots = replace(slots, blocker=None)
    return slots


def _at_place(slots: Slots, place: Place, made: dict[str, Any]) -> Slots:
    """Facts at another kind of place, where there is nothing of the old one: no site, and lights at junctions only."""
    slots = replace(slots, site=made.get("site"))
    if place in JUNCTIONS:
        if "maneuver" not in made and slots.maneuver in (*LANE_CHANGES, Maneuver.BYPASS):
            raise EditRefused(f"the ego changes lanes or passes somebody, which it does on roads, not at a {place}")
        return slots
    if "maneuver" not in made and slots.maneuver in TURNS:
        raise EditRefused(f"the ego turns, which it does at junctions only; say what it does on the {place}")
    return replace(slots, control=made.get("control"))


_NEEDED = ("adversary", "maneuver")
_GONE = {"place": Place.ROAD}  # what is there where a fact goes: who is at no junction is on a road


def _at_site(slots: Slots, site: Site, made: dict[str, Any]) -> Slots:
    place = Place.JUNCTION if site is Site.ROUNDABOUT else Place.ROAD
    if site is Site.CROSSWALK and slots.place not in JUNCTIONS:
        place = Place.ROAD
    slots = replace(slots, place=made.get("place", place), control=made.get("control"))
    if slots.maneuver in TURNS and "maneuver" not in made:
        raise EditRefused(f"the ego turns, which it does not at a {site}; say what it does there")
    motorway = site is not Site.ROUNDABOUT and site not in (Site.RURAL, Site.CROSSWALK, Site.PARKING, Site.BUS_BAY)
    return replace(slots, two_way=None) if motorway and "two_way" not in made else slots


def _is_there(slots: Slots, around: Surroundings, name: str, value: Any, said: str) -> None:
    """Refuse to take away what is not there."""
    if name.startswith("other "):
        now = getattr(slots.others[0], name.removeprefix("other "))
    else:
        now = getattr(around if name in _USUAL else slots, name)
    place = isinstance(now, Place) and isinstance(value, Place) and (includes(value, now) or includes(now, value))
    if now != value and not place:
        raise EditRefused(f"{said!r}: it is not so ({name}: {in_words(now)})")


# What somebody does


def _with_acts(slots: Slots, wishes: Wishes, of: int) -> Slots:
    wished = [one for one in wishes.acts if one.of == of]
    if not wished:
        return slots
    acts = list(slots.actions)
    olds = [one for one in wished if one.order is Mark.OLD]
    at = None
    for one in olds:
        action = _meant(one, acts)
        at = acts.index(action)
        acts.remove(action)
    news = [one for one in wished if one.order is not Mark.OLD]
    acts = _placed(acts, news, at)
    if not acts:
        raise EditRefused(
            f"{olds[-1].said!r}: nothing is left that the {slots.adversary} does; say what it does instead"
        )
    told = in_order(replace(slots, actions=tuple(dict.fromkeys(acts))))
    if told is None:
        raise EditRefused(f"a {slots.adversary} cannot do all of this: {', then '.join(acts)}")
    return replace(slots, actions=told)


def _meant(one: ActWish, acts: list[Action]) -> Action:
    """The act that is to go: the one that is named, or the one that brings it along."""
    if one.action in acts:
        return one.action
    brings = [action for action in acts if one.action in BRINGS[action] and (action in _PAUSES or len(acts) > 1)]
    slower = {Action.BRAKE: Action.SLOW, Action.SLOW: Action.BRAKE}.get(one.action)
    if brings or slower in acts:
        return brings[0] if brings else Action(str(slower))
    raise EditRefused(f"{one.said!r}: it does not do that ({' then '.join(acts) or 'nothing is said of what it does'})")


def _placed(acts: list[Action], news: list[ActWish], at: int | None) -> list[Action]:
    """Acts with those that are new, each in its place; `at` is the place of one that goes for them."""
    ordered = any(one.order not in (None, Mark.ALSO, Mark.ON_THE_WAY) for one in news)
    if (more := [one for one in news if one.action not in acts]) and len(more) < len(news) and not ordered:
        return _besides(acts, [one.action for one in more])  # "slow down while crossing"
    own = [one.action for one in news]
    if at is not None or not news:
        return [*acts[: at or 0], *own, *acts[at or 0 :]]
    anchored = next((i for i, one in enumerate(news) if one.order in (Mark.BEFORE, Mark.AFTER)), None)
    if anchored is not None and own[anchored] in acts:
        where = acts.index(own.pop(anchored)) + (news[anchored].order is Mark.AFTER)
        return [*acts[:where], *own, *acts[where:]]
    if news[0].order is Mark.FIRST:
        return [*own, *acts]
    return _besides(acts, own) if _joins(acts, news) else own


def _joins(acts: list[Action], news: list[ActWish]) -> bool:
    """Whether new acts come on top of what somebody does, rather than in its place."""
    if news[0].order is not None:
        return news[0].order is not Mark.INSTEAD
    if all(action.row.all_along and action.row.directed for action in acts) and not news[0].action.row.directed:
        return True  # who comes towards the ego still does
    if len(news) == 1 and news[0].action is Action.STOP and acts == [Action.BRAKE]:
        return False  # whoever stops brakes
    new, moving = {one.action for one in news}, bool(acts) and not _IDLE.issuperset(acts)
    braking = new <= {Action.BRAKE, *_ON_THE_WAY} and not _ENTERS.isdisjoint(acts)
    return moving and (new <= _ON_THE_WAY or braking)


def _besides(acts: list[Action], own: list[Action]) -> list[Action]:
    """Acts with others on top; of two that exclude each other the new one stays."""
    opposite = {action.opposite for action in own} | ({Action.SLOW} if Action.FAST in own else set[Action]())
    opposite |= {Action.FAST} if Action.SLOW in own else set[Action]()
    stay = [action for action in acts if not (action.row.all_along or action.row.hasty) or action not in opposite]
    return [*stay, *own]


# Where somebody starts


def _start(before: Slots, slots: Slots, wishes: Wishes, of: int) -> Position | None:
    """Where somebody starts: where it is said, else where it did, unless it cannot do there what it does now."""
    if slots.adversary is None or before.adversary is None:
        return slots.position
    if (said := wishes.where.get(of)) is None:
        return _start_unsaid(before, slots)
    if slots.position is not None and all(slots.position in _CONSISTENT.get(where, ()) for where, _ in said):
        return slots.position
    stays = {Where.NEXT_LANE} if before.position in _CONSISTENT[Where.NEXT_LANE] else set[Where]()
    lane = stays if {where for where, _ in said} <= {Where.AHEAD, Where.BEHIND} else set[Where]()
    found = start_of(replace(slots, position=None), frozenset(where for where, _ in said) | lane)
    if found is None:
        words = ", ".join(repr(one) for _, one in said)
        raise EditRefused(f"{words}: a {slots.adversary} that does this cannot start there")
    return found


def _start_unsaid(before: Slots, slots: Slots) -> Position | None:
    """Where somebody starts of whom that was not named."""
    now, unplaced = slots.position, replace(slots, position=None)
    changed = {name for name in _WATCHED if getattr(before, name) != getattr(slots, name)}
    if changed == {"side"}:
        in_lane = before.side is None and now in _IN_LANE
        return start_of(unplaced, frozenset((_IN_LANE[now],))) or now if in_lane and now is not None else now
    if changed == {"place"} and (now is not Position.CROSSING or slots.place in JUNCTIONS):
        return now
    other_manner = _manner(before) is not _manner(slots) and slots.place in JUNCTIONS
    if not changed and not other_manner:
        return now
    if now is None or now is start_of(replace(before, position=None)):
        return start_of(unplaced) or now
    if "occluder" in changed and slots.occluder is not None:
        return Position.ROADSIDE
    elsewhere = any(action in _STARTS and now not in _STARTS[action] for action in slots.actions)
    return start_of(unplaced) or now if elsewhere and "actions" in changed else now


_WATCHED = ("actions", "side", "occluder", "place")


def _manner(slots: Slots) -> Manner | None:
    return None if slots.adversary is None else slots.adversary.row.manner


# Who else there is


def _with_others(slots: Slots, wishes: Wishes) -> Slots:
    if wishes.dropped:
        return replace(slots, others=() if wishes.other is None else (wishes.other[0],))
    if wishes.other is not None:
        return replace(slots, others=(*slots.others, wishes.other[0]))
    if not slots.others:
        return slots
    before = slots.others[0]
    own = {name.removeprefix("other "): v for name, (v, _) in wishes.facts.items() if name.startswith("other ")}
    one = _with_acts(replace(before, **own), wishes, 1)
    one = replace(one, position=_start(before, replace(one, place=slots.place), wishes, 1), place=None)
    return replace(slots, others=(one, *slots.others[1:]))


# Numbers, light, weather and road


def _numbers(known: tuple[Quantity | Shift, ...], number: Quantity | Shift | None) -> tuple[Quantity | Shift, ...]:
    """What is said of a measure: a number, or what it is shifted by."""
    if number is None:
        return ()
    if isinstance(number, Quantity):
        return (number,)
    told = next((one for one in known if isinstance(one, Quantity)), None)
    if told is None:
        return (*known, number)
    if number.times is not None:
        value = told.value * number.times
    elif number.by is not None:
        value = told.value + (number.by if number.more else -number.by)
    else:
        value = told.value * (_MORE if number.more else _LESS)
    if value <= 0.0:
        raise EditRefused(f"{number.said!r}: nothing is left of {told.said!r}")
    return (Quantity(measure=told.measure, value=round(value, 3), said=f"{number.said} (before: {told.said})"),)


def _surroundings(now: Surroundings, wishes: Wishes) -> Surroundings:
    made = {name: value for name, (value, _) in wishes.facts.items() if name in _USUAL}
    made |= {name: _USUAL[name] for name, _, _ in wishes.olds if name in _USUAL and name not in made}
    followed = FOLLOWS.get(now.weather, Surface.DRY) is now.surface
    if "weather" in made and "surface" not in made and followed:
        made["surface"] = FOLLOWS.get(made["weather"], Surface.DRY)
    if made.get("surface") is Surface.DRY and "weather" not in made and now.weather in FOLLOWS:
        made["weather"] = Weather.CLEAR
    return replace(now, **made)


# What must hold in the end


def _hold(wishes: Wishes, before: Slots, after: Slots) -> None:
    """Refuse an edit of which a named fact is not so in the end, because of what follows from others."""
    for name, (value, said) in wishes.facts.items():
        now = getattr(after, name, value) if not name.startswith("other ") else value
        if name not in _USUAL and now != value:
            raise EditRefused(f"{said!r} cannot be with the rest, from which follows {name}: {in_words(now)}")
    if after.control is not None and after.place not in JUNCTIONS:
        raise EditRefused("there are lights and signs at junctions only; say at which kind of junction")
    if "control" in wishes.facts and before.place not in JUNCTIONS and "place" not in wishes.facts:
        raise EditRefused(f"{wishes.facts['control'][1]!r}: it is at no junction; say at which kind of junction")
