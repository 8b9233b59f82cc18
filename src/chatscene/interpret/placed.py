"""Whether what a user stated beside a text has a place in its situation: what has none would be gone without a word."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from chatscene.errors import SettingsError
from chatscene.interpret.situation_of import in_a_situation
from chatscene.interpret.stated import AROUND, FACTS, facts_stated, in_text
from chatscene.terms.acts import Action
from chatscene.terms.scenario import Scenario
from chatscene.terms.situation import Situation

_IMPLIED = frozenset((Action.FOLLOW, Action.BRAKE, Action.CHANGE_LANE, Action.DIAGONAL))
"""Acts that another one may have in it, or that are told as left out."""


def require_placed(scenario: Scenario, stated: str) -> None:
    """Hold a situation to the facts that a user stated: each is in it.

    Raises:
        SettingsError: A fact has no place in it, such as the side of somebody straight ahead.
    """
    for name, value in facts_stated(stated).items():
        if name == "actions":
            lost = [act for act in value if not _acts(scenario, act)]
        else:
            lost = [] if _matters(scenario, name) else [value]
        for one in lost:
            told = in_text({name: one})
            raise SettingsError(f"{told} has no place in what was read: {scenario.slots}")


def _matters(scenario: Scenario, name: str) -> bool:
    """Whether a situation is another with another value of a fact."""
    values = FACTS[name] if name in AROUND else (None, *FACTS[name])
    first, *others = (_made(scenario, name, value) for value in values)
    return any(one != first for one in others)


def _acts(scenario: Scenario, act: Action) -> bool:
    """Whether a situation is another without an act, or has it in what follows."""
    acts = scenario.slots.actions
    rest = tuple(one for one in acts if one is not act)
    return act in _IMPLIED or not rest or _made(scenario, "actions", rest) != _made(scenario, "actions", acts)


def _made(scenario: Scenario, name: str, value: Any) -> Situation:
    slots, around = scenario.slots, scenario.surroundings
    if name in AROUND:
        around = replace(around, **{name: value})
    else:
        slots = replace(slots, **{name: value})
    return in_a_situation(slots, scenario.frame.quantities if scenario.frame is not None else (), around)
