"""What was understood and why, as plain JSON: the content of `explanation.json`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from chatscene.terms.scenario import Component, Scenario
from chatscene.terms.snippet import Match, Retrieval


def explain(text: str, understood: Sequence[tuple[Scenario, Retrieval | None]]) -> dict[str, Any]:
    """The explanation of a run; `docs/run-folder.md` lists the keys.

    Args:
        text: What the user wrote.
        understood: Each scenario with what was retrieved for it, or None where retrieval was not reached.
    """
    return {"text": text, "scenarios": [_scenario(*pair) for pair in understood]}


def _scenario(scenario: Scenario, retrieval: Retrieval | None) -> dict[str, Any]:
    return {
        "scenario_id": scenario.id,
        "text": scenario.text,
        "base": scenario.base.value if scenario.base else None,
        "parts": {component.value: scenario.parts[component] for component in Component},
        "slots": {name: _plain(value) for name, value in scenario.slots.said().items()},
        "notes": [*scenario.notes, *(retrieval.notes if retrieval else ())],
        "unused": [
            {"said": one.said, "why": one.why.value}
            for one in (*scenario.unused, *(retrieval.unused if retrieval else ()))
        ],
    } | (_retrieval(retrieval) if retrieval else {})


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
    """A slot as JSON: enumerations are text already, tuples become lists."""
    return [str(item) for item in value] if isinstance(value, tuple) else value
