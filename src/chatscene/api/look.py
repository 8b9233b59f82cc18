"""Look at scenes: driven again, explained, told in words, asked about in SQL."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from typing import TYPE_CHECKING

from chatscene.api.arguments import Name, Names, judging
from chatscene.api.results import Run, again_of, folder_of, run_again

if TYPE_CHECKING:
    from chatscene.runs.replay import Replayed
    from chatscene.runs.tables import Table
    from chatscene.runs.why import Why
    from chatscene.verdict.story import Story


def replay(
    folder: Name | Run,
    scene_id: str | None = None,
    *,
    ego: Names = (),
    generator: Names = (),
    simulator: Names = (),
    library: Names = (),
    watch: bool = False,
    record: bool = False,
) -> Replayed:
    """Simulate a scene of a run again from its stored values, and compare every number of every track.

    Args:
        folder: A run, or its folder.
        scene_id: Id of the scene; None for the first scene of the report.
        ego: Ego of the run, repeated if it may run its own code.
        generator: Generator of the run, repeated if it is not packaged.
        simulator: Simulator of the run, repeated if it is not packaged.
        library: Snippet folder of the run, repeated if it has one.
        watch: Whether the window of a CARLA server looks down on the ego.
        record: Whether a CARLA server's recorder writes a file below ``recordings`` in the folder.

    Raises:
        RunError: The run has no such scene, it was never driven, or the run names code that must be repeated.
        SettingsError: The simulator has no window or no recorder.
    """
    from chatscene.runs.replay import replay as replay_scene

    repeated = again_of(folder, ego=ego, generator=generator, simulator=simulator, library=library)
    path = folder_of(folder)
    return replay_scene(path, scene_id or Run(path).best.id, repeated=repeated, watch=watch, record=record)


def why(
    folder: Name | Run,
    scene_id: str | None = None,
    *,
    ego: Names = (),
    generator: Names = (),
    simulator: Names = (),
    library: Names = (),
) -> Why:
    """Explain why a scene of a run crashed by driving variants of it: who struck whom, what decides, what avoids it.

    Args:
        folder: A run, or its folder.
        scene_id: Id of the scene; None for the first scene of the report.
        ego: Ego of the run, repeated if it may run its own code.
        generator: Generator of the run, repeated if it is not packaged.
        simulator: Simulator of the run, repeated if it is not packaged.
        library: Snippet folder of the run, repeated if it has one.

    Raises:
        RunError: The run has no such scene, the scene does not crash, or the run names code that must be repeated.
    """
    from chatscene.runs.why import why as why_crashed

    repeated = again_of(folder, ego=ego, generator=generator, simulator=simulator, library=library)
    path = folder_of(folder)
    return why_crashed(path, scene_id or Run(path).best.id, repeated=repeated)


def story(
    what: Name | Run,
    *,
    scene: str | None = None,
    seed: int | None = None,
    ego: Name | None = None,
    map: Name | None = None,  # noqa: A002 - the word of the command line
    trust: bool = False,
    as_written: bool = False,
    ego_id: str | None = None,
    param: Mapping[str, object] | None = None,
    variant: int | None = None,
    within: Name | None = None,
    generator: Names = (),
    simulator: Names = (),
    library: Names = (),
) -> Story:
    """What happened in a drive of a program, a run or a recording, in words, with times and speeds.

    The answer prints as lines; its `picture` is a moment from above.

    Args:
        what: As in `verify`; a program is driven once.
        scene: Id of a scene of a run; None for its first kept scene.
        seed: Seed of a program's values.
        ego: The ego that drives a program; None for its own ego, or the default one if it has none or was imported.
        map: The map of a program, in place of the one that it names.
        trust: Whether a program may use all of Scenic and Python, in this process.
        as_written: Whether the program's own ego drives; an imported one drives as its file says.
        ego_id: Id of the ego in a recording; None for the one that is marked.
        param: As `verify`.
        variant: Number of a set in a file of parameter values, from 1; None for the first.
        within: Folder outside which a program's map and catalogs may not lie; None for anywhere.
        generator: Generator of the run, repeated if it is not packaged.
        simulator: Simulator of the run, repeated if it is not packaged.
        library: Snippet folder of the run, repeated if it has one.

    Raises:
        ChatSceneError: It cannot be read or driven, or has no such scene.
    """
    from chatscene.verdict.story import story as told

    settings = judging(
        trust=trust,
        map_name=map,
        ego=ego,
        within=within,
        as_written=as_written or None,
        seed=seed,
        ego_id=ego_id,
        scene_id=scene,
        given=param,
        variant=variant,
    )
    path, repeated = run_again(what, generator=generator, simulator=simulator, library=library)
    return told(path, settings, repeated)


def sql(query: str, folder: Name | Run = "runs") -> Table:
    """The answer to a query over all runs below a folder: an Arrow table. Needs the extra ``sql``.

    Args:
        query: A SELECT in DuckDB's SQL over the tables runs, facts, scenes, parameters and events; nothing else can be
            read, and nothing written.
        folder: A run, its folder, or a folder with run folders somewhere below.

    Raises:
        MissingExtra: The extra is not installed.
        QueryError: It is not SQL, names something that does not exist, or would do more than read these tables.
        RunError: There is no run in the folder.

    Warns:
        RuntimeWarning: For each folder that is left out, with the reason: it is damaged or unfinished.
    """
    from chatscene.report.index import index
    from chatscene.report.sql import ask

    found = index(folder_of(folder))
    for one in found.left_out:
        warnings.warn(str(one), RuntimeWarning, stacklevel=2)
    return ask(query, found)
