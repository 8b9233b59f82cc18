import math
import sys
import types

import pytest

from chatscene.ego.observation import OBSERVATIONS, Observation, RouteView, Seen
from chatscene.ego.policy import EGOS, EgoPolicy, controls, load_ego, observation_of
from chatscene.errors import EgoError
from chatscene.simulate.embedded.dynamics import VehicleBody, WalkerBody
from chatscene.terms.actors import LIMITS
from chatscene.terms.polyline import Polyline

EAST = Polyline([(x, 0.0) for x in range(100)])


def four_numbers(view: RouteView, *pose: float, ahead: bool = False) -> Observation:
    view.locate(pose[0], pose[1])
    return view.four_numbers(pose[0], pose[1], pose[2], pose[3], ahead)


def test_left_of_the_route_is_positive_and_so_is_pointing_left() -> None:
    lateral, heading, speed, ahead = four_numbers(RouteView(EAST), 10.0, 1.5, 0.2, 7.0)
    assert lateral == pytest.approx(1.5)
    assert heading == pytest.approx(0.2)
    assert speed == 7.0
    assert ahead == 0.0


def test_the_view_looks_about_six_metres_ahead() -> None:
    bend = Polyline([*((float(x), 0.0) for x in range(20)), *((19.0, float(y)) for y in range(1, 20))])
    view = RouteView(bend)
    assert four_numbers(view, 10.0, 0.0, 0.0, 5.0)[1] == pytest.approx(0.0)
    assert four_numbers(view, 14.5, 0.0, 0.0, 5.0)[1] == pytest.approx(-math.pi / 2)


def test_actions_are_mapped_as_safebench_maps_them() -> None:
    assert controls((1.0, 0.0)) == (1.0, 0.0, 0.0)
    assert controls((-1.0, 1.0)) == (0.0, 0.375, 0.3)
    assert controls((0.5, -9.0)) == (0.5, 0.0, -0.3)


def test_full_brake_gives_the_whole_pedal_and_the_same_throttle() -> None:
    assert controls((-1.0, 0.0), "full-brake") == (0.0, 1.0, 0.0)
    assert controls((0.4, 0.5), "full-brake") == controls((0.4, 0.5))


def test_the_richer_view_places_a_walker_ahead_and_to_the_left() -> None:
    view = RouteView(EAST)
    view.locate(10.0, 0.5)
    ego = VehicleBody(10.0, 0.5, 0.0, LIMITS["Car"], 6.0)
    walker = WalkerBody(22.0, 4.5, -math.pi / 2, LIMITS["Pedestrian"], 1.5)
    observation = view.actors(ego, [Seen(walker, True, math.inf)])
    assert observation.shape == (OBSERVATIONS["actors"],)
    assert observation[:4] == pytest.approx((6.0, 0.5, 0.0, 89.0))
    assert observation[4:6] == pytest.approx((5.0, -0.5))
    row = observation[14:25]
    assert row == pytest.approx((1.0, 12.0, 4.5, 12.0, 4.0, 0.0, -1.5, -math.pi / 2, 0.3, 0.3, 1.0), abs=1e-9)
    assert not observation[25:].any()


def test_the_nearest_actors_come_first_and_those_out_of_sight_not_at_all() -> None:
    view = RouteView(EAST)
    view.locate(0.0, 0.0)
    ego = VehicleBody(0.0, 0.0, 0.0, LIMITS["Car"], 6.0)
    others = [Seen(VehicleBody(x, 0.0, 0.0, LIMITS["Car"], 1.0), False, math.inf) for x in (60.0, 40.0, 20.0, 30.0)]
    rows = view.actors(ego, others)[14:].reshape(-1, 11)
    assert rows[:, 3].tolist() == [20.0, 30.0, 40.0, 0.0, 0.0, 0.0]


