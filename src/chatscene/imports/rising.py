"""Edges that do not rise: what a story waits for holds from the beginning on, so that it never begins to hold."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from types import SimpleNamespace
from typing import Any

from chatscene.imports.written_story import StoryProgram, Told
from chatscene.terms.actors import BY_CLASS, Manner
from chatscene.terms.plan import Expression
from chatscene.terms.sums import valued
from chatscene.world.story.conditions import truth_of
from chatscene.world.story.entities import Bounds, Entity
from chatscene.world.story.places import Place, place_of

_OF_THE_WORLD = frozenset(("time", "value", "number", "element", "never", "always"))


class _First:
    """A story before anything has happened in it."""

    def __init__(self, story: StoryProgram, network: Any) -> None:
        self.time, self.variables = 0.0, dict[str, Any]()
        self._who = {
            one.name: Entity(
                SimpleNamespace(
                    pose=(one.x, one.y, one.heading, one.speed),
                    length=one.length,
                    width=one.width,
                    isWalker=one.kind in BY_CLASS and BY_CLASS[one.kind].row.manner is Manner.WALKS,
                ),
                one.name,
                one.ahead,
                network,
                led=True,
                bounds=Bounds(*one.bounds),
            )
            for one in story.members
        }

    def entity(self, name: str) -> Entity:
        """Somebody by name."""
        return self._who[name]

    def place(self, told: tuple[Any, ...]) -> Place:
        """A place."""
        return place_of(told, self.entity)

    def is_in(self, kind: str, name: str, state: str) -> bool:
        """No part has begun."""
        del kind, name, state
        return False


def holds_at_first(story: StoryProgram, network: Any, values: Mapping[str, float]) -> bool:
    """Whether somebody but the ego waits for an edge to rise of what holds from the beginning on."""
    asked = [what for edge, _, *what in _conditions(story) if edge == "rising" and what[0] not in _OF_THE_WORLD]
    if not asked:
        return False
    world = _First(story, network)
    return any(truth_of(tuple(_valued(part, values) for part in what), world)() for what in asked)


def _conditions(story: StoryProgram) -> Iterator[Any]:
    """All conditions by which acts begin, and events of others than the ego."""
    for _, start, _, groups in story.acts:  # type: ignore[misc]
        yield from (condition for group in start or () for condition in group)  # type: ignore[union-attr]
        for _, _, actors, events in groups:  # type: ignore[misc, union-attr]
            for event in events if actors != ("ego",) else ():  # type: ignore[union-attr]
                yield from (condition for group in event[4] or () for condition in group)  # type: ignore[index, union-attr]


def _valued(told: Told | Any, values: Mapping[str, float]) -> Any:
    """A part of a story with a number in the place of each expression."""
    if isinstance(told, tuple):
        return tuple(_valued(one, values) for one in told)  # type: ignore[reportUnknownVariableType]
    return valued(told, values) if isinstance(told, Expression) else told
