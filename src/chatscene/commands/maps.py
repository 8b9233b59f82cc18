"""The command line, continued: maps."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from chatscene.commands.options import JSON
from chatscene.commands.output import console, say
from chatscene.errors import SettingsError

if TYPE_CHECKING:
    from chatscene.maps.survey import MapDescription


WARNINGS = 5  # of netconvert's are shown


@click.group("map")
def map_group() -> None:
    """The maps that scenes run on."""


@map_group.command("info")
@click.argument("map_name", metavar="MAP", default="town")
@JSON
def show_map(map_name: str, as_json: bool) -> None:
    """Show what a map offers: junctions, lanes, and how many routes each base scenario finds.

    \b
    chatscene map info
    chatscene map info Town04.xodr
    """
    from chatscene.maps.network import resolve_map
    from chatscene.maps.survey import describe_map

    _show(describe_map(resolve_map(map_name)), as_json=as_json)


@map_group.command("check")
@click.argument("map_name", metavar="MAP")
def check_map_file(map_name: str) -> None:
    """Check that a map can be used, and report what is wrong with it.

    \b
    chatscene map check my-town.xodr
    """
    from chatscene.maps.network import resolve_map
    from chatscene.maps.survey import check_map

    problems = check_map(resolve_map(map_name))
    for problem in problems:
        say(problem)
    if problems:
        sys.exit(1)
    say("no problems found")


@map_group.command("import")
@click.argument("extract", metavar="FILE.osm", type=click.Path(path_type=Path))
@click.option(
    "--out",
    type=click.Path(path_type=Path),
    help="The .xodr file; default: the name of FILE.osm, in the working folder.",
)
@JSON
def import_map(extract: Path, out: Path | None, as_json: bool) -> None:
    """Make a map of the streets in an OpenStreetMap extract, and show what it offers.

    Traffic on the map keeps to the right, and the world is flat. Needs the extra 'osm'; Linux only.

    \b
    chatscene map import street.osm
    chatscene map import street.osm --out high-street.xodr
    """
    from chatscene.maps.joints import write_loadable
    from chatscene.maps.openstreetmap import read_extract
    from chatscene.maps.survey import check_map, describe_map
    from chatscene.simulate.confined.netconvert import convert

    out = out or Path(f"{extract.stem}.xodr")
    if out.suffix != ".xodr":
        raise SettingsError(f"a map's name ends in .xodr, and {str(out)!r} does not")
    if out.exists():
        raise SettingsError(f"{out} is there already; delete it, or give another name with --out")
    found = read_extract(extract)
    made = convert(extract, found)
    cuts = write_loadable(out, made.xodr, extract)
    _show(describe_map(out), as_json=as_json)
    notes = [f"netconvert: {warning}" for warning in made.warnings[:WARNINGS]]
    if (more := len(made.warnings) - WARNINGS) > 0:
        notes.append(f"netconvert: and {more} more warnings")
    notes += [f"left out: the joint at node {cut.node}, where its lanes end now; {cut.why}" for cut in cuts]
    if found.backways:
        notes.append(f"left out: {found.backways} service roads and tracks")
    if found.stacked:
        notes.append(
            f"on bridges, in tunnels or on a layer of their own: {', '.join(found.stacked)}; "
            "this world is flat, and where they cross another street traffic of both would meet"
        )
    for note in (*check_map(out), *notes):
        say(note, err=as_json)


def _show(description: MapDescription, *, as_json: bool) -> None:
    from dataclasses import asdict

    from chatscene.report.terminal import print_map

    if as_json:
        say(json.dumps(asdict(description), indent=1))
    else:
        print_map(console(), description)
