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
    """Fine-tune an SAC ego on the kept scenes of runs, or teach a new one, and measure it before and after.

    Needs the extra ``train``. Repeat the call to continue after an interruption.

    Args:
        scenes: Runs, or folders with runs somewhere below.
        folder: Folder for the ego: new, or one to continue.
        ego: ``sac``, the file of an SAC policy, or its folder.
        teacher: Ego that a new policy learns from, instead of by reward.
        preset: Gradient steps: ``paper``, one per step; ``released``.
        choice: Routes that choose the checkpoint: ``paper`` or ``held-out``.
        episodes: Scenes driven.
        train_routes: How many of the first routes train; the rest test.
        reward: ``safebench`` or ``progress``.
        ordinary_share: Share of the episodes on ordinary routes.
        simulator: Simulator of the scenes; that of the runs if None.
        physics: How vehicles respond to pedals and steering: ``kinematic`` or ``lagged``; that of the runs if None.
        seed: Seed of everything random.
        settings: All other settings; the keywords above override them.
        progress: Called with what is done.

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

    Needs the extra ``train``. Repeat the call to continue after an interruption.

    Args:
        folder: Folder for the ego: new, or one to continue.
        algorithm: ``sac``, ``ppo`` or ``td3``.
        observation: What the ego sees: ``safebench``, ``actors``, ``road`` or ``traffic``, the default with a speed.
        reward: ``safebench`` or ``progress``.
        pedals: ``safebench``, or ``full-brake``, the default with a speed.
        steps: Environment steps of 0.1 s.
        round: Steps between two evaluations.
        seed: Seed of everything random.
        map: Packaged ``town``, or an ``.xodr`` file.
        simulator: Simulator of the drives.
        physics: How vehicles respond to pedals and steering: ``kinematic`` or ``lagged``.
        speed: Speed of the ego [km/h] within the speed limits, 110 for the limits alone; None for SafeBench's speed.
        progress: Called with what is done.

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
