"""As much of a situation as can be built: lesser facts that cannot be are left out, each told with the reason.

What is left out first is what a watcher misses least: a number before a side, a side before a deed, a deed before
somebody who is not met. Where the ego goes, who meets it, where that one begins and what it does to the ego stay: a
situation that cannot be built with these is refused. So is one that somebody stated: only what was read is left out.
"""

from __future__ import annotations

import heapq
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import count

from chatscene.build.build import Built, build
from chatscene.errors import NoSuchPlace, NotBuilt, SituationError
from chatscene.situations.check import faults_of
from chatscene.situations.facts import all_facts, said_in, still_evident, with_facts, within
from chatscene.situations.naming import named_by
from chatscene.terms.situation import EGO, Deed, Other, Situation, When
from chatscene.terms.vocabulary import PLAIN, Heads, Role, Tempo, acts_of

TRIES = 40
"""Situations at most that are tried to be built."""
_BESIDE = 3
"""How much more it counts to leave out what the refusal does not name."""
_DEED, _WHEN, _SOMEBODY = 5, 4, 6
"""How much a watcher misses a deed, that it begins with another's, and somebody who is not met."""
_MISSED: Mapping[str, int] = {
    **dict.fromkeys(("manner", "acceleration", "time", "delay", "offset", "edge", "overlap", "clearance", "beyond"), 1),
    **dict.fromkeys(("has", "setting", "lanes", "two_way", "radius", "speed_limit", "at", "behind_nose"), 1),
    **dict.fromkeys(("distance", "speed", "breaks", "count", "ego_lane", "control", "ego", "other", "striker"), 2),
    **dict.fromkeys(("to", "side", "facing", "kind", "ego_light", "light", "weather", "surface"), 3),
    "hidden_by": 5,
}
"""How much a watcher misses a fact, by the name of its field."""
_AFTERWARDS = acts_of(
    *(Tempo.GAINS, Tempo.SETS_OFF, Tempo.WAITS),
    *(Heads.ALONG, Heads.THROUGH, Heads.BEHIND, Heads.CLOSE, Heads.LEVEL, Heads.OFF, Heads.BACK, Heads.EDGE),
)
"""What somebody does who has done to the ego what it is there for."""
_KEPT = re.compile(
    r"^(?:others\.[\w-]+\.(?:kind|role|starts\.where|does\.\d+\.(?:act|whom|when\..*))|ego\.(?:kind|does\..*\.act|route))$"
)
_PATH = re.compile(r"\b(?:(?:ego|road|contact|around)\.|others\.[\w-]+)[\w.-]*")


@dataclass(frozen=True, slots=True, kw_only=True)
class Less:
    """A situation without one of its facts.

    Attributes:
        path: Where the fact stands that it lacks.
        told: That fact, as ``path: value``.
        missed: How much a watcher misses it.
        situation: What is left.
    """

    path: str
    told: str
    missed: int
    situation: Situation


def build_in_part(situation: Situation) -> tuple[Situation, Built]:
    """As much of a situation as can be built, and its program; all of it if that can be.

    What is left out is told in the evidence of what is returned.

    Args:
        situation: What is to happen.

    Raises:
        NotBuilt: It cannot be built, and not without its lesser facts either; why not is told of the whole.
        MapError: There is no such map.
    """
    try:
        return situation, build(situation)
    except NotBuilt as error:
        found = _without_least(situation, error) if situation.evidence.quoted else None
        if found is None:
            raise
        return found


