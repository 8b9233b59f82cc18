"""A process that gives up everything but computing and then becomes somebody else's program.

Started as ``python -I -m`` with its name, a file descriptor and what it is to become. What it has given up the program
does not get back: the kernel's walls outlast the change. Only the watchman inside Python goes with Python.
"""

from __future__ import annotations

import json
import os
import sys

from chatscene.simulate.confined.confinement import KERNEL, Limits, check_layers, give_up


def main() -> None:
    """Say which walls stand, and become the program if they are enough."""
    channel, asked = int(sys.argv[1]), json.loads(sys.argv[2])
    command = asked["command"]
    layers = give_up(Limits(**asked["limits"]), asked["readable"], command[0])
    os.write(channel, " ".join(layers).encode())
    os.close(channel)
    check_layers(layers, KERNEL)
    os.execve(command[0], command, asked["environment"])


if __name__ == "__main__":
    main()
