"""The facts of a situation by their paths, others by their ids: ``others.A.starts.side``."""

from __future__ import annotations

import re
from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import fields, is_dataclass, replace
from typing import Any, cast

from chatscene.errors import SituationError
from chatscene.situations.form import from_plain, to_plain
from chatscene.terms.amount import Amount
from chatscene.terms.situation import Evidence, Situation

NO_FACTS = frozenset(("version", "about", "map", "evidence"))
"""What a situation has beside facts."""
NAMED = "about"
"""The path for whose words a situation is called by: those of facts that were changed since it was read, too."""
GAP = " \u2026 "
"""Stands in a quote where words of the text are left out that gave another fact."""
_NAMES = re.compile(rf"(?:^(?:{'|'.join(sorted(NO_FACTS))})(?:\..*)?|\.id|\.role)$")

_KIND = re.compile(r"others\.[^.]+\.kind")
_NAMES_ONE = ("hidden_by", "whom", "after", "during", "of")


def said_in(situation: Situation) -> Iterator[tuple[str, object]]:
    """Each fact of a situation by its path; an id and a role are none, as they are there wherever somebody is."""
    for path, value in _leaves(to_plain(situation), ()):
        if not _NAMES.search(path):
            yield path, value


def is_said(situation: Situation, path: str) -> bool:
    """Whether something stands at a path: a fact, or a whole with facts in it."""
    here: Any = situation
    for step in path.split("."):
        if isinstance(here, tuple):
            here = _in_list(cast("tuple[Any, ...]", here), step)
        else:
            here = getattr(here, step) if step in _fields(here) else None
    nothing = (None, ())
    return any(getattr(here, name) not in nothing for name in _fields(here)) if _fields(here) else here not in nothing


def still_evident(before: Situation, after: Situation) -> Evidence:
    """The evidence of a situation of which another was made: what changed was stated by whoever changed it.

    Words that were quoted for a whole stay with the facts in it that are as they were; those for which no fact is left
    were read all the same, and stand for the name. What was left out and is stated now is left out no more.
    """
    was, now = dict(said_in(before)), dict(said_in(after))
    same = {path for path, value in was.items() if now.get(path) == value}

    def stays(whole: str) -> bool:
        return all(path in same for path in {*was, *now} if within(path, (whole,)))

    def left_of(whole: str, narrower: Sequence[str]) -> list[str]:
        return [path for path in was if path in same and within(path, (whole,)) and not within(path, narrower)]

    quoted: dict[str, str] = {}
    gone: list[str] = []
    for whole, words in before.evidence.quoted.items():
        if stays(whole):
            quoted[whole] = words
            continue
        narrower = [one for one in before.evidence.quoted if one != whole and within(one, (whole,))]
        kept = left_of(whole, narrower)
        quoted |= dict.fromkeys(kept, words)
        gone += [] if kept else [words]
    if gone:
        quoted[NAMED] = GAP.join(dict.fromkeys(filter(None, (quoted.get(NAMED), *gone))))
    still = {path: (path,) if stays(path) else left_of(path, ()) for path in before.evidence.assumed}
    assumed = tuple(path for paths in still.values() for path in paths)
    unbuilt = tuple(one for one in before.evidence.unbuilt if one.partition(": ")[0] not in now)
    return replace(before.evidence, quoted=quoted, assumed=assumed, unbuilt=unbuilt)


def within(path: str, wholes: Container[str]) -> bool:
    """Whether a path is one of some, or lies in one of them."""
    steps = path.split(".")
    return any(".".join(steps[: i + 1]) in wholes for i in range(len(steps)))


def _fields(noun: Any) -> frozenset[str]:
    """Where the parts of a noun stand; none of what is no noun."""
    if not is_dataclass(noun) or isinstance(noun, Amount):
        return frozenset()
    return frozenset(one.name for one in fields(noun)) - NO_FACTS


def _in_list(several: tuple[Any, ...], step: str) -> object:
    for one in several:
        if getattr(one, "id", None) == step:
            return one
    return several[int(step)] if step.isdecimal() and len(step) < 4 and int(step) < len(several) else None


def _leaves(value: object, path: tuple[str, ...]) -> Iterator[tuple[str, object]]:
    if isinstance(value, Mapping):
        for name, part in cast("Mapping[str, object]", value).items():
            yield from _leaves(part, (*path, name))
    elif isinstance(value, Sequence) and not isinstance(value, str):
        for i, part in enumerate(cast("Sequence[object]", value)):
            named = cast("Mapping[str, object]", part).get("id", i) if isinstance(part, Mapping) else i
            yield from _leaves(part, (*path, str(named)))
    else:
        yield ".".join(path), value


