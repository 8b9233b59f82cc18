"""Does every snippet keep its word? The rungs of the validation ladder, for the parts instead of a program.

A snippet is tried in programs with partners that fit it, chosen in a fixed order so that few programs cover the
whole library: every behavior with every kind of adversary it names, every geometry, every spawn position.
"""

from __future__ import annotations

import builtins
import re
from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from chatscene.ego.policy import EgoPolicy
from chatscene.errors import ChatSceneError, SnippetError
from chatscene.grow.directions import Joint, misnamed, strays
from chatscene.grow.twins import scenario_of, twins
from chatscene.library.compatibility import compatibility
from chatscene.library.load import Library, names_of
from chatscene.library.plan_check import acts_of, check_plan
from chatscene.library.snippet_file import ADVERSARY_CLASS
from chatscene.maps.network import resolve_map
from chatscene.program.assemble import assemble
from chatscene.program.meaning import check_meaning
from chatscene.program.sample import draw
from chatscene.simulate.confined.allow_list import check_foreign
from chatscene.simulate.confined.plain_text import Refusal
from chatscene.simulate.simulator import Simulator, simulate
from chatscene.terms.actors import LIMITS, AdversaryKind
from chatscene.terms.episode import Episode, Role, Track
from chatscene.terms.plan import Plan
from chatscene.terms.plan_text import plan_of
from chatscene.terms.pointing import pointed
from chatscene.terms.route import Route
from chatscene.terms.scenario import Component
from chatscene.terms.scene import Rejected, Scene, ScenicProgram
from chatscene.terms.snippet import Snippet
from chatscene.world.compilation import compile_program

Triple = tuple[Snippet, Snippet, Snippet]

SCENES = 10  # per program, drawn at random over as many routes as there are
SHARE = 0.9  # of them must show what a snippet says of itself
RANDOM = re.compile(
    r"\b(\w*Range|Uniform|Discrete|Options|Normal|TruncatedNormal|VerifaiOptions|VerifaiParameter|resample|random|numpy)\b"
)  # Scenic's distributions, and where Python's come from
TOWN_SPEED = 20.0  # [m/s]; nobody in our scenes has a reason to drive faster
SLACK = 0.5  # [m/s²], rounding of speeds over one step
DEEP = 0.3  # [m] of overlap that is seen as driving through something


@dataclass(frozen=True, slots=True)
class Finding:
    """One broken promise.

    Attributes:
        rung: ``allow-list``, ``names``, ``randomness``, ``direction``, ``plan``, ``partners``, ``runs``,
            ``samples``, ``plausible``, ``means`` or ``distinct``.
    """

    snippet_id: str
    rung: str
    message: str

    def __str__(self) -> str:
        return f"{self.snippet_id}: {self.rung}: {self.message}"


def sifted(found: Collection[Finding], only: Collection[str] | None) -> tuple[Finding, ...]:
    """The findings about the snippets that were to be checked, sorted."""
    return tuple(sorted((f for f in found if only is None or f.snippet_id in only), key=str))


def unpartnered(library: Library, tried: Collection[str]) -> set[Finding]:
    """Snippets that were in no program, because none could be joined with them."""
    return {Finding(s.id, "partners", "no two other snippets fit it") for s in library if s.id not in tried}


def alike(library: Library, simulator: Simulator, ego: EgoPolicy, only: Collection[str] | None) -> set[Finding]:
    """Snippets that do the same as another."""
    return {
        Finding(one, "distinct", f"does the same as {other}: {why}")
        for pair in twins(library, simulator, ego, only)
        for one, other, why in (pair, (pair[1], pair[0], pair[2]))
        if only is None or one in only
    }


def sound_part(library: Library, strangers: Collection[str] | None = None) -> tuple[Library, set[Finding]]:
    """The snippets whose code is sound as far as reading shows, and what is wrong with the others.

    Without geometries of sites, which the town has not: they are read, and driven nowhere.
    """
    found: set[Finding] = set()
    for snippet in library:
        refused = refused_code(snippet, library) if snippet.id in (strangers or ()) else ()
        found |= set(refused or check_code(snippet))
    known = {finding.snippet_id for finding in found}
    return Library(tuple(s for s in library if s.id not in known and s.slots.site is None)), found


# The code alone


def partner_names(component: Component, library: Library) -> frozenset[str]:
    """Names that a snippet's partners may define."""
    others = {name for s in library if s.component is not component for name in s.provides}
    return frozenset(others | {ADVERSARY_CLASS})


