"""The command line, continued: egos that are trained on ordinary drives, and tuned on kept scenes."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

import chatscene
from chatscene.commands.options import (
    JSON,
    MANY,
    MAP,
    NEW_FOLDER,
    PHYSICS_OPTION,
    PHYSICS_THERE,
    SEED,
    SIMULATOR_OPTION,
    SIMULATOR_THERE,
    Finite,
    road_speed,
)
from chatscene.commands.output import console, progress, say

if TYPE_CHECKING:
    from rich.table import Table

    from chatscene.learn.finetune import Finetuned
    from chatscene.learn.train import Trained

_SHOWN = {"collision_rate": "collision rate", "overall_score": "overall score", "completion": "completion"}
_SELDOM = 0.1  # of its drives: who crashes or leaves the road more often has not learned to drive


@click.command()
@click.option("--algorithm", default="sac", show_default=True, help="sac, ppo or td3.")
@click.option(
    "--observation",
    default=None,
    help="What the ego sees: safebench, actors, road or traffic.  [default: safebench; with --speed, traffic]",
)
@click.option(
    "--reward",
    default="progress",
    show_default=True,
    help="What the ego is rewarded for: progress, metres along the route; safebench, SafeBench's reward.",
)
@click.option(
    "--pedals",
    default=None,
    help="How hard the ego can brake: safebench, 37.5 % of the brake pedal; full-brake, all of it."
    "  [default: safebench; with --speed, full-brake]",
)
@road_speed(
    "Speed of the ego in km/h, within the speed limits; other traffic scales with it. 'road': only the limits apply."
    "  [default: SafeBench's speed]"
)
@click.option(
    "--steps",
    default=60_000,
    show_default=True,
    type=click.IntRange(1, 10**9),
    help="Steps of 0.1 s, rounded up to whole rounds.",
)
@click.option(
    "--round",
    "round_",
    default=5_000,
    show_default=True,
    type=click.IntRange(1, 10**9),
    help="Steps between two evaluations; of a shorter training, all.",
)
@SEED
@MAP
@SIMULATOR_OPTION
@PHYSICS_OPTION
@NEW_FOLDER
def train(steps: int, round_: int, out: Path, **options: Any) -> None:
    """Train an ego on the ordinary drives of a map. Needs the extra 'train'.

    \b
    chatscene train --algorithm sac --out egos/sac
    chatscene train --speed road --out egos/at-speed
    chatscene evaluate runs/cyclist --ego egos/sac/policy.npz
    """
    if steps < round_:
        say(f"evaluated once, after all {steps} steps", err=True)
        round_ = steps
    if steps % round_:
        say(f"{-(-steps // round_) * round_} steps instead of {steps}: whole rounds of {round_} (--round)", err=True)
    trained = chatscene.train(out, steps=steps, round=round_, progress=progress(), **options)
    say_trained(trained, as_json=False)


@click.command()
@click.argument("sources", metavar="DIR...", nargs=-1, required=True, type=click.Path(path_type=Path))
@click.option("--ego", default="sac", show_default=True, help="sac, the file of an SAC policy, or its folder.")
@click.option("--teacher", default="", help="Learn a new policy from this ego instead of by reward: planner, idm, …")
@click.option(
    "--preset",
    default="paper",
    show_default=True,
    help="Gradient steps: paper, one per step; released, one per episode.",
)
@click.option(
    "--choice", default="paper", show_default=True, help="Routes on which the checkpoint is chosen: paper or held-out."
)
@click.option("--episodes", default=500, show_default=True, type=MANY, help="Scenes driven.")
@click.option(
    "--train-routes",
    default=8,
    show_default=True,
    type=MANY,
    help="Number of routes for training; the rest are for testing.",
)
@click.option(
    "--reward",
    default="safebench",
    show_default=True,
    help="What the ego is rewarded for: safebench, SafeBench's reward; progress, metres along the route.",
)
@click.option(
    "--ordinary-share",
    default=0.0,
    show_default=True,
    type=Finite(0.0, 1.0, max_open=True),
    help="Share of the episodes on ordinary routes.",
)
@SIMULATOR_THERE
@PHYSICS_THERE
@SEED
@NEW_FOLDER
@JSON
def finetune(sources: tuple[Path, ...], out: Path, as_json: bool, **options: Any) -> None:
    """Fine-tune an SAC ego on the kept scenes of the runs in DIR..., or teach a new one; compare before and after.

    Scenes on the first eight routes are for training, the others for testing. Needs the extra 'train'. Repeat the
    command to continue after an interruption.

    \b
    chatscene benchmark --budget paper --out bench
    chatscene finetune bench/scenes/straight-obstacle --out egos/hardened
    chatscene finetune bench/scenes --teacher planner --ordinary-share 0.4 --out egos/taught
    chatscene evaluate bench/scenes/turning-obstacle --ego egos/hardened/policy.npz
    """
    say_finetuned(chatscene.finetune(sources, out, progress=progress(), **options), as_json)


def say_trained(trained: Trained, as_json: bool) -> None:
    """Say how a training went, and how the ego drives that it kept."""
    if as_json:
        say(json.dumps({"folder": str(trained.folder), "best": trained.best}))
        return
    say("        of the route   of the drives           of the time  mean speed")
    say(" steps        driven  collided  off the road  off the road       [m/s]")
    for row in trained.curve:
        astray = f"{row['off_road_rate']:.1%}" if "off_road_rate" in row else "?"  # a round of an earlier version
        say(
            f"{row['steps']:6.0f}  {row['completion']:12.1%}  {row['collision_rate']:8.1%}  {astray:>12}"
            f"  {row['off_road']:12.1%}  {row['mean_speed']:10.2f}" + ("  kept" if row == trained.best else "")
        )
    best = trained.best
    policy = trained.folder / "policy.npz"
    say(f"the best of them is in {policy}; drive with it: --ego {policy}")
    faults = {"collides": best["collision_rate"], "leaves the road": best.get("off_road_rate", best["off_road"])}
    if told := [f"{does} in {share:.0%} of its drives" for does, share in faults.items() if share > _SELDOM]:
        say(f"it {' and '.join(told)}: it has not learned to drive yet; continue with more --steps")


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
