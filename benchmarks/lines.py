"""The lines of Python of each package of `src/chatscene`: code, docstrings, comments and blank lines.

python benchmarks/lines.py [FOLDER]
"""

from __future__ import annotations

import ast
import sys
from collections import Counter
from pathlib import Path

KINDS = ("code", "docstring", "comment", "blank")


def lines_of(text: str) -> Counter[str]:
    """How many lines of each kind a file has."""
    documented = {
        number
        for node in ast.walk(ast.parse(text))
        for one in (node.body if isinstance(getattr(node, "body", None), list) else ())
        if isinstance(one, ast.Expr) and isinstance(one.value, ast.Constant) and isinstance(one.value.value, str)
        for number in range(one.lineno, (one.end_lineno or one.lineno) + 1)
    }
    found = Counter[str]()
    for number, line in enumerate(text.splitlines(), 1):
        bare = line.strip()
        kind = "docstring" if number in documented else "comment" if bare.startswith("#") else "code"
        found[kind if bare or number in documented else "blank"] += 1
    return found


def main() -> None:
    root = Path(sys.argv[1] if len(sys.argv) > 1 else "src/chatscene")
    rooms: dict[str, Counter[str]] = {}
    for path in sorted(root.rglob("*.py")):
        room = rooms.setdefault(path.relative_to(root).parts[0], Counter())
        room.update(lines_of(path.read_text(encoding="utf-8")))
        room["files"] += 1
    rooms["all"] = sum(rooms.values(), Counter())
    print(f"{'':14}{'files':>9}{'lines':>9}" + "".join(f"{kind:>11}" for kind in KINDS))
    for name, room in sorted(rooms.items(), key=lambda one: -sum(one[1][kind] for kind in KINDS)):
        lines = sum(room[kind] for kind in KINDS)
        print(f"{name:14}{room['files']:9}{lines:9}" + "".join(f"{room[kind]:11}" for kind in KINDS))


if __name__ == "__main__":
    main()
