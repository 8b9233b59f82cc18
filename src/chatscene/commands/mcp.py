"""The command line, continued: a server for agents."""

from __future__ import annotations

import os
from pathlib import Path

import click

from chatscene.commands.output import say


@click.command()
@click.argument("folder", metavar="FOLDER", type=click.Path(path_type=Path, file_okay=False))
@click.option("--http", is_flag=True, help="Serve HTTP on loopback with a token, instead of the standard streams.")
@click.option("--port", default=0, type=click.IntRange(0, 65535), help="Port on loopback.  [default: a free one]")
@click.option(
    "--language-model",
    default="offline",
    show_default=True,
    help="Reader of sentences: offline, openai:MODEL, or gguf:FILE.",
)
def mcp(folder: Path, http: bool, port: int, language_model: str) -> None:
    """Serve the Model Context Protocol, so agents can make, drive and judge scenes in FOLDER. Needs the extra 'mcp'.

    Agents can read and write only in FOLDER, and their programs run in the sandbox. An agent starts this command itself
    and uses its standard streams. --http serves on loopback instead, and requires a token: CHATSCENE_MCP_TOKEN, or a
    new one, which is printed.

    \b
    chatscene mcp scenes
    chatscene mcp scenes --http --port 8765
    """
    from chatscene.mcp.transports import TOKEN, serve_http, serve_stdio
    from chatscene.mcp.walls import served_model

    reading = {"language_model": served_model(language_model)}
    if port and not http:
        raise click.UsageError("--port needs --http")
    if not http:
        serve_stdio(folder, reading)
        return
    serve_http(folder, reading, port, os.environ.get(TOKEN, ""), say)
