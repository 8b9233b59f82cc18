"""What `import chatscene` gives: the verbs of the command line as functions, and what they come to.

A folder may be left out: a new one is made in the system's temporary folder then, and stays. Errors are those of
`chatscene.errors`, the same that the command line shows.
"""

from __future__ import annotations

import tempfile
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, overload

from chatscene import runs
from chatscene.errors import EditRefused, RunError, SettingsError, no_such
from chatscene.interpret.stated import in_text
from chatscene.maps.network import check_opendrive, resolve_map
from chatscene.runs.executor import Workers
from chatscene.runs.progress import Progress, silent
from chatscene.runs.trust import Repeated, follow
from chatscene.settings import (
    EGO,
    EXECUTOR,
    SIMULATOR,
    RetrievalSettings,
    Settings,
    SimulationSettings,
    VerifySettings,
)
from chatscene.terms.conflict import Conflict
from chatscene.terms.description import Description
from chatscene.terms.episode import Episode
from chatscene.terms.scenario import BaseScenario
from chatscene.terms.scene import ScenicProgram, at_speed
from chatscene.terms.situation import Situation

if TYPE_CHECKING:
    from chatscene.ego.policy import EgoPolicy
    from chatscene.exports.export import Exported
    from chatscene.imports.import_file import ImportedScenario
    from chatscene.learn.env import DrivingEnv
    from chatscene.learn.finetune import Finetuned, FinetuneSettings
    from chatscene.learn.train import Trained
    from chatscene.report.stated import Stated
    from chatscene.report.summary import Summary
    from chatscene.report.understood import Understood
    from chatscene.runs.rate import Rate
    from chatscene.runs.replay import Replayed
    from chatscene.runs.tables import Table
    from chatscene.runs.why import Why
    from chatscene.search.generators.foreign import ForeignProgram
    from chatscene.studies.benchmark import Benchmarked
    from chatscene.studies.evaluation import Evaluated
    from chatscene.studies.reproduce import Reproduced
    from chatscene.verdict.story import Story
    from chatscene.verdict.verdict import Verdict

Name = str | Path
Names = Name | Sequence[Name]

FIRST_LOOK = 20  # scenes of a run that is made only to have its situation rated


