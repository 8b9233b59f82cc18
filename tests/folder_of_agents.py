"""A folder in which an agent works, with a call of every tool that succeeds in it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import chatscene
from chatscene.mcp.folder import LONGEST, Folder
from chatscene.mcp.tool import Desk
from chatscene.mcp.tools import TOOLS
from chatscene.mcp.working import answered

CROSSES = "A pedestrian crosses from the right."
SITUATION = """others:
- {id: A, kind: pedestrian, starts: {where: roadside, side: right}, does: [{act: cross}]}
"""
TABLE = """time,id,kind,x,y,heading,speed,ego
0,car1,car,0,0,0,10,1
8,car1,car,80,0,0,10,1
0,walker,pedestrian,45,-6,1.5708,0,0
1.5,walker,pedestrian,45,-6,1.5708,0,0
1.6,walker,pedestrian,45,-6,1.5708,1.5,0
8,walker,pedestrian,45,3.6,1.5708,1.5,0
"""
CATALOGUE = f'[[entry]]\nname = "one"\nsentence = "{CROSSES}"\n'
SECRET = "nobody outside may see this"
OUTSIDE = ("secret.yaml", "secret.csv", "secret.toml", "secret.xosc", "secret.scenic", "secret.xodr", "secret.txt")
"""Files beside the folder."""

CALLS: dict[str, dict[str, Any]] = {
    "vocabulary": {"about": "cut-in"},
    "read": {"sentence": CROSSES},
    "build": {"file": "crosses.yaml"},
    "verify": {"what": "drive.csv", "said_file": "crosses.yaml"},
    "story": {"what": "drive.csv"},
    "edit": {"file": "crosses.yaml", "edit": "make it a child"},
    "run": {"file": "crosses.yaml", "scenes": 2, "out": "runs/again"},
    "why": {"run": "runs/brakes"},
    "rate": {"run": "runs/brakes", "scenes": 2},
    "coverage": {"catalogue": "one.toml"},
    "export": {"run": "runs/brakes", "to": "csv", "out": "exported"},
    "import": {"file": "crash.xosc", "save_as": "imported.scenic"},
}
"""Of each tool, arguments that are right in a folder with a run."""


def furnished(folder: Path) -> Path:
    """The same folder with files, and links that lead out of it; beside it is a file that is none of the agent's."""
    folder.mkdir(parents=True)
    (folder / "crosses.yaml").write_text(SITUATION)
    (folder / "drive.csv").write_text(TABLE)
    (folder / "one.toml").write_text(CATALOGUE)
    outside = folder.parent / "outside"
    outside.mkdir()
    for name in OUTSIDE:
        (outside / name).write_text(SECRET)
        (folder / f"link-{name}").symlink_to(outside / name)
    (folder / "link").symlink_to(outside)
    return folder


def furnished_with_run(folder: Path) -> Path:
    """The same, with a run, and with a scene of it as OpenSCENARIO beside its map."""
    made = furnished(folder)
    chatscene.run("The car ahead brakes hard.", made / "runs" / "brakes", scenes=4)
    chatscene.export(made / "runs" / "brakes", to="openscenario-logical", out=made / "xosc")
    first = sorted(made.glob("xosc/*scene-*.xosc"))[0]
    (made / "crash.xosc").write_bytes(first.read_bytes())
    (made / "town.xodr").write_bytes((made / "xosc" / "town.xodr").read_bytes())
    return made


def paths_of(tool: str) -> list[str]:
    """The arguments of a tool that are paths, as their length says."""
    longest = {name: one.get("maxLength") for name, one in TOOLS[tool].schema["properties"].items()}
    return [name for name, most in longest.items() if most == LONGEST]


def desk_in(folder: Path) -> Desk:
    return Desk(Folder(folder))


def called(folder: Path, tool: str, **arguments: Any) -> dict[str, Any]:
    """What a tool answers in the working folder, without a server."""
    return answered(desk_in(folder), {"tool": tool, "arguments": arguments})
