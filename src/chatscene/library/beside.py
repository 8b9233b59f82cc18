"""A road user beside the adversary: who stands, drives or acts in the same scene, and is not searched with.

It is composed of acts like an adversary that no snippet does (`chatscene.library.compose`), starts where a spawn of the
library puts it, and becomes a part of the adversary's spawn: what it does has no parameters, but stands at the middle
of their ranges. Its id says all of it: ``spawn/roadside-right+ahead-in-lane-far=car.ahead.stand``.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import replace

from chatscene.errors import SnippetError
from chatscene.library.compose import COMPOSED, Asked, asked_in, compose
from chatscene.library.snippet_file import names_in
from chatscene.terms.episode import OTHER
from chatscene.terms.scenario import Position
from chatscene.terms.snippet import Snippet

AND = "+"
DOES = "="
_SPAWN = "spawn/"
_REVEALED = "(egoRoute.eventAt + 42)"  # [m]: the adversary has left the lane before that
_OF_ADVERSARY = re.compile(r"\b(?:adv(?=[A-Z])|Adv(?=Class\b|Agent\b|Behavior\b))")  # names of it alone
_MEETINGS = re.compile(r"\b(egoMeeting|acrossMeeting|leaderWay|LeadingAgent)\b")
_DECLARED = re.compile(r"^param (OPT_\w+) = .*\n?", re.MULTILINE)
_READ = re.compile(r"globalParameters\.(OPT_\w+)")


def placed_beside(spawn: Snippet, asked: Asked, place: Snippet) -> Snippet:
    """The adversary's spawn with another road user in it.

    Args:
        spawn: Where the adversary starts.
        asked: What the other does.
        place: A spawn that puts it where it starts.

    Raises:
        SnippetError: No steps do what is asked.
    """
    behavior = compose(asked)
    if behavior is None:
        raise SnippetError(f"there are no steps for {asked.snippet_id!r}")
    named = place.id.removeprefix(_SPAWN) + DOES + behavior.id.removeprefix(COMPOSED)
    start = _fixed(
        place, {"OPT_GEO_Y": _REVEALED} if reveals(spawn, asked) and "laneLeft" not in place.requires else {}
    )
    start = start.replace("new OtherClass", f"new {asked.kind.row.scenic}")
    start = start.replace("behavior OtherBehavior()", f"behavior OtherBehavior(), with label '{OTHER}'")
    source = "\n".join((spawn.source.strip(), _fixed(behavior), start))
    requires, provides = names_in(source)
    return replace(
        spawn,
        id=f"{spawn.id}{AND}{named}",
        description=f"{spawn.description} {place.description.replace('adversary', 'other road user')}",
        requires=requires,
        provides=provides,
        source=source,
    )


def others_of(snippet_id: str) -> tuple[Asked, ...]:
    """What those do who are beside the adversary in the spawn of an id; none of another snippet."""
    return tuple(asked_in(COMPOSED + other.partition(DOES)[2]) for other in snippet_id.split(AND)[1:])


def placed_again(snippet_id: str, get: Callable[[str], Snippet]) -> Snippet:
    """The spawn of an id that says who is beside the adversary.

    Args:
        snippet_id: The id.
        get: The snippet of an id of the library.

    Raises:
        SnippetError: There is no such spawn, or no such road user can be composed.
    """
    spawn, _, other = snippet_id.partition(AND)
    place, _, does = other.partition(DOES)
    return placed_beside(get(spawn), asked_in(COMPOSED + does), get(_SPAWN + place))


def reveals(spawn: Snippet, asked: Asked) -> bool:
    """Whether an adversary ahead of the ego has somebody before it who stands or just drives on, whom it may reveal."""
    ahead = spawn.slots.position is asked.position is Position.AHEAD
    return ahead and all(action.row.all_along for action in asked.actions)


def _fixed(part: Snippet, instead: Mapping[str, str] | None = None) -> str:
    """The code of a part with a parameter's middle, or something else, in its place, and names of its own."""
    middle = {p.name: f"{(p.low + p.high) / 2:g}" for p in part.parameters} | dict(instead or {})
    code = _DECLARED.sub("", part.source.strip())
    code = _READ.sub(lambda m: middle[m[1]], code)
    code = _OF_ADVERSARY.sub(lambda m: "other" if m[0] == "adv" else "Other", code)
    return _MEETINGS.sub(lambda m: f"other{m[1][0].upper()}{m[1][1:]}", code)
