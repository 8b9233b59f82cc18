import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from chatscene.simulate.contact import approach_speed, contact_side, touch
from chatscene.simulate.embedded.dynamics import VehicleBody, WalkerBody, make_body
from chatscene.terms.actors import LIMITS
from chatscene.world.bodies import Body, Placement

DT = 0.1
pedal = st.floats(0, 1)
wheel = st.floats(-1, 1)
kinds = st.sampled_from([kind for kind, limits in LIMITS.items() if limits.wheelbase])


def vehicle(kind: str = "Car", speed: float = 0.0) -> VehicleBody:
    limits = LIMITS[kind]
    body = make_body(
        Placement(
            kind=kind,
            x=0.0,
            y=0.0,
            heading=0.0,
            speed=speed,
            length=limits.length,
            width=limits.width,
            wheelbase=limits.wheelbase,
            wheel_angle=limits.wheel_angle,
        )
    )
    assert isinstance(body, VehicleBody)
    return body


def walker(speed: float = 0.0) -> WalkerBody:
    body = make_body(Placement(kind="Pedestrian", x=0.0, y=0.0, heading=0.0, speed=speed, length=0.6, width=0.6))
    assert isinstance(body, WalkerBody)
    return body


def run(body: VehicleBody | WalkerBody, steps: int) -> None:
    for _ in range(steps):
        body.step(DT)


def test_full_throttle_moves_a_car_forward_and_full_brake_stops_it_for_good() -> None:
    body = vehicle()
    body.throttle = 1.0
    run(body, 30)
    assert 10.0 < body.speed < 14.0
    body.throttle, body.brake = 0.0, 1.0
    run(body, 40)
    assert body.speed == 0.0
    x = body.x
    run(body, 10)
    assert body.x == x


def test_a_car_coasts_down_but_not_backwards() -> None:
    body = vehicle(speed=3.0)
    run(body, 300)
    assert body.speed == 0.0


def test_steering_right_turns_clockwise() -> None:
    body = vehicle(speed=5.0)
    body.steer, body.throttle = 0.2, 0.2
    run(body, 20)
    assert body.heading < -0.3
    assert body.y < -0.5


def test_a_slow_car_drives_the_circle_that_its_wheel_angle_gives() -> None:
    car = vehicle(speed=2.0)
    car.wheel = -0.3 * LIMITS["Car"].wheel_angle
    car.steer, car.target_speed = 0.3, 2.0
    radius = LIMITS["Car"].wheelbase / math.tan(0.3 * LIMITS["Car"].wheel_angle)
    run(car, 100)
    turned = -car.heading
    # The centre runs on a slightly larger circle than the rear axle.
    assert turned == pytest.approx(2.0 * 100 * DT / math.hypot(radius, LIMITS["Car"].wheelbase / 2), rel=0.02)


def test_reverse_gear_first_brakes_and_then_drives_backwards() -> None:
    body = vehicle(speed=2.0)
    body.reverse, body.throttle = True, 0.6
    body.step(DT)
    assert 0.0 < body.speed < 2.0
    run(body, 30)
    assert body.speed < -1.0
    assert body.x < vehicle(speed=2.0).x + 3.0


def test_a_speed_asked_for_at_once_is_reached_no_faster_than_pedals_allow() -> None:
    body = vehicle(speed=15.0)
    body.target_speed = 0.0
    body.step(DT)
    assert body.speed == pytest.approx(15.0 - LIMITS["Car"].brake * DT)


def test_a_walker_needs_time_to_sprint_and_faces_where_it_goes() -> None:
    body = walker()
    body.course, body.target_speed = math.pi / 2, 5.0
    body.step(DT)
    assert body.speed == pytest.approx(LIMITS["Pedestrian"].throttle * DT)
    run(body, 20)
    assert body.speed == pytest.approx(5.0)
    assert body.heading == pytest.approx(math.pi / 2)
    assert body.x == pytest.approx(0.0)


