"""Does every snippet keep the turn, the side and the direction that it names, on every geometry it joins?

A behavior that turns right beside one geometry may turn left beside the next, because the ways of others through a
junction are the map's. So this rung goes through pairs, not through snippets: every behavior that names a direction
with every geometry and arm it joins, and every spawn with every geometry.
"""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np

from chatscene.ego.policy import EgoPolicy
from chatscene.errors import MapError
from chatscene.grow.twins import SHARES, Triple, scenario_of
from chatscene.library.compatibility import ARMS, Compatibility, compatibility, ways_of
from chatscene.library.load import Library
from chatscene.program.assemble import assemble
from chatscene.program.deeds import STANDING, TURNED, TURNED_MIDWAY
from chatscene.program.meaning import check_meaning
from chatscene.program.sample import scene_at
from chatscene.simulate.simulator import Simulator, simulate
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import TURNS, Action
from chatscene.terms.episode import Episode, Track
from chatscene.terms.scenario import Component, Maneuver, Place, Position, Side, Slots
from chatscene.terms.scene import Rejected, Scene, ScenicProgram
from chatscene.terms.snippet import Snippet

T = TypeVar("T")

ASTRAY = math.radians(25)  # turned so far to the other side, a watcher says that it turns there
ASIDE = math.radians(45)  # who has turned so far went no longer straight on

# What a word in an id says, by the facts of which one must be filled so.
_BEHAVIORS: dict[str, tuple[object, ...]] = {
    **{action.row.named: (action,) for action in Action if action.row.named},
    r"^oncoming": (Position.ONCOMING,),
    r"^behind": (Position.BEHIND,),
    r"^lead": (Position.AHEAD,),
    r"^kerb": (Position.KERB,),
}
_SPAWNS: dict[str, tuple[object, ...]] = {
    r"\bleft\b": (Side.LEFT,),
    r"\bright\b": (Side.RIGHT,),
    r"^oncoming": (Position.ONCOMING,),
    r"^crossing": (Position.CROSSING,),
    r"^ahead": (Position.AHEAD,),
    r"^behind-in-lane": (Position.BEHIND,),
    r"lane-level": (Position.BESIDE,),
    r"lane-ahead": (Position.AHEAD_BESIDE,),
    r"lane-behind": (Position.BEHIND_BESIDE,),
}
_GEOMETRIES: dict[str, tuple[object, ...]] = {
    r"left-turn": (Maneuver.LEFT_TURN,),
    r"^right-turn": (Maneuver.RIGHT_TURN,),
    r"^straight": (Maneuver.STRAIGHT,),
    r"^lane-change-left": (Maneuver.LANE_CHANGE_LEFT,),
    r"^lane-change-right": (Maneuver.LANE_CHANGE_RIGHT,),
    r"^left-curve": (Place.LEFT_CURVE,),
    r"^right-curve": (Place.RIGHT_CURVE,),
    r"three-way": (Place.THREE_WAY,),
    r"four-way": (Place.FOUR_WAY,),
}
NAMED = {Component.BEHAVIOR: _BEHAVIORS, Component.SPAWN: _SPAWNS, Component.GEOMETRY: _GEOMETRIES}
# Who says so goes on to the other side of the junction; through a red light one may turn.
_STRAIGHT = re.compile(r"\b(straight|across|crosses|through(?! the red))\b")


def misnamed(snippet: Snippet) -> Iterator[str]:
    """What an id or a description says of a direction and the facts or the code do not."""
    name, slots = snippet.id.partition("/")[2], snippet.slots
    facts = {*slots.actions, slots.side, slots.position, slots.maneuver, slots.place}
    for pattern, wanted in NAMED[snippet.component].items():
        if (word := re.search(pattern, name)) and not facts & set(wanted):
            yield f"its name says {word[0]}, its facts do not: {' or '.join(map(str, wanted))} is missing"
    ways = ways_of(snippet)
    if says_straight(snippet) and ways != (Maneuver.STRAIGHT,):
        yield f"its words say that it goes straight on, its advTurn allows {', '.join(ways)}"


def says_straight(snippet: Snippet) -> bool:
    """Whether a behavior at a junction says that its adversary goes straight on, and of no turn."""
    turns = {*TURNS, Action.U_TURN} & set(snippet.slots.actions)
    return bool(ways_of(snippet)) and not turns and _STRAIGHT.search(snippet.description) is not None


# Pairs


@dataclass(frozen=True, slots=True)
class Joint:
    """Three snippets to hold to the directions they name."""

    ids: tuple[str, str, str]
    kind: AdversaryKind
    acts: bool


