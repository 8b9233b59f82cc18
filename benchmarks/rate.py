"""Whether `chatscene rate` tells what brute force finds, and with how many drives.

    python benchmarks/rate.py --out FOLDER

For each sentence and ego: `--brute` scenes with every value of the ranges alike; and from a run of twenty other such
scenes the rate, by `--scenes` further ones, with `--seeds` seeds. Prints the share of crashes with the adversary by
brute force with its interval; of the estimates, how many could be told, their mean, how many of their intervals meet
that of brute force and hold its share; and how many drives without weights have intervals as narrow.
"""

from __future__ import annotations

from pathlib import Path

import click
import numpy as np

import chatscene

CASES = (
    ("A car runs the red light from the left.", "planner"),
    ("A car pulls out from the left kerb.", "planner"),
    ("A car from the right runs the red light while we turn left.", "idm"),
)


@click.command()
@click.option("--brute", default=1200, show_default=True)
@click.option("--scenes", default=300, show_default=True)
@click.option("--seeds", default=6, show_default=True)
@click.option("--out", type=click.Path(file_okay=False, path_type=Path), required=True)
def main(brute: int, scenes: int, seeds: int, out: Path) -> None:
    for number, (text, ego) in enumerate(CASES):
        plain = {"ego": ego, "sampler": "random", "simulator": "native"}
        chatscene.run(text, out / f"{number}-brute", scenes=brute, seed=1, **plain)
        chatscene.run(text, out / f"{number}", scenes=20, seed=0, **plain)
        forced = chatscene.rate(out / f"{number}-brute", scenes=0).crash
        print(f"{text} {ego}: brute force, {brute} scenes: {forced}", flush=True)
        found = [chatscene.rate(out / f"{number}", scenes=scenes, seed=seed).crash for seed in range(seeds)]
        told = [one for one in found if one.probability is not None]
        if not told or forced.probability is None:
            print(f"  {len(told)} of {seeds} could be told; crashes seen: {[one.seen for one in found]}", flush=True)
            continue
        held = sum((one.low or 0) <= forced.probability <= (one.high or 0) for one in told)
        met = sum((one.low or 0) <= (forced.high or 0) and (forced.low or 0) <= (one.high or 0) for one in told)
        shares = np.array([one.probability for one in told])
        widths = np.array([(one.high or 0) - (one.low or 0) for one in told])
        p = forced.probability
        as_many = (2 * 1.96) ** 2 * p * (1 - p) / widths.mean() ** 2
        print(
            f"  {len(told)} of {seeds} told from {scenes + 20} scenes each: mean {shares.mean():.4f}, from "
            f"{shares.min():.4f} to {shares.max():.4f}; {held} hold what brute force found, {met} meet its interval; "
            f"as narrow as {as_many:.0f} drives without weights",
            flush=True,
        )


if __name__ == "__main__":
    main()
