"""Who struck whom, in words that hold of how the two touch."""

from __future__ import annotations

from chatscene.simulate.striking import Strike

_PARTS = {"front": "front", "rear": "rear", "left": "left side", "right": "right side"}
Touched = tuple[str, str]
"""What somebody is called, and which part of it is touched; the part is empty of a walker or a thing."""


def struck_in_words(how: Strike, ego: Touched, other: Touched, *, past: bool = False) -> str:
    """Such as *the ego runs into the car, front to rear*, or *the ego's left side touches the truck's right side*.

    Args:
        how: Who struck whom.
        ego: The ego, and where it is touched.
        other: The other, and where it is touched.
        past: Whether to tell it as something that was.
    """
    striker, struck = (ego, other) if how.by_ego else (other, ego)
    (one, its), (another, theirs) = ((name, _PARTS.get(part, "")) for name, part in (striker, struck))
    parts = f", {its} to {theirs}" if its and theirs else ""
    runs = "ran" if past else "runs"
    if how.each:
        return f"{one} and {another} {runs.removesuffix('s')} into each other{parts}"
    if how.runs_in:
        return f"{one} {runs} into {another}{parts or (f' with its {its}' if its else '')}"
    one, another = (f"{name}'s {part}" if part else name for name, part in ((one, its), (another, theirs)))
    return f"{one} {'touched' if past else 'touches'} {another}"
