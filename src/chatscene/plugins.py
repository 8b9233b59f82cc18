"""One way for all kinds of plug-ins: what is built in, what installed packages bring, and what the user points at.

A name stands, in this order, for

1. what is built in;
2. an entry point that an installed package brings under the group of its kind, such as ``chatscene.samplers``;
3. ``package.module:factory``, the user's own, which is also looked for in the working folder.

Whatever is named is imported and run, so a name must come from the user: `chatscene.runs.trust` holds back those that
stand in a record only.
"""

from __future__ import annotations

import ast
import importlib
import os
import re
import sys
from collections.abc import Callable, Generator, Iterator, Mapping
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, Generic, NamedTuple, TypeVar

from chatscene.errors import ChatSceneError, MissingExtra, SettingsError, no_such
from chatscene.terms.nouns import with_article

Plugin = TypeVar("Plugin")
_HERE = Path(__file__).parent
_VALUE = re.compile(r"([\w.]+)\s*:\s*([\w.]+)\s*(?:\[\s*(\w+).*\]\s*)?")
_SAYS = re.compile(r"^PLUGIN = (\{.*?^\})", re.MULTILINE | re.DOTALL)


class Packaged(Mapping[str, str]):
    """What is built in of a kind, where each file that brings one says so itself: a new one is a file, and no more.

    Such a file has at its top level ``PLUGIN = {...}``, texts by texts, which are read and not run: ``name``;
    ``makes``, what its factory is called; ``needs``, the extra that it needs, if any; ``what``, a few words of help.
    What else it says is for the table of its page.
    """

    def __init__(self, package: str) -> None:
        """Those of the files below a package of ours, such as ``exports``."""
        self._package = package

    @cached_property
    def rows(self) -> Mapping[str, Mapping[str, str]]:
        """What each says of itself, by its name, sorted.

        Raises:
            ValueError: A file says it in another way, or says a name that another has.
        """
        found: dict[str, Mapping[str, str]] = {}
        for path in sorted((_HERE / self._package).rglob("*.py")):
            if (said := _SAYS.search(path.read_text(encoding="utf-8"))) is None:
                continue
            row = ast.literal_eval(said[1])
            if not {"name", "makes", "what"} <= row.keys() or row["name"] in found:
                raise ValueError(f"{path}: PLUGIN is to have a name of its own, makes, and what; it has {row}")
            module = ".".join(("chatscene", *path.relative_to(_HERE).with_suffix("").parts))
            found[row["name"]] = {"module": module, **row}
        return dict(sorted(found.items()))

    def __getitem__(self, name: str) -> str:
        """Where it is, as an entry point is written."""
        row = self.rows[name]
        return f"{row['module']}:{row['makes']}" + (f" [{row['needs']}]" if "needs" in row else "")

    def __iter__(self) -> Iterator[str]:
        """Their names, sorted."""
        return iter(self.rows)

    def __len__(self) -> int:
        """How many there are."""
        return len(self.rows)


def _never(_name: str) -> bool:
    return False


@dataclass(frozen=True, slots=True, kw_only=True)
class Kind(Generic[Plugin]):
    """A kind of plug-in.

    Attributes:
        noun: What one is called.
        group: Group of the entry points by which other packages bring theirs.
        method: Name of a method that each one has.
        built_in: What is packaged by name, each written as an entry point: ``module:factory``, and behind it in
            brackets the extra that it needs, if any. It is a table, or `Packaged`.
        forms: What else a user may type besides a name and ``package.module:factory``, in words.
        beyond: Whether what is typed is in one of these forms, and no name.
        error: What is raised for one that cannot be had.
        addressed: Which of the built-in ones are servers elsewhere, so that an address may follow after a colon.
    """

    noun: str
    group: str
    method: str
    built_in: Mapping[str, str]
    forms: tuple[str, ...] = ()
    beyond: Callable[[str], bool] = _never
    error: type[ChatSceneError] = SettingsError
    addressed: frozenset[str] = frozenset()


class _Entry(NamedTuple):
    """Where a name leads, as ``package.module:factory [extra]``, and which package says so."""

    name: str
    value: str
    group: str
    package: str = "chatscene"

    @property
    def parts(self) -> re.Match[str] | None:
        """The module, the factory and the extra; None if the value is not of that form."""
        return _VALUE.fullmatch(self.value)


def _installed(kind: Kind[Any]) -> list[_Entry]:
    """What installed packages bring of a kind."""
    # As much to import as a small command; who names what is built in does without.
    from importlib.metadata import entry_points

    found = entry_points(group=kind.group)
    return [_Entry(one.name, one.value, one.group, one.dist.name if one.dist else "chatscene") for one in found]