class Run:
    """A finished run: its scenes, the ones worth keeping, and the report.

    In a notebook it shows the report, with a replay of the scenes.

    Args:
        folder: Folder that `chatscene.run` or the command left.
        ego: Ego of the run again, if it may run code of its own: that a record names one is not enough to load it.
        generator: Generator of the run again, if it is none of ours.
        sampler: Sampler of the run again, if it is none of ours.
        simulator: Simulator of the run again, if it is none of ours.
        library: Folder of snippets of the run again, if it has one.
        embedder: Embedder of the run again, if it is not the packaged one.
        language_model: Language model of the run again, if it has one.

    Attributes:
        folder: The folder.

    Raises:
        RunError: There is no run in the folder, it is not finished, or a file was changed since.
    """

    def __init__(
        self,
        folder: Name,
        *,
        ego: Names = (),
        generator: Names = (),
        sampler: Names = (),
        simulator: Names = (),
        library: Names = (),
        embedder: Names = (),
        language_model: Names = (),
    ) -> None:
        self.folder = _path(folder)
        self._repeated = _again(
            ego=ego,
            generator=generator,
            sampler=sampler,
            simulator=simulator,
            library=library,
            embedder=embedder,
            language_model=language_model,
        )
        self._workspace = runs.open_run(self.folder, runs.RunRecord)
        self._record = runs.read_record(self._workspace)
        runs.require_done(self._workspace, self._record)

    @property
    def summary(self) -> Summary:
        """How many scenes were driven, collided, left the road and were kept, and who drove."""
        from chatscene.report.summary import Summary

        counts, rows = runs.read_counts(self._workspace), runs.read_scenes(self._workspace)
        return Summary.of(self._record, counts, rows)

    @property
    def scenes(self) -> Table:
        """A row per scene, driven or rejected, with the columns of `scenes.parquet`: an Arrow table."""
        from chatscene.runs.tables import SCENES, read_table

        return read_table(self._workspace.file("scenes.parquet"), SCENES)

    @property
    def kept(self) -> tuple[DrivenScene, ...]:
        """The scenes worth keeping, the best first."""
        return tuple(self._driven(row) for row in self._ranked() if row["selected"])

    @property
    def best(self) -> DrivenScene:
        """The first scene that the report shows.

        Raises:
            RunError: None was driven.
        """
        if not (rows := self._ranked()):
            raise RunError(f"no scene of {self.folder} was driven")
        return self._driven(rows[0])

    def scene(self, scene_id: str) -> DrivenScene:
        """A scene by its id.

        Raises:
            RunError: The run has none of that id, or it was rejected and never driven.
        """
        for row in self._ranked():
            if row["scene_id"] == scene_id:
                return self._driven(row)
        raise RunError(f"{self.folder} has no scene {scene_id!r} that was driven; `scenes` lists them")

    @property
    def report(self) -> Path:
        """The report: one page that needs nothing but a browser."""
        return self._workspace.file("report.html")

    @property
    def understood(self) -> Understood | Stated:
        """How it is understood, with its edits; nothing of it is run again.

        Raises:
            EditRefused: It is a run of a program of one's own, of which nothing was read.
            RunError: It names what must be repeated.
        """
        from chatscene.report.filled import explain_text
        from chatscene.report.stated import explain_stated
        from chatscene.report.understood import understand

        record = self._record
        if record.program is not None:
            raise EditRefused(f"{self.folder} is a run of a program of one's own; only what was said can be edited")
        follow(replace(self._repeated, ego=(), simulator=()), reading_of=[self._workspace])
        if record.situation is not None:
            return explain_stated(self._situation, record.situation.read_by)
        settings = runs.settings_of(record)
        if record.generator == "chatscene" and not record.stated:  # made by a version that chose snippets, maybe
            return explain_text(record.text, settings, edits=record.edits)
        return understand(record.text, settings, generator=record.generator)

    @property
    def _situation(self) -> Situation:
        """The situation of its record, on any map that has its place if it lies on a packaged one."""
        from chatscene.search.generators.situated import on_any_map
        from chatscene.situations.file import read_text

        return on_any_map(read_text(self._record.stated))

    def edit(
        self,
        text: str,
        folder: Name | None = None,
        *,
        jobs: int = 1,
        executor: str = EXECUTOR,
        progress: Progress = silent,
    ) -> Run:
        """A new run of the same situation but for what an edit names, with the same settings, seed and ego.

        This run stays as it is: to undo the edit is to go on with this one.

        Args:
            text: What is to be another one: "make it a truck, from the left, and faster".
            folder: The new run's folder; one beside this one's if none is given.
            jobs: How many work at a time; any number gives the same files.
            executor: Who they are, one of `chatscene.runs.executor.EXECUTORS`.
            progress: Told what is done.

        Raises:
            EditRefused: The edit was not understood, contradicts itself or what stays, or changes nothing.
            NothingFits: The edited situation cannot be built, or the library cannot serve it.
            RunError: The run names what must be repeated.
        """
        from chatscene import pipeline

        asked = self._asked_with(text)
        asked = asked.model_copy(update={"edited_from": str(self.folder.resolve())})
        where = runs.free_folder(self.folder.parent, text) if folder is None else _path(folder)
        pipeline.run(asked, where, workers=Workers(jobs, executor), progress=progress)
        return Run(where, **asdict(self._repeated))

    def _asked_with(self, edit: str) -> runs.RunRecord:
        """What a run of the same situation asks for, with an edit."""
        record, made = self._record, self.understood.edit(edit)
        follow(self._repeated, egos_of=[self._workspace], simulators_of=[self._workspace], reading_of=[self._workspace])
        return runs.asked_run(
            "",
            settings=runs.settings_of(record),
            situation=made.record,
            map_name=str(made.built.map),
            ego=record.ego,
            generator="situation",
            edits=[*record.edits, edit],
        )

    @property
    def edited_from(self) -> Run:
        """The run of which this one is an edit.

        Raises:
            RunError: It is of none, or that one is not there any more.
        """
        if not self._record.edited_from:
            raise RunError(f"{self.folder} is no edit of another run")
        return Run(self._record.edited_from)

    def _ranked(self) -> list[Mapping[str, Any]]:
        from chatscene.report.viewer import ranked

        return ranked(runs.read_scenes(self._workspace))

    def _driven(self, row: Mapping[str, Any]) -> DrivenScene:
        joining = replace(self._repeated, sampler=(), embedder=(), language_model=())  # no text is read for a scene
        return DrivenScene(row=row, _workspace=self._workspace, _repeated=joining)

    @property
    def told_first(self) -> list[str]:
        """Words that were not read, and what was built otherwise than it was read; read this before any number."""
        from chatscene.report.accounting import told_first
        from chatscene.runs.explanation import read_explanation

        return told_first(read_explanation(self._workspace), self._record)

    def __str__(self) -> str:
        return "\n".join([*self.told_first, self.summary.in_words(), f"report: {self.report}"])

    def __repr__(self) -> str:
        counts = self._record.counts
        return (
            f"<Run {str(self.folder)!r}: {counts['ran']} scenes, {counts['collided']} collided, "
            f"{counts['selected']} kept>"
        )

    def _repr_html_(self) -> str:
        from chatscene.report.notebook import framed

        return framed(self.report.read_text(encoding="utf-8"))


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class DrivenScene:
    """A scene of a run that was driven.

    In a notebook it shows the drive.

    Attributes:
        row: Its row of `Run.scenes`: outcome, measures and parameters by column.
    """

    row: Mapping[str, Any]
    _workspace: runs.Workspace
    _repeated: Repeated

    @property
    def id(self) -> str:
        """Its id."""
        return self.row["scene_id"]

    @property
    def values(self) -> dict[str, float]:
        """The concrete values of the program's parameters, by name."""
        return {name: value for name, value in self.row.items() if name.startswith("OPT_") and value is not None}

    @property
    def program(self) -> str:
        """The Scenic program, whose parameters take the `values`."""
        return runs.read_programs(self._workspace)[self.row["scenario_id"]]

    @property
    def tracks(self) -> Table:
        """A row per actor and step, with the columns of the files in ``episodes/``: an Arrow table."""
        from chatscene.runs.tables import EPISODES, read_table

        place = self.row["scenario_id"], runs.route_index(self.row["route_id"]), self.row["block"]
        return read_table(self._workspace.episodes(*place), EPISODES, scene_id=self.id)

    @property
    def episode(self) -> Episode:
        """The drive as it was simulated: tracks as NumPy arrays, events, signals, how it ended."""
        return runs.read_episode(self._workspace, self.id)

    def replay(self) -> Replayed:
        """Simulate it again from its stored values, and compare every number of every track."""
        from chatscene.runs.replay import replay as replay_scene

        return replay_scene(self._workspace.path, self.id, repeated=self._repeated)

    def branch(self, at: float, ego: str | EgoPolicy) -> Episode:
        """The same drive until a moment, with another ego from then on, which has no memory of what was before.

        Args:
            at: When the other takes over [s].
            ego: Who: by name, file or ``package.module:factory``, or an object with ``act``.

        Raises:
            RunError: The run names what must be repeated.
            SimulationError: The scene cannot be driven again.
        """
        from chatscene.runs.branching import branch_scene

        return branch_scene(self._workspace.path, self.id, at=at, ego=ego, repeated=self._repeated)

    def why(self) -> Why:
        """Why it crashed, by driving it otherwise: who struck whom, what it took, how the ego avoids it.

        Raises:
            RunError: It did not crash, or the run names what must be repeated.
        """
        from chatscene.runs.why import why as why_crashed

        return why_crashed(self._workspace.path, self.id, repeated=self._repeated)

    def env(
        self,
        ego_observation: str = "safebench",
        *,
        pedals: str = "safebench",
        reward: str = "progress",
        render_mode: str | None = None,
    ) -> DrivingEnv:
        """A Gymnasium environment of this scene: every episode begins as it did. Needs the extra ``gym``.

        Args:
            ego_observation: What the ego sees, a preset of `chatscene.ego.observation`.
            pedals: Mapping of actions, one of `chatscene.ego.policy.PEDALS`.
            reward: One of `chatscene.learn.reward.REWARDS`.
            render_mode: ``rgb_array`` or None.

        Raises:
            MissingExtra: The extra is not installed.
            RunError: The run names what must be repeated.
            Diverged: This version makes another program than the one that was kept.
        """
        from chatscene.learn.env import DrivingEnv
        from chatscene.program.ordinary import Course
        from chatscene.runs.rebuild import map_of, rebuild
        from chatscene.search.climb import simulator_of
        from chatscene.search.generator import load_generator

        follow(replace(self._repeated, ego=()), simulators_of=[self._workspace], joining_of=[self._workspace])
        record = runs.read_record(self._workspace)
        map_path = map_of(record)
        _, program = rebuild(self._workspace)
        scene = runs.scene_of(self.row, program)
        return DrivingEnv(
            [Course(program=program, route=scene.route, values=scene.values)],
            map_name=map_path,
            ego_observation=ego_observation,
            pedals=pedals,
            reward=reward,
            simulator=simulator_of(load_generator(record.generator), map_path, runs.settings_of(record)),
            render_mode=render_mode,
        )

    def __repr__(self) -> str:
        outcome = "collision" if self.row["collision"] else self.row["ending"]
        return f"<DrivenScene {self.id!r}: {outcome}{', kept' * self.row['selected']}>"

    def _repr_html_(self) -> str:
        from chatscene.report.animation import animate
        from chatscene.report.notebook import picture

        record = runs.read_record(self._workspace)
        moving = animate(self.episode, runs.read_drawing(self._workspace), said=record.title, ego=record.ego)
        return picture(moving, said=self.id)


