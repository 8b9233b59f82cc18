"""Scenes out to other tools, and scenarios in from them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from chatscene.api.arguments import Name, Names, folder_for, names_of, path_of
from chatscene.api.results import Run, folder_of

if TYPE_CHECKING:
    from chatscene.exports.export import Exported
    from chatscene.imports.import_file import ImportedScenario


def export(folder: Name | Run, scenes: Names = (), *, to: str, out: Name | None = None) -> Exported:
    """Write scenes of a run as files for other tools; simulates and runs nothing.

    Args:
        folder: A run, or its folder.
        scenes: Ids of the scenes; none for all kept scenes.
        to: An exporter by name, one of `chatscene.exports.exporter.EXPORTERS` such as ``openscenario`` or ``csv``, or
            ``package.module:factory``.
        out: A new or empty folder.

    Raises:
        SettingsError: There is no such exporter, or the folder is not empty.
        MissingExtra: The exporter needs a package that is not installed.
        RunError: The run has no such scene, the scene was never driven, or no scene is kept.
        MapError: The run's map no longer exists.
    """
    from chatscene.exports.export import export as export_scenes

    return export_scenes(folder_of(folder), names_of(scenes), to=to, out=folder_for(out))


def import_scenario(
    file: Name,
    *,
    out: Name | None = None,
    map: Name | None = None,  # noqa: A002 - the word of the command line
    ego: str | None = None,
    variant: int | None = None,
    param: Mapping[str, object] | None = None,
    within: Name | None = None,
) -> ImportedScenario:
    """Convert a scenario in OpenSCENARIO XML to a Scenic program, which `run` takes; runs nothing.

    Args:
        file: An ``.xosc`` file: a scenario, or parameter values for one, each set of which gives a program.
        out: The ``.scenic`` file, a new one; None for one beside it with its name.
        map: A packaged map or an ``.xodr`` file; None for the one that the file names by a path from its folder.
        ego: The ego's name in the file; None for the one that the file implies.
        variant: The number of one set of parameter values, from 1; None for all of them.
        param: Values, by name, that replace those in the file.
        within: Folder outside which the file's catalogs and map may not lie; None for anywhere.

    Raises:
        ScenarioError: It cannot be read, or has elements that cannot be imported; the message names each with its line.
        MapError: The map does not exist, or is broken.
        SettingsError: The program already exists, or there is no such variant.
    """
    from chatscene.imports.import_file import import_scenario as import_file

    return import_file(
        path_of(file),
        out=None if out is None else path_of(out),
        map_name=None if map is None else str(map),
        ego=ego,
        variant=variant,
        given=param,
        within=None if within is None else path_of(within),
    )
