"""The run folder, a public contract: written as the run goes, continued after a kill, read by anyone.

::

    run = create(folder, asked_run("a pedestrian …", settings=...))
    write_choice(run, scenario, written); write_drawing(run, ...)
    write_block(run, block)                     # for each block, as it is done
    rows = read_scenes(run)                     # to select from
    finish(run, selected={"…/scene-017": False}, expected=[("…", 0, 0)])

    with alone(folder):                                     # after a kill
        run = open_run(folder); done = resume(run)
    episode = read_episode(run, "…/scene-017")              # exactly as simulated

`docs/run-folder.md` lists the files and their columns.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from chatscene.runs.asked import (
        asked_benchmark,
        asked_evaluation,
        asked_run,
        ego_digests,
        scenario_of,
    )
    from chatscene.runs.blocks import (
        done_blocks,
        drop_blocks,
        each_scene,
        finish,
        read_adversaries,
        read_counts,
        read_episode,
        read_episodes,
        read_events,
        read_ranges,
        read_scenes,
        resume,
        write_block,
    )
    from chatscene.runs.checking import Condition, check
    from chatscene.runs.drawing import read_drawing, write_drawing
    from chatscene.runs.exclusive import alone
    from chatscene.runs.explanation import explain, read_choice, read_explanation, write_choice
    from chatscene.runs.record import (
        SCHEMA_VERSION,
        BenchmarkRecord,
        ComparisonRecord,
        Driven,
        EvaluationRecord,
        FinetuningRecord,
        Kind,
        LessonsRecord,
        MapRecord,
        ProgramRecord,
        Record,
        ReproductionRecord,
        RunRecord,
        SimulatorRecord,
        SituationRecord,
        SourceRecord,
        Status,
        TrainingRecord,
        settings_from,
        settings_of,
    )
    from chatscene.runs.tables import (
        criticality_of,
        measurements_of,
        metrics_of,
        route_index,
        scene_of,
        speeds_of,
    )
    from chatscene.runs.workspace import (
        Workspace,
        changed_versions,
        create,
        free_folder,
        is_drawn_up,
        note,
        open_run,
        read_programs,
        read_record,
        require_done,
        run_folders,
        standing,
        take_up,
        update,
        write_program,
    )

__all__ = [
    "SCHEMA_VERSION",
    "BenchmarkRecord",
    "ComparisonRecord",
    "Condition",
    "Driven",
    "EvaluationRecord",
    "FinetuningRecord",
    "Kind",
    "LessonsRecord",
    "MapRecord",
    "ProgramRecord",
    "Record",
    "ReproductionRecord",
    "RunRecord",
    "SimulatorRecord",
    "SituationRecord",
    "SourceRecord",
    "Status",
    "TrainingRecord",
    "Workspace",
    "alone",
    "asked_benchmark",
    "asked_evaluation",
    "asked_run",
    "changed_versions",
    "check",
    "create",
    "criticality_of",
    "done_blocks",
    "drop_blocks",
    "each_scene",
    "ego_digests",
    "explain",
    "finish",
    "free_folder",
    "is_drawn_up",
    "measurements_of",
    "metrics_of",
    "note",
    "open_run",
    "read_adversaries",
    "read_choice",
    "read_counts",
    "read_drawing",
    "read_episode",
    "read_episodes",
    "read_events",
    "read_explanation",
    "read_programs",
    "read_ranges",
    "read_record",
    "read_scenes",
    "require_done",
    "resume",
    "route_index",
    "run_folders",
    "scenario_of",
    "scene_of",
    "settings_from",
    "settings_of",
    "speeds_of",
    "standing",
    "take_up",
    "update",
    "write_block",
    "write_choice",
    "write_drawing",
    "write_program",
]

_NAMES = {
    "asked": "asked_benchmark asked_evaluation asked_run ego_digests scenario_of",
    "blocks": (
        "done_blocks drop_blocks each_scene finish read_adversaries read_episode read_episodes read_events "
        "read_counts read_ranges read_scenes resume write_block"
    ),
    "checking": "Condition check",
    "drawing": "read_drawing write_drawing",
    "exclusive": "alone",
    "explanation": "explain read_choice read_explanation write_choice",
    "record": (
        "SCHEMA_VERSION BenchmarkRecord ComparisonRecord Driven EvaluationRecord FinetuningRecord Kind LessonsRecord "
        "MapRecord ProgramRecord Record ReproductionRecord RunRecord SimulatorRecord "
        "SituationRecord SourceRecord Status TrainingRecord settings_from settings_of"
    ),
    "tables": "criticality_of measurements_of metrics_of route_index scene_of speeds_of",
    "workspace": (
        "Workspace changed_versions create free_folder is_drawn_up note open_run read_programs read_record "
        "require_done run_folders standing take_up update write_program"
    ),
}
"""Names by the module that defines them, loaded when one is first used: who reads a sentence needs none of them."""

if not TYPE_CHECKING:  # else a type checker would take any name for one of ours

    def __getattr__(name: str) -> object:
        """Load a name where it is first used."""
        module = next((module for module, names in _NAMES.items() if name in names.split()), None)
        if module is None:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        found = globals()[name] = getattr(import_module(f"{__name__}.{module}"), name)
        return found
