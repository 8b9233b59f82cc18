"""A situation that was stated, and the program that is built of it, for scripts and people."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from chatscene.build.build import Built, build
from chatscene.files.bounded import is_there
from chatscene.read.quotes import left_over, not_in_words
from chatscene.situations.file import read_file, to_yaml
from chatscene.situations.form import to_plain, with_fact
from chatscene.situations.words import told
from chatscene.terms.situation import Situation


@dataclass(frozen=True, slots=True, kw_only=True)
class Stated:
    """A situation and its program, before anything is run.

    Attributes:
        situation: What was said.
        built: The program, what was assumed and what is left out.
        reader: Who read it in a text; empty if it was stated.
    """

    situation: Situation
    built: Built
    reader: str = ""

    def as_dict(self) -> dict[str, Any]:
        """For a script."""
        return {
            "told": told(self.situation),
            "situation": to_plain(self.situation),
            "map": self.built.map,
            "assumed": list(self.built.assumed),
            "left_out": list(self.built.left_out),
            "not_read": list(left_over(self.situation)),
            "reader": self.reader,
            "program": self.built.program.source,
        }

    @property
    def told_first(self) -> tuple[str, ...]:
        """What the program has that was not said, and what it lacks, in lines."""
        return (
            *not_in_words(self.situation),
            *(f"assumed: {one}" for one in self.built.assumed),
            *(f"left out: {one}" for one in self.built.left_out),
        )

    def __str__(self) -> str:
        """For a person: what is otherwise than was said, the situation in words, its facts, and its map."""
        words = filter(None, (told(self.situation),))
        return "\n".join((*self.told_first, *words, to_yaml(self.situation).rstrip(), f"built on map {self.built.map}"))


def stated(
    situation: Situation | Path, facts: Mapping[str, object] | None = None, map_name: str | None = None
) -> Situation:
    """A situation, or that in a file, with some facts set by their paths.

    Raises:
        SituationError: It is none, or a fact has no place in it.
    """
    made = situation if isinstance(situation, Situation) else read_file(situation)
    if map_name is None and isinstance(situation, Path) and made.map and is_there(situation.parent / made.map):
        map_name = str((situation.parent / made.map).resolve())
    if map_name is not None:
        made = replace(made, map=map_name)
    for path, value in (facts or {}).items():
        made = with_fact(made, path, value)
    return made


def explain_stated(situation: Situation, reader: str = "") -> Stated:
    """What becomes of a situation.

    Args:
        situation: What is to happen.
        reader: Who read it in a text; empty if it was stated.

    Raises:
        NotBuilt: A fact of it cannot be built.
    """
    return Stated(situation=situation, built=build(situation), reader=reader)
