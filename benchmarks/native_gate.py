"""Whether the simulator `native` gives the embedded one's numbers: every number of every drive, and how fast.

    python benchmarks/native_gate.py [--programs 240] [--scenes 3] [--seed 0] [--ego rule-based] [--speed 0]
        [--budget 480] [--in-turn] [--situations FILE] [--drawn]

Each program is a behavior of the library with a geometry and a spawn that are drawn among those it can be joined with,
every behavior in turn. Each is driven in scenes drawn from its ranges, on a route of its geometry that is drawn too, by
every ego; with `--in-turn`, each scene by one of the egos in turn. `--situations FILE` takes programs that are built of
the situations of a file (`tests/build/written.yaml`) instead; `--drawn` takes `--programs` that are built of random
situations, which `building.py` draws by the seed, without those that cannot be or are not built. The first scene of a
program is placed by Scenic, the others by what was learned of it where that can be, which is counted. Both episodes
must agree in every number of every track, every event, signal, offset, flag and the ending. What took the embedded path
in `native` is not compared, and is counted by reason; one that fails has to fail alike in both. At the end, the
processor time of both in this process, from the opened scene to its end, of the drives that were compared.
"""

from __future__ import annotations

import random
import time
from collections import Counter, defaultdict
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from types import SimpleNamespace

import click
import numpy as np
import yaml
from building import drawn
from differing import differences

from chatscene.build.build import build
from chatscene.build.possible import impossible
from chatscene.ego.asking import wanting
from chatscene.ego.policy import EgoPolicy, load_ego, observation_of, pedals_of
from chatscene.errors import ChatSceneError, DoesNotCompile, MapError, ProgramError
from chatscene.library.compatibility import compatibility
from chatscene.library.load import library_with
from chatscene.maps.network import resolve_map
from chatscene.program.assemble import assemble
from chatscene.program.sample import draw, scene_seed
from chatscene.settings import SimulationSettings
from chatscene.simulate.native.binding import ORDER
from chatscene.simulate.native.simulator import NativeSession, NativeSimulator
from chatscene.simulate.simulator import Session, Simulator, drive, load_simulator
from chatscene.situations.form import from_plain
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.episode import Episode
from chatscene.terms.scenario import Scenario, Slots, SubDescriptions
from chatscene.terms.scene import Rejected, Scene, ScenicProgram

MAPS = ("town", "outskirts", "region")


@dataclass
class Tally:
    """What came of an ego's drives."""

    tried: int = 0
    rejected: int = 0
    compared: int = 0
    identical: int = 0
    steps: int = 0
    agent_steps: int = 0
    reference: float = 0.0
    native: float = 0.0
    learned: int = 0
    reasons: Counter[str] = field(default_factory=Counter)
    endings: Counter[str] = field(default_factory=Counter)
    primitives: Counter[str] = field(default_factory=Counter)
    programs: set[str] = field(default_factory=set)
    differing: list[str] = field(default_factory=list)


def programs(count: int, rng: np.random.Generator) -> Iterator[ScenicProgram]:
    """Programs of the library, every behavior in turn."""
    joint = compatibility(library_with())
    order = [int(b) for b in rng.permutation(len(joint.behaviors)) if joint.mask[b].any()]
    made = 0
    while made < count:
        for b in order[: count - made]:
            made += 1
            behavior = joint.behaviors[b]
            pairs = np.argwhere(joint.mask[b])
            g, s = pairs[rng.integers(len(pairs))].tolist()
            geometry, spawn = joint.geometries[g], joint.spawns[s]
            kinds = sorted(set(behavior.adversaries) & set(spawn.adversaries))
            kind: AdversaryKind = kinds[rng.integers(len(kinds))]
            parts = SubDescriptions(behavior=behavior.id, geometry=geometry.id, spawn=spawn.id)
            scenario = Scenario(id=f"gate-{made}", text="gate", base=None, parts=parts, slots=Slots())
            yield assemble(scenario, (behavior, geometry, spawn), kind)


def built(path: Path) -> Iterator[ScenicProgram]:
    """Programs of the situations of a file."""
    for number, one in enumerate(yaml.safe_load(path.read_text(encoding="utf-8"))):
        one.pop("name", None)
        try:
            yield build(from_plain(one), name=f"gate-{number}").program
        except ChatSceneError as error:
            print(f"situation {number} is not built: {error}")


def built_of_drawn(count: int, seed: int) -> Iterator[ScenicProgram]:
    """As many programs, built of situations at random."""
    rng, made, tried = random.Random(seed), 0, 0
    while made < count:
        tried += 1
        situation = drawn(rng)
        if any(True for _ in impossible(situation)):
            continue
        try:
            yield build(situation, name=f"drawn-{tried}").program
        except ChatSceneError:
            continue
        made += 1


def scenes(program: ScenicProgram, simulator: Simulator, count: int, seed: int) -> Iterator[Scene]:
    """Scenes drawn from a program's ranges, on a route that is drawn."""
    route = scene_seed(seed, program.scenario_id) % simulator.routes(program)
    for i in range(count):
        name = f"{program.scenario_id}/{i}"
        own = scene_seed(seed, name)
        values = draw(program.parameters, seed=own)
        yield Scene(id=name, scenario_id=program.scenario_id, route=route, block=0, seed=own, values=values)


