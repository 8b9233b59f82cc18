"""What was said and is not used, whatever else is: numbers, words that no rule knows; and who is named.

Nothing that a user wrote may vanish in silence. This errs toward naming too much.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from chatscene.read import lexicon as words
from chatscene.read.phrases import Sort, phrases
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.frame import Mention
from chatscene.terms.scenario import Quantity, Unused, Why

_NUMBER = re.compile(
    r"(?<![\w.])\d+(?:[.,:]\d+)*(?: ?(?:km/h|kph|kmh|kmph|mph|m/s ?(?:²|\^?2)|m/s|metres?|meters?|mtrs?|m|yards?|feet|"
    r"ft|seconds?|secs?|s|%|percent|degrees?|°c?|g|car lengths?|years?)(?!\w))?"
)
_ANOTHER = r"(?:another|a second|a third|a different|yet another)"
_SHORT = 60  # characters of a text that is not English
_A = rf"(?:{_ANOTHER}|an?|two|three|several|some)"


def unused_of(text: str, quantities: Sequence[Quantity], unlike: Sequence[Unused] = ()) -> tuple[Unused, ...]:
    """What of a text is in no slot and no quantity, whatever the slots are.

    Args:
        text: Lower case, mended and rewritten, with what the ego then has to do.
        quantities: The numbers that were read in it.
        unlike: The light and the weather that no scene has.
    """
    if not words.is_english(text):
        return (Unused(said=text[:_SHORT], why=Why.LANGUAGE),)
    found = [*unlike]
    found += [Unused(said=m[0].strip(" ,"), why=Why.REACTION) for m in words.REACTION.finditer(text)]
    text = words.REACTION.sub(" ", text)
    found += [Unused(said=said, why=Why.SITE) for said in _sites(text)]
    text = _without(text, quantities)
    found += [Unused(said=said, why=Why.NUMBER) for said in _numbers(text)]
    found += [Unused(said=said, why=Why.WORDS) for said in words.known_to_no_rule(_NUMBER.sub(" , ", text))]
    return tuple(dict.fromkeys(found))


def _sites(text: str) -> list[str]:
    """The places of which no reader but the whole one knows, as they are named."""
    rules = (phrase.pattern for phrase in phrases() if phrase.sort is Sort.SITE and phrase.ego is None)
    return [m[0] for rule in rules for m in rule.finditer(text)]


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


def mentions_of(text: str) -> tuple[Mention, ...]:
    """The road users that a text names, in its order.

    Args:
        text: Lower case, mended and rewritten.
    """
    text = words.BACKGROUND.sub(" ", words.REACTION.sub(" ", text))
    hidden_by = [m.span() for pattern in words.OCCLUDERS.values() for m in pattern.finditer(text)]
    led_by = [m.span() for m in words.LEADER.finditer(text)]
    found: list[Mention] = []
    for start, end, kinds in _mentions(text):
        named = re.search(rf"\b(?P<how>{_A}) (?:[\w-]+ ){{0,2}}?$", text[:start])
        found.append(
            Mention(
                said=text[named.start() : end] if named else "",
                kinds=frozenset(kinds),
                another=bool(named and re.fullmatch(_ANOTHER, named["how"])),
                hides=any(start < last and first < end for first, last in hidden_by),
                leads=any(start < last and first < end for first, last in led_by),
            )
        )
    return tuple(found)


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
