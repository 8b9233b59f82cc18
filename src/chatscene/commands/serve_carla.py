"""The command line, continued: a stand-in for a CARLA server."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import click

from chatscene.commands.options import SIMULATORS, Named
from chatscene.commands.output import say
from chatscene.errors import ChatSceneError
from chatscene.settings import PHYSICS, SimulationSettings

if TYPE_CHECKING:
    from carla_stand_in.world import World

NOT_HERE = (
    "the stand-in for CARLA is a package of its own, which is not installed; install it from a checkout of chatscene: "
    "pip install ./packages/carla-stand-in"
)
LOOPBACK = "127.0.0.1"
PORTS = click.IntRange(1, 65534)  # streams are on the next


@click.command("serve-carla")
@click.option(
    "--map",
    "maps",
    multiple=True,
    default=("town",),
    show_default=True,
    help="The packaged 'town', 'outskirts' or 'region', or an .xodr file; the first is loaded, clients can load "
    "the others.",
)
@click.option("--port", default=2000, show_default=True, type=PORTS, help="Port for calls; streams use the next one.")
@click.option(
    "--host",
    default=LOOPBACK,
    show_default=True,
    help="Address to listen on. Anyone who can reach it controls the world.",
)
@click.option(
    "--files",
    metavar="DIR",
    type=click.Path(exists=True, file_okay=False, path_type=Path),
    help="Folder for clients' recordings. [default: a private temporary folder]",
)
@click.option(
    "--simulator",
    cls=Named,
    kind=SIMULATORS,
    default=SimulationSettings().simulator,
    show_default=True,
    help="Simulator that moves the bodies.",
)
@click.option(
    "--physics",
    type=click.Choice(PHYSICS),
    default=SimulationSettings().physics,
    show_default=True,
    help="How vehicles respond to pedals and steering: kinematic, or lagged (delays and a friction circle).",
)
def serve_carla(maps: tuple[str, ...], port: int, host: str, files: Path | None, simulator: str, physics: str) -> None:
    """Serve CARLA 0.9.16's protocol with our own simulator, for clients without a CARLA server.

    It is a stand-in, not CARLA: no tyres, no engine, drawings as camera images. docs/carla.md lists what it supports.
    This command and its clients need the wheel carla 0.9.16 (the extra 'carla'). The server is a package of its own,
    packages/carla-stand-in; a checkout that is installed with -e includes it.

    \b
    chatscene serve-carla --port 2000 --files runs
    chatscene serve-carla --map Town01.xodr --map Town04.xodr --physics lagged
    """
    try:
        from carla_stand_in.serving import serve
    except ModuleNotFoundError as error:
        if error.name != "carla_stand_in":
            raise
        raise ChatSceneError(NOT_HERE) from None

    def ready(world: World) -> None:
        say(
            f"a stand-in for CARLA 0.9.16, not CARLA: {world.roads.name} on {host}, ports {port} and {port + 1}; "
            + (f"clients' files are in {files}" if files else "clients' files go to a private temporary folder")
        )

    settings = SimulationSettings(simulator=simulator, physics=physics)
    try:
        serve(maps, host, port, settings, files=files, ready=ready, log=partial(say, err=True))
    except KeyboardInterrupt:
        say("ended; clients must connect again to a new server")
