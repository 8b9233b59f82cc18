"""What is worked out of a network, or of an element of it, once, and kept on that element, which goes with its map."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

Kept = TypeVar("Kept")


def kept(element: Any, name: str, make: Callable[[Any], Kept]) -> Kept:
    """What was made of an element before, else what is made of it now.

    What a lane knows of its network is a weak reference, and elements of two maps may be equal: so nothing is
    remembered by them, but on them. There is at most one of each name for each element.

    Args:
        element: Scenic's network, or a lane or junction of it.
        name: What it is called there; nothing of Scenic's own.
        make: Makes it of the element, always the same.
    """
    there = getattr(element, name, None)
    if there is None:
        there = make(element)
        setattr(element, name, there)
    return there
