"""What somebody is seen to do, and what not, on tracks made by hand."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from test_encounter import BRAKES, CROSSES, found, one, other, shown
from test_meaning import CUTTING_IN, DT, ROUTE, episode, moving

from chatscene.program.doing import ACTS, standing
from chatscene.program.judge import judge
from chatscene.program.watching import watch
from chatscene.terms.amount import Speed
from chatscene.terms.episode import Episode, Role, Track
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import Route
from chatscene.terms.scenario import Place, Site
from chatscene.terms.situation import Contact, Deed, Ego
from chatscene.terms.vocabulary import Act, EgoRoute, Part, Side, UserKind, Where

LEFT = replace(
    ROUTE,
    id="left",
    line=Polyline(
        np.concatenate(
            (
                np.column_stack([np.arange(40.0), np.zeros(40)]),
                [(40 + 20 * np.sin(a), 20 - 20 * np.cos(a)) for a in np.linspace(0.0, np.pi / 2, 32)],
                np.column_stack([np.full(60, 60.0), 20 + np.arange(1.0, 61.0)]),
            )
        )
    ),
    event_at=40.0,
)
ACT = "others.adversary.does.0.act"


def does(act: Act, track: Track, route: Route = ROUTE, *, until: int | None = None) -> bool:
    """Whether a deed is done on a track; with a last step, also whether it is under way then."""
    times = list(ACTS[act](watch(episode(track), route, track, until)))
    return any(until is not None or once.done is not None for once in times)


ON = moving(20.0, 0.0, (100, 8.0, 0.0), speed=8.0)
TURNS_LEFT = moving(50.0, 3.5, (20, 6.0, 180.0), (26, 6.0, 270.0), (40, 8.0, 270.0), facing=180.0, speed=6.0)
"""An oncoming car that turns across the ego's way."""
CHANGES = moving(20.0, 0.0, (10, 8.0, 0.0), (5, 8.0, 15.0), (12, 8.0, 15.0), (5, 8.0, 0.0), (60, 8.0, 0.0), speed=8.0)
LEAVES = moving(20.0, 0.0, (30, 8.0, 0.0), (10, 8.0, 20.0), (60, 8.0, 20.0), speed=8.0)
SWINGS = moving(
    20.0,
    0.0,
    (10, 8.0, 0.0),
    (6, 8.0, 20.0),
    (6, 8.0, 20.0),
    (6, 8.0, 0.0),
    (6, 8.0, -20.0),
    (6, 8.0, -20.0),
    (6, 8.0, 0.0),
    (40, 8.0, 0.0),
    speed=8.0,
)
"""Leaves its line by three metres and comes back to it."""
PASSES = moving(-14.0, 3.5, (80, 12.0, 0.0), speed=12.0)


@pytest.mark.parametrize(
    ("act", "track", "seen"),
    [
        (Act.GO_STRAIGHT, ON, True),
        (Act.GO_STRAIGHT, TURNS_LEFT, False),
        (Act.EXIT, ON, False),
        (Act.EXIT, LEAVES, True),
        (Act.EXIT, SWINGS, False),
        (Act.EXIT, TURNS_LEFT, False),
        (Act.SWERVE, SWINGS, True),
        (Act.SWERVE, TURNS_LEFT, False),
        (Act.DRIFT, SWINGS, True),
        (Act.DRIFT, TURNS_LEFT, False),
        (Act.LANE_CHANGE, CHANGES, True),
        (Act.LANE_CHANGE, TURNS_LEFT, False),
        (Act.CUT_OUT, CHANGES, True),
        (Act.CUT_OUT, TURNS_LEFT, False),
        (Act.CUT_IN, CUTTING_IN, True),
        (Act.CUT_IN, TURNS_LEFT, False),
        (Act.FOLLOW, ON, False),
        (Act.FOLLOW, moving(-20.0, 0.0, (100, 8.0, 0.0), speed=8.0), True),
        (Act.FOLLOW, moving(-60.0, 0.0, (100, 8.0, 0.0), speed=8.0), False),  # 7.5 s behind
        (Act.FOLLOW, moving(-60.0, 0.0, (100, 14.0, 0.0), speed=14.0), True),  # 4.3 s behind, and nearer
    ],
)
def test_a_deed_is_seen_of_who_does_it_and_not_of_who_only_moves(act: Act, track: Track, *, seen: bool) -> None:
    assert does(act, track) is seen


