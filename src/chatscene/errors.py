"""Every error chatscene raises, as one tree below `ChatSceneError`.

A message says what happened, where, and what to do.
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any


class ChatSceneError(Exception):
    """Base of every error that is ours; the command line shows it without a traceback."""


class SettingsError(ChatSceneError):
    """A setting or an argument is out of range or names nothing known."""


class MissingExtra(ChatSceneError):  # noqa: N818
    """Something needs an optional package; the message names the extra that brings it."""

    def __init__(self, what: str, *, extra: str, package: str = "chatscene") -> None:
        super().__init__(f"{what}, which is not installed; install it with: {_install(package, extra)}")


def _install(package: str, extra: str) -> str:
    """The command that brings an extra from where the package itself was installed: no index need have it."""
    # Only who lacks something waits for these.
    import json
    from importlib.metadata import PackageNotFoundError, distribution
    from urllib.parse import urlsplit
    from urllib.request import url2pathname

    try:
        origin = json.loads(distribution(package).read_text("direct_url.json") or "{}")
    except (PackageNotFoundError, ValueError):
        return f'pip install -e ".[{extra}]" in a checkout of {package}'
    url = str(origin.get("url", ""))
    if not url:
        return f'pip install "{package}[{extra}]"'
    if url.startswith("file:"):
        editable = "-e " if origin.get("dir_info", {}).get("editable") else ""
        return f'pip install {editable}"{url2pathname(urlsplit(url).path)}[{extra}]"'
    vcs = origin.get("vcs_info", {}).get("vcs")
    return f'pip install "{package}[{extra}] @ {f"{vcs}+" if vcs else ""}{url}"'


@dataclass(frozen=True, slots=True, kw_only=True)
class OfferedReading:
    """What a sentence may say, for the user to take.

    Attributes:
        number: Its place among those that are offered, from 1; the option ``--reading`` takes it.
        told: What it says, in plain sentences.
        probability: That every fact of it is right.
        settled_by: The fact that makes it sure enough once it is stated, as the option ``--set`` takes it; empty if no
            single one does.
    """

    number: int
    told: str
    probability: float
    settled_by: str = ""

    def as_dict(self) -> dict[str, Any]:
        """For a script."""
        return {
            "reading": self.number,
            "text": self.told,
            "probability": self.probability,
            "settled_by": self.settled_by,
        }


class NothingFits(ChatSceneError):  # noqa: N818 - reads as what it says: nothing fits
    """Nothing serves what was said: it is not sure what that is, or there is no program for it.

    Attributes:
        reasons: What was not understood or cannot be done, in a user's words, the weightiest first.
        confidence: How sure it was that the sentence can be served; None where that was not asked.
        nearest: The snippets that came nearest, by id, with what they do.
        understood: What was read, fact by fact, in words; empty if that was not asked.
        readings: What the sentence may say instead, each of which can be taken; the likeliest first.
        text: The sentence as it was read; empty if that was not asked.
        words: What became of each word of it, as in `explanation.json`.
    """

    def __init__(
        self,
        message: str,
        *,
        reasons: tuple[str, ...] = (),
        confidence: float | None = None,
        nearest: Mapping[str, str] | None = None,
    ) -> None:
        super().__init__(message)
        self.reasons = reasons or (message,)
        self.confidence = confidence
        self.nearest = dict(nearest or {})
        self.understood = ""
        self.readings: tuple[OfferedReading, ...] = ()
        self.text = ""
        self.words: tuple[dict[str, Any], ...] = ()


class EditRefused(ChatSceneError):  # noqa: N818 - reads as what it says
    """An edit has words that were not understood, contradicts itself or what stays, or changes nothing.

    Attributes:
        words: The words that were not understood; none where all were.
    """

    def __init__(self, message: str, *, words: tuple[str, ...] = ()) -> None:
        super().__init__(message)
        self.words = words


class MapError(ChatSceneError):
    """A map is missing, broken, or has not the geometry that was asked for."""


class UnreadRoad(MapError):  # noqa: N818
    """A road of a map cannot be made into lanes.

    Attributes:
        road: Its id.
    """

    def __init__(self, message: str, *, road: str) -> None:
        super().__init__(message)
        self.road = road


class SituationError(ChatSceneError):
    """A written situation has a fault; the message names the line, the path and what could stand there."""


class NotBuilt(NothingFits):
    """A situation has a fact that cannot be built; the message names the fact and what it lacks."""


class NothingBuilds(NotBuilt):
    """No code builds what was said, at whatever speed the ego drives."""


class NoSuchPlace(NotBuilt):
    """No map has a place with all that was said of the road; each fact may be there alone."""


class NoSuchRoad(NoSuchPlace):
    """No map has such a road, however short, whatever others need there."""


class RoadTooShort(NotBuilt):
    """An ego at the speed that was said is past others before they have done all that was said."""


class SnippetError(ChatSceneError):
    """A snippet file is malformed or its code does not keep the contract in its header."""


class ProgramError(ChatSceneError):
    """A Scenic program failed a rung of the validation ladder."""


class ForeignCodeRefused(ProgramError):  # noqa: N818
    """A program by a stranger uses what strangers may not use, or lacks what every program has."""


class NamesNotClosed(ProgramError):  # noqa: N818
    """A name is used that neither the world model nor any part of the program defines."""


class DoesNotCompile(ProgramError):  # noqa: N818
    """Scenic refuses the text of the program."""


class Unsatisfiable(ProgramError):  # noqa: N818
    """No scene could be sampled within the tries allowed."""


class MeansSomethingElse(ProgramError):  # noqa: N818
    """The program runs, but its tracks do not show what the sentence says.

    Attributes:
        blamed: Ids of the snippets that do not show it together; none for a program that has none.
    """

    def __init__(self, message: str, *, blamed: tuple[str, ...] = ()) -> None:
        super().__init__(message)
        self.blamed = blamed


class SimulationError(ChatSceneError):
    """A simulation could not be run to its end."""


class StuckBehavior(SimulationError):  # noqa: N818
    """Code did not come back in its time, such as a behavior that never yields control to the simulator.

    Attributes:
        within: The time it had, in words.
    """

    def __init__(self, message: str, *, within: str = "") -> None:
        super().__init__(message)
        self.within = within


class Diverged(SimulationError):  # noqa: N818
    """A replay differs from the stored tracks."""


class ServerError(SimulationError):
    """A simulator's server is not there, is another than the one that is needed, refuses something, or was lost."""