def _without_least(situation: Situation, refused: NotBuilt) -> tuple[Situation, Built] | None:
    """What is left of a situation without what is missed least, and its program; None if nothing helps.

    Facts are left out one after the other, as long as each time another refusal comes of it.
    """
    numbers, met = count(), {situation}
    tried: list[tuple[int, int, Situation, tuple[str, ...], str]] = []

    def push(one: Situation, missed: int, left_out: tuple[str, ...], error: NotBuilt) -> None:
        named = tuple(dict.fromkeys(_PATH.findall(str(error))))
        for path, several in ((None, _without_all(one, named)), *((less.path, [less]) for less in lesser_read(one))):
            if not several or several[-1].situation in met:
                continue
            met.add(several[-1].situation)
            beside = path is not None and not any(touches(path, other) for other in named)
            more = max(less.missed for less in several) + beside * _BESIDE
            told = (*left_out, *(less.told + _because(error, less.told) for less in several))
            heapq.heappush(tried, (missed + more, next(numbers), several[-1].situation, told, str(error)))

    push(situation, 0, (), refused)
    for _ in range(TRIES):
        if not tried:
            break
        missed, _, less, left_out, why = heapq.heappop(tried)
        try:
            built = build(less)
        except NotBuilt as error:
            if str(error) != why:
                push(less, missed, left_out, error)
            continue
        evidence = still_evident(situation, less)
        unbuilt = (*situation.evidence.unbuilt, *left_out)
        return replace(less, evidence=replace(evidence, unbuilt=unbuilt)), built
    return None


def _without_all(situation: Situation, named: tuple[str, ...]) -> list[Less]:
    """A situation without one after the other of the facts that a refusal names; none if one of them is no lesser one.

    A refusal that names several facts says that none of them is built.
    """
    several: list[Less] = []
    for path in named if len(named) > 1 else ():
        here = several[-1].situation if several else situation
        less = next((one for one in lesser_read(here) if f"{path}.".startswith(f"{one.path}.")), None)
        if less is None:
            return []
        several.append(less)
    return several


def touches(one: str, other: str) -> bool:
    """Whether one of two paths is in the other."""
    one, other = f"{one}.", f"{other.rstrip('.')}."
    return one.startswith(other) or other.startswith(one)


def _is_read(situation: Situation, path: str) -> bool:
    """Whether all facts at a path were read in a text: what somebody stated stays."""
    evidence = situation.evidence
    facts = [fact for fact, _ in said_in(situation) if within(fact, (path,))]
    return all(fact in evidence.assumed or within(fact, evidence.quoted) for fact in facts)


def _because(error: NotBuilt, told: str) -> str:
    """Why a fact is left out, behind it in brackets; empty where the refusal says no more than that it is not built."""
    if isinstance(error, NoSuchPlace):
        return " (no map has such a place with it)"
    path, _, value = told.partition(": ")
    clauses = str(error).removeprefix("impossible: ").removeprefix("cannot be built yet: ").split("; ")
    clause = next((one for one in clauses if one.startswith(path)), clauses[0])
    why = clause.removeprefix(path).removeprefix(".act").removeprefix(": ")
    return f" ({why})" if why not in ("", told, value) else ""


def lesser_read(situation: Situation) -> Iterator[Less]:
    """The same of each lesser fact that was read in a text."""
    return (less for less in lesser(situation) if _is_read(situation, less.path))


def lesser(situation: Situation) -> Iterator[Less]:
    """A situation without each of its lesser facts in turn."""
    for path, value in all_facts(situation):
        parts = path.split(".")
        field = "has" if parts[:2] == ["road", "has"] else parts[-1]
        if _KEPT.match(path) or field not in _MISSED:
            continue
        yield from _sound(
            path, f"{path}: {value}" if field != "has" else path, _MISSED[field], _without(situation, path)
        )
    for who, does in situation.everybody():
        for k, deed in enumerate(does):
            at = f"{'' if who == EGO else 'others.'}{who}.does.{k}"
            if deed.when is not None:
                told = ", ".join(f"{at}.{path}" for path in _when_told(deed.when))
                yield from _sound(f"{at}.when", told, _WHEN, _with_deed(situation, who, k, replace(deed, when=None)))
            if not _is_main(situation, who, k) and not _is_waited_for(situation, who, k):
                yield from _sound(at, f"{at}: {deed.act}", _DEED, _with_deed(situation, who, k, None))
    for one in situation.others:
        if _is_beside_it(situation, one):
            left = replace(situation, others=tuple(other for other in situation.others if other is not one))
            deeds = sum(deed.act not in PLAIN for deed in one.does)
            yield from _sound(
                f"others.{one.id}", f"others.{one.id}: {one.kind} {one.starts.where}", _SOMEBODY + deeds, left
            )


