"""The words that gave each fact of a situation, where the offline reader read it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from itertools import takewhile

from chatscene.interpret.situation_rows import BESIDE, BLOCKS, HIDES, LEADS, WHO
from chatscene.read.accounting import CONTACT, JOINS, PART, words_of
from chatscene.read.lexicon import KINDS as KINDS_HEARD
from chatscene.read.quotes import says_nothing
from chatscene.situations.facts import GAP, is_said, said_in, within
from chatscene.terms.frame import Word
from chatscene.terms.scenario import Scenario
from chatscene.terms.situation import Situation

_OF_ACTS = re.compile(r"^others\..*\.does$")
_PATHS: dict[str, tuple[str, ...]] = {
    "adversary": (f"others.{WHO}.kind",),
    "actions": (f"others.{WHO}.does",),
    "position": (f"others.{WHO}.starts.where", f"others.{WHO}.starts"),
    "side": (f"others.{WHO}.starts.side", *(f"others.{WHO}.does.{i}.to" for i in range(4)), f"others.{WHO}.starts"),
    "distance": (f"others.{WHO}.starts.distance",),
    "group": (f"others.{WHO}.count",),
    "maneuver": ("ego.route",),
    "ego": ("ego.does",),
    "the ego": ("ego.route", "ego"),
    "place": ("road.kind",),
    "control": ("road.control",),
    "lanes": ("road.lanes",),
    "two_way": ("road.two_way",),
    "site": ("road",),
    "occluder": (f"others.{HIDES}",),
    **dict.fromkeys((CONTACT, PART), ("contact.happens",)),
    "leader": (f"others.{LEADS}",),
    "blocker": (f"others.{BLOCKS}",),
    "others": (f"others.{BESIDE[0]}",),
    "light": ("around.light",),
    "weather": ("around.weather",),
    "surface": ("around.surface",),
    "speed": (f"others.{WHO}.does",),
    "time": (f"others.{WHO}.does",),
    "deceleration": (f"others.{WHO}.does",),
    "trigger": (f"others.{WHO}.does",),
    "aside": (f"others.{WHO}.does",),
}
"""Where the fact stands that a word gave, the first that is there."""
_A = f"others.{WHO}"
_TOLD_WITH: dict[str, tuple[str, ...]] = {
    "road.control": ("road.kind", "ego.does", f"{_A}.does"),
    "road.kind": ("road.control", "ego.route", f"{_A}.does", "ego.does"),
    "road.ego_light": ("road.control", "ego.does"),
    f"{_A}.hidden_by": (f"others.{HIDES}",),
    f"{_A}.starts.speed": (f"{_A}.does",),
    f"others.{HIDES}.starts.side": (f"{_A}.starts.side",),
    f"others.{LEADS}": (f"others.{BESIDE[0]}",),
    f"others.{BLOCKS}": ("ego.route",),
}
"""Facts that the words of another one tell as well, where none of their own do."""
_OF_EACH = {
    "count": ("kind",),
    "starts.where": ("starts.side", "does", "kind"),
    "starts.side": ("starts.where", "does"),
    "starts.distance": ("starts.where",),
    "does": ("kind",),
}
"""The same, of everybody who does something."""


def _told_with(made: Situation) -> Iterator[tuple[str, tuple[str, ...]]]:
    yield from _TOLD_WITH.items()
    for one in made.others:
        for path, others in _OF_EACH.items():
            yield f"others.{one.id}.{path}", tuple(f"others.{one.id}.{other}" for other in others)


def quoted_words(scenario: Scenario, made: Situation, words: Iterable[tuple[Word, str]]) -> dict[str, str]:
    """The words that gave each fact: those that follow each other as they stand, others parted by a gap."""
    text = scenario.frame.text if scenario.frame is not None else ""
    runs: dict[str, list[tuple[int, int]]] = {}
    path = None
    drives = _of_ego_speed(scenario)
    if drives and made.ego.speed is not None:
        runs["ego.speed"] = [drives]
    for word, who in words:
        if drives and drives[0] <= word.start < drives[1]:
            continue
        joins = word.besides == JOINS and not says_nothing(word.text)  # the light of "we wait at a red light"
        if not joins or _OF_ACTS.search(path or ""):  # behind an act it may say how that is done
            of_whom = (one.replace(f"others.{WHO}.", f"others.{who}.") for one in _PATHS.get(word.fact, ()))
            path = next((one for one in of_whom if is_said(made, one)), None)
        if path is not None:
            spans = runs.setdefault(path, [])
            if spans and not text[spans[-1][1] : word.start].strip():
                spans[-1] = (spans[-1][0], word.end)
            else:
                spans.append((word.start, word.end))
    found = {path: GAP.join(text[start:end] for start, end in spans) for path, spans in runs.items()}
    for path, others in _told_with(made):
        told = next((found[one] for one in others if one in found), "")
        if path not in found and told and any(within(one, (path,)) for one, _ in said_in(made)):
            found[path] = told
    return found


def _of_ego_speed(scenario: Scenario) -> tuple[int, int] | None:
    """Where a text says how fast the ego drives: the number with its verb, or what of it stands as it was read."""
    frame = scenario.frame
    if frame is None or frame.ego_speed is None:
        return None
    words = frame.ego_speed.said.split()
    tails = (" ".join(words[at:]) for at in range(len(words)))
    found = ((text, frame.text.lower().find(text)) for text in tails)
    return next(((at, at + len(text)) for text, at in found if at >= 0), None)


def told_of(scenario: Scenario) -> Iterator[tuple[Word, str]]:
    """Each word with the id of whom it tells: of several who do something, of whom was spoken last."""
    slots, told, who, last = scenario.slots, words_of(scenario), WHO, ""
    kinds = {WHO: slots.adversary, **{name: one.adversary for name, one in zip(BESIDE, slots.others, strict=False)}}
    spoken: set[str] = set()
    for i, word in enumerate(told):
        if word.fact == "adversary" and last != "adversary" and len(kinds) > 1:
            run = " ".join(one.text for one in takewhile(lambda one: one.fact == "adversary", told[i:]))
            heard = ((one, KINDS_HEARD.get(kind)) for one, kind in kinds.items() if kind is not None)
            named = [one for one, words in heard if words is not None and words.search(run.lower())]
            who = next((one for one in named if one not in spoken), next(iter(named), who))
            spoken.add(who)
        last = word.fact
        yield word, who