def run(
    text: str | Conflict | Situation = "",
    folder: Name | None = None,
    *,
    report: Name | None = None,
    program: Name | None = None,
    trust: bool = False,
    as_written: bool = False,
    within: Name | None = None,
    param: Mapping[str, object] | None = None,
    edit: Names | None = None,
    map: Name | None = None,  # noqa: A002 - the word of the command line
    ego: Name = EGO,
    speed: float | None = None,
    scenes: int | None = None,
    routes: int | None = None,
    seed: int | None = None,
    avoidable: bool | None = None,
    sampler: str | None = None,
    simulator: str | None = None,
    physics: str | None = None,
    library: Name | None = None,
    embedder: str | None = None,
    language_model: str | None = None,
    reader: str | None = None,
    reading: int | None = None,
    set: Mapping[str, object] | None = None,  # noqa: A002 - the word of the command line
    settings: Settings | None = None,
    jobs: int = 1,
    executor: str = EXECUTOR,
    progress: Progress = silent,
) -> Run:
    """Understand a sentence, search for crash scenes, keep the ones worth testing on, and write a report.

    Args:
        text: The sentence, a conflict of a report (`conflicts`), or a situation.
        folder: Run folder, new or empty, or one to go on in.
        report: File of a report that tells one conflict, in place of the sentence; of several, see `conflicts`.
        program: File of a Scenic program of one's own, in place of the sentence.
        trust: Whether the program may use all of Scenic and Python, in this process; else it runs in the sandbox.
        as_written: Whether the program's own ego drives; else `ego` does, on a route that follows from the program.
        within: The folder in which the map lies that the program names, if it may lie nowhere else.
        param: Values, by name, of parameters that the program uses and does not define; only with a program.
        edit: What is to differ from the text or the situation, in words: one edit, or several that are applied one
            after the other. None and ``[]`` change nothing.
        map: Packaged ``town``, ``outskirts`` or ``region``, or an ``.xodr`` file; None for the town, or for the
            outskirts where the text names what the town has not, such as a motorway. Where a program names a map that
            is there, that one is taken.
        ego: An ego by name, file or ``package.module:factory``.
        speed: What it drives at [km/h] if that was not said, whatever the road allows; None for the speed of the road.
        scenes: Simulations per scenario and route.
        routes: Routes per scenario.
        seed: What everything random derives from.
        avoidable: Whether to keep no crash that a careful driver would not have avoided.
        sampler: Who says where to look next.
        simulator: What scenes run in; ``native`` where neither this nor ``settings`` is given.
        physics: How bodies answer to pedals and wheel: ``kinematic`` or ``lagged``.
        library: Folder of one's own snippets, beside the packaged ones.
        embedder: Who measures wording.
        language_model: ``openai:MODEL`` or ``gguf:FILE``, which fills a situation from the text; or ``offline``.
        reader: ``facts``, or ``paper`` for the paper's own way, by wording alone, which refuses nothing.
        reading: Which of the readings that are offered is taken whole, from 1.
        set: Facts beside the text, by name, which are sure: ``{"side": "left"}``; of a situation, stated or
            filled, by path: ``{"others.A.starts.side": "left"}``.
        settings: All other settings; the keywords above come before them.
        jobs: How many work at a time; any number gives the same files. A script that starts more than one needs the
            guard ``if __name__ == "__main__":``.
        executor: Who they are, one of `chatscene.runs.executor.EXECUTORS`; anyone gives the same files.
        progress: Told what is done.

    Raises:
        NothingFits: It is not sure what the text says, nothing is built of it, or a model says that it tells nothing.
        ChatSceneError: Anything else that went wrong; the folder can be resumed.
    """
    from chatscene import pipeline

    if sum((bool(text), report is not None, program is not None)) > 1:
        raise SettingsError("say what to run: a text, a report or a program, and only one of them")
    _check_asked(
        program is not None,
        told=isinstance(text, Situation),
        driven=trust or as_written or bool(param),
        changed=edit is not None or bool(set),
        reading=reading or 0,
    )
    settings = settings or Settings(simulation=SimulationSettings(simulator=SIMULATOR))
    chosen = _reading(settings.retrieval, library, embedder, language_model, reader, reading)
    if report is not None:
        text = _only_conflict(report)
    from chatscene.report.filled import explain_text, is_filled, read_already
    from chatscene.report.stated import Stated, explain_stated, stated
    from chatscene.search.generators.their_map import their_map

    edits, made = _names(edit or ()), None
    on = None if map is None else str(map)
    if isinstance(text, Situation):
        made = explain_stated(stated(text, set, on, speed), edits=edits)
    elif is_filled(str(text), chosen) or (speed is not None and program is None):
        reads = replace(settings, retrieval=chosen)
        made = explain_text(str(text), reads, facts=set, edits=edits, map_name=on, speed=speed)
        chosen = read_already(chosen)
    else:
        chosen = _reading(chosen, stated=set)
    looking = _changed(
        settings.search, scenes=scenes, routes=routes, seed=seed, avoidable_only=avoidable, sampler=sampler
    )
    simulation = _changed(settings.simulation, simulator=simulator, physics=physics)
    where = _folder(folder)
    own = None if program is None else _own(_path(program), trusted=trust, as_written=as_written, given=param)
    if own and within is not None:
        own.check_map(_path(within))
    if own and speed is not None:
        own = replace(own, program=_at_speed(own.program, speed))
    if own:
        map, notes = their_map(own.map_path, None if map is None else str(map))  # noqa: A001
        for line in (*own.changed(), *notes):
            progress(f"{line}\n", 0, 0)
    situation = made.record if isinstance(made, Stated) else None
    if isinstance(made, Stated):
        map = made.built.map  # noqa: A001
    asked = runs.asked_run(
        "" if isinstance(text, Situation) else text,
        program=None if own is None else runs.ProgramRecord(name=own.program.scenario_id, source=own.program.source),
        settings=replace(settings, search=looking, simulation=simulation, retrieval=chosen),
        situation=situation,
        map_name=None if map is None else str(map),
        ego=str(ego),
        generator=_generator_of(situation, own, trusted=trust, as_written=as_written),
        edits=edits,
    )
    pipeline.run(asked, where, workers=Workers(jobs, executor), progress=progress)
    return Run(where, ego=ego, simulator=simulation.simulator, library=chosen.library or ())


