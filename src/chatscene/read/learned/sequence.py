"""A sequence of tokens as a situation; `making.reader.sequence` writes the sequence of a situation.

Others are called A, B, C… in their order, and a deed that is waited for has its number; a list of words comes in the
order of its table. What nobody says, such as a name or a map, is not written.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

from chatscene.read.learned.grammar import (
    COPIED,
    END,
    NAMES,
    NUMBERED,
    Node,
    Place,
    Sort,
    Token,
    grammar,
    places,
)
from chatscene.situations.faults import Malformed
from chatscene.situations.form import parsed
from chatscene.terms.amount import Amount
from chatscene.terms.reading import Verdict
from chatscene.terms.situation import Situation

_SOMEBODY = "others.kind"  # the first field of another road user


@dataclass(frozen=True, slots=True)
class Step:
    """A token where it stands."""

    place: Place
    token: Token | None
    amount: Amount | None = None


@cache
def _nodes() -> Mapping[Place, Node]:
    return {node.place: node for node in places(grammar().nodes)}


def path_of(steps: Sequence[Step], at: int) -> str:
    """The path of the fact that a step gives, with the plain names and numbers of who does it."""
    before = steps[: at + 1]
    place = steps[at].place.rstrip(COPIED + NUMBERED)
    first = max((i for i, step in enumerate(before) if step.place == _SOMEBODY), default=0)
    others = sum(step.place == _SOMEBODY for step in before) - 1
    of_ego = place.startswith("ego.")
    does = "ego.does.act" if of_ego else "others.does.act"
    deeds = sum(step.place == does for step in (before if of_ego else before[first:])) - 1
    path = place.replace("others.", f"others.{NAMES[min(max(others, 0), len(NAMES) - 1)]}.", 1)
    return path.replace(".does.", f".does.{deeds}.", 1)


def verdict_of(steps: Sequence[Step]) -> Verdict:
    """What a sequence says of the text."""
    return Verdict(steps[0].token[1]) if steps and steps[0].token else Verdict.NO_SITUATION


def situation_of(steps: Sequence[Step]) -> Situation:
    """The situation of a sequence.

    Raises:
        Malformed: It is against itself, as a pedestrian who overtakes is.
    """
    plain: dict[str, Any] = {}
    for step in steps[1:]:
        _put(plain, step)
    for one, name in zip(plain.get("others", ()), NAMES, strict=False):
        one["id"] = name
    if len(plain.get("others", ())) > len(NAMES):
        raise Malformed(())
    return parsed(plain)


def _put(plain: dict[str, Any], step: Step) -> None:
    place = step.place.rstrip(COPIED + NUMBERED)
    if place == END:
        return
    here: Any = plain
    path, node = "", _nodes()[place]
    for name in place.split(".")[:-1]:
        path = f"{path}.{name}".lstrip(".")
        above = _nodes()[path]
        if above.sort is Sort.NOUNS:
            several = here.setdefault(name, [])
            if place == above.nodes[0].place:
                several.append({})
            here = several[-1]
        else:
            here = here.setdefault(name, {})
    _set(here, node, step)


def _set(here: dict[str, Any], node: Node, step: Step) -> None:
    word = step.token[1] if step.token is not None else ""
    match node.sort:
        case Sort.OPEN:
            here.setdefault(node.name, {})
        case Sort.LIST:
            here.setdefault(node.name, []).append(_word(node, word))
        case Sort.AMOUNT:
            if step.amount is not None:
                here[node.name] = step.amount
        case Sort.DEED if step.place.endswith(NUMBERED):
            here[node.name] += f".{word}"
        case _:
            here[node.name] = _word(node, word)


def _word(node: Node, said: str) -> Any:
    return next(word for word in node.words if str(word) == said)
