"""The whole method on one screen (paper, figure 1): nine calls, of which a sentence meets the middle six here.

1. describe: a base scenario to sentences, `chatscene.sentences.describe`;
2. read, 3. interpret and 4. assemble and check: a sentence to a program that shows what was read, `understand`;
5. simulate and 6. refine: blocks of scenes, each block drawn from where the last one hit;
7. select: the scenes worth testing on;
8. evaluate: egos on those of many runs, `chatscene.studies.evaluation.evaluate`;
9. finetune: an ego that survives them, `chatscene.learn.finetune.finetune`.
"""

from __future__ import annotations

from functools import partial
from pathlib import Path

from chatscene import runs
from chatscene.ego.policy import cut_off
from chatscene.report.animation import if_drawn, write_gif
from chatscene.report.summary import Summary
from chatscene.report.understood import understand
from chatscene.report.viewer import write_report
from chatscene.runs.executor import ONE, Workers
from chatscene.runs.progress import Progress, Slowly, silent
from chatscene.runs.searching import Common, Desk, Search, search_all
from chatscene.runs.trust import Repeated, follow
from chatscene.runs.working import working
from chatscene.simulate.simulator import check_jobs, telling

__all__ = ["resume", "run", "search", "understand"]


def run(asked: runs.RunRecord, folder: Path, *, workers: Workers = ONE, progress: Progress = silent) -> Summary:
    """Steps 2 to 7 and the report, for what `chatscene.runs.asked_run` worked out, into a new folder or on in its own.

    Raises:
        NothingFits: The library cannot serve the sentence; the folder says why.
        ChatSceneError: Anything else that went wrong; the folder can be resumed.
    """
    check_jobs(runs.settings_of(asked).simulation, workers.jobs)
    with runs.alone(folder):
        return _carry_on(runs.take_up(folder, asked), workers, progress)


def resume(
    folder: Path, *, workers: Workers = ONE, progress: Progress = silent, repeated: Repeated | None = None
) -> Summary:
    """Go on with a run that was killed or failed; the result is that of an uninterrupted one.

    Raises:
        RunError: There is no run in the folder, it is damaged, another process is at work on it, or it names what must
            be repeated (`chatscene.runs.trust.follow`).
    """
    kept = runs.open_run(folder, runs.RunRecord)
    follow(repeated or Repeated(), egos_of=[kept], simulators_of=[kept], reading_of=[kept])
    check_jobs(runs.settings_of(runs.read_record(kept)).simulation, workers.jobs)
    with runs.alone(folder):
        return _carry_on(kept, workers, progress)


def _carry_on(kept: runs.Workspace, workers: Workers, progress: Progress) -> Summary:
    if not runs.is_drawn_up(kept):
        with working(kept, progress) as tell:
            search(kept, workers, tell)
            tell("writing the report", 0, 0)
            write_report(kept.path, followed=True)
            if_drawn(f"the animation in {kept.path}", lambda: write_gif(kept.path))
    return Summary.of(kept)


def search(kept: runs.Workspace, workers: Workers, progress: Progress) -> None:
    """Steps 2 to 7 for a run folder, from where it stands."""
    cut_off.clear()
    done = runs.resume(kept, told=lambda said: progress(said, 0, 0))
    record = runs.read_record(kept)
    if record.status is runs.Status.DONE:
        return
    common = Common.of(record)
    one = Search(run=kept, record=record, settings=common.settings.search, done=done)
    one.prepare(Desk(common).prepare(record, partial(runs.write_choice, kept), progress))
    scenes = len(one.prepared.routes) * one.settings.scenes if one.prepared else 0
    slowly = Slowly(lambda driven: progress("searching, scenes", min(one.scenes_kept + driven, scenes), scenes))
    progress("searching, scenes", one.scenes_kept, scenes)
    with telling(slowly):
        for _ in search_all([one], workers=workers):
            slowly.begin()
            progress("searching, scenes", one.scenes_kept, scenes)
