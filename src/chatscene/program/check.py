"""Step 4 of 9, second half: the validation ladder of a program.

Names close, compiles, samples, runs, shows what was read: each rung fails in its own words, and a program is only
searched with once it stands on the last.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from chatscene.ego.policy import EgoPolicy
from chatscene.errors import MeansSomethingElse, Unsatisfiable
from chatscene.program.sample import scene_at
from chatscene.program.shown import not_shown
from chatscene.simulate.simulator import Simulator, simulate
from chatscene.terms.episode import Episode
from chatscene.terms.route import Route
from chatscene.terms.scenario import Said
from chatscene.terms.scene import Rejected, Scene, ScenicProgram

PROBES = (
    0.5,
    0.25,
    0.75,
    0.4,
    0.6,
    0.1,
    0.9,
)  # where in every range the probing scenes lie, the middle first
PROBED = 3  # drives that a program is checked with
DRAWN_PROBES = 3  # of them, for a program that draws where its things stand: each takes its time to be drawn


@dataclass(frozen=True, slots=True, kw_only=True)
class Checked:
    """A program that climbed the ladder.

    Attributes:
        episodes: The probing drives, through collisions.
        meaning: Per episode, what it did not show of what was read up to the first contact; at least one shows all.
        rejected: Probing scenes that could not be placed.
    """

    episodes: tuple[Episode, ...]
    meaning: tuple[tuple[str, ...], ...]
    rejected: tuple[Rejected, ...]


def probe_scenes(program: ScenicProgram, route: int) -> tuple[Scene, ...]:
    """Scenes at fixed places in the declared ranges, to try a program with."""
    return tuple(scene_at(program, route, share, name=f"probe-{i}") for i, share in enumerate(PROBES))


def check(
    program: ScenicProgram, said: Said, simulator: Simulator, ego: EgoPolicy, *, route: int = 0, drives: int = PROBED
) -> Checked:
    """Climb the ladder from compiling to meaning.

    The last rung is two. The adversary can do what was read: in a drive that goes on through collisions it does all of
    it, in order. And an ego can be tested with it: in a drive all of it has begun before the ego meets anything.

    Args:
        program: What to check; its names were checked when it was assembled.
        said: What was read.
        simulator: Where to run it.
        ego: Who drives.
        route: Which route to probe on.
        drives: How many probing scenes to run to the end.

    Raises:
        DoesNotCompile: Scenic refuses it.
        MapError: The map lacks the geometry.
        Unsatisfiable: No probing scene can be placed.
        StuckBehavior: A behavior never yields.
        MeansSomethingElse: No drive shows what was read, or each has its collision before that.
    """
    episodes: list[Episode] = []
    rejected: list[Rejected] = []
    placed: list[Scene] = []
    for scene in probe_scenes(program, route)[: DRAWN_PROBES if program.drawn else None]:
        outcome = simulate(simulator, program, scene, ego, through_collisions=True)
        if isinstance(outcome, Rejected):
            rejected.append(outcome)
        else:
            episodes.append(outcome)
            placed.append(scene)
        if len(episodes) == drives:
            break
    if not episodes:
        raise Unsatisfiable(
            f"{program.called}: none of {len(rejected)} probing scenes could be placed; "
            f"most often: {_commonest([r.reason for r in rejected])}"
            + ("; no more were tried, since each takes its time to be drawn" if program.drawn else "")
        )
    way = simulator.route_in(program, placed[0])
    if failures := unshown(said, episodes, way):
        raise MeansSomethingElse(
            f"{program.called} runs, but none of {len(episodes)} drives shows what was read: {'; '.join(failures)}",
            blamed=_blamed(program, failures),
        )
    meaning = tuple(not_shown(said, episode, way) for episode in episodes)
    return Checked(episodes=tuple(episodes), meaning=meaning, rejected=tuple(rejected))


def unshown(said: Said, episodes: Sequence[Episode], route: Route) -> tuple[str, ...]:
    """What probing drives through collisions never show: that it can be done, else that an ego is tested with it.

    Returns:
        One sentence per failure of the drive that shows most; empty if one drive shows that the adversary can do what
        was read, and one that all of it has begun before the ego meets anything.
    """
    for through in (True, False):
        if failures := min((not_shown(said, e, route, through=through, met=False) for e in episodes), key=len):
            return failures
    return ()


def _blamed(program: ScenicProgram, failures: Sequence[str]) -> tuple[str, ...]:
    """The snippets that fail together, by the first failure: an ego's way is its geometry's, a deed needs a start."""
    if not program.snippet_ids:
        return ()
    behavior, geometry, spawn = program.snippet_ids
    match failures[0].partition(":")[0]:
        case "ego" | "control" | "place":
            return (geometry,)
        case "distance":
            return (spawn,)
        case "action":
            return (behavior, spawn)
        case _:
            return (geometry, spawn)


def _commonest(reasons: Sequence[str]) -> str:
    return max(sorted(set(reasons)), key=list(reasons).count)
