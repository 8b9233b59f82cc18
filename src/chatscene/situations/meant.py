"""What was meant by a word or a field that a written situation does not have."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterable, Iterator
from dataclasses import fields, is_dataclass
from functools import cache
from typing import Any

from chatscene.terms import situation as nouns
from chatscene.terms import surroundings, vocabulary
from chatscene.terms.pointing import nearest
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import Word

ALIKE = 0.6  # of two words that are taken for one that was written wrong


def word_meant(given: str, words: Iterable[str]) -> str:
    """The end of a sentence that says which of some words was meant; empty if none was.

    A word of which the parts stand in another order is meant first, then one that is spelled much alike, then the one
    whose meaning has the word that was given, as a lorry is a truck.
    """
    known = list(words)
    turned = (word for word in known if _parts(word) == _parts(given))
    near = next(turned, "") or nearest(given.lower(), known, alike=ALIKE)
    found = [near] if near else _by_meaning(given, known)
    return f"; did you mean {' or '.join(found[:2])}?" if found else ""


def field_meant(given: str, path: tuple[str | int, ...]) -> str:
    """The end of a sentence that says where a field stands that does not stand at a path, and which stand there."""
    here = fields_at(path)
    if found := nearest(given.lower(), here, alike=ALIKE):
        return f"; did you mean {found}?"
    noun = noun_at(path)
    below = [one for one in _places(noun) if one.rpartition(".")[2] == given] if noun is not None else []
    anywhere = below or [one for one in _places(Situation) if one.rpartition(".")[2] == given]
    if anywhere:
        return f"; did you mean {' or '.join(anywhere[:2])}?"
    return f", but {', '.join(here)}" if here else ""


def words_at(path: tuple[str | int, ...]) -> tuple[str, ...]:
    """The words of which one stands at a path; nothing where no table says."""
    noun = noun_at(path[:-1])
    held = "" if noun is None else next((str(one.type) for one in fields(noun) if one.name == path[-1]), "")
    return next((tuple(map(str, one)) for one in _tables() if one.__name__ == held.partition(" ")[0]), ())


def noun_at(path: tuple[str | int, ...]) -> type[Any] | None:
    """The noun that stands at a path; None where no noun does."""
    noun: Any = Situation
    for step in path:
        if isinstance(step, str):
            noun = _parts_of(noun).get(step) if noun is not None else None
    return noun


def fields_at(path: tuple[str | int, ...]) -> tuple[str, ...]:
    """The fields of the noun at a path."""
    noun = noun_at(path)
    return tuple(one.name for one in fields(noun)) if noun is not None else ()


def _parts(word: str) -> list[str]:
    return sorted(re.split(r"[-_\s]+", word.strip().lower()))


def _by_meaning(given: str, known: list[str]) -> list[str]:
    """The words of a table whose meaning has a word."""
    table = next((one for one in _tables() if [str(word) for word in one] == known), None)
    if table is None or not given.strip():
        return []
    said = re.compile(rf"\b{re.escape(given.strip().lower().replace('-', ' '))}s?\b")
    return [str(word) for word in table if said.search(word.meaning.lower())]


@cache
def _tables() -> tuple[type[Word], ...]:
    every = (*vars(vocabulary).values(), *vars(surroundings).values())
    return tuple(one for one in every if inspect.isclass(one) and issubclass(one, Word) and len(one))


@cache
def _parts_of(noun: type[Any]) -> dict[str, type[Any]]:
    """The fields of a noun that hold nouns, with which."""
    found: dict[str, type[Any]] = {}
    for one in fields(noun):
        names = [getattr(nouns, name, None) for name in re.findall(r"\w+", str(one.type))]
        if (held := next((name for name in names if is_dataclass(name)), None)) is not None:
            found[one.name] = held  # pyright: ignore[reportArgumentType] - a class, since nouns are
    return found


def _places(noun: type[Any], above: str = "") -> Iterator[str]:
    """The paths of all fields in a noun, the nearest first, but for those of evidence."""
    yield from (f"{above}{one.name}" for one in fields(noun))
    for name, part in _parts_of(noun).items():
        if name != "evidence":
            yield from _places(part, f"{above}{name}.")
