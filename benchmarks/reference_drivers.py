"""How far reference drivers agree on which crashes could be avoided, and where they do not.

    python benchmarks/reference_drivers.py [--ego idm] [--scenes 20] [--most 200]

Scenes of every sentence of the benchmark are drawn uniformly on one route and driven in the native simulator; all
reference drivers are asked about each crash, until there are `--most`. Prints how many each avoids, of how many pairs
of answers agree, and the scenes in which they differ with the values to drive them again.
"""

from __future__ import annotations

from collections import Counter
from itertools import combinations

import click
from careful_drivers import REFERENCE_DRIVERS

from chatscene import pipeline
from chatscene.ego.policy import load_ego
from chatscene.maps.network import resolve_map
from chatscene.measure.crash_type import crash_type
from chatscene.program.sample import draw, scene_seed
from chatscene.search.generator import load_generator
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import load_simulator, simulate
from chatscene.terms.episode import Episode
from chatscene.terms.scenario import BaseScenario
from chatscene.terms.scene import Scene


@click.command()
@click.option("--ego", "ego_name", default="idm", show_default=True)
@click.option("--scenes", default=20, show_default=True, help="Of each sentence.")
@click.option("--most", default=200, show_default=True, help="Crashes to ask about.")
@click.option("--differing", default=20, show_default=True, help="Scenes to list.")
@click.option("--seed", default=0, show_default=True)
def main(ego_name: str, scenes: int, most: int, differing: int, seed: int) -> None:
    simulator = load_simulator(resolve_map("town"), SimulationSettings(simulator="native"))
    ego, generator = load_ego(ego_name), load_generator("chatscene")
    answers: list[dict[str, bool]] = []
    listed: list[str] = []
    per_sentence = max(most // 40, 1)
    for text in (text for base in BaseScenario for text in generator.texts(base)):
        program = pipeline.understand(text).program
        asked = 0
        for number in range(scenes):
            name = f"{program.scenario_id}/route-00/scene-{number:03d}"
            drawn = scene_seed(seed, name)
            values = draw(program.parameters, seed=drawn)
            scene = Scene(id=name, scenario_id=program.scenario_id, route=0, block=0, seed=drawn, values=values)
            episode = simulate(simulator, program, scene, ego)
            if not isinstance(episode, Episode) or episode.collision is None:
                continue
            told = {
                who: bool(judge(episode, program, scene, ego, simulator)) for who, judge in REFERENCE_DRIVERS.items()
            }
            answers.append(told)
            if len(set(told.values())) > 1:
                avoided = ", ".join(who for who, avoids in told.items() if avoids)
                listed.append(f"- {text} Scene {number}: {crash_type(episode)}; avoided by {avoided}")
            asked += 1
            if asked == per_sentence:
                break
        click.echo(f"{len(answers)} crashes, {len(listed)} in which they differ", err=True)
    click.echo("| | avoids | " + " | ".join(REFERENCE_DRIVERS) + " |")
    click.echo("|---|---:|" + "---:|" * len(REFERENCE_DRIVERS))
    agree = Counter(
        pair for told in answers for pair in combinations(REFERENCE_DRIVERS, 2) if told[pair[0]] == told[pair[1]]
    )
    for one in REFERENCE_DRIVERS:
        row = ["" if one == other else str(agree[(one, other)] + agree[(other, one)]) for other in REFERENCE_DRIVERS]
        click.echo(f"| {one} | {sum(told[one] for told in answers)} | " + " | ".join(row) + " |")
    click.echo(f"\nOf {len(answers)} crashes of {ego_name}: how many each avoids, and in how many two agree.\n")
    click.echo("\n".join(listed[:differing]))


if __name__ == "__main__":
    main()
