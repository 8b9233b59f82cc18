"""How a broken rule is told."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

Plugin = TypeVar("Plugin")


class ContractBroken(AssertionError):  # noqa: N818 - reads as what it says
    """A plug-in breaks a rule of its kind; the message says which, and how."""


def require(holds: bool, rule: str, found: object = "") -> None:
    """Hold a plug-in to a rule.

    Raises:
        ContractBroken: It does not.
    """
    if not holds:
        raise ContractBroken(f"{rule}; found: {found}" if found != "" else rule)


def maker(plugin: str | Callable[[], Plugin], load: Callable[[str], Plugin]) -> Callable[[], Plugin]:
    """How fresh ones of a plug-in are made: by its name, or by its factory."""
    return (lambda: load(plugin)) if isinstance(plugin, str) else plugin