def read_situation(file: Name) -> Situation:
    """The situation in a file of YAML or JSON.

    Raises:
        SituationError: It cannot be read, or is none; the message lists each fault with its line.
    """
    from chatscene.report.stated import stated

    return stated(_path(file))


@overload
def explain(text: Situation, **options: Any) -> Stated: ...
@overload
def explain(
    text: str | Conflict = "",
    *,
    library: None = None,
    reader: None = None,
    settings: None = None,
    report: Name | None = None,
    edit: Names | None = None,
    embedder: str | None = None,
    language_model: str | None = None,
    reading: int | None = None,
    set: Mapping[str, object] | None = None,
) -> Stated: ...
@overload
def explain(text: str | Conflict | Situation = "", **options: Any) -> Understood | Stated: ...
def explain(  # pyright: ignore[reportInconsistentOverload] - **options are its keywords
    text: str | Conflict | Situation = "",
    *,
    report: Name | None = None,
    edit: Names | None = None,
    library: Name | None = None,
    embedder: str | None = None,
    language_model: str | None = None,
    reader: str | None = None,
    reading: int | None = None,
    set: Mapping[str, object] | None = None,  # noqa: A002 - the word of the command line
    settings: Settings | None = None,
) -> Understood | Stated:
    """How a text is understood: the situation, the words of each fact, the program. Runs nothing.

    With a library of one's own, or in the paper's way, it is the snippets that are chosen for a sentence, and why.

    As text (``print``) it reads as the command prints it; in a notebook it shows as the report does.

    Args:
        text: The sentence, a conflict of a report (`conflicts`), or a situation, of which the program is built.
        report: File of a report that tells one conflict, in place of the sentence; of several, see `conflicts`.
        edit: What is to be another than it says, in words, edit by edit, as in `run`; so does `edit` of the answer.
        library: Folder of one's own snippets, beside the packaged ones.
        embedder: Who measures wording.
        language_model: ``openai:MODEL`` or ``gguf:FILE``, which fills a situation from the text; or ``offline``.
        reader: ``facts``, or ``paper`` for the paper's own way, by wording alone, which refuses nothing.
        reading: Which of the readings that are offered is taken whole, from 1.
        set: Facts beside the text, by name, which are sure: ``{"side": "left"}``; of a situation, stated or filled, by
            path.
        settings: All other settings; the keywords above come before them.

    Raises:
        EditRefused: An edit was not understood.
        NothingFits: It is not sure what the text says, nothing is built of it, or a model says that it tells nothing.
    """
    if isinstance(text, Situation):
        from chatscene.report.stated import explain_stated, stated

        if report is not None:
            raise SettingsError("say what to explain: a situation or a report, and only one of them")
        return explain_stated(stated(text, set), edits=_names(edit or ()))
    from chatscene.report.filled import explain_text

    settings = settings or Settings()
    chosen = _reading(settings.retrieval, library, embedder, language_model, reader, reading)
    if report is not None:
        text = _only_conflict(report)
    return explain_text(str(text), replace(settings, retrieval=chosen), facts=set, edits=_names(edit or ()))


def conflicts(
    report: Name,
    *,
    progress: Progress = silent,
) -> tuple[Conflict, ...]:
    """The conflicts that a report tells, each to be run or explained, with what is in none of them.

    Args:
        report: A file: text in UTF-8, of any length up to 1 MB.
        progress: Told how many of its sentences are read.

    Raises:
        SettingsError: There is no such file, or it is no text.
        NothingFits: It tells no conflict.
    """
    from chatscene.interpret.conflicts import conflicts_in, read_report

    path = _path(report)
    return conflicts_in(read_report(path), path.name, progress)


def describe(
    n: int = 10,
    *,
    base: BaseScenario | str | None = None,
    instruction: str = "",
    seed: int = 0,
    library: Name | None = None,
    embedder: str | None = None,
    language_model: str | None = None,
) -> tuple[Description, ...]:
    """Make up scenarios for `run`, each with a sentence of its own (``text``) that the library serves.

    Args:
        n: How many.
        base: Base scenario they belong to; any if None.
        instruction: What they are to be about, in words.
        seed: Another seed, other sentences.
        library: Folder of one's own snippets, beside the packaged ones.
        embedder: Who measures wording.
        language_model: ``openai:MODEL``, ``gguf:FILE``, or ``offline``.

    Raises:
        NothingFits: The library has no such scenario, or nothing in the instruction was understood.
    """
    from chatscene.sentences.describe_with_model import describe_for

    settings = _reading(RetrievalSettings(), library, embedder, language_model)
    wanted = BaseScenario(base) if base else None
    return describe_for(settings, wanted, n, seed=seed, instruction=instruction).descriptions


