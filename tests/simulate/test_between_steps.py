"""Nobody goes through anybody between two steps, however fast they come, and it is told where they met."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from benchmarks.differing import differences
from chatscene.ego.observation import Observation
from chatscene.maps.network import resolve_map
from chatscene.measure.criticality import criticality, part_struck
from chatscene.settings import SimulationSettings
from chatscene.simulate.boxes import Boxes, Pair
from chatscene.simulate.contact import FINE, SWEPT, Was, between, contact_side, met, touch
from chatscene.simulate.native.simulator import NativeSimulator
from chatscene.simulate.simulator import load_simulator, simulate
from chatscene.terms.actors import LIMITS
from chatscene.terms.episode import Episode
from chatscene.terms.scene import Scene, ScenicProgram
from chatscene.world.bodies import Body

DT = 0.1
KINDS = ("Child", "Pedestrian", "Bicycle", "Motorcycle", "Car", "Truck")
angle = st.floats(-math.pi, math.pi)


def _smaller(body: Body) -> Boxes:
    half_length, half_width = body.half_length - FINE / 2, body.half_width - FINE / 2
    x, y, cos, sin = (np.array(one) for one in (body.x, body.y, body.cos, body.sin))
    return Boxes(x, y, cos, sin, half_length, half_width)


def _steps(
    kind: str, speeds: tuple[float, float], turned: float, beside: float, phase: float
) -> tuple[bool, float | None]:
    """Whether two who go straight on truly meet by more than is looked for, and when it is noticed [steps]."""
    car, other = LIMITS["Car"], LIMITS[kind]
    ego, them = Body(0.0, 0.0, 0.0, car.length, car.width), Body(0.0, 0.0, turned, other.length, other.width)
    vx, vy = speeds[1] * them.cos - speeds[0], speeds[1] * them.sin
    speed = math.hypot(vx, vy)
    assume(speed > 1.0)
    x, y = -vy / speed * beside - vx * phase * DT, vx / speed * beside - vy * phase * DT

    pair = Pair.of(_smaller(ego), replace(_smaller(them), x=np.array(x), y=np.array(y)))
    enter, leave = pair.overlap(np.array(vx), np.array(vy))
    truly, noticed = bool(enter.max() < leave.min()), None
    before: tuple[Was, Was] | None = None
    far = math.ceil((ego.radius + them.radius) / (speed * DT)) + 2
    for step in range(-far, far + 1):
        ego.x, them.x, them.y = (
            speeds[0] * step * DT,
            x + them.cos * speeds[1] * step * DT,
            y + them.sin * speeds[1] * step * DT,
        )
        if before is not None and noticed is None:
            earlier = met(ego, them, *before, 0.0)
            noticed = None if earlier is None else step - earlier
        before = (ego.x, ego.y, ego.heading), (them.x, them.y, them.heading)
    return truly, noticed


@settings(max_examples=150, deadline=None)
@given(st.sampled_from(KINDS), st.floats(1, 36), st.floats(0, 36), angle, st.floats(-5, 5), st.floats(0, 1))
def test_whoever_meets_is_seen_to_meet_at_up_to_seventy_metres_a_second(
    kind: str, own: float, theirs: float, turned: float, beside: float, phase: float
) -> None:
    truly, noticed = _steps(kind, (own, theirs), turned, beside, phase)
    assert noticed is not None or not truly


def test_a_bicycle_that_comes_at_seventy_metres_a_second_is_not_driven_through() -> None:
    ego, bicycle = Body(5.3, 0.0, 0.0, 4.9, 2.13), Body(1.9, 0.3, math.pi, 1.8, 0.6)
    was = (1.8, 0.0, 0.0), (5.2, 0.3, math.pi)
    assert not touch(ego, bicycle)
    assert not touch(between(ego, was[0], 0.0), between(bicycle, was[1], 0.0))
    earlier = met(ego, bicycle, *was, SWEPT)
    assert earlier is not None
    assert earlier > 0.9
    assert contact_side(between(ego, was[0], 1.0 - earlier), between(bicycle, was[1], 1.0 - earlier)) == "front"


def test_somebody_who_is_hit_at_speed_is_hit_where_the_car_first_touches_them() -> None:
    """After the step they are 2 m inside the box, nearer to its side than to its front."""
    ego, walker = Body(3.0, 0.0, 0.0, 4.9, 2.13), Body(3.4, 0.7, math.pi / 2, 0.6, 0.6)
    was = (0.0, 0.0, 0.0), (3.4, 0.55, math.pi / 2)
    earlier = met(ego, walker, *was, SWEPT)
    assert earlier is not None
    assert contact_side(ego, walker) == "left"
    assert contact_side(between(ego, was[0], 1.0 - earlier), between(walker, was[1], 1.0 - earlier)) == "front"


def test_where_two_come_slowly_nearer_only_the_state_after_the_step_is_looked_at() -> None:
    ego, walker = Body(0.8, 0.0, 0.0, 4.9, 2.13), Body(2.8, 0.2, 0.0, 0.6, 0.6)
    assert met(ego, walker, (0.0, 0.0, 0.0), (2.8, 0.2, 0.0), SWEPT) == 0.0


PROGRAM = """model chatscene.world.model
egoRoute = selectRoute(maneuver="straight")
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute, with speed 46,
    with wantedSpeed 46
behavior AdvBehavior():
    do MoveAhead(46, 0)
AdvAgent = new Motorcycle at pointOn(egoRoute, {far}, 0.3), facing directionOn(egoRoute, {far}) + 180 deg,
    with speed 46, with behavior AdvBehavior()
"""
SCENE = Scene(id="own/0", scenario_id="own", route=0, block=0, seed=0, values={})


class StraightOn:
    """Presses the pedal and leaves the wheel alone."""

    name = "straight-on"

    def act(self, observation: Observation) -> tuple[float, float]:
        return 1.0, 0.0


@pytest.mark.parametrize(("far", "passes"), [(41.5, True), (44.5, False)])
def test_both_simulators_see_what_passes_between_two_steps_alike(far: float, passes: bool) -> None:
    program = ScenicProgram(scenario_id="own", source=PROGRAM.format(far=far), parameters=(), snippet_ids=())
    settings_ = SimulationSettings(simulator="embedded")
    theirs = simulate(load_simulator(resolve_map("town"), settings_), program, SCENE, StraightOn())
    native = NativeSimulator(resolve_map("town"), settings_)
    assert isinstance(theirs, Episode)
    crash = theirs.collision
    assert crash is not None
    ego, other = theirs.ego_track, theirs.adversaries[0]
    apart = not touch(*(Body(*track.pose(crash.step), track.length, track.width) for track in (ego, other)))
    assert apart == passes
    assert (crash.side, part_struck(other, ego, crash)) == ("front", "front")
    assert criticality(theirs).distance == 0.0
    if not native.missing:
        mine = simulate(native, program, SCENE, StraightOn())
        assert isinstance(mine, Episode)
        assert mine.stepped.by == "native"
        assert differences(mine, theirs) == []
