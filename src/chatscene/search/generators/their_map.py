"""On which map a program of somebody else's runs, and what there is to say of it: none stands in for another unsaid."""

from __future__ import annotations

from pathlib import Path

from chatscene.errors import MapError
from chatscene.maps.carla_towns import PACKAGE, file_or_town, how_to_have
from chatscene.maps.network import TOWN, resolve_map


def their_map(asked: Path | None, chosen: str | None) -> tuple[str | None, tuple[str, ...]]:
    """The user's choice; else the map that a program names, if it is there; else CARLA's town of that name.

    Returns:
        The map by its file or name, None for the packaged town; and lines for a person, none where there is nothing to
        say.
    """
    if asked is None:
        return chosen, ()
    found, gone = file_or_town(asked), f"the program's map {asked.name} does not exist"
    if chosen is not None:
        if found is not None and _same(found, chosen):
            return chosen, ()
        here = found == str(asked)
        return chosen, (f"{f'the program names the map {asked.name}' if here else gone}; it runs on {chosen}",)
    if found == str(asked):
        return found, ()
    if found is not None:
        return found, (f"{gone}; it runs on CARLA's {found} of the package {PACKAGE}",)
    return None, (f"{gone}; it runs on {TOWN}{how_to_have(asked.stem)}",)


def _same(found: str, chosen: str) -> bool:
    """Whether a map that is there and one that is chosen are one file."""
    try:
        return resolve_map(chosen).resolve() == resolve_map(found).resolve()
    except (MapError, OSError):  # which is said when it is read
        return False
