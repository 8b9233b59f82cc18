"""What the printed tables of docs/lab/paper-tables.md say beyond their cells; nothing is simulated.

    python benchmarks/printed_tables.py

How much of the overall score is the collision rate (tables 4 and 5), how far the two protocols of table 3 lie apart,
and how often the egos crash that the scenes were not kept for (table 4).
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

RESULTS = Path(__file__).parents[1] / "docs" / "lab" / "paper-tables.md"
METHODS = ("chatscene", "adversarial-trajectory", "advsim", "learning-to-collide", "carla-scenario-generator")
BASES = 8
Table = dict[str, list[float]]


def printed(first: str, until: str) -> Table:
    """Our rows between two headings: a row's label to its numbers on the eight base scenarios."""
    text = RESULTS.read_text(encoding="utf-8")
    part = text[text.index(first) :]
    part = part[: part.index(until)] if until else part
    rows: Table = {}
    for line in part.splitlines():
        label, *cells = [cell.strip() for cell in line.strip("|").split("|")]
        if label != "*paper*" and len(cells) == BASES + 1 and re.match(r"\d", cells[0]):
            rows[label] = [float(cell.split()[0]) for cell in cells[:BASES]]
    return rows


def score_from_collisions() -> tuple[float, float, float, int]:
    """Of the line through overall score over collision rate: value at 0, slope, share explained, number of cells."""
    rates, scores = printed("## Table 4", "## Table 5"), printed("## Table 5", "")
    x, y = (np.array([table[label] for label in rates]).ravel() for table in (rates, scores))
    slope, start = np.polyfit(x, y, 1)
    return float(start), float(slope), float(np.corrcoef(x, y)[0, 1] ** 2), x.size


def between_protocols() -> tuple[float, float, int]:
    """Standard deviation between the two protocols of a cell; of an average of eight for one training; cells."""
    first = printed("## Table 3", "### Checkpoints chosen on held-out routes")
    second = printed("### Checkpoints chosen on held-out routes", "### Beyond the paper")
    apart = np.array([[*first[f"CR, {method}"]] for method in METHODS])
    apart -= np.array([second[f"CR, {method}"] for method in METHODS])
    deviation = float(apart.std())
    return deviation, deviation / np.sqrt(2 * BASES), apart.size


def transfer() -> dict[str, float]:
    """The collision rate of PPO and TD3, which the scenes were not kept for, by method."""
    rates = printed("## Table 4", "## Table 5")
    return {method: float(np.mean([rates[f"{ego}, {method}"] for ego in ("ppo", "td3")])) for method in METHODS}


def main() -> None:
    """Print all three."""
    start, slope, share, cells = score_from_collisions()
    print(f"overall score = {start:.3f} - {-slope:.3f} x collision rate, R² = {share:.3f} ({cells} cells)")
    deviation, average, cells = between_protocols()
    print(
        f"between the protocols of table 3: {deviation:.2f} a cell ({cells} cells), {average:.2f} an average of eight"
    )
    for method, rate in transfer().items():
        print(f"transfer to PPO and TD3: {rate:.3f} {method}")


if __name__ == "__main__":
    main()
