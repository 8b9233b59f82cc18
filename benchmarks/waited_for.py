"""What a user waits for: the sentences that benchmarks of it share, and what a command costs."""

from __future__ import annotations

import subprocess
import sys

SENTENCE = "A cyclist rides out from the left and stops in front of us."
LATER = (
    "The car ahead brakes hard.",
    "While we turn left, a pedestrian runs across from behind a parked van.",
    "so this guy on a scooter just shot past on our right and cut in like it was nothing",
    "A truck backs out of a driveway and we have to stop for it.",
    "At the crossroads a van runs the red light from the right and clips us.",
)  # told in different ways, plainly and not
# In between, since the peak of a process begins with that of the one that it was started from.
_WATCHED = """
import resource, subprocess, sys
subprocess.run(sys.argv[1:], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
used = resource.getrusage(resource.RUSAGE_CHILDREN)
print(used.ru_utime + used.ru_stime, used.ru_maxrss / 1000)
"""


def cost(*command: str) -> tuple[float, float]:
    """Processor time [s] and peak memory [MB] of a command in a process of its own."""
    told = subprocess.run([sys.executable, "-c", _WATCHED, *command], check=True, capture_output=True, text=True)
    cpu, peak = map(float, told.stdout.split())
    return cpu, peak


def cost_of_ours(*words: str) -> tuple[float, float]:
    """What a command of `chatscene` costs, as `cost` says it."""
    return cost(sys.executable, "-m", "chatscene", *words)