def refused_code(snippet: Snippet, library: Library) -> tuple[Finding, ...]:
    """What a stranger's snippet uses that strangers may not use; nothing of it is run."""
    given = partner_names(snippet.component, library)
    refusals = check_foreign(snippet.source, whole=False, given=given)
    return tuple(Finding(snippet.id, "allow-list", _where_it_stands(snippet, refusal)) for refusal in refusals)


def _where_it_stands(snippet: Snippet, refusal: Refusal) -> str:
    """A refusal by its line in the snippet's file, with that line and a caret under the place."""
    told = replace(refusal, line=snippet.lines[refusal.line - 1]) if 0 < refusal.line <= len(snippet.lines) else refusal
    return f"{told}\n{pointed(snippet.source, refusal.place)}".rstrip()


def check_code(snippet: Snippet) -> Iterator[Finding]:
    """Whether the code is Scenic, asks for nothing that nobody defines, and leaves nothing else to chance."""
    try:
        names = names_of(snippet.source, world_names())
    except SnippetError as error:
        yield Finding(snippet.id, "names", str(error))
        return
    if unknown := sorted(set(names.requires) - set(snippet.requires)):
        yield Finding(snippet.id, "names", f"it calls {', '.join(unknown)}, which nothing defines")
    if hidden := sorted(set(names.provides) ^ set(snippet.provides)):
        yield Finding(snippet.id, "names", f"define {', '.join(hidden)} at the beginning of a line")
    if extra := _other_randomness(snippet.source, len(snippet.parameters)):
        yield Finding(snippet.id, "randomness", f"{extra} outside of a parameter; every random value must be one")
    for problem in misnamed(snippet):
        yield Finding(snippet.id, "direction", problem)
    plan = plan_of(snippet)
    if isinstance(plan, Plan):
        for problem in (*check_plan(plan, snippet.parameters), *_misjudged(snippet, plan)):
            yield Finding(snippet.id, "plan", problem)


def _misjudged(snippet: Snippet, plan: Plan) -> Iterator[str]:
    """Acts that the facts name and the plan cannot show, or the other way round."""
    for action, shows in acts_of(plan).items():
        if shows and action not in snippet.slots.actions:
            yield f"it must be seen to {action}, and its actions do not say so"
        elif not shows and action in snippet.slots.actions:
            yield f"its actions say {action}, and nothing in its code can show that"


def _other_randomness(source: str, ranges: int) -> str:
    names: list[str] = RANDOM.findall(re.sub(r"#.*", "", source))
    others = sorted(set(names) - {"Range"})
    return ", ".join(others) or ("Range" if names.count("Range") > ranges else "")


@lru_cache(maxsize=1)
def world_names() -> frozenset[str]:
    """Every name that a program finds defined: Python's, Scenic's and the world model's."""
    # A program can say itself what it finds.
    scenario = compile_program(
        "model chatscene.world.model\nparam names = tuple(globals())\nego = new Car at (0, 0)\n",
        map_path=resolve_map("town"),
        route=0,
        filename="<names>",
    )
    return frozenset((*scenario.params["names"], *dir(builtins), "self"))


# Partners


def trials(library: Library, only: Collection[str] | None = None) -> Iterator[tuple[Triple, AdversaryKind]]:
    """Programs to try: every behavior as every kind, with geometries and spawns that were not tried yet first."""
    joint = compatibility(library)
    # The town has none of the places that are a site; what is there is held by tests of routes and facts.
    mask = joint.mask & np.array([g.slots.site is None for g in joint.geometries])[None, :, None]
    tried = (np.zeros(len(joint.geometries), int), np.zeros(len(joint.spawns), int))
    wanted = [
        [only is None or part.id in only for part in parts]
        for parts in (joint.behaviors, joint.geometries, joint.spawns)
    ]

    def taken(b: int, g: int, s: int) -> Triple:
        tried[0][g] += 1
        tried[1][s] += 1
        return joint.behaviors[b], joint.geometries[g], joint.spawns[s]

    for b, behavior in enumerate(joint.behaviors):
        for kind in behavior.adversaries if wanted[0][b] else ():
            fits = mask[b] & np.array([kind in spawn.adversaries for spawn in joint.spawns])[None, :]
            if fits.any():
                used = np.where(fits, tried[0][:, None] + tried[1][None, :], np.iinfo(int).max)
                g, s = np.unravel_index(int(used.argmin()), used.shape)
                yield taken(b, int(g), int(s)), kind
    for axis in (1, 2):
        for i, missing in enumerate(tried[axis - 1] == 0):
            at = np.argwhere(np.take(mask, i, axis=axis)) if missing and wanted[axis][i] else []
            if len(at):
                b, other = (int(n) for n in at[0])
                triple = taken(b, i, other) if axis == 1 else taken(b, other, i)
                yield triple, next(kind for kind in triple[0].adversaries if kind in triple[2].adversaries)


