"""Bodies do not go through each other: whoever pushes against another stays before it, however long it pushes.

Nobody is pushed away, which would be a second physics: of a step that would take a body deeper into another, the body
keeps the share that does not. In the step in which two meet they lie in each other as far as that step took them, as
in every simulator of ours, so that a drive ends the same here and there; before the next step they are taken apart.
"""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass

from carla_stand_in.actors import BodyActor
from chatscene.simulate.contact import depth
from chatscene.world.bodies import Body, Walker

SKIN = 0.01  # [m] that two who met lie in each other, so that whoever looks at their boxes sees that they touch
_NOTHING = 1e-9  # [m], of rounding
_HALVINGS = 14  # of a step's motion: to less than a millimetre

Pair = tuple[int, int]
_Pose = tuple[float, float, float]


@dataclass(slots=True)
class _Motion:
    """What a step did to a body.

    Attributes:
        actor: Whose.
        start, end: x [m], y [m], heading [rad].
        others: Whom it must not go into.
    """

    actor: BodyActor
    start: _Pose
    end: _Pose
    others: list[BodyActor]


def hold_back(bodies: list[BodyActor], pairs: Collection[Pair] | None, dt: float) -> bool:
    """Take from the last step's motions what goes into others; whether there was anything to take.

    Bodies move one after another, in the order of their ids, out of the places where they were before the step: first
    those whose way is free, also where it becomes free as others go, then the others as far as they come. Who was in
    somebody before, such as a thing that was spawned there, may go anywhere but deeper.

    Args:
        bodies: All of them.
        pairs: Who must not go into whom, by ids, the smaller first; None for everybody. Who goes further than its own
            length must go into nobody, or it could jump over somebody.
        dt: What the step took [s].
    """
    partners: dict[int, set[int]] = {}
    for one, other in pairs or ():
        partners.setdefault(one, set()).add(other)
        partners.setdefault(other, set()).add(one)
    touchable = {actor.id: actor for actor in bodies if actor.touchable}
    motions: list[_Motion] = []
    for actor in touchable.values():
        start, end = actor.came_from, (actor.body.x, actor.body.y, actor.body.heading)
        if start is None or start == end:
            continue
        everybody = pairs is None or math.dist(start[:2], end[:2]) > actor.body.length
        near = [
            touchable[number]
            for number in (touchable if everybody else partners.get(actor.id, ()))
            if number in touchable
        ]
        if others := [other for other in near if other is not actor and actor.level_with(other)]:
            motions.append(_Motion(actor, start, end, others))
    if not motions:
        return False
    places = {number: actor.body for number, actor in touchable.items()}
    for motion in motions:
        places[motion.actor.id] = _box(motion.actor, motion.start)
    pending = motions
    while pending:
        left = [motion for motion in pending if not _goes(motion, motion.end, places)]
        if len(left) == len(pending):
            break
        pending = left
    for motion in pending:
        _go_as_far_as_free(motion, places, dt)
    return bool(pending)


def _goes(motion: _Motion, end: _Pose, places: dict[int, Body]) -> bool:
    """Go to a place if the way is free; whether it is."""
    actor = motion.actor
    before = places[actor.id]
    boxes = [_box(actor, pose) for pose in _on_the_way((before.x, before.y, before.heading), end, actor.body.length)]
    for other in motion.others:
        place = places[other.id]
        most = max(SKIN, depth(before, place)) + _NOTHING
        if any(depth(box, place) > most for box in boxes):
            return False
    places[actor.id] = boxes[-1]
    return True


def _on_the_way(start: _Pose, end: _Pose, length: float) -> list[_Pose]:
    """Places on a way, no further apart than a body is long; the last is its end."""
    count = max(1, math.ceil(math.dist(start[:2], end[:2]) / length))
    return [_between(start, end, number / count) for number in range(1, count + 1)]


def _go_as_far_as_free(motion: _Motion, places: dict[int, Body], dt: float) -> None:
    actor, start, end = motion.actor, motion.start, motion.end
    share, step = 0.0, 1.0
    for _ in range(_HALVINGS):
        step /= 2
        if _goes(motion, _between(start, end, share + step), places):
            share += step
    if share == 0.0 and isinstance(actor.body, Walker) and _goes(motion, (*end[:2], start[2]), places):
        share = 1.0  # who cannot turn round because of somebody beside can still step away
    place = places[actor.id]
    actor.keep(share, (place.x, place.y, place.heading), dt)


def _between(start: _Pose, end: _Pose, share: float) -> _Pose:
    x, y, heading = (a + share * (b - a) for a, b in zip(start, end, strict=True))
    return x, y, heading


def _box(actor: BodyActor, pose: _Pose) -> Body:
    return Body(*pose, actor.body.length, actor.body.width)