def driven(
    simulator: Simulator, program: ScenicProgram, scene: Scene, ego: EgoPolicy
) -> tuple[Session, Episode, float] | str:
    """An opened scene driven to its end; or why there is none. The seconds are the processor's, of the drive alone."""
    try:
        session = simulator.open(program, scene, observation=observation_of(ego), pedals=pedals_of(ego))
    except ProgramError as error:
        return f"fails: {error}"
    if isinstance(session, Rejected):
        return session.reason
    try:
        began = time.thread_time()
        drive(session, ego, scene.id)
        spent = time.thread_time() - began
        return session.rejection or (session, session.episode(scene.id, "ego"), spent)
    except ProgramError as error:
        return f"fails: {error}"
    finally:
        session.close()


def compare(
    native: NativeSimulator, embedded: Simulator, program: ScenicProgram, scene: Scene, ego: EgoPolicy, tally: Tally
) -> None:
    tally.tried += 1
    ours = driven(native, program, scene, ego)
    if not isinstance(ours, str) and (reason := ours[1].stepped.instead):
        tally.reasons[reason] += 1
        return
    theirs = driven(embedded, program, scene, ego)
    if isinstance(ours, str) or isinstance(theirs, str):
        tally.rejected += 1
        if ours != theirs:
            tally.differing.append(f"{scene.id} {program.snippet_ids}: {ours} against {theirs}")
        return
    (session, mine, spent), (_, other, reference) = ours, theirs
    assert isinstance(session, NativeSession)
    tally.compared += 1
    tally.learned += isinstance(session._reference.simulation.scene, SimpleNamespace)
    tally.programs.add(program.digest)
    world = session._bound.world
    for agent in world.agent[: world.agents]:  # of a loop, its phases count as begun in one round at most
        tally.primitives.update(ORDER[agent.list[i].primitive] for i in range(min(agent.phase + 1, agent.phases)))
    tally.endings[str(mine.ending)] += 1
    tally.steps += session.step_number
    tally.agent_steps += session.step_number * int(sum(bool(np.ptp(t.x) or np.ptp(t.y)) for t in mine.tracks))
    tally.native += spent
    tally.reference += reference
    if apart := differences(mine, other):
        tally.differing.append(f"{scene.id} {program.snippet_ids}: {'; '.join(apart)}")
    else:
        tally.identical += 1


def show(name: str, tally: Tally) -> None:
    print(
        f"\n{name}: {tally.tried} drives tried, {tally.rejected} rejected by both alike, {tally.compared} compared "
        f"of {len(tally.programs)} programs, {tally.identical} identical, {tally.learned} of them placed "
        f"without Scenic; endings {dict(tally.endings)}"
    )
    print("  phases begun:", ", ".join(f"{primitive} {times}" for primitive, times in tally.primitives.most_common()))
    for reason, times in tally.reasons.most_common():
        print(f"  not covered, {times} drives: {reason}")
    for line in tally.differing[:20]:
        print(f"  DIFFERS: {line}")
    if tally.native:
        print(
            f"  {tally.steps} steps, {tally.agent_steps} agent-steps (of those that move at all); the drive alone: "
            f"embedded {tally.agent_steps / tally.reference:,.0f}, native {tally.agent_steps / tally.native:,.0f} "
            f"agent-steps/s of processor time, {tally.reference / tally.native:.0f} times"
        )


@click.command()
@click.option("--programs", "count", default=240)
@click.option("--scenes", "each", default=3)
@click.option("--seed", default=0)
@click.option("--ego", "egos", multiple=True, default=("rule-based",))
@click.option("--speed", default=0.0, help="What is wanted of each ego [km/h]; 0 leaves each at its own.")
@click.option("--in-turn", is_flag=True, help="Each scene by one of the egos, in turn, and not by all.")
@click.option("--situations", type=click.Path(path_type=Path), help="A file of situations, instead of the library.")
@click.option("--drawn", "at_random", is_flag=True, help="Programs of situations at random, instead of the library.")
@click.option("--budget", default=480.0, help="Processor seconds after which no further program is begun.")
def main(
    count: int,
    each: int,
    seed: int,
    egos: tuple[str, ...],
    speed: float,
    in_turn: bool,
    situations: Path | None,
    at_random: bool,
    budget: float,
) -> None:
    """Compare the two simulators, and say how many drives were identical."""
    settings = SimulationSettings()
    pairs = [(NativeSimulator(path, settings), load_simulator(path, settings)) for path in map(resolve_map, MAPS)]
    if pairs[0][0].missing:
        raise SystemExit(f"there is no engine: {pairs[0][0].missing}")
    drivers = {name: wanting(load_ego(name), speed / 3.6 if speed else None) for name in egos}
    tallies: dict[str, Tally] = defaultdict(Tally)
    failed: Counter[str] = Counter()
    tried, driven_scenes, why = 0, 0, ""
    asked = programs(count, np.random.default_rng(seed))
    if situations or at_random:
        asked = built(situations) if situations else built_of_drawn(count, seed)
    for program in asked:
        if time.process_time() > budget:
            break
        tried += 1
        for native, embedded in pairs:  # the first map that has such a place
            try:
                for scene in scenes(program, embedded, each, seed):
                    for name in [egos[driven_scenes % len(egos)]] if in_turn else egos:
                        compare(native, embedded, program, scene, drivers[name], tallies[name])
                    driven_scenes += 1
            except (MapError, DoesNotCompile) as error:
                why = str(error)
                continue
            break
        else:
            failed[why[:100]] += 1
    print(f"{tried} programs, {each} scenes each, seed {seed}; {sum(failed.values())} do not run: {dict(failed)}")
    for name, tally in tallies.items():
        show(name, tally)
    raise SystemExit(any(tally.differing for tally in tallies.values()))


if __name__ == "__main__":
    main()
