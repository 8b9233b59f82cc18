"""A situation that was stated, and the program that is built of it, for scripts and people."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from chatscene.build.build import Built, build
from chatscene.build.in_part import build_in_part
from chatscene.errors import OfferedReading
from chatscene.files.bounded import is_there
from chatscene.maps.left_hand import keeps_left
from chatscene.maps.network import resolve_map
from chatscene.read.quotes import left_over, not_in_words, words_of
from chatscene.report.accounting import in_words, parts_of
from chatscene.situations.facts import with_fact
from chatscene.situations.file import read_file, read_text, to_yaml
from chatscene.situations.form import to_plain
from chatscene.situations.words import title, told
from chatscene.terms.mirroring import as_said_on
from chatscene.terms.scenario import Scenario
from chatscene.terms.scene import ScenicProgram
from chatscene.terms.situation import Evidence, Situation

if TYPE_CHECKING:
    from chatscene.runs.record import SituationRecord
    from chatscene.situations.edited import Edited

Editor = Callable[[Situation, str], tuple["Edited", Built]]
"""Who applies an edit in words to a situation, and what is built of that."""


@lru_cache(maxsize=8)
def _shown_in_part(text: str, built: Built) -> tuple[Situation, Built]:
    from chatscene.search.shown_in_part import shown_in_part  # who asks for no program drives nothing

    return shown_in_part(read_text(text), built)


@dataclass(frozen=True, slots=True, kw_only=True)
class Stated:
    """A situation and its program, before anything is run.

    Attributes:
        situation: What was said.
        built: The program before it is rehearsed, what was assumed and what is left out.
        reader: Who read it in a text; empty if it was stated.
        editor: Who applies edits in words; who reads without a language model if None.
        readings: What else the text may say that it was read in.
    """

    situation: Situation
    built: Built
    reader: str = ""
    editor: Editor | None = field(default=None, repr=False)
    readings: tuple[OfferedReading, ...] = ()

    @property
    def told(self) -> str:
        """The situation in plain sentences."""
        return told(self.situation)

    @property
    def program(self) -> ScenicProgram:
        """Its program, as a run has it."""
        return self.as_shown.rehearsed.program

    @property
    def rehearsed(self) -> Built:
        """Its program with shifted ranges, and what was assumed for that."""
        from chatscene.search.rehearsal import rehearsed_once  # who asks for no program drives nothing

        return rehearsed_once(self.built, self.situation)

    @property
    def as_shown(self) -> Stated:
        """The same without lesser facts for which no drive shows what was said; asking for it drives the program."""
        made, built = _shown_in_part(to_yaml(self.situation), self.built)
        if built is self.built:
            return self
        return replace(self, situation=replace(made, about=self.situation.about), built=built)

    @property
    def unseen(self) -> tuple[str, ...]:
        """What none of its drives shows, in lines; asking for it drives the program."""
        return self.rehearsed.unseen

    @property
    def shifted(self) -> tuple[str, ...]:
        """What is assumed besides since the program was rehearsed, in lines; asking for it drives the program."""
        return tuple(f"assumed: {one}" for one in self.rehearsed.assumed if one not in self.built.assumed)

    @property
    def generator(self) -> str:
        """Who makes scenes of it, by name."""
        return "situation"

    @property
    def scenario(self) -> Scenario:
        """The scenario that a run of it has."""
        from chatscene.search.generators.situated import Situated
        from chatscene.settings import RetrievalSettings

        return Situated().read(to_yaml(replace(self.situation, map=self.built.map)), RetrievalSettings())

    @property
    def record(self) -> SituationRecord:
        """The situation as a run keeps it."""
        from chatscene.runs.record import SituationRecord

        return SituationRecord(
            name=self.situation.about or title(self.situation),
            text=to_yaml(replace(self.situation, map=self.built.map)),
            read_by=self.reader,
        )

    def edit(self, text: str) -> Changed:
        """The same situation but for what an edit in words names, such as "make it a truck, from the left".

        Raises:
            EditRefused: The edit was not understood, contradicts itself or what stays, or changes nothing.
            NotBuilt: The edited situation cannot be built.
        """
        made, built = (self.editor or _edited_offline)(self.situation, text)
        return Changed(
            situation=made.after,
            built=built,
            reader=self.reader,
            editor=self.editor,
            before=self,
            edited=made,
        )

    def as_dict(self) -> dict[str, Any]:
        """For a script."""
        if (shown := self.as_shown) is not self:
            return shown.as_dict()
        return {
            "told": told(self.situation),
            "situation": to_plain(self.situation),
            "map": self.built.map,
            "assumed": list(self.rehearsed.assumed),
            "left_out": list(self.rehearsed.left_out),
            "unseen": list(self.unseen),
            "not_read": list(left_over(self.situation)),
            "words": self._words(),
            "reader": self.reader,
            "program": self.program.source,
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
        from chatscene.report.terminal import readings_in_words

        facts = to_yaml(replace(self.situation, evidence=Evidence(), about="")).rstrip()
        words = in_words(parts_of(self.situation.about, self._words())) if self.reader else ""
        told = filter(None, (self.told, words, facts))
        also = readings_in_words(self.readings, also=True)
        return "\n".join((*self.told_first, *told, f"built on map {self.built.map}", *also))

    def _repr_html_(self) -> str:
        """For a notebook, as the report shows it."""
        from chatscene import runs
        from chatscene.report.notebook import understanding_frame

        scenario = self.scenario
        explained = runs.explain(self.situation.about, [(scenario, None)])
        explained["scenarios"][0]["notes"] = list(self.told_first)
        return understanding_frame(scenario, {**explained, "program": self.program.source})

    def _words(self) -> list[dict[str, Any]]:
        return [word.as_dict() for word in words_of(self.situation, self.situation.about)] if self.reader else []


@dataclass(frozen=True, slots=True, kw_only=True)
class Changed(Stated):
    """What became of a situation after an edit in words; as text it is the difference.

    Attributes:
        before: What it was.
        edited: What the edit names and what follows from that.
    """

    before: Stated
    edited: Edited

    @property
    def difference(self) -> tuple[str, ...]:
        """The lines of the program that went (``-``) and came (``+``), without comments."""
        return lines_changed(self.before.program.source, self.program.source)

    def as_dict(self) -> dict[str, Any]:
        """For a script: the situation and the program, and the difference."""
        changes = [
            {"fact": path, "before": None if was is None else str(was), "after": None if now is None else str(now)}
            for path, was, now in self.edited.changes
        ]
        more = {"edit": self.edited.text, "changes": changes, "difference": list(self.difference)}
        return Stated.as_dict(self) | more

    def __str__(self) -> str:
        """For a person: the situation told anew, the facts and the lines of the program that changed."""
        return "\n".join(
            (
                f"now: {self.told}",
                *(f"  {one}" for one in self.edited.in_words()),
                *(f"  {one}" for one in self.told_first if one not in self.before.told_first),
                *difference_told(self.difference),
            )
        )


def _edited_offline(situation: Situation, text: str) -> tuple[Edited, Built]:
    from chatscene.interpret.edited import edited

    made = edited(situation, text)
    return made, built_of(made.after)


def built_of(situation: Situation) -> Built:
    """The program of a situation, called as a run of it is.

    Raises:
        NotBuilt: A fact of it cannot be built.
    """
    from chatscene.interpret.scenario_names import scenario_id

    return build(situation, name=scenario_id(situation))


def built_in_part(situation: Situation) -> tuple[Situation, Built]:
    """As much of a situation as can be built, and its program, called as a run of it is.

    Raises:
        NotBuilt: It cannot be built without its lesser facts either.
    """
    from chatscene.interpret.scenario_names import scenario_id

    made, built = build_in_part(situation)
    return made, replace(built, program=replace(built.program, scenario_id=scenario_id(made)))


def lines_changed(before: str, after: str) -> tuple[str, ...]:
    """The lines of a program that went (``-``) and came (``+``) from one text to another, without comments."""
    lines = difflib.unified_diff(before.splitlines(), after.splitlines(), n=0, lineterm="")
    code = (line for line in list(lines)[2:] if not line.startswith("@@"))
    return tuple(line for line in code if line[1:].strip() and line[1:].lstrip()[0] != "#")


def difference_told(difference: Sequence[str]) -> tuple[str, ...]:
    """The difference of two programs, for a person."""
    return ("program:" if difference else "program: as before", *(f"  {line}" for line in difference))


def stated(
    situation: Situation | Path,
    facts: Mapping[str, object] | None = None,
    map_name: str | None = None,
    speed: float | None = None,
) -> Situation:
    """A situation, or that in a file, with some facts set by their paths.

    Args:
        situation: Which.
        facts: What is set.
        map_name: The map that it is to be built on; None for its own.
        speed: What the ego drives at [km/h], if the situation does not say.

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
    if made.map is not None:
        made = as_said_on(made, keeps_left=keeps_left(resolve_map(made.map)))
    return made if speed is None or made.ego.speed is not None else with_fact(made, "ego.speed", f"{speed:g} km/h")


def explain_stated(situation: Situation, reader: str = "", edits: Sequence[str] = ()) -> Stated:
    """What becomes of a situation, and of edits of it, one after the other.

    Raises:
        NotBuilt: A fact of it cannot be built.
        EditRefused: An edit was not understood.
    """
    made, built = built_in_part(situation)
    return with_edits(Stated(situation=made, built=built, reader=reader), edits)


def with_edits(made: Stated, edits: Sequence[str]) -> Stated:
    """What becomes of a situation by edits in words, one after the other.

    Raises:
        EditRefused: An edit was not understood.
        NotBuilt: An edited situation cannot be built.
    """
    for one in edits:
        made = made.edit(one)
    return made
