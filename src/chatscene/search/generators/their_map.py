"""On which map a program of somebody else's runs, and what there is to say of it: none stands in for another unsaid."""

from __future__ import annotations

import os
from pathlib import Path

from chatscene.maps.carla_towns import INSTALL, PACKAGE, carla_town, is_town
from chatscene.maps.network import TOWN


def their_map(asked: Path | None, chosen: str | None) -> tuple[str | None, tuple[str, ...]]:
    """The map that a program names, if it is there; else the user's choice; else CARLA's town of that name.

    Args:
        asked: The map that the program names; None if it names none.
        chosen: The map that its user names, or None.

    Returns:
        The map by its file or name, None for the packaged town; and lines for a person, none where there is nothing to
        say.
    """
    if asked is None:
        return chosen, ()
    if os.path.isfile(asked):  # noqa: PTH113 - Path.is_file() raises for a path that the system refuses
        return str(asked), ()
    gone = f"the program's map {asked.name} is not there"
    if chosen is None and (town := carla_town(asked.stem)) is not None:
        return town.stem, (f"{gone}; it runs on CARLA's {town.stem} of the package {PACKAGE}",)
    brings = f"; `{INSTALL}` brings CARLA's towns" if chosen is None and is_town(asked.stem) else ""
    return chosen, (f"{gone}; it runs on {chosen or TOWN}{brings}",)
