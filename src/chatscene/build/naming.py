"""What somebody of a situation is called in a program."""

from __future__ import annotations


def name_of(one: str) -> str:
    """What somebody of an id is called: no word of Scenic or of the world."""
    plain = one.replace("-", "_")
    return plain if len(plain) == 1 and plain.isupper() else f"The_{plain}"
