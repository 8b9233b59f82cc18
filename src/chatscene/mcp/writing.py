"""Tools that write: the words of a situation, sentences read into one, programs built of one, edits, imports."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path as Place
from typing import TYPE_CHECKING, Annotated, cast

from pydantic import Field

import chatscene
from chatscene.errors import SettingsError
from chatscene.mcp.tool import Desk, Path, Text, first_of

if TYPE_CHECKING:
    from chatscene.report.stated import Stated
    from chatscene.terms.situation import Situation

SITUATIONS = (".yaml", ".yml", ".json")
Sentence = Annotated[str, Field(max_length=2000, description="One situation in plain English, up to 2,000 characters.")]
_Short = Annotated[str, Field(max_length=200)]
Facts = Annotated[
    dict[_Short, _Short | int | float | bool],
    Field(max_length=50, description='Facts that hold whatever the text says, by path: {"others.A.kind": "truck"}.'),
]
Given = Annotated[
    dict[_Short, Annotated[str, Field(max_length=2000)] | int | float | bool | list[int | float]],
    Field(max_length=50, description="Parameters that a program reads and does not state, or a .xosc declares."),
]
Variant = Annotated[int, Field(ge=1, le=10**9, description="One set of parameter values of an .xosc file, from 1.")]
Written = Annotated[Text, Field(description="A situation as YAML or JSON text. Give this or `file`.")]
SituationFile = Annotated[Path, Field(description="A file with a situation (.yaml, .json). Give this or `situation`.")]
SaveAs = Annotated[Path, Field(description="A new .yaml file for the situation; its .scenic program lies beside it.")]


def vocabulary(
    desk: Desk,
    about: Annotated[str, Field(max_length=200, description="A word, a table, a noun or a path; empty for all.")] = "",
) -> str:
    """Say which words a situation may have, and what they mean.

    Without `about` it lists every noun with its fields, and every table with its words. With `about` it explains one:
    a word (cut-in), a table (Act), a noun (Deed), or a path (others.A.starts.where). Begin here before you write a
    situation.
    """
    del desk
    from chatscene.mcp.words import explained, listed

    return explained(about.strip()) if about.strip() else listed()


def read(
    desk: Desk,
    sentence: Sentence,
    facts: Facts | None = None,
    reading: Annotated[int, Field(ge=0, le=20, description="Which offered reading is taken; 0 for the best.")] = 0,
    save_as: SaveAs | None = None,
) -> str:
    """Read a sentence into a situation: who does what, when, how fast. Runs nothing.

    The answer has the situation as YAML, which words gave no fact, and what was assumed. Check it: a sentence can be
    misread, a situation cannot. A refusal says what was not understood and what could be said.
    """
    saving = Saving(desk, save_as)
    made = cast("Stated", chatscene.explain(sentence, set=facts or None, reading=reading, **desk.reading))
    return f"{made}\n{saving.written(made)}"


def build(
    desk: Desk,
    situation: Written | None = None,
    file: SituationFile | None = None,
    facts: Facts | None = None,
    save_as: SaveAs | None = None,
    show_program: Annotated[bool, Field(description="Whether the Scenic program is part of the answer.")] = False,
) -> str:
    """Build a Scenic program of a situation. Runs nothing.

    Faults are told with their lines, and what cannot be built by its path, with what could be said. The answer says
    what was assumed. Then call verify with the program, and the situation as what was said.
    """
    saving = Saving(desk, save_as)
    made = chatscene.explain(_situation(desk, situation, file), set=facts or None)
    program = "\n".join(("", *made.shifted, made.program.source)) if show_program else ""
    return f"{made}\n{saving.written(made)}{program}"


def edit(
    desk: Desk,
    edit: Annotated[str, Field(min_length=1, max_length=2000, description="What is to be different, in words.")],
    situation: Written | None = None,
    file: SituationFile | None = None,
    save_as: SaveAs | None = None,
) -> str:
    """Change what words name in a situation, and keep the rest: "make it a truck, from the left, and faster".

    The answer is the difference. The file stays as it was; `save_as` keeps the new situation. To set one fact exactly,
    call build with `facts`.
    """
    saving = Saving(desk, save_as)
    made = chatscene.explain(_situation(desk, situation, file)).edit(edit)
    return f"{made}\n{saving.written(made)}"


def import_(
    desk: Desk,
    file: Annotated[Path, Field(description="An OpenSCENARIO XML file (.xosc); catalogs and map lie in the folder.")],
    save_as: Annotated[Path, Field(description="A new .scenic file; of several programs each has a number behind it.")],
    map: Annotated[str, Field(max_length=500, description="A packaged map, or an .xodr file.")] | None = None,  # noqa: A002
    ego: Annotated[str, Field(max_length=200, description="What the file calls the ego, if it is not told.")]
    | None = None,
    variant: Annotated[int, Field(ge=1, le=10**9, description="One set of parameter values, from 1; else all.")]
    | None = None,
    param: Given | None = None,
) -> str:
    """Turn an OpenSCENARIO XML file into a Scenic program. Nothing of it is run.

    A file of parameter values for a scenario gives a program for each set of them, a hundred at most. What cannot be
    said here is refused by its element and line.
    """
    from chatscene.maps.network import name_of

    out = desk.folder.free(save_as, ".scenic")
    desk.folder.make_above(out)
    source = desk.folder.file(file, ".xosc")
    done = chatscene.import_scenario(
        source, out=out, map=desk.folder.map(map), ego=ego, variant=variant, param=param, within=desk.folder.root
    )
    lies = [name_of(one) for one in done.maps]
    written = [f"written: {program} on map {where}" for program, where in zip(done.programs, lies, strict=True)]
    return "\n".join([*done.notes, *first_of(written), f"next: verify {done.program} on map {lies[0]}"])


def _situation(desk: Desk, text: str | None, file: str | None) -> Situation:
    """The situation that a call gives, as text or as a file."""
    from chatscene.situations.file import read_text

    if (text is None) == (file is None):
        raise SettingsError("give a situation: as text in `situation`, or as a path in `file`, and only one of them")
    return read_text(text) if text is not None else situation_in(desk, file or "")


def situation_in(desk: Desk, file: str) -> Situation:
    """The situation in a file of the folder, on a map of the folder if it names one.

    Raises:
        SettingsError: There is no such file, or its map lies elsewhere.
        SituationError: It is none.
    """
    path = desk.folder.file(file, *SITUATIONS)
    made = chatscene.read_situation(path)
    desk.folder.map(made.map or None)
    return made


class Saving:
    """Where a situation and its program are to be written, held to the folder before anything is done for them.

    Raises:
        SettingsError: Nothing can be written there.
    """

    def __init__(self, desk: Desk, save_as: str | None) -> None:
        self._folder = desk.folder
        self._paths = ()
        if save_as is not None:
            program = str(Place(save_as).with_suffix(".scenic"))
            self._paths = desk.folder.free(save_as, ".yaml", ".yml"), desk.folder.free(program, ".scenic")

    def written(self, made: Stated) -> str:
        """Write them, and say where they are.

        Raises:
            SettingsError: They cannot be written.
        """
        if not self._paths:
            return "nothing was written; save_as keeps it"
        from chatscene.situations.file import to_yaml
        from chatscene.terms.situation import Evidence

        situation, program = self._paths
        self._folder.write(situation, to_yaml(replace(made.situation, evidence=Evidence())))
        self._folder.write(program, made.program.source)
        return f"written: {situation}, {program}\nnext: verify {program} against {situation}"
