"""What a text may say: the readings that a user may choose between where none is sure.

The account, what patterns and classifier make of the text, and either with the fact changed that was next likely. Only
what can be built, or what the library serves where snippets are chosen, is offered: whoever takes one is not refused
again.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial

from chatscene.errors import NothingFits, OfferedReading, SettingsError
from chatscene.interpret.choose import choose
from chatscene.interpret.decide import Weighed, as_told, as_worded, decide, decided, understood, weigh
from chatscene.interpret.paper import read_as_in_paper
from chatscene.interpret.situation_of import in_a_situation
from chatscene.interpret.stated import in_text, require_stated, with_stated
from chatscene.library.load import library_with
from chatscene.settings import MOST_READINGS, RetrievalSettings
from chatscene.situations.words import told
from chatscene.terms.conclusions import JUNCTIONS, concluded
from chatscene.terms.frame import About, Beliefs, Frame, Note, certain
from chatscene.terms.scenario import Component, Maneuver, Reading, Scenario, Slots

SURE = 0.75  # of a text as likely to be read rightly as this, no other readings are sought
POSSIBLE = 0.05  # a value less likely than this is not thought of
FAINTEST = 0.005  # a reading less likely than this is not offered …
IN_SCOPE = 0.5  # … nor, in a text less likely than this about driving …
FAINT = 0.05  # … one less likely than this
MOST_OF_IT = 0.5  # a reading with one fact changed is at most this much as likely
TRIED = 6  # how many are asked about whether they are served, the likeliest first
_DOUBTED = ("adversary", "side", "position", "occluder", "maneuver")
"""The slots of which the next likely value is thought of: those that part one situation from another."""


Served = Callable[[Scenario], bool]
"""Whether there is a program for a scenario."""


def understand(frame: Frame, settings: RetrievalSettings, served: Served | None = None) -> Scenario:
    """What a text says: as the readers have it, or as the user chose, with the facts that the user stated.

    Args:
        frame: What was read.
        settings: What the user stated and chose, and which library.
        served: Says which readings can be offered; None for those that the library serves.

    Raises:
        SettingsError: There is no such fact or reading, or what was stated does not go together.
    """
    frame = with_stated(frame, settings.stated)
    if settings.reader == "paper":
        return read_as_in_paper(frame, settings)
    if not settings.reading:
        frame = as_worded(frame, settings)
    offered: tuple[Reading, ...] = ()
    if frame.whole or frame.reader:
        scenario = decide(frame, settings)
    else:
        weighed = weigh(frame, settings)
        scenario, frame = decided(weighed), weighed.frame
        if settings.reading or weighed.right < SURE:
            offered = readings_of(weighed, settings, served)
    if settings.reading:
        scenario = _taken(frame, offered, settings.reading)
    require_stated(scenario, settings.stated)
    return replace(scenario, readings=offered)


def readings_of(weighed: Weighed, settings: RetrievalSettings, served: Served | None = None) -> tuple[Reading, ...]:
    """The likeliest readings that differ and can be served, at most `MOST_READINGS`.

    Args:
        weighed: What the text says, and what the user stated beside it.
        settings: Which library.
        served: Says which can be served; None for those that the library serves.
    """
    is_served = served or partial(_is_served, settings)
    found: list[Reading] = []
    told_so: set[object] = set()
    floor = FAINT if weighed.frame.beliefs.in_scope < IN_SCOPE else FAINTEST
    likely = [one for one in _different(weighed, settings) if one.probability >= floor]
    for one in likely[:TRIED]:
        told_as = _told(one.slots, weighed.frame) if served is not None else one.slots
        if len(found) < MOST_READINGS and told_as not in told_so and is_served(as_read(weighed.frame, one.slots)):
            found.append(one)
            told_so.add(told_as)
    if weighed.right >= settings.refuse_below or len(found) < MOST_READINGS:
        return tuple(found)
    first, second = found
    return (
        replace(first, settled_by=_settling(first, second, weighed.frame, settings)),
        replace(second, settled_by=_settling(second, first, weighed.frame, settings)),
    )


def _told(slots: Slots, frame: Frame) -> str:
    """A reading as it is told, where it becomes a situation: of two that are told alike nobody could take one."""
    return told(in_a_situation(slots, frame.quantities, frame.surroundings))


def _settling(reading: Reading, other: Reading, frame: Frame, settings: RetrievalSettings) -> str:
    """The one fact by which a reading is told from another, if whoever states it is served; else empty."""
    ours, theirs = reading.slots.said(), other.slots.said()
    differ = [name for name in {**ours, **theirs} if ours.get(name) != theirs.get(name)]
    if len(differ) != 1 or differ[0] not in ours or differ[0] == "others":
        return ""
    fact = in_text({differ[0]: ours[differ[0]]})
    return fact if weigh(with_stated(frame, fact), settings).right >= settings.refuse_below else ""


def offered(readings: tuple[Reading, ...]) -> tuple[OfferedReading, ...]:
    """Readings as a user is asked to take one of them."""
    return tuple(
        OfferedReading(number=number, told=one.told, probability=one.probability, settled_by=one.settled_by)
        for number, one in enumerate(readings, 1)
    )


def _taken(frame: Frame, offered: tuple[Reading, ...], number: int) -> Scenario:
    """A text of which the user chose the reading: it says just this."""
    if number > len(offered):
        there = f"only {len(offered)}" if offered else "none to choose: nothing else is likely and served"
        raise SettingsError(f"there is no reading {number} of this text; there is {there}")
    one = offered[number - 1]
    note = Note(about=About.TAKEN, said=(str(number), f"{one.probability:.0%} likely"))
    return as_read(frame, one.slots, (*frame.notes, note))


def as_read(frame: Frame, slots: Slots, notes: tuple[Note, ...] = ()) -> Scenario:
    """A text of which this is known to be what it says."""
    notes = tuple(note for note in notes if note.about not in _SETTLED)
    if frame.account is not None and frame.account.slots.actions == slots.actions:
        frame = as_told(frame, frame.account)
    frame = replace(frame, outright=slots, beliefs=certain(slots, frame.beliefs), whole=True, sure=1.0)
    return understood(frame, slots, notes)


_SETTLED = (About.WHO, About.STRANGER, About.WHAT, About.SIDE)  # by the choice of a reading


def _is_served(settings: RetrievalSettings, scenario: Scenario) -> bool:
    try:
        choose(scenario, settings)
    except NothingFits:
        return False
    return True


# Which there are


def _different(weighed: Weighed, settings: RetrievalSettings) -> list[Reading]:
    """All readings that differ in what tells situations apart, the likeliest first."""
    frame = weighed.frame
    said = [Reading(slots=weighed.guessed, probability=weighed.guess_is_right)]
    if frame.account is not None:
        said.append(Reading(slots=concluded(frame.account.slots), probability=weighed.account_is_right))
    beside = [other for one in said for other in _beside(one, frame, settings)]
    ranked = sorted((*said, *beside), key=lambda one: -one.probability)
    found: dict[object, Reading] = {}
    for one in ranked:
        if one.slots.adversary is not None and one.slots.actions:
            found.setdefault(_core(one.slots), one)
    return list(found.values())


def _core(slots: Slots) -> object:
    """The facts by which a person tells two situations apart; of the rest, a program takes what fits."""
    return (
        slots.adversary,
        slots.actions,
        slots.side,
        slots.position,
        slots.occluder,
        slots.maneuver or Maneuver.STRAIGHT,
        slots.place in JUNCTIONS,
        slots.site,
        slots.leader or None,
        slots.blocker or None,
        slots.ego,
        slots.others,
    )


def _beside(reading: Reading, frame: Frame, settings: RetrievalSettings) -> Iterator[Reading]:
    """A reading with one fact as it was next likely; if it is not right, it is mostly in one."""
    beliefs, slots = frame.beliefs, reading.slots
    for name in _DOUBTED:
        value = getattr(slots, name)
        for other, p in beliefs.slots.get(name, {}).items():
            if name not in frame.stated and other is not None and other != value and p >= POSSIBLE:
                share = p / max(beliefs.of(name, value), POSSIBLE)
                changed = concluded(replace(slots, **{name: other}))
                if getattr(changed, name) == other:
                    yield Reading(slots=changed, probability=_next(reading, share))
    if "actions" not in frame.stated:
        yield from _done_otherwise(reading, beliefs, settings)


def _done_otherwise(reading: Reading, beliefs: Beliefs, settings: RetrievalSettings) -> Iterator[Reading]:
    """A reading with what other likely behaviors do."""
    does = {one.id: one.slots.actions for one in library_with(settings.library).of(Component.BEHAVIOR)}
    likely = {name: p for name, p in beliefs.behaviors.items() if p >= POSSIBLE and name in does}
    own = max((p for name, p in likely.items() if set(does[name]) == set(reading.slots.actions)), default=POSSIBLE)
    for name, p in likely.items():
        if set(does[name]) != set(reading.slots.actions):
            changed = concluded(replace(reading.slots, actions=does[name]))
            yield Reading(slots=changed, probability=_next(reading, p / own))


def _next(reading: Reading, share: float) -> float:
    """How likely a reading is that differs in one fact, which is `share` times as likely as the one it stands for."""
    return min(share, MOST_OF_IT) * min(reading.probability, 1.0 - reading.probability)