def resume(
    folder: Name,
    *,
    jobs: int = 1,
    executor: str = EXECUTOR,
    ego: Names = (),
    generator: Names = (),
    sampler: Names = (),
    simulator: Names = (),
    library: Names = (),
    embedder: Names = (),
    language_model: Names = (),
    progress: Progress = silent,
) -> Run | Evaluated | Benchmarked | Reproduced | Finetuned | Trained:
    """Go on with what was killed or failed; the result is that of an uninterrupted one.

    Args:
        folder: Folder of a run, an evaluation, a benchmark, a reproduction, a fine-tuning or a training.
        jobs: How many work at a time; any number gives the same files. A fine-tuning and a training are one process.
        executor: As `run`.
        ego: Egos again that the folder names and that may run code of their own: that its files say so is not enough.
        generator: Generator again, if it names one that is none of ours.
        sampler: Sampler again, if it names one that is none of ours.
        simulator: Simulator again, if it names one that is none of ours.
        library: Folder of snippets again, if it names one.
        embedder: Embedder again, if it names another than the packaged one.
        language_model: Language model again, if it names one.
        progress: Told what is done.

    Raises:
        RunError: There is nothing to go on with in the folder, it is damaged, another process is at work on it, or it
            names what must be repeated.
    """
    where = _path(folder)
    repeated = _again(
        ego=ego,
        generator=generator,
        sampler=sampler,
        simulator=simulator,
        library=library,
        embedder=embedder,
        language_model=language_model,
    )
    kind = runs.read_record(runs.Workspace(where), runs.Record).kind
    go_on: Callable[..., Any] = import_module(_RESUMES[kind]).resume
    done = go_on(where, workers=Workers(jobs, executor), progress=progress, repeated=repeated)
    if kind is runs.Kind.RUN:
        return Run(where, ego=ego, generator=generator, simulator=simulator, library=library)
    return done


_RESUMES = {
    "run": "chatscene.pipeline",
    "evaluation": "chatscene.studies.evaluation",
    "benchmark": "chatscene.studies.benchmark",
    "reproduction": "chatscene.studies.reproduce",
    "finetuning": "chatscene.learn.finetune",
    "training": "chatscene.learn.train",
}
"""Whose `resume` goes on with each kind of folder (`chatscene.runs.Kind`); loaded when it does."""


