"""What the parts of a Scenic program are, to be coloured."""

from __future__ import annotations

import re

_KEYWORDS = (
    "model|param|behavior|monitor|do|until|for|while|if|elif|else|try|interrupt|when|with|at|facing|on|in|new|"
    "require|terminate|after|take|wait|return|def|class|import|from|as|and|or|not|is|None|True|False|record|"
    "setup|compose|scenario|abort|break|continue|pass|lambda|ahead|behind|left|right|of|by|seconds|steps|offset"
)

_TOKEN = re.compile(
    r"(?P<comment>#[^\n]*)"
    r'|(?P<string>"""[\s\S]*?"""|\'\'\'[\s\S]*?\'\'\'|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\')'
    r"|(?P<tuned>\bOPT_\w+)"
    rf"|(?P<keyword>\b(?:{_KEYWORDS})\b)"
    r"|(?P<number>\b\d+(?:\.\d+)?\b)"
    r"|(?P<actor>\b(?:ego|AdvAgent|AdvBehavior|AdvClass|egoRoute|egoSpawnPt|advTrajectory)\b)"
)


def highlight(source: str) -> list[tuple[str, str]]:
    """The program in pieces, each with its kind: ``comment``, ``string``, ``tuned`` and so on, or none."""
    pieces: list[tuple[str, str]] = []
    end = 0
    for token in _TOKEN.finditer(source):
        pieces += [("", source[end : token.start()]), (token.lastgroup or "", token.group())]
        end = token.end()
    return [*pieces, ("", source[end:])]
