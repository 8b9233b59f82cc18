"""Measure: whether a scene shows what was said, how often it ends in a crash, how egos fare."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from chatscene import runs
from chatscene.api.arguments import Name, Names, again, folder_for, judging, names_of, path_of, read_by
from chatscene.api.results import Run, again_of, folder_of, folders_of, run_again
from chatscene.errors import SettingsError
from chatscene.runs.executor import Workers
from chatscene.runs.progress import Progress, silent
from chatscene.settings import EXECUTOR, MANY, SEEDS, SPEEDS, RetrievalSettings, finite, whole
from chatscene.terms.situation import Situation

if TYPE_CHECKING:
    from chatscene.runs.rate import Rate
    from chatscene.studies.collection import Compared
    from chatscene.studies.evaluation import Evaluated
    from chatscene.verdict.verdict import Verdict


def verify(
    what: Name | Run,
    said: str | Path | Situation | None = None,
    *,
    draws: int | None = None,
    seed: int | None = None,
    least: float | None = None,
    ego: Name | None = None,
    map: Name | None = None,  # noqa: A002 - the word of the command line
    trust: bool = False,
    as_written: bool = False,
    ego_id: str | None = None,
    scene: str | None = None,
    param: Mapping[str, object] | None = None,
    variant: int | None = None,
    budget: float | None = None,
    within: Name | None = None,
    page: Name | None = None,
    library: Name | None = None,
    embedder: str | None = None,
    language_model: str | None = None,
    reader: str | None = None,
    reading: int | None = None,
    set: Mapping[str, object] | None = None,  # noqa: A002 - the word of the command line
    generator: Names = (),
    simulator: Names = (),
) -> Verdict:
    """Check from the tracks whether a program, a run or a recording shows what was said, fact by fact.

    Args:
        what: A Scenic program (``.scenic``) or a file of OpenSCENARIO (``.xosc``), which run in the sandbox; a run; a
            table of tracks (``.csv``); or a trace of ASAM OSI (``.mcap``).
        said: A sentence, a situation, or the file of a situation or a report; None for the run's own text.
        draws: Number of drives of a program to judge, or of scenes of a run.
        seed: Seed of their values.
        least: Share of the drives that must show a fact, among those that reached it.
        ego: The ego that drives a program; None for its own ego, or the default one if it has none or was imported.
        map: The map of a program, in place of the one that it names.
        trust: Whether a program may use all of Scenic and Python, in this process.
        as_written: Whether the program's own ego drives; an imported one drives as its file says.
        ego_id: Id of the ego in a recording; None for the one that is marked.
        scene: Id of a scene of a run; None for all its kept scenes.
        param: Values, by name, of parameters that a program uses and does not define, or that an OpenSCENARIO file
            declares.
        variant: Number of a set in a file of parameter values, from 1; None spreads the drives over all sets.
        budget: Processor time [s] for scenes that cannot be driven, over all drives.
        within: Folder outside which a program's map and catalogs may not lie; None for anywhere.
        page: File for a page with the moment of each fact; None for none.
        library: Snippet folder of the run, repeated if it has one. For all else it is refused: snippets have no facts
            to be judged by.
        embedder: As `explain`.
        language_model: As `explain`.
        reader: As `explain`.
        reading: As `explain`.
        set: Further facts, by path; for a text also by name.
        generator: Generator of the run, repeated if it is not packaged.
        simulator: Simulator of the run, repeated if it is not packaged.

    Raises:
        NothingFits: The text is not understood well enough.
        ChatSceneError: It cannot be read or driven.
    """
    from chatscene.verdict.page import write_page
    from chatscene.verdict.said import asked
    from chatscene.verdict.sources import watching
    from chatscene.verdict.verify import weighed

    settings = judging(
        trust=trust,
        map_name=map,
        ego=ego,
        within=within,
        as_written=as_written or None,
        draws=draws,
        seed=seed,
        least=least,
        ego_id=ego_id,
        scene_id=scene,
        given=param,
        variant=variant,
        budget=budget,
    )
    path, repeated = run_again(what, generator=generator, simulator=simulator, library=library or ())
    own = None if os.path.isdir(path) else library  # noqa: PTH112 - Path.is_dir() raises for what is too long
    chosen = read_by(RetrievalSettings(), own, embedder, language_model, reader, reading)
    wanted = asked(_made_of(path) if said is None else said, chosen, set)
    found = watching(path, settings, repeated)
    verdict = weighed(found, str(path), wanted, settings)
    if page is not None:
        write_page(path_of(page), verdict, found.drawing)
    return verdict


def _made_of(folder: Path) -> Situation:
    """The situation that a run was made of."""
    from chatscene.situations.file import read_text
    from chatscene.verdict.sources import check_there

    check_there(folder)
    if not folder.is_dir():
        raise SettingsError(f"say what {folder} should show: a sentence, a situation or a report")
    record = runs.read_record(runs.open_run(folder, runs.RunRecord))
    if record.situation is None:
        raise SettingsError(f"{folder} has no situation; say what it should show")
    return read_text(record.situation.text)


def rate(
    folder: Name | Run,
    *,
    scenes: int = 200,
    seed: int = 0,
    exposure: Name | None = None,
    jobs: int = 1,
    executor: str = EXECUTOR,
    progress: Progress = silent,
    ego: Names = (),
    generator: Names = (),
    simulator: Names = (),
    library: Names = (),
) -> Rate:
    """Estimate how often a run's situation, if it occurs, ends in a crash, and in an avoidable one.

    Args:
        folder: A run, or its folder; its ego drives.
        scenes: Number of scenes to draw in addition to the run's.
        seed: Seed of these scenes.
        exposure: TOML file with a density per parameter; without it, all values of a range are equally frequent.
        jobs: Number of worker processes; any number gives the same result.
        executor: As `run`.
        progress: Called with what is done.
        ego: Ego of the run, repeated if it may run its own code.
        generator: Generator of the run, repeated if it is not packaged.
        simulator: Simulator of the run, repeated if it is not packaged.
        library: Snippet folder of the run, repeated if it has one.

    Raises:
        RunError: There is no run, it has no program, or it names code that must be repeated.
        SettingsError: The exposure cannot be read, or has other parameters or units.
    """
    from chatscene.runs.rate import rate as rate_of
    from chatscene.search.exposure import read_exposure

    scenes, seed = whole("scenes", scenes, 0, MANY[1]), whole("seed", seed, *SEEDS)
    repeated = again_of(folder, ego=ego, generator=generator, simulator=simulator, library=library)
    densities = () if exposure is None else read_exposure(path_of(exposure))
    return rate_of(
        folder_of(folder),
        scenes=scenes,
        seed=seed,
        densities=densities,
        workers=Workers(jobs, executor),
        progress=progress,
        repeated=repeated,
    )


def evaluate(
    scenes: Run | Name | Sequence[Run | Name],
    folder: Name | None = None,
    *,
    ego: Names = (),
    as_written: bool = False,
    all: bool = False,  # noqa: A002 - the word of the command line
    simulator: str | None = None,
    physics: str | None = None,
    speed: float | None = None,
    jobs: int = 1,
    executor: str = EXECUTOR,
    generator: Names = (),
    library: Names = (),
    progress: Progress = silent,
) -> Evaluated | Compared:
    """Compare egos on the kept scenes of runs; makes the paper's tables, with intervals.

    In an imported folder (`chatscene import FOLDER --out DIR`), each ego drives every program on its own map.

    Args:
        scenes: Runs, or folders with runs somewhere below; or one folder that was imported.
        folder: Folder of the evaluation: new, empty, or one to continue.
        ego: Egos by name, file or ``package.module:factory``; `planner`, `idm` and `sac` if none is given.
        as_written: Whether each program of an imported folder is also driven as its file says; without an ego, only so.
        all: Whether every scene that ran is driven, not only the kept ones.
        simulator: Simulator of the drives; that of the runs if None.
        physics: How vehicles respond to pedals and steering: ``kinematic`` or ``lagged``; that of the runs if None.
        speed: Speed of the egos [km/h] in scenes whose text gives none; None for that of the runs.
        jobs: As `run`.
        executor: As `run`.
        generator: Generators of the runs, repeated if they are not packaged.
        library: Snippet folders of the runs, repeated if they have any.
        progress: Called with what is done.

    Raises:
        RunError: A run is not finished, the runs were not simulated alike, or one names code that must be repeated.
        EgoError: An ego cannot be loaded.
        SettingsError: An option that only applies to runs was given for an imported folder.
    """
    from chatscene.imports.collection import is_collection
    from chatscene.studies import evaluation

    speed = None if speed is None else finite("speed", speed, *SPEEDS)
    sources = folders_of(scenes)
    if any(map(is_collection, sources)):
        from chatscene.studies.collection import Driving, evaluate_collection

        if len(sources) > 1 or all or simulator or names_of(generator) or names_of(library):
            raise SettingsError(
                "an imported folder is evaluated alone, in the sandbox: give no other folder, and no `all`, "
                "`simulator`, `generator` or `library`"
            )
        egos = names_of(ego) or (() if as_written else evaluation.COMPARED)
        driving = Driving(egos=egos, as_written=as_written, physics=physics or "", speed=speed)
        return evaluate_collection(
            sources[0], folder_for(folder), driving, workers=Workers(jobs, executor), progress=progress
        )
    if as_written:
        raise SettingsError("`as_written` is for an imported folder")
    return evaluation.evaluate(
        sources,
        folder_for(folder),
        egos=names_of(ego) or evaluation.COMPARED,
        every_scene=all,
        simulator=simulator or "",
        physics=physics or "",
        speed=speed,
        workers=Workers(jobs, executor),
        progress=progress,
        repeated=again(generator=generator, library=library),
    )
