"""Our environments by id: ``import chatscene.gym``, and Gymnasium knows them.

::

    import gymnasium
    import chatscene.gym

    env = gymnasium.make("chatscene/Scene-v0", text="a van ahead of us brakes hard on a straight road")
    env = gymnasium.make("chatscene/Drive-v0", render_mode="rgb_array")
    env = gymnasium.make("chatscene.gym:chatscene/Drive-v0")  # where nobody imported this module before

Gymnasium 1 looks for no entry points, so that an import it must be (decision 0040).
"""

from __future__ import annotations

from pathlib import Path

from gymnasium.envs.registration import register

from chatscene.ego.policy import load_ego
from chatscene.learn.env import DrivingEnv
from chatscene.maps.network import resolve_map
from chatscene.program.ordinary import Course
from chatscene.report.filled import explain_text
from chatscene.search.climb import climb, simulator_of
from chatscene.search.generator import load_generator
from chatscene.settings import SIMULATOR, RetrievalSettings, Settings, SimulationSettings
from chatscene.simulate.simulator import routes_of


def make_scene(
    text: str,
    *,
    map: str | Path = "town",  # noqa: A002 - the word of the command line
    ego: str = "sac",
    routes: int = 1,
    library: str = "",
    simulator: str = SIMULATOR,
    physics: str = SimulationSettings().physics,
    ego_observation: str = "safebench",
    pedals: str = "safebench",
    reward: str = "progress",
    render_mode: str | None = None,
) -> DrivingEnv:
    """An environment of a sentence: each episode is another scene of its program.

    Args:
        text: The sentence.
        map: Packaged ``town``, or an ``.xodr`` file.
        ego: Who drives while it is checked that scenes show what was read.
        routes: Routes that episodes lie on.
        library: Folder of one's own snippets, beside the packaged ones.
        simulator: Where it runs, one of `chatscene.simulate.simulator.SIMULATORS`.
        physics: How bodies answer there, one of `chatscene.settings.PHYSICS`.
        ego_observation: What the ego sees, a preset of `chatscene.ego.observation`.
        pedals: Mapping of actions, one of `chatscene.ego.policy.PEDALS`.
        reward: One of `chatscene.learn.reward.REWARDS`.
        render_mode: ``rgb_array`` or None.

    Raises:
        NothingFits: The library cannot serve the sentence.
        MeansSomethingElse: Its scenes do not show what was read.
    """
    settings = Settings(
        retrieval=RetrievalSettings(library=library),
        simulation=SimulationSettings(simulator=simulator, physics=physics),
    )
    understood = explain_text(text, settings, map_name=str(map))
    generator = load_generator(understood.generator)
    where = simulator_of(generator, resolve_map(str(map)), settings)
    scenario = understood.scenario
    first = generator.write(scenario, settings.retrieval)
    written, _ = climb(generator, scenario, first, settings=settings.retrieval, simulator=where, ego=load_ego(ego))
    return DrivingEnv(
        [Course(program=written.program, route=route) for route in routes_of(where, written.program, routes)],
        map_name=map,
        ego_observation=ego_observation,
        pedals=pedals,
        reward=reward,
        simulator=where,
        render_mode=render_mode,
    )


def make_drive(
    *,
    map: str | Path = "town",  # noqa: A002 - the word of the command line
    simulator: str = SIMULATOR,
    physics: str = SimulationSettings().physics,
    ego_observation: str = "safebench",
    pedals: str = "safebench",
    reward: str = "progress",
    speed: float | None = None,
    render_mode: str | None = None,
) -> DrivingEnv:
    """An environment of the ordinary routes of a map, with traffic that means no harm.

    Args:
        map: Packaged ``town``, or an ``.xodr`` file.
        simulator: Where it runs, one of `chatscene.simulate.simulator.SIMULATORS`.
        physics: How bodies answer there, one of `chatscene.settings.PHYSICS`.
        ego_observation: What the ego sees, a preset of `chatscene.ego.observation`.
        pedals: Mapping of actions, one of `chatscene.ego.policy.PEDALS`.
        reward: One of `chatscene.learn.reward.REWARDS`.
        speed: What the ego is to drive at [km/h], within the limits of the roads; None for the drives of before.
        render_mode: ``rgb_array`` or None.
    """
    return DrivingEnv(
        map_name=map,
        settings=SimulationSettings(simulator=simulator, physics=physics),
        ego_observation=ego_observation,
        pedals=pedals,
        reward=reward,
        speed=speed,
        render_mode=render_mode,
    )


register(id="chatscene/Scene-v0", entry_point="chatscene.gym:make_scene")
register(id="chatscene/Drive-v0", entry_point="chatscene.gym:make_drive")
