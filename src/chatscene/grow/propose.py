"""Asking a model for snippets, one after another; what passes every check waits for a person."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import asdict, dataclass, field, fields
from pathlib import Path
from typing import Any

from chatscene.errors import LanguageModelError, SettingsError, SnippetError
from chatscene.grow.draft import Draft, slug, snippet_of
from chatscene.grow.lint import Finding
from chatscene.grow.prompt import existing, question, shots, system
from chatscene.grow.shelf import Shelf, now, write_record
from chatscene.grow.trying import Judge
from chatscene.models.language.protocol import Example, LanguageModel, Prompt, Spending
from chatscene.models.language.structured import printable
from chatscene.terms.scenario import BaseScenario, Component
from chatscene.terms.snippet import Snippet

REPAIRS = 2
SILENCE = 3  # proposals in a row without a usable reply, after which a model is not asked any more
SHOWN = 5  # faults that a model is told at a time
LONGEST_FAULT = 400  # characters
Progress = Callable[[str, int, int], None]


@dataclass(frozen=True, slots=True, kw_only=True)
class Kept:
    """A proposal that passed and waits."""

    id: str
    path: Path
    attempts: int


@dataclass(frozen=True, slots=True, kw_only=True)
class Refused:
    """A proposal that did not pass; counted and shown, never dropped.

    Attributes:
        reason: The rung it failed, such as ``allow-list``, ``means`` or ``distinct``; ``reply`` if there was none.
    """

    name: str
    reason: str
    message: str
    attempts: int = 1


@dataclass(frozen=True, slots=True, kw_only=True)
class Summary:
    """What came of asking."""

    kept: tuple[Kept, ...]
    refused: tuple[Refused, ...]
    spending: Spending

    @property
    def reasons(self) -> dict[str, int]:
        """How many were refused for each reason, most frequent first."""
        return dict(Counter(one.reason for one in self.refused).most_common())


@dataclass(slots=True)
class _Try:
    """One proposal on its way."""

    name: str = ""
    drafts: int = 0
    faults: list[list[str]] = field(default_factory=list[list[str]])
    last: tuple[Finding, ...] = ()


def propose(
    model: LanguageModel,
    component: Component,
    base: BaseScenario,
    n: int,
    *,
    shelf: Shelf,
    judge: Judge,
    progress: Progress,
) -> Summary:
    """Ask for snippets that the library has not.

    Raises:
        SettingsError: None is asked for.
        SnippetError: The queue cannot be written.
    """
    if n < 1:
        raise SettingsError(f"the number of proposals must be at least 1, not {n}")
    begun, silent = model.spending, 0
    kept: list[Kept] = []
    refused: list[Refused] = []
    packaged = judge.library
    instructions, examples = system(component, base, packaged), shots(component, base, packaged)
    for number in range(n):
        before, tried = model.spending, _Try()
        have = existing(component, base, judge.library)
        prompt = Prompt(
            system=instructions, examples=examples, text=question(component, base, have, _unwanted(shelf, component))
        )
        try:
            snippet = _mended(model, prompt, component, base, judge, tried)
            silent = 0
        except LanguageModelError as error:
            tried.last, snippet = (Finding("", "reply", str(error)),), None
            silent += 1
        record = _record(model, tried, component, base, spent_since(before, model.spending))
        if snippet is None:
            refused.append(_refused(tried))
            shelf.remember({"event": "refused", "reason": refused[-1].reason, **record})
        else:
            kept.append(Kept(id=snippet.id, path=shelf.queue_up(snippet), attempts=tried.drafts))
            write_record(kept[-1].path.with_suffix(".json"), {"id": snippet.id, "date": now(), **record})
            shelf.remember({"event": "proposed", "id": snippet.id, **record})
            judge.learn(snippet)
        progress("proposals", number + 1, n)
        if silent == SILENCE:
            break
    return Summary(kept=tuple(kept), refused=tuple(refused), spending=spent_since(begun, model.spending))


def _mended(
    model: LanguageModel, prompt: Prompt, component: Component, base: BaseScenario, judge: Judge, tried: _Try
) -> Snippet | None:
    """A snippet that passes, after at most `REPAIRS` drafts that did not; None if none does."""
    earlier: Draft | None = None
    for _ in range(1 + REPAIRS):
        draft = model.reply(prompt, Draft).answer
        if draft == earlier:
            return None
        tried.drafts += 1
        made = _judged(draft, component, base, judge, model.name, tried)
        if isinstance(made, Snippet):
            return made
        said = [printable(f"{f.rung}: {f.message}", LONGEST_FAULT) for f in made[:SHOWN]]
        tried.faults.append(said)
        tried.last, earlier = made, draft
        again = "It cannot be used. Mend it, and reply with the whole object.\n" + "\n".join(f"- {one}" for one in said)
        shown = (*prompt.examples, Example(prompt.text, draft.model_dump_json()))
        prompt = Prompt(system=prompt.system, examples=shown, text=again)
    return None


def _judged(
    draft: Draft, component: Component, base: BaseScenario, judge: Judge, model: str, tried: _Try
) -> Snippet | tuple[Finding, ...]:
    tried.name = printable(draft.name, 80)
    try:
        name = slug(draft.name, [s.id.partition("/")[2] for s in judge.library.of(component)])
    except SnippetError as error:
        return (Finding(f"{component}/?", "name", str(error)),)
    origin = printable(f"proposed by the language model {model} for the base scenario {base}", 200)
    made = snippet_of(draft, f"{component}/{name}", component, judge.library, origin=origin)
    if not isinstance(made, Snippet):
        return made
    return judge.faults(made, base) or made


def _refused(tried: _Try) -> Refused:
    last = tried.last[0]
    return Refused(
        name=tried.name or "?",
        reason=last.rung,
        message=printable(last.message, LONGEST_FAULT),
        attempts=tried.drafts,
    )


def _record(
    model: LanguageModel, tried: _Try, component: Component, base: BaseScenario, spending: Spending
) -> dict[str, Any]:
    """How a proposal came about, for the file beside it and for the history."""
    return {
        "name": tried.name,
        "component": component.value,
        "base": base.value,
        "model": printable(model.name, 200),
        "drafts": tried.drafts,
        "diagnostics": tried.faults,
        "spending": asdict(spending),
    }


def _unwanted(shelf: Shelf, component: Component) -> list[str]:
    """What was refused or rejected before, so that it is not proposed again, with the reason."""
    found: list[str] = []
    for event in shelf.history():
        unwanted = event.get("event") in ("refused", "rejected") and event.get("component") == component
        if unwanted and event.get("name"):
            found.append(printable(f"{event['name']}: {event.get('why') or event.get('reason')}", 160))
    return found


def spent_since(before: Spending, after: Spending) -> Spending:
    """The difference of two states of a model's spending."""
    known = after.dollars is not None and before.dollars is not None
    counted = {
        f.name: getattr(after, f.name) - getattr(before, f.name) for f in fields(Spending) if f.name != "dollars"
    }
    return Spending(**counted, dollars=(after.dollars or 0.0) - (before.dollars or 0.0) if known else None)
