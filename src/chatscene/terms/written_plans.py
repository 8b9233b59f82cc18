"""The plans in a program's text, each with the lines on which its phases stand."""

from __future__ import annotations

import re
from bisect import bisect_right
from dataclasses import dataclass
from functools import lru_cache

from chatscene.errors import SnippetError
from chatscene.terms.plan import Plan
from chatscene.terms.plan_text import BEHAVIOR, parse_plan

_BEHAVIOR = re.compile(r"^behavior (\w+)\(\):\s*(?:#.*)?\n((?:[ \t]+.*\n|[ \t]*(?:#.*)?\n)+)", re.MULTILINE)
_DOES = re.compile(r"\s*do\b")


@dataclass(frozen=True, slots=True)
class WrittenPlan:
    """A plan where it is written.

    Attributes:
        lines: The line of the text on which each phase begins, from 1.
    """

    plan: Plan
    lines: tuple[int, ...]

    def phase_at(self, line: int) -> int:
        """The number of the phase that a line belongs to, from 0."""
        return max(bisect_right(self.lines, line) - 1, 0)


@lru_cache(maxsize=256)
def written_plans(source: str) -> dict[str, WrittenPlan | str]:
    """The behaviors without arguments in a program's text, by name: the plan of each, or why it is none."""
    found: dict[str, WrittenPlan | str] = {}
    for match in _BEHAVIOR.finditer(source):
        name, block = match.groups()
        first = source.count("\n", 0, match.start(2)) + 1
        try:
            plan = parse_plan(f"behavior {BEHAVIOR}():\n{block}")
        except SnippetError as error:
            found[name] = str(error)
            continue
        lines = tuple(first + i for i, line in enumerate(block.split("\n")) if _DOES.match(line))
        found[name] = WrittenPlan(plan, lines)
    return found