def test_who_leaves_a_roundabout_by_the_way_of_the_ego_takes_an_exit() -> None:
    goes = other(Where.AHEAD, Deed(act=Act.EXIT))
    beyond, short = moving(60.0, 0.0, (100, 8.0, 0.0), speed=8.0), moving(20.0, 0.0, (60, 8.0, 0.0), speed=8.0)
    for track, route, right in (
        (beyond, EgoRoute.ROUNDABOUT, True),
        (short, EgoRoute.ROUNDABOUT, False),
        (beyond, EgoRoute.STRAIGHT, False),
    ):
        assert shown(ACT, one(goes, ego=Ego(route=route)), episode(track)) is right


def test_who_has_just_begun_to_follow_when_the_drive_is_cut_short_is_seen_to() -> None:
    behind = moving(-20.0, 0.0, (100, 8.0, 0.0), speed=8.0)
    assert does(Act.FOLLOW, behind, until=6)
    assert not does(Act.FOLLOW, behind, until=2)


def test_who_parks_stands_aside_and_not_in_the_ego_lane() -> None:
    stops = (20, 8.0, 0.0), (20, 0.0, 0.0), (40, 0.0, 0.0)
    aside = (10, 6.0, -15.0), (15, 4.0, -15.0), (10, 3.0, 0.0), (15, 0.0, 0.0), (40, 0.0, 0.0)
    assert does(Act.PARK, moving(30.0, 0.0, *aside, speed=8.0))
    assert not does(Act.PARK, moving(30.0, 0.0, *stops, speed=8.0))
    assert does(Act.STOP, moving(30.0, 0.0, *stops, speed=8.0))


def test_who_follows_a_way_that_bends_has_not_begun_to_turn_round() -> None:
    along = np.arange(20.0, 75.0, 0.6)
    x, y = np.array([LEFT.line.point_at(at) for at in along]).T
    heading = np.array([LEFT.line.heading_at(at) for at in along])
    follows = replace(ON, x=x, y=y, heading=heading, speed=np.full(len(x), 6.0))
    assert not does(Act.U_TURN, follows, LEFT, until=70)
    assert does(Act.TURN_LEFT, follows, LEFT)
    round_it = moving(80.0, 3.5, (20, 4.0, 180.0), (30, 4.0, 300.0), facing=180.0, speed=4.0)
    assert does(Act.U_TURN, round_it, until=45)


def test_who_crosses_the_ego_lane_to_the_far_side_does_not_enter_it() -> None:
    over = moving(48.0, -6.0, (80, 2.0, 90.0), facing=90.0, speed=2.0, kind="Pedestrian")
    stays = moving(48.0, -6.0, (28, 2.0, 90.0), (2, 0.0, 90.0), (50, 0.0, 90.0), facing=90.0, speed=2.0)
    assert does(Act.CROSS, over)
    assert not does(Act.ENTER, over)
    assert does(Act.ENTER, stays)


def test_who_stood_before_a_deed_stands_after_it_only_if_it_still_does() -> None:
    track = moving(30.0, 0.0, (10, 0.0, 0.0), (10, 8.0, 0.0), (60, 8.0, 0.0))
    seen = watch(episode(track), ROUTE, track)
    assert [once.began for once in standing(seen)] == [0]
    assert not list(standing(seen, since=12))


# In order


def test_of_one_movement_aside_not_two_deeds_are_seen() -> None:
    for second in (Act.LANE_CHANGE, Act.ENTER):
        said = one(other(Where.AHEAD_BESIDE, Deed(act=Act.CUT_IN), Deed(act=second), side=Side.LEFT))
        assert shown(ACT, said, episode(CUTTING_IN)) is True
        assert shown("others.adversary.does.1.act", said, episode(CUTTING_IN)) is False


def test_who_slows_for_a_turn_does_not_slow_after_it() -> None:
    said = one(other(Where.ONCOMING, Deed(act=Act.TURN_LEFT), Deed(act=Act.BRAKE)))
    turn = (20, 10.0, 180.0), (15, 5.0, 180.0), (26, 5.0, 270.0)
    before = moving(70.0, 3.5, *turn, (40, 8.0, 270.0), facing=180.0, speed=10.0)
    after = moving(70.0, 3.5, *turn, (10, 0.0, 270.0), (40, 0.0, 270.0), facing=180.0, speed=10.0)
    assert shown("others.adversary.does.1.act", said, episode(before)) is False
    assert shown("others.adversary.does.1.act", said, episode(after)) is True


PAUSES_AT_THE_EDGE = moving(
    110.0,
    -8.0,
    (20, 2.0, 90.0),
    (3, 0.0, 90.0),
    (20, 0.0, 90.0),
    (5, 2.0, 90.0),
    (60, 2.0, 90.0),
    facing=90.0,
    speed=2.0,
    kind="Pedestrian",
)
"""Comes up to the road, stands there for two seconds, and goes over it."""


