"""The folder that a library grows in: a user's own snippets, and beside them the queue of what waits for review.

::

    DIR/<component>/<name>.scenic                      the snippets …
    DIR/wordings/<component>/<name>.txt                … and other ways to say what they do
    DIR/proposed/<component>/<name>.scenic, .json      proposals, each with how it came about …
    DIR/proposed/wordings/<component>/<name>.txt       … and their wordings
    DIR/proposed/rephrasings/<component>/<name>.json   proposed wordings of a snippet
    DIR/proposed/history.jsonl                         what was proposed, accepted and rejected, a line each
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from chatscene.errors import RunError, SnippetError
from chatscene.files.bounded import parse_json
from chatscene.library.load import PACKAGED, Library, load_library, load_snippet
from chatscene.library.snippet_file import as_text, wordings_path, wordings_text
from chatscene.runs.atomic import write_bytes
from chatscene.terms.scenario import Component
from chatscene.terms.snippet import Snippet

QUEUE = "proposed"
REPHRASINGS = "rephrasings"
_ID = re.compile(rf"(?:{REPHRASINGS}/)?(?:{'|'.join(Component)})/[a-z0-9]+(?:-[a-z0-9]+)*")


@dataclass(frozen=True, slots=True)
class Shelf:
    """A user's folder of snippets."""

    folder: Path

    @property
    def queue(self) -> Path:
        """Where proposals wait."""
        return self.folder / QUEUE

    def library(self) -> Library:
        """The packaged library, and what is in the folder beside it, as the files are now.

        Raises:
            SnippetError: A file is malformed, or takes the id of a packaged snippet.
        """
        packaged, own = load_library(), self.own()
        if self.folder.resolve() == PACKAGED.resolve():
            return own
        if taken := sorted({s.id for s in own} & {s.id for s in packaged}):
            raise SnippetError(f"{self.folder}: {', '.join(taken)}: a packaged snippet has this id; rename the file")
        return Library(tuple(sorted((*packaged, *own), key=lambda s: s.id)))

    def own(self) -> Library:
        """What is in the folder, as the files are now.

        Raises:
            SnippetError: A file is malformed.
        """
        return load_library(self.folder) if _has_snippets(self.folder) else Library(())

    def with_queue(self) -> Library:
        """The library and every proposal that can be read."""
        library = self.library()
        taken, waiting = {s.id for s in library}, []
        for path in sorted(path for c in Component for path in (self.queue / c).glob("*.scenic")):
            try:
                snippet = load_snippet(path)
            except SnippetError:  # `pending` says so
                continue
            if snippet.id not in taken:
                waiting.append(snippet)
        return Library(tuple(sorted((*library, *waiting), key=lambda s: s.id)))

    def place(self, proposal_id: str) -> Path:
        """Where a proposal lies, whether or not it does; never outside of the queue.

        Raises:
            SnippetError: It is no id.
        """
        return self.queue / f"{checked_id(proposal_id)}.{'json' if is_wordings(proposal_id) else 'scenic'}"

    def proposal(self, proposal_id: str) -> Path:
        """The file of a proposal that is there.

        Raises:
            SnippetError: There is no such proposal.
        """
        path = self.place(proposal_id)
        if not path.is_file():
            waiting = ", ".join(self.ids()) or "nothing"
            raise SnippetError(f"no proposal {proposal_id!r} waits in {self.queue}; waiting: {waiting}")
        return path

    def ids(self) -> tuple[str, ...]:
        """The ids of what waits, sorted."""
        kinds = [(self.queue / c, "scenic") for c in Component]
        kinds += [(self.queue / REPHRASINGS / c, "json") for c in Component]
        found = (path for folder, ending in kinds for path in folder.glob(f"*.{ending}"))
        ids = (path.relative_to(self.queue).with_suffix("").as_posix() for path in found)
        return tuple(sorted(one for one in ids if _ID.fullmatch(one)))

    def home(self, snippet_id: str) -> Path:
        """Where a snippet of the folder lies once it is accepted.

        Raises:
            SnippetError: It is no id.
        """
        return self.folder / f"{checked_id(snippet_id)}.scenic"

    def wordings(self, snippet_id: str) -> Path:
        """Where the wordings of a snippet of the folder lie.

        Raises:
            SnippetError: It is no id.
        """
        return wordings_path(self.folder, checked_id(snippet_id))

    def queued_wordings(self, snippet_id: str) -> Path:
        """Where the wordings of a proposed snippet lie.

        Raises:
            SnippetError: It is no id.
        """
        return wordings_path(self.queue, checked_id(snippet_id))

    def queue_up(self, snippet: Snippet) -> Path:
        """Write a snippet and its wordings into the queue.

        Raises:
            SnippetError: They cannot be written.
        """
        write(self.queued_wordings(snippet.id), wordings_text(snippet.rephrasings))
        write(self.place(snippet.id), as_text(snippet))
        return self.place(snippet.id)

    def keep(self, snippet: Snippet) -> Path:
        """Write a snippet and its wordings into the folder.

        Raises:
            SnippetError: They cannot be written.
        """
        write(self.wordings(snippet.id), wordings_text(snippet.rephrasings))
        write(self.home(snippet.id), as_text(snippet))
        return self.home(snippet.id)

    def remember(self, event: Mapping[str, Any]) -> None:
        """Add a line to the history.

        Raises:
            SnippetError: It cannot be written.
        """
        line = json.dumps({"date": now(), **event}, ensure_ascii=False)
        try:
            self.queue.mkdir(parents=True, exist_ok=True)
            with self._history.open("a", encoding="utf-8") as file:
                file.write(line + "\n")
        except OSError as error:
            raise SnippetError(f"cannot write {self._history}: {error.strerror or error}") from error

    def history(self) -> Iterator[dict[str, Any]]:
        """What was remembered, oldest first; lines that are damaged are passed over."""
        try:
            lines = self._history.read_text(encoding="utf-8", errors="replace").splitlines()
        except OSError:
            return
        for line in lines:
            try:
                event = parse_json(line)
            except ValueError:
                continue
            if isinstance(event, dict):
                yield event

    @property
    def _history(self) -> Path:
        return self.queue / "history.jsonl"


