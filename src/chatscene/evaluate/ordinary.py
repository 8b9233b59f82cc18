"""How an ego fares on ordinary drives: whether it gets there, and whether it crashes on the way."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from chatscene.ego.policy import EgoPolicy, name_of
from chatscene.evaluate.score import wilson
from chatscene.maps.network import resolve_map
from chatscene.program.ordinary import Course, ordinary_courses
from chatscene.program.sample import draw, scene_seed
from chatscene.settings import SimulationSettings
from chatscene.simulate.backend import Backend, load_backend
from chatscene.terms.episode import Episode
from chatscene.terms.scene import Rejected, Scene


@dataclass(frozen=True, slots=True, kw_only=True)
class OrdinaryResult:
    """The ordinary drives of one ego.

    Attributes:
        ego: Its name.
        completion: Share of the route driven, one per drive.
        speed: Mean speed [m/s], one per drive.
        collided: Whether it crashed, one per drive.
        rejected: Draws that could not be placed.
    """

    ego: str
    completion: tuple[float, ...]
    speed: tuple[float, ...]
    collided: tuple[bool, ...]
    rejected: int

    def figures(self) -> dict[str, float]:
        """The means, by name, and the Wilson interval of the collision rate."""
        drives = len(self.completion)
        low, high = wilson(sum(self.collided), drives)
        return {
            "drives": float(drives),
            "completion": sum(self.completion) / drives,
            "collision_rate": sum(self.collided) / drives,
            "collision_rate_low": low,
            "collision_rate_high": high,
            "mean_speed": sum(self.speed) / drives,
        }


def drive_ordinary(ego: EgoPolicy, *, map_name: str, scenes: int, seed: int) -> OrdinaryResult:
    """Let an ego drive every ordinary course of a map.

    Args:
        ego: Who drives.
        map_name: Where.
        scenes: Draws of traffic per course.
        seed: Of the traffic.

    Raises:
        MapError: The map offers no route.
        EgoError: The ego fails.
    """
    episodes = list(ordinary_episodes(ego, map_name=map_name, scenes=scenes, seed=seed))
    driven = [episode for episode in episodes if not isinstance(episode, Rejected)]
    return OrdinaryResult(
        ego=name_of(ego),
        completion=tuple(episode.route_completion for episode in driven),
        speed=tuple(float(episode.ego_track.speed.mean()) for episode in driven),
        collided=tuple(episode.collision is not None for episode in driven),
        rejected=len(episodes) - len(driven),
    )


def ordinary_episodes(ego: EgoPolicy, *, map_name: str, scenes: int, seed: int) -> Iterator[Episode | Rejected]:
    """The drives themselves, course by course."""
    backend: Backend = load_backend("embedded", resolve_map(map_name), SimulationSettings())
    for course in ordinary_courses(backend):
        for number in range(scenes):
            yield backend.run(course.program, _scene(course, number, seed), ego)


def _scene(course: Course, number: int, seed: int) -> Scene:
    name = f"{course.program.scenario_id}/route-{course.route:02d}/scene-{number:03d}"
    own = scene_seed(seed, name)
    return Scene(
        id=name,
        scenario_id=course.program.scenario_id,
        route=course.route,
        block=0,
        seed=own,
        values=draw(course.program.parameters, seed=own),
    )
