"""What was understood and why, as plain JSON: the content of `explanation.json`, and what a program is made of again.

What is read back is data: it is checked against its types, and none of it is ever executed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields
from typing import Any

from pydantic import BaseModel, ConfigDict, Field, ValidationError, field_validator

from chatscene.errors import RunError
from chatscene.runs.atomic import read_json, write_bytes, write_json
from chatscene.runs.record import first_problem
from chatscene.runs.workspace import Workspace, read_record, write_program
from chatscene.search.generator import Choice, Written
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.scenario import BaseScenario, Component, Scenario, Slots, SubDescriptions
from chatscene.terms.situation import Situation
from chatscene.terms.snippet import Match, Retrieval
from chatscene.terms.surroundings import Surroundings


def explain(text: str, understood: Sequence[tuple[Scenario, Retrieval | None]]) -> dict[str, Any]:
    """The explanation of a run; `docs/run-folder.md` lists the keys."""
    return {"text": text, "scenarios": [_scenario(*pair) for pair in understood]}


def write_choice(run: Workspace, scenario: Scenario, written: Written | None = None) -> None:
    """Keep what was read and, if it came that far, what was chosen and the program it makes."""
    retrieval = written.retrieval if written else None
    record = read_record(run)
    explained = explain(record.text, [(scenario, retrieval)])
    if written:
        explained["scenarios"][0]["otherwise"] += written.left_out
    write_json(run.file("explanation.json"), explained)
    if record.situation is not None:
        write_bytes(run.file("situation.yaml"), record.situation.text.encode())
    if written:
        write_program(run, scenario.id, written.program.source)


def _scenario(scenario: Scenario, retrieval: Retrieval | None) -> dict[str, Any]:
    from chatscene.interpret.otherwise import otherwise  # who reads an explanation again reads no sentence

    if scenario.situation is not None:
        return _of_situation(scenario, scenario.situation)
    words = [one.as_dict() for one in scenario.words]
    return {
        "scenario_id": scenario.id,
        "text": scenario.text,
        "base": scenario.base.value if scenario.base else None,
        "parts": {component.value: scenario.parts[component] for component in Component},
        "slots": {name: _plain(value) for name, value in scenario.slots.said().items()},
        "surroundings": {name: value.value for name, value in scenario.surroundings.said().items()},
        "words": words,
        "otherwise": list(otherwise(scenario, retrieval, words)) if retrieval else [],
        "readings": [one.as_dict() for one in scenario.readings],
        "notes": [*map(str, scenario.notes), *(retrieval.notes if retrieval else ())],
        "unused": [
            {"said": one.said, "why": one.why.value}
            for one in (*scenario.unused, *(retrieval.unused if retrieval else ()))
        ],
    } | (_retrieval(retrieval) if retrieval else {})


def _of_situation(scenario: Scenario, situation: Situation) -> dict[str, Any]:
    """What is explained of a situation: it is told in words, and so is what became of those that it was read in."""
    from chatscene.read.quotes import words_told
    from chatscene.situations.words import told

    return {
        "scenario_id": scenario.id,
        "text": scenario.text,
        "said": situation.about,
        "told": told(situation),
        "base": scenario.base.value if scenario.base else None,
        "parts": {component.value: scenario.parts[component] for component in Component},
        "slots": {name: _plain(value) for name, value in scenario.slots.said().items()},
        "surroundings": {name: value.value for name, value in scenario.surroundings.said().items()},
        "words": [one.as_dict() for one in words_told(situation)],
        "otherwise": [],
        "readings": [],
        "notes": [],
        "unused": [],
    }


def _retrieval(retrieval: Retrieval) -> dict[str, Any]:
    chosen = {snippet.component: snippet.id for snippet in retrieval.snippets}
    return {
        "confidence": retrieval.confidence,
        "adversary": retrieval.adversary.value,
        "chosen": {component.value: chosen[component] for component in Component},
        "candidates": {
            component.value: [_match(match) for match in retrieval.candidates.get(component, ())]
            for component in Component
        },
        "ruled_out": [{"snippet_id": out.snippet_id, "reason": out.reason} for out in retrieval.ruled_out],
        "tried": [{"snippet_ids": list(one.snippet_ids), "reason": one.reason} for one in retrieval.tried],
    }


def _match(match: Match) -> dict[str, Any]:
    return {
        "snippet_id": match.snippet.id,
        "description": match.snippet.description,
        "similarity": match.similarity,
        "agreement": match.agreement,
        "score": match.score,
        "nearest": match.nearest,
        "conflicts": list(match.conflicts),
    }


def _plain(value: object) -> object:
    """A slot as JSON: enumerations are text already, tuples become lists, and others have slots of their own."""
    if isinstance(value, Slots):
        return {name: _plain(one) for name, one in value.said().items()}
    return [_plain(item) for item in value] if isinstance(value, tuple) else value


class _Told(BaseModel):
    model_config = ConfigDict(frozen=True, extra="ignore", hide_input_in_errors=True)


class _Candidate(_Told):
    snippet_id: str
    description: str
    similarity: float
    conflicts: list[str] = []


class _RuledOut(_Told):
    snippet_id: str
    reason: str


class _Tried(_Told):
    snippet_ids: list[str]
    reason: str


class _Explained(_Told):
    """One scenario of `explanation.json`; what comes with a retrieval is absent where none was reached."""

    scenario_id: str
    text: str
    base: BaseScenario | None
    parts: SubDescriptions
    slots: Slots
    surroundings: Surroundings = Surroundings()
    notes: list[str]
    confidence: float | None = None
    adversary: AdversaryKind | None = None
    chosen: dict[Component, str] = {}
    candidates: dict[Component, list[_Candidate]] = {}
    ruled_out: list[_RuledOut] = []
    tried: list[_Tried] = []

    @field_validator("slots", mode="before")
    @classmethod
    def _known(cls, value: Any) -> Any:
        known = {field.name for field in fields(Slots)}
        if isinstance(value, dict) and (unknown := [str(name) for name in value if name not in known]):
            raise ValueError(f"there is no slot {', '.join(unknown)}")
        return value


class _Explanation(_Told):
    text: str
    scenarios: list[_Explained] = Field(min_length=1)


def read_explanation(run: Workspace) -> dict[str, Any]:
    """What was understood and why; empty if the run did not come that far.

    Raises:
        RunError: It was changed or damaged.
    """
    content, _ = _read(run)
    return content


def read_choice(run: Workspace) -> tuple[Scenario, Choice | None]:
    """The scenario of a run as it was understood, and the snippets that were joined; None where none were retrieved.

    Raises:
        RunError: The run did not come that far, or its explanation was changed or damaged.
    """
    _, explanation = _read(run)
    if explanation is None:
        raise RunError(f"{run.path} has no explanation.json: nothing was made of the text yet, or the file was removed")
    told = explanation.scenarios[0]
    scenario = Scenario(
        id=told.scenario_id,
        text=told.text,
        base=told.base,
        parts=told.parts,
        slots=told.slots,
        surroundings=told.surroundings,
    )
    if not told.chosen:
        return scenario, None
    behavior, geometry, spawn = (told.chosen.get(component) for component in Component)
    if behavior is None or geometry is None or spawn is None or told.adversary is None:
        raise RunError(f"{run.file('explanation.json')} does not say what was chosen for each part; it was changed")
    return scenario, Choice(snippet_ids=(behavior, geometry, spawn), adversary=told.adversary)


def _read(run: Workspace) -> tuple[dict[str, Any], _Explanation | None]:
    """The file as it is and as its types have it; nothing if there is none."""
    path = run.file("explanation.json")
    if not path.is_file():
        return {}, None
    content = read_json(path)
    try:
        return content, _Explanation.model_validate(content)
    except ValidationError as error:
        raise RunError(
            f"{path} is not the explanation of a run: {first_problem(error)}; it was changed or damaged after it was"
            " written"
        ) from error
