# ruff: noqa: E501 - elements stand in one line each
"""What a plan cannot say as the file does becomes a story: both drive the same."""

from __future__ import annotations

from pathlib import Path

import pytest

from chatscene.imports.openscenario import ScenarioFile
from chatscene.imports.written_story import StoryProgram
from chatscene.terms.storyboard import Storyboard
from straight import CAR, event, group, lane, of, read, scenario, speed, time, trigger, written

ENTITIES = {name: f'<ScenarioObject name="{name}">{CAR.format("")}</ScenarioObject>' for name in ("ego", "A")}


def travelled(metres: float) -> str:
    return of("A", f'<TraveledDistanceCondition value="{metres}"/>')


def near(metres: float, **more: str) -> str:
    told = " ".join(f'{name}="{what}"' for name, what in more.items())
    return of("A", f'<RelativeDistanceCondition entityRef="ego" rule="lessThan" value="{metres}" {told}/>')


def state(name: str, kind: str = "event") -> str:
    asked = f'storyboardElementType="{kind}" storyboardElementRef="{name}" state="completeState"'
    return f"<ByValueCondition><StoryboardElementStateCondition {asked}/></ByValueCondition>"


def to_collision(seconds: float) -> str:
    target = '<TimeToCollisionConditionTarget><EntityRef entityRef="A"/></TimeToCollisionConditionTarget>'
    told = f'freespace="false" rule="lessThan" value="{seconds}"'
    return of("ego", f"<TimeToCollisionCondition {told}>{target}</TimeToCollisionCondition>")


def to_place(freespace: str) -> str:
    place = f"<Position>{lane(150)}</Position>"
    return of(
        "ego", f'<DistanceCondition freespace="{freespace}" rule="lessThan" value="10">{place}</DistanceCondition>'
    )


GOES, STOPS = speed(20), speed(0)
LONGITUDINAL = {"relativeDistanceType": "longitudinal", "coordinateSystem": "road"}


@pytest.mark.parametrize(
    "text",
    [
        scenario(group("A", event("one", STOPS, time(5)), event("two", GOES, time(2)))),
        scenario(group("A", event("one", GOES, time(6)), event("two", speed(3), travelled(20)))),
        scenario(group("A", event("one", speed(3), time(4))), stops=trigger(time(2), tag="StopTrigger")),
        scenario(group("A", event("one", STOPS, time(1)), event("two", GOES, state("one")), times=3)),
        scenario(group("A", event("one", STOPS, of("A", '<SpeedCondition rule="greaterThan" value="5"/>'), edge="rising"))),
        scenario(group("A", event("one", GOES, time(1)), event("two", STOPS, state("one"), near(30, freespace="false", **LONGITUDINAL), edge="rising"))),
        scenario(group("A", event("one", STOPS, to_place("true")))),
        scenario(group("A", event("one", STOPS, to_place("1")))),
        scenario(group("A", event("one", STOPS, of("A", '<StandStillCondition duration="1"/>')))),
        scenario(group("A", event("one", STOPS, to_collision(2)))),
        scenario(group("A", event("one", STOPS, of("A", '<SpeedCondition rule="equalTo" value="5"/>')))),
        scenario(group("A", event("one", GOES, time(1)), event("two", STOPS, state("three"), time(2)))),
    ],
    ids=[
        "not in order", "not one after the other", "stopped", "several times", "an edge that does not rise",
        "an edge after an event", "freespace", "freespace as 1", "a stand", "a leader", "equal", "another event",
    ],
)  # fmt: skip
def test_what_a_plan_cannot_say_is_a_story(text: str, tmp_path: Path) -> None:
    assert isinstance(read(tmp_path, text).board, StoryProgram)


@pytest.mark.parametrize(
    "text",
    [
        scenario(group("A", event("one", GOES, time(2)), event("two", STOPS, time(5)))),
        scenario(group("A", event("one", GOES, time(2)), event("two", STOPS, state("one"), edge="rising"))),
        scenario(group("A", event("one", STOPS, near(40, **LONGITUDINAL), edge="rising"))),
        scenario(group("A", event("one", STOPS, near(40, freespace="1", **LONGITUDINAL)))),
    ],
    ids=["in order", "after the one before", "an edge that rises", "freespace along the road"],
)
def test_what_a_plan_can_say_is_one(text: str, tmp_path: Path) -> None:
    assert isinstance(read(tmp_path, text).board, Storyboard)


def plan(folder: Path, text: str) -> str:
    board = read(folder, text).board
    assert isinstance(board, Storyboard)
    (found,) = [one.plan for one in board.actors if one.plan is not None]
    return str(found)


def test_a_time_of_an_act_and_one_of_its_event_are_of_one_clock(tmp_path: Path) -> None:
    text = scenario(group("A", event("one", STOPS, time(5))), begins=trigger(time(2)))
    whole = scenario(group("A", event("one", STOPS, time(5))))
    said = plan(tmp_path, text)
    assert "After(seconds=Number(value=2.0))" in said
    assert "After(seconds=Number(value=3.0))" in said
    assert "After(seconds=Number(value=5.0))" in plan(tmp_path, whole)


