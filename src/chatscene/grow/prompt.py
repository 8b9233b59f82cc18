"""The question a model is asked for a new snippet: what there is to build with, and a few snippets as examples."""

from __future__ import annotations

import inspect
import re
from collections.abc import Sequence
from functools import lru_cache
from importlib.resources import files

from chatscene.grow.draft import Draft, DraftParameter, DraftSlots
from chatscene.grow.lint import partner_names
from chatscene.grow.trying import partners_for
from chatscene.library.compatibility import compatibility
from chatscene.library.load import Library
from chatscene.library.snippet_file import ADVERSARY_CLASS
from chatscene.models.language.protocol import Example
from chatscene.sentences.describe import varied
from chatscene.simulate.confined.words import world_words
from chatscene.terms.nouns import with_article
from chatscene.terms.scenario import BaseScenario, Component
from chatscene.terms.snippet import Snippet
from chatscene.world import places

SHOTS = 3
SHORT = 600  # characters of code
SHOT_REPHRASINGS = 5
MOST_NAMES = 150  # of what there is already
MOST_TRIED = 30  # of what was proposed and not wanted

PARTNERS: dict[str, str] = {
    "AdvAgent": "the adversary",
    "AdvBehavior": "what the adversary does",
    ADVERSARY_CLASS: "the class of the adversary",
    "LeadingAgent": "a slow vehicle ahead of the ego",
    "adjacentLane": "a lane of the ego's direction beside its own, a line",
    "advFacing": "how far a walker who comes toward the ego faces away from its direction [rad]",
    "advKerb": "the way of an adversary that starts at the edge of the road, a line",
    "advLane": "the way of an adversary in a lane beside the ego's, a line",
    "advMeeting": "where the ways meet: arc length [m] on advTrajectory",
    "advTrajectory": "the way that the adversary drives, a line",
    "advTurn": 'what the adversary does at a junction: "straight", "left-turn" or "right-turn"; where '
    "its sentence says none of them, a tuple of those that will do, best first",
    "blockedLane": "the lane that something parked stands in, a line",
    "crossSignal": "the light of those who cross the ego's way",
    "egoMeeting": "where the ways meet: arc length [m] on egoRoute",
    "egoRoute": "the ego's way; egoRoute.eventAt is where its manoeuvre begins [m]",
    "egoSpawnPt": "where the ego starts",
    "junctionExit": "where the ego leaves the junction: arc length [m] on egoRoute",
    "kerbLane": "the lane at the edge of the road, a line",
    "leftLane": "the lane left of the ego's, a line",
    "oncomingTraffic": "the ways of those who come toward the ego at a junction",
    "oppositeLane": "the oncoming lane, a line in its own driving order",
    "rightLane": "the lane right of the ego's, a line",
    "trafficFromLeft": "the ways of those who come from the left at a junction",
    "trafficFromRight": "the ways of those who come from the right at a junction",
}
"""The names by which the parts of a program meet (decision 0009)."""

_ROLE = {
    Component.BEHAVIOR: "what the adversary does; defines `behavior AdvBehavior():`",
    Component.GEOMETRY: "the ego's way; defines egoRoute (with selectRoute) and egoSpawnPt = startOf(egoRoute)",
    Component.SPAWN: f"where the adversary starts and what is there; defines AdvAgent = new {ADVERSARY_CLASS} …",
}
_BEHAVIOR = re.compile(r'^behavior (\w+\([^)]*\)):\n\s+"""(.+?)"""', re.MULTILINE | re.DOTALL)


def system(component: Component, base: BaseScenario, library: Library) -> str:
    """What a model is told about its task and about the language."""
    unused: set[str] = set() if component is Component.SPAWN else {ADVERSARY_CLASS}
    given = sorted(partner_names(component, _serving(base, library)) - unused)
    return f"""You write parts of test scenarios for automated driving, in Scenic 3, as one JSON object each.
A program is joined from three parts: a geometry (the ego's way), a spawn (where the adversary starts) and a behavior
(what the adversary does). The ego is the car under test, the adversary the one road user who endangers it.
You write one {component}: {_ROLE[component]}.

Units are metres, seconds, radians. Every number worth tuning is a parameter with a range that a person would call
possible, declared as `param OPT_NAME = Range(low, high)` and read as `globalParameters.OPT_NAME`; there is no other
randomness. Names of a spawn's parameters begin with OPT_GEO_, OPT_BLOCKER_ or OPT_LEAD_, those of a behavior do not.
The code has no model statement, no import, def, class, lambda, comprehension, try/except or backslash, and a loop in a
behavior takes an action or waits in every turn. Do not write `ego = ...`.

The other parts define these names:
{_listed({name: PARTNERS.get(name, "") for name in given})}
The world model defines:
{vocabulary()}

name: two to five words. description: one sentence. rephrasings: five or more other ways to say it, as different
people would. adversaries: the kinds of road user it works for. slots: only what its drives will show; it is checked
on simulated tracks. parameters: the unit and meaning of each OPT_ parameter."""


