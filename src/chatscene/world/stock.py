"""What Scenic's own command simulates a program in; our own sessions are opened by the simulator itself."""

from __future__ import annotations

import importlib
from typing import Any


def stock_simulator(name: str, map_path: str) -> Any:
    """Scenic's simulator over a simulator of ours.

    Args:
        name: As in the table of simulators.
        map_path: The map.

    Raises:
        SettingsError: There is no simulator of that name, or Scenic's own loop cannot run it.
    """
    # By name and only when Scenic asks: simulators stand above the world model, which compiles without any.
    return importlib.import_module("chatscene.simulate.stock").scenic_simulator(name, map_path)
