"""A situation as a sequence of tokens, and back; nothing is lost of what a text can say.

Others are called A, B, C… in their order, and a deed that is waited for has its number; a list of words comes in the
order of its table. What nobody says, such as a name or a map, is not written.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

from chatscene.read.learned.grammar import (
    COPIED,
    DEEDS,
    END,
    NAMES,
    NUMBERED,
    VERDICT,
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
from chatscene.terms.situation import EGO, Deed, Situation

_SOMEBODY = "others.kind"  # the first field of another road user


@dataclass(frozen=True, slots=True)
class Step:
    """A token where it stands.

    Attributes:
        place: Where.
        token: Which; None of an amount.
        amount: The amount that is copied.
    """

    place: Place
    token: Token | None
    amount: Amount | None = None


def with_plain_names(situation: Situation) -> Situation:
    """The same with others called A, B, C… and deeds by their numbers.

    Raises:
        ValueError: There are more others, or deeds that are waited for, than names.
    """
    if len(situation.others) > len(NAMES):
        raise ValueError(f"{len(situation.others)} others are too many to edit in words: at most {len(NAMES)}")
    names = {EGO: EGO} | {one.id: name for one, name in zip(situation.others, NAMES, strict=False)}

    def reference(said: str | None) -> str | None:
        if said is None:
            return None
        number = situation.number_of(said)
        if number >= DEEDS:
            raise ValueError(f"{said}: only deeds up to number {DEEDS - 1} can be waited for")
        return f"{names[said.partition('.')[0]]}.{number}"

    def name(said: str | None) -> str | None:
        return names[said] if said not in (None, EGO) else None

    def deed(one: Deed) -> Deed:
        when = one.when
        if when is not None:
            when = replace(when, after=reference(when.after), during=reference(when.during), of=name(when.of))
        return replace(one, whom=name(one.whom), when=when)

    def all_of(does: Iterable[Deed]) -> tuple[Deed, ...]:
        return tuple(map(deed, does))

    others = tuple(
        replace(one, id=names[one.id], hidden_by=name(one.hidden_by), does=all_of(one.does)) for one in situation.others
    )
    contact = situation.contact
    if contact is not None:
        contact = replace(contact, whom=name(contact.whom and contact.whom.partition(".")[0]))
    ego = replace(situation.ego, does=all_of(situation.ego.does))
    return replace(situation, ego=ego, others=others, contact=contact)


def steps_of(verdict: Verdict, situation: Situation | None) -> tuple[Step, ...]:
    """The sequence of a reading.

    Raises:
        ValueError: It has more others or deeds than are written.
    """
    of = grammar().of
    token = (VERDICT, verdict.value)
    at = next(place for place in (VERDICT, f"{VERDICT}.not") if grammar().number[token] in of[place])
    told = _written(grammar().nodes, with_plain_names(situation)) if situation is not None else ()
    return (Step(at, token), *told, Step(END, (END, END)))


def _written(nodes: Sequence[Node], noun: Any) -> Iterator[Step]:
    for node in nodes:
        value = getattr(noun, node.name)
        if value != node.default or node.required or node.sort is Sort.NOUN:
            yield from _steps(node, value)


def _steps(node: Node, value: Any) -> Iterator[Step]:
    """The tokens of a field."""
    match node.sort:
        case Sort.NOUN:
            yield from _written(node.nodes, value)
        case Sort.NOUNS:
            for one in value:
                yield from _written(node.nodes, one)
        case Sort.OPEN:
            yield Step(node.place, (node.key, ""))
            yield from _written(node.nodes, value)
        case Sort.LIST:
            yield from (Step(node.place, (node.key, str(word))) for word in sorted(value, key=node.words.index))
        case Sort.AMOUNT:
            yield Step(node.place, (node.key, ""))
            yield Step(node.place + COPIED, None, value)
        case Sort.DEED:
            who, _, number = value.partition(".")
            yield Step(node.place, (node.key, who))
            yield Step(node.place + NUMBERED, (NUMBERED, number))
        case Sort.WORDS:
            yield Step(node.place, (node.key, str(value)))


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
