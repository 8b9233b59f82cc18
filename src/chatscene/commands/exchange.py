"""The command line, continued: scenes out to other tools, and scenarios in from them."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import click

import chatscene
from chatscene.commands.options import EXPORTERS, JSON, TOLD, Named, param_option, usable_map
from chatscene.commands.output import say


@click.command()
@click.argument("folder", metavar="RUN", type=click.Path(path_type=Path))
@click.argument("scenes", metavar="[SCENE]...", nargs=-1)
@click.option(
    "--to",
    required=True,
    cls=Named,
    kind=EXPORTERS,
    help=f"The format: {TOLD}, or package.module:factory.",
)
@click.option(
    "--out",
    type=click.Path(path_type=Path),
    required=True,
    help="A new folder, or an empty one.",
)
@JSON
def export(folder: Path, scenes: tuple[str, ...], as_json: bool, **options: Any) -> None:
    """Write each SCENE of RUN as files for other tools. Without SCENE, all kept scenes are written.

    With openscenario, every road user follows its driven trajectory. Most formats come with the map.

    \b
    chatscene export runs/cyclist --to openscenario --out exported/cyclist
    chatscene export runs/cyclist cyclist-1f2e/route-00/scene-017 --to csv --out exported/tracks
    """
    done = chatscene.export(folder, scenes, **options)
    say(json.dumps({"folder": str(done.folder), "files": done.files}) if as_json else str(done))


@click.command("import")
@click.argument("file", metavar="FILE|FOLDER", type=click.Path(path_type=Path))
@click.option(
    "--out",
    type=click.Path(path_type=Path),
    help="The .scenic file to write; for FOLDER, a new folder.  [default: beside FILE, with its name]",
)
@click.option(
    "--map",
    metavar="MAP",
    callback=usable_map,
    help="A packaged map or an .xodr file.  [default: the map that FILE names]",
)
@click.option("--ego", metavar="NAME", help="The ego in FILE.  [default: the one named ego, else the first vehicle]")
@click.option(
    "--variant", type=click.IntRange(min=1), metavar="N", help="Import only set N of a file of parameter values."
)
@param_option("Set a parameter that FILE declares.")
@JSON
def import_scenario(
    file: Path,
    out: Path | None,
    map: str | None,  # noqa: A002 - the name of the option
    ego: str | None,
    variant: int | None,
    param: dict[str, object],
    as_json: bool,
    **options: Any,
) -> None:
    """Convert an OpenSCENARIO XML file, or each one in a folder, to a Scenic program. Runs nothing.

    FILE is a scenario (.xosc), or a file of parameter values, which gives a program for each set of values. Paths in
    FILE to catalogs and the map are relative to its folder. An element that cannot be imported is refused, and its
    line is named. `run --program` and `verify` take the programs.

    \b
    chatscene import cut-in.xosc
    chatscene import cut-in.xosc --map Town04.xodr --ego Car1 --out mine.scenic
    chatscene import variations.xosc --variant 3
    chatscene import theirs --out mine

    FOLDER needs --out. Every .xosc file below FOLDER is imported there, and a table shows the result of each.
    """
    from chatscene.imports.import_folder import import_folder

    if file.is_dir():
        if out is None or variant is not None or param:
            raise click.UsageError(
                "a folder needs --out, a new folder for its programs, and takes neither --variant nor --param"
            )
        folder = import_folder(file, out, map_name=map, ego=ego)
        say(json.dumps([one.as_dict() for one in folder.files]) if as_json else str(folder))
        return
    done = chatscene.import_scenario(file, out=out, map=map, ego=ego, variant=variant, param=param, **options)
    told = {
        "program": str(done.program),
        "programs": [str(one) for one in done.programs],
        "map": str(done.map_path),
        "maps": [str(one) for one in done.maps],
        "notes": done.notes,
        "command": done.command,
    }
    say(json.dumps(told) if as_json else str(done))
