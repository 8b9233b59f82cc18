"""The words of a situation for an agent: all of them in short, or one of them at length."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import Any

from chatscene.errors import SettingsError, no_such
from chatscene.situations.form import schema
from chatscene.terms.lateral import LATERAL_OF_STARTS
from chatscene.terms.situation import Lateral
from chatscene.terms.vocabulary import Act

ALL = "Situation"


@cache
def nouns() -> dict[str, Any]:
    """The parts of the schema, by name: nouns with fields, and tables of words."""
    made = schema()
    parts: dict[str, Any] = made.pop("$defs")
    return {ALL: made, **parts}


def listed() -> str:
    """Every noun with its fields, and every table with its words."""
    lines = ["A situation is YAML. Its nouns, with their fields:"]
    lines += [f"  {name}: {', '.join(part['properties'])}" for name, part in nouns().items() if "properties" in part]
    lines += ["Tables, with their words:"]
    lines += [f"  {name}: {', '.join(part['enum'])}" for name, part in nouns().items() if "enum" in part]
    lines += [
        "Amounts have units: 50 km/h, 10 m, 3 s, 4 m/s²; or a range: 30 to 50 km/h.",
        "For one of them call vocabulary again: about=cut-in, about=Deed, about=others.A.starts.where",
        EXAMPLE,
    ]
    return "\n".join(lines)


def explained(about: str) -> str:
    """One noun, table, word, or what stands at a path.

    Raises:
        SettingsError: There is no such thing.
    """
    by_name = {name.lower(): name for name in nouns()}
    if (name := by_name.get(about.lower())) is not None:
        return _part(name)
    if found := [*_words(about.lower())]:
        return "\n".join(found)
    if "." in about or about in nouns()[ALL]["properties"]:
        return _at(about)
    words = (word for part in nouns().values() for word in part.get("enum", ()))
    raise SettingsError(no_such("word, table, noun or path", about[:60], {*nouns(), *words}).partition("; known")[0])


EXAMPLE = """An example:
  ego: {route: straight, speed: 50 km/h}
  road: {kind: road}
  others:
  - {id: A, kind: pedestrian, starts: {where: roadside, side: right}, does: [{act: cross, speed: 5 km/h}]}"""


def _part(name: str) -> str:
    part = nouns()[name]
    head = str(part.get("description", "")).strip()
    if "properties" not in part:
        return f"{name}: {head}"
    fields = (f"  {field} ({_kind(said)}): {said.get('description', '')}" for field, said in part["properties"].items())
    return "\n".join((f"{name}: {head}", *fields, *_built_where(name)))


def _built_where(name: str) -> Iterator[str]:
    """Where a noun is built that not every place or act has."""
    if name == Lateral.__name__:
        yield f"  {LATERAL_OF_STARTS}"
        yield f"  a deed may have it whose act is {', '.join(act for act in Act if act.row.placed)}"


def _kind(said: Any) -> str:
    """What stands in a field: the name of a noun or a table, or a plain type."""
    for key in ("anyOf", "allOf", "oneOf"):
        if key in said:
            return " or ".join(dict.fromkeys(_kind(one) for one in said[key] if one.get("type") != "null"))
    if "$ref" in said:
        return str(said["$ref"]).rpartition("/")[2]
    if said.get("type") == "array":
        return f"list of {_kind(said.get('items', {}))}"
    return str(said.get("type", "value"))


def _words(about: str) -> Iterator[str]:
    """What a word means in each table that has it, and, of an act, from where and how it is done."""
    for name, part in nouns().items():
        if about in part.get("enum", ()):
            meanings = dict(line.split(": ", 1) for line in part["description"].splitlines()[1:] if ": " in line)
            yield f"{about} ({name}): {meanings.get(about, '')}".rstrip(": ")
            if name == "Act":
                yield from _act(about)


def _act(word: str) -> Iterator[str]:
    from chatscene.build.possible import FROM
    from chatscene.terms.vocabulary import FOR_SOMEBODY, UserKind, Where

    act = Act(word)
    yield f"  by: {', '.join(kind for kind in UserKind if kind.can(act))}{', ego' * act.row.ego}"
    begins = FROM.get(act)
    yield f"  begins from (starts.where): {', '.join(one for one in Where if one in begins) if begins else 'anywhere'}"
    whom = ["whom"] * (act.row.whom or act in FOR_SOMEBODY)
    fields = [*sorted(act.row.takes), *["to"] * act.row.sided, *whom, *["lateral"] * act.row.placed]
    yield f"  may have: {', '.join([*fields, 'when', 'manner', 'breaks'])}"


def _at(path: str) -> str:
    """What stands at a path, as ``others.A.does.0.act``."""
    here, steps, of_list = ALL, path.split("."), False
    for number, step in enumerate(steps):
        fields = nouns()[here].get("properties", {})
        if of_list and step not in fields:
            of_list = False
            continue  # the id of somebody, or a number
        if step not in fields:
            told = ".".join(steps[: number + 1])
            raise SettingsError(f"nothing stands at {told[:100]!r}; {here} has {', '.join(fields)}")
        kind = _kind(fields[step])
        names = [one for one in kind.removeprefix("list of ").split(" or ") if one in nouns()]
        if not names:
            return f"{path} ({kind}): {fields[step].get('description', '')}"
        here, of_list = names[0], kind.startswith("list of ")
    return f"{path}: {_part(here)}"