def in_order(
    track: Track, where: Where, *acts: Act, side: Side | None = None, kind: UserKind = UserKind.CAR
) -> list[bool]:
    """Which of some deeds are shown, said in this order."""
    said = one(other(where, *(Deed(act=act) for act in acts), kind=kind, side=side))
    return [shown(f"others.adversary.does.{k}.act", said, episode(track)) is True for k in range(len(acts))]


def test_who_pauses_before_the_road_and_then_crosses_does_not_cross_and_then_pause() -> None:
    for acts, right in (((Act.HESITATE, Act.CROSS), True), ((Act.CROSS, Act.HESITATE), False)):
        found = in_order(PAUSES_AT_THE_EDGE, Where.ROADSIDE, *acts, side=Side.RIGHT, kind=UserKind.PEDESTRIAN)
        assert found == [True, right]


@pytest.mark.parametrize("second", [Act.CUT_IN, Act.CUT_OUT, Act.SWERVE, Act.LANE_CHANGE])
def test_who_comes_into_a_lane_does_not_leave_its_line_once_more_by_that(second: Act) -> None:
    pulls_out = moving(40.0, -3.5, (10, 0.0, 0.0), (10, 4.0, 25.0), (14, 5.0, 25.0), (8, 6.0, 0.0), (60, 8.0, 0.0))
    assert in_order(pulls_out, Where.KERB, Act.PULL_OUT, second, side=Side.RIGHT) == [True, False]


def test_of_two_times_that_somebody_brakes_the_harder_one_is_meant() -> None:
    lightly, hard = (6, 8.5, 0.0), (12, 0.0, 0.0)
    track = moving(20.0, 3.5, (20, 10.0, 0.0), lightly, (2, 8.5, -10.0), (24, 8.5, -10.0), (2, 8.5, 0.0),
                   (10, 8.5, 0.0), hard, (20, 0.0, 0.0), speed=10.0)  # fmt: skip
    assert in_order(track, Where.AHEAD_BESIDE, Act.CUT_IN, Act.BRAKE, side=Side.LEFT) == [True, True]
    assert in_order(track, Where.AHEAD_BESIDE, Act.BRAKE, Act.CUT_IN, side=Side.LEFT) == [True, False]


def test_who_gets_past_does_not_keep_level_and_who_comes_in_and_stays_does_not_cross() -> None:
    assert does(Act.OVERTAKE, PASSES)
    assert not does(Act.KEEP_LEVEL, PASSES)
    assert does(Act.KEEP_LEVEL, moving(2.0, 3.5, (60, 8.0, 0.0), speed=8.0))
    assert does(Act.CUT_IN, CUTTING_IN)
    assert not does(Act.CROSS, CUTTING_IN)


def test_a_low_speed_is_not_had_by_whoever_gains_speed_through_it() -> None:
    runs = moving(110.0, -10.0, (20, 2.8, 90.0), (60, 2.8, 90.0), facing=90.0, kind="Pedestrian")
    for said, right in (("10 km/h", True), ("5 km/h", False)):
        crosses = Deed(act=Act.CROSS, speed=Speed.of(said))
        claim = one(other(Where.ROADSIDE, crosses, kind=UserKind.PEDESTRIAN, side=Side.RIGHT))
        assert shown("others.adversary.does.0.speed", claim, episode(runs)) is right


@pytest.mark.parametrize("act", [Act.LANE_CHANGE, Act.DRIFT, Act.SWERVE, Act.WEAVE, Act.CUT_OUT])
def test_who_goes_through_a_roundabout_as_the_ego_does_keeps_its_line(act: Act) -> None:
    turns = np.radians(np.concatenate((np.zeros(40), np.linspace(0, -60, 15), np.linspace(-60, 60, 60),
                                       np.linspace(60, 0, 15), np.zeros(60))))  # fmt: skip
    line = Polyline(np.cumsum(np.column_stack([np.cos(turns), np.sin(turns)]), axis=0))
    ring = replace(ROUTE, line=line, junction="ring", site=Site.ROUNDABOUT, place=Place.JUNCTION, event_at=40.0)
    along = np.arange(20.0, 180.0, 0.6)
    x, y = np.array([line.point_at(at) for at in along]).T
    heading = np.unwrap([line.heading_at(at) for at in along])
    assert not does(act, replace(ON, x=x, y=y, heading=heading, speed=np.full(len(x), 6.0)), ring)


# What is let go, and what nobody said


def part(name: str, *legs: tuple[int, float, float]) -> Track:
    return replace(moving(25.0, 0.0, *legs), actor=name, role=Role.BACKGROUND)


