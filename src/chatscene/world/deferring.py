"""Functions that programs call with values that are drawn, and that others call without Scenic.

A value is drawn only where Scenic is: until it is imported, a function is called as it is.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from functools import cache, wraps
from typing import Any, TypeVar, cast

Function = TypeVar("Function", bound=Callable[..., Any])


def deferred(function: Function) -> Function:
    """Mark a function, so that Scenic defers it where it is given what is drawn.

    Args:
        function: It follows from what it is given alone.
    """

    @cache
    def of_scenic() -> Callable[..., Any]:
        from scenic.core.distributions import distributionFunction
        from scenic.core.vectors import Vector

        if function.__annotations__.get("return") == "Vector":  # Scenic asks what it gives
            function.__annotations__["return"] = Vector
        return cast("Callable[..., Any]", distributionFunction(function))

    @wraps(function)
    def called(*given: Any, **named: Any) -> Any:
        return (of_scenic() if "scenic.core.distributions" in sys.modules else function)(*given, **named)

    setattr(called, "_canUnpackDistributions", True)  # noqa: B010 - what Scenic asks of a function
    return cast("Function", called)


def vector(x: float, y: float) -> Any:
    """Scenic's vector of a point [m]."""
    from scenic.core.vectors import Vector

    return Vector(x, y)


def reject(reason: str) -> Exception:
    """What is raised where a place that a program asks for is not there: Scenic draws anew."""
    from scenic.core.distributions import RejectionException

    return RejectionException(reason)
