"""Facts that a user says beside a text, by name: ``side=left``. They count as said, and are sure."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from chatscene.errors import SettingsError, no_such
from chatscene.terms.acts import Action
from chatscene.terms.frame import About, Frame, Note
from chatscene.terms.scenario import Scenario
from chatscene.terms.slots import SLOTS
from chatscene.terms.surroundings import Light, Surface, Surroundings, Weather

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


def with_stated(frame: Frame, stated: str) -> Frame:
    """A frame in which the facts that a user stated are said outright, and sure."""
    facts = facts_stated(stated)
    slots = {name: value for name, value in facts.items() if name not in AROUND}
    around = {name: value for name, value in facts.items() if name in AROUND}
    if not facts:
        return frame
    beliefs = frame.beliefs
    single = {name: {value: 1.0} for name, value in slots.items() if name in beliefs.slots}
    acts = {action: float(action in slots["actions"]) for action in Action} if "actions" in slots else beliefs.actions
    account = frame.account and replace(frame.account, slots=replace(frame.account.slots, **slots))
    said = frame.surroundings
    return replace(
        frame,
        outright=replace(frame.outright, **slots),
        beliefs=replace(beliefs, slots={**beliefs.slots, **single}, actions=acts),
        account=account,
        surroundings=Surroundings(**{name: getattr(said, name) for name in AROUND} | around),
        stated=tuple(slots),
        notes=(*frame.notes, Note(about=About.STATED, said=(in_text(facts).replace(" ", ", "),))),
    )


def require_stated(scenario: Scenario, stated: str) -> None:
    """Hold a scenario to the facts that a user stated.

    Raises:
        SettingsError: What follows from the other facts is another.
    """
    for name, value in facts_stated(stated).items():
        read = getattr(scenario.surroundings if name in AROUND else scenario.slots, name)
        if read != value:
            raise SettingsError(
                f"{name}={_said(value)} does not go with the rest of what was read, which makes it "
                f"{_said(read) if read is not None else 'nothing'}: {scenario.slots}"
            )