def replay(
    folder: Name,
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
        folder: Run folder.
        scene_id: Id of the scene; None for the first that the report shows.
        ego: Ego of the run again, if it may run code of its own.
        generator: Generator of the run again, if it is none of ours.
        simulator: Simulator of the run again, if it is none of ours.
        library: Folder of snippets of the run again, if it has one.
        watch: Whether the window of a CARLA server looks down on the ego.
        record: Whether a CARLA server's recorder writes a file below ``recordings`` in the folder.

    Raises:
        RunError: The run has no such scene, or it was never driven; or it names what must be repeated.
        SettingsError: The simulator has no window or no recorder.
    """
    from chatscene.runs.replay import replay as replay_scene

    repeated = _again(ego=ego, generator=generator, simulator=simulator, library=library)
    return replay_scene(_path(folder), scene_id or Run(folder).best.id, repeated=repeated, watch=watch, record=record)


def why(
    folder: Name,
    scene_id: str | None = None,
    *,
    ego: Names = (),
    generator: Names = (),
    simulator: Names = (),
    library: Names = (),
) -> Why:
    """Say why a scene of a run crashed, by driving it otherwise: who struck whom, what it took, how the ego avoids it.

    Args:
        folder: Run folder.
        scene_id: Id of the scene; None for the first that the report shows.
        ego: Ego of the run again, if it may run code of its own.
        generator: Generator of the run again, if it is none of ours.
        simulator: Simulator of the run again, if it is none of ours.
        library: Folder of snippets of the run again, if it has one.

    Raises:
        RunError: The run has no such scene, or it did not crash, or does not any more; or it names what must be
            repeated.
    """
    from chatscene.runs.why import why as why_crashed

    repeated = _again(ego=ego, generator=generator, simulator=simulator, library=library)
    return why_crashed(_path(folder), scene_id or Run(folder).best.id, repeated=repeated)


def rate(
    folder: Name,
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
    """Say how often the situation of a run ends in a crash, and in an avoidable one, if it comes about.

    Args:
        folder: Run folder; its ego drives.
        scenes: How many scenes to draw for this.
        seed: Of these.
        exposure: TOML file that says how often values occur on the road; without it every value of a parameter's range
            is taken to occur alike.
        jobs: How many work at a time; any number gives the same.
        executor: As `run`.
        progress: Told what is done.
        ego: Ego of the run again, if it may run code of its own.
        generator: Generator of the run again, if it is none of ours.
        simulator: Simulator of the run again, if it is none of ours.
        library: Folder of snippets of the run again, if it has one.

    Raises:
        RunError: There is no run, it has no program, or it names what must be repeated.
        SettingsError: The exposure cannot be read, or is of other parameters or units.
    """
    from chatscene.runs.rate import rate as rate_of
    from chatscene.search.exposure import read_exposure

    repeated = _again(ego=ego, generator=generator, simulator=simulator, library=library)
    densities = () if exposure is None else read_exposure(_path(exposure))
    return rate_of(
        _path(folder),
        scenes=scenes,
        seed=seed,
        densities=densities,
        workers=Workers(jobs, executor),
        progress=progress,
        repeated=repeated,
    )


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
) -> Verdict:
    """Whether a program, a run or a recording shows what was said, fact by fact, from its tracks.

    Args:
        what: A Scenic program (``.scenic``) or a file of OpenSCENARIO (``.xosc``), which run in the sandbox; a run; a
            table of tracks (``.csv``); or a trace of ASAM OSI (``.mcap``).
        said: A sentence, a situation, or the file of a situation or of a report; None for what a run was made of.
        draws: How many drives of a program are judged, or scenes of a run.
        seed: What their values are drawn by.
        least: The share of the drives that must show a fact, of those that came to it.
        ego: Who drives a program; None for its own ego, or the usual one where it has none.
        map: The map of a program that names none.
        trust: Whether a program may use all of Scenic and Python, in this process.
        ego_id: Whose track of a recording is the ego's; None for the one that is marked.
        scene: Which scene of a run; None for those that it keeps.
        param: Parameters that a program reads and does not state, or values of those that a file of OpenSCENARIO
            declares, by name.
        variant: Which set of parameter values of a file of such sets, from 1; None spreads the drives over them.
        budget: Processor time [s] for scenes that cannot be placed, over all drives; then no more are tried.
        within: The folder in which map and catalogs lie that a program names, if they may lie nowhere else.
        page: Where a page with the moment of each fact is written; None for none.
        library: As `explain`, where it is refused: snippets have no facts to be judged by.
        embedder: As `explain`.
        language_model: As `explain`.
        reader: As `explain`.
        reading: As `explain`.
        set: Facts beside what was said, by their paths; beside a text also by their names.

    Raises:
        NothingFits: Nothing, or nothing for sure, is read in the text.
        ChatSceneError: It cannot be read or driven.
    """
    from chatscene.verdict.page import write_page
    from chatscene.verdict.said import asked
    from chatscene.verdict.sources import watching
    from chatscene.verdict.verify import weighed

    if map is not None:
        check_opendrive(resolve_map(str(map)))
    settings = _changed(
        VerifySettings(trust=trust),
        draws=draws,
        seed=seed,
        least=least,
        ego=None if ego is None else str(ego),
        map_name=None if map is None else str(map),
        ego_id=ego_id,
        scene_id=scene,
        given=param,
        variant=variant,
        budget=budget,
        within=None if within is None else str(_path(within)),
    )
    path = what.folder if isinstance(what, Run) else _path(what)
    chosen = _reading(RetrievalSettings(), library, embedder, language_model, reader, reading)
    wanted = asked(_made_of(path) if said is None else said, chosen, set)
    found = watching(path, settings)
    verdict = weighed(found, str(path), wanted, settings)
    if page is not None:
        write_page(_path(page), verdict, found.drawing)
    return verdict


def story(
    what: Name | Run,
    *,
    scene: str | None = None,
    seed: int | None = None,
    ego: Name | None = None,
    map: Name | None = None,  # noqa: A002 - the word of the command line
    trust: bool = False,
    ego_id: str | None = None,
    param: Mapping[str, object] | None = None,
    variant: int | None = None,
    within: Name | None = None,
) -> Story:
    """What happened in a drive of a program, a run or a recording, in words, with times and speeds.

    The answer prints as lines; its `picture` is a moment from above.

    Args:
        what: As `verify`: of a program the first drive is told.
        scene: Which scene of a run; None for the first that it keeps.
        seed: What the values of a program's drive are drawn by.
        ego: Who drives a program; None for its own ego, or the usual one where it has none.
        map: The map of a program that names none.
        trust: Whether a program may use all of Scenic and Python, in this process.
        ego_id: Whose track of a recording is the ego's; None for the one that is marked.
        param: As `verify`.
        variant: Which set of parameter values of a file of such sets, from 1; None for the first.
        within: The folder in which map and catalogs lie that a program names, if they may lie nowhere else.

    Raises:
        ChatSceneError: It cannot be read or driven, or has no such scene.
    """
    from chatscene.verdict.story import story as told

    if map is not None:
        check_opendrive(resolve_map(str(map)))
    settings = _changed(
        VerifySettings(trust=trust),
        seed=seed,
        ego=None if ego is None else str(ego),
        map_name=None if map is None else str(map),
        ego_id=ego_id,
        scene_id=scene,
        given=param,
        variant=variant,
        within=None if within is None else str(_path(within)),
    )
    return told(what.folder if isinstance(what, Run) else _path(what), settings)


def _made_of(folder: Path) -> Situation:
    """The situation that a run was made of.

    Raises:
        SettingsError: It is no run, or one that was made of none.
    """
    from chatscene.situations.file import read_text
    from chatscene.verdict.sources import check_there

    check_there(folder)
    if not folder.is_dir():
        raise SettingsError(f"say what {folder} is to show: a sentence, a situation or a report")
    record = runs.read_record(runs.open_run(folder, runs.RunRecord))
    if record.situation is None:
        raise SettingsError(f"{folder} was made of no situation; say what it is to show")
    return read_text(record.situation.text)


def export(folder: Name, scenes: Names = (), *, to: str, out: Name | None = None) -> Exported:
    """Write scenes of a run as files that other tools read; nothing is simulated or executed.

    Args:
        folder: Run folder.
        scenes: Ids of the scenes; none for those that the run keeps.
        to: An exporter by name: ``openscenario``, ``openscenario-logical``, ``opendrive``, ``commonroad``, ``osi``,
            ``csv``, ``scenic``, or ``package.module:factory``.
        out: Where to; a new folder, or an empty one.

    Raises:
        SettingsError: There is no such exporter, or the folder is not empty.
        MissingExtra: The exporter needs a package that is not installed.
        RunError: The run has no such scene, it was never driven, or it keeps none.
        MapError: The run's map is not there any more.
    """
    from chatscene.exports.export import export as export_scenes

    return export_scenes(_path(folder), _names(scenes), to=to, out=_folder(out))


def import_scenario(
    file: Name,
    *,
    out: Name | None = None,
    map: Name | None = None,  # noqa: A002 - the word of the command line
    ego: str | None = None,
    variant: int | None = None,
    param: Mapping[str, object] | None = None,
    within: Name | None = None,
) -> ImportedScenario:
    """Write a scenario of OpenSCENARIO XML as a Scenic program of one's own, which `run` takes; nothing of it is run.

    Args:
        file: An ``.xosc`` file: a scenario, or parameter values for one, each set of which gives a program.
        out: The ``.scenic`` file, a new one; None for one beside it with its name.
        map: A packaged map or an ``.xodr`` file; None for the one that the file names by a path from its folder.
        ego: What the file calls the ego; None where that is told by the file.
        variant: The number of one set of parameter values, from 1; None for all of them.
        param: Values of parameters in place of those in the file, by name.
        within: The folder in which catalogs and the map lie that the file names, if they may lie nowhere else.

    Raises:
        ScenarioError: It cannot be read, or says what cannot be said here; the message names each element and its line.
        MapError: The map is not there, or is broken.
        SettingsError: The program is there already, or there is no such variant.
    """
    from chatscene.imports.import_file import import_scenario as import_file

    return import_file(
        _path(file),
        out=None if out is None else _path(out),
        map_name=None if map is None else str(map),
        ego=ego,
        variant=variant,
        given=param,
        within=None if within is None else _path(within),
    )


def sql(query: str, folder: Name = "runs") -> Table:
    """The answer to a query over all runs below a folder: an Arrow table. Needs the extra ``sql``.

    Args:
        query: A SELECT in DuckDB's SQL over the tables runs, facts, scenes, parameters and events; nothing else can be
            read, and nothing written.
        folder: A run folder, or one with run folders somewhere below.

    Raises:
        MissingExtra: The extra is not installed.
        QueryError: It is no SQL, names what there is not, or would do more than read these tables.
        RunError: There is no run in the folder.

    Warns:
        RuntimeWarning: For each folder that is left out, with the reason: it is damaged, or not done.
    """
    from chatscene.report.index import index
    from chatscene.report.sql import ask

    found = index(_path(folder))
    for one in found.left_out:
        warnings.warn(str(one), RuntimeWarning, stacklevel=2)
    return ask(query, found)


def evaluate(
    scenes: Run | Name | Sequence[Run | Name],
    folder: Name | None = None,
    *,
    ego: Names = (),
    all: bool = False,  # noqa: A002 - the word of the command line
    simulator: str | None = None,
    physics: str | None = None,
    speed: float | None = None,
    jobs: int = 1,
    executor: str = EXECUTOR,
    generator: Names = (),
    library: Names = (),
    progress: Progress = silent,
) -> Evaluated:
    """Measure egos on the kept scenes of runs; gives the paper's tables with intervals.

    Args:
        scenes: Runs, or folders with runs somewhere below.
        folder: Folder of the evaluation, new or empty, or one to go on in.
        ego: Egos by name, file or ``package.module:factory``; `planner`, `idm` and `sac` if none is given.
        all: Whether every scene that ran is driven, not only the kept ones.
        simulator: What they are driven in; that of the runs if None.
        physics: How bodies answer to pedals and wheel: ``kinematic`` or ``lagged``; that of the runs if None.
        speed: What egos drive at [km/h] in scenes of which it was not said; None for what the runs have.
        jobs: As `run`.
        executor: As `run`.
        generator: Generators of the runs again, if they are none of ours.
        library: Folders of snippets of the runs again, if they have any.
        progress: Told what is done.

    Raises:
        RunError: A run is not finished, they lie on different maps, or one names what must be repeated.
        EgoError: An ego cannot be loaded.
    """
    from chatscene.studies import evaluation

    return evaluation.evaluate(
        _sources(scenes),
        _folder(folder),
        egos=_names(ego) or evaluation.COMPARED,
        every_scene=all,
        simulator=simulator or "",
        physics=physics or "",
        speed=speed,
        workers=Workers(jobs, executor),
        progress=progress,
        repeated=_again(generator=generator, library=library),
    )


def finetune(
    scenes: Run | Name | Sequence[Run | Name],
    folder: Name | None = None,
    *,
    ego: Name | None = None,
    teacher: Name | None = None,
    preset: str | None = None,
    choice: str | None = None,
    episodes: int | None = None,
    train_routes: int | None = None,
    reward: str | None = None,
    ordinary_share: float | None = None,
    simulator: str | None = None,
    physics: str | None = None,
    seed: int | None = None,
    settings: FinetuneSettings | None = None,
    progress: Progress = silent,
) -> Finetuned:
    """Fine-tune an SAC ego on the kept scenes of runs, or teach a new one; measured before and after.

    Needs the extra ``train``. The same call goes on after a kill.

    Args:
        scenes: Runs, or folders with runs somewhere below.
        folder: Where the hardened ego goes: a new folder, or one to go on in.
        ego: ``sac``, the file of an SAC policy, or its folder.
        teacher: An ego to learn from, from nothing, instead of by reward.
        preset: Gradient steps: ``paper``, one per step; ``released``.
        choice: Who chooses the checkpoint: ``paper`` or ``held-out``.
        episodes: Scenes driven.
        train_routes: How many of the first routes train; the rest test.
        reward: What it is paid for: ``safebench`` or ``progress``.
        ordinary_share: Share of the episodes on ordinary routes.
        simulator: What scenes are driven in; that of the runs if None.
        physics: How bodies answer to pedals and wheel: ``kinematic`` or ``lagged``; that of the runs if None.
        seed: What everything random derives from.
        settings: All other settings; the keywords above come before them.
        progress: Told what is done.

    Raises:
        MissingExtra: The extra is not installed.
        RunError: A run is not usable, or there is nothing to train, choose or test on.
    """
    from chatscene.learn.finetune import PRESETS, FinetuneSettings
    from chatscene.learn.finetune import finetune as finetune_ego

    if preset is not None and preset not in PRESETS:
        raise SettingsError(no_such("preset", preset, PRESETS))
    chosen = _changed(
        settings or FinetuneSettings(),
        ego=None if ego is None else str(ego),
        teacher=None if teacher is None else str(teacher),
        choice=choice,
        episodes=episodes,
        train_routes=train_routes,
        reward=reward,
        ordinary_share=ordinary_share,
        simulator=simulator,
        physics=physics,
        seed=seed,
        **(PRESETS[preset] if preset else {}),
    )
    return finetune_ego(_folder(folder), _sources(scenes), chosen, progress=progress)


def train(
    folder: Name | None = None,
    *,
    algorithm: str | None = None,
    observation: str | None = None,
    reward: str | None = None,
    pedals: str | None = None,
    steps: int | None = None,
    round: int | None = None,  # noqa: A002 - the word of the command line
    seed: int | None = None,
    map: Name | None = None,  # noqa: A002 - the word of the command line
    simulator: str | None = None,
    physics: str | None = None,
    speed: float | None = None,
    progress: Progress = silent,
) -> Trained:
    """Train an ego on the ordinary drives of a map.

    Needs the extra ``train``. The same call goes on after a kill.

    Args:
        folder: Where the ego goes: a new folder, or one to go on in.
        algorithm: ``sac``, ``ppo`` or ``td3``.
        observation: What the ego sees: ``safebench``, ``actors``, ``road`` or ``traffic``, which is what it sees by
            default if it is to drive at a speed.
        reward: What it is paid for: ``safebench`` or ``progress``.
        pedals: ``safebench``, or ``full-brake``, which it has by default if it is to drive at a speed.
        steps: Environment steps of 0.1 s.
        round: Steps between two evaluations.
        seed: What everything random derives from.
        map: Packaged ``town``, or an ``.xodr`` file.
        simulator: What scenes run in.
        physics: How bodies answer to pedals and wheel: ``kinematic`` or ``lagged``.
        speed: What the ego is to drive at [km/h] within the limits of the roads, 110 for these alone; None for one
            that drives at SafeBench's speed.
        progress: Told what is done.

    Raises:
        MissingExtra: The extra is not installed.
    """
    from chatscene.learn.train import TrainSettings
    from chatscene.learn.train import train as train_ego

    if speed is not None:
        observation, pedals = observation or "traffic", pedals or "full-brake"
    chosen = _changed(
        TrainSettings(),
        algorithm=algorithm,
        observation=observation,
        reward=reward,
        pedals=pedals,
        steps=steps,
        round=round,
        seed=seed,
        map_name=None if map is None else str(map),
        simulator=simulator,
        physics=physics,
        speed=speed,
    )
    return train_ego(_folder(folder), chosen, progress=progress)


def _changed(settings: Any, **given: Any) -> Any:
    """Settings with those replaced that were given."""
    return replace(settings, **{name: value for name, value in given.items() if value is not None})


def _reading(
    settings: RetrievalSettings,
    library: Name | None = None,
    embedder: str | None = None,
    language_model: str | None = None,
    reader: str | None = None,
    reading: int | None = None,
    stated: Mapping[str, object] | None = None,
) -> RetrievalSettings:
    own = str(_path(library)) if library else None
    facts = in_text(stated) if stated else None
    return _changed(
        settings,
        library=own,
        embedder=embedder,
        language_model=language_model,
        reader=reader,
        reading=reading,
        stated=facts,
    )


def _check_asked(program: bool, *, told: bool, driven: bool, changed: bool, reading: int) -> None:
    """Refuse what is asked of a run that has no place in what is run, which would else be dropped.

    Args:
        program: Whether a program is run.
        told: Whether a situation is.
        driven: Whether it is said how a program is driven.
        changed: Whether facts or edits are said.
        reading: Which reading of a text is taken; 0 where that is not said.

    Raises:
        SettingsError: There is such a thing.
    """
    if driven and not program:
        raise SettingsError("`trust`, `as_written` and `param` are about a program, and none is run")
    if changed and program:
        raise SettingsError("`edit` and `set` are about what is said, and a program is run as it is; leave them away")
    if reading and (program or told):
        raise SettingsError("`reading` is about a text; there is one way to read a situation or a program")


def _only_conflict(report: Name) -> Conflict:
    """The conflict of a report that tells one."""
    from chatscene.interpret.conflicts import conflicts_in, read_report

    found, *others = conflicts_in(read_report(_path(report)), _path(report).name)
    if others:
        raise SettingsError(
            f"{report} tells {found.of} conflicts; run them one by one: "
            f"[chatscene.run(one) for one in chatscene.conflicts({str(report)!r})]"
        )
    return found


def _again(**named: Names) -> Repeated:
    """What the user names beside a record, by the fields of `Repeated`."""
    return Repeated(**{field: _names(names) for field, names in named.items()})


def _path(name: Name) -> Path:
    """A path that a user names.

    Raises:
        SettingsError: It can be none.
    """
    if "\0" in str(name):
        raise SettingsError(f"{str(name)!r} is no path: it holds a NUL character")
    return Path(name)


def _folder(folder: Name | None) -> Path:
    return Path(tempfile.mkdtemp(prefix="chatscene-")) if folder is None else _path(folder)


def _names(names: Names) -> tuple[str, ...]:
    return (str(names),) if isinstance(names, str | Path) else tuple(map(str, names))


def _sources(scenes: Run | Name | Sequence[Run | Name]) -> list[Path]:
    every = [scenes] if isinstance(scenes, Run | str | Path) else scenes
    return [one.folder if isinstance(one, Run) else _path(one) for one in every]


def _generator_of(situation: object | None, own: ForeignProgram | None, *, trusted: bool, as_written: bool) -> str:
    from chatscene.search.generators.own_program import generator_for

    if situation is not None:
        return "situation"
    return "chatscene" if own is None else generator_for(trusted=trusted, as_written=as_written)


def _at_speed(program: ScenicProgram, speed: float) -> ScenicProgram:
    """A program whose ego wants a speed [km/h], if it says none.

    Raises:
        SettingsError: Nothing can be wanted of its ego.
    """
    if program.drawn or program.as_written:
        why = "drives as it is written" if program.as_written else "is written for another world model"
        raise SettingsError(f"{program.called} {why}, so that its ego is not told a speed")
    return at_speed(program, speed / 3.6)


def _own(path: Path, *, trusted: bool, as_written: bool, given: Mapping[str, object] | None) -> ForeignProgram:
    """A program of the user's own."""
    from chatscene.search.generators.foreign import foreign_files, read_foreign

    file, *others = foreign_files(path)
    if others:
        raise SettingsError(f"{path} holds {len(others) + 1} programs; run them one by one")
    return read_foreign(file, trusted=trusted, as_written=as_written, given=given)
