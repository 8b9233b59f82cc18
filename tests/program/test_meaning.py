"""What a drive shows of what was said, on tracks made by hand: when acts begin, are done, and in what order."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, cast

import numpy as np
import pytest

from chatscene.ego.rule_based import RuleBased
from chatscene.errors import MeansSomethingElse
from chatscene.program.check import check
from chatscene.program.deeds import ACTIONS, Act
from chatscene.program.meaning import check_meaning, is_place, maneuver_of
from chatscene.program.watching import watch
from chatscene.simulate.simulator import Simulator
from chatscene.terms.acts import Action
from chatscene.terms.episode import Ending, Episode, Event, EventKind, Role, SignalTrack, Track
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import Route
from chatscene.terms.scenario import Control, Maneuver, Place, Slots
from chatscene.terms.scene import ScenicProgram
from chatscene.terms.simulator import SimulatorIdentity

DT = 0.1
EGO_SPEED = 8.0  # along +x from the origin, on a straight route
SIZES = {"Car": (4.5, 1.9), "Pedestrian": (0.6, 0.6)}
LIGHT = SignalTrack(x0=45.0, y0=-15.0, x1=55.0, y1=-15.0, state="r" * 300, role="other")
ROUTE = Route(
    id="toy",
    map_name="toy",
    maneuver=Maneuver.STRAIGHT,
    place=Place.ROAD,
    control=Control.NONE,
    line=Polyline(np.column_stack([np.arange(300.0), np.zeros(300)])),
    lane_ids=("lane",),
    event_at=100.0,
)


def moving(
    x: float, y: float, *legs: tuple[int, float, float], facing: float = 0.0, speed: float = 0.0, kind: str = "Car"
) -> Track:
    """A track of legs: how many steps, the speed and the heading [degrees] at their ends, both linear in between.

    A leg of one step is a jump.
    """
    speeds, headings = [speed], [facing]
    for steps, fast, heading in legs:
        speeds += np.linspace(speeds[-1], fast, steps + 1)[1:].tolist()
        headings += np.linspace(headings[-1], heading, steps + 1)[1:].tolist()
    v, angle = np.array(speeds), np.radians(headings)
    length, width = SIZES[kind]
    return Track(
        actor="adversary",
        role=Role.ADVERSARY,
        kind=kind,
        length=length,
        width=width,
        x=x + np.concatenate(([0.0], np.cumsum(v * np.cos(angle))[:-1])) * DT,
        y=y + np.concatenate(([0.0], np.cumsum(v * np.sin(angle))[:-1])) * DT,
        heading=angle,
        speed=v,
    )


def episode(track: Track, *, contact: int | None = None, through: bool = False) -> Episode:
    """A drive beside a track; a contact ends it unless it goes on through it."""
    steps = len(track.x) if contact is None or through else contact + 1
    cut = replace(track, **{name: getattr(track, name)[:steps] for name in ("x", "y", "heading", "speed")})
    time = np.arange(steps) * DT
    ego = Track(
        actor="ego",
        role=Role.EGO,
        kind="Car",
        length=4.5,
        width=1.9,
        x=np.asarray(EGO_SPEED * time, np.float64),
        y=np.zeros(steps),
        heading=np.zeros(steps),
        speed=np.full(steps, EGO_SPEED),
    )
    crash = Event(kind=EventKind.COLLISION, step=contact or 0, other="adversary", side="front", impact_speed=5.0)
    return Episode(
        scene_id="toy",
        ego="toy",
        dt=DT,
        tracks=(ego, cut),
        events=() if contact is None else (crash,),
        signals=(LIGHT,),
        ending=Ending.TIMEOUT if contact is None or through else Ending.COLLISION,
        route_completion=0.5,
        distance_to_route=np.zeros(steps),
        off_road=np.zeros(steps, bool),
    )


def failures(actions: Sequence[Action], track: Track, *, contact: int | None = None) -> tuple[str, ...]:
    return check_meaning(Slots(actions=tuple(actions)), episode(track, contact=contact), ROUTE)


def acts(action: Action, track: Track, until: int | None = None) -> list[Act]:
    return list(ACTIONS[action](watch(episode(track), ROUTE, track, until)))


@dataclass(frozen=True)
class Toy:
    """An adversary that does one thing, and when: at `begun` it is under way, and done not before `done`."""

    track: Track
    not_yet: int
    begun: int
    done: int


ON_FOOT: dict[str, Any] = {"facing": 90.0, "kind": "Pedestrian"}


def weaving() -> Track:
    straight = moving(20, 0, (70, 8, 0), speed=8)
    heading = np.concatenate([np.zeros(11), 0.3 * np.sin(2 * np.pi * np.arange(60) / 40)])
    return replace(straight, heading=heading, y=np.cumsum(straight.speed * np.sin(heading)) * DT)


STOPPING = moving(40, 0, (10, 8, 0), (13, 0, 0), (30, 0, 0), speed=8)
CROSSING = moving(40, -5, (10, 0, 90), (1, 1.5, 90), (50, 1.5, 90), **ON_FOOT)
CUTTING_IN = moving(10, 3.5, (10, 8, 0), (2, 8, -10), (25, 8, -10), (2, 8, 0), (20, 8, 0), speed=8)
TOYS = {
    Action.CROSS: Toy(CROSSING, 8, 20, 35),
    Action.STOP: Toy(STOPPING, 9, 15, 26),
    Action.BRAKE: Toy(STOPPING, 9, 12, 13),
    Action.ACCELERATE: Toy(moving(30, 0, (10, 3, 0), (20, 8, 0), (20, 8, 0), speed=3), 9, 13, 18),
    Action.SLOW: Toy(moving(30, 0, (10, 8, 0), (10, 2, 0), (60, 2, 0), speed=8), 9, 14, 17),
    Action.REVERSE: Toy(moving(30, 0, (10, 0, 0), (10, -2, 0), (10, -2, 0)), 9, 11, 12),
    Action.CUT_IN: Toy(CUTTING_IN, 9, 18, 27),
    Action.CHANGE_LANE: Toy(CUTTING_IN, 9, 18, 28),
    Action.WEAVE: Toy(weaving(), 9, 22, 50),
    Action.SWERVE: Toy(moving(30, 0, (10, 8, 0), (5, 8, 20), (20, 8, 20), speed=8), 9, 15, 17),
    Action.PACE: Toy(moving(-20, 3.5, (32, 12, 0), (1, 8, 0), (40, 8, 0), speed=12), 28, 37, 44),
    Action.RUN_LIGHT: Toy(moving(50, -30, (40, 8, 90), facing=90, speed=8), 14, 17, 19),
    Action.TURN_LEFT: Toy(moving(60, 3.5, (10, 8, 180), (20, 8, 270), (10, 8, 270), facing=180, speed=8), 9, 14, 20),
    Action.TURN_RIGHT: Toy(moving(60, 3.5, (10, 8, 180), (20, 8, 90), (10, 8, 90), facing=180, speed=8), 9, 14, 20),
    Action.ONCOMING: Toy(moving(90, 3.5, (10, 0, 180), (1, 8, 180), (20, 8, 180), facing=180), 9, 12, 11),
    Action.HESITATE: Toy(
        moving(40, -5, (10, 1.5, 90), (1, 0, 90), (5, 0, 90), (1, 1.5, 90), (20, 1.5, 90), **ON_FOOT, speed=1.5),
        9, 14, 17,
    ),
    Action.DIAGONAL: Toy(
        moving(40, -5, (10, 0, 45), (1, 1.5, 45), (20, 1.5, 45), facing=45, kind="Pedestrian"),
        9, 13, 15,
    ),
    Action.TURN_BACK: Toy(
        moving(40, -5, (20, 1.5, 90), (1, 1.5, 270), (20, 1.5, 270), **ON_FOOT, speed=1.5),
        18, 23, 25,
    ),
    Action.OVERTAKE: Toy(moving(-20, 3.5, (10, 8, 0), (1, 14, 0), (60, 14, 0), speed=8), 9, 20, 50),
    Action.TAILGATE: Toy(moving(-30, 0, (32, 14, 0), (1, 8, 0), (40, 8, 0), speed=14), 25, 36, 43),
    Action.PULL_OUT: Toy(moving(40, -3.5, (10, 0, 15), (5, 4, 15), (40, 4, 15), facing=15), 9, 25, 33),
    Action.WRONG_WAY: Toy(moving(100, 0, (10, 0, 180), (1, 8, 180), (20, 8, 180), facing=180), 9, 14, 18),
    Action.U_TURN: Toy(moving(40, -3.5, (10, 6, 0), (30, 6, 180), (10, 6, 180), speed=6), 9, 18, 33),
    Action.BLOCK: Toy(STOPPING, 9, 15, 32),
    Action.FAST: Toy(moving(30, 0, (10, 5, 0), (30, 13, 0), (60, 13, 0), speed=5), 9, 15, 33),
    Action.FOLLOW: Toy(moving(30, 0, (10, 0, 0), (1, 8, 0), (20, 8, 0)), 9, 14, 18),
    Action.STAND: Toy(moving(30, 0, (40, 0, 0)), 0, 5, 9),
    Action.NARROW: Toy(moving(30, 1.2, (40, 0, 0)), 0, 5, 9),
}  # fmt: skip
LASTING = sorted(set(TOYS) - {Action.ONCOMING})  # of which a watcher sees the beginning before he can be sure
each = pytest.mark.parametrize("action", sorted(TOYS))


def test_every_action_has_a_toy() -> None:
    assert set(TOYS) == set(Action) == set(ACTIONS)


@each
def test_an_act_begins_and_is_done_when_a_watcher_says_so(action: Action) -> None:
    toy = TOYS[action]
    (act, *_) = [act for act in acts(action, toy.track) if act.done is not None]
    assert act.done is not None
    assert toy.not_yet <= act.began <= (act.done if action.row.all_along else toy.begun)
    assert abs(act.done - toy.done) <= 2


@pytest.mark.parametrize("action", LASTING)
def test_an_act_under_way_has_begun_but_is_not_done(action: Action) -> None:
    toy = TOYS[action]
    found = acts(action, toy.track, toy.begun)
    assert [act.done for act in found] == [None]
    assert toy.not_yet <= found[0].began < toy.begun


@each
def test_a_contact_excuses_no_act_that_had_not_begun(action: Action) -> None:
    toy = TOYS[action]
    assert failures([action], toy.track, contact=toy.not_yet) == (
        f"action: said {action}, but the adversary had not begun to when the ego crashed",
    )


@each
def test_a_contact_excuses_an_act_that_had_begun(action: Action) -> None:
    assert failures([action], TOYS[action].track, contact=TOYS[action].begun) == ()


@pytest.mark.parametrize("action", LASTING)
def test_without_a_contact_an_act_must_be_done(action: Action) -> None:
    toy = TOYS[action]
    steps = toy.begun + 1
    track = replace(toy.track, **{n: getattr(toy.track, n)[:steps] for n in ("x", "y", "heading", "speed")})
    assert failures([action], track) == (f"action: said {action}, but the adversary never does",)
    assert failures([action], toy.track) == ()


def test_what_happens_after_the_contact_of_a_drive_that_goes_on_proves_nothing() -> None:
    toy = TOYS[Action.STOP]
    assert "had not begun" in failures([Action.STOP], toy.track, contact=toy.not_yet)[0]
    gone_on = episode(toy.track, contact=toy.not_yet, through=True)
    said = Slots(actions=(Action.STOP,))
    assert "had not begun" in check_meaning(said, gone_on, ROUTE)[0]
    assert check_meaning(said, gone_on, ROUTE, through=True) == ()


def test_a_stop_that_was_given_up_before_the_contact_is_not_excused() -> None:
    slows_and_goes_on = moving(40, 0, (10, 8, 0), (5, 5, 0), (10, 8, 0), (20, 8, 0), speed=8)
    assert failures([Action.STOP], slows_and_goes_on, contact=15) == ()
    assert failures([Action.STOP], slows_and_goes_on, contact=40) != ()


# Order

CROSSES_THEN_STOPS = moving(40, -5, (10, 0, 90), (1, 1.5, 90), (28, 1.5, 90), (1, 0, 90), (20, 0, 90), **ON_FOOT)
BRAKES_THEN_CUTS_IN = moving(20, 3.5, (10, 8, 0), (10, 5, 0), (15, 5, 0), (2, 5, -15), (30, 5, -15), speed=8)


def test_acts_are_seen_in_the_order_in_which_they_were_said() -> None:
    assert failures([Action.BRAKE, Action.CUT_IN], BRAKES_THEN_CUTS_IN) == ()
    assert failures([Action.CUT_IN, Action.BRAKE], BRAKES_THEN_CUTS_IN) == (
        "action: said cut-in, then brake, but the adversary does it the other way round",
    )


def test_an_act_that_comes_twice_is_taken_where_it_is_in_order() -> None:
    again = moving(20, 3.5, (10, 8, 0), (5, 5, 0), (20, 5, 0), (2, 5, -15), (28, 5, -15), (2, 5, 0), (8, 1, 0), speed=8)
    assert failures([Action.BRAKE, Action.CUT_IN], again) == ()
    assert failures([Action.CUT_IN, Action.BRAKE], again) == ()


def test_a_contact_between_two_acts_leaves_the_second_unseen() -> None:
    said = [Action.CROSS, Action.STOP]
    assert failures(said, CROSSES_THEN_STOPS) == ()
    assert failures(said, CROSSES_THEN_STOPS, contact=30) == (
        "action: said stop, but the adversary had not begun to when the ego crashed",
    )


def test_what_begins_within_a_second_begins_together() -> None:
    speeds_up_into_the_gap = moving(10, 3.5, (10, 4, 0), (8, 6, 0), (2, 8, -12), (20, 8, -12), speed=4)
    assert failures([Action.ACCELERATE, Action.CUT_IN], speeds_up_into_the_gap) == ()
    assert failures([Action.CUT_IN, Action.ACCELERATE], speeds_up_into_the_gap) == ()


def test_what_is_done_all_along_has_no_place_in_the_order() -> None:
    crawls_then_stops = moving(40, 0, (40, 2, 0), (1, 1, 0), (1, 0, 0), (20, 0, 0), speed=2)
    assert Action.SLOW.row.all_along
    assert failures([Action.STOP, Action.SLOW], crawls_then_stops) == ()
    assert failures([Action.SLOW, Action.STOP], crawls_then_stops) == ()


def test_whoever_crosses_to_the_far_side_has_not_turned_back() -> None:
    assert failures([Action.CROSS], CROSSING) == ()
    far = moving(40, -5, (80, 1.5, 90), **ON_FOOT, speed=1.5)
    assert float(far.y[-1]) > 5.0
    assert failures([Action.TURN_BACK], far) != ()


def test_a_bend_of_the_road_is_no_turn() -> None:
    slight = moving(60, 3.5, (10, 8, 180), (20, 8, 205), (10, 8, 205), facing=180, speed=8)
    assert failures([Action.TURN_LEFT], slight) != ()


# The ladder


@dataclass
class Shown:
    """A simulator whose every session is over as soon as it is opened, with the same drive through a contact."""

    shown: Episode
    rejection: str = ""
    identity = SimulatorIdentity(name="shown", version="1", physics="a script", exact=True, confinable=False)

    @property
    def ending(self) -> Ending:
        return self.shown.ending

    def open(self, *_: object, **__: object) -> Shown:
        return self

    def step(self, *_: object) -> None:
        raise AssertionError("it is over")

    def episode(self, *_: object) -> Episode:
        return self.shown

    def close(self) -> None:
        pass

    def route_in(self, *_: object) -> Route:
        return ROUTE


def climbed(track: Track, contact: int) -> None:
    program = ScenicProgram(scenario_id="toy", source="", parameters=(), snippet_ids=())
    simulator = cast("Simulator", Shown(episode(track, contact=contact, through=True)))
    check(program, Slots(actions=(Action.CROSS, Action.STOP)), simulator, RuleBased())


def test_a_program_whose_ego_crashes_before_the_act_tests_nobody_with_it() -> None:
    climbed(CROSSES_THEN_STOPS, contact=44)
    with pytest.raises(MeansSomethingElse, match="said stop, but the adversary had not begun to when the ego crashed"):
        climbed(CROSSES_THEN_STOPS, contact=30)


def test_a_program_that_begins_an_act_and_never_does_it_is_refused() -> None:
    legs = ((10, 0, 90), (1, 1.5, 90), (28, 1.5, 90), (3, 0.7, 90), (30, 0.7, 90))
    never_stands = moving(40, -5, *legs, **ON_FOOT)
    assert failures([Action.CROSS, Action.STOP], never_stands, contact=42) == ()
    with pytest.raises(MeansSomethingElse, match="said stop, but the adversary never does"):
        climbed(never_stands, contact=42)


@pytest.mark.parametrize(("turns", "place"), [(-1.0, Place.RIGHT_CURVE), (1.0, Place.LEFT_CURVE)])
def test_a_bend_to_a_side_is_told_as_a_plain_truth(turns: float, place: Place) -> None:
    line = Polyline([(math.sin(turn), turns * (1.0 - math.cos(turn))) for turn in np.linspace(0.0, 1.5, 9)])
    route = replace(ROUTE, place=Place.CURVE, line=line)
    other = Place.LEFT_CURVE if place is Place.RIGHT_CURVE else Place.RIGHT_CURVE
    assert is_place(place, route) is True  # what is not the truth itself, as of an array, would be counted as not shown
    assert is_place(other, route) is False


@pytest.mark.parametrize("over", [25.0, 110.0, 300.0])
def test_a_change_of_lanes_is_one_however_much_road_it_takes(over: float) -> None:
    x = np.arange(600.0)
    y = 3.5 * np.clip((x - 130.0) / over, 0.0, 1.0)
    route = replace(ROUTE, maneuver=Maneuver.LANE_CHANGE_LEFT, line=Polyline(np.column_stack([x, y])))
    assert maneuver_of(route) is Maneuver.LANE_CHANGE_LEFT
    straight = Polyline(np.column_stack([x, 0.0 * x]))
    assert maneuver_of(replace(route, line=straight)) is Maneuver.STRAIGHT


def test_a_turn_is_one_at_the_junction_however_the_road_bends_before_and_after_it() -> None:
    turn = np.linspace(0.0, math.pi / 2, 10)
    left = np.column_stack([20.0 + 8.0 * np.sin(turn), 8.0 - 8.0 * np.cos(turn)])
    back = np.column_stack([58.0 - 30.0 * np.cos(turn), 30.0 + 30.0 * np.sin(turn)])  # to the right again
    line = Polyline(np.concatenate([[(0.0, 0.0), (10.0, 0.0)], left, back]))
    route = replace(ROUTE, place=Place.FOUR_WAY, junction="i1", line=line, event_at=19.0, exit_at=35.0)
    assert maneuver_of(route) is Maneuver.LEFT_TURN
    assert maneuver_of(replace(route, exit_at=None)) is Maneuver.STRAIGHT  # nobody asked where the junction ends
