"""What a run comes to: its scenes, the ones worth keeping, and the report."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from chatscene import runs
from chatscene.api.arguments import Name, Names, again, path_of
from chatscene.errors import EditRefused, RunError
from chatscene.runs.executor import Workers
from chatscene.runs.progress import Progress, silent
from chatscene.runs.trust import Repeated, follow
from chatscene.settings import EXECUTOR
from chatscene.terms.episode import Episode
from chatscene.terms.situation import Situation

if TYPE_CHECKING:
    from chatscene.ego.policy import EgoPolicy
    from chatscene.learn.env import DrivingEnv
    from chatscene.report.stated import Stated
    from chatscene.report.summary import Summary
    from chatscene.report.understood import Understood
    from chatscene.runs.replay import Replayed
    from chatscene.runs.tables import Table
    from chatscene.runs.why import Why


class Run:
    """A finished run: its scenes, the ones worth keeping, and the report.

    In a notebook it shows the report, with a replay of the scenes.

    Args:
        folder: Folder that `chatscene.run` or the command wrote.
        ego: Ego of the run, repeated if it may run its own code; a record alone never loads code.
        generator: Generator of the run, repeated if it is not packaged.
        sampler: Sampler of the run, repeated if it is not packaged.
        simulator: Simulator of the run, repeated if it is not packaged.
        library: Snippet folder of the run, repeated if it has one.
        embedder: Encoder of the run, repeated if it is not the packaged one.
        language_model: Language model of the run, repeated if it has one.

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
        self.folder = path_of(folder)
        self._repeated = again(
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
    def repeated(self) -> Repeated:
        """What the user named again, and so trusts."""
        return self._repeated

    @property
    def summary(self) -> Summary:
        """How many scenes were driven, collided, left the road and were kept, and who drove."""
        from chatscene.report.summary import Summary

        return Summary.of(self._workspace)

    @property
    def scenes(self) -> Table:
        """A row per scene, driven or rejected, with the columns of `scenes.parquet`: an Arrow table."""
        from chatscene.runs.tables import SCENES, read_table

        return read_table(self._workspace.file("scenes.parquet"), SCENES)

    @property
    def kept(self) -> tuple[DrivenScene, ...]:
        """The scenes worth keeping, the best first."""
        from chatscene.report.viewer import ranked

        return tuple(self._driven(row) for row in ranked(runs.read_scenes(self._workspace, selected=True)))

    @property
    def best(self) -> DrivenScene:
        """The first scene of the report.

        Raises:
            RunError: None was driven.
        """
        from chatscene.report.viewer import best

        if (row := best(self._workspace)) is None:
            raise RunError(f"no scene of {self.folder} was driven")
        return self._driven(row)

    def scene(self, scene_id: str) -> DrivenScene:
        """A scene by its id.

        Raises:
            RunError: The run has none of that id, or it was rejected and never driven.
        """
        for row in runs.read_scenes(self._workspace, ids=[scene_id]):
            if row["status"] == "ran":
                return self._driven(row)
        raise RunError(f"{self.folder} has no scene {scene_id!r} that was driven; `scenes` lists them")

    @property
    def report(self) -> Path:
        """The report: one page that needs nothing but a browser."""
        return self._workspace.file("report.html")

    @property
    def understood(self) -> Understood | Stated:
        """How the text is understood, with its edits; runs nothing.

        Raises:
            EditRefused: It is a run of your own program, which has no text.
            RunError: It names code that must be repeated.
        """
        from chatscene.report.filled import explain_text
        from chatscene.report.stated import explain_stated
        from chatscene.report.understood import understand

        record = self._record
        if record.program is not None:
            raise EditRefused(f"{self.folder} is a run of your own program; only texts and situations can be edited")
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
        """A new run of the situation with an edit applied, with the same settings, seed and ego.

        This run does not change; to undo the edit, use this run again.

        Args:
            text: The edit, such as "make it a truck, from the left, and faster".
            folder: The new run's folder; one beside this one's if none is given.
            jobs: How many work at a time; any number gives the same files.
            executor: Where they run, one of `chatscene.runs.executor.EXECUTORS`.
            progress: Called with what is done.

        Raises:
            EditRefused: The edit is not understood, contradicts itself or other facts, or changes nothing.
            NothingFits: The edited situation cannot be built.
            RunError: The run names code that must be repeated.
        """
        from chatscene import pipeline

        asked = self._asked_with(text)
        asked = asked.model_copy(update={"edited_from": str(self.folder.resolve())})
        where = runs.free_folder(self.folder.parent, text) if folder is None else path_of(folder)
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
        ).model_copy(update={"report": record.report})

    @property
    def edited_from(self) -> Run:
        """The run of which this one is an edit.

        Raises:
            RunError: It is not an edit, or the other run no longer exists.
        """
        if not self._record.edited_from:
            raise RunError(f"{self.folder} is not an edit of another run")
        return Run(self._record.edited_from)

    def _driven(self, row: Mapping[str, Any]) -> DrivenScene:
        joining = replace(self._repeated, sampler=(), embedder=(), language_model=())  # no text is read for a scene
        return DrivenScene(row=row, _workspace=self._workspace, _repeated=joining)

    @property
    def told_first(self) -> list[str]:
        """What was not read, assumed or left out, in lines; read this before any number."""
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
        from chatscene.runs.tables import read_table
        from chatscene.runs.tracks import EPISODES

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
        """The same drive until a moment, continued by another ego that has no memory of what was before.

        Args:
            at: Time at which the other ego takes over [s].
            ego: The other ego: a name, a file, ``package.module:factory``, or an object with ``act``.

        Raises:
            RunError: The run names code that must be repeated.
            SimulationError: The scene cannot be driven again.
        """
        from chatscene.runs.branching import branch_scene

        return branch_scene(self._workspace.path, self.id, at=at, ego=ego, repeated=self._repeated)

    def why(self) -> Why:
        """Explain why it crashed by driving variants of it: who struck whom, what decides, what avoids it.

        Raises:
            RunError: It did not crash, or the run names code that must be repeated.
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
            RunError: The run names code that must be repeated.
            Diverged: This version builds another program than the stored one.
        """
        from chatscene.learn.env import DrivingEnv
        from chatscene.program.ordinary import Course
        from chatscene.runs.rebuild import map_of, rebuild
        from chatscene.search.climb import simulator_of
        from chatscene.search.generator import load_generator

        follow(replace(self._repeated, ego=()), simulators_of=[self._workspace], joining_of=[self._workspace])
        record = runs.read_record(self._workspace)
        map_path = map_of(record)
        made = rebuild(self._workspace)
        scene = runs.scene_of(self.row, made.program)
        return DrivingEnv(
            [Course(program=made.program, route=scene.route, values=scene.values)],
            map_name=map_path,
            ego_observation=ego_observation,
            pedals=pedals,
            reward=reward,
            simulator=simulator_of(load_generator(made.generator), map_path, runs.settings_of(record)),
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


def folder_of(what: Run | Name) -> Path:
    """The folder of a run."""
    return what.folder if isinstance(what, Run) else path_of(what)


def again_of(what: Run | Name, **named: Names) -> Repeated:
    """What the user names beside a record: now, or when the run was opened."""
    before = what.repeated if isinstance(what, Run) else Repeated()
    return replace(again(**named), **{name: asdict(before)[name] for name, now in named.items() if not now})


def run_again(what: Run | Name, **named: Names) -> tuple[Path, Repeated]:
    """Where something lies that may be a run, and what the user names beside its record."""
    return folder_of(what), again_of(what, **named)


def folders_of(scenes: Run | Name | Sequence[Run | Name]) -> list[Path]:
    """The folders of one run or of several."""
    given: object = scenes
    alone = isinstance(scenes, Run | str | Path) or not isinstance(given, Iterable)
    every: Iterable[Any] = [scenes] if alone else scenes  # type: ignore[assignment] # pyright: ignore[reportAssignmentType]
    return [one.folder if isinstance(one, Run) else path_of(one) for one in every]
