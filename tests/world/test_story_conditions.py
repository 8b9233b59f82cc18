"""What a story measures at each step is held against what it measured at the step before, and no earlier one."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

from chatscene.world.story.conditions import truth_of
from chatscene.world.story.places import Place
from chatscene.world.story.player import Trigger


def story(**more: Any) -> Any:
    return SimpleNamespace(time=0.0, variables={}, **more)


def test_a_condition_that_is_asked_anew_does_not_take_what_it_missed_for_passed() -> None:
    told = story()
    trigger = Trigger([[("none", 0.0, "time", "equalTo", 5.0)]], told, empty=False)
    assert not trigger.holds()
    trigger.forgets()
    told.time = 9.0
    assert not trigger.holds()


def test_a_headway_is_not_passed_while_whom_it_is_to_is_behind() -> None:
    who: Any = SimpleNamespace(origin=(0.0, 0.0, 0.0), line=None, speed=10.0)
    there = ("at", 40.0, 0.0, 0.0)
    place = Place(lambda: (40.0, 0.0, 0.0), lambda: (0.0, 0.0))
    world = story(entity={"A": who}.get, place={there: place}.get)
    holds = truth_of(("headway", "any", ("A",), "equalTo", 2.0, there, "", "entity", False), world)
    seen: list[bool] = []
    for x in (0.0, 60.0, 30.0, 10.0):  # 4 s before it, behind it, 1 s before it, and 3 s
        who.origin = (x, 0.0, 0.0)
        seen.append(holds())
    assert seen == [False, False, False, True]
