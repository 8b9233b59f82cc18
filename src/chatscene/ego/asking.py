"""Ask an ego: the one way in which its code is run.

Whatever that code does, who asks gets what is asked for or an `EgoError` that says which ego failed, when, and where in
its file.
"""

from __future__ import annotations

import linecache
from collections.abc import Callable
from pathlib import Path
from traceback import walk_tb
from types import CodeType
from typing import Any

from chatscene.ego.observation import Observation
from chatscene.ego.policy import EgoPolicy, name_of, two_numbers
from chatscene.errors import ChatSceneError, EgoError, StuckBehavior
from chatscene.terms.actors import LIMITS, Limits
from chatscene.terms.pointing import SourcePlace, place_in, pointed, told
from chatscene.terms.scene import CAR, ScenicProgram

_PACKAGE = Path(__file__).parents[1]


def begin(ego: EgoPolicy, scene: str = "") -> None:
    """Tell an ego that an episode begins, if it wants to know: it forgets what was before.

    Args:
        ego: Which.
        scene: The id of what it is to drive, for the message.

    Raises:
        EgoError: Its `reset` fails.
    """
    if (reset := getattr(ego, "reset", None)) is None:
        return
    try:
        reset()
    except EgoError:
        raise  # of an ego within this one
    except (Exception, SystemExit) as error:
        raise failed(ego, error, f"before scene {scene!r}" if scene else "before a drive") from error


def answer(ego: EgoPolicy, observation: Observation, *, step: int, scene: str) -> tuple[float, float]:
    """Acceleration and steering, each a finite number.

    Args:
        ego: Which.
        observation: What it is shown.
        step: Of the drive, from 0, for the message.
        scene: The id of what is driven, for the message.

    Raises:
        EgoError: It fails, gives no answer in its time, or answers anything else.
    """
    try:
        return decide(ego, observation)
    except (Exception, SystemExit) as error:
        raise failed(ego, error, f"at step {step} of scene {scene!r}") from error


def decide(ego: EgoPolicy, observation: Observation) -> tuple[float, float]:
    """As `answer`, for an ego within another: whoever asks the outer one tells what was raised.

    Raises:
        EgoError: It answers with anything but two finite numbers.
    """
    action = ego.act(observation)
    try:
        return two_numbers(action)
    except EgoError as error:
        raise EgoError(f"{error}{_defined(ego.act)}") from error


def wanting(ego: EgoPolicy, speed: float | None) -> EgoPolicy:
    """An ego that wants to drive at a speed, where it can be told.

    Args:
        ego: Which.
        speed: What a program wants of its ego [m/s]; None where it wants nothing.

    Returns:
        It itself where nothing is wanted of it, or where it drives at a speed of its own.

    Raises:
        EgoError: Its `wanting` fails, or gives no ego.
    """
    return ego if speed is None else _other(ego, "wanting", speed)


def fitted(ego: EgoPolicy, program: ScenicProgram) -> EgoPolicy:
    """An ego that drives as a program has it, where it can be told: at the speed that it wants, in the body it has.

    Args:
        ego: Which.
        program: What it is to drive in.

    Raises:
        EgoError: Its `wanting` or its `driving` fails, or gives no ego.
    """
    ego = wanting(ego, program.wanted_speed)
    return ego if program.ego_limits == LIMITS[CAR] else driving(ego, program.ego_limits)


def driving(ego: EgoPolicy, body: Limits) -> EgoPolicy:
    """An ego that knows what it drives, where it can be told.

    Args:
        ego: Which.
        body: What its vehicle can do.

    Raises:
        EgoError: Its `driving` fails, or gives no ego.
    """
    return _other(ego, "driving", body)


def _other(ego: EgoPolicy, method: str, value: object) -> EgoPolicy:
    """What a method of an ego makes of it; it itself if it has no such method."""
    made: Callable[[object], Any] | None = getattr(ego, method, None)
    if made is None:
        return ego
    try:
        other = made(value)
    except (Exception, SystemExit) as error:
        raise failed(ego, error, f"as its {method} is called") from error
    if not callable(getattr(other, "act", None)):
        raise EgoError(
            f"the ego {name_of(ego)!r} fails as its {method} is called: that gives {type(other).__name__}, not an ego, "
            f"which has a method act{_defined(made)}"
        )
    return other


def failed(ego: EgoPolicy, error: BaseException, when: str) -> EgoError:
    """The error for an ego whose code fails: what it raised, where in its file, and the line.

    Args:
        ego: Whose.
        error: What it raised.
        when: When it did.
    """
    if isinstance(error, StuckBehavior):
        return EgoError(f"the ego {name_of(ego)!r} gave no action {when}: its drive was stopped after {error.within}")
    if isinstance(error, EgoError):
        return EgoError(f"the ego {name_of(ego)!r} fails {when}: {error}")
    said = f"the ego {name_of(ego)!r} fails {when}: "
    files = (frame.f_code.co_filename for frame, _ in walk_tb(error.__traceback__))
    file = next((one for one in files if not Path(one).is_relative_to(_PACKAGE)), "")
    place = place_in(error, file) if file else None
    if place is None or isinstance(error, ChatSceneError):
        return EgoError(said + told(error))
    return EgoError(f"{said}{told(error)}{_at(file, place)}".rstrip())


def _defined(method: Any) -> str:
    """Where a method of a user's own stands, and its line; empty if that is nowhere outside of this package."""
    code = getattr(getattr(method, "__func__", method), "__code__", None)
    if not isinstance(code, CodeType) or Path(code.co_filename).is_relative_to(_PACKAGE):
        return ""
    return _at(code.co_filename, SourcePlace(code.co_firstlineno))


def _at(file: str, place: SourcePlace) -> str:
    """A place in a file, and below it its line."""
    here = Path(file).relative_to(Path.cwd()) if Path(file).is_relative_to(Path.cwd()) else file
    return f" ({here}, line {place.line})\n{pointed(''.join(linecache.getlines(file)), place)}".rstrip()
