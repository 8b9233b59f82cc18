"""Kept scenes, from a run folder to files in a format."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from chatscene.errors import ChatSceneError, MapError, RunError, SettingsError
from chatscene.exports.exporter import Exporter, KeptScene, MapFile, load_exporter
from chatscene.files.alone import alone_in
from chatscene.files.atomic import write_whole
from chatscene.maps.network import check_given
from chatscene.runs import (
    RunRecord,
    open_run,
    read_drawing,
    read_episodes,
    read_programs,
    read_record,
    read_scenes,
    require_done,
    route_index,
)
from chatscene.runs.rebuild import map_of, rebuild
from chatscene.runs.trust import Repeated, follow
from chatscene.terms.polyline import Polyline
from chatscene.terms.scene import ScenicProgram


@dataclass(frozen=True, slots=True, kw_only=True)
class Exported:
    """What an export wrote.

    Attributes:
        files: The names of the files of each scene, by its id; one that several scenes need stands with each.
    """

    folder: Path
    files: dict[str, tuple[str, ...]]

    def __str__(self) -> str:
        """A line per file."""
        names = dict.fromkeys(name for of_scene in self.files.values() for name in of_scene)
        return "\n".join(str(self.folder / name) for name in names)


def export(folder: Path, scene_ids: Sequence[str] = (), *, to: str, out: Path) -> Exported:
    """Write scenes of a run as files in a format; what is stored is copied, and nothing is simulated or executed.

    Raises:
        SettingsError: There is no such exporter, it breaks its contract, or the folder is not empty.
        RunError: The run has no such scene, it was never driven, or it keeps none.
        MapError: The run's map is not there any more, or is none that can be used.
    """
    exporter = load_exporter(to)
    if out.exists() and not out.is_dir():
        raise SettingsError(f"{out} is a file; name a new folder to export to")
    if out.is_dir() and any(out.iterdir()):
        raise SettingsError(f"{out} is not empty, and an export overwrites nothing; name a new folder")
    with alone_in(out):
        found = [(scene, _files(exporter, to, scene)) for scene in kept_scenes(folder, scene_ids)]
        written: dict[str, bytes] = {}
        for scene, files in found:
            for name, content in files.items():
                if written.setdefault(name, content) != content:
                    raise SettingsError(
                        f"exporter {to!r} gives {name!r} for {scene.episode.scene_id!r} and for another scene, "
                        "each other"
                    )
        try:
            for name, content in written.items():
                write_whole(out / name, content)
        except OSError as error:
            raise SettingsError(f"cannot write to {out}: {error.strerror}") from error
    return Exported(folder=out, files={scene.episode.scene_id: tuple(files) for scene, files in found})


def kept_scenes(folder: Path, scene_ids: Sequence[str] = ()) -> Iterator[KeptScene]:
    """Scenes of a run with all that is kept of them; without ids, those that the run keeps.

    Raises:
        RunError: The run has no such scene, it was never driven, or it keeps none.
        MapError: The run's map is not there any more, or is none that can be used.
    """
    run = open_run(folder, RunRecord)
    record = read_record(run)
    if not scene_ids:
        require_done(run, record)
    rows = {row["scene_id"]: row for row in read_scenes(run, selected=not scene_ids, ids=scene_ids or None)}
    chosen = list(dict.fromkeys(scene_ids)) or list(rows)
    if not chosen:
        raise RunError(f"{run.path} keeps no scene; name one, scenes.parquet lists them")
    path = map_of(record)
    try:
        check_given(path)  # whoever wrote run.json chose the path, and only a map is to be copied
        where = MapFile(name=path.name, content=path.read_bytes())
    except OSError as error:
        raise MapError(f"map {path.name!r} cannot be read: {error.strerror} ({path})") from error
    programs = read_programs(run)

    def joined() -> ScenicProgram:
        if record.program is not None:
            raise RunError(
                f"{run.path} is of a program of your own, which an export does not execute; export what was driven: "
                "--to openscenario or --to csv"
            )
        follow(Repeated(), joining_of=(run,))
        made = rebuild(run)
        if made.generator != record.generator:
            raise RunError(
                f"an earlier version composed a snippet of {run.path}, and an export does not execute the program that "
                "the folder keeps; export what was driven: --to openscenario or --to csv"
            )
        return made.program

    ways = read_drawing(run).get("routes", {})
    for episode in read_episodes(run, chosen):
        row = rows[episode.scene_id]
        way = ways.get(f"{row['scenario_id']}/{row['route_id']}")
        yield KeptScene(
            episode=episode,
            text=record.title,
            program=programs.get(row["scenario_id"], ""),
            values={name: value for name, value in row.items() if name.startswith("OPT_") and value is not None},
            route=route_index(row["route_id"]),
            map=where,
            way=Polyline(way) if way else None,
            joined=joined,
        )


def _files(exporter: Exporter, name: str, scene: KeptScene) -> dict[str, bytes]:
    """What an exporter, which may be anybody's, gives of a scene."""
    try:
        files = dict(exporter.files(scene))
    except ChatSceneError:
        raise
    except Exception as error:
        raise SettingsError(
            f"exporter {name!r} fails on {scene.episode.scene_id!r}: {type(error).__name__}: {error}"
        ) from error
    for file in files:
        if Path(file).name != file:
            raise SettingsError(f"exporter {name!r} gives {file!r}, which is not the plain name of a file")
    return files
