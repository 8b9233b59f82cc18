"""Simulators on one map after another, for who drives on several."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from typing import Generic, TypeVar

from chatscene.simulate.simulator import Simulator

S = TypeVar("S", bound=Simulator)


class OneMap(Generic[S]):
    """Keeps simulators as long as what is driven lies on their map: a map that was read is large."""

    def __init__(self) -> None:
        self._map: Hashable = None
        self._made: dict[Hashable, S] = {}

    def on(self, where: Hashable, key: Hashable, make: Callable[[], S]) -> S:
        """The simulator of a key on a map, made where there is none yet; those of another map are closed."""
        if where != self._map:
            self.close()
            self._map = where
        if key not in self._made:
            self._made[key] = make()
        return self._made[key]

    def close(self) -> None:
        """End the processes of those that have any."""
        while self._made:
            _, one = self._made.popitem()
            if callable(end := getattr(one, "close", None)):
                end()
