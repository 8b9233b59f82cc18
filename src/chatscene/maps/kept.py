"""What is worked out of a network, or of an element of it, once, and kept as long as its map is used."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache, partial, wraps
from typing import Any, Concatenate, ParamSpec, TypeVar

Kept = TypeVar("Kept")
Named = ParamSpec("Named")

NETWORKS = 8  # of which results are kept: as many as `chatscene.maps.network` keeps networks


def kept(element: Any, name: str, make: Callable[[Any], Kept]) -> Kept:
    """What was made of an element before, else what is made of it now.

    What a lane knows of its network is a weak reference, and elements of two maps may be equal: so nothing is
    remembered by them, but on them. There is at most one of each name for each element.
    """
    there = getattr(element, name, None)
    if there is None:
        there = make(element)
        setattr(element, name, there)
    return there


def kept_with_network(
    most: int | None = None,
) -> Callable[[Callable[Concatenate[Any, Named], Kept]], Callable[Concatenate[Any, Named], Kept]]:
    """Keep the results of a function whose first argument is a network.

    All results for a network are dropped together, once `NETWORKS` others were used since. With a cache of its own,
    each function would hold networks for as long as it is not called for enough others, which may be for ever.

    Args:
        most: Results of the function to keep for each network, the latest; None for all.
    """

    def keeping(make: Callable[Concatenate[Any, Named], Kept]) -> Callable[Concatenate[Any, Named], Kept]:
        @wraps(make)
        def of_network(network: Any, *args: Named.args, **named: Named.kwargs) -> Kept:
            by_function = _results(network)
            if (own := by_function.get(make)) is None:
                own = by_function[make] = lru_cache(maxsize=most)(partial(make, network))
            return own(*args, **named)

        return of_network

    return keeping


@lru_cache(maxsize=NETWORKS)
def _results(network: Any) -> dict[Callable[..., Any], Callable[..., Any]]:  # noqa: ARG001 - whose they are
    return {}
