"""Drive scenes and judge the drives: what was said, how the ego fared, how critical it was, whose doing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from chatscene.ego.asking import fitted
from chatscene.ego.policy import EgoPolicy, knows_body, name_of, takes_speed
from chatscene.measure.avoidability import avoidable_if_driven
from chatscene.measure.crash_type import crash_type, waits
from chatscene.measure.criticality import criticality, fault
from chatscene.measure.happening import happened
from chatscene.measure.score import columns, measure
from chatscene.measure.speeds import speeds
from chatscene.measure.sums import BLOCK, sum_up
from chatscene.measure.tyres import beyond_tyres, friction_demand
from chatscene.measure.unplayed import unplayed
from chatscene.program.shown import shown
from chatscene.simulate.simulator import Simulator, simulate
from chatscene.terms.actors import noun_of
from chatscene.terms.criticality import Criticality, Fault, Happened
from chatscene.terms.episode import Episode
from chatscene.terms.metrics import Measurements
from chatscene.terms.scenario import Said
from chatscene.terms.scene import CAR, Rejected, Scene, ScenicProgram
from chatscene.terms.speeds import Speeds


@dataclass(frozen=True, slots=True, kw_only=True)
class Ran:
    """A scene that was driven, and what came of it.

    Attributes:
        scene: The scene.
        episode: The ego's drive.
        measurements: Its raw numbers.
        metrics: One number per metric, by column name, paper mode.
        meaning: What the drive did not show of what was said; empty is good.
        cut: How many facts a contact cut short that were to be seen to their end.
        touch: Whether it was said that there is a contact; None where nothing was said of one.
        criticality: How close it came.
        speeds: How fast who was, and how hard they met.
        happened: What happened, and when.
        fault: Who ran into whom; None without a collision.
        avoidable: Whether a careful driver would have avoided the collision; None without one, or where nobody
            knows.
        crash_type: Of which kind the collision is; empty without one.
        waits: Whether the ego waits at the end behind somebody who does not move on.
        unplayed: What of a program of one's own did not take place, and what took place as it could not on a road;
            empty is good.
    """

    scene: Scene
    episode: Episode
    measurements: Measurements
    metrics: dict[str, float]
    meaning: tuple[str, ...]
    criticality: Criticality
    speeds: Speeds
    happened: Happened
    fault: Fault | None
    avoidable: bool | None
    crash_type: str
    waits: bool
    unplayed: tuple[str, ...] = ()
    cut: int = 0
    touch: bool | None = None


def drive(program: ScenicProgram, said: Said, scene: Scene, *, simulator: Simulator, ego: EgoPolicy) -> Ran | Rejected:
    """Drive one scene and judge it, as `drive_all` does."""
    return drive_all(program, said, [scene], simulator=simulator, ego=ego)[0]


def drive_all(
    program: ScenicProgram, said: Said, scenes: Sequence[Scene], *, simulator: Simulator, ego: EgoPolicy
) -> list[Ran | Rejected]:
    """Drive scenes one after another, and judge them as a block.

    Args:
        program: What to run.
        said: What was said.
        scenes: The concrete values of each; what comes of one depends on no other.
        simulator: Where.
        ego: Who drives.

    Raises:
        EgoError: The ego fails.
        ProgramError: The program's own code fails.
    """
    ego, found = fitted(ego, program), list[Ran | Rejected]()
    for first in range(0, len(scenes), BLOCK):
        block = scenes[first : first + BLOCK]
        driven = [_driven(program, scene, ego, simulator) for scene in block]
        sum_up([one.episode for one in driven if isinstance(one, _Driven)])
        found += [
            _judged(program, said, scene, one, simulator, ego) if isinstance(one, _Driven) else one
            for scene, one in zip(block, driven, strict=True)
        ]
    return found


@dataclass(frozen=True, slots=True)
class _Driven:
    """A drive, and whether a careful driver would have avoided its collision, or why nobody knows."""

    episode: Episode
    careful: bool | None
    unknown: tuple[str, ...]


def _driven(program: ScenicProgram, scene: Scene, ego: EgoPolicy, simulator: Simulator) -> _Driven | Rejected:
    episode = simulate(simulator, program, scene, ego)
    if isinstance(episode, Rejected):
        return episode
    return _Driven(episode, *avoidable_if_driven(episode, program, scene, ego, simulator))


def _judged(
    program: ScenicProgram, said: Said, scene: Scene, driven: _Driven, simulator: Simulator, ego: EgoPolicy
) -> Ran:
    episode = driven.episode
    measurements = measure(episode)
    found = shown(said, episode, simulator.route_in(program, scene))
    return Ran(
        scene=scene,
        episode=episode,
        measurements=measurements,
        metrics=columns(measurements),
        meaning=found.missing,
        cut=found.cut,
        touch=found.touch,
        criticality=criticality(episode),
        speeds=speeds(episode, friction_demand(episode)),
        happened=happened(episode),
        fault=fault(episode),
        avoidable=driven.careful,
        crash_type=crash_type(episode),
        waits=waits(episode),
        unplayed=(
            *_not_kept_to(program, ego),
            *unplayed(program, episode),
            *driven.unknown,
            *(beyond_tyres(episode) if simulator.identity.at_once else ()),
        ),
    )


def _not_kept_to(program: ScenicProgram, ego: EgoPolicy) -> list[str]:
    """What a program wants of its ego, its speed or its kind of vehicle, that this one does not take."""
    if program.as_written:
        return []
    told: list[str] = []
    if (wanted := program.wanted_speed) is not None:
        trained_for = getattr(ego, "trained_for", 0.0)
        so = f"the ego should drive at {wanted:g} m/s, but {name_of(ego)}"
        if not takes_speed(ego):
            told = [f"{so} chooses its own speed"]
        elif 0.0 < trained_for < wanted and not program.keeps_limits:
            told = [f"{so} was trained for up to {trained_for:.4g} m/s and drives no faster"]
    if program.ego_kind != CAR and not knows_body(ego):
        told.append(
            f"the ego is not a car ({noun_of(program.ego_kind)}), and {name_of(ego)} drives it as if it were one"
        )
    return told
