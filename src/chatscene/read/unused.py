"""What was said and is not used: weather, light, numbers, a second road user, words that no rule knows.

Nothing that a user wrote may vanish in silence. This errs toward naming too much.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from chatscene.read import lexicon as words
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.frame import Frame
from chatscene.terms.scenario import Quantity, Slots, Unused, Why

_NUMBER = re.compile(
    r"(?<![\w.])\d+(?:[.,:]\d+)*(?: ?(?:km/h|kph|kmh|mph|m/s ?(?:²|\^?2)|m/s|metres?|meters?|m|yards?|feet|ft|seconds?|"
    r"secs?|s|%|percent|degrees?|°c?|g|car lengths?|years?)(?!\w))?"
)
_ANOTHER = r"(?:another|a second|a third|a different|yet another)"
_SHORT = 60  # characters of a text that is not English
_ORDER = {why: place for place, why in enumerate(Why)}
_A = rf"(?:{_ANOTHER}|an?|two|three|several|some)"


def unused_of(text: str, quantities: Sequence[Quantity]) -> tuple[Unused, ...]:
    """What of a text is in no slot and no quantity, whatever the slots are.

    Args:
        text: Lower case, mended and rewritten, with what the ego then has to do.
        quantities: The numbers that were read in it.
    """
    if not words.is_english(text):
        return (Unused(said=text[:_SHORT], why=Why.LANGUAGE),)
    found = [Unused(said=m[0], why=Why.WEATHER) for m in words.WEATHER.finditer(text)]
    found += [Unused(said=m[0], why=Why.LIGHT) for m in words.LIGHT.finditer(text)]
    found += [Unused(said=m[0].strip(" ,"), why=Why.REACTION) for m in words.REACTION.finditer(text)]
    text = words.REACTION.sub(" ", text)
    text = _without(text, quantities)
    found += [Unused(said=said, why=Why.NUMBER) for said in _numbers(text)]
    found += [Unused(said=said, why=Why.WORDS) for said in words.known_to_no_rule(_NUMBER.sub(" , ", text))]
    return tuple(dict.fromkeys(found))


def known_whole(text: str, quantities: Sequence[Quantity]) -> bool:
    """Whether some pattern knows every word of a text."""
    text = words.REACTION.sub(" ", _without(text, quantities))
    return not words.known_to_no_rule(_NUMBER.sub(" , ", text), strictly=True)


def _without(text: str, quantities: Sequence[Quantity]) -> str:
    for quantity in quantities:
        text = text.replace(quantity.said, " , ")
    return text


def _numbers(text: str) -> list[str]:
    """The numbers that are no part of a road or a road user."""
    lanes = (words.MANY_LANES, words.ONE_LANE, words.EACH_WAY)
    for rule in (*lanes, *words.KINDS.values(), *words.PLACES.values(), words.GROUP, words.NEAR, words.FAR_AWAY):
        text = rule.sub(" ", text)
    return [m[0].strip(" .,:") for m in _NUMBER.finditer(text)]


def unused_beside(frame: Frame, slots: Slots) -> tuple[Unused, ...]:
    """What of a text is in no slot and no quantity, and the road users beside those that the slots have."""
    if any(one.why is Why.LANGUAGE for one in frame.unused):
        return frame.unused
    told = others(words.REACTION.sub(" ", frame.told), slots)
    found = (*frame.unused, *(Unused(said=said, why=Why.ROAD_USER) for said in told))
    return tuple(sorted(dict.fromkeys(found), key=lambda one: _ORDER[one.why]))


def others(text: str, slots: Slots) -> list[str]:
    """The road users that are spoken of beside the adversary and what the slots have: "a cyclist", "another car"."""
    if slots.occluder is not None or slots.blocker:
        for pattern in words.OCCLUDERS.values():
            text = pattern.sub(" ", text)
    if slots.leader:
        text = words.LEADER.sub(" ", text)
    text = words.BACKGROUND.sub(" ", text)
    found: list[str] = []
    seen = False  # of the adversary
    for start, end, kinds in _mentions(text):
        named = re.search(rf"\b(?P<how>{_A}) (?:[\w-]+ ){{0,2}}?$", text[:start])
        own = slots.adversary in kinds or slots.adversary is None
        if named is not None and ((not own) or (seen and re.fullmatch(_ANOTHER, named["how"]))):
            found.append(text[named.start() : end])
        seen = seen or own
    return found


def _mentions(text: str) -> list[tuple[int, int, set[AdversaryKind]]]:
    """Where road users are named: from, to, and of what kinds the words may be ("bus driver")."""
    hits = sorted((m.start(), m.end(), kind) for kind, pattern in words.KINDS.items() for m in pattern.finditer(text))
    joined: list[tuple[int, int, set[AdversaryKind]]] = []
    for start, end, kind in hits:
        if joined and start <= joined[-1][1] + 1:
            first, last, kinds = joined[-1]
            joined[-1] = (first, max(last, end), kinds | {kind})
        else:
            joined.append((start, end, {kind}))
    return joined
