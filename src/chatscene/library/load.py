"""The library of snippets: a folder for each component, with files in it (`chatscene.library.snippet_file`)."""

from __future__ import annotations

import ast
import difflib
from collections.abc import Collection, Iterator
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path

from chatscene.errors import SnippetError
from chatscene.library.snippet_file import ADVERSARY_CLASS, ENDING, read_snippets
from chatscene.parsing import parse_string
from chatscene.terms.scenario import Component
from chatscene.terms.snippet import Snippet

PACKAGED = Path(__file__).parent / "packaged"


@dataclass(frozen=True, slots=True)
class Library:
    """Snippets, sorted by id."""

    snippets: tuple[Snippet, ...]
    _by_id: dict[str, Snippet] = field(init=False, repr=False, compare=False)
    _hash: int = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "_by_id", {snippet.id: snippet for snippet in self.snippets})
        object.__setattr__(self, "_hash", hash(self.snippets))  # indexes are looked up by it, sentence by sentence

    def __hash__(self) -> int:
        return self._hash

    def __len__(self) -> int:
        return len(self.snippets)

    def __iter__(self) -> Iterator[Snippet]:
        return iter(self.snippets)

    def of(self, component: Component) -> tuple[Snippet, ...]:
        """The snippets of one component."""
        return tuple(snippet for snippet in self.snippets if snippet.component is component)

    def without_sites(self) -> Library:
        """Without the geometries of sites, which the town has not and which no sentence of ours is written for."""
        return Library(tuple(snippet for snippet in self.snippets if snippet.slots.site is None))

    def get(self, snippet_id: str) -> Snippet:
        """The snippet of that id.

        Raises:
            SnippetError: There is none; the nearest id is given.
        """
        if snippet_id in self._by_id:
            return self._by_id[snippet_id]
        near = difflib.get_close_matches(snippet_id, self._by_id, n=1, cutoff=0.3)
        hint = f"; did you mean {near[0]!r}?" if near else ""
        raise SnippetError(f"there is no snippet {snippet_id!r}{hint}")


def load_library(folder: Path | None = None) -> Library:
    """The packaged library, or that in a folder of the same layout.

    Raises:
        SnippetError: A file is malformed, or the folder has no snippet.
    """
    return _packaged() if folder is None else _load(folder)


@lru_cache(maxsize=4)
def library_with(folder: str = "") -> Library:
    """The packaged library and a user's own beside it.

    Raises:
        SnippetError: A file is malformed, or takes the id of a packaged snippet.
    """
    if not folder:
        return _packaged()
    packaged, own = _packaged(), _load(Path(folder))
    taken = sorted({s.id for s in own} & {s.id for s in packaged})
    if taken:
        raise SnippetError(f"{folder}: {', '.join(taken)}: a packaged snippet has this id; rename the file")
    return Library(tuple(sorted((*packaged, *own), key=lambda s: s.id)))


@lru_cache(maxsize=1)
def _packaged() -> Library:
    return _load(PACKAGED)


def _load(folder: Path) -> Library:
    paths = sorted(path for component in Component for path in (folder / component.value).glob(f"*{ENDING}"))
    if not paths:
        raise SnippetError(
            f"{folder} holds no snippet; a library has folders {', '.join(Component)} with {ENDING} files in them"
        )
    found: dict[str, tuple[Path, Snippet]] = {}
    for path in paths:
        for snippet in read_snippets(path):
            if snippet.id in found:
                raise SnippetError(f"{path}: {snippet.id} stands in {found[snippet.id][0]} already; rename one of them")
            found[snippet.id] = path, snippet
    return Library(tuple(snippet for _, (_, snippet) in sorted(found.items())))


def load_snippet(path: Path) -> Snippet:
    """Read a file with one snippet.

    Raises:
        SnippetError: It is malformed, or holds a family.
    """
    found = read_snippets(path)
    if len(found) != 1:
        raise SnippetError(f"{path} holds a family of {len(found)} snippets; here one is wanted")
    return found[0]


# What the code itself says


@dataclass(frozen=True, slots=True, kw_only=True)
class CodeNames:
    """The contract of a piece of Scenic, computed from the code.

    Attributes:
        requires: Names it reads that neither it nor the world model defines, sorted.
        provides: Names it defines at the top level, sorted.
        parameters: ``param OPT_… = Range(low, high)``: name to (low, high).
    """

    requires: tuple[str, ...]
    provides: tuple[str, ...]
    parameters: dict[str, tuple[float, float]]


def names_of(source: str, known: Collection[str]) -> CodeNames:
    """Compute the contract of a piece of Scenic from its syntax tree.

    Raises:
        SnippetError: It is not Scenic.
    """
    from scenic.core.errors import ScenicError

    try:
        tree = parse_string(source)
    except ScenicError as error:
        raise SnippetError(f"line {getattr(error, 'lineno', '?')}: {error}") from error
    except Exception as error:  # a parser that loses its way in a faulty text may raise anything
        raise SnippetError(
            f"Scenic's parser breaks off with {type(error).__name__}: {error}; look for an unclosed bracket or quote, "
            "and for an empty line within brackets"
        ) from error
    read: set[str] = set()
    bound: set[str] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Name):
            (read if isinstance(node.ctx, ast.Load) else bound).add(node.id)
        elif isinstance(node, ast.arg):
            bound.add(node.arg)
        elif isinstance(made := getattr(node, "className", None), str):  # Scenic's `new X` holds a text, no name
            read.add(made)
    read.discard(ADVERSARY_CLASS)
    provides = {name for node in tree.body for name in _defined(node)}
    return CodeNames(
        requires=tuple(sorted(read - bound - provides - set(known))),
        provides=tuple(sorted(provides)),
        parameters=parameters_in(tree),
    )


def _defined(node: ast.AST) -> Iterator[str]:
    """Names that one top-level statement defines."""
    if isinstance(name := getattr(node, "name", None), str):
        yield name
    if isinstance(node, ast.Assign):
        yield from (t.id for target in node.targets for t in ast.walk(target) if isinstance(t, ast.Name))


def parameters_in(tree: ast.AST) -> dict[str, tuple[float, float]]:
    """Parameters whose value is a literal range; Scenic parses ``param`` into its own node."""
    return {name: ends for name, value in stated_in(tree) if (ends := _range(value)) is not None}


def stated_in(tree: ast.AST) -> Iterator[tuple[str, ast.expr]]:
    """Every parameter that a program states, with its value."""
    for node in ast.walk(tree):
        name, value = getattr(node, "identifier", None), getattr(node, "value", None)
        if isinstance(name, str) and isinstance(value, ast.expr):
            yield name, value


def _range(value: ast.expr) -> tuple[float, float] | None:
    """The ends of ``Range(low, high)``, two numbers; None of all else."""
    match value:
        case ast.Call(func=ast.Name(id="Range"), args=[low, high], keywords=[]):
            try:
                return float(ast.literal_eval(low)), float(ast.literal_eval(high))
            except (ValueError, TypeError):
                return None
        case _:
            return None
