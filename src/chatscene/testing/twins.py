"""The same place and the same start, with an adversary that does no harm: what an ego must drive through as if alone.

A test of avoiding alone is passed by an ego that always stands. So each scene has a twin in which nothing is to be
avoided. Candidates come nearest first; which of them is harmless is found by driving (`chatscene.testing.solvable`).
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

from chatscene.terms.scene import ScenicProgram

_BUILT = re.compile(r"^(\w+ = new \w+ at )[^\n]* with role 'adversary'[^\n]* with behavior (\w+)\(\)", re.MULTILINE)
_ASSEMBLED = re.compile(r"^(AdvAgent = new AdvClass at )", re.MULTILINE)
_WAYS = re.compile(r"\b(advTrajectory|way(?:[A-Z]|The_\w+)) = ")
_ENDS = re.compile(r" (?:until|for) .*")
AWAY = "(100000, 100000)"  # [m], beyond what anybody sees on any map


@dataclass(frozen=True, slots=True, kw_only=True)
class Twin:
    """A program whose adversary may be harmless."""

    program: ScenicProgram
    told: str


def without_adversary(program: ScenicProgram) -> ScenicProgram | None:
    """The program with the adversary far away from the map; None where nobody in it is one by name or role."""
    placed = _placed(program.source)
    source = _halted(program.source)
    found = placed and source and re.search(rf"^{re.escape(placed[0])}", source, re.MULTILINE)
    if not source or not found:
        return None
    return _with(program, f"{source[: found.end()]}{AWAY}{source[_end_of_value(source, found.end()) :]}")


def twins(program: ScenicProgram) -> tuple[Twin, ...]:
    """What may be harmless, the nearest to the program first; none where nobody in it is the adversary."""
    away = without_adversary(program)
    behavior = _behavior(program.source)
    if away is None or behavior is None:
        return ()
    before, first = _first_phase(behavior[1])
    way = next((one[1] for one in _WAYS.finditer(program.source) if one[1] in behavior[1]), "")
    told = {
        "never begins its act": f"{before}    {first}\n\n" if first else "",
        "stands where it starts": "    do Halt()\n\n",
        "drives on along its way": f"    do DrivePath({way}, 10)\n\n" if way else "",
    }
    near = [
        Twin(program=_with(program, _replaced(program.source, body)), told=words)
        for words, body in told.items()
        if body
    ]
    return (*near, Twin(program=away, told="is not there"))


def _placed(source: str) -> tuple[str, str] | None:
    """How the line begins that places the adversary, and what its behavior is called."""
    if (built := _BUILT.search(source)) is not None:
        return built[1], built[2]
    assembled = _ASSEMBLED.search(source)
    return (assembled[1], "AdvBehavior") if assembled is not None else None


def _behavior(source: str) -> re.Match[str] | None:
    """The adversary's behavior, with its body as the first group."""
    placed = _placed(source)
    if placed is None:
        return None
    return re.search(rf"^behavior {placed[1]}\(\):\n((?:(?:[ \t]+[^\n]*)?\n)+)", source, re.MULTILINE)


def _first_phase(body: str) -> tuple[str, str]:
    """What a behavior says before its first phase, and that phase without its end; no phase where it never ends."""
    before = ""
    for line in body.splitlines(keepends=True):
        if line.lstrip().startswith("do "):
            endless = _ENDS.sub("", line.strip())
            return before, endless if endless != line.strip() else ""
        before += line
    return before, ""


def _halted(source: str) -> str:
    return _replaced(source, "    do Halt()\n\n") if _behavior(source) else ""


def _replaced(source: str, body: str) -> str:
    behavior = _behavior(source)
    assert behavior is not None  # or there is no twin
    return f"{source[: behavior.start(1)]}{body}{source[behavior.end(1) :]}"


def _end_of_value(source: str, start: int) -> int:
    """Where the expression that begins at `start` ends: at the first comma or line end outside of brackets."""
    depth = 0
    for place in range(start, len(source)):
        sign = source[place]
        depth += (sign in "([{") - (sign in ")]}")
        if depth == 0 and sign in ",\n":
            return place
    return len(source)


def _with(program: ScenicProgram, source: str) -> ScenicProgram:
    return replace(program, source=source)
