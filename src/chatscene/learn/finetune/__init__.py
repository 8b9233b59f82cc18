"""Step 9 of 9: fine-tune an ego on kept scenes, and say what it gained and what it lost.

Paper: section 4.3 and appendix "Adversarial Finetuning Details". What departs from it and why: decision 0021.

Like a training, a fine-tuning goes in rounds that are kept when they are done, so it can be killed at any moment; the
same call goes on and ends in the same weights. It does not end in the last weights but in those of the checkpoint that
is chosen, and drives ordinary routes before and after, so that an ego that learned to stand still cannot hide it.
"""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from chatscene import runs
from chatscene.ego.network import NetworkEgo
from chatscene.ego.policy import EGOS, EgoPolicy, load_ego
from chatscene.errors import EgoError, MissingExtra, RunError
from chatscene.learn.finetune.scenes import CHOICE, TEST, TRAIN, KeptScene, judge, kept_scenes, split
from chatscene.learn.finetune.settings import PRESETS, FinetuneSettings
from chatscene.maps.network import resolve_map
from chatscene.measure.ordinary import drive_ordinary
from chatscene.program.ordinary import ordinary_courses
from chatscene.runs.atomic import write_bytes
from chatscene.runs.progress import Progress, silent
from chatscene.runs.trust import Repeated, follow
from chatscene.runs.working import going_on
from chatscene.simulate.simulator import Simulator, load_simulator

if TYPE_CHECKING:
    from chatscene.learn.finetune.learner import Learner
    from chatscene.learn.finetune.pupil import Pupil

__all__ = ["PRESETS", "FinetuneSettings", "Finetuned", "choose", "finetune"]

LEAST_COMPLETION = 0.3  # of a checkpoint that may be chosen (paper)
ORDINARY = "ordinary"
ORDINARY_SEED = 20_000  # of the traffic: neither a training's nor that of its evaluations
LEAVES = ("policy.npz", "checkpoints/*.npz", "state-*.npz", "state-*.pt")  # the last of before, which is not read
Row = dict[str, int | float]  # a row of the curve: numbers by name


@dataclass(frozen=True, slots=True, kw_only=True)
class Finetuned:
    """What a fine-tuning came to; `run.json` in its folder holds the same.

    Attributes:
        folder: Where everything is; `policy.npz` is the chosen ego, which ``--ego`` takes.
        curve: One row per round: what was driven and learned and, from the first checkpoint on, the figures on the
            scenes that choose.
        before: Figures of the start policy, by what was driven: ``train``, ``choice``, ``test``, ``ordinary``.
        skipped: Why a kept scene could not be driven, by scene.
    """

    folder: Path
    curve: tuple[Row, ...]
    chosen: Row
    reason: str
    before: dict[str, dict[str, float]]
    after: dict[str, dict[str, float]]
    skipped: dict[str, str]


