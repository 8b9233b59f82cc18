"""The table of acts is the only place that says what holds of one, beside its test on tracks."""

from __future__ import annotations

import ast
import pickle

import pytest

from chatscene.program.deeds import ACTIONS
from chatscene.terms.acts import TURNS, Action, reordered
from listed import members
from places import ROOT

SOURCE = ROOT / "src" / "chatscene"
ELSEWHERE = {
    "program/deeds.py": "a test on tracks for each",
    "interpret/situation_rows.py": "which act of a situation each of these is",
    "interpret/situation_of.py": "where somebody starts by what it does, and acts that say how another is done",
    "interpret/slots_of.py": "which of these each act of a situation is, for an edit",
    "interpret/stated.py": "acts that another one may have in it",
    "library/plan_check.py": "acts that a plan shows before it is driven",
}

every_act = pytest.mark.parametrize("action", Action)


def listed(source: str) -> list[int]:
    """The lines of a Python file where a list, a set or a table has more than one act in it."""
    return [line for line, _ in members(source, ("Action", "A"))]


def test_no_other_file_lists_acts() -> None:
    found = {
        str(path.relative_to(SOURCE)): lines for path in SOURCE.rglob("*.py") if (lines := listed(path.read_text()))
    }
    assert set(found) == set(ELSEWHERE), found


@pytest.mark.parametrize(
    "source",
    ["X = {Action.STOP: 1, Action.FAST: 2}", "x in (Action.STOP, Action.FAST)", "{'a': (Action.STOP, Action.FAST)}"],
)
def test_a_list_of_acts_is_recognised_as_one(source: str) -> None:
    assert set(listed(source)) == {1}
    assert not listed("f(Action.STOP, Action.FAST); x = [Action.STOP, Action.STOP]")


@every_act
def test_an_act_has_one_test_on_tracks(action: Action) -> None:
    tree = ast.parse((SOURCE / "program" / "deeds.py").read_text())
    assert [
        key
        for node in ast.walk(tree)
        if isinstance(node, ast.Dict)
        for key in node.keys
        if getattr(key, "attr", "") == action.name
    ]
    assert callable(ACTIONS[action])


@every_act
def test_an_act_says_what_is_seen(action: Action) -> None:
    assert action.row.meaning


@every_act
def test_opposites_are_each_other_s(action: Action) -> None:
    assert action.opposite is None or action.opposite.opposite is action is not action.opposite


@every_act
def test_an_act_survives_being_copied_and_written_down(action: Action) -> None:
    assert Action(str(action)) is action is pickle.loads(pickle.dumps(action))


def test_what_lasts_has_no_place_in_the_order_of_acts() -> None:
    assert reordered((Action.BRAKE, Action.CROSS), (Action.CROSS, Action.BRAKE))
    lasting = [action for action in Action if action.row.all_along]
    assert lasting
    assert not any(reordered((action, Action.CROSS), (Action.CROSS, action)) for action in lasting)


def test_the_right_is_the_other_side() -> None:
    assert TURNS == {Action.TURN_LEFT: 1, Action.TURN_RIGHT: -1}
