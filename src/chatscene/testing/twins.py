"""The same place and the same start, with an adversary that does no harm: what an ego must drive through as if alone.

A test of avoiding alone is passed by an ego that always stands. So each scene has a twin in which nothing is to be
avoided. Candidates come nearest first; which of them is harmless is found by driving (`chatscene.testing.solvable`).
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

from chatscene.terms.scene import ScenicProgram

_BEHAVIOR = re.compile(r"^behavior AdvBehavior\(\):\n((?:(?:[ \t]+[^\n]*)?\n)+)", re.MULTILINE)
_PLACED = re.compile(r"^(AdvAgent = new AdvClass at )", re.MULTILINE)
_ENDS = re.compile(r" (?:until|for) .*")
AWAY = "(100000, 100000)"  # [m], beyond what anybody sees on any map


@dataclass(frozen=True, slots=True, kw_only=True)
class Twin:
    """A program whose adversary may be harmless.

    Attributes:
        program: It.
        told: What the adversary does in it.
    """

    program: ScenicProgram
    told: str


def without_adversary(program: ScenicProgram) -> ScenicProgram | None:
    """The program with the adversary far away from the map; None if nobody is called `AdvAgent` in it."""
    source = _halted(program.source)
    found = source and _PLACED.search(source)
    if not source or not found:
        return None
    return _with(program, f"{source[: found.end()]}{AWAY}{source[_end_of_value(source, found.end()) :]}")


def twins(program: ScenicProgram) -> tuple[Twin, ...]:
    """What may be harmless, the nearest to the program first; none where nobody is called `AdvAgent` in it."""
    away = without_adversary(program)
    behavior = _BEHAVIOR.search(program.source)
    if away is None or behavior is None:
        return ()
    before, first = _first_phase(behavior[1])
    told = {
        "never begins its act": f"{before}    {first}\n\n" if first else "",
        "stands where it starts": "    do Halt()\n\n",
        "drives on along its way": "    do DrivePath(advTrajectory, 10)\n\n"
        if "advTrajectory" in program.source
        else "",
    }
    near = [
        Twin(program=_with(program, _replaced(program.source, body)), told=words)
        for words, body in told.items()
        if body
    ]
    return (*near, Twin(program=away, told="is not there"))


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
    return _replaced(source, "    do Halt()\n\n") if _BEHAVIOR.search(source) else ""


def _replaced(source: str, body: str) -> str:
    return _BEHAVIOR.sub(lambda _: f"behavior AdvBehavior():\n{body}", source, count=1)


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