def checked_id(proposal_id: str) -> str:
    """An id that can name a file of the queue and nothing else.

    Raises:
        SnippetError: It cannot.
    """
    if not _ID.fullmatch(proposal_id):
        raise SnippetError(
            f"{proposal_id!r} is not an id; an id is behavior/NAME, geometry/NAME or spawn/NAME, or one of these after "
            f"{REPHRASINGS}/, with letters a to z, digits and hyphens in NAME"
        )
    return proposal_id


def is_wordings(proposal_id: str) -> bool:
    """Whether a proposal is of wordings, not of a snippet."""
    return proposal_id.startswith(f"{REPHRASINGS}/")


def write(path: Path, text: str) -> None:
    """Write a whole file or nothing.

    Raises:
        SnippetError: The file system refuses.
    """
    try:
        write_bytes(path, text.encode())
    except RunError as error:
        raise SnippetError(f"cannot write {path}: {error.__cause__ or error}; choose another --library") from error


def write_record(path: Path, record: Mapping[str, Any]) -> None:
    """Write JSON for people."""
    write(path, json.dumps(record, indent=1, ensure_ascii=False) + "\n")


def read_record(path: Path) -> dict[str, Any]:
    """Read JSON that `write_record` wrote; empty where there is none.

    Raises:
        SnippetError: It is damaged.
    """
    if not path.is_file():
        return {}
    try:
        record = parse_json(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise SnippetError(f"{path} cannot be read ({error}); reject the proposal") from error
    if not isinstance(record, dict):
        raise SnippetError(f"{path} holds no object; reject the proposal")
    return record


def now() -> str:
    """The date, for a record."""
    return datetime.now(UTC).isoformat(timespec="seconds")


def _has_snippets(folder: Path) -> bool:
    return any(path for component in Component for path in (folder / component).glob("*.scenic"))
