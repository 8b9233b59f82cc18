# ruff: noqa: E501 - elements stand in one line each
"""What goes on in a story that is played: what ends when, how soon two meet, who is meant."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from chatscene.errors import ScenarioError
from chatscene.imports.written_story import written_story
from chatscene.search.generators.foreign import foreign_program
from chatscene.terms.polyline import Polyline
from chatscene.terms.storyboard import Storyboard
from chatscene.world.story.conditions import truth_of
from chatscene.world.story.entities import Bounds, Entity, room
from chatscene.world.story.pace import NO_TIME, UNBOUND, pace_of
from chatscene.world.story.places import Place, place_of
from chatscene.world.story.ways import Line, Way, way_of
from played import DISTANCE, STATE, TIME, driven, read, speed, story
from red_team.scenario_files import NEAR, alone, event, scenario

SHAPE = '<Trajectory name="t" closed="false"><Shape><Polyline>{}</Polyline></Shape></Trajectory>'
VERTEX = '<Vertex{}><Position><WorldPosition x="136.75" y="{}"/></Position></Vertex>'
UNTIMED, TIMED = "<None/>", '<Timing domainAbsoluteRelative="relative" scale="1" offset="0"/>'


def follows(*vertices: tuple[float, float], timed: bool, offset: str = "0") -> str:
    """A line along x = 136.75, of (y, s)."""
    line = "".join(VERTEX.format(f' time="{time}"' if timed else "", y) for y, time in vertices)
    reference = f"<TimeReference>{TIMED if timed else UNTIMED}</TimeReference>"
    return f'<RoutingAction><FollowTrajectoryAction initialDistanceOffset="{offset}"><TrajectoryRef>{SHAPE.format(line)}</TrajectoryRef>{reference}</FollowTrajectoryAction></RoutingAction>'


LONG = follows((-345, 0), (-200, 0), timed=False)
FAST = follows((-345, 0), (-200, 20), timed=True)
JUMP = '<TeleportAction><Position><WorldPosition x="136.75" y="-300" h="1.570796"/></Position></TeleportAction>'
GONE = '<GlobalAction><EntityAction entityRef="lead"><DeleteEntityAction/></EntityAction></GlobalAction>'


def stopped_by(condition: str, text: str) -> str:
    """A scenario that ends when a condition holds."""
    whole = f'<StopTrigger><ConditionGroup><Condition name="x" delay="0" conditionEdge="none">{condition}</Condition></ConditionGroup></StopTrigger></Storyboard>'
    return text.replace("<StopTrigger/></Storyboard>", whole)


@pytest.mark.parametrize(
    ("first", "second"),
    [(LONG, JUMP), (LONG, GONE), (speed(9, 30), GONE), (speed(9, 30), FAST), (FAST, speed(3)), (FAST, JUMP)],
    ids=["way-jump", "way-leave", "pace-leave", "pace-timed", "timed-pace", "timed-jump"],
)
def test_what_something_else_replaces_is_over_for_who_waits_for_it(first: str, second: str, beside: Path) -> None:
    events = event(first, TIME.format(1), "first") + event(second, TIME.format(2), "second")
    events = events.replace('"overwrite"', '"parallel"').replace(f"<PrivateAction>{GONE}</PrivateAction>", GONE)
    text = scenario(events=events + event(DISTANCE, TIME.format(90), "later"))
    found = driven(beside, stopped_by(STATE.format("event", "first", "completeState"), text))
    assert str(found.ending) == "scenario-done"
    assert 19 <= len(found.tracks[0].x) <= 25


def test_a_file_in_which_only_the_ego_does_something_ends_as_it_tells(beside: Path) -> None:
    text = scenario().replace('entityRef="lead"/></Actors>', 'entityRef="ego"/></Actors>')
    text = stopped_by(
        TIME.format(1), text.replace('<AbsoluteTargetSpeed value="5"/>', '<AbsoluteTargetSpeed value="0"/>')
    )
    found = driven(beside, text)
    assert str(found.ending) == "scenario-done"
    assert len(found.tracks[0].x) <= 13


def test_the_end_of_a_file_with_nobody_but_an_ego_is_noted(beside: Path) -> None:
    found = read(beside, stopped_by(TIME.format(1), alone()))
    assert any("ends as usual, not as the file says" in note for note in found.notes)
    foreign_program("theirs", written_story(found.board, "theirs.xosc"))  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("dynamics", "told"),
    [('dynamicsDimension="time" value="7"', "after 7 s, as the file says"), ('dynamicsDimension="rate" value="2"', "after 3 s, since no time is given")],
)  # fmt: skip
def test_how_long_the_ego_is_waited_for_is_noted(dynamics: str, told: str, beside: Path) -> None:
    does = f'<LongitudinalAction><SpeedAction><SpeedActionDynamics dynamicsShape="linear" {dynamics}/><SpeedActionTarget><AbsoluteTargetSpeed value="3"/></SpeedActionTarget></SpeedAction></LongitudinalAction>'
    text = scenario(events=event(does)).replace('entityRef="lead"/></Actors>', 'entityRef="ego"/></Actors>')
    found = read(beside, text.replace('<AbsoluteTargetSpeed value="5"/>', '<AbsoluteTargetSpeed value="0"/>'))
    assert any(told in note for note in found.notes)


# Selections


BY_TYPE = '<EntitySelection name="all"><Members>{}</Members></EntitySelection></Entities>'


def about(who: str) -> str:
    return event(DISTANCE, NEAR.replace('<EntityRef entityRef="ego"/>', f'<EntityRef entityRef="{who}"/>'))


@pytest.mark.parametrize(
    "members",
    ['<ByType objectType="vehicle"/>', '<EntityRef entityRef="inner"/>', '<EntityRef entityRef="ego"/><EntityRef entityRef="lead"/>'],
    ids=["type", "selection", "names"],
)  # fmt: skip
def test_a_selection_holds_those_that_it_names_by_type_selection_or_name(members: str, beside: Path) -> None:
    inner = BY_TYPE.replace('"all"', '"inner"').format('<ByType objectType="vehicle"/>').removesuffix("</Entities>")
    text = scenario(events=about("all")).replace("</Entities>", inner + BY_TYPE.format(members))
    assert "'apart', 'any', ('ego', 'lead')" in str(story(beside, text).acts)


@pytest.mark.parametrize(
    ("members", "why"),
    [("", "it is empty"), ('<ByType objectType="boat"/>', "the type 'boat' is not known"), ('<EntityRef entityRef="who"/>', "'who' is not an entity"), ('<EntityRef entityRef="all"/>', "'all' is not an entity")],
)  # fmt: skip
def test_a_selection_of_nobody_who_is_known_is_refused(members: str, why: str, beside: Path) -> None:
    text = scenario(events=about("ego")).replace("</Entities>", BY_TYPE.format(members))
    with pytest.raises(ScenarioError, match=rf"line \d+: .*{why}"):
        read(beside, text)


def chain(count: int) -> str:
    """Selections each of which names the next one twice."""
    names = [*(f"s{i}" for i in range(count)), "lead"]
    twice = (f'<EntityRef entityRef="{name}"/><EntityRef entityRef="{name}"/>' for name in names[1:])
    parts = (BY_TYPE.replace('"all"', f'"{one}"').format(of) for one, of in zip(names, twice, strict=False))
    return "".join(part.removesuffix("</Entities>") for part in parts) + "</Entities>"


def test_selections_of_selections_are_read_once_and_refused_where_they_lie_too_deep(beside: Path) -> None:
    text = scenario(events=about("s0"))
    assert "'apart', 'any', ('lead',)" in str(story(beside, text.replace("</Entities>", chain(40))).acts)
    with pytest.raises(ScenarioError, match=r"line \d+: .*more than 50 deep"):
        read(beside, text.replace("</Entities>", chain(60)))


def test_that_a_condition_is_about_nobody_who_is_there_is_noted(beside: Path) -> None:
    text = scenario(events=about("all") + event(DISTANCE, TIME.format(1))).replace(
        "</Entities>", BY_TYPE.format('<ByType objectType="pedestrian"/>')
    )
    notes = read(beside, text).notes
    assert any("there is nobody of the type pedestrian" in note for note in notes)
    assert any("none of its entities exists; this never holds" in note for note in notes)


def test_a_collision_with_a_type_is_one_with_those_of_that_type(beside: Path) -> None:
    hit = '<ByEntityCondition><TriggeringEntities triggeringEntitiesRule="any"><EntityRef entityRef="ego"/></TriggeringEntities><EntityCondition><CollisionCondition><ByType type="{}"/></CollisionCondition></EntityCondition></ByEntityCondition>'
    told = [
        str(story(beside, scenario(events=event(DISTANCE, hit.format(kind)))).acts)
        for kind in ("vehicle", "pedestrian")
    ]
    assert "'touches', 'any', ('ego',), ('ego', 'lead'))" in told[0]
    assert "'touches', 'any', ('ego',), ())" in told[1]


# Times to collisions and lines, of bodies that are where a test says


class Bodies:
    """A world of those whose poses are told: x, y [m], heading [rad], speed [m/s]; each follows the x axis."""

    def __init__(self, **poses: tuple[float, float, float, float]) -> None:
        self.time, self.variables = 0.0, dict[str, Any]()
        line = SimpleNamespace(line=Polyline([(-1000.0, 0.0), (1000.0, 0.0)]))
        self._who = {
            name: Entity(SimpleNamespace(pose=pose, route=line, isWalker=False, length=4.0, width=2.0), name, 0.0, None)
            for name, pose in poses.items()
        }

    def entity(self, name: str) -> Entity:
        return self._who[name]

    def place(self, told: tuple[Any, ...]) -> Place:
        return place_of(told, self.entity)

    def is_in(self, kind: str, name: str, state: str) -> bool:
        raise AssertionError((kind, name, state))


def in_less_than(seconds: float, world: Bodies, other: Any, how: str = "", frame: str = "entity") -> bool:
    return truth_of(("collision-in", "any", ("a",), "lessThan", seconds, other, how, frame, False), world)()


EAST, NORTH, WEST = 0.0, math.pi / 2, math.pi
PLACE = ("at", 100.0, 0.0, 0.0)


@pytest.mark.parametrize("how", ["", "longitudinal"])
@pytest.mark.parametrize("frame", ["entity", "road"])
@pytest.mark.parametrize(("heading", "speed", "near"), [(EAST, 10.0, True), (WEST, 10.0, False), (WEST, -10.0, True)])
def test_only_who_comes_nearer_to_a_place_has_a_time_to_it(
    heading: float, speed: float, near: bool, how: str, frame: str
) -> None:
    world = Bodies(a=(0.0, 0.0, heading, speed))
    assert in_less_than(10.1, world, PLACE, how, frame) is near
    assert not in_less_than(9.9, world, PLACE, how, frame)


@pytest.mark.parametrize(
    ("other", "how", "frame", "seconds"),
    [
        ((100.0, 0.0, WEST, 10.0), "", "entity", 5.0),
        ((100.0, 0.0, EAST, 5.0), "longitudinal", "entity", 20.0),
        ((-50.0, 0.0, EAST, 20.0), "longitudinal", "road", 5.0),
        ((30.0, -40.0, NORTH, 10.0), "", "entity", 50.0 / (10.0 * 0.6 + 10.0 * 0.8)),
        ((30.0, -40.0, NORTH, 10.0), "lateral", "entity", 4.0),
        ((30.0, -40.0, NORTH, 10.0), "lateral", "road", 4.0),
        ((30.0, -40.0, NORTH, 10.0), "longitudinal", "road", 3.0),
        ((100.0, 0.0, EAST, 15.0), "", "entity", math.inf),
        ((30.0, -40.0, -NORTH, 10.0), "lateral", "entity", math.inf),
    ],
)  # fmt: skip
def test_the_time_of_two_to_each_other_is_of_what_both_do_along_the_axis_that_is_asked(
    other: tuple[float, float, float, float], how: str, frame: str, seconds: float
) -> None:
    world = Bodies(a=(0.0, 0.0, EAST, 10.0), b=other)
    assert in_less_than(seconds + 0.01, world, "b", how, frame) is math.isfinite(seconds)
    assert not in_less_than(min(seconds - 0.01, 1e6), world, "b", how, frame)


def test_a_place_beside_somebody_moves_as_that_one_does() -> None:
    world = Bodies(a=(0.0, 0.0, EAST, 10.0), b=(100.0, 5.0, WEST, 10.0))
    beside_b = ("beside", "b", 0.0, 5.0, 0.0)
    assert in_less_than(5.01, world, beside_b)
    assert not in_less_than(4.99, world, beside_b)


@pytest.mark.parametrize("for_good", [True, False])
def test_an_offset_from_somebody_is_kept_for_good_only_where_that_is_told(for_good: bool) -> None:
    world = Bodies(a=(0.0, 0.0, EAST, 10.0), b=(50.0, 2.0, EAST, 10.0))
    way = way_of(("aside", "sinusoidal", 0.0, ("mine", 1.0), for_good), world.entity("a"), world)
    assert way is not None
    assert way.goes(300.0, 30.0)[:2] == pytest.approx((300.0, 1.0))
    assert way.done is not for_good
    world.entity("a").agent.isWalker = True  # whose left is no lane's
    way = way_of(("aside", "sinusoidal", 0.0, ("of", "b", 0.0), for_good), world.entity("a"), world)
    assert way is not None
    world.entity("b").put(50.0, 4.0, EAST, 10.0)
    assert way.goes(300.0, 30.0)[:2] == pytest.approx((300.0, 4.0 if for_good else 2.0))


def test_a_line_is_followed_from_the_distance_along_it_that_is_told() -> None:
    world = Bodies(a=(40.0, 0.0, EAST, 10.0))
    world.time = 3.0
    table = ((2.0, 0.0), (4.0, 40.0), (10.0, 100.0))
    line = Polyline([(0.0, 0.0), (100.0, 0.0)])
    for absolute, begins, goes_at in ((False, 40.0, 10.0), (True, 40.0, 20.0)):
        way = way_of(("line", line, (absolute, table), 40.0), world.entity("a"), world)
        assert way is not None
        assert way.speed() == pytest.approx(goes_at)
        assert way.goes(0.0, 0.0) == pytest.approx((begins, 0.0, 0.0))
        assert way.goes(0.0, 2.0) == pytest.approx((60.0 if not absolute else 50.0, 0.0, 0.0))


def test_a_distance_along_a_line_that_is_longer_than_it_is_refused(beside: Path) -> None:
    def told(offset: str) -> str:
        return scenario(events=event(follows((-345, 0), (-245, 20), timed=True, offset=offset)))

    assert "20.0)" in str(story(beside, told("20")).acts)
    with pytest.raises(ScenarioError, match=r"its line is 100 m long, and 100 m is not on it"):
        read(beside, told("100"))


def test_the_line_of_a_trajectory_is_built_once(beside: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    built: list[int] = []

    def counting(points: Sequence[tuple[float, ...]]) -> Polyline:
        built.append(len(points))
        return Polyline(points)

    monkeypatch.setattr("chatscene.imports.shapes.Polyline", counting)
    way = follows((-345, 0), (-300, 5), (-300, 8), (-245, 20), timed=True)
    assert "(8.0, 45.0)" in str(story(beside, scenario(events=event(way))).acts)
    assert built.count(4) == 1


def test_who_is_early_at_the_end_of_a_timed_line_stands_there(beside: Path) -> None:
    way = follows((-345, 0), (-325, 2), (-320, 4), (-320, 6), timed=True)
    track = driven(beside, scenario(events=event(way, TIME.format(1))), steps=75).adversaries[0]
    assert track.y[-1] == pytest.approx(track.y[60], abs=0.02)
    assert track.speed[-1] == pytest.approx(0.0, abs=0.01)


def test_that_a_plan_follows_its_line_from_where_somebody_is_is_noted(beside: Path) -> None:
    line = SHAPE.replace('"t"', '"leadWay"').format(VERTEX.format("", -345) + VERTEX.format("", -245))
    at = f'<TrajectoryPosition s="2" t="0"><TrajectoryRef>{line}</TrajectoryRef></TrajectoryPosition>'
    way = follows((-345, 0), (-245, 0), timed=False, offset="20").replace('"t"', '"leadWay"')
    found = read(
        beside, scenario(place=at, events=event(way, TIME.format(1)) + event(speed(2), TIME.format(3), "then"))
    )
    assert isinstance(found.board, Storyboard)
    assert any("follows its line from its position" in note for note in found.notes)


HEADWAY = '<ByEntityCondition><TriggeringEntities triggeringEntitiesRule="any"><EntityRef entityRef="lead"/></TriggeringEntities><EntityCondition><TimeHeadwayCondition entityRef="ego" value="0.1" freespace="true" rule="greaterThan" relativeDistanceType="longitudinal"/></EntityCondition></ByEntityCondition>'


def test_there_is_no_headway_to_somebody_behind(beside: Path) -> None:
    found = driven(beside, stopped_by(HEADWAY, scenario(events=event(DISTANCE, TIME.format(90)))), 20)
    assert str(found.ending) != "scenario-done"  # the ego is 29 m behind


def test_who_comes_to_the_end_of_a_line_of_lanes_goes_on_as_far_beside_it() -> None:
    line, onward = Polyline([(0.0, 0.0), (10.0, 0.0)]), Polyline([(10.0, 0.0), (30.0, 0.0)])
    way = Way(SimpleNamespace(origin=(9.0, 1.5, 0.0)), line)  # type: ignore[arg-type]
    way.goes(3.0, 0.1)
    assert way.over == pytest.approx(2.0)
    way.goes_on_along(onward)
    assert way.goes(1.0, 0.1)[:2] == pytest.approx((13.0, 1.5))


def test_who_follows_times_evenly_changes_speed_steadily_and_comes_to_each_place_in_time() -> None:
    who = SimpleNamespace(origin=(0.0, 0.0, 0.0), pose=(0.0, 0.0, 0.0, 10.0), speed=10.0)
    world = SimpleNamespace(time=0.0)
    table = ((0.0, 0.0), (2.0, 20.0), (3.0, 25.0))
    way = Line(who, world, Polyline([(0.0, 0.0), (25.0, 0.0)]), (False, table, True), 0.0)  # type: ignore[arg-type]
    world.time = 2.5
    assert way.speed() == pytest.approx(5.0)
    assert way.goes(0.0, 0.0)[0] == pytest.approx(23.75)
    assert way.goes(0.0, 0.5)[0] == pytest.approx(25.0)


@pytest.mark.parametrize(("heading", "speed"), [(0.0, 10.0), (math.pi, -10.0)])
def test_who_begins_further_along_times_or_backs_along_them_does_not_jump(heading: float, speed: float) -> None:
    who = SimpleNamespace(origin=(50.0, 0.0, heading), pose=(50.0, 0.0, heading, speed), speed=speed)
    world, table = SimpleNamespace(time=0.0), ((0.0, 0.0), (10.0, 100.0))
    way = Line(who, world, Polyline([(0.0, 0.0), (100.0, 0.0)]), (False, table, True), 50.0)  # type: ignore[arg-type]
    assert way.goes(0.0, 0.1)[0] == pytest.approx(51.0)
    assert way.goes(0.0, 5.0)[0] == pytest.approx(100.0)


def test_who_has_more_time_than_it_takes_to_stop_waits_at_its_place() -> None:
    who, world = (
        SimpleNamespace(origin=(0.0, 0.0, 0.0), pose=(0.0, 0.0, 0.0, 10.0), speed=10.0),
        SimpleNamespace(time=0.0),
    )
    table = ((0.0, 0.0), (4.0, 10.0), (6.0, 10.0))
    way = Line(who, world, Polyline([(0.0, 0.0), (10.0, 0.0)]), (False, table, True), 0.0)  # type: ignore[arg-type]
    assert [way.goes(0.0, t)[0] for t in (2.0, 3.0, 5.0)] == pytest.approx([10.0, 10.0, 10.0])
    assert way.goes(0.0, 1.0)[0] == pytest.approx(7.5)


@pytest.mark.parametrize(("turn", "taken"), [(0.0, 4.0), (math.pi / 2, 3.0), (math.pi / 4, 2.0 + 3.0 / math.sqrt(2))])
def test_a_body_takes_of_a_distance_what_it_is_as_it_is_turned(turn: float, taken: float) -> None:
    agent = SimpleNamespace(length=4.0, width=2.0)
    one, other = (SimpleNamespace(agent=agent, pose=(x, 0.0, h, 0.0)) for x, h in ((0.0, 0.0), (20.0, turn)))
    assert room(one, other, "longitudinal", "entity") == pytest.approx(taken)  # type: ignore[arg-type]


def test_a_second_place_of_init_is_where_somebody_begins(beside: Path) -> None:
    again = f"<PrivateAction>{JUMP}</PrivateAction><PrivateAction><LongitudinalAction><SpeedAction>"
    text = scenario().replace("<PrivateAction><LongitudinalAction><SpeedAction>", again, 1)
    found = driven(beside, text, 5)
    assert float(found.tracks[1].y[2]) == pytest.approx(-300.0, abs=5.0)


@pytest.mark.parametrize(
    ("time", "most", "exactly", "after"),
    [
        (0.0, UNBOUND, False, 20.0),
        (0.0, 5.0, False, 5.0),
        (0.0, 5.0, True, 20.0),
        (4.0, 5.0, False, 5.0),
        (NO_TIME, 5.0, True, 5.0),
    ],
)
def test_a_speed_of_a_profile_is_there_at_its_time_and_without_one_as_soon_as_may_be(
    time: float, most: float, exactly: bool, after: float
) -> None:
    who, world = SimpleNamespace(speed=0.0, bounds=Bounds()), SimpleNamespace(time=0.0)
    pace = pace_of(("profile", "", ((time, 20.0),), (UNBOUND, most, UNBOUND), exactly), who, world)  # type: ignore[arg-type]
    assert pace is not None
    assert pace.speed(1.0) == pytest.approx(after)


@pytest.mark.parametrize("times", [1, 3])
def test_a_group_happens_as_often_as_it_may(times: int, beside: Path) -> None:
    up = event(speed(9, 0.0, "step"), TIME.format(0.5), "up").replace('"rising"', '"none"')
    down = event(speed(3, 1.0), STATE.format("event", "up", "completeState"), "down")
    down = down.replace('"rising"', '"none"').replace('delay="0"', 'delay="0.5"')
    group = '<ManeuverGroup name="{}" maximumExecutionCount="1"><Actors><EntityRef entityRef="lead"/></Actors><Maneuver name="n">{}</Maneuver></ManeuverGroup>'
    text = scenario(events=up + down, more=group.format("later", event(DISTANCE, TIME.format(90), "later")))
    found = driven(beside, text.replace('maximumExecutionCount="1"', f'maximumExecutionCount="{times}"', 1), 79)
    track = found.tracks[1]
    ups = sum(float(now) - float(was) > 3.0 for was, now in zip(track.speed, track.speed[1:], strict=False))
    assert ups == times


def test_what_an_event_overwrites_leaves_off_where_it_is(beside: Path) -> None:
    over = event(JUMP, TIME.format(2), "jumps")
    found = driven(beside, scenario(events=event(speed(15, 2.0), TIME.format(1)) + over), 60)
    assert float(found.tracks[1].speed[55]) == pytest.approx(10.0, abs=0.1)


@pytest.mark.parametrize("for_good", [True, False])
def test_a_speed_beside_another_stays_once_it_is_reached_unless_it_is_for_good(for_good: bool) -> None:
    world = Bodies(a=(0.0, 0.0, EAST, 10.0), b=(50.0, 0.0, EAST, 12.0))
    who, other = world.entity("a"), world.entity("b")
    pace = pace_of(("speed", "linear", "time", 1.0, ("delta", "b", 0.0, for_good)), who, world)
    assert pace is not None
    who.speed = pace.speed(1.0)
    assert (who.speed, pace.done) == (pytest.approx(12.0), not for_good)
    other.speed = 20.0
    assert pace.speed(0.1) == pytest.approx(20.0 if for_good else 12.0)


def test_a_change_at_a_rate_keeps_its_rate_while_the_speed_that_is_meant_moves() -> None:
    world = Bodies(a=(0.0, 0.0, EAST, 10.0), b=(50.0, 0.0, EAST, 12.0))
    who = world.entity("a")
    pace = pace_of(("speed", "linear", "rate", 2.0, ("delta", "b", 0.0, False)), who, world)
    assert pace is not None
    for step in range(10):
        world.entity("b").speed = 13.0 + step
        who.speed = pace.speed(0.5)
    assert who.speed == pytest.approx(20.0)


@pytest.mark.parametrize(("faces", "at"), [((), 45.0), (((0.0, 0.0), (100.0, 0.0)), 45.0), (None, 55.0)])
def test_who_backs_goes_back_on_a_line_along_which_the_file_has_it_look(faces: Any, at: float) -> None:
    world = Bodies(a=(50.0, 0.0, EAST, -5.0))
    line = Polyline([(0.0, 0.0), (100.0, 0.0)])
    told = ("line", line, (), 50.0) if faces is None else ("line", line, (), 50.0, faces)
    way = way_of(told, world.entity("a"), world)
    assert way is not None
    x, _, heading = way.goes(-5.0, 1.0)
    assert x == pytest.approx(at)
    assert math.remainder(heading - (math.pi if faces is None else 0.0), math.tau) == pytest.approx(0.0)


def test_who_waits_on_a_timed_line_turns_by_the_times_that_are_told() -> None:
    world = Bodies(a=(0.0, 0.0, EAST, 0.0))
    table, faces = ((0.0, 0.0), (1.0, 10.0), (3.0, 10.0)), ((0.0, 0.0), (1.0, 0.0), (3.0, 4.0))
    way = way_of(("line", Polyline([(0.0, 0.0), (10.0, 0.0)]), (True, table), 0.0, faces), world.entity("a"), world)
    assert way is not None
    assert [way.goes(0.0, t)[2] for t in (1.0, 2.0, 3.0)] == pytest.approx([0.0, 2.0, 4.0])


@pytest.mark.parametrize(("heading", "left"), [(EAST, 3.0), (WEST, 1.0)])
def test_an_offset_from_somebody_is_to_the_left_of_that_one(heading: float, left: float) -> None:
    world = Bodies(a=(0.0, 0.0, EAST, 10.0), b=(50.0, 2.0, heading, 10.0))
    way = way_of(("aside", "step", 0.0, ("of", "b", 1.0), False), world.entity("a"), world)
    assert way is not None
    assert way.goes(10.0, 1.0)[1] == pytest.approx(left)


@pytest.mark.parametrize(("axis", "faster"), [((), 10.0), (("longitudinal",), -10.0), (("lateral",), 20.0)])
def test_relative_speeds_are_seen_along_the_other_where_a_direction_is_asked(axis: Any, faster: float) -> None:
    world = Bodies(a=(0.0, 0.0, NORTH, 20.0), b=(50.0, 2.0, EAST, 10.0))
    asked = [truth_of(("faster", "any", ("a",), "greaterThan", faster + by, "b", *axis), world)() for by in (-0.1, 0.1)]
    assert asked == [True, False]


THING = '<MiscObject name="m" miscObjectCategory="obstacle"><BoundingBox><Center x="0" y="0" z="0.5"/><Dimensions width="0.5" length="1.5" height="1"/></BoundingBox></MiscObject>'


def test_a_thing_goes_where_the_file_moves_it(beside: Path) -> None:
    text = scenario(events=event(LONG, TIME.format(1)), body=THING)
    track = driven(beside, text, 40).tracks[1]
    assert float(track.y[39]) == pytest.approx(-345.0 + 5.0 * 2.9, abs=0.6)
    assert (track.length, track.width) == (1.5, 0.5)


FREE = 1e3


@pytest.mark.parametrize(
    ("bounds", "after"), [((FREE, FREE, FREE), 3.0), ((0.5, FREE, FREE), 0.5), ((FREE, 2.0, FREE), 0.7)]
)
def test_who_goes_beside_somebody_goes_over_as_fast_as_its_bounds_let_it(bounds: Any, after: float) -> None:
    world = Bodies(a=(0.0, 0.0, EAST, 10.0), b=(0.0, 0.0, EAST, 10.0))
    way = way_of(("beside", "b", 3.0, 1.0, False, True, bounds), world.entity("a"), world)
    assert way is not None
    ys = [way.goes(0.1, 0.01)[1] for _ in range(1200)]
    assert ys[99] == pytest.approx(after, abs=0.1)
    assert max(ys) == pytest.approx(3.0, abs=0.01)
    assert not way.done


@pytest.mark.parametrize(("heading", "left"), [(EAST, 3.0), (WEST, -3.0)])
def test_the_left_of_somebody_is_to_the_left_as_that_one_faces(heading: float, left: float) -> None:
    world = Bodies(a=(0.0, 0.0, EAST, 10.0), b=(0.0, 0.0, heading, 10.0))
    way = way_of(("beside", "b", 3.0, 1.0, False, False), world.entity("a"), world)
    assert way is not None
    assert way.goes(1.0, 0.1)[1] == pytest.approx(left)


@pytest.mark.parametrize("turn", ["", '<Orientation type="relative" h="3.14159"/>'])
def test_who_begins_behind_somebody_who_faces_against_its_lane_begins_behind_as_that_one_faces(
    turn: str, beside: Path
) -> None:
    behind = '<RelativeLanePosition entityRef="ego" dLane="0" ds="-10">{}</RelativeLanePosition>'
    text = scenario(place=behind.format(turn), events=event(LONG, TIME.format(90)))
    text = text.replace('y="-374.0" h="1.570796"', 'y="-300.0" h="-1.570796"')
    ego, other = story(beside, text).members[:2]
    assert other.y - other.ahead * math.sin(other.heading) == pytest.approx(-290.0, abs=0.1)
    assert math.cos(other.heading - ego.heading) == pytest.approx(1.0, abs=1e-3)


def test_a_barrier_is_as_long_as_its_file_says(beside: Path) -> None:
    barrier = THING.replace('length="1.5"', 'length="200"')
    other = story(beside, scenario(body=barrier, events=event(LONG, TIME.format(1)))).members[1]
    assert other.length == 200.0


@pytest.mark.parametrize(("frame", "holds"), [("world", False), ("road", False), ("lane", True)])
def test_a_heading_is_asked_on_the_map_to_the_road_or_to_the_lane(frame: str, holds: bool, beside: Path) -> None:
    angle = f'<ByEntityCondition><TriggeringEntities triggeringEntitiesRule="any"><EntityRef entityRef="lead"/></TriggeringEntities><EntityCondition><AngleCondition angleType="heading" angle="0" angleTolerance="0.1" coordinateSystem="{frame}"/></EntityCondition></ByEntityCondition>'
    place = '<WorldPosition x="133.25" y="-345" h="-1.570796"/>'  # in the lane that runs against the road
    text = stopped_by(angle, scenario(place=place, events=event(DISTANCE, TIME.format(90))))
    assert (str(driven(beside, text, 20).ending) == "scenario-done") is holds


TRIGGERED = '<ByEntityCondition><TriggeringEntities triggeringEntitiesRule="{}">{}</TriggeringEntities><EntityCondition><TraveledDistanceCondition value="5"/></EntityCondition></ByEntityCondition>'
LEAD, EGO = '<EntityRef entityRef="lead"/>', '<EntityRef entityRef="ego"/>'


def selecting(rule: str, who: str) -> str:
    """A scenario in which those who trigger it keep a distance."""
    text = scenario(events=event(DISTANCE, TRIGGERED.format(rule, who)))
    return text.replace(f'selectTriggeringEntities="false">{LEAD}', 'selectTriggeringEntities="true">')


def test_those_act_who_trigger_it_where_the_file_selects_them(beside: Path) -> None:
    acts: Any = story(beside, selecting("any", LEAD)).acts
    assert acts[0][3][0][2] == ("lead",)
    with pytest.raises(ScenarioError, match="those of several who trigger it"):
        read(beside, selecting("any", LEAD + EGO))
