# ruff: noqa: E501 - elements stand in one line each
"""What a file says of parameters, of Init and of lines comes to pass as it is written, or is refused or told."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import chatscene
from chatscene.errors import ScenarioError
from chatscene.terms.mirrored_scenario import mirrored_attributes
from chatscene.world.story.conditions import RULES
from straight import (  # fmt: skip
    CAR,
    declared,
    driven,
    event,
    first,
    group,
    lane,
    of,
    parameter,
    put,
    read,
    scenario,
    speed,
    time,
    told,
    written,
)

STANDS = event("stands", speed(0), time(5))
CATALOG = '<OpenSCENARIO><FileHeader revMajor="1" revMinor="2" date="2026-01-01T00:00:00" description="c" author="us"/><Catalog name="cars">{}</Catalog></OpenSCENARIO>'


# Parameters


@pytest.mark.parametrize(
    ("outer", "inner", "comes"),
    [({"v": 5}, {"v": 20}, 20), ({"base": 7}, {"v": "${$base*2}"}, 14), ({"v": 3}, {"v": "${$v+1}"}, 4), ({}, {"v": "${$w*2}", "w": 4}, 8), ({}, {"$v": 6}, 6)],
    ids=["shadowed", "made of an outer one", "made of the outer one of its name", "made of a later one", "with a $"],
)  # fmt: skip
def test_the_nearest_declaration_of_a_parameter_holds(
    outer: dict[str, object], inner: dict[str, object], comes: float, tmp_path: Path
) -> None:
    acts = group("A", event("goes", speed("$v"), time(1)), declared=declared(**inner))
    assert driven(tmp_path, scenario(acts, story=declared(**outer))).speed[20] == pytest.approx(comes)


def test_parameters_made_of_one_another_are_refused_with_their_line(tmp_path: Path) -> None:
    acts = group("A", event("goes", speed("$v"), time(1)), declared=declared(v="$w", w="$v"))
    with pytest.raises(ScenarioError, match=r"line \d+: <ParameterDeclarations>: \$\w is an expression of itself"):
        read(tmp_path, scenario(acts))


def car_of(folder: Path, entry: str, *assigned: tuple[str, object], before: str = "") -> str:
    """A scenario whose A is of a catalog with one entry, a body of `len` by `wid`."""
    body = f'<Vehicle name="v" vehicleCategory="car">{entry}<BoundingBox><Center x="1.4" y="0" z="0.7"/><Dimensions width="$wid" length="$len" height="1.5"/></BoundingBox></Vehicle>'
    (folder / "cars.xosc").write_text(CATALOG.format(body))
    given = "".join(f'<ParameterAssignment parameterRef="{name}" value="{value}"/>' for name, value in assigned)
    named = f'<CatalogReference catalogName="cars" entryName="v"><ParameterAssignments>{given}</ParameterAssignments></CatalogReference>'
    entities = (
        f'<ScenarioObject name="ego">{CAR.format("")}</ScenarioObject><ScenarioObject name="A">{named}</ScenarioObject>'
    )
    folders = '<VehicleCatalog><Directory path="."/></VehicleCatalog>'
    return scenario(group("A", STANDS), entities=entities, catalogs=folders, before=before)


def test_a_default_of_a_catalog_is_made_of_what_its_entry_is_given(tmp_path: Path) -> None:
    text = car_of(tmp_path, declared(len=4, wid="${$len/2}"), ("len", 6), before=declared(len=9))
    found = told(tmp_path, text)._episode.tracks[1]  # pyright: ignore[reportPrivateUsage]
    assert (found.length, found.width) == (6, 3)


def test_declarations_whose_values_are_too_long_together_are_refused(tmp_path: Path) -> None:
    long = {f"v{i}": "${$big+$big}" for i in range(4000)}
    acts = group("A", event("goes", speed("$v1"), time(1)), declared=declared(big="1" * 4500, **long))
    with pytest.raises(ScenarioError, match=r"<ParameterDeclarations>: its values are longer than \d+ MB"):
        read(tmp_path, scenario(acts))


def test_a_value_for_a_parameter_that_a_catalog_does_not_declare_is_told(tmp_path: Path) -> None:
    notes = read(tmp_path, car_of(tmp_path, declared(len=4, wid=2), ("lenn", 6))).notes
    assert any("the entry 'v' declares no parameter 'lenn'; its value is left out" in one for one in notes)


def test_a_text_may_be_a_parameter_of_a_parameter(tmp_path: Path) -> None:
    names = declared(who="$other", other="A")
    assert driven(tmp_path, scenario(group("$who", event("goes", speed(3), time(1))), before=names)).speed[20] == 3


def test_a_parameter_whose_name_is_written_with_a_dollar_can_be_set(tmp_path: Path) -> None:
    text = scenario(group("A", event("goes", speed("$v"), time(1))), before=declared(**{"$v": 4}))
    found = chatscene.story(written(tmp_path, text), as_written=True, param={"v": 6})
    assert found._episode.tracks[1].speed[20] == 6  # pyright: ignore[reportPrivateUsage]


ADD = '<GlobalAction><ParameterAction parameterRef="n"><ModifyAction><Rule><AddValue value="1"/></Rule></ModifyAction></ParameterAction></GlobalAction>'


def test_a_parameter_that_changes_begins_at_the_value_of_its_expression(tmp_path: Path) -> None:
    acts = group("A", event("adds", ADD, time(1)), event("goes", speed(3), parameter("n", 3)))
    assert driven(tmp_path, scenario(acts, before=declared(n="${1+1}"))).speed[20] == 3


def test_to_add_to_a_text_is_refused_with_its_line(tmp_path: Path) -> None:
    acts = group("A", event("adds", ADD, time(1)), event("goes", speed(3), parameter("n", 3)))
    with pytest.raises(ScenarioError, match=r"line \d+: <AddValue>: 'n' is not a number all along"):
        read(tmp_path, scenario(acts, before=declared(n="red")))


# Init


@pytest.mark.parametrize("kind", ["Parameter", "Variable"])
def test_what_init_sets_holds_from_the_beginning(kind: str, tmp_path: Path) -> None:
    sets = f'<GlobalAction><{kind}Action {kind.lower()}Ref="go"><SetAction value="1"/></{kind}Action></GlobalAction>'
    usual = first("ego", put(lane(50)), speed(10)) + first("A", put(lane(100)), speed(10))
    acts = group("A", event("goes", speed(3), parameter("go", 1, kind=kind)))
    found = driven(tmp_path, scenario(acts, inits=sets + usual, before=declared(kind, go=0)))
    assert found.speed[3] == 3


@pytest.mark.parametrize(
    ("action", "says"),
    [
        (
            '<UserDefinedAction><CustomCommandAction type="x">y</CustomCommandAction></UserDefinedAction>',
            "a command to another program is left out",
        ),
        ('<GlobalAction><SetMonitorAction monitorRef="m" value="true"/></GlobalAction>', "there are no monitors here"),
    ],
    ids=["command", "monitor"],
)
def test_what_init_has_that_nothing_here_does_is_told(action: str, says: str, tmp_path: Path) -> None:
    usual = first("ego", put(lane(50)), speed(10)) + first("A", put(lane(100)), speed(10))
    notes = read(tmp_path, scenario(group("A", STANDS), inits=usual + action)).notes
    assert any(says in one for one in notes)


def test_all_of_a_selection_do_what_it_does_in_init(tmp_path: Path) -> None:
    names = "".join(f'<ScenarioObject name="{name}">{CAR.format("")}</ScenarioObject>' for name in ("ego", "A", "B"))
    both = '<EntitySelection name="both"><Members><EntityRef entityRef="A"/><EntityRef entityRef="B"/></Members></EntitySelection>'
    inits = first("ego", put(lane(50)), speed(10)) + first("A", put(lane(100))) + first("B", put(lane(150)))
    text = scenario(group("A", STANDS), inits=inits + first("both", speed(10)), entities=names + both)
    tracks = told(tmp_path, text)._episode.tracks  # pyright: ignore[reportPrivateUsage]
    assert [one.speed[5] for one in tracks] == [10, 10, 10]


def test_a_name_in_init_that_nobody_has_is_refused(tmp_path: Path) -> None:
    inits = first("ego", put(lane(50)), speed(10)) + first("nobody", put(lane(100)), speed(10))
    with pytest.raises(ScenarioError, match=r"line \d+: <Private>: there is no entity 'nobody'"):
        read(tmp_path, scenario(group("A", STANDS), inits=inits))


def test_an_ego_that_is_told_to_stand_stands(tmp_path: Path) -> None:
    inits = first("ego", put(lane(50)), speed(0)) + first("A", put(lane(100)), speed(10))
    found = told(tmp_path, scenario(group("A", STANDS), inits=inits))
    assert found._episode.ego_track.speed.max() == 0  # pyright: ignore[reportPrivateUsage]


def test_what_bounds_somebody_may_be_endless(tmp_path: Path) -> None:
    endless = CAR.format('<Performance maxSpeed="70" maxAcceleration="INF" maxDeceleration="INF"/>')
    names = f'<ScenarioObject name="ego">{CAR.format("")}</ScenarioObject><ScenarioObject name="A">{endless}</ScenarioObject>'
    slows = event("slows", speed(0, "linear", "time", 1.0), time(1))
    assert driven(tmp_path, scenario(group("A", slows), entities=names)).speed[21] == 0


@pytest.mark.parametrize("sight", ["INF", "1e7"])
def test_who_sees_for_ever_sees_no_fog(sight: str, tmp_path: Path) -> None:
    weather = f'<Weather cloudState="free"><Fog visualRange="{sight}"/></Weather>'
    around = f'<GlobalAction><EnvironmentAction><Environment name="e">{weather}</Environment></EnvironmentAction></GlobalAction>'
    usual = first("ego", put(lane(50)), speed(10)) + first("A", put(lane(100)), speed(10))
    board = read(tmp_path, scenario(group("A", STANDS), inits=around + usual)).board
    assert str(board.surroundings) == ""


def test_who_is_refused_is_not_said_to_be_absent_as_well(tmp_path: Path) -> None:
    zeppelin = CAR.format("").replace('"car"', '"zeppelin"')
    names = f'<ScenarioObject name="ego">{CAR.format("")}</ScenarioObject><ScenarioObject name="A">{zeppelin}</ScenarioObject>'
    with pytest.raises(ScenarioError) as found:
        read(tmp_path, scenario(group("A", STANDS), entities=names))
    assert "no road user is known as 'zeppelin'" in str(found.value)
    assert "there is no 'A'" not in str(found.value)


# What is done


def profile(*speeds: float, **limits: float) -> str:
    bounds = " ".join(f'{name}="{value}"' for name, value in limits.items())
    entries = "".join(f'<SpeedProfileEntry speed="{one}"/>' for one in speeds)
    return f'<LongitudinalAction><SpeedProfileAction followingMode="follow"><DynamicConstraints {bounds}/>{entries}</SpeedProfileAction></LongitudinalAction>'


@pytest.mark.parametrize(
    ("does", "body", "comes"),
    [(profile(0, maxAcceleration=1, maxDeceleration=5), "", 5), (profile(20, maxAcceleration=2, maxDeceleration=5), "", 12), (profile(20, maxAcceleration=20, maxSpeed=15), "", 15), (profile(0, maxAcceleration=9, maxDeceleration=9), '<Performance maxSpeed="70" maxAcceleration="4" maxDeceleration="4"/>', 6)],
    ids=["slower", "faster", "top", "body"],
)  # fmt: skip
def test_a_profile_of_speeds_keeps_to_its_own_bounds_each_way_and_to_those_of_the_body(
    does: str, body: str, comes: float, tmp_path: Path
) -> None:
    names = f'<ScenarioObject name="ego">{CAR.format("")}</ScenarioObject><ScenarioObject name="A">{CAR.format(body)}</ScenarioObject>'
    found = driven(tmp_path, scenario(group("A", event("goes", does, time(1))), entities=names))
    assert found.speed[20] == pytest.approx(comes, abs=0.02)


def test_how_fast_an_acceleration_changes_is_told_not_to_be_bounded(tmp_path: Path) -> None:
    does = event("goes", profile(0, maxDeceleration=5, maxDecelerationRate=1), time(1))
    assert any("its maxDecelerationRate is left out" in one for one in read(tmp_path, scenario(group("A", does))).notes)


def line(*vertices: tuple[float, float, float | None], closed: bool = False, timed: bool = False) -> str:
    """A line that is followed, of x, y and times."""
    told = "".join(
        f'<Vertex{"" if at is None else f""" time="{at}" """}><Position><WorldPosition x="{x}" y="{y}"/></Position></Vertex>'
        for x, y, at in vertices
    )
    times = '<Timing domainAbsoluteRelative="relative" scale="1" offset="0"/>' if timed else "<None/>"
    return f'<RoutingAction><FollowTrajectoryAction><TrajectoryRef><Trajectory name="t" closed="{str(closed).lower()}"><Shape><Polyline>{told}</Polyline></Shape></Trajectory></TrajectoryRef><TimeReference>{times}</TimeReference><TrajectoryFollowingMode followingMode="position"/></FollowTrajectoryAction></RoutingAction>'


SQUARE = ((120.0, -1.75, None), (140.0, -1.75, None), (140.0, -21.75, None), (120.0, -21.75, None))


def test_a_closed_line_is_gone_round_again_and_again(tmp_path: Path) -> None:
    found = driven(tmp_path, scenario(group("A", event("goes", line(*SQUARE, closed=True), time(1))), lasts=19))
    a_round = round(80 / found.speed[20] / 0.1)
    for at in (20, 40, 60):
        here, later = [(found.x[i], found.y[i]) for i in (at, at + a_round)]
        assert math.dist(here, later) < 0.2


def test_a_closed_route_is_told_to_be_followed_once(tmp_path: Path) -> None:
    points = "".join(f'<Waypoint routeStrategy="shortest"><Position>{lane(s)}</Position></Waypoint>' for s in (100, 300))  # fmt: skip
    route = f'<RoutingAction><AssignRouteAction><Route name="r" closed="true">{points}</Route></AssignRouteAction></RoutingAction>'
    notes = read(tmp_path, scenario(group("A", event("goes", route, time(1))))).notes
    assert any("it is closed; it is followed to its last waypoint" in one for one in notes)


def test_a_line_of_which_some_times_are_missing_is_refused(tmp_path: Path) -> None:
    does = line((101, -1.75, 0), (121, -1.75, None), (141, -1.75, 20), timed=True)
    with pytest.raises(ScenarioError, match=r"line \d+: <Trajectory>: some of its times are missing"):
        read(tmp_path, scenario(group("A", event("goes", does, time(1)))))


# Conditions


def to_place(x: float, y: float, rule: str, value: float, **more: str) -> str:
    told = " ".join(f'{name}="{what}"' for name, what in more.items())
    return of("A", f'<DistanceCondition freespace="true" rule="{rule}" value="{value}" {told}><Position><WorldPosition x="{x}" y="{y}"/></Position></DistanceCondition>')  # fmt: skip


LATERAL = {"coordinateSystem": "road", "relativeDistanceType": "lateral"}


@pytest.mark.parametrize(
    ("condition", "holds"),
    [
        (to_place(150, -4.75, "lessThan", 1.5), None),  # 2 m beside who is 2 m wide and drives by
        (to_place(150, -4.75, "lessThan", 2.05), 147.3),
        (to_place(150, -3.75, "lessThan", 1.2, **LATERAL), 101.4),
        (to_place(101.4, -1.75, "greaterThan", 10), 101.4 + 10 + 2.25),
    ],
    ids=["beside", "nearer", "lateral", "behind"],
)
def test_the_free_space_to_a_place_is_that_of_the_outline(condition: str, holds: float | None, tmp_path: Path) -> None:
    found = driven(tmp_path, scenario(group("A", event("stands", speed(0), condition))))
    assert found.x[-1] == pytest.approx(holds, abs=0.5) if holds else found.speed[-1] == 10


@pytest.mark.parametrize("value", [2.3, 2.35, 0.1, 0.7])
def test_a_time_that_is_to_be_equal_comes(value: float, tmp_path: Path) -> None:
    found = driven(tmp_path, scenario(group("A", event("stands", speed(0), time(value, "equalTo"))), lasts=4))
    assert found.x[-1] == pytest.approx(101.4 + 10 * value, abs=0.05)


def test_a_speed_that_is_to_be_equal_is_passed(tmp_path: Path) -> None:
    slows = event("slows", speed(0, "linear", "rate", 3), time(1))
    equal = of("A", '<SpeedCondition rule="equalTo" value="5"/>')
    found = driven(tmp_path, scenario(group("A", slows, event("goes", speed(5), equal))))
    assert found.speed[-1] == 5


# Places beside somebody, and left-hand traffic


EAST_AND_SOUTH = ((100.0, -1.75, None), (140.0, -1.75, None), (140.0, -101.75, None))


@pytest.mark.parametrize(
    ("place", "x", "y", "heading"),
    [
        (
            '<RelativeWorldPosition entityRef="ego" dx="20" dy="0"><Orientation type="absolute" h="0"/></RelativeWorldPosition>',
            20,
            0,
            0,
        ),
        ('<RelativeWorldPosition entityRef="ego" dx="20" dy="0"/>', 20, 0, -math.pi / 2),
        (
            '<RelativeObjectPosition entityRef="ego" dx="20" dy="0"><Orientation type="absolute" h="0"/></RelativeObjectPosition>',
            0,
            -20,
            0,
        ),
        ('<RelativeObjectPosition entityRef="ego" dx="20" dy="0"/>', 0, -20, -math.pi / 2),
    ],
    ids=["world, absolute", "world", "object, absolute", "object"],
)
def test_a_place_beside_somebody_turns_as_its_kind_says(
    place: str, x: float, y: float, heading: float, tmp_path: Path
) -> None:
    acts = group("ego", event("turns", line(*EAST_AND_SOUTH), time(0))), group("A", event("jumps", put(place), time(7)))
    inits = first("ego", put(lane(50)), speed(10)) + first("A", put(lane(500)), speed(10))
    ego, other = told(tmp_path, scenario(*acts, inits=inits))._episode.tracks  # pyright: ignore[reportPrivateUsage]
    at, ahead = 71, 1.4
    assert ego.heading[at] == pytest.approx(-math.pi / 2, abs=0.01)
    assert math.remainder(other.heading[at] - heading, math.tau) == pytest.approx(0, abs=0.01)
    theirs, ours = (
        (one.x[at] - ahead * math.cos(one.heading[at]), one.y[at] - ahead * math.sin(one.heading[at]))
        for one in (ego, other)
    )
    assert (ours[0] - theirs[0], ours[1] - theirs[1]) == pytest.approx((x, y), abs=1.2)


@pytest.mark.parametrize("rule", ["lessThan", "greaterThan", "lessOrEqual", "equalTo"])
def test_a_speed_to_the_left_is_one_to_the_right_in_the_mirror(rule: str) -> None:
    asked = {"rule": rule, "value": "0.5", "direction": "lateral", "entityRef": "ego"}
    twice = mirrored_attributes("RelativeSpeedCondition", mirrored_attributes("RelativeSpeedCondition", asked))
    assert twice == asked
    once = mirrored_attributes("RelativeSpeedCondition", asked)
    assert once["value"] == "-0.5"
    assert RULES[rule](0.7, 0.5) == RULES[once["rule"]](-0.7, -0.5)
    assert mirrored_attributes("RelativeSpeedCondition", asked | {"direction": "longitudinal"})["value"] == "0.5"


# What is told of a drive


def test_a_drive_as_written_tells_its_own_notes_and_of_no_variants(tmp_path: Path) -> None:
    text = scenario(group("A", event("stands", speed(0), time(1))), lasts=2)
    as_plan, as_story = ("\n".join(told(tmp_path, text, as_written=as_).notes) for as_ in (False, True))
    ends = "a drive ends with a collision, at the end of the route or after 30 s"
    assert (ends in as_plan, ends in as_story) == (True, False)
    assert "variant" not in as_plan + as_story
