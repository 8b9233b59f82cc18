import math
import sys
import types

import pytest

from chatscene.ego.observation import RouteView
from chatscene.ego.policy import EGOS, EgoPolicy, controls, load_ego
from chatscene.errors import EgoError
from chatscene.terms.polyline import Polyline

EAST = Polyline([(x, 0.0) for x in range(100)])


def test_left_of_the_route_is_positive_and_so_is_pointing_left() -> None:
    lateral, heading, speed, ahead = RouteView(EAST).observe(10.0, 1.5, 0.2, 7.0, False)
    assert lateral == pytest.approx(1.5)
    assert heading == pytest.approx(0.2)
    assert speed == 7.0
    assert ahead == 0.0


def test_the_view_looks_about_six_metres_ahead() -> None:
    bend = Polyline([*((float(x), 0.0) for x in range(20)), *((19.0, float(y)) for y in range(1, 20))])
    view = RouteView(bend)
    assert view.observe(10.0, 0.0, 0.0, 5.0, False)[1] == pytest.approx(0.0)
    assert view.observe(14.5, 0.0, 0.0, 5.0, False)[1] == pytest.approx(-math.pi / 2)


def test_actions_are_mapped_as_safebench_maps_them() -> None:
    assert controls((1.0, 0.0)) == (1.0, 0.0, 0.0)
    assert controls((-1.0, 1.0)) == (0.0, 0.375, 0.3)
    assert controls((0.5, -9.0)) == (0.5, 0.0, -0.3)


@pytest.mark.parametrize("action", [None, (1.0,), (float("nan"), 0.0), "ab"])
def test_an_action_that_is_not_two_finite_numbers_is_refused(action: object) -> None:
    with pytest.raises(EgoError):
        controls(action)


@pytest.mark.parametrize("name", sorted(EGOS))
class TestContract:
    """What every ego in the table must do."""

    def test_it_loads_and_acts_within_bounds(self, name: str) -> None:
        ego = load_ego(name)
        assert isinstance(ego, EgoPolicy)
        view = RouteView(EAST)
        for pose in ((0.0, 0.0, 0.0, 0.0), (5.0, -2.0, 0.5, 9.0), (50.0, 3.0, -1.0, 15.0)):
            controls(ego.act(view.observe(*pose, True)))

    def test_the_same_observation_gives_the_same_action(self, name: str) -> None:
        observation = RouteView(EAST).observe(5.0, 0.4, 0.1, 6.0, False)
        assert tuple(load_ego(name).act(observation)) == tuple(load_ego(name).act(observation))


def test_an_unknown_ego_is_named_with_the_nearest_known_one() -> None:
    with pytest.raises(EgoError, match="did you mean 'rule-based'"):
        load_ego("rule-base")


def test_an_ego_of_the_user_is_a_factory_in_a_module(monkeypatch: pytest.MonkeyPatch) -> None:
    class Still:
        def act(self, observation: object) -> tuple[float, float]:
            return 0.0, 0.0

    module = types.ModuleType("my_stack")
    module.make = Still  # type: ignore[attr-defined]
    module.wrong = dict  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "my_stack", module)
    assert isinstance(load_ego("my_stack:make"), Still)
    with pytest.raises(EgoError, match="no method act"):
        load_ego("my_stack:wrong")
    with pytest.raises(EgoError, match="has no 'nothing'"):
        load_ego("my_stack:nothing")
    with pytest.raises(EgoError, match="cannot import"):
        load_ego("no_such_stack:make")
