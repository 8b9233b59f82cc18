"""What came of a line of a talk, as a page shows it: words and lists of them, no markup."""

from __future__ import annotations

import difflib
import re
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any

from chatscene.api.results import Run
from chatscene.errors import ChatSceneError, MeansSomethingElse, NothingFits, SettingsError
from chatscene.report.accounting import parts_of
from chatscene.report.refused import refusal
from chatscene.report.stated import Changed, Stated, lines_changed
from chatscene.report.understood import Understood
from chatscene.runs.progress import Progress
from chatscene.situations.facts import said_in
from chatscene.talk import Shown, Talk, Undone
from chatscene.terms.scenario import grouped

Turn = dict[str, Any]


def turn_of(talk: Talk, line: str, progress: Progress, embedder: str) -> Turn:
    """Have a talk hear a line, and say what came of it."""
    try:
        if re.match(r"run\s+\S+$", line):
            raise SettingsError("a run of this page has a folder of its own below the page's; say run alone")
        heard = talk.hear(line, progress)
    except (NothingFits, MeansSomethingElse) as error:
        text = (error.text if isinstance(error, NothingFits) else "") or line.removeprefix("new ")
        told = refusal(error, text, embedder)
        return {"kind": "refused", **told, "parts": _parts(text, told["words"])}
    except ChatSceneError as error:
        return {"kind": "failed", "failed": type(error).__name__, "message": str(error)}
    match heard:
        case Shown():
            return {"kind": "shown", "edits": talk.edits, **_understood(heard.understood)}
        case Undone():
            return {"kind": "undone", "edits": talk.edits, "edit": heard.edit, **_changed(heard.edited, back=True)}
        case Run():
            return {"kind": "ran", **_ran(heard)}
        case Changed():
            return {"kind": "edited", "edits": talk.edits, **_changed(heard)}


def _understood(understood: Understood | Stated) -> Turn:
    return _stated(understood) if isinstance(understood, Stated) else _retrieved(understood)


def _stated(stated: Stated) -> Turn:
    told = stated.as_dict()
    return {
        "told": stated.told,
        "parts": _parts(stated.situation.about, told["words"]),
        "facts": [[path, _said(value)] for path, value in said_in(stated.situation)],
        "notes": _notes(stated),
        "readings": [one.as_dict() for one in stated.readings],
        "confidence": None,
        "snippets": [],
        "program": told["program"],
    }


def _notes(stated: Stated) -> list[str]:
    return [*stated.told_first, *stated.shifted]


def _retrieved(understood: Understood) -> Turn:
    told = understood.as_dict()
    (scenario,) = told["scenarios"]
    candidates = scenario.get("candidates", {})
    return {
        "told": understood.told,
        "parts": _parts(scenario["text"], scenario["words"]),
        "facts": [[name.replace("_", " "), _said(value)] for name, value in _facts(scenario).items()],
        "notes": [*scenario["notes"], *(f"not used: {one}" for one in grouped(_unused(understood)).values())],
        "readings": scenario["readings"],
        "confidence": scenario.get("confidence"),
        "snippets": [
            [component, name, *(one["description"] for one in candidates[component] if one["snippet_id"] == name)]
            for component, name in scenario.get("chosen", {}).items()
        ],
        "program": told["program"],
    }


def _changed(edited: Changed, *, back: bool = False) -> Turn:
    """What an edit changes, or, of one that is taken back, what changes then."""
    before, after = (edited, edited.before) if back else (edited.before, edited)
    changes = edited.as_dict()["changes"]
    if back:
        changes = [{**one, "before": one["after"], "after": one["before"]} for one in changes]
    return {
        "told": after.told,
        "sentence": between(before.told, after.told),
        "changes": changes,
        "difference": list(lines_changed(before.program.source, after.program.source)),
        "notes": [] if back else [one for one in _notes(after) if one not in _notes(before)],
        "program": after.program.source,
    }


def between(before: str, after: str) -> list[dict[str, str]]:
    """Two texts as one, word by word, in parts: in both (``same``), the first (``gone``), the second (``new``)."""
    first, second = before.split(), after.split()
    parts: list[dict[str, str]] = []
    for tag, a, b, c, d in difflib.SequenceMatcher(None, first, second, autojunk=False).get_opcodes():
        for words, how in ((first[a:b], "same" if tag == "equal" else "gone"), (second[c:d], "new")):
            if words and not (how == "new" and tag == "equal"):
                parts.append({"how": how, "text": " ".join(words)})
    return parts


def _ran(run: Run) -> Turn:
    return {
        "run": run.folder.name,
        "summary": [*run.told_first, *run.summary.in_words().splitlines()],
        "counts": dict(run.summary.counts),
    }


def _parts(text: str, words: Sequence[Mapping[str, Any]]) -> list[dict[str, Any]]:
    return [asdict(one) | {"unread": one.unread} for one in parts_of(text, words)] if words else []


def _facts(scenario: Mapping[str, Any]) -> dict[str, Any]:
    return {**scenario["slots"], **scenario["surroundings"]}


def _said(value: object) -> str:
    if isinstance(value, list):
        return ", ".join(_said(one) for one in value)  # type: ignore[reportUnknownVariableType]
    if isinstance(value, dict):
        return " ".join(_said(one) for one in value.values())  # type: ignore[reportUnknownVariableType]
    return {True: "yes", False: "no"}[value] if isinstance(value, bool) else str(value)


def _unused(understood: Understood) -> tuple[Any, ...]:
    return (*understood.scenario.unused, *(understood.retrieval.unused if understood.retrieval else ()))
