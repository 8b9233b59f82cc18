"""The tutorials are notebooks that hold what their cells said; `python tests/notebooks.py` has them say it again."""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

TUTORIALS = sorted((Path(__file__).parents[1] / "docs" / "tutorials").glob("*.ipynb"))
# Each cell in one process, as in a notebook; what a last expression is worth is left to `print`.
_KERNEL = """
import contextlib, io, json, sys
shared, said = {"__name__": "__main__"}, []
for cell in json.load(sys.stdin):
    with contextlib.redirect_stdout(io.StringIO()) as out:
        exec(cell, shared)
    said.append(out.getvalue())
print(json.dumps(said))
"""


def code_cells(notebook: dict[str, Any]) -> list[dict[str, Any]]:
    """The cells that are run."""
    return [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]


def printed(notebook: dict[str, Any], folder: Path) -> list[str]:
    """What each code cell of a notebook prints when it is run in a folder."""
    cells = ["".join(cell["source"]) for cell in code_cells(notebook)]
    done = subprocess.run(
        [sys.executable, "-c", _KERNEL],
        input=json.dumps(cells),
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def held(notebook: dict[str, Any]) -> list[str]:
    """What a notebook says that each code cell printed."""
    return ["".join(part for one in cell["outputs"] for part in one["text"]) for cell in code_cells(notebook)]


if __name__ == "__main__":
    for path in TUTORIALS:
        notebook = json.loads(path.read_text())
        with tempfile.TemporaryDirectory() as folder:
            for number, (cell, text) in enumerate(
                zip(code_cells(notebook), printed(notebook, Path(folder)), strict=True), 1
            ):
                output = {"name": "stdout", "output_type": "stream", "text": text.splitlines(keepends=True)}
                cell |= {"execution_count": number, "outputs": [output] if text else []}
        path.write_text(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n")
