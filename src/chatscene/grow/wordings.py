"""Asking a model for more ways to say what a snippet does; each is held against the library before a person sees it."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import asdict, dataclass

from pydantic import BaseModel, ConfigDict, Field

from chatscene.errors import LanguageModelError, SettingsError, SnippetError
from chatscene.grow.draft import same_words, wording_fault
from chatscene.grow.propose import Refused, spent_since
from chatscene.grow.shelf import REPHRASINGS, Shelf, is_wordings, now, read_record, write_record
from chatscene.interpret.nearest import nearest
from chatscene.library.load import Library
from chatscene.models.encoders.embedding import Embedder
from chatscene.models.language.protocol import Example, LanguageModel, Prompt, Spending
from chatscene.models.language.structured import printable
from chatscene.terms.snippet import Snippet

TOP = 3  # among so many nearest snippets must be the one that a wording is for
ROUNDS = 3  # times a model is asked, while some are missing
MOST = 40  # wordings in one reply


class Wordings(BaseModel):
    """What a model is asked for."""

    model_config = ConfigDict(extra="forbid")

    wordings: list[str] = Field(max_length=MOST)


@dataclass(frozen=True, slots=True, kw_only=True)
class Rephrased:
    """What came of asking for wordings."""

    snippet_id: str
    kept: tuple[str, ...]
    refused: tuple[Refused, ...]
    spending: Spending


SYSTEM = """You write other ways to say what a road user does, for a search in sentences that people type.
Each is one short sentence of its own, in other words than those that are there. Vary who speaks: a test engineer in
the fewest words, somebody telling a friend, a crash report in the past tense, a driver complaining. Add no fact, leave
none out. Call the car under test the ego, us or vehicle 1."""


def rephrase(model: LanguageModel, snippet_id: str, n: int, *, shelf: Shelf, embedder: Embedder) -> Rephrased:
    """Ask for wordings of a snippet that lies in the folder; what passes waits in the queue.

    Raises:
        SettingsError: None is asked for, or more than one reply holds.
        SnippetError: The folder has no such snippet, or the queue cannot be written.
    """
    if not 1 <= n <= MOST:
        raise SettingsError(f"the number of wordings must be between 1 and {MOST}, not {n}")
    library = shelf.library()
    snippet = own_snippet(shelf, library, snippet_id)
    path = shelf.place(f"{REPHRASINGS}/{snippet.id}")
    waiting = tuple(str(text) for text in read_record(path).get("wordings", ()))
    begun = model.spending
    kept: list[str] = []
    refused: dict[str, Refused] = {}
    for _ in range(ROUNDS):
        missing = n - len(kept)
        if not missing:
            break
        have = (snippet.description, *snippet.rephrasings, *waiting, *kept)
        try:
            answer = model.reply(_prompt(snippet, have, refused, missing, library), Wordings).answer
        except LanguageModelError as error:
            refused["?"] = Refused(name="?", reason="reply", message=printable(str(error), 400))
            break
        for text in (printable(one, 300) for one in answer.wordings[:MOST]):
            if len(kept) == n or text in kept:
                continue
            fault = fault_of(text, snippet, library, embedder, besides=(*waiting, *kept))
            if fault is None:
                kept.append(text)
            else:
                refused[text] = fault
    spending = spent_since(begun, model.spending)
    if kept:
        record = {"snippet": snippet.id, "model": printable(model.name, 200), "date": now()}
        write_record(path, {**record, "wordings": [*waiting, *kept], "spending": asdict(spending)})
    shelf.remember({"event": "rephrased", "id": snippet.id, "kept": len(kept), "refused": len(refused)})
    return Rephrased(snippet_id=snippet.id, kept=tuple(kept), refused=tuple(refused.values()), spending=spending)


def own_snippet(shelf: Shelf, library: Library, snippet_id: str) -> Snippet:
    """A snippet of the folder, so that its wordings can be changed there.

    Raises:
        SnippetError: It is another's.
    """
    if is_wordings(snippet_id):
        raise SnippetError(f"{snippet_id!r} is a proposal of wordings; name the snippet itself")
    snippet = library.get(snippet_id)
    if snippet.id not in {s.id for s in shelf.own()}:
        raise SnippetError(
            f"{snippet.id} is a packaged snippet; its wordings are packaged with it. To propose some, work in a copy "
            "of the source and give its folder src/chatscene/library/packaged as --library"
        )
    return snippet


def fault_of(
    text: str, snippet: Snippet, library: Library, embedder: Embedder, *, besides: Collection[str] = ()
) -> Refused | None:
    """Why a text is no new wording of a snippet; None if it is one."""
    if problem := wording_fault(text):
        return Refused(name=text[:80], reason="text", message=problem)
    for other in library.of(snippet.component):
        if any(same_words(text, there) for there in (other.description, *other.rephrasings)):
            return Refused(name=text, reason="duplicate", message=f"it is a wording of {other.id} already")
    if any(same_words(text, there) for there in besides):
        return Refused(name=text, reason="duplicate", message="it waits already")
    found = [s.id for s, _ in nearest(text, snippet.component, library, embedder, count=TOP)]
    if snippet.id not in found:
        return Refused(name=text, reason="elsewhere", message=f"it finds {', '.join(found)}")
    return None


def _prompt(
    snippet: Snippet, have: Collection[str], refused: dict[str, Refused], missing: int, library: Library
) -> Prompt:
    other = next(s for s in library.of(snippet.component) if s.id != snippet.id)
    count = min(3, len(other.rephrasings) - 1)
    shown = Example(
        _asked(other.description, other.rephrasings[count:], count),
        Wordings(wordings=list(other.rephrasings[:count])).model_dump_json(),
    )
    text = _asked(snippet.description, [t for t in have if t != snippet.description], missing)
    if refused:
        text += "\nThese cannot be used:\n" + "\n".join(
            f"- {r.name}: {r.message}" for r in list(refused.values())[-10:]
        )
    return Prompt(system=SYSTEM, examples=(shown,), text=text)


def _asked(description: str, have: Collection[str], count: int) -> str:
    there = "\n".join(f"- {text}" for text in have)
    return f"{description}\nThere are already:\n{there}\nWrite {count} more."
