"""What a run folder may name without the user saying it again.

A `run.json` may come from a stranger, and what it names is loaded and run when it is followed: an ego, a generator, a
sampler, a simulator, snippets, an encoder, a language model. Followed without asking is only what cannot carry code:
names of what is packaged, and files of an ego's plain weights that are still those of the record. All else the user
must name, too, on the command line.
"""

from __future__ import annotations

import shlex
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from chatscene import runs
from chatscene.ego.files import is_plain
from chatscene.ego.policy import EGOS
from chatscene.errors import RunError
from chatscene.plugins import Kind, without_address
from chatscene.runs.digests import digest_of
from chatscene.search.generator import GENERATORS
from chatscene.search.sampler import SAMPLERS
from chatscene.settings import RetrievalSettings
from chatscene.simulate.simulator import SIMULATORS

_PACKAGED = asdict(RetrievalSettings())
_PROGRAMS: dict[str, Kind[Any]] = {"generator": GENERATORS, "sampler": SAMPLERS, "simulator": SIMULATORS}
_SIMULATING = ("simulator",)
_JOINING = ("generator", "library")
_READING = (*_JOINING, "sampler", "embedder", "language_model")


@dataclass(frozen=True, slots=True, kw_only=True)
class Repeated:
    """What the user names beside a run folder, by the name of its option."""

    ego: tuple[str, ...] = ()
    generator: tuple[str, ...] = ()
    sampler: tuple[str, ...] = ()
    simulator: tuple[str, ...] = ()
    library: tuple[str, ...] = ()
    embedder: tuple[str, ...] = ()
    language_model: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class _Named:
    """One thing that a record names, and why it is not followed unasked; empty if it is."""

    run: runs.Workspace
    option: str
    value: str
    doubt: str


def follow(
    repeated: Repeated,
    *,
    egos_of: Sequence[runs.Workspace] = (),
    simulators_of: Sequence[runs.Workspace] = (),
    reading_of: Sequence[runs.Workspace] = (),
    joining_of: Sequence[runs.Workspace] = (),
) -> None:
    """Refuse to follow run folders that name what only the user may.

    Args:
        repeated: What the user named as well.
        egos_of: Runs whose egos will be loaded.
        simulators_of: Runs whose simulators will be loaded.
        reading_of: Runs whose texts will be read and made into programs.
        joining_of: Runs whose programs will be joined again from the snippets that were chosen; no text is read.

    Raises:
        RunError: They name something that is neither packaged nor repeated; an ego's file is not that of the record
            any more; or the user named something that they do not.
    """
    named = [
        *(one for run in egos_of for one in _egos(run)),
        *(one for run in simulators_of for one in _code(run, _SIMULATING)),
        *(one for run in reading_of for one in _code(run, _READING)),
        *(one for run in joining_of for one in _code(run, _JOINING)),
    ]
    said: dict[str, tuple[str, ...]] = asdict(repeated)
    for one in named:
        if one.doubt and one.value not in said[one.option]:
            raise RunError(
                f"{one.run.path} names the {_words(one.option)} {one.value!r}, {one.doubt}: whoever wrote run.json "
                f"chose it. If you trust it, say so: --{_words(one.option, '-')} {shlex.quote(one.value)}"
            )
    for option, values in said.items():
        known = {one.value for one in named if one.option == option}
        if wrong := [value for value in values if value not in known]:
            there = f"it names {', '.join(map(repr, sorted(known)))}" if known else "it names none"
            where = (*egos_of, *simulators_of, *reading_of, *joining_of)[0].path
            raise RunError(f"{where} does not name the {_words(option)} {wrong[0]!r}; {there}")


def _words(option: str, joint: str = " ") -> str:
    return option.replace("_", joint)


def _egos(run: runs.Workspace) -> Iterator[_Named]:
    for ego, kept in runs.read_record(run, runs.Record).egos_named().items():
        path = Path(ego)
        if kept and path.is_file() and digest_of(path) != kept:
            raise RunError(f"the ego {ego} is not the file that {run.path} was made with (its SHA-256 differs)")
        packaged = ego in EGOS.built_in
        plain = packaged or is_plain(path)
        doubt = "which may run code of its own" if not plain else "of whose file it holds no SHA-256"
        yield _Named(run=run, option="ego", value=ego, doubt="" if packaged or (plain and kept) else doubt)


def _code(run: runs.Workspace, options: Sequence[str]) -> Iterator[_Named]:
    named = runs.read_record(run, runs.Record).code_named()
    for option in (option for option in options if option in named):
        value, kind = named[option], _PROGRAMS.get(option)
        packaged = value in kind.built_in if kind else value == _PACKAGED[option]
        if value or not packaged:
            doubt = "" if packaged else f"which is not {'a' if kind else 'the'} packaged one"
            if kind and without_address(kind, value) != value:
                doubt = "at an address that only a user may call"
            yield _Named(run=run, option=option, value=value, doubt=doubt)
