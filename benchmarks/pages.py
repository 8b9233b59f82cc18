"""How large reports are, and what they cost a browser: of runs of 10, 100 and 1,000 scenes.

    python benchmarks/pages.py --out runs/pages

runs one sentence (seed 0, `idm`), opens each report five times in Chromium (1400 px, no motion) until its replay
stands, and prints bytes, processor time against that of the smallest run's page (medians), and the scripts' memory.
Runs that are there already are resumed. Needs what the tests need.
"""

from __future__ import annotations

import argparse
import statistics
import sys
import tempfile
from pathlib import Path

import chatscene
from chatscene.report.viewer import write_report

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from browser import Browser

TEXT = "A car runs the red light from the left."
RUNS = {10: 1, 100: 1, 1000: 2}  # routes by scenes
TIMES = 5


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, required=True, help="the folder that the runs go to")
    out = parser.parse_args().out
    pages = {scenes: page(out / str(scenes), scenes // routes, routes) for scenes, routes in RUNS.items()}
    least = 0.0
    for scenes, path in pages.items():
        costs = [cost(path) for _ in range(TIMES)]
        seconds, memory = (statistics.median(each) for each in zip(*costs, strict=True))
        least = least or seconds
        print(f"{scenes} scenes: {path.stat().st_size / 1e6:.2f} MB, {seconds / least:.1f} times, {memory:.1f} MB")


def page(folder: Path, scenes: int, routes: int) -> Path:
    """The report of a run, as it is written now."""
    if (folder / "run.json").exists():
        chatscene.resume(folder)
    else:
        chatscene.run(TEXT, folder, ego="idm", scenes=scenes, routes=routes)
    return write_report(folder)


def cost(path: Path) -> tuple[float, float]:
    """Processor time until the replay of a page stands [s], and its scripts' memory [MB]."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile, Browser(Path(profile)) as browser:
        browser.open(path.absolute().as_uri())
        browser.wait(
            "document.readyState === 'complete' && document.querySelector('#clock')?.textContent.includes(' of ')"
        )
        return browser.cost()


if __name__ == "__main__":
    main()
