"""The command line, continued: fine-tuning an ego on kept scenes."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

import click

from chatscene.commands.library import JSON, console, progress, say
from chatscene.settings import PHYSICS

if TYPE_CHECKING:
    from rich.table import Table

    from chatscene.learn.finetune import Finetuned

_SHOWN = {"collision_rate": "collision rate", "overall_score": "overall score", "completion": "completion"}

PHYSICS_THERE = click.option(
    "--physics", type=click.Choice(PHYSICS), default=None, help="Physics of the drives.  [default: that of the runs]"
)


@click.command()
@click.argument("sources", metavar="DIR...", nargs=-1, required=True, type=click.Path(path_type=Path))
@click.option("--ego", default="sac", show_default=True, help="sac, the file of an SAC policy, or its folder.")
@click.option("--teacher", default="", help="Learn a new policy from this ego instead of by reward: planner, idm, …")
@click.option("--preset", default="paper", show_default=True, help="Gradient steps: paper, one per step; released.")
@click.option(
    "--choice", default="paper", show_default=True, help="Routes that choose the checkpoint: paper or held-out."
)
@click.option("--episodes", default=500, show_default=True, help="Scenes driven.")
@click.option("--train-routes", default=8, show_default=True, help="Number of routes to train on; the rest test.")
@click.option("--reward", default="safebench", show_default=True, help="safebench or progress.")
@click.option("--ordinary-share", default=0.0, show_default=True, help="Share of the episodes on ordinary routes.")
@click.option("--simulator", default="", help="Simulator.  [default: that of the runs]")
@PHYSICS_THERE
@click.option("--seed", default=0, show_default=True)
@click.option(
    "--out", type=click.Path(path_type=Path, file_okay=False), required=True, help="A new folder, or one to continue."
)
@JSON
def finetune(
    sources: tuple[Path, ...],
    ego: str,
    teacher: str,
    preset: str,
    choice: str,
    episodes: int,
    train_routes: int,
    reward: str,
    ordinary_share: float,
    simulator: str,
    physics: str | None,
    seed: int,
    out: Path,
    as_json: bool,
) -> None:
    """Fine-tune an SAC ego on the kept scenes of the runs in DIR..., or teach a new one; show it before and after.

    Scenes on the first eight routes train, the others test. Needs the extra 'train'. The same command goes on after a
    kill.

    \b
    chatscene benchmark --budget paper --out bench
    chatscene finetune bench/scenes/straight-obstacle --out egos/hardened
    chatscene finetune bench/scenes --teacher planner --ordinary-share 0.4 --out egos/taught
    chatscene evaluate bench/scenes/turning-obstacle --ego egos/hardened/policy.npz
    """
    from chatscene import api

    tuned = api.finetune(
        sources,
        out,
        ego=ego,
        teacher=teacher,
        preset=preset,
        choice=choice,
        episodes=episodes,
        train_routes=train_routes,
        reward=reward,
        ordinary_share=ordinary_share,
        simulator=simulator,
        physics=physics,
        seed=seed,
        progress=progress(),
    )
    say_finetuned(tuned, as_json)


def say_finetuned(tuned: Finetuned, as_json: bool) -> None:
    """Say what a fine-tuning came to."""
    if as_json:
        told = {"folder": str(tuned.folder), "chosen": tuned.chosen, "before": tuned.before, "after": tuned.after}
        say(json.dumps(told))
        return
    console().print(_before_and_after(tuned))
    for row in tuned.curve:
        if "collision_rate" in row:
            say(
                f"{row['episode']:5} episodes  collision rate {row['collision_rate']:.3f}"
                f"  completion {row['completion']:.3f}  overall score {row['overall_score']:.3f}"
                + ("  kept" if row == tuned.chosen else "")
            )
    say(f"kept: {tuned.reason}")
    if tuned.skipped:
        say(f"{len(tuned.skipped)} scenes could not be driven; run.json says why")
    policy = tuned.folder / "policy.npz"
    say(f"the ego is in {policy}; drive with it: --ego {policy}")


def _before_and_after(tuned: Finetuned) -> Table:
    from rich.table import Table

    table = Table(title="Before and after", title_justify="left")
    table.add_column("driven")
    table.add_column("n", justify="right")
    for name in _SHOWN.values():
        table.add_column(name, justify="right")
    for part, before in tuned.before.items():
        after = tuned.after[part]
        cells = [_change(before.get(name), after.get(name)) for name in _SHOWN]
        table.add_row(part, f"{before.get('n', before.get('drives', 0)):.0f}", *cells)
    return table


def _change(before: float | None, after: float | None) -> str:
    return "" if before is None or after is None else f"{before:.3f} \N{RIGHTWARDS ARROW} {after:.3f}"
