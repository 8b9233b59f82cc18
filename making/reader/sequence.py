"""The sequence of tokens of a situation, which the reader learns to write; nothing is lost of what a text can say."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import Any

from chatscene.read.learned.grammar import COPIED, DEEDS, END, NAMES, NUMBERED, VERDICT, Node, Sort, grammar
from chatscene.read.learned.sequence import Step
from chatscene.terms.reading import Verdict
from chatscene.terms.situation import EGO, Deed, Situation


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
