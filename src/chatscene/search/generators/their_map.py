"""On which map a program of somebody else's runs, and what there is to say of it: none stands in for another unsaid."""

from __future__ import annotations

from pathlib import Path

from chatscene.maps.carla_towns import PACKAGE, file_or_town, how_to_have
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
    found, gone = file_or_town(asked), f"the program's map {asked.name} does not exist"
    if found == str(asked):
        return found, ()
    if chosen is None and found is not None:
        return found, (f"{gone}; it runs on CARLA's {found} of the package {PACKAGE}",)
    brings = how_to_have(asked.stem) if chosen is None else ""
    return chosen, (f"{gone}; it runs on {chosen or TOWN}{brings}",)
