"""The command line, continued: why a sentence was refused, what it may say, and how to go on."""

from __future__ import annotations

import errno
import json
import shlex
import sys
from collections.abc import Generator
from contextlib import contextmanager

from chatscene.commands.output import say
from chatscene.errors import ChatSceneError, MeansSomethingElse, NothingFits, SettingsError
from chatscene.report.refused import refusal, suggested

REFUSED = 3  # exit status


def no_such_name(error: Exception) -> ChatSceneError | None:
    """An error as ours where somebody named a file that no file system can have; None for any other."""
    if not (isinstance(error, OSError) and error.errno == errno.ENAMETOOLONG):
        return None
    name = str(error.filename)
    return SettingsError(
        f"no file or folder can be called {name[:20]!r}… ({len(name)} characters); give a shorter name"
    )


def complain(error: ChatSceneError, *, as_json: bool = False) -> None:
    """Say what went wrong, and as what; as JSON to who reads that."""
    say(f"{type(error).__name__}: {error}", err=True)
    if as_json:
        say(json.dumps({"error": type(error).__name__, "message": str(error)}, ensure_ascii=False))


@contextmanager
def refusing(text: str, embedder: str, as_json: bool) -> Generator[None]:
    """Says why a sentence was refused and what may be done, and ends with status 3; `text` is empty for a program."""
    try:
        yield
    except (NothingFits, MeansSomethingElse) as error:
        refuse(error, text, embedder, as_json)
        sys.exit(REFUSED)


@contextmanager
def going_on(text: str, embedder: str, as_json: bool, gone: list[int] | None) -> Generator[None]:
    """The same where several are run, of which the next has its turn whatever became of one."""
    if gone is None:
        with refusing(text, embedder, as_json):
            yield
        return
    try:
        yield
    except (NothingFits, MeansSomethingElse) as error:
        refuse(error, text, embedder, as_json)
        gone.append(REFUSED if text else 1)
    except ChatSceneError as error:
        complain(error)
        gone.append(1)


def refuse(error: NothingFits | MeansSomethingElse, text: str, embedder: str, as_json: bool) -> None:
    """Say why a sentence was refused, what it may say, or which one works."""
    if as_json:
        say(json.dumps(refusal(error, text, embedder), indent=1))
        return
    from chatscene.report.accounting import in_words, parts_of
    from chatscene.report.terminal import readings_in_words

    complain(error)
    readings = error.readings if isinstance(error, NothingFits) else ()
    if isinstance(error, NothingFits):
        if error.words:
            say(f"  {in_words(parts_of(error.text, error.words))}", err=True)
        if error.understood:
            say(f"  understood: {error.understood}", err=True)
        for name, does in error.nearest.items() if not readings else ():
            say(f"  nearest: {name}: {does}", err=True)
    for line in readings_in_words(readings):
        say(line, err=True)
    if text and not readings:
        say(f"This one works: chatscene explain {shlex.quote(suggested(text, embedder))}", err=True)