def test_free_space_written_as_1_is_that_of_both_bodies(tmp_path: Path) -> None:
    texts = [
        scenario(group("A", event("one", STOPS, near(30, freespace=as_, **LONGITUDINAL)))) for as_ in ("1", "true")
    ]
    one, other = (plan(tmp_path, text) for text in texts)
    assert one == other
    assert "length" in one


def test_who_begins_faster_than_its_kind_goes_is_a_story_in_which_it_goes_as_fast_as_it_can(tmp_path: Path) -> None:
    body = '<Pedestrian name="p" pedestrianCategory="pedestrian"><BoundingBox><Center x="0" y="0" z="0.9"/><Dimensions width="0.6" length="0.6" height="1.8"/></BoundingBox></Pedestrian>'
    names = f'{ENTITIES["ego"]}<ScenarioObject name="A">{body}</ScenarioObject>'
    found = read(tmp_path, scenario(group("A", event("one", STOPS, time(5))), entities=names))
    assert isinstance(found.board, StoryProgram)
    assert any("goes at 8 m/s at most, where it says 10 m/s" in note for note in found.notes)


RANGE = "<ParameterDeclarations>{}</ParameterDeclarations>"
VARIES = '<ParameterDeclaration name="{}" parameterType="{}" value="{}"><ConstraintGroup>{}</ConstraintGroup></ParameterDeclaration>'


def varying(name: str, value: object, *bounds: tuple[str, float], kind: str = "double") -> str:
    inner = "".join(f'<ValueConstraint rule="{rule}" value="{at}"/>' for rule, at in bounds)
    return VARIES.format(name, kind, value, inner)


def within(low: float, high: float) -> tuple[tuple[str, float], ...]:
    return ("greaterOrEqual", low), ("lessOrEqual", high)


def test_parameters_whose_names_are_alike_vary_each_for_itself(tmp_path: Path) -> None:
    both = RANGE.format(varying("v", 5, *within(2, 8)) + varying("V", 15, *within(12, 18)))
    events = event("one", speed("$v"), time(1)), event("two", speed("$V"), time(3))
    board = read(tmp_path, scenario(group("A", *events), before=both)).board
    assert isinstance(board, Storyboard)
    assert {(one.low, one.high) for one in board.parameters} == {(2, 8), (12, 18)}
    assert len({one.name for one in board.parameters}) == 2


def test_the_strictest_bounds_of_a_parameter_hold(tmp_path: Path) -> None:
    told = RANGE.format(varying("v", 5, ("greaterOrEqual", 4), ("greaterOrEqual", 2), ("lessOrEqual", 10)))
    board = read(tmp_path, scenario(group("A", event("one", speed("$v"), time(1))), before=told)).board
    assert [(one.low, one.high) for one in board.parameters] == [(4, 10)]


def test_that_a_whole_number_varies_among_all_numbers_is_told(tmp_path: Path) -> None:
    told = RANGE.format(varying("v", 5, *within(2, 8), kind="int"))
    notes = read(tmp_path, scenario(group("A", event("one", speed("$v"), time(1))), before=told)).notes
    assert any("$v is of the type int, and varies here among all numbers" in note for note in notes)


def test_constraints_hold_of_a_parameter_that_is_made_of_another(tmp_path: Path) -> None:
    from chatscene.errors import ScenarioError

    told = varying("v", "$w", *within(2, 8)) + '<ParameterDeclaration name="w" parameterType="double" value="30"/>'
    text = scenario(group("A", event("one", speed("$v"), time(1))), before=RANGE.format(told))
    with pytest.raises(ScenarioError, match=r"line \d+: <ParameterDeclaration>: 30 is not within 2 to 8"):
        read(tmp_path, text)


def test_that_a_value_from_outside_is_beyond_its_constraints_is_told(tmp_path: Path) -> None:
    told = RANGE.format(varying("v", 5, *within(2, 8)))
    path = written(tmp_path, scenario(group("A", event("one", speed("$v"), time(1))), before=told))
    said = ScenarioFile(path).said({"v": "20"})
    assert any("$v is 20, and its constraints are 2 to 8" in note for note in said.notes)


def test_a_speed_that_may_be_below_nothing_is_no_plan(tmp_path: Path) -> None:
    told = RANGE.format(varying("v", 4, *within(-5, 13)))
    found = read(tmp_path, scenario(group("A", event("one", speed("$v"), time(1))), before=told))
    assert isinstance(found.board, StoryProgram)


def test_what_is_noted_of_a_plan_is_not_said_of_a_drive_as_written(tmp_path: Path) -> None:
    found = read(tmp_path, scenario(group("A", event("one", STOPS, time(5)))))
    ends = "a drive ends with a collision, at the end of the route or after 30 s"
    assert any(ends in note for note in found.notes)
    assert not any(ends in note for note in found.notes_as_written)
