"""CARLA's blueprints, of the one version that ours is modelled on, whatever is installed: Scenic's tables of them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, cast

from scenic.core.distributions import distributionFunction
from scenic.simulators.carla import _blueprintData as _tables

VERSION = "0.9.16"
_IDS: dict[str, list[str]] = _tables._IDS[VERSION]  # pyright: ignore[reportPrivateUsage]
_SIZES: dict[str, dict[str, float]] = _tables._DIMS[VERSION]  # pyright: ignore[reportPrivateUsage]

_deferred = cast("Callable[[Callable[..., Any]], Callable[..., Any]]", distributionFunction)


def blueprintsInCategory(category: str) -> Sequence[str]:  # noqa: N802 - Scenic's name
    """The blueprints of a category, such as ``car``, ``walker`` or ``trash``.

    Raises:
        ValueError: CARLA has none, or Scenic records none.
    """
    if not (found := _IDS.get(f"{category}Models")):
        raise ValueError(f"Scenic records no blueprint of the category {category!r} for CARLA {VERSION}")
    return found


@_deferred
def sizeOf(blueprint: str | None, axis: str, default: float) -> float:  # noqa: N802
    """The ``length``, ``width`` or ``height`` [m] of a blueprint, or the default where none is recorded."""
    return _SIZES.get(blueprint or "", {}).get(axis) or default
