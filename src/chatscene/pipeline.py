"""The whole method on one screen (paper, figure 1): nine calls, of which a sentence meets the middle six here.

1. describe: a base scenario to sentences, `chatscene.sentences.describe`;
2. read, 3. interpret and 4. assemble and check: a sentence to a program that shows what was read, `understand`;
5. simulate and 6. refine: blocks of scenes, each block drawn from where the last one hit;
7. select: the scenes worth testing on;
8. evaluate: egos on those of many runs, `chatscene.studies.evaluation.evaluate`;
9. finetune: an ego that survives them, `chatscene.learn.finetune.finetune`.
"""

from __future__ import annotations

from pathlib import Path

from chatscene import runs
from chatscene.ego.policy import load_ego
from chatscene.maps.drawing import routes_drawing
from chatscene.maps.network import load_network
from chatscene.report.animation import write_gif
from chatscene.report.summary import Summary
from chatscene.report.understood import understand
from chatscene.report.viewer import write_report
from chatscene.runs.parallel import Work, run_blocks
from chatscene.runs.progress import Progress, silent
from chatscene.runs.rebuild import map_of
from chatscene.runs.selection import selected
from chatscene.runs.trust import Repeated, follow
from chatscene.runs.working import working
from chatscene.search.climb import climb, simulator_of
from chatscene.search.generator import load_generator
from chatscene.simulate.simulator import check_jobs, routes_of

__all__ = ["resume", "run", "search", "understand"]


def run(asked: runs.RunRecord, folder: Path, *, jobs: int = 1, progress: Progress = silent) -> Summary:
    """Steps 2 to 7 and the report, for what `chatscene.runs.asked_run` worked out, into a new folder or on in its own.

    Raises:
        NothingFits: The library cannot serve the sentence; the folder says why.
        ChatSceneError: Anything else that went wrong; the folder can be resumed.
    """
    check_jobs(runs.settings_of(asked).simulation, jobs)
    with runs.alone(folder):
        return _carry_on(runs.take_up(folder, asked), jobs, progress)


def resume(folder: Path, *, jobs: int = 1, progress: Progress = silent, repeated: Repeated | None = None) -> Summary:
    """Go on with a run that was killed or failed; the result is that of an uninterrupted one.

    Raises:
        RunError: There is no run in the folder, it is damaged, another process is at work on it, or it names what must
            be repeated (`chatscene.runs.trust.follow`).
    """
    kept = runs.open_run(folder, runs.RunRecord)
    follow(repeated or Repeated(), egos_of=[kept], simulators_of=[kept], reading_of=[kept])
    check_jobs(runs.settings_of(runs.read_record(kept)).simulation, jobs)
    with runs.alone(folder):
        return _carry_on(kept, jobs, progress)


def _carry_on(kept: runs.Workspace, jobs: int, progress: Progress) -> Summary:
    with working(kept, progress) as tell:
        search(kept, jobs, tell)
        tell("writing the report", 0, 0)
        write_report(kept.path)
        write_gif(kept.path)
    return Summary.of(runs.read_record(kept))


def search(kept: runs.Workspace, jobs: int, progress: Progress) -> None:
    """Steps 2 to 7 for a run folder, from where it stands."""
    done = runs.resume(kept, told=lambda said: progress(said, 0, 0))
    record = runs.read_record(kept)
    if record.status is runs.Status.DONE:
        return
    settings, map_path, ego = runs.settings_of(record), map_of(record), load_ego(record.ego)
    generator = load_generator(record.generator)
    simulator = simulator_of(generator, map_path, settings)

    progress("understanding the sentence", 0, 0)
    scenario = runs.scenario_of(record, generator)
    runs.write_choice(kept, scenario)
    written = generator.write(scenario, settings.retrieval)
    runs.write_choice(kept, scenario, written)

    if scenario.slots.site is not None:
        progress(f"driving on the map {map_path.stem!r}, for the {scenario.slots.site}", 0, 0)
    progress("checking that drives show what was read", 0, 0)
    written, _ = climb(generator, scenario, written, settings=settings.retrieval, simulator=simulator, ego=ego)
    runs.write_choice(kept, scenario, written)

    routes = routes_of(simulator, written.program, settings.search.routes)
    if len(routes) < settings.search.routes:
        progress(f"map {record.map_name!r} has {len(routes)} of the {settings.search.routes} routes asked for", 0, 0)
    named = {f"{scenario.id}/{runs.route_id(number)}": route for number, route in routes.items() if route}
    runs.write_drawing(kept, routes_drawing(load_network(map_path), named))

    work = Work.of(kept, scenario.slots, written.program, routes)
    run_blocks(work, done, jobs=jobs, progress=progress)
    runs.finish(kept, selected=selected(kept, settings.search), expected=work.blocks())