# Programs


def try_triple(
    triple: Triple, kind: AdversaryKind, simulator: Simulator, ego: EgoPolicy, scenes: int = SCENES
) -> Iterator[Finding]:
    """Run the program of a triple and see whether its parts keep their words."""
    behavior = triple[0]
    where = f"as {kind} with {triple[1].id} and {triple[2].id}"
    try:
        program = assemble(scenario_of(triple), triple, kind)
        driven, rejected = _drive(program, simulator, ego, scenes)
    except ChatSceneError as error:
        yield Finding(behavior.id, "runs", f"{where}: {type(error).__name__}: {error}")
        return
    if len(rejected) > scenes // 2:
        yield Finding(
            triple[2].id, "samples", f"{len(rejected)} of {scenes} not placed: {rejected[0]} ({behavior.id} {where})"
        )
    for episode, _ in driven:
        for problem in implausible(episode):
            yield Finding(behavior.id, "plausible", f"{problem} ({where})")
    for part in triple:
        slots = replace(part.slots, adversary=kind)
        failures = [
            failure for episode, route in driven for failure in check_meaning(slots, episode, route, through=True)[:1]
        ]
        if len(failures) > (1 - SHARE) * len(driven) + 1e-9:
            yield Finding(
                part.id, "means", f"{failures[0]}, in {len(failures)} of {len(driven)} scenes ({behavior.id} {where})"
            )


def try_joint(joint: Joint, library: Library, simulator: Simulator, ego: EgoPolicy) -> Iterator[Finding]:
    """Join three snippets and see whether they go where their names and facts say."""
    behavior, geometry, spawn = (library.get(snippet_id) for snippet_id in joint.ids)
    where = f"{behavior.id} as {joint.kind} with {geometry.id} and {spawn.id}"
    try:
        for problem in strays((behavior, geometry, spawn), joint, simulator, ego):
            blamed = behavior if problem.startswith("action") else spawn
            yield Finding(blamed.id, "direction", f"{problem} ({where})")
    except ChatSceneError as error:
        yield Finding(behavior.id, "runs", f"{where}: {type(error).__name__}: {error}")


def _drive(
    program: ScenicProgram, simulator: Simulator, ego: EgoPolicy, count: int
) -> tuple[list[tuple[Episode, Route]], list[str]]:
    """Scenes drawn from the declared ranges, each on the next route; and why the others could not be placed."""
    driven: list[tuple[Episode, Route]] = []
    rejected: list[str] = []
    routes = simulator.routes(program)
    for i in range(count):
        route = i % routes
        scene = Scene(
            id=f"{program.scenario_id}/route-{route:02d}/lint-{i}",
            scenario_id=program.scenario_id,
            route=route,
            block=-1,
            seed=i,
            values=draw(program.parameters, seed=i),
        )
        outcome = simulate(simulator, program, scene, ego, through_collisions=True)
        if isinstance(outcome, Rejected):
            rejected.append(outcome.reason)
        else:
            driven.append((outcome, simulator.route(program, route)))
    return driven, rejected


def implausible(episode: Episode) -> Iterator[str]:
    """What no road user could do: too fast, too hard, or, until it meets the ego, through something else."""
    until = episode.collision.step if episode.collision else None
    for track in episode.adversaries:
        limits = LIMITS[track.kind]
        fastest = float(np.abs(track.speed).max())
        if fastest > min(limits.top_speed, TOWN_SPEED) + 0.1:
            yield f"the {track.kind} reaches {fastest:.1f} m/s"
        hardest = float(np.abs(track.acceleration(episode.dt)).max())
        if hardest > max(limits.throttle, limits.brake + limits.drag) + SLACK:
            yield f"the {track.kind} accelerates by {hardest:.1f} m/s²"
        for other in episode.tracks:
            if other.role in (Role.BACKGROUND, Role.OCCLUDER) and _pass_through(track, other, until):
                yield f"the {track.kind} goes through the {other.actor}"


def _pass_through(a: Track, b: Track, until: int | None) -> bool:
    """Whether the box of one actor is ever, before a step, deep inside another's, seen along the other's axes."""
    cos, sin = np.cos(b.heading), np.sin(b.heading)
    dx, dy = a.x - b.x, a.y - b.y
    c, s = np.abs(np.cos(a.heading - b.heading)), np.abs(np.sin(a.heading - b.heading))
    along = np.abs(dx * cos + dy * sin) - (b.length + a.length * c + a.width * s) / 2
    across = np.abs(dy * cos - dx * sin) - (b.width + a.length * s + a.width * c) / 2
    return bool(((along < -DEEP) & (across < -DEEP))[:until].any())
