"""What a run of five thousand scenes costs: processor time, memory, folder, report, and opening its page.

    python benchmarks/many_scenes.py [--seed 0] [--out FOLDER] [10 500]

A sentence on ten routes, with so many scenes on each, one job. Where Chromium is, it opens the page without a screen
and ends when the scripts have run; the processor time of an empty page is taken off, and the least of three counts.
"""

from __future__ import annotations

import argparse
import shutil
import tempfile
from pathlib import Path

from waited_for import SENTENCE, cost, cost_of_ours

ROUTES = 10
OPENINGS = 3
CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")


def opening(address: str) -> float:
    """Processor time [s] of Chromium, in one process, for a page."""
    flags = ("--headless", "--no-sandbox", "--single-process", "--no-zygote", "--disable-gpu", "--dump-dom")
    with tempfile.TemporaryDirectory() as profile:
        return min(cost(str(CHROMIUM), *flags, f"--user-data-dir={profile}", address)[0] for _ in range(OPENINGS))


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("scenes", nargs="*", type=int, default=(10, 500))
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--out", help="where the runs stay, instead of a folder that is removed")
    given = parser.parse_args()
    empty = opening("about:blank") if CHROMIUM else 0.0
    print("scenes  run [s]  peak [MB]  folder [MB]  files  report [MB]  open [s]")
    with tempfile.TemporaryDirectory() as temporary:
        for scenes in given.scenes:
            folder = Path(given.out or temporary, f"run-{scenes}")
            asked = ("--routes", str(ROUTES), "--scenes", str(scenes), "--seed", str(given.seed), "--jobs", "1")
            run = ["run", SENTENCE, "--ego", "idm", *asked, "--out", str(folder)]
            cpu, peak = cost_of_ours(*run)
            sizes = [path.stat().st_size for path in folder.rglob("*") if path.is_file()]
            report = folder / "report.html"
            opened = opening(report.resolve().as_uri()) - empty if CHROMIUM else float("nan")
            print(
                f"{ROUTES * scenes:>6} {cpu:>8.1f} {peak:>10.0f} {sum(sizes) / 1e6:>12.1f} {len(sizes):>6} "
                f"{report.stat().st_size / 1e6:>12.2f} {opened:>9.2f}",
                flush=True,
            )


if __name__ == "__main__":
    main()