@pytest.mark.parametrize(("x", "along"), [(-14.0, -14.0), (112.0, 112.0)])
def test_whoever_is_beyond_an_end_of_the_route_is_so_far_behind_or_ahead(x: float, along: float) -> None:
    view = RouteView(EAST)
    view.locate(0.0 if x < 0.0 else 90.0, 0.0)
    ego = VehicleBody(view.along, 0.0, 0.0, LIMITS["Car"], 0.0)
    row = view.actors(ego, [Seen(VehicleBody(x, 0.0, 0.0, LIMITS["Car"], 1.0), False, math.inf)])[14:25]
    assert row[1:3] == pytest.approx((along - view.along, 0.0))


def test_an_ego_by_rule_sets_off_though_somebody_stands_behind_the_start_of_its_route() -> None:
    view = RouteView(EAST)
    view.locate(0.0, 0.0)
    ego = VehicleBody(0.0, 0.0, 0.0, LIMITS["Car"], 0.0)
    behind = VehicleBody(-14.0, 0.0, 0.0, LIMITS["Car"], 0.0)
    assert load_ego("idm").act(view.actors(ego, [Seen(behind, False, math.inf)]))[0] > 0.1


@pytest.mark.parametrize("action", [None, (1.0,), (float("nan"), 0.0), "ab"])
def test_an_action_that_is_not_two_finite_numbers_is_refused(action: object) -> None:
    with pytest.raises(EgoError):
        controls(action)


def seen(ego: EgoPolicy, x: float, y: float, heading: float, speed: float) -> Observation:
    """What an ego sees on an empty road that runs east."""
    view = RouteView(EAST)
    view.locate(x, y)
    if observation_of(ego) == "safebench":
        return view.four_numbers(x, y, heading, speed, False)
    see = {"actors": view.actors, "road": view.road, "traffic": view.traffic}[observation_of(ego)]
    return see(VehicleBody(x, y, heading, LIMITS["Car"], speed), [])


@pytest.mark.parametrize("name", sorted(EGOS.built_in))
class TestContract:
    """What every ego in the table must do."""

    def test_it_steers_back_to_its_route(self, name: str) -> None:
        left, right = load_ego(name), load_ego(name)
        # Learned ones have a bias; what counts is that they steer more to the right from the left than from the right.
        assert left.act(seen(left, 5.0, 1.5, 0.0, 6.0))[1] > right.act(seen(right, 5.0, -1.5, 0.0, 6.0))[1] + 0.05

    def test_it_sets_off_on_an_empty_road(self, name: str) -> None:
        ego = load_ego(name)
        assert ego.act(seen(ego, 5.0, 0.0, 0.0, 0.0))[0] > 0.1


def test_an_unknown_ego_is_named_with_the_nearest_known_one() -> None:
    with pytest.raises(EgoError, match="did you mean 'rule-based'"):
        load_ego("rule-base")


@pytest.mark.parametrize("name", [":", ":make", "my_stack:", ".:make", "my_stack.:make", "..:", "a..b:make"])
def test_a_name_that_lacks_a_part_is_refused(name: str) -> None:
    with pytest.raises(EgoError, match=r"is not of the form package\.module:factory"):
        load_ego(name)


def test_no_name_at_all_is_refused() -> None:
    with pytest.raises(EgoError, match="there is no ego ''"):
        load_ego("")


def test_an_ego_of_the_user_is_a_factory_in_a_module(monkeypatch: pytest.MonkeyPatch) -> None:
    class Still:
        def act(self, observation: object) -> tuple[float, float]:
            return 0.0, 0.0

    module = types.ModuleType("my_stack")
    module.make = Still  # type: ignore[attr-defined]
    module.wrong = dict  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "my_stack", module)
    assert isinstance(load_ego("my_stack:make"), Still)
    with pytest.raises(EgoError, match="without the method act"):
        load_ego("my_stack:wrong")
    with pytest.raises(EgoError, match="has no 'nothing'"):
        load_ego("my_stack:nothing")
    with pytest.raises(EgoError, match="cannot import"):
        load_ego("no_such_stack:make")
