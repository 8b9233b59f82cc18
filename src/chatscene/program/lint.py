"""Does every snippet keep its word? The rungs of the validation ladder, for the parts instead of a program.

A snippet is tried in programs with partners that fit it, chosen in a fixed order so that few programs cover the
whole library: every behavior with every kind of adversary it names, every geometry, every spawn position.
"""

from __future__ import annotations

import builtins
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import product

import numpy as np

from chatscene.ego.policy import EgoPolicy
from chatscene.errors import ChatSceneError, SnippetError
from chatscene.maps.network import resolve_map
from chatscene.program.assemble import assemble
from chatscene.program.check import probe_scenes
from chatscene.program.meaning import check_meaning
from chatscene.simulate.backend import Backend
from chatscene.snippets.compatibility import incompatibility
from chatscene.snippets.library import Library, names_of
from chatscene.terms.episode import Episode, Role, Track
from chatscene.terms.limits import LIMITS
from chatscene.terms.scenario import AdversaryKind, Component, Scenario, Slots, SubDescriptions
from chatscene.terms.scene import Rejected, ScenicProgram
from chatscene.terms.snippet import Snippet
from chatscene.world.compilation import compile_program

Triple = tuple[Snippet, Snippet, Snippet]

PROBES = 4  # scenes per program
RANDOM = re.compile(
    r"\b(\w*Range|Uniform|Discrete|Options|Normal|TruncatedNormal|VerifaiOptions|VerifaiParameter|resample|random|numpy)\b"
)  # Scenic's distributions, and where Python's come from
TOWN_SPEED = 20.0  # [m/s]; nobody in our scenes has a reason to drive faster
SLACK = 0.5  # [m/s²], rounding of speeds over one step
_FAULTS = (ArithmeticError, AttributeError, LookupError, NameError, TypeError, ValueError)  # of a snippet's own code
DEEP = 0.3  # [m] of overlap that is seen as driving through something


@dataclass(frozen=True, slots=True)
class Finding:
    """One broken promise.

    Attributes:
        snippet_id: Whose.
        rung: ``names``, ``parameters``, ``randomness``, ``partners``, ``runs``, ``samples``, ``plausible`` or
            ``means``.
        message: What is wrong.
    """

    snippet_id: str
    rung: str
    message: str

    def __str__(self) -> str:
        return f"{self.snippet_id}: {self.rung}: {self.message}"


def lint(library: Library, backend: Backend, ego: EgoPolicy) -> tuple[Finding, ...]:
    """Check every snippet of a library, alone and in programs.

    Args:
        library: The snippets.
        backend: Where to run them.
        ego: Who drives.

    Returns:
        The findings, sorted; empty if every snippet keeps its contract.
    """
    found = {finding for snippet in library for finding in check_code(snippet)}
    known = {finding.snippet_id for finding in found}
    sound = Library(tuple(snippet for snippet in library if snippet.id not in known))
    tried: set[str] = set()
    for triple, kind in trials(sound):
        tried |= {snippet.id for snippet in triple}
        found |= set(_try(triple, kind, backend, ego))
    found |= {Finding(s.id, "partners", "no two other snippets fit it") for s in sound if s.id not in tried}
    return tuple(sorted(found, key=str))


# The code alone


def check_code(snippet: Snippet) -> Iterator[Finding]:
    """Whether the header says what the code says."""
    try:
        names = names_of(snippet.source, world_names())
    except SnippetError as error:
        yield Finding(snippet.id, "names", str(error))
        return
    for what, said, real in (
        ("requires", snippet.requires, names.requires),
        ("provides", snippet.provides, names.provides),
    ):
        if said != real:
            yield Finding(snippet.id, "names", f"the header says {what} = {list(said)}, the code {list(real)}")
    declared = {p.name: (p.low, p.high) for p in snippet.parameters}
    if declared != names.parameters:
        yield Finding(snippet.id, "parameters", f"the header has {declared}, the code {names.parameters}")
    if extra := _other_randomness(snippet.source, len(names.parameters)):
        yield Finding(snippet.id, "randomness", f"{extra} outside of a parameter; every random value must be one")


def _other_randomness(source: str, ranges: int) -> str:
    names: list[str] = RANDOM.findall(re.sub(r"#.*", "", source))
    others = sorted(set(names) - {"Range"})
    return ", ".join(others) or ("Range" if names.count("Range") > ranges else "")


@lru_cache(maxsize=1)
def world_names() -> frozenset[str]:
    """Every name that a program finds defined: Python's, Scenic's and the world model's."""
    # A program can say itself what it finds.
    scenario = compile_program(
        "model chatscene.world.model\nparam names = tuple(globals())\nego = new Car\n",
        map_path=resolve_map("town"),
        route=0,
        filename="<names>",
    )
    return frozenset((*scenario.params["names"], *dir(builtins), "self"))


# Partners


