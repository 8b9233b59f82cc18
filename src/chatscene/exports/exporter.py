"""In which formats scenes leave: one Protocol, and the files here that say their own name.

An exporter touches no file. It is handed a scene that was driven, and says what the files are to hold; so the same
scene gives the same bytes, and what cannot be exported leaves nothing behind.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Protocol
from urllib.parse import quote

from chatscene.errors import RunError
from chatscene.plugins import Kind, Packaged, make
from chatscene.terms.episode import Episode
from chatscene.terms.polyline import Polyline
from chatscene.terms.scene import ScenicProgram


@dataclass(frozen=True, slots=True, kw_only=True)
class MapFile:
    """The map that a scene lies on.

    Attributes:
        name: Of the file, such as ``town.xodr``.
        content: All of it, OpenDRIVE.
    """

    name: str
    content: bytes


def _unknown() -> ScenicProgram:
    raise RunError("the scene is of no program that can be joined again")


@dataclass(frozen=True, slots=True, kw_only=True)
class KeptScene:
    """All that a run kept of a scene that was driven.

    Attributes:
        episode: What happened: tracks, events, ending.
        text: What was asked for, in words; of a program of a user's own, its name.
        program: The Scenic program of its scenario, whose parameters take the values.
        values: The value of each ``OPT_`` parameter, in the unit its range declares.
        route: Which of the routes that the program's geometry asks for.
        map: Where it lies.
        way: The line of that route [m], map frame, as a run keeps it, to the centimetre; None where it keeps none.
        joined: The program once more, joined again of packaged snippets, so that it may be executed; raises RunError
            where there is none, as of a program of a user's own.
    """

    episode: Episode
    text: str
    program: str
    values: Mapping[str, float]
    route: int
    map: MapFile
    way: Polyline | None = None
    joined: Callable[[], ScenicProgram] = _unknown

    @property
    def stem(self) -> str:
        """What the scene's files are called before the dot: its id, as the name of a file."""
        return quote(self.episode.scene_id.replace("/", "-"), safe="")


class Exporter(Protocol):
    """Writes scenes in one format."""

    def files(self, scene: KeptScene) -> Mapping[str, bytes]:
        """What is to be written of a scene: content by the name of the file.

        A name has no folder in it. A file that several scenes need, such as the map, has one name and one content;
        all others have names of their own, which begin with the scene's `stem`. There is at least one.

        Raises:
            RunError: The scene lacks what the format needs.
        """
        ...


EXPORTERS: Kind[Exporter] = Kind(
    noun="exporter",
    group="chatscene.exporters",
    method="files",
    built_in=Packaged("exports"),
)


def load_exporter(name: str) -> Exporter:
    """An exporter by its name (`chatscene.plugins`).

    Raises:
        SettingsError: There is none of that name.
        MissingExtra: Its package is missing.
    """
    return make(EXPORTERS, name)
