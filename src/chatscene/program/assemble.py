"""Step 4 of 9: join a triple of snippets into a Scenic program.

Paper: section 3.3, step iii. The reference joins text and hopes; here the parts' contracts are checked first.
"""

from __future__ import annotations

import textwrap
from dataclasses import asdict, replace

from chatscene.errors import NamesNotClosed
from chatscene.program.orders import ORDERS
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.scenario import AT_REST, EgoState, Position, Scenario
from chatscene.terms.scene import ScenicProgram
from chatscene.terms.snippet import Snippet

HEADER_PROVIDES = ("AdvClass", "ego")


def assemble(scenario: Scenario, triple: tuple[Snippet, Snippet, Snippet], adversary: AdversaryKind) -> ScenicProgram:
    """Join three snippets.

    Args:
        scenario: What the program expresses; its text becomes a comment.
        triple: The behavior, which defines `AdvBehavior`; the geometry, which defines `egoRoute`, `egoSpawnPt` and
            what else the place offers; the spawn, which places `AdvAgent` and whatever stands beside it.
        adversary: The class of the adversary.

    Returns:
        A program that `scenic` compiles as it stands.

    Raises:
        NamesNotClosed: A part needs a name that no other part provides.
    """
    behavior, geometry, spawn = triple
    provided = {name for part in triple for name in part.provides} | set(HEADER_PROVIDES)
    for part in triple:
        missing = sorted(set(part.requires) - provided)
        if missing:
            joined = ", ".join(p.id for p in triple)
            raise NamesNotClosed(f"snippet {part.id!r} needs {', '.join(missing)}, which none of {joined} provides")
    around = scenario.surroundings
    conditions = ", ".join(f"{name} = '{value}'" for name, value in asdict(around).items())
    conditions = f"param {conditions}\n" if str(around) else ""
    said = "\n".join(textwrap.wrap(" ".join(scenario.text.split()), 100, initial_indent="# ", subsequent_indent="# "))
    state = scenario.slots.ego
    start = "param egoStart = 'at-line'\n\n" if _waits_at_line(state, spawn) else ""
    orders = "" if state is None else f", with orders ({ORDERS[state].source},)"
    source = "\n\n".join(
        (
            said,
            f"model chatscene.world.model\n{conditions}\n{start}AdvClass = {adversary.row.scenic}",
            f"## {behavior.id}\n{behavior.source.strip()}",
            f"## {geometry.id}\n{_lit(geometry, behavior, state).source.strip()}",
            f"ego = new Car at egoSpawnPt, facing directionOn(egoRoute, 0), with route egoRoute{orders}",
            f"## {spawn.id}\n{spawn.source.strip()}\n",
        )
    )
    return ScenicProgram(
        scenario_id=scenario.id,
        source=source,
        parameters=tuple(sorted((p for part in triple for p in part.parameters), key=lambda p: p.name)),
        snippet_ids=tuple(part.id for part in triple),
    )


def _waits_at_line(state: EgoState | None, spawn: Snippet) -> bool:
    """Whether the ego begins right before its junction, if there is one: it stands, and nobody is between."""
    return state in AT_REST and spawn.slots.position is not Position.AHEAD


def _lit(geometry: Snippet, behavior: Snippet, state: EgoState | None) -> Snippet:
    """A geometry whose light is red for an ego that stands or stops there, unless the adversary has that red itself."""
    if state not in (EgoState.STANDS, EgoState.STOPS) or "crossSignal" in behavior.requires:
        return geometry
    source = geometry.source.replace("param signals = 'ego-green'", "param signals = 'ego-red'")
    return replace(geometry, source=source.replace('crossSignal = "red"', 'crossSignal = "green"'))
