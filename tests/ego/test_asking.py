# pyright: reportUnknownLambdaType=false
"""Whatever the code of an ego does, who asks it gets two finite numbers or is told which ego failed, when and where."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from chatscene.ego.asking import answer, begin, fitted, wanting
from chatscene.ego.policy import is_cut_off, load_ego
from chatscene.errors import EgoError
from chatscene.terms.actors import LIMITS
from chatscene.testing import ContractBroken, check_ego

SEEN = np.zeros(4)


class Own:
    """An ego of a user."""

    def __init__(self, gives: Any) -> None:
        self._gives = gives

    def act(self, observation: Any) -> Any:
        return self._gives


@pytest.mark.parametrize(
    "gives",
    [None, (0.1,), (0.1, 0.2, 0.3), np.zeros((1, 2)), ("0.3", "0.0"), (1j, 0), (float("inf"), 0.0), (10**400, 0), {}],
)
def test_what_is_not_two_finite_numbers_is_told_with_ego_step_scene_and_line(gives: Any) -> None:
    with pytest.raises(EgoError, match=r"the ego 'Own' fails at step 7 of scene 's': .*test_asking\.py, line \d+\)"):
        answer(Own(gives), SEEN, step=7, scene="s")


@pytest.mark.parametrize("gives", [(1, -1), np.array([1.0, -1.0], np.float32), [np.float64(1), -1.0]])
def test_two_numbers_of_any_kind_are_floats(gives: Any) -> None:
    action = answer(Own(gives), SEEN, step=0, scene="s")
    assert action == (1.0, -1.0)
    assert all(type(number) is float for number in action)
    assert not is_cut_off(action)


def _raises(*_: object) -> Any:
    raise LookupError("no table")


def test_an_ego_that_fails_as_it_is_told_a_speed_or_a_body_is_told_by_name() -> None:
    ego: Any = Own((0.0, 0.0))
    ego.wanting = _raises
    with pytest.raises(EgoError, match=r"'Own' fails as its wanting is called: LookupError: no table \(.*, line \d+\)"):
        wanting(ego, 8.0)
    ego.wanting = lambda _speed: None
    with pytest.raises(EgoError, match="gives NoneType, not an ego"):
        wanting(ego, 8.0)
    ego.driving = lambda _body: 3
    bus: Any = SimpleNamespace(wanted_speed=None, ego_kind="Bus", ego_limits=LIMITS["Bus"])
    with pytest.raises(EgoError, match="fails as its driving is called: that gives int"):
        fitted(ego, bus)


def test_an_ego_that_cannot_begin_is_told_by_name() -> None:
    with pytest.raises(EgoError, match="'SimpleNamespace' fails before scene 's': LookupError: no table"):
        begin(SimpleNamespace(reset=_raises, act=None), "s")  # type: ignore[arg-type] # pyright: ignore[reportArgumentType]


class Late(Own):
    """Fails after a while."""

    def __init__(self) -> None:
        super().__init__((0.0, 0.0))
        self._calls = 0

    def act(self, observation: Any) -> Any:
        self._calls += 1
        return (float("nan"), 0.0) if self._calls > 30 else self._gives


def _leaves() -> Any:
    raise SystemExit(3)


@pytest.mark.parametrize(
    ("ego", "rule"),
    [
        (Own(("0.3", "0.0")), "two finite numbers"),
        (Late, "two finite numbers.*at step 30"),
        (_leaves, "SystemExit: 3"),
        (SimpleNamespace(act=lambda _: (0.0, 0.0), reset=_raises), "an episode can begin; found: .*no table"),
        (SimpleNamespace(act=lambda _: (0.0, 0.0), wanting=lambda _: None), "makes an ego; found: .*wanting"),
        (SimpleNamespace(act=lambda _: (0.0, 0.0), driving=lambda _: Own(None)), "two finite numbers"),
        (SimpleNamespace(act=lambda _: _leaves()), "two finite numbers; found: .*SystemExit"),
    ],
)
def test_the_contract_finds_what_would_break_a_command(ego: Any, rule: str) -> None:
    with pytest.raises(ContractBroken, match=rule):
        check_ego(ego)


def test_the_contract_takes_a_class_as_tests_of_scenes_do() -> None:
    check_ego(type(load_ego("rule-based")))