def finetune(folder: Path, sources: Sequence[Path], settings: FinetuneSettings, *, progress: Progress) -> Finetuned:
    """Fine-tune into a new folder, or go on in one where the same fine-tuning was cut.

    Raises:
        MissingExtra: Stable-Baselines3 is not installed.
        EgoError: The ego cannot be loaded, or is no SAC.
        RunError: A source is not usable, there is nothing to train, choose or test on, or the folder holds something
            else.
    """
    try:
        from chatscene.learn.finetune.learner import Learner, Schedule
        from chatscene.learn.finetune.pupil import Pupil
    except ImportError as error:
        raise MissingExtra("fine-tuning needs Stable-Baselines3", extra="train") from error
    settings = replace(settings, ego=_file(settings.ego), teacher=_file(settings.teacher))
    if settings.teacher:
        start = load_ego(settings.ego)
        learner_of = partial(Pupil, load_ego(settings.teacher))
    else:
        start = _start(settings.ego)
        learner_of = partial(Learner, start)
    progress("reading the scenes", 0, 0)
    lessons = kept_scenes(sources, simulator=settings.simulator, physics=settings.physics)
    parts = split(
        lessons.scenes,
        choice=settings.choice,
        train_routes=settings.train_routes,
        validation_routes=settings.validation_routes,
    )
    asked = runs.FinetuningRecord(
        settings=asdict(settings),
        ego_digests=runs.ego_digests((settings.ego, settings.teacher)),
        scenes=runs.LessonsRecord(digest=lessons.digest, **{name: len(part) for name, part in parts.items()}),
        sources=[str(source.resolve()) for source in sources],
    )
    with going_on(folder, asked, progress, leaves=LEAVES) as (work, tell):
        simulator = load_simulator(resolve_map(lessons.map_name), lessons.simulation)
        judging = _Judging(parts, simulator, tell)
        if not _told(work).before:
            before, skipped = judging.all(start, "driving before")
            runs.update(work, before=before, skipped=skipped)
        schedule = Schedule(
            scenes=_drivable(parts[TRAIN], _told(work).skipped),
            ordinary=ordinary_courses(simulator) if settings.ordinary_share else (),
            share=settings.ordinary_share,
            seed=settings.seed,
        )
        if not _told(work).chosen:
            learner = learner_of(settings, schedule, lessons.map_name, lessons.simulation)
            chosen, why = choose(_rounds(work, learner, judging, settings, tell))
            write_bytes(work.file("policy.npz"), _checkpoint(work, chosen).read_bytes())
            runs.update(work, chosen=chosen, chosen_why=why)
        if not _told(work).after:
            after, _ = judging.all(load_ego(str(work.file("policy.npz"))), "driving after")
            runs.update(work, after=after)
    record = _told(work)
    return Finetuned(
        folder=folder,
        curve=tuple(record.curve),
        chosen=record.chosen,
        reason=record.chosen_why,
        before=record.before,
        after=record.after,
        skipped=record.skipped,
    )


def resume(folder: Path, *, progress: Progress = silent, repeated: Repeated | None = None) -> Finetuned:
    """Go on with a fine-tuning that was killed or failed.

    Raises:
        RunError: There is none in the folder, its scenes are not there any more, or it names what must be repeated
            (`chatscene.runs.trust.follow`).
    """
    work = runs.open_run(folder, runs.FinetuningRecord)
    follow(repeated or Repeated(), egos_of=[work], simulators_of=[work])
    record = _told(work)
    settings = runs.settings_from(FinetuneSettings, record.settings)
    return finetune(folder, [Path(source) for source in record.sources], settings, progress=progress)


def _told(work: runs.Workspace) -> runs.FinetuningRecord:
    return runs.read_record(work, runs.FinetuningRecord)


def choose(curve: Sequence[Mapping[str, Any]]) -> tuple[Row, str]:
    """The checkpoint to keep, and why that one.

    The lowest collision rate among those that complete more than `LEAST_COMPLETION` of their routes (paper); of equal
    ones the higher overall score, then the earlier. Where none completes so much: the one that completes most.

    Raises:
        RunError: None was.
    """
    rows = [dict(row) for row in curve if "collision_rate" in row]
    if not rows:
        raise RunError("no checkpoint has figures to choose by: none of the scenes that choose could be driven")
    able = [row for row in rows if row["completion"] > LEAST_COMPLETION]
    if able:
        chosen = min(able, key=lambda row: (row["collision_rate"], -row["overall_score"], row["episode"]))
        return chosen, f"lowest collision rate of those that complete more than {LEAST_COMPLETION}"
    chosen = min(rows, key=lambda row: (-row["completion"], row["collision_rate"], row["episode"]))
    return chosen, f"no checkpoint completes more than {LEAST_COMPLETION} of its routes; this one completes most"