def test_a_load_is_dropped_by_whoever_has_one_and_as_often_as_was_said() -> None:
    once = one(other(Where.AHEAD, Deed(act=Act.DROP_LOAD)))
    none = one(other(Where.AHEAD, Deed(act=Act.GO_ALONG)))
    stops = episode(moving(30.0, 0.0, (20, 8.0, 0.0), (20, 0.0, 0.0), (60, 0.0, 0.0), speed=8.0))
    assert shown(ACT, once, stops) is False  # it stops, and nothing falls off it
    seen = episode(ON)
    load = part("adversary-load", (20, 0.0, 0.0), (5, 6.0, 0.0), (15, 0.0, 0.0), (60, 0.0, 0.0))
    drops = replace(seen, tracks=(*seen.tracks, load))
    assert shown(ACT, once, drops) is True
    assert found("unasked.adversary-load", once, drops) is None
    assert shown("unasked.adversary-load", none, drops) is False
    kept = replace(seen, tracks=(*seen.tracks, part("adversary-load", (100, 0.0, 0.0))))
    assert found("unasked.adversary-load", none, kept) is None


def test_who_crosses_and_comes_to_stand_in_the_way_is_told() -> None:
    stops = (30, 2.0, 90.0), (2, 0.0, 90.0), (70, 0.0, 90.0)
    seen = episode(moving(90.0, -6.0, *stops, facing=90.0, speed=2.0, kind="Pedestrian"))
    assert shown("unasked.adversary", CROSSES, seen) is False
    said = one(other(Where.ROADSIDE, Deed(act=Act.CROSS), Deed(act=Act.STOP), kind=UserKind.PEDESTRIAN))
    assert found("unasked.adversary", said, seen) is None
    goes = episode(moving(90.0, -6.0, (102, 2.0, 90.0), facing=90.0, speed=2.0, kind="Pedestrian"))
    assert found("unasked.adversary", CROSSES, goes) is None


def test_who_is_to_stand_and_goes_is_told() -> None:
    said = one(other(Where.AHEAD, Deed(act=Act.STAND)))
    still = (40, 0.0, 0.0)
    for legs, told in (
        (((60, 0.0, 0.0),), None),
        (((20, 3.0, 0.0),), "adversary moves away, which the text does not say"),
        (((20, -3.0, 0.0),), "adversary moves backwards, which the text does not say"),
    ):
        finding = found("unasked.adversary", said, episode(moving(60.0, 0.0, still, *legs)))
        assert (finding and finding.told) == told


def test_braking_in_bouts_without_a_break_is_one_time() -> None:
    bouts = (20, 8.0, 0.0), (5, 6.0, 0.0), (8, 5.0, 0.0), (10, 0.0, 0.0), (40, 0.0, 0.0)
    assert found("unasked.adversary", BRAKES, episode(moving(20.0, 0.0, *bouts, speed=8.0))) is None
    held = (20, 8.0, 0.0), (5, 6.0, 0.0), (15, 6.0, 0.0), (10, 0.0, 0.0), (40, 0.0, 0.0)
    assert shown("unasked.adversary", BRAKES, episode(moving(20.0, 0.0, *held, speed=8.0))) is False


def test_who_is_still_on_its_way_to_a_junction_that_the_ego_has_left_does_not_meet_it() -> None:
    junction = replace(ROUTE, junction="j", event_at=48.0)
    said = one(other(Where.ARM, Deed(act=Act.GO_STRAIGHT)))
    comes = episode(moving(55.0, -60.0, (100, 4.0, 90.0), facing=90.0, speed=4.0))  # there 8 s after the ego
    away = episode(moving(55.0, -30.0, (100, 4.0, 270.0), facing=270.0, speed=4.0))

    def met(seen: Episode, route: Route) -> list[bool | None]:
        return [f.shown for f in judge(said, seen, route) if f.path == "encounter.adversary"]

    assert met(comes, junction) == [False]
    assert met(comes, ROUTE) == []  # on open road nobody knows where it is bound for
    assert met(away, junction) == []


# The ego's speed and contacts


def test_a_contact_excuses_a_speed_that_is_not_reached_only_of_who_still_gains() -> None:
    said = one(other(Where.AHEAD, Deed(act=Act.STAND)), ego=Ego(speed=Speed.of("15 m/s")))
    seen = episode(moving(52.0, 0.0, (120, 0.0, 0.0)), contact=59)
    assert shown("ego.speed", said, seen) is False  # it goes at 8 m/s all the way
    ego = replace(seen.ego_track, speed=np.linspace(0.0, 8.0, 60))
    gains = replace(seen, tracks=(ego, *seen.tracks[1:]))
    assert shown("ego.speed", said, gains) is None


