"""A situation that is talked about: said in a line, answered for where it is asked back, changed line by line, run."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypedDict

from chatscene import runs
from chatscene.api import make
from chatscene.errors import EditRefused, NothingFits, SettingsError
from chatscene.runs.progress import Progress, silent

if TYPE_CHECKING:
    from chatscene.api.results import Run
    from chatscene.report.stated import Changed, Stated
    from chatscene.report.understood import Understood


@dataclass(frozen=True, slots=True)
class Shown:
    """The situation as it stands."""

    understood: Understood | Stated


@dataclass(frozen=True, slots=True)
class Undone:
    """An edit that was taken back.

    Attributes:
        edited: What had come of it; the situation is what that was `before`.
    """

    edit: str
    edited: Changed


class Talk:
    """A conversation about a situation.

    Args:
        reading: How sentences are read: options of `chatscene.explain`.
        search: How a run is searched: options of `chatscene.run`.
        folder: Where the folders of runs go that are given no name.
    """

    def __init__(self, reading: Mapping[str, Any], search: Mapping[str, Any], folder: Path) -> None:
        self._reading, self._search, self._folder = reading, search, folder
        self._text, self._answer = "", Answer()
        self._asked = self._text, self._answer  # what is answered for: the text last said, understood or not
        self._first: Understood | Stated | None = None
        self._edits: list[tuple[str, Changed]] = []

    def hear(self, line: str, progress: Progress = silent) -> Shown | Changed | Undone | Run:
        """Do what a line says: a situation or an edit of it, or one of the words that `docs/edit.md` lists.

        Args:
            line: What is said, without an end of line.
            progress: Told what is done of a run.

        Returns:
            What came of it.

        Raises:
            ChatSceneError: The line is refused; the situation is as it was.
        """
        verb, _, rest = line.partition(" ")
        text, before = self._asked
        if text and (answer := before.further(verb, rest)):
            return self._understand(text, answer, self.edits if text == self._text else [])
        if self._first is None and not text and _is_command(line, verb, rest):
            raise SettingsError(f"nothing is said yet that {verb!r} could be done with; describe a situation first")
        if self._first is None or verb == "new":
            return self._understand(rest if verb == "new" else line, Answer(), [])
        now = self._edits[-1][1] if self._edits else self._first
        if line == "undo":
            return self._undo()
        if line == "show":
            return Shown(now)
        if verb == "run" and len(rest.split()) <= 1:
            return self._run(Path(rest) if rest else self.free_folder(), progress)
        edited = now.edit(line)
        self._edits.append((line, edited))
        return edited

    @property
    def kept(self) -> Kept:
        """What another talk needs to go on from here: what stands, and what is answered for."""
        return {
            "text": self._text,
            "answer": self._answer.options(),
            "edits": self.edits,
            "asked": self._asked[0],
            "answered": self._asked[1].options(),
        }

    def go_on(self, kept: Kept) -> None:
        """Be where another talk was. Nothing is heard again: what stood is understood, and nothing else is done.

        Args:
            kept: Of the other; this one is fresh.

        Raises:
            ChatSceneError: What stood is not understood any more; the talk is fresh, but for what is answered for.
        """
        self._asked = asked = kept["asked"], Answer.of(kept["answered"])
        try:
            if kept["text"]:
                self._understand(kept["text"], Answer.of(kept["answer"]), kept["edits"])
        finally:
            self._asked = asked

    @property
    def edits(self) -> list[str]:
        """The edits that stand, in order."""
        return [edit for edit, _ in self._edits]

    def free_folder(self) -> Path:
        """Where the next run goes that is given no name: a folder called by what was said last."""
        return runs.free_folder(self._folder, self._edits[-1][0] if self._edits else self._text)

    def _understand(self, text: str, answer: Answer, edits: list[str]) -> Shown:
        try:
            first = now = make.explain(text, **self._reading, **answer.options())
        except NothingFits:
            self._asked = text, answer  # one fact may not be enough
            raise
        edited: list[tuple[str, Changed]] = []
        for edit in edits:
            now = now.edit(edit)
            edited.append((edit, now))
        self._asked = text, answer
        self._text, self._answer, self._first, self._edits = text, answer, first, edited
        return Shown(now)

    def _undo(self) -> Undone:
        if not self._edits:
            raise EditRefused("nothing to undo: this is the first text")
        return Undone(*self._edits.pop())

    def _run(self, folder: Path, progress: Progress) -> Run:
        return make.run(
            self._text,
            folder,
            edit=self.edits,
            progress=progress,
            **self._search,
            **self._reading,
            **self._answer.options(),
        )


@dataclass(frozen=True, slots=True)
class Answer:
    """What was answered to what was asked back of a text.

    Attributes:
        reading: The number of the one taken, of those that were offered; 0 for none.
    """

    reading: int = 0
    facts: tuple[tuple[str, str], ...] = ()

    @classmethod
    def of(cls, options: Answered) -> Answer:
        """That of such options."""
        return cls(options["reading"], tuple(options["set"].items()))

    def further(self, verb: str, rest: str) -> Answer | None:
        """The same with what a line answers; None if it answers nothing."""
        if verb == "reading" and rest.isdecimal():
            return replace(self, reading=int(rest))
        name, equals, value = rest.partition("=")
        if verb == "set" and equals:
            return replace(self, facts=(*self.facts, (name.strip(), value.strip())))
        return None

    def options(self) -> Answered:
        """The same as options of `chatscene.explain` and `chatscene.run`."""
        return {"reading": self.reading, "set": dict(self.facts)}


def _is_command(line: str, verb: str, rest: str) -> bool:
    """Whether a line is one of the words that need something said before, and no situation."""
    run = verb == "run" and len(rest.split()) <= 1
    return line in ("undo", "show") or run or Answer().further(verb, rest) is not None


class Kept(TypedDict):
    """Where a talk stands, in words of JSON.

    Attributes:
        text: What was said first and understood; empty if nothing was.
        asked: What was said last, understood or not: what is answered for.
    """

    text: str
    answer: Answered
    edits: list[str]
    asked: str
    answered: Answered


class Answered(TypedDict):
    """An answer, as options of `chatscene.explain` and `chatscene.run`."""

    reading: int
    set: dict[str, str]