def _rounds(
    work: runs.Workspace, learner: Learner | Pupil, judging: _Judging, settings: FinetuneSettings, progress: Progress
) -> list[Row]:
    """Do the rounds that are not done; the curve of all."""
    curve = _told(work).curve
    ends = settings.ends()
    if curve:
        learner.restore(_state(work, curve[-1]))
    else:
        progress("teaching the critics", 0, 0)
        runs.update(work, warm_up=learner.warm_up())
    for number in range(len(curve), len(ends)):
        begin, end = ends[number - 1] if number else 0, ends[number]
        progress("fine-tuning, episodes", begin, settings.episodes)
        began = time.monotonic()
        collisions = learner.learn(number, range(begin, end))
        row: Row = {
            "episode": end,
            "steps": learner.steps,
            "updates": learner.updates,
            "training_collision_rate": collisions / (end - begin),
            "seconds": round(time.monotonic() - began, 1),
        }
        if end >= settings.first_choice or end == settings.episodes:
            ego = learner.ego()
            row |= judging.choice(ego)
            about = {"observation": ego.observation, "pedals": ego.pedals, "algorithm": ego.name}
            write_bytes(_checkpoint(work, row), ego.network.stored({**asdict(settings), **about, "episode": end}))
        learner.keep(_state(work, row))
        curve.append(row)  # last: a row says that everything before it is on disk
        runs.update(work, curve=curve)
        if number:
            _state(work, curve[-2]).unlink(missing_ok=True)
    progress("fine-tuning, episodes", settings.episodes, settings.episodes)
    return curve


class _Judging:
    """Drives an ego for its figures."""

    def __init__(self, parts: Mapping[str, tuple[KeptScene, ...]], simulator: Simulator, progress: Progress) -> None:
        self._parts = parts
        self._simulator = simulator
        self._progress = progress

    def choice(self, ego: EgoPolicy) -> dict[str, float]:
        """The figures on the scenes that choose."""
        return judge(ego, self._parts[CHOICE], self._simulator, on_scene=lambda _done, _total: None).figures

    def all(self, ego: EgoPolicy, what: str) -> tuple[dict[str, dict[str, float]], dict[str, str]]:
        """The figures on everything, by what was driven, and why a scene could not be."""
        figures: dict[str, dict[str, float]] = {}
        rejected: dict[str, str] = {}
        for name in (TRAIN, CHOICE, TEST):
            scenes = self._parts[name]
            if name == TEST and scenes == self._parts[CHOICE]:
                figures[name] = figures[CHOICE]
                continue
            on_scene = partial(self._progress, f"{what}, {name} scenes")
            judged = judge(ego, scenes, self._simulator, on_scene=on_scene)
            figures[name] = judged.figures
            rejected |= judged.rejected
        self._progress(f"{what}, ordinary routes", 0, 0)
        ordinary = drive_ordinary(ego, self._simulator, scenes=1, seed=ORDINARY_SEED)
        figures[ORDINARY] = ordinary.figures()
        return figures, rejected


def _file(name: str) -> str:
    """The file of an ego that is named by its folder; any other name is itself."""
    return str(Path(name) / "policy.npz") if name and Path(name).is_dir() else name


def _start(name: str) -> NetworkEgo:
    """The ego to fine-tune by reward."""
    ego = load_ego(name)
    if not isinstance(ego, NetworkEgo):
        raise EgoError(f"{name} is not a network that could be trained on; give `sac` or the file of an SAC policy")
    if ego.network.output == "ways":
        raise EgoError(f"{name} chooses among ways, and soft actor-critic learns actions; teach a pupil by another ego")
    if ego.every != 1:
        raise EgoError(f"{name} holds each action for several steps, as SafeBench's do, and a fine-tuning acts at each")
    if (name in EGOS.built_in and name != "sac") or (ego.network.hidden, ego.network.output) != ("relu", "tanh"):
        raise EgoError(
            f"{name} is not an SAC policy, and nothing else can be fine-tuned; train one with: chatscene train"
        )
    return ego


def _drivable(scenes: Sequence[KeptScene], skipped: Mapping[str, str]) -> tuple[KeptScene, ...]:
    """The training scenes that can be placed."""
    left = tuple(kept for kept in scenes if kept.scene.id not in skipped)
    if not left:
        reason = skipped[scenes[0].scene.id]
        raise RunError(f"none of the {len(scenes)} training scenes can be driven ({reason}); search for them again")
    return left


def _state(work: runs.Workspace, row: Mapping[str, Any]) -> Path:
    """Where the learner is kept after a round."""
    return work.file(f"state-{row['episode']:04d}.npz")


def _checkpoint(work: runs.Workspace, row: Mapping[str, Any]) -> Path:
    """Where the policy is kept after a round."""
    return work.file("checkpoints") / f"policy-{row['episode']:04d}.npz"
