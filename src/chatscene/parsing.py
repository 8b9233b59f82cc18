"""Scenic's parser, with a quicker memory.

The parser tries each rule at each place of a text and remembers what came of it. What remembers, tells one token from
another and looks for the end of what was read takes nearly half of its time: the words of a rule are written out for a
log that nobody asked for, a token is looked up where it could be compared, and all tokens so far are copied for the
last of them. Here this is done without; the tree is the same.
"""

from __future__ import annotations

import token
from collections.abc import Callable
from functools import cache
from typing import Any


def parse_string(source: str, filename: str = "<unknown>") -> Any:
    """Scenic's syntax tree of a program.

    Args:
        source: Scenic text.
        filename: Where it is from, for errors.

    Raises:
        ScenicError: It is none. A faulty text may make the parser lose its way, which raises anything.
    """
    from scenic.syntax import parser

    quicken()
    return parser.parse_string(source, "exec", filename=filename)


@cache
def quicken() -> None:
    """Give Scenic's parser this memory, wherever it is called from in this process."""
    from pegen.parser import Parser
    from pegen.tokenizer import Tokenizer
    from scenic.syntax.parser import ScenicParser

    remembering = Parser.name.__qualname__
    for kind in ScenicParser.__mro__[:-1]:
        for name, rule in list(vars(kind).items()):
            if getattr(rule, "__qualname__", "") == remembering:
                own = rule.__wrapped__
                # What looks at one token is done sooner than looked up.
                setattr(kind, name, own if kind is Parser else _remembered(own))
    own_peek = Tokenizer.peek

    def peek(tokenizer: Any) -> Any:
        tokens = tokenizer._tokens
        return tokens[tokenizer._index] if tokenizer._index < len(tokens) else own_peek(tokenizer)

    patched: Any = (Parser, Tokenizer)
    patched[0].expect, patched[1].peek, patched[1].get_last_non_whitespace_token = _expect, peek, _last_token


def _remembered(rule: Callable[..., Any]) -> Callable[..., Any]:
    """A rule of the grammar that is tried once at each place."""
    name = rule.__name__

    def remembered(parser: Any, *given: Any) -> Any:
        tokenizer, found = parser._tokenizer, parser._cache
        key = tokenizer._index, name, given
        if key in found:
            tree, tokenizer._index = found[key]
            return tree
        tree = rule(parser, *given)
        found[key] = tree, tokenizer._index
        return tree

    setattr(remembered, "__wrapped__", rule)  # noqa: B010 - as the rule that it stands for
    return remembered


_KINDS = {**vars(token), **token.EXACT_TOKEN_TYPES}
"""The number of a kind of token, by its name or by what is written."""


def _expect(parser: Any, what: str) -> Any:
    """The next token, if it is what is written or of that kind."""
    found = parser._tokenizer.peek()
    if found.string == what or found.type == _KINDS.get(what):
        parser._tokenizer._index += 1
        return found
    return None


def _last_token(tokenizer: Any) -> Any:
    """The last of the tokens so far that is more than the end of a line or block; the first if none is."""
    tokens, found = tokenizer._tokens, None
    for at in range(tokenizer._index - 1, -1, -1):
        found = tokens[at]
        if found.type != token.ENDMARKER and not token.NEWLINE <= found.type <= token.DEDENT:
            break
    return found
