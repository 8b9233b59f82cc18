"""What a person does with the queue: look, accept, reject, edit. Accepting makes a proposal the person's own code."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from chatscene.errors import SnippetError
from chatscene.grow.draft import code_faults
from chatscene.grow.lint import Finding
from chatscene.grow.shelf import (
    REPHRASINGS,
    Shelf,
    checked_id,
    is_wordings,
    read_record,
    write,
    write_record,
)
from chatscene.grow.trying import Judge
from chatscene.grow.wordings import fault_of, own_snippet
from chatscene.library.load import Library, load_snippet
from chatscene.library.snippet_file import wordings_text
from chatscene.models.encoders.embedding import Embedder
from chatscene.models.language.structured import printable
from chatscene.terms.plan import Foreign
from chatscene.terms.plan_text import plan_of
from chatscene.terms.scenario import BaseScenario, Component
from chatscene.terms.snippet import Snippet

MakeJudge = Callable[[Library], Judge]


@dataclass(frozen=True, slots=True, kw_only=True)
class Pending:
    """A proposal that waits for a person.

    Attributes:
        fault: Why it cannot be accepted as it is, as far as that can be seen without driving; empty if it can.
    """

    id: str
    path: Path
    says: str
    model: str
    date: str
    fault: str = ""


def pending(shelf: Shelf) -> tuple[Pending, ...]:
    """Everything that waits, sorted by id; nothing of it is run."""
    library = shelf.library()
    return tuple(_pending(shelf, library, one) for one in shelf.ids())


def accept(shelf: Shelf, proposal_id: str, *, make_judge: MakeJudge, embedder: Callable[[], Embedder]) -> Path:
    """Check a proposal again, behind both walls, and move it into the library.

    Returns:
        The file of the snippet, or of its wordings.

    Raises:
        SnippetError: There is no such proposal, it does not pass, or the folder cannot be written.
    """
    shelf.proposal(proposal_id)
    if is_wordings(proposal_id):
        snippet = _with_wordings(shelf, proposal_id, embedder())
        home = shelf.wordings(snippet.id)
        write(home, wordings_text(snippet.rephrasings))
    else:
        home = shelf.keep(_checked(shelf, proposal_id, make_judge))
    _forget(shelf, proposal_id)
    shelf.remember({"event": "accepted", "id": proposal_id})
    return home


def reject(shelf: Shelf, proposal_id: str, why: str) -> None:
    """Remove a proposal; the reason is remembered, and told to models that are asked for more.

    Raises:
        SnippetError: There is no such proposal, or it cannot be removed.
    """
    shelf.proposal(proposal_id)
    component, _, name = proposal_id.removeprefix(f"{REPHRASINGS}/").partition("/")
    kind = REPHRASINGS if is_wordings(proposal_id) else component
    shelf.remember({
        "event": "rejected", "id": proposal_id, "name": name.replace("-", " "), "component": kind,
        "why": printable(why, 200),
    })  # fmt: skip
    _forget(shelf, proposal_id)


def text_of(shelf: Shelf, proposal_id: str) -> str:
    """What a person edits: the file of a snippet, or wordings, one a line.

    Raises:
        SnippetError: There is no such proposal, or it is damaged.
    """
    path = shelf.proposal(proposal_id)
    if is_wordings(proposal_id):
        return "".join(f"{text}\n" for text in _wordings(path))
    try:
        return path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise SnippetError(f"{path} cannot be read: {error}") from error


def edit(
    shelf: Shelf, proposal_id: str, text: str, *, make_judge: MakeJudge, embedder: Callable[[], Embedder]
) -> tuple[Finding, ...]:
    """Put an edited text in a proposal's place, and check it again; it stays in the queue, faulty or not.

    Raises:
        SnippetError: There is no such proposal, or it cannot be written.
    """
    path = shelf.proposal(proposal_id)
    if is_wordings(proposal_id):
        lines = [line.strip() for line in text.splitlines()]
        write_record(path, {**read_record(path), "wordings": [line for line in lines if line]})
        check: Callable[[], object] = lambda: _with_wordings(shelf, proposal_id, embedder())  # noqa: E731
    else:
        write(path, text)
        check = lambda: _checked(shelf, proposal_id, make_judge)  # noqa: E731
    shelf.remember({"event": "edited", "id": proposal_id})
    try:
        check()
    except SnippetError as error:
        return (Finding(proposal_id, "check", str(error)),)
    return ()


def _pending(shelf: Shelf, library: Library, proposal_id: str) -> Pending:
    path = shelf.place(proposal_id)
    says, model, date, fault = "", "", "", ""
    try:
        record = read_record(path.with_suffix(".json"))
        model, date = str(record.get("model", "")), str(record.get("date", ""))
        if is_wordings(proposal_id):
            wordings = _wordings(path)
            says = f"{len(wordings)} wordings, such as {wordings[0]!r}" if wordings else "no wordings"
        else:
            snippet = load_snippet(path)
            plan = plan_of(snippet)
            says = snippet.description
            if isinstance(plan, Foreign) and snippet.component is Component.BEHAVIOR:
                says += f" (no plan: {plan.reason})"
            fault = "; ".join(f"{f.rung}: {f.message}" for f in code_faults(snippet, library)[:3])
    except SnippetError as error:
        fault = str(error)
    return Pending(
        id=proposal_id,
        path=path,
        says=printable(says, 200),
        model=printable(model, 80),
        date=printable(date, 40),
        fault=printable(fault, 400),
    )


def _checked(shelf: Shelf, proposal_id: str, make_judge: MakeJudge) -> Snippet:
    """A proposed snippet, if it passes; what is written is what was checked, not the file as it is then."""
    path = shelf.proposal(proposal_id)
    library = shelf.library()
    if shelf.home(proposal_id).exists() or proposal_id in {s.id for s in library}:
        raise SnippetError(
            f"the library has a snippet {proposal_id} already; rename {path} and its .json, or reject it"
        )
    snippet = load_snippet(path)
    base = str(read_record(path.with_suffix(".json")).get("base", ""))
    faults = code_faults(snippet, library) or make_judge(library).faults(
        snippet, BaseScenario(base) if base in BaseScenario.__members__.values() else None
    )
    if faults:
        said = "; ".join(printable(f"{f.rung}: {f.message}", 400) for f in faults[:5])
        raise SnippetError(f"{proposal_id} cannot be accepted: {said}. Mend it: chatscene library edit {proposal_id}")
    return snippet


def _with_wordings(shelf: Shelf, proposal_id: str, embedder: Embedder) -> Snippet:
    """The snippet that wordings are for, with them, if all of them pass."""
    library = shelf.library()
    snippet = own_snippet(shelf, library, checked_id(proposal_id).removeprefix(f"{REPHRASINGS}/"))
    wordings = _wordings(shelf.proposal(proposal_id))
    for i, text in enumerate(wordings):
        if fault := fault_of(text, snippet, library, embedder, besides=wordings[:i]):
            raise SnippetError(
                f"{printable(text, 80)!r}: {printable(fault.message, 300)}. "
                f"Take it out: chatscene library edit {proposal_id}"
            )
    return replace(snippet, rephrasings=(*snippet.rephrasings, *wordings))


def _wordings(path: Path) -> list[str]:
    found = read_record(path).get("wordings", [])
    if not isinstance(found, list) or not all(isinstance(text, str) for text in found):
        raise SnippetError(f"{path} holds no list of wordings; reject the proposal")
    return found


def _forget(shelf: Shelf, proposal_id: str) -> None:
    path = shelf.place(proposal_id)
    beside = (path.with_suffix(".json"), *(() if is_wordings(proposal_id) else (shelf.queued_wordings(proposal_id),)))
    try:
        for one in (path, *beside):
            one.unlink(missing_ok=True)
    except OSError as error:
        raise SnippetError(f"{path} cannot be removed: {error.strerror or error}") from error
