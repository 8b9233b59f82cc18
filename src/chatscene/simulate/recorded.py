"""The states of a drive that were noted step by step, as tracks."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chatscene.simulate.simulation import SteppedSimulation
from chatscene.terms.actors import kind_of
from chatscene.terms.episode import Role, Track


def states_of(rows: Any, since: Sequence[int], steps: int) -> list[NDArray[np.float64]]:
    """The state of each body that moves at each step, (4, steps); of one that came later, as it stood at first.

    Args:
        rows: Numbers of these bodies, step after step.
        since: For each body the step at which it came.
        steps: How many steps there are.
    """
    if not any(since):
        columns = np.array(rows).reshape(steps, len(since), 4).transpose(1, 2, 0)
        return list(np.ascontiguousarray(columns))
    states = np.empty((len(since), 4, steps))
    noted = iter(rows)
    for step in range(steps):
        for i, first in enumerate(since):
            if step >= first:
                states[i, :, step] = [next(noted) for _ in range(4)]
    for state, first in zip(states, since, strict=True):
        state[:3, :first] = state[:3, first : first + 1]
        state[3, :first] = 0.0
    return list(states)


def tracks_of(
    simulation: SteppedSimulation,
    names: Sequence[tuple[str, Role]],
    states: Sequence[NDArray[np.float64]],
    steps: int,
    backs: bool,
) -> tuple[Track, ...]:
    """The tracks of all bodies, the ego's first.

    Args:
        simulation: Whose bodies they are.
        names: What each is called, and what it is there for.
        states: Of those that move, in their order.
        steps: How many steps there are.
        backs: Whether the ego drives backwards; it is carried as it goes then.
    """
    moving = iter(states)
    tracks: list[Track] = []
    for number, (obj, body, (name, role)) in enumerate(zip(simulation.objects, simulation.bodies, names, strict=True)):
        if not body.moves:
            state = np.repeat(np.array([[body.x], [body.y], [body.heading], [0.0]]), steps, axis=1)
        else:
            state = next(moving)
            if number == 0 and backs:
                state = np.array([state[0], state[1], state[2] + math.pi, 0.0 - state[3]])
        tracks.append(
            Track(
                actor=name,
                role=role,
                kind=kind_of(obj),
                length=body.length,
                width=body.width,
                x=state[0],
                y=state[1],
                heading=state[2],
                speed=state[3],
            )
        )
    order = (Role.EGO, Role.ADVERSARY, Role.BACKGROUND, Role.OCCLUDER)
    return tuple(sorted(tracks, key=lambda track: order.index(track.role)))
