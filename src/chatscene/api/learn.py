"""Learn: egos that are trained, and those that are tuned on kept scenes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from chatscene.api.arguments import Name, changed, folder_for
from chatscene.api.results import Run, folders_of
from chatscene.errors import SettingsError, no_such
from chatscene.runs.progress import Progress, silent

if TYPE_CHECKING:
    from chatscene.learn.finetune import Finetuned, FinetuneSettings
    from chatscene.learn.train import Trained


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
    chosen = changed(
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
    return finetune_ego(folder_for(folder), folders_of(scenes), chosen, progress=progress)


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
    chosen = changed(
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
    return train_ego(folder_for(folder), chosen, progress=progress)
