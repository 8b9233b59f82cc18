"""What the chosen snippets do that was not said, or do otherwise than was said: facts compared with facts."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

from chatscene.terms.acts import BRINGS, Action
from chatscene.terms.nouns import with_article
from chatscene.terms.scenario import Scenario, Slots
from chatscene.terms.snippet import Retrieval

_OF_KIND = re.compile(r"others\.\w+(?:\.kind)?")  # the paths of whoever is there, and of what kind
_STAND_BESIDE = {
    "leader": "a slow vehicle ahead",
    "blocker": "a parked vehicle in the ego's lane",
    "group": "others of its kind",
}


def otherwise(scenario: Scenario, retrieval: Retrieval, words: Sequence[Mapping[str, Any]]) -> tuple[str, ...]:
    """Lines for a person, empty where what was chosen is what was read."""
    return (
        *_instead(retrieval),
        *_acts(scenario.slots, retrieval),
        *_others(scenario, retrieval),
        *_kind(scenario, words),
    )


def _instead(retrieval: Retrieval) -> list[str]:
    """Choices that were better, but whose drives did not show what was read."""
    chosen = {snippet.id: snippet for snippet in retrieval.snippets}
    parts = {snippet.component.value: snippet.id for snippet in retrieval.snippets}
    gone = dict.fromkeys(name for one in retrieval.tried for name in one.snippet_ids if name not in chosen)
    told: list[str] = []
    for component, now in parts.items():
        if better := [name for name in gone if name.partition("/")[0] == component]:
            told.append(f"instead of {' and '.join(better)}, which no drive showed, {now}: {chosen[now].description}")
    return told


def _acts(said: Slots, retrieval: Retrieval) -> list[str]:
    """Acts beside those that were said; what comes along without a word, or only says how, need not be said."""
    asked, built = _all_acts(said), _all_acts(retrieval.behavior.snippet.slots)
    added = [action for action in built if action not in _with_brought(asked) and not action.row.hasty]
    lost = [action for action in asked if action not in _with_brought(built) and not action.row.hasty]
    if lost:
        return [f"instead of {', '.join(lost)}: {', '.join(added or built) or 'nothing'}"]
    return [f"added: the adversary {action.row.meaning}" for action in added]


def _all_acts(slots: Slots) -> list[Action]:
    return [*slots.actions, *(action for other in slots.others for action in other.actions)]


def _with_brought(actions: Sequence[Action]) -> set[Action]:
    return {*actions, *(brought for action in actions for brought in BRINGS[action])}


def _others(scenario: Scenario, retrieval: Retrieval) -> list[str]:
    """Who or what is beside the adversary though nobody asked."""
    said = scenario.slots
    built = [snippet.slots for snippet in retrieval.snippets]
    told = [
        f"added: {what}"
        for name, what in _STAND_BESIDE.items()
        if not getattr(said, name) and any(getattr(slots, name) for slots in built)
    ]
    if said.occluder is None:
        told += [
            f"added: something that hides the adversary, {with_article(s.occluder.replace('-', ' '))}"
            for s in built
            if s.occluder is not None
        ]
    asked, there = len(said.others), max(len(slots.others) for slots in built)
    if there > asked:
        told.append(f"added: {there - asked} other road user{'s' * (there - asked > 1)}")
    return list(dict.fromkeys(told))


def _kind(scenario: Scenario, words: Sequence[Mapping[str, Any]]) -> list[str]:
    """A road user that is shown as a kind of another name, or that no word names."""
    kind = scenario.slots.adversary
    if kind is None or not words:
        return []
    named = _named(words)
    if not named:
        return [f"guessed: {with_article(kind.row.noun)}, which no word names"]
    if any(name in text for text in named for name in (kind.row.noun.lower(), kind.value.replace("-", " "))):
        return []
    shown = f"{'is' if len(named) == 1 else 'are'} shown as {with_article(kind.row.noun)}"
    return [f"{', '.join(map(repr, named))} {shown}"]


def _named(words: Sequence[Mapping[str, Any]]) -> list[str]:
    """What names the adversary, in lower case; none twice. Only words that were read part one name from the next."""
    runs: list[list[str]] = [[]]
    for word in words:
        if _OF_KIND.fullmatch(word.get("fact", "")):
            runs[-1].append(str(word["text"]).lower())
        elif not word.get("unread"):
            runs.append([])
    return list(dict.fromkeys(" ".join(run) for run in runs if run))
