"""What memory the system lets a process take, and that it was too little."""

from __future__ import annotations

import errno
import sys

from chatscene.errors import ChatSceneError, SettingsError

LEAST = 512 * 2**20  # bytes of address space; with three fifths of it a sentence is read for minutes
FOR_WORK = 1536 * 2**20  # bytes; with two thirds of it libraries that lack memory abort, which nobody can catch
ENOUGH = 2 * 2**30  # bytes; two scenes in the packaged town and their report take two thirds of it


def require_memory(least: int = LEAST) -> None:
    """Refuse to begin where the system gives a process so little that it would stand still, or end without a word.

    Args:
        least: How much it needs [bytes].

    Raises:
        SettingsError: It has less.
    """
    if (limit := _limit()) is not None and limit < least:
        needs = " to work on a run" if least > LEAST else ", several times that for a run"
        raise SettingsError(
            f"a process may take {limit // 2**20} MiB here (ulimit -v), and at least {least // 2**20} are needed{needs}"
        )


def lack_of_memory(error: Exception) -> SettingsError | None:
    """What to say of an error that comes of too little memory; None for any other.

    Libraries tell it in as many ways as there are: that a file cannot be mapped, a thread not started, a module not
    initialised. So where a process may take less than what is known to be enough, all that nobody foresaw counts.

    Args:
        error: What ended a command.
    """
    limit = _limit()
    little = limit is not None and limit < ENOUGH
    cause = next((one for one in _chain(error) if _told_as_such(one)), None)
    if cause is None and little and not isinstance(error, ChatSceneError):
        cause = error
    if cause is None:
        return None
    kept = "what was finished is kept: continue with chatscene resume DIR"
    reason = f"{type(cause).__name__}: {cause}".rstrip(": ").partition("\n")[0]
    if limit is None:
        return SettingsError(f"there is too little memory; {kept} ({reason})")
    return SettingsError(
        f"there is too little memory: a process may take {limit // 2**20} MiB here (ulimit -v), and a run needs "
        f"up to {ENOUGH // 2**20}, more on a large map; allow that; {kept} ({reason})"
    )


def _limit() -> int | None:
    """How much address space this process may take [bytes]; None for any."""
    if sys.platform == "win32":
        return None
    import resource

    limit, _ = resource.getrlimit(resource.RLIMIT_AS)
    return None if limit == resource.RLIM_INFINITY else limit


def _chain(error: BaseException) -> list[BaseException]:
    """An error and what it came of."""
    found, following = [error], error.__cause__ or error.__context__
    while following is not None and following not in found:
        found.append(following)
        following = following.__cause__ or following.__context__
    return found


def _told_as_such(error: BaseException) -> bool:
    return isinstance(error, MemoryError) or (isinstance(error, OSError) and error.errno == errno.ENOMEM)
