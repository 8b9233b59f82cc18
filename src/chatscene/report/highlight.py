"""Colours for a Scenic program, as HTML."""

from __future__ import annotations

import html
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


def highlight(source: str) -> str:
    """The program as HTML, with its tokens in spans of class ``comment``, ``string``, ``tuned`` and so on."""
    pieces: list[str] = []
    end = 0
    for token in _TOKEN.finditer(source):
        text = html.escape(token.group())
        pieces += [html.escape(source[end : token.start()]), f'<span class="{token.lastgroup}">{text}</span>']
        end = token.end()
    return "".join([*pieces, html.escape(source[end:])])