def joints(library: Library, only: Collection[str] | None = None) -> Iterator[Joint]:
    """Every behavior that names a direction with every geometry and arm it joins, and every spawn with every geometry.

    Of the spawns that a behavior can have there, and of the behaviors that a spawn can, the next in turn is taken.
    """
    joint = compatibility(library)
    acting = list(_acting(joint))
    placed = {(g, s) for _, g, s in acting}
    standing = [
        (_in_turn(np.flatnonzero(joint.mask[:, g, s]).tolist(), g + s), g, s)
        for g, s in np.argwhere(joint.mask.any(axis=0)).tolist()
        if (g, s) not in placed
    ]
    for number, (b, g, s) in enumerate([*acting, *standing]):
        behavior, geometry, spawn = joint.behaviors[b], joint.geometries[g], joint.spawns[s]
        ids = (behavior.id, geometry.id, spawn.id)
        if only is None or set(ids) & set(only):
            kinds = [kind for kind in behavior.adversaries if kind in spawn.adversaries]
            yield Joint(ids, _in_turn(kinds, b + g), acts=number < len(acting))


def _acting(joint: Compatibility) -> Iterator[tuple[int, int, int]]:
    """Behavior, geometry and a spawn for each arm of the junction, if it has any, of those that name a direction."""
    arms = [frozenset(ARMS) & set(spawn.requires) for spawn in joint.spawns]
    for b, behavior in enumerate(joint.behaviors):
        if any(action.row.directed for action in behavior.slots.actions) or says_straight(behavior):
            for g in range(len(joint.geometries)):
                spawns = np.flatnonzero(joint.mask[b, g]).tolist()
                for arm in dict.fromkeys(arms[s] for s in spawns):
                    yield b, g, _in_turn([s for s in spawns if arms[s] == arm], b + g)


def _in_turn(ones: Sequence[T], number: int) -> T:
    return ones[number % len(ones)]


# Tracks


def strays(triple: Triple, joint: Joint, simulator: Simulator, ego: EgoPolicy) -> Iterator[str]:
    """What three joined snippets do against a direction that one of them names, at the first route that shows it.

    Raises:
        ChatSceneError: They make no program, or one that fails.
    """
    behavior, _, spawn = triple
    program = assemble(scenario_of(triple), triple, joint.kind)
    does, starts = behavior.slots, spawn.slots
    said = Slots(side=does.side or starts.side, position=does.position or starts.position)
    if joint.acts:
        said = replace(said, actions=tuple(a for a in does.actions if a.row.directed and not a.row.turn))
    # At a junction the ways of others differ from route to route.
    for index in sorted({0, simulator.routes(program) - 1} if ways_of(behavior) else {0}):
        try:
            route = simulator.route(program, index)
        except MapError:
            continue  # a run leaves it out as well
        episode = _first_placed(program, index, simulator, ego if joint.acts else None)
        if episode is not None:
            astray = _astray(behavior, episode.adversaries[0]) if joint.acts else ()
            for problem in (*check_meaning(said, episode, route, through=True), *astray):
                yield f"{problem}, on route {index}"
                return


def _first_placed(program: ScenicProgram, route: int, simulator: Simulator, ego: EgoPolicy | None) -> Episode | None:
    """The drive of the first of some scenes that can be placed; without an ego, its first moment."""
    for number, share in enumerate(SHARES):
        scene = scene_at(program, route, share, name=f"direction-{number}")
        outcome = (
            _begun(program, scene, simulator)
            if ego is None
            else simulate(simulator, program, scene, ego, through_collisions=True)
        )
        if isinstance(outcome, Episode):
            return outcome
    return None


def _begun(program: ScenicProgram, scene: Scene, simulator: Simulator) -> Episode | Rejected:
    drive = simulator.open(program, scene)
    if isinstance(drive, Rejected):
        return drive
    try:
        return drive.episode(scene.id, "nobody")
    finally:
        drive.close()


def _astray(behavior: Snippet, track: Track) -> Iterator[str]:
    """Where an adversary turns to the wrong side, or turns though it is said to go straight on."""
    turned = track.heading - track.heading[0]
    if says_straight(behavior) and (most := float(np.abs(turned).max())) > ASIDE:
        yield f"action: said straight on, it turns by {math.degrees(most):.0f}°"
    for action, sign in TURNS.items():
        if action in behavior.slots.actions:
            own = sign * turned
            first = -float(own[: int(own.argmax()) + 1].min())
            if first > ASTRAY:
                yield f"action: said {action}, it first turns to the other side by {math.degrees(first):.0f}°"
            elif own.max() < (TURNED_MIDWAY if abs(track.speed[-1]) < STANDING else TURNED):
                yield f"action: said {action}, it turns by {math.degrees(float(own.max())):.0f}°"