class SandboxError(SimulationError):
    """The process for strangers' programs could not be made, or does not answer."""


class ProgramStopped(SandboxError):  # noqa: N818 - reads as what it says
    """A stranger's program was stopped: it used up what it may, tried what it may not, or answered nonsense."""


class EgoError(ChatSceneError):
    """An ego could not be loaded, or returned something that is not an action."""


class ScenarioError(ChatSceneError):
    """A scenario in another tool's format cannot be read, or says what cannot be said here."""


class RunError(ChatSceneError):
    """A run folder cannot be written, read or continued."""


class QueryError(ChatSceneError):
    """A query over runs is no SQL, asks for what there is not, or would do more than read the index."""


class LanguageModelError(ChatSceneError):
    """A language model gave no usable reply in time."""


class NoUsableReply(LanguageModelError):  # noqa: N818 - reads as what it says
    """A language model replied as often as it was asked, and no reply could be used."""


def no_such(what: str, name: str, known: Iterable[str]) -> str:
    """The message for a name that nothing has: what was meant, the nearest known one, and all of them."""
    names = sorted(known)
    near = difflib.get_close_matches(name, names, n=1)
    hint = f"did you mean {near[0]!r}? " if near else ""
    if not names:
        return f"there is no {what} {name!r}, and none is known"
    return f"there is no {what} {name!r}; {hint}known: {', '.join(names)}"