@settings(max_examples=60)
@given(kinds, st.lists(st.tuples(pedal, pedal, wheel, st.booleans()), min_size=1, max_size=30), st.floats(0, 20))
def test_no_control_makes_a_vehicle_jump(
    kind: str, orders: list[tuple[float, float, float, bool]], speed: float
) -> None:
    limits = LIMITS[kind]
    body = vehicle(kind, min(speed, limits.top_speed))
    hardest = limits.throttle + limits.brake + limits.drag + 0.0008 * limits.top_speed**2
    for body.throttle, body.brake, body.steer, body.reverse in orders:
        x, y, v, heading = body.x, body.y, body.speed, body.heading
        body.step(DT)
        assert abs(body.speed - v) <= hardest * DT + 1e-9
        assert math.hypot(body.x - x, body.y - y) <= max(abs(v), abs(body.speed)) * DT + 1e-9
        assert abs(body.heading - heading) * abs(v + body.speed) / 2 <= limits.lateral * DT + 1e-6
        assert -6.0 <= body.speed <= limits.top_speed


@settings(max_examples=60)
@given(st.lists(st.tuples(st.floats(-4, 4), st.floats(0, 20)), min_size=1, max_size=30))
def test_no_wish_makes_a_walker_jump(wishes: list[tuple[float, float]]) -> None:
    body, limits = walker(), LIMITS["Pedestrian"]
    for body.course, body.target_speed in wishes:
        vx, vy = body.vx, body.vy
        body.step(DT)
        assert math.hypot(body.vx - vx, body.vy - vy) <= limits.brake * DT + 1e-9
        assert body.speed <= limits.top_speed + 1e-9


def box(x: float, y: float, heading: float = 0.0, length: float = 4.0, width: float = 2.0) -> Body:
    return Body(x, y, heading, length, width)


def test_boxes_touch_when_they_overlap_and_not_when_they_miss() -> None:
    assert touch(box(0, 0), box(3.9, 0))
    assert not touch(box(0, 0), box(4.1, 0))
    assert touch(box(0, 0), box(0, 1.9))
    assert not touch(box(0, 0), box(0, 2.1))
    # Circles around them overlap, the turned boxes do not.
    assert not touch(box(0, 0), box(3.0, 3.2, math.pi / 4))


@settings(max_examples=200)
@given(*[st.floats(-5, 5)] * 2, *[st.floats(-math.pi, math.pi)] * 2)
def test_touching_agrees_with_polygon_intersection(x: float, y: float, a: float, b: float) -> None:
    shapely = pytest.importorskip("shapely", reason="shapely, which Scenic brings, is not installed")

    def polygon(body: Body):
        corners = [
            (
                body.x + u * body.half_length * body.cos - v * body.half_width * body.sin,
                body.y + u * body.half_length * body.sin + v * body.half_width * body.cos,
            )
            for u, v in ((1, 1), (1, -1), (-1, -1), (-1, 1))
        ]
        return shapely.Polygon(corners)

    first, second = box(0, 0, a), box(x, y, b, 3.0, 1.0)
    distance = polygon(first).distance(polygon(second))
    area = polygon(first).intersection(polygon(second)).area
    if area > 1e-6:
        assert touch(first, second)
    elif distance > 1e-6:
        assert not touch(first, second)


@pytest.mark.parametrize(
    ("x", "y", "side"), [(2.2, 0, "front"), (-2.2, 0, "rear"), (0, 1.2, "left"), (0.5, -1.2, "right")]
)
def test_a_contact_is_reported_on_the_side_where_it_is(x: float, y: float, side: str) -> None:
    assert contact_side(box(0, 0), box(x, y, 0.0, 0.6, 0.6)) == side


def test_approach_speed_is_relative() -> None:
    a, b = vehicle(), vehicle()
    a.before, b.before = 8.0, 5.0
    assert approach_speed(a, b, 0.0, 0.0) == pytest.approx(3.0)
    assert approach_speed(a, b, 0.0, math.pi) == pytest.approx(13.0)


@pytest.mark.parametrize(
    ("kind", "size", "speed", "message"),
    [
        ("Car", (4.9, 0.0), 0.0, "a car of 4.9 m by 0 m"),
        ("Car", (math.inf, 2.0), 0.0, "a car of inf m"),
        ("Car", (4.9, 2.1), 90.0, "it goes at -6 to 50 m/s"),
        ("Pedestrian", (0.6, 0.6), -1.0, "it goes at 0 to 8 m/s"),
        ("Kiosk", (2.0, 2.0), 5.0, "a kiosk that begins at 5 m/s"),
    ],
)
def test_a_body_that_cannot_be_is_refused_and_not_made_into_another(
    kind: str, size: tuple[float, float], speed: float, message: str
) -> None:
    with pytest.raises(ValueError, match=message):
        make_body(Placement(kind=kind, x=0.0, y=0.0, heading=0.0, speed=speed, length=size[0], width=size[1]))
