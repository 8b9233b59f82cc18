"""Whether scenes in a CARLA server end as they do in the embedded simulator: who collides, on which side, and when.

    chatscene serve-carla --port 2000 &
    python benchmarks/carla_agreement.py src/chatscene/search/generators/benchmark_scenarios.json

A file of sentences, one a line or strings in lists of JSON, however nested. Each is read and made into a program that
climbs the validation ladder in the server, as in a run; then scenes are drawn and driven by the ego `sac`, by default
10 a sentence on one route with seed 0: in the server, in the embedded simulator with bodies of the server's sizes, and
in the embedded simulator as it is. Two drives agree if both are rejected or neither collides, or both collide with
the same on the same side within two steps. Prints a line per sentence, each scene that differs, and totals.
"""

from __future__ import annotations

from pathlib import Path

import click
from shown import texts_in

from chatscene.ego.policy import load_ego
from chatscene.errors import ChatSceneError
from chatscene.maps.network import resolve_map
from chatscene.search.climb import climb
from chatscene.search.generators.retrieved import Retrieved
from chatscene.settings import RetrievalSettings, SimulationSettings
from chatscene.simulate.simulator import load_simulator
from chatscene.studies.agreement import compared, same_sizes


@click.command()
@click.argument("sentences", type=click.Path(path_type=Path, exists=True, dir_okay=False))
@click.option("--simulator", default="carla", show_default=True, help="carla:HOST:PORT")
@click.option("--map", "map_name", default="town", show_default=True)
@click.option("--scenes", default=10, show_default=True)
@click.option("--seed", default=0, show_default=True)
@click.option("--ego", "ego_name", default="sac", show_default=True)
def main(sentences: Path, simulator: str, map_name: str, scenes: int, seed: int, ego_name: str) -> None:
    """Drive scenes of every sentence of a file in both simulators and count how many agree."""
    path, ego, reading = resolve_map(map_name), load_ego(ego_name), RetrievalSettings()
    settings = SimulationSettings(simulator=simulator)
    carla = load_simulator(path, settings)
    click.echo(f"{carla.identity.name} {carla.identity.version}: {carla.identity.physics}")
    others = ("with its sizes", "as it is")
    simulators = (
        carla,
        same_sizes(path, settings, getattr(carla, "size_of")),  # noqa: B009
        load_simulator(path, SimulationSettings()),
    )
    generator = Retrieved()
    ran = driven = collided = 0
    agree, apart = [0, 0], [list[float](), list[float]()]
    texts = texts_in(sentences)
    for number, text in enumerate(texts, 1):
        try:
            scenario = generator.read(text, reading)
            first = generator.write(scenario, reading)
            written, _ = climb(generator, scenario, first, settings=reading, simulator=carla, ego=ego)
        except ChatSceneError as error:
            click.echo(f"{number:3} does not run: {type(error).__name__}: {error}: {text}")
            continue
        pairs = list(compared(written.program, scenes, route=0, seed=seed, ego=ego, simulators=simulators))
        ran, driven = ran + 1, driven + len(pairs)
        collided += sum(pair[0].collided for pair in pairs)
        here = [sum(not pair[way].difference for pair in pairs) for way in (0, 1)]
        click.echo(f"{number:3} {len(pairs)} scenes, agree {here[0]} {others[0]}, {here[1]} {others[1]}: {text}")
        for way in (0, 1):
            agree[way] += here[way]
            apart[way] += [pair[way].apart for pair in pairs]
            for pair in pairs:
                if pair[way].difference:
                    click.echo(f"      {others[way]}: {pair[way].scene.id}: {pair[way].difference}")
    click.echo(f"{ran} of {len(texts)} sentences run; {driven} scenes, {collided} collide in the server")
    for way in (0, 1):
        ordered = sorted(apart[way])
        click.echo(
            f"beside the embedded simulator {others[way]}: {agree[way]} of {driven} agree "
            f"({agree[way] / max(driven, 1):.3f}); actors are apart by {ordered[len(ordered) // 2]:.5f} m in the "
            f"median and {ordered[-1]:.3f} m at most"
        )
    for disagreement in getattr(carla, "disagreements"):  # noqa: B009
        click.echo(f"sensor: {disagreement}")


if __name__ == "__main__":
    main()