def test_a_contact_that_was_said_is_told_and_so_is_that_there_is_none() -> None:
    said = replace(CROSSES, contact=Contact(ego=Part.FRONT))
    near = moving(48.0, -6.0, (80, 1.0, 90.0), facing=90.0, speed=1.0, kind="Pedestrian")
    hit = [f for f in judge(said, episode(near, contact=57), ROUTE) if f.path == "contact.happens"]
    assert [(f.shown, f.at) for f in hit] == [(True, pytest.approx(57 * DT))]
    assert shown("contact.happens", said, episode(near)) is None
    none = replace(CROSSES, contact=Contact(happens=False))
    assert shown("contact.happens", none, episode(near)) is True
    assert shown("contact.happens", none, episode(near, contact=57)) is False


SWINGS_OUT = ((6, 12.0, 15.0), (12, 14.0, 15.0), (6, 14.0, 0.0))
COMES_IN = ((6, 8.0, -15.0), (12, 8.0, -15.0), (6, 8.0, 0.0))
GOES_OUT = ((6, 8.0, 15.0), (12, 8.0, 15.0), (6, 8.0, 0.0))
WAITS = ((30, 8.0, 0.0),)
IN_AND_OUT = moving(20.0, 3.5, *WAITS, *COMES_IN, *WAITS, *GOES_OUT, *WAITS, speed=8.0)


@pytest.mark.parametrize(
    ("track", "where", "acts"),
    [
        (IN_AND_OUT, "beside", (Act.CUT_IN, Act.CUT_OUT)),
        (IN_AND_OUT, "beside", (Act.CUT_IN, Act.LANE_CHANGE)),
        (
            moving(20.0, 0.0, *WAITS, (5, 8.0, 5.0), (12, 8.0, 5.0), (5, 8.0, 0.0), *WAITS, *GOES_OUT, *WAITS,
                   speed=8.0),
            "ahead",
            (Act.DRIFT, Act.LANE_CHANGE),
        ),
        (
            moving(-25.0, 0.0, (4, 10.0, -15.0), (4, 10.0, 0.0), (4, 10.0, 15.0), (14, 10.0, 0.0), *SWINGS_OUT,
                   (70, 14.0, 0.0), speed=10.0),
            "behind",
            (Act.SWERVE, Act.OVERTAKE),
        ),
        (
            moving(20.0, 0.0, (10, 8.0, 0.0), (4, 8.0, 15.0), (3, 8.0, 15.0), (8, 8.0, -15.0), (3, 8.0, -15.0),
                   (4, 8.0, 0.0), (60, 8.0, 0.0), speed=8.0),
            "ahead",
            (Act.SWERVE, Act.SWERVE),
        ),
        (
            moving(20.0, 3.5, (20, 12.0, 0.0), (12, 8.5, 0.0), (5, 8.5, 0.0), (3, 8.5, -10.0), (20, 8.5, -10.0),
                   (3, 8.5, 0.0), (20, 8.5, 0.0), (28, 0.0, 0.0), (30, 0.0, 0.0), speed=12.0),
            "beside",
            (Act.BRAKE, Act.CUT_IN, Act.STOP),
        ),
    ],
)  # fmt: skip
def test_a_second_movement_is_seen_from_where_the_first_one_ended(
    track: Track, where: str, acts: tuple[Act, ...]
) -> None:
    start = {"beside": Where.AHEAD_BESIDE, "ahead": Where.AHEAD, "behind": Where.BEHIND}[where]
    side = Side.LEFT if start is Where.AHEAD_BESIDE else None
    assert in_order(track, start, *acts, side=side) == [True] * len(acts)


def test_who_halts_in_the_middle_of_the_road_crosses_and_then_hesitates() -> None:
    walks = moving(
        60.0, 6.0, (24, 1.4, -90.0), (4, 0.0, -90.0), (20, 0.0, -90.0), (5, 1.3, -90.0), (80, 1.3, -90.0),
        facing=-90.0, speed=1.4, kind="Pedestrian",
    )  # fmt: skip
    found = in_order(walks, Where.ROADSIDE, Act.CROSS, Act.HESITATE, side=Side.LEFT, kind=UserKind.PEDESTRIAN)
    assert found == [True, True]


@pytest.mark.parametrize("degrees", [20.0, 25.0])
def test_who_goes_slantingly_over_the_lane_until_the_contact_crosses_it(degrees: float) -> None:
    walks = moving(50.0, -3.0, (90, 1.4, degrees), facing=degrees, speed=1.4, kind="Pedestrian")
    assert does(Act.CROSS, walks)
