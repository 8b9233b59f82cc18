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
    """Write scenes of a run as files that other tools read; nothing is simulated or executed.

    Args:
        folder: A run, or its folder.
        scenes: Ids of the scenes; none for those that the run keeps.
        to: An exporter by name, one of `chatscene.exports.exporter.EXPORTERS` such as ``openscenario`` or ``csv``, or
            ``package.module:factory``.
        out: Where to; a new folder, or an empty one.

    Raises:
        SettingsError: There is no such exporter, or the folder is not empty.
        MissingExtra: The exporter needs a package that is not installed.
        RunError: The run has no such scene, it was never driven, or it keeps none.
        MapError: The run's map is not there any more.
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
    """Write a scenario of OpenSCENARIO XML as a Scenic program of one's own, which `run` takes; nothing of it is run.

    Args:
        file: An ``.xosc`` file: a scenario, or parameter values for one, each set of which gives a program.
        out: The ``.scenic`` file, a new one; None for one beside it with its name.
        map: A packaged map or an ``.xodr`` file; None for the one that the file names by a path from its folder.
        ego: What the file calls the ego; None where that is told by the file.
        variant: The number of one set of parameter values, from 1; None for all of them.
        param: Values of parameters in place of those in the file, by name.
        within: The folder in which catalogs and the map lie that the file names, if they may lie nowhere else.

    Raises:
        ScenarioError: It cannot be read, or says what cannot be said here; the message names each element and its line.
        MapError: The map is not there, or is broken.
        SettingsError: The program is there already, or there is no such variant.
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
