"""A name that nothing defines is read as the one thing that can be meant, or refused with what it could be."""

import pytest

from chatscene.parsing import parse_string
from chatscene.simulate.confined.undefined import Undefined, undefined_in, with_meanings

ADV = "behavior B():\n    {}\n"
WAY = "advPath = [m.startLane, m.connectingLane]\n"
PLACED = "ego = new Car\nLead = new Car ahead of ego by 20\nAdv = new Car left of ego by 3, with behavior B()\n"


def missing(does: str, placed: str = PLACED, more: str = "") -> list[Undefined]:
    return list(undefined_in(parse_string(ADV.format(does) + more + placed)))


@pytest.mark.parametrize(
    ("does", "means"),
    [
        ("take SetSpeedAction(leading.speed)", "Lead"),
        ("do FollowLaneBehavior() until (distance to target) < 3", "Lead"),
        ("do CrossingBehavior(somebody, 3, 10)", "Lead"),
        ("do FollowTrajectoryBehavior(5, way)", "lanesAhead(self)"),
        ("do FollowTrajectoryBehavior(trajectory=way)", "lanesAhead(self)"),
        ("do FollowLaneBehavior() until (distance from self to egoTrajectory) < 3", "lanesAhead(ego)"),
        ("do FollowTrajectoryBehavior(5, leadTrajectory)", "lanesAhead(Lead)"),
        ("take SetSpeedAction(lead.speed)", "Lead"),
    ],
)
def test_a_name_is_read_as_the_one_thing_that_is_wanted_there(does: str, means: str) -> None:
    (one,) = missing(does)
    assert one.means is not None
    assert one.means[0] == means


def test_a_way_that_the_program_has_for_somebody_is_taken_before_the_lanes_ahead() -> None:
    (one,) = missing("do FollowTrajectoryBehavior(5, advTrajectory)", more=f"m = 4\n{WAY}")
    assert one.means is not None
    assert one.means[0] == "advPath"


def test_what_is_wanted_of_a_parameter_is_what_is_wanted_where_it_is_read() -> None:
    placed = PLACED.replace("B()", "B(way)")
    program = "behavior B(t):\n    do FollowTrajectoryBehavior(5, t)\n" + placed
    (one,) = undefined_in(parse_string(program))
    assert one.means is None  # it is read where Adv is made, who is not there yet
    assert "lanesAhead(Adv)" in one.candidates


def test_who_is_done_by_another_behavior_belongs_to_who_has_that_one() -> None:
    placed = PLACED.replace("B()", "Whole()")
    (one,) = missing("do FollowTrajectoryBehavior(5, way)", placed, "behavior Whole():\n    do B()\n")
    assert one.means is not None
    assert one.means[0] == "lanesAhead(self)"


def test_one_of_several_is_not_chosen_and_all_are_listed() -> None:
    (one,) = missing("take SetSpeedAction(leading.speed)", PLACED + "Other = new Truck behind ego by 20\n")
    assert one.means is None
    assert one.hint() == "; it could be Lead or Other; --param leading=EXPRESSION says what it is"


@pytest.mark.parametrize("does", ["take SetSpeedAction(fast)", "x = lanes.centerline", "take SetSpeedAction(b + 1)"])
def test_a_name_of_which_nothing_is_known_has_no_meaning(does: str) -> None:
    (one,) = missing(does)
    assert one.means is None
    assert one.candidates == ()


def test_a_name_that_is_defined_somewhere_or_by_the_world_model_is_not_missing() -> None:
    assert missing("x = FollowLaneBehavior\n    take SetSpeedAction(later + x)", more="later = 4\n") == []


def test_what_is_assumed_stands_in_the_text_before_it_is_read() -> None:
    program = ADV.format("take SetSpeedAction(leading.speed)") + PLACED
    text, told = with_meanings(program, undefined_in(parse_string(program)), {})
    assert text.splitlines()[1] == "    leading = Lead  #: assumed, as nothing defines it: Lead"
    assert told[0].startswith("line 2: nothing defines `leading`; assumed to be Lead, since ")
    assert undefined_in(parse_string(text)) == ()


def test_what_its_user_says_comes_before_what_is_assumed() -> None:
    program = ADV.format("take SetSpeedAction(leading.speed)") + PLACED + "require leading.speed < 4\n"
    text, told = with_meanings(program, undefined_in(parse_string(program)), {"leading": "ego"})
    assert "    leading = ego\n" in text
    assert "\nleading = ego\nrequire" in text
    assert told == ("line 2: nothing defines `leading`; it is `ego`, as you say",)