def _sound(path: str, told: str, missed: int, situation: Situation | None) -> Iterator[Less]:
    """What is left, if that is a situation."""
    if situation is not None and not any(faults_of(situation)):
        yield Less(path=path, told=told, missed=missed, situation=situation)


def _without(situation: Situation, path: str) -> Situation | None:
    try:
        return with_facts(situation, {path: None})
    except SituationError:
        return None


def _when_told(when: When) -> Iterator[str]:
    """The facts of when something is done, as ``path: value``."""
    for name in ("after", "during", "delay", "ego_within", "of"):
        if (value := getattr(when, name)) is not None:
            yield f"when.{name}: {value}"


def _is_main(situation: Situation, who: str, k: int) -> bool:
    """Whether a deed is what somebody is there for, or one comes before that: it is not left out."""
    if who == EGO:
        return False
    one = situation[who]
    tells = [n for n, deed in enumerate(one.does) if deed.act not in PLAIN]
    if not tells or k <= tells[0]:
        return True
    after = range(k, len(one.does)) if one.role is Role.ADVERSARY else ()
    return k != len(one.does) - 1 or any(one.does[n].act not in _AFTERWARDS for n in after)


def _is_waited_for(situation: Situation, who: str, k: int) -> bool:
    """Whether a deed of somebody waits for one."""
    return any(
        number == k
        for reference in _references(situation)
        if (number := _number(situation, reference, who)) is not None
    )


def _references(situation: Situation) -> Iterator[str]:
    for _, does in situation.everybody():
        for deed in does:
            when = deed.when or When()
            yield from filter(None, (when.after, when.during))


def _number(situation: Situation, reference: str, who: str) -> int | None:
    """Which deed of somebody a reference means; None if it means another's."""
    return situation.number_of(reference) if reference.partition(".")[0] == who else None


def _with_deed(situation: Situation, who: str, k: int, deed: Deed | None) -> Situation:
    """A situation with another deed in place of one of somebody's, or without it."""
    does = situation.does(who)
    made = (*does[:k], *((deed,) if deed is not None else ()), *does[k + 1 :])
    if who == EGO:
        left = replace(situation, ego=replace(situation.ego, does=made))
    else:
        others = tuple(replace(one, does=made) if one.id == who else one for one in situation.others)
        left = replace(situation, others=others)
    return left if deed is not None else _renumbered(left, situation, who, k)


def _renumbered(left: Situation, whole: Situation, who: str, k: int) -> Situation:
    """A situation in which references to deeds behind one of somebody's, which is gone, have the numbers of now."""

    def now(reference: str | None) -> str | None:
        number = None if reference is None else _number(whole, reference, who)
        return reference if number is None else f"{who}.{number - (number > k)}"

    def again(does: Iterable[Deed]) -> tuple[Deed, ...]:
        whens = ((deed, deed.when) for deed in does)
        return tuple(
            deed if when is None else replace(deed, when=replace(when, after=now(when.after), during=now(when.during)))
            for deed, when in whens
        )

    others = tuple(replace(one, does=again(one.does)) for one in left.others)
    return replace(left, ego=replace(left.ego, does=again(left.ego.does)), others=others)


def _is_beside_it(situation: Situation, one: Other) -> bool:
    """Whether somebody is not met, and nobody speaks of it: it can be left out."""
    if one.role is Role.ADVERSARY and one is situation.adversaries[0]:
        return False
    if situation.contact is not None and situation.contact.whom == one.id:
        return False
    named = {name for who, does in situation.everybody() if who != one.id for deed in does for name in named_by(deed)}
    return one.role is not Role.ADVERSARY and one.id not in named | {other.hidden_by for other in situation.others}