def _kinds(triple: Triple) -> list[AdversaryKind]:
    behavior, _, spawn = triple
    return [kind for kind in behavior.adversaries if kind in spawn.adversaries]


def trials(library: Library) -> Iterator[tuple[Triple, AdversaryKind]]:
    """Programs to try: every behavior as every kind, with geometries and spawns that were not tried yet first."""
    tried: dict[str, int] = {}
    geometries, spawns = library.of(Component.GEOMETRY), library.of(Component.SPAWN)

    def fewest(triples: Iterable[Triple]) -> Triple | None:
        return min(triples, key=lambda t: sum(tried.get(part.id, 0) for part in t[1:]), default=None)

    def note(triple: Triple) -> Triple:
        tried.update({part.id: tried.get(part.id, 0) + 1 for part in triple})
        return triple

    for behavior in library.of(Component.BEHAVIOR):
        possible = [
            t for t in ((behavior, *pair) for pair in product(geometries, spawns)) if incompatibility(*t) is None
        ]
        for kind in behavior.adversaries:
            triple = fewest(t for t in possible if kind in t[2].adversaries)
            if triple is not None:
                yield note(triple), kind
    for triple in product(library.of(Component.BEHAVIOR), geometries, spawns):
        if (triple[1].id not in tried or triple[2].id not in tried) and not incompatibility(*triple):
            yield note(triple), _kinds(triple)[0]


# Programs


def _try(triple: Triple, kind: AdversaryKind, backend: Backend, ego: EgoPolicy) -> Iterator[Finding]:
    behavior = triple[0]
    where = f"as {kind} with {triple[1].id} and {triple[2].id}"
    try:
        program = assemble(_scenario(triple), triple, kind)
        episodes, rejected = _probe(program, backend, ego)
        route = backend.route(program, 0)
    except (ChatSceneError, *_FAULTS) as error:
        yield Finding(behavior.id, "runs", f"{where}: {type(error).__name__}: {error}")
        return
    if len(rejected) > PROBES // 2:
        yield Finding(
            triple[2].id, "samples", f"{len(rejected)} of {PROBES} not placed: {rejected[0]} ({behavior.id} {where})"
        )
    for episode in episodes:
        for problem in implausible(episode):
            yield Finding(behavior.id, "plausible", f"{problem} ({where})")
    for part in triple:
        slots = replace(part.slots, adversary=kind)
        failures = [failure for episode in episodes for failure in check_meaning(slots, episode, route)[:1]]
        if len(failures) > len(episodes) // 2:
            yield Finding(part.id, "means", f"{failures[0]} ({behavior.id} {where})")


def _scenario(triple: Triple) -> Scenario:
    behavior, geometry, spawn = (part.description for part in triple)
    return Scenario(
        id="+".join(part.id for part in triple),
        text=f"{geometry} {spawn} {behavior}",
        base=None,
        parts=SubDescriptions(behavior=behavior, geometry=geometry, spawn=spawn),
        slots=Slots(),
    )


def _probe(program: ScenicProgram, backend: Backend, ego: EgoPolicy) -> tuple[list[Episode], list[str]]:
    outcomes = [backend.run(program, s, ego, through_collisions=True) for s in probe_scenes(program, 0)[:PROBES]]
    episodes = [outcome for outcome in outcomes if not isinstance(outcome, Rejected)]
    return episodes, [outcome.reason for outcome in outcomes if isinstance(outcome, Rejected)]


def implausible(episode: Episode) -> Iterator[str]:
    """What no road user could do: too fast, too hard, or through a thing that is not the ego."""
    for track in episode.adversaries:
        limits = LIMITS[track.kind]
        fastest = float(np.abs(track.speed).max())
        if fastest > min(limits.top_speed, TOWN_SPEED) + 0.1:
            yield f"the {track.kind} reaches {fastest:.1f} m/s"
        hardest = float(np.abs(track.acceleration(episode.dt)).max())
        if hardest > max(limits.throttle, limits.brake + limits.drag) + SLACK:
            yield f"the {track.kind} accelerates by {hardest:.1f} m/s²"
        for other in episode.tracks:
            if other.role in (Role.BACKGROUND, Role.OCCLUDER) and _pass_through(track, other):
                yield f"the {track.kind} goes through the {other.actor}"


def _pass_through(a: Track, b: Track) -> bool:
    """Whether the box of one actor is ever deep inside another's, seen along the other's axes."""
    cos, sin = np.cos(b.heading), np.sin(b.heading)
    dx, dy = a.x - b.x, a.y - b.y
    c, s = np.abs(np.cos(a.heading - b.heading)), np.abs(np.sin(a.heading - b.heading))
    along = np.abs(dx * cos + dy * sin) - (b.length + a.length * c + a.width * s) / 2
    across = np.abs(dy * cos - dx * sin) - (b.width + a.length * s + a.width * c) / 2
    return bool(((along < -DEEP) & (across < -DEEP)).any())