def all_facts(situation: Situation) -> Iterator[tuple[str, object]]:
    """Each fact of a situation by its path, roles too; of a list of words each word has a path: ``road.has.school``."""
    plain = to_plain(situation)
    for path, value in _leaves({name: part for name, part in plain.items() if name not in NO_FACTS}, ()):
        whole, _, last = path.rpartition(".")
        if last.isdecimal():
            yield f"{whole}.{value}", True
        elif last != "id":
            yield path, value


# One fact another


def with_facts(situation: Situation, changed: Mapping[str, object]) -> Situation:
    """A situation with some facts of `all_facts` others than they were; None for what is not said.

    Whoever is of no kind any more is gone, and nobody speaks of it.

    Raises:
        SituationError: There is no such place, or it takes no such value.
    """
    facts = {path: value for path, value in {**dict(all_facts(situation)), **changed}.items() if value is not None}
    gone = {path.split(".")[1] for path, value in changed.items() if value is None and _KIND.fullmatch(path)}
    kept = {
        path: value
        for path, value in facts.items()
        if not (path.startswith("others.") and path.split(".")[1] in gone)
        and not (path.rpartition(".")[2] in _NAMES_ONE and str(value).partition(".")[0] in gone)
    }
    whole: dict[str, Any] = {}
    for path, value in kept.items():
        *steps, last = path.split(".")
        here = whole
        for step in steps:
            here = here.setdefault(step, {})
        here[last] = value
    made = from_plain({name: part for name, part in to_plain(situation).items() if name in NO_FACTS} | _listed(whole))
    return replace(made, evidence=still_evident(situation, made))


def _listed(whole: dict[str, Any]) -> dict[str, Any]:
    """A mapping in which lists are lists again: others in their order, deeds by their numbers, words alone."""
    made: dict[str, Any] = {}
    for name, part in whole.items():
        if name == "others":
            made[name] = [{"id": one, **_listed(its)} for one, its in part.items()]
        elif name == "does":
            made[name] = [_listed(part[number]) for number in sorted(part, key=int)]
        elif name == "has":
            made[name] = list(part)
        else:
            made[name] = _listed(part) if isinstance(part, dict) else part
    return made


def with_fact(situation: Situation, path: str, value: object) -> Situation:
    """A situation with one fact another than it was.

    Args:
        situation: What it was.
        path: Where the fact stands, as in ``others.A.does.0.speed`` or ``ego.route``.
        value: As it stands in a file; None for what is not said. Somebody new comes with the path of the new id.

    Raises:
        SituationError: There is no such place, or it takes no such value.
    """
    plain = to_plain(situation)
    steps = path.split(".")
    here: Any = plain
    for i, step in enumerate(steps[:-1]):
        here = _into(here, step, ".".join(steps[: i + 1]))
    _put(here, steps[-1], value, path)
    made = from_plain(plain)
    return replace(made, evidence=still_evident(situation, made))


def _into(here: Any, step: str, path: str) -> Any:
    if isinstance(here, dict):
        return here.setdefault(step, [] if step in ("does", "others", "has") else {})
    return here[_index(here, step, path)]


def _index(here: Any, step: str, path: str) -> int:
    if isinstance(here, list):
        several = cast("list[Any]", here)
        for i, one in enumerate(several):
            if isinstance(one, dict) and cast("dict[str, Any]", one).get("id") == step:
                return i
        if step.isdecimal() and int(step) < len(several):
            return int(step)
        named = [
            str(cast("dict[str, Any]", one).get("id", i)) for i, one in enumerate(several) if isinstance(one, dict)
        ]
        raise SituationError(f"{path}: there is no {step!r} here, but {', '.join(named) or 'nothing'}")
    raise SituationError(f"{path}: there is nothing in {here!r}")


def _put(here: Any, step: str, value: object, path: str) -> None:
    if isinstance(here, dict):
        place = cast("dict[str, Any]", here)
        if value is None:
            place.pop(step, None)
        else:
            place[step] = value
        return
    if isinstance(here, list) and isinstance(value, dict) and cast("dict[str, Any]", value).get("id") == step:
        several = cast("list[dict[str, Any]]", here)
        at = next((i for i, one in enumerate(several) if one.get("id") == step), len(several))
        several[at : at + 1] = [cast("dict[str, Any]", value)]  # where it was, or behind all
        return
    at = _index(here, step, path)
    if value is None:
        del here[at]
    else:
        here[at] = value
