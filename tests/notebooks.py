"""The tutorials are notebooks that hold what their cells said; `python tests/notebooks.py` has them say it again."""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

TUTORIALS = sorted((Path(__file__).parents[1] / "docs" / "tutorials").glob("*.ipynb"))
# Each notebook in its folder, with its own names; one process for all, since to begin takes seconds. What a last
# expression is worth is left to `print`.
_KERNEL = """
import contextlib, io, json, os, sys
told = []
for folder, cells in json.load(sys.stdin):
    os.chdir(folder)
    shared, said = {"__name__": "__main__"}, []
    for cell in cells:
        with contextlib.redirect_stdout(io.StringIO()) as out:
            exec(cell, shared)
        said.append(out.getvalue())
    told.append(said)
print(json.dumps(told))
"""


def code_cells(notebook: dict[str, Any]) -> list[dict[str, Any]]:
    """The cells that are run."""
    return [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]


def printed(notebooks: Mapping[Path, dict[str, Any]]) -> list[list[str]]:
    """What each code cell of some notebooks prints when they are run, each in a folder."""
    given = [
        (str(folder), ["".join(cell["source"]) for cell in code_cells(notebook)])
        for folder, notebook in notebooks.items()
    ]
    done = subprocess.run(
        [sys.executable, "-c", _KERNEL], input=json.dumps(given), capture_output=True, text=True, check=False
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
            (said,) = printed({Path(folder): notebook})
            for number, (cell, text) in enumerate(zip(code_cells(notebook), said, strict=True), 1):
                output = {"name": "stdout", "output_type": "stream", "text": text.splitlines(keepends=True)}
                cell |= {"execution_count": number, "outputs": [output] if text else []}
        path.write_text(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n")