def question(component: Component, base: BaseScenario, have: Sequence[str], tried: Sequence[str]) -> str:
    """The question itself."""
    lines = [f"Write a new {component} for the base scenario {base}. It does what none of these does:"]
    lines.append(", ".join(have[:MOST_NAMES]))
    if tried:
        lines.append("These were proposed before and could not be used; write another one:")
        lines += [f"- {one}" for one in tried[-MOST_TRIED:]]
    return "\n".join(lines)


def shots(component: Component, base: BaseScenario, library: Library) -> tuple[Example, ...]:
    """Snippets of the component that serve the base scenario, a varied choice of short ones."""
    axis = list(Component).index(component)
    several = dict.fromkeys(one[axis].id for one in varied(base, 4 * SHOTS, library=library, seed=0))
    compact = sorted((library.get(one) for one in several), key=lambda s: len(s.source) > SHORT)
    return tuple(
        Example(f"Write {with_article(component)} for the base scenario {base}.", draft_of(s)) for s in compact[:SHOTS]
    )


def existing(component: Component, base: BaseScenario, library: Library) -> tuple[str, ...]:
    """Names of the snippets of a component that can be joined to something of a base scenario."""
    return tuple(s.id.partition("/")[2] for s in _serving(base, library).of(component))


def _serving(base: BaseScenario, library: Library) -> Library:
    """The snippets that are in some program of a base scenario."""
    joint = compatibility(partners_for(library, base))
    found: list[Snippet] = []
    for axis, parts in enumerate((joint.behaviors, joint.geometries, joint.spawns)):
        fits = {int(i) for i in joint.mask.nonzero()[axis]}
        found += [parts[i] for i in sorted(fits)]
    return Library(tuple(sorted(found, key=lambda s: s.id)))


def draft_of(snippet: Snippet) -> str:
    """A snippet as the reply that would have proposed it, without what it leaves open."""
    slots = {name: value for name, value in snippet.slots.said().items() if name != "adversary"}
    draft = Draft(
        name=snippet.id.partition("/")[2].replace("-", " "),
        description=snippet.description,
        rephrasings=list(snippet.rephrasings[:SHOT_REPHRASINGS]),
        adversaries=list(snippet.adversaries),
        slots=DraftSlots.model_validate(slots),
        parameters=[
            DraftParameter.model_validate({"name": p.name, "unit": p.unit, "meaning": p.meaning})
            for p in snippet.parameters
        ],
        code=snippet.source.strip(),
    )
    return draft.model_dump_json(exclude_unset=True)


@lru_cache(maxsize=1)
def vocabulary() -> str:
    """What a part may call, with what it takes and does; read from the world model itself."""
    known = world_words()
    text = files("chatscene.world").joinpath("behaviors.scenic").read_text(encoding="utf-8")
    found = {signature: " ".join(says.split()) for signature, says in _BEHAVIOR.findall(text)}
    for name, function in inspect.getmembers(places, inspect.isfunction):
        if name in known:
            takes = inspect.signature(function).replace(return_annotation=inspect.Signature.empty)
            bare = [p.replace(annotation=inspect.Parameter.empty) for p in takes.parameters.values()]
            says = (function.__doc__ or "").partition("\n")[0]
            found[f"{name}{takes.replace(parameters=bare)}"] = says
    things = sorted(name for name in known if name[0].isupper() and not any(s.startswith(f"{name}(") for s in found))
    return f"{_listed(found)}\n- selectRoute, startOf: as in the examples\n- things: {', '.join(things)}"


def _listed(named: dict[str, str]) -> str:
    return "\n".join(f"- {name}: {says}".rstrip(": ") for name, says in named.items())
