"""Nouns in messages and sentences: with their article, and more than one."""

from __future__ import annotations

import re
from functools import lru_cache

_AN = re.compile(
    r"(?:[aiAI]|[eE](?!u)|[oO](?!ne\b)|[uU](?!\b|ni(?!n|m|d(?!ir))|ti|s[eu])|[hH]our|SUV|HGV|MPV|8"
    r"|1[18](?=(?:\d{3})*(?!\d)))"  # eleven and eighteen, also of thousands
)


@lru_cache(maxsize=4096)
def with_article(noun: str) -> str:
    """A noun phrase after *a* or *an*."""
    return f"{'an' if _AN.match(noun) else 'a'} {noun}"


_IRREGULAR = {
    "man": "men", "woman": "women", "child": "children", "person": "people", "schoolchild": "schoolchildren",
    "passer-by": "passers-by", "other party in traffic": "other parties in traffic",
}  # fmt: skip
_TAIL = re.compile(r" (?:on|with|in|carrying|pushing|under|at|from) ")


@lru_cache(maxsize=4096)
def plural(noun: str) -> str:
    """The plural of a noun phrase; what follows its head stays."""
    tail = _TAIL.search(noun)
    head, rest = (noun[: tail.start()], noun[tail.start() :]) if tail else (noun, "")
    before, _, last = head.rpartition(" ")
    many = _IRREGULAR.get(last) or (f"{last}es" if last.endswith(("s", "x", "ch", "sh")) else f"{last}s")
    if last.endswith("y") and last not in _IRREGULAR and last[-2] not in "aeiou":
        many = f"{last[:-1]}ies"
    return f"{before} {many}{rest}".strip()