def names(kind: Kind[Any]) -> list[str]:
    """What is built in or installed, by name, sorted."""
    return sorted({*kind.built_in, *(entry.name for entry in _installed(kind))})


def without_address(kind: Kind[Any], name: str) -> str:
    """The name of what is built in, where it stands before an address; any other as it is."""
    bare = name.partition(":")[0]
    return bare if bare in kind.addressed else name


def make(kind: Kind[Plugin], name: str, *arguments: Any, **named: Any) -> Plugin:
    """A new plug-in by its name.

    Args:
        kind: Its kind.
        name: As in the head of this module.
        arguments: What its factory takes.
        named: What its factory takes by name.

    Raises:
        ChatSceneError: The error of its kind: there is none of that name, its code fails, whatever it raises, or what
            is made lacks the method; the message names the nearest.
        MissingExtra: A package that its extra brings is not installed.
    """
    entry = _find(kind, name)
    with _folder_kept(), nullcontext() if entry.group else _importable_from_here():
        factory, called = _imported(kind, entry)
        try:
            made = factory(*arguments, **named)
        except ChatSceneError:
            raise
        except (Exception, SystemExit) as error:
            raise kind.error(f"{kind.noun} {name!r}: {called!r} fails: {type(error).__name__}: {error}") from error
    if not callable(getattr(made, kind.method, None)):
        raise kind.error(
            f"{kind.noun} {name!r} gives {with_article(type(made).__name__)} without the method {kind.method}"
        )
    return made


def check_name(kind: Kind[Any], name: str) -> None:
    """Make sure that a name leads somewhere, before anything is begun for it; no code of it is run.

    Raises:
        ChatSceneError: The error of its kind: there is none of that name.
    """
    if not kind.beyond(name):
        _find(kind, name)


def _find(kind: Kind[Any], name: str) -> _Entry:
    """Where a name leads; one that the user points at is of no group."""
    bare = without_address(kind, name)
    if bare in kind.built_in:
        return _Entry(bare, kind.built_in[bare], kind.group)
    found = [entry for entry in _installed(kind) if entry.name == name]
    if len(found) > 1:
        places = ", ".join(sorted(entry.value for entry in found))
        raise kind.error(
            f"several packages define {with_article(kind.noun)} {name!r} ({places}); name one as module:factory"
        )
    if found:
        return found[0]
    module, colon, factory = name.partition(":")
    if not colon:
        forms = " or ".join(("", *kind.forms, "package.module:factory"))
        is_folder = f"; {name!r} is a folder" if os.path.isdir(name) else ""  # noqa: PTH112 - Path.is_dir() raises
        raise kind.error(f"{no_such(kind.noun, name, names(kind))};{forms}{is_folder}")
    if not all(part.isidentifier() for part in (*module.split("."), factory)):
        raise kind.error(f"{kind.noun} {name!r} is not of the form package.module:factory, such as my_stack.x:make")
    return _Entry(name, name, "")


def _imported(kind: Kind[Any], entry: _Entry) -> tuple[Any, str]:
    """What a name leads to, and what that is called in its module."""
    of, value = f"{kind.noun} {entry.name!r}", entry.value
    if (parts := entry.parts) is None:
        raise kind.error(f"{of}: {value!r}, which its package names, is not of the form package.module:factory")
    module, factory, extra = parts.groups()
    try:
        found = importlib.import_module(module)
    except (Exception, SystemExit) as error:
        ours = module.partition(".")[0]
        if extra and isinstance(error, ImportError) and (error.name or ours).partition(".")[0] != ours:
            raise MissingExtra(f"the {of} needs {error.name}", extra=extra, package=entry.package) from error
        raise kind.error(f"{of}: cannot import {value!r}: {type(error).__name__}: {error}") from error
    if not hasattr(found, factory):
        raise kind.error(f"{of}: module {module!r} has no {factory!r}")
    return getattr(found, factory), factory


@contextmanager
def _folder_kept() -> Generator[None]:
    """Let code change the working folder while it runs here: paths of a user are seen from where they were given."""
    try:
        here = Path.cwd()
    except FileNotFoundError:  # it is gone, and so is what lay in it
        yield
        return
    try:
        yield
    finally:
        os.chdir(here)


@contextmanager
def _importable_from_here() -> Generator[None]:
    """Let a user's own module be found in the working folder, behind all that is installed, and only for now."""
    if (here := str(Path.cwd())) in sys.path:
        yield
        return
    sys.path.append(here)
    try:
        yield
    finally:
        if here in sys.path:
            sys.path.remove(here)
