"""What a tool is: a function whose arguments are checked by its own signature, and an answer of bounded size."""

from __future__ import annotations

import difflib
import inspect
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Annotated, Any, get_type_hints

from pydantic import BaseModel, ConfigDict, Field, ValidationError, create_model

from chatscene.errors import ChatSceneError
from chatscene.mcp.folder import LONGEST, Folder
from chatscene.runs.progress import Progress, silent

SCHEME = "chatscene"  # of the addresses of resources
MOST_FAULTS = 5  # of a call that are told
MOST_LISTED = 20  # lines of one kind in an answer
MOST_TEXT = 100_000  # characters of a text that a call may have

Path = Annotated[str, Field(min_length=1, max_length=LONGEST, description="A path below the folder.")]
Text = Annotated[str, Field(max_length=MOST_TEXT)]


class WrongArguments(ChatSceneError):  # noqa: N818 - reads as what it says
    """A call has arguments that its tool does not take; the message names each."""


@dataclass(frozen=True, slots=True)
class Desk:
    """What a tool works with.

    Attributes:
        reading: How sentences are read: options of `chatscene.explain`.
    """

    folder: Folder
    reading: Mapping[str, Any] = field(default_factory=dict[str, Any])
    progress: Progress = silent


@dataclass(frozen=True, slots=True)
class Answer:
    """What a tool says.

    Attributes:
        picture: A picture beside it, as PNG; empty for none.
    """

    text: str
    picture: bytes = b""


@dataclass(frozen=True, kw_only=True)
class Tool:
    """A row of the table of tools.

    Attributes:
        does: The function: a desk, then the arguments of a call by name. Its docstring tells agents what it does.
        writes: Whether it makes files in the folder.
    """

    name: str
    does: Callable[..., Answer | str]
    writes: bool = False

    @cached_property
    def arguments(self) -> type[BaseModel]:
        """The arguments as a model that checks them."""
        hints = get_type_hints(self.does, include_extras=True)
        _, *parameters = inspect.signature(self.does).parameters.values()
        fields: dict[str, Any] = {
            one.name: (hints[one.name], ... if one.default is one.empty else one.default) for one in parameters
        }
        config = ConfigDict(extra="forbid", allow_inf_nan=False)
        return create_model(f"{self.name}Arguments", __config__=config, **fields)

    @property
    def says(self) -> str:
        """What it does, for an agent."""
        return inspect.getdoc(self.does) or ""

    @property
    def schema(self) -> dict[str, Any]:
        """The JSON schema of its arguments."""
        made = self.arguments.model_json_schema()
        properties = {name: _plain(one) for name, one in made.get("properties", {}).items()}
        kept = {key: value for key, value in made.items() if key not in ("title", "description", "properties")}
        return {**kept, "properties": properties}

    def checked(self, given: Mapping[str, Any]) -> dict[str, Any]:
        """The arguments of a call.

        Raises:
            WrongArguments: They are none of its.
        """
        try:
            made = self.arguments.model_validate(given)
        except ValidationError as error:
            raise WrongArguments(self._faults(error)) from None
        return {name: getattr(made, name) for name in type(made).model_fields}

    def _faults(self, error: ValidationError) -> str:
        faults = error.errors(include_url=False)
        known = list(self.arguments.model_fields)
        told = [_fault(one, known) for one in faults[:MOST_FAULTS]]
        told += [f"and {len(faults) - MOST_FAULTS} more"] * (len(faults) > MOST_FAULTS)
        return f"{self.name}: {'; '.join(dict.fromkeys(told))}. It takes: {', '.join(known)}"


def first_of(lines: Sequence[str], more: str = "") -> list[str]:
    """The first of many lines, and how many more there are."""
    left_out = len(lines) - MOST_LISTED
    return [*lines[:MOST_LISTED], *[f"  and {left_out} more{more}"] * (left_out > 0)]


def short(value: object, most: int = 80) -> str:
    """A value as a message shows it."""
    shown = repr(value if not isinstance(value, str | bytes) else value[: 2 * most])
    return shown if len(shown) <= most else f"{shown[: most - 1]}…"


def _plain(said: dict[str, Any]) -> dict[str, Any]:
    """What an argument may be, without its title and without saying that it may be left out."""
    either = [one for one in said.get("anyOf", ()) if one.get("type") != "null"]
    said = {**said, **either[0]} if len(either) == 1 else said
    left_out = ("title", "anyOf") if len(either) == 1 else ("title",)
    return {
        key: value for key, value in said.items() if key not in left_out and not (key == "default" and value is None)
    }


_NO = {
    "string": "is not text",
    "int": "is not a whole number",
    "float": "is not a number",
    "finite": "is not a number",
    "bool": "is neither true nor false",
    "list": "is not a list",
    "dict": "is no mapping",
}
"""What is wrong with a value, by the first word of what pydantic calls the fault."""


def _fault(one: Any, known: list[str]) -> str:
    """A fault of an argument in words."""
    at = ".".join(str(step) for step in one["loc"])[:60]
    match one["type"]:
        case "extra_forbidden":
            near = difflib.get_close_matches(at, known, n=1)
            return f"there is no argument {at!r}" + (f"; did you mean {near[0]!r}?" if near else "")
        case "missing":
            return f"{at} is missing"
        case str(kind) if kind.endswith(("_type", "_parsing", "_number")) and kind.partition("_")[0] in _NO:
            return f"{at}: {short(one['input'])} {_NO[kind.partition('_')[0]]}"
        case _:
            said = str(one["msg"])
            return f"{at}: {said[0].lower()}{said[1:]}, not {short(one['input'])}"
