import math
from dataclasses import asdict, fields, replace
from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely import Polygon, box
from shapely.affinity import rotate, translate

from chatscene.measure.criticality import criticality, fault
from chatscene.report.measures import InWords
from chatscene.simulate import boxes
from chatscene.simulate.contact import side_touched
from chatscene.terms.criticality import CRITICALITY, Criticality, Fault, Severity
from chatscene.terms.episode import Ending, Episode, Event, EventKind, Role, Track

DT = 0.1
WEST, NORTH = math.pi, math.pi / 2
few = settings(max_examples=60)


def track(
    actor: str = "adversary",
    x: float = 0.0,
    y: float = 0.0,
    heading: float = 0.0,
    speed: float = 0.0,
    *,
    rows: int = 1,
    size: tuple[float, float] = (4.0, 2.0),
    kind: str = "Car",
    role: Role | None = None,
    turning: float = 0.0,
) -> Track:
    """An actor that keeps its speed [m/s] and its rate of turning [rad/s]."""
    headings = heading + turning * DT * np.arange(rows, dtype=np.float64)
    dx, dy = speed * DT * np.cos(headings[:-1]), speed * DT * np.sin(headings[:-1])
    return Track(
        actor=actor, role=role or Role(actor), kind=kind, length=size[0], width=size[1],
        x=x + np.concatenate(([0.0], np.cumsum(dx))), y=y + np.concatenate(([0.0], np.cumsum(dy))),
        heading=headings, speed=np.full(rows, speed),
    )  # fmt: skip


def episode(*tracks: Track, events: tuple[Event, ...] = ()) -> Episode:
    rows = len(tracks[0].x)
    return Episode(
        scene_id="s", ego="e", dt=DT, tracks=tracks, events=events, signals=(), route_completion=0.5,
        ending=Ending.COLLISION if events else Ending.TIMEOUT,
        distance_to_route=np.zeros(rows), off_road=np.zeros(rows, dtype=np.bool_),
    )  # fmt: skip


def polygon(body: Track, row: int, after: float = 0.0) -> Polygon:
    """A body's box, some seconds after a row if it goes straight on."""
    heading, way = float(body.heading[row]), float(body.speed[row]) * after
    shape = rotate(
        box(-body.length / 2, -body.width / 2, body.length / 2, body.width / 2), heading, (0, 0), use_radians=True
    )
    return translate(shape, float(body.x[row]) + way * math.cos(heading), float(body.y[row]) + way * math.sin(heading))


def crash(ego: Track, *others: Track, speed: float = 5.0) -> Episode:
    """The drive until the ego touches one of the others for the first time."""
    step, struck = next(
        (row, other)
        for row in range(len(ego.x))
        for other in others
        if polygon(ego, row).intersects(polygon(other, row))
    )
    cut = [
        replace(t, **{name: getattr(t, name)[: step + 1] for name in ("x", "y", "heading", "speed")})
        for t in (ego, *others)
    ]
    return episode(*cut, events=(Event(kind=EventKind.COLLISION, step=step, other=struck.actor, impact_speed=speed),))


def test_head_on_both_speeds_count() -> None:
    # Bumpers 96 m apart, closing at 25 m/s; after 1 s, 71 m.
    ego, other = track("ego", speed=10.0, rows=11), track(x=100.0, heading=WEST, speed=15.0, rows=11)
    measures = criticality(episode(ego, other))
    assert measures.time_to_collision == pytest.approx(71 / 25)
    assert measures.time_headway == pytest.approx(71 / 10)
    assert measures.deceleration_required == pytest.approx(25**2 / (2 * 71))
    assert measures.distance == pytest.approx(71)
    assert measures.post_encroachment_time is None  # neither came to where the other had been
    assert (measures.impact_speed, measures.severity) == (None, None)


def test_following_a_slower_leader() -> None:
    # Bumpers 26 m apart, closing at 5 m/s; after 2 s, 16 m.
    ego, leader = track("ego", speed=15.0, rows=21), track(x=30.0, speed=10.0, rows=21)
    measures = criticality(episode(ego, leader))
    assert measures.time_to_collision == pytest.approx(16 / 5)
    assert measures.time_headway == pytest.approx(16 / 15)
    assert measures.deceleration_required == pytest.approx(5**2 / (2 * 16))
    assert measures.distance == pytest.approx(16)
    # The ego's front comes to 32 m after 2 s; the leader's rear, at 28 m to begin with, left it after 0.4 s.
    assert measures.post_encroachment_time == pytest.approx(1.6)


def test_a_leader_that_is_not_slower_asks_for_no_braking() -> None:
    measures = criticality(episode(track("ego", speed=10.0, rows=5), track(x=30.0, speed=10.0, rows=5)))
    assert (measures.time_to_collision, measures.deceleration_required) == (None, None)
    assert measures.time_headway == pytest.approx(2.6)


def test_a_follower_is_not_ahead() -> None:
    measures = criticality(episode(track("ego", speed=10.0), track(x=-30.0, speed=15.0)))
    assert (measures.time_headway, measures.deceleration_required) == (None, None)
    assert measures.time_to_collision == pytest.approx(26 / 5)


def test_an_ego_that_stands_has_no_headway() -> None:
    measures = criticality(episode(track("ego"), track(x=30.0, heading=WEST, speed=10.0)))
    assert measures.time_headway is None
    assert measures.deceleration_required == pytest.approx(10**2 / (2 * 26))


@pytest.mark.parametrize("rows", [1, 80])
def test_parallel_ways_are_never_on_a_collision_course(rows: int) -> None:
    ego, other = track("ego", speed=20.0, rows=rows), track(x=30.0, y=3.5, heading=WEST, speed=15.0, rows=rows)
    expected = 1.5 if rows > 1 else math.hypot(26.0, 1.5)
    measures = criticality(episode(ego, other))
    assert measures.distance == pytest.approx(expected)
    assert (measures.time_to_collision, measures.post_encroachment_time, measures.time_headway) == (None, None, None)
    assert (measures.deceleration_required, measures.impact_speed, measures.severity) == (None, None, None)


def test_crossing_courses_meet_when_both_are_in_the_way() -> None:
    # The ego's front is at the other's side after 4.7 s; the other's front at the ego's side after 4.9 s.
    measures = criticality(episode(track("ego", speed=10.0), track(x=50.0, y=-52.0, heading=NORTH, speed=10.0)))
    assert measures.time_to_collision == pytest.approx(4.9)
    # At 46 m the other's front comes after 4.9 s, when the ego's rear has 1 m to go: it just does not pass.
    measures = criticality(episode(track("ego", speed=10.0), track(x=50.0, y=-57.0, heading=NORTH, speed=10.0)))
    assert measures.time_to_collision is None


@pytest.mark.parametrize("late", [False, True])
def test_crossing_ways_have_the_time_between_one_leaving_and_the_other_coming(late: bool) -> None:
    # Crossing, 2 m by 2 m about (60, 0). The ego is in it from 5.7 s to 6.3 s, the other from 4.7 s to 5.3 s.
    start = -50.0 if not late else -68.0  # … or from 6.5 s to 7.1 s
    ego, other = track("ego", speed=10.0, rows=100), track(y=start, x=60.0, heading=NORTH, speed=10.0, rows=100)
    measures = criticality(episode(ego, other))
    assert measures.post_encroachment_time == pytest.approx(0.2 if late else 0.4)
    assert measures.time_to_collision is None


def test_a_place_left_between_two_steps_is_timed_between_them() -> None:
    # In the crossing from 5.7 s to 6.3 s and from 4.633 s to 5.233 s: neither end falls on a step of 0.1 s.
    ego = track("ego", speed=10.0, rows=100)
    other = track(y=-49.33, x=60.0, heading=NORTH, speed=10.0, rows=100)
    assert criticality(episode(ego, other)).post_encroachment_time == pytest.approx(5.7 - 5.233, abs=DT / 4)


def test_boxes_count_not_circles_nor_upright_rectangles() -> None:
    # A square on its corner, straight ahead: half a diagonal of 2√2 in front of its centre.
    corner = track(x=20.0, heading=math.pi / 4, size=(2.0, 2.0))
    assert criticality(episode(track("ego", speed=10.0), corner)).time_to_collision == pytest.approx(
        (20 - 2 - math.sqrt(2)) / 10
    )
    beside = track(x=3.0, y=2.0, heading=math.pi / 4, size=(2.0, 2.0))
    measures = criticality(episode(track("ego"), beside))
    # Corner (2, 1) of the ego lies |1| + |1| = 2 from its centre along the square's two axes, (2 - √2) / √2 beyond.
    assert measures.distance == pytest.approx((2 - math.sqrt(2)) / math.sqrt(2))


def test_in_contact_all_that_can_be_least_is_zero() -> None:
    scene = crash(track("ego", speed=10.0, rows=40), track(x=30.0, rows=40), speed=10.0)
    measures = criticality(scene)
    assert (measures.time_to_collision, measures.post_encroachment_time, measures.distance) == (0.0, 0.0, 0.0)
    assert (measures.impact_speed, measures.severity) == (10.0, Severity.S2)
    assert measures.deceleration_required is not None


def test_the_worst_adversary_counts_and_nobody_else() -> None:
    ego, near, far = track("ego", speed=15.0), track(x=30.0, speed=10.0), track(x=60.0, speed=5.0)
    background = track("background", x=10.0)
    assert criticality(episode(ego, near, background)) == criticality(episode(ego, near))
    both, first, second = (criticality(episode(ego, *others)) for others in ((near, far), (near,), (far,)))
    assert both.time_headway == first.time_headway
    assert both.deceleration_required == max(measures.deceleration_required or 0.0 for measures in (first, second))


def test_without_an_adversary_only_the_crash_is_measured() -> None:
    thing = track("occluder", x=30.0, rows=40, kind="Kiosk")
    measures = criticality(crash(track("ego", speed=10.0, rows=40), thing, speed=1.0))
    assert not {name: value for name, value in asdict(measures).items() if name in CRITICALITY and value is not None}
    assert (measures.impact_speed, measures.severity) == (1.0, Severity.S0)


SEVERITIES = [  # the other's kind, the speed in km/h, the class
    ("Pedestrian", 0.0, "S0"), ("Pedestrian", 1.0, "S1"), ("Pedestrian", 28.9, "S1"), ("Pedestrian", 29.1, "S2"),
    ("Pedestrian", 38.5, "S2"), ("Bicycle", 39.5, "S3"), ("Motorcycle", 29.1, "S2"),
    ("Car", 6.9, "S0"), ("Car", 7.1, "S1"), ("Kiosk", 34.9, "S1"), ("Truck", 35.1, "S2"), ("Bus", 52.4, "S2"),
    ("Car", 52.6, "S3"),
]  # fmt: skip


@pytest.mark.parametrize(("kind", "speed", "expected"), SEVERITIES)
def test_severity_follows_the_speed_and_what_was_struck(kind: str, speed: float, expected: str) -> None:
    scene = crash(track("ego", speed=10.0, rows=40), track(x=30.0, rows=40, kind=kind), speed=speed / 3.6)
    assert criticality(scene).severity == expected


@given(st.floats(0.0, 40.0))
def test_at_one_speed_who_is_unprotected_is_never_hurt_less(speed: float) -> None:
    ego = track("ego", speed=10.0, rows=40)
    walker, car = (criticality(crash(ego, track(x=30.0, rows=40, kind=k), speed=speed)) for k in ("Pedestrian", "Car"))
    assert walker.severity is not None
    assert car.severity is not None
    assert walker.severity >= car.severity


PERSON = (0.6, 0.6)
LEFT = 3.0  # [m], beside the ego with 1 m between
MOVED_THEN_STOOD = replace(track(x=31.0, rows=40), x=np.concatenate((np.linspace(29.0, 31.0, 5), np.full(35, 31.0))))
FAULTS: list[tuple[str, Track, Track, Fault]] = [
    ("the ego rams a slower leader",
     track("ego", speed=15.0, rows=60), track(x=20.0, speed=8.0, rows=60), Fault.EGO_INTO_ADVERSARY),
    ("a faster follower rams the ego",
     track("ego", speed=8.0, rows=60), track(x=-20.0, speed=15.0, rows=60), Fault.ADVERSARY_INTO_EGO),
    ("a follower rams the ego on its last 10 cm of width, and is 0.7 m deep when that is seen",
     track("ego", speed=8.0, rows=60), track(x=-20.0, y=1.9, speed=15.0, rows=60), Fault.ADVERSARY_INTO_EGO),
    ("the adversary swerves, its corner into the ego's flank, the ego driving faster",
     track("ego", speed=15.0, rows=60), track(x=-1.0, y=LEFT, heading=-0.1, speed=13.0, rows=60),
     Fault.ADVERSARY_INTO_EGO),
    ("the ego swerves, its corner into the adversary's flank",
     track("ego", heading=0.1, speed=15.0, rows=60), track(x=1.0, y=LEFT, speed=13.0, rows=60),
     Fault.EGO_INTO_ADVERSARY),
    ("the adversary cuts in, and its flank is struck by the ego's corner",
     track("ego", speed=15.0, rows=60), track(x=4.0, y=LEFT, heading=-0.1, speed=13.0, rows=60),
     Fault.EGO_INTO_ADVERSARY),
    ("a pedestrian walks into the ego's flank",
     track("ego", speed=10.0, rows=60), track(x=30.0, y=-5.75, heading=NORTH, speed=1.5, size=PERSON, rows=60),
     Fault.ADVERSARY_INTO_EGO),
    ("the ego drives into a pedestrian in its way",
     track("ego", speed=10.0, rows=60), track(x=30.0, y=-3.6, heading=NORTH, speed=1.2, size=PERSON, rows=60),
     Fault.EGO_INTO_ADVERSARY),
    ("a crossing car hits the ego's flank",
     track("ego", speed=10.0, rows=60), track(x=30.0, y=-36.0, heading=NORTH, speed=11.0, rows=60),
     Fault.ADVERSARY_INTO_EGO),
    ("the ego hits a crossing car's flank",
     track("ego", speed=10.0, rows=60), track(x=30.0, y=-27.0, heading=NORTH, speed=10.0, rows=60),
     Fault.EGO_INTO_ADVERSARY),
    ("head-on, the adversary faster",
     track("ego", speed=10.0, rows=60), track(x=50.0, heading=WEST, speed=12.0, rows=60), Fault.ADVERSARY_INTO_EGO),
    ("head-on, alike",
     track("ego", speed=10.0, rows=60), track(x=50.0, heading=WEST, speed=10.0, rows=60), Fault.EGO_INTO_ADVERSARY),
    ("the ego stands and is hit",
     track("ego", rows=60), track(x=50.0, heading=WEST, speed=10.0, rows=60), Fault.ADVERSARY_INTO_EGO),
    ("the ego reverses into a standing adversary that had come",
     track("ego", x=40.0, speed=-5.0, rows=40), MOVED_THEN_STOOD, Fault.EGO_INTO_ADVERSARY),
    ("the ego drives into a parked car",
     track("ego", speed=10.0, rows=60), track("background", x=30.0, rows=60), Fault.EGO_INTO_STATIC),
    ("the ego drives into an adversary that never moved",
     track("ego", speed=10.0, rows=60), track(x=30.0, rows=60), Fault.EGO_INTO_STATIC),
    ("the ego drives into a thing",
     track("ego", speed=10.0, rows=60), track("occluder", x=30.0, rows=60, kind="Kiosk"), Fault.EGO_INTO_STATIC),
    ("the ego drives into other traffic",
     track("ego", speed=10.0, rows=60), track("background", x=30.0, speed=4.0, rows=60), Fault.EGO_INTO_BACKGROUND),
    ("other traffic drives into the ego",
     track("ego", speed=4.0, rows=60), track("background", x=-30.0, speed=12.0, rows=60), Fault.BACKGROUND_INTO_EGO),
]  # fmt: skip


@cache
def staged(case: int) -> Episode:
    return crash(FAULTS[case][1], FAULTS[case][2])


@pytest.mark.parametrize("case", range(len(FAULTS)), ids=[name for name, *_ in FAULTS])
def test_who_struck_whom(case: int) -> None:
    assert fault(staged(case)) is FAULTS[case][3]


BESIDE = [
    ("the ego moves over into who keeps its lane",
     track("ego", speed=20.0, turning=0.02, rows=60), track(y=2.6, speed=20.0, rows=60), Fault.EGO_INTO_ADVERSARY),
    ("who moves over into an ego that keeps its lane",
     track("ego", speed=20.0, rows=60), track(y=2.6, speed=20.0, turning=-0.02, rows=60), Fault.ADVERSARY_INTO_EGO),
    ("who comes over from the oncoming lane",
     track("ego", speed=12.0, rows=60), track(x=60.0, y=2.6, heading=WEST, speed=11.0, turning=0.02, rows=60),
     Fault.ADVERSARY_INTO_EGO),
]  # fmt: skip


@pytest.mark.parametrize("case", BESIDE, ids=[name for name, *_ in BESIDE])
def test_of_two_who_touch_side_by_side_who_turned_toward_the_other_struck(
    case: tuple[str, Track, Track, Fault],
) -> None:
    _, ego, other, expected = case
    scene = crash(ego, other)
    hit = scene.events[0]
    side = side_touched(scene.tracks[0], scene.tracks[1], hit.step)
    assert side == "left"
    assert fault(replace(scene, events=(replace(hit, side=side),))) is expected


def test_without_a_collision_nobody_struck_anybody() -> None:
    assert fault(episode(track("ego", speed=10.0), track(x=30.0))) is None


def test_whoever_is_pushed_by_the_crash_had_not_moved() -> None:
    scene = crash(track("ego", speed=10.0, rows=60), track("background", x=30.0, rows=60))
    ego, parked = scene.tracks
    pushed = [
        replace(t, **{name: np.append(getattr(t, name), getattr(t, name)[-1] + (name == "x")) for name in
                      ("x", "y", "heading", "speed")})
        for t in (ego, parked)
    ]  # fmt: skip
    assert fault(episode(*pushed, events=scene.events)) is Fault.EGO_INTO_STATIC


# Numbers off any round one: exactly touching or exactly parallel is a matter of rounding, and turning a scene rounds.
def odd(least: int, most: int, unit: float) -> st.SearchStrategy[float]:
    return st.integers(least, most).map(lambda n: n * unit + 0.01237)


def moving(actor: str, rows: int) -> st.SearchStrategy[Track]:
    return st.builds(
        track, st.just(actor), odd(-20, 20, 1.1), odd(-20, 20, 1.3), odd(-6, 6, 0.5), odd(0, 15, 1.0),
        rows=st.just(rows), size=st.sampled_from([(4.9, 2.1), (0.6, 0.6), (11.5, 2.5)]), turning=odd(-3, 3, 0.1),
    )  # fmt: skip


def turned(body: Track, angle: float, dx: float, dy: float) -> Track:
    c, s = math.cos(angle), math.sin(angle)
    return replace(body, x=c * body.x - s * body.y + dx, y=s * body.x + c * body.y + dy, heading=body.heading + angle)


def numbers(measures: Criticality) -> list[float | None]:
    return [getattr(measures, field.name) for field in fields(Criticality)[:5]]


@few
@given(moving("ego", 30), moving("adversary", 30), st.floats(-7, 7), st.floats(-500, 500), st.floats(-500, 500))
def test_where_a_scene_lies_and_how_it_is_turned_changes_nothing(
    ego: Track, other: Track, angle: float, dx: float, dy: float
) -> None:
    here = criticality(episode(ego, other))
    there = criticality(episode(turned(ego, angle, dx, dy), turned(other, angle, dx, dy)))
    for before, after in zip(numbers(here), numbers(there), strict=True):
        assert after is None if before is None else after == pytest.approx(before, rel=1e-6, abs=1e-6)


@few
@given(st.integers(0, len(FAULTS) - 1), st.floats(-7, 7), st.floats(-500, 500), st.floats(-500, 500))
def test_who_struck_whom_does_not_depend_on_where(case: int, angle: float, dx: float, dy: float) -> None:
    scene = staged(case)
    assert fault(replace(scene, tracks=tuple(turned(t, angle, dx, dy) for t in scene.tracks))) is FAULTS[case][3]


@few
@given(moving("ego", 30), moving("adversary", 30))
def test_what_is_between_two_is_the_same_from_either(ego: Track, other: Track) -> None:
    one = criticality(episode(ego, other))
    two = criticality(episode(replace(other, role=Role.EGO), replace(ego, role=Role.ADVERSARY)))
    assert one.time_to_collision == pytest.approx(two.time_to_collision)
    assert one.distance == pytest.approx(two.distance)
    first, second = one.post_encroachment_time, two.post_encroachment_time
    assert (first is None) == (second is None)
    # Only one of the two is followed between steps with its turning: where boxes graze, that shows.
    assert first is None or second is None or abs(first - second) <= 2 * DT


@few
@given(moving("ego", 1), moving("adversary", 1))
def test_the_boxes_touch_after_the_time_to_collision_and_not_before(ego: Track, other: Track) -> None:
    time = criticality(episode(ego, other)).time_to_collision

    def gap(after: float) -> float:
        return polygon(ego, 0, after).distance(polygon(other, 0, after))

    if time is None:
        assert all(gap(after) > 0.0 for after in np.linspace(0.0, 30.0, 120).tolist())
    else:
        assert gap(time) == pytest.approx(0.0, abs=1e-6)
        assert all(gap(after) > 0.0 for after in np.linspace(0.0, time, 20, endpoint=False).tolist() if time > 0.0)


@few
@given(moving("ego", 10), moving("adversary", 10))
def test_the_distance_is_that_of_the_nearest_boxes(ego: Track, other: Track) -> None:
    expected = min(polygon(ego, row).distance(polygon(other, row)) for row in range(10))
    assert criticality(episode(ego, other)).distance == pytest.approx(expected, abs=1e-9)


@few
@given(moving("ego", 25), moving("adversary", 25))
def test_the_post_encroachment_time_is_that_of_the_boxes(ego: Track, other: Track) -> None:
    ours = criticality(episode(ego, other)).post_encroachment_time
    one, two = ([polygon(body, row) for row in range(25)] for body in (ego, other))
    whole = [abs(i - j) * DT for i, a in enumerate(one) for j, b in enumerate(two) if a.intersects(b)]
    assert (ours is None) == (not whole)
    # Whole steps see either end up to a step late.
    assert ours is None or min(whole) - 2 * DT - 1e-9 <= ours <= min(whole) + 1e-9


def test_every_measure_has_its_words() -> None:
    for one in fields(Criticality):
        assert "page" in one.metadata, f"terms/criticality.py: {one.name} is to be _measured, or _of_crash"
    for name, one in CRITICALITY.items():
        assert one.more in ("better", "worse"), f"terms/criticality.py: {name}: more of it is better or worse"
        assert one.name and one.meaning and one.unit, f"terms/criticality.py: {name} lacks words"


def test_a_measure_of_which_no_more_is_said_is_told_without_a_gap() -> None:
    assert InWords("least mean distance", "better", "m").in_one == "least mean distance; more is better"
    assert InWords("friction demand", "", of="share").in_one == "friction demand: share"
    assert InWords("speed", "").in_one == "speed"


def ahead_in_the_corridor(ego: Track, other: Track) -> float | None:
    """From the ego's front to the nearest of what is ahead of the other, cut to the strip as wide as the ego."""
    strip = box(float(ego.x[0]) + ego.length / 2, -ego.width / 2, 1e3, ego.width / 2)
    part = polygon(other, 0).intersection(strip)
    return part.bounds[0] - strip.bounds[0] if part.area > 1e-6 else None


@few
@given(
    x=st.floats(8.0, 30.0),
    y=st.floats(-5.0, 5.0),
    heading=st.floats(-math.pi, math.pi),
    length=st.floats(0.5, 12.0),
    width=st.floats(0.5, 3.0),
)
@pytest.mark.parametrize("native", [True, False])
def test_who_is_ahead_is_ahead_by_what_of_it_lies_in_the_corridor(
    native: bool, x: float, y: float, heading: float, length: float, width: float
) -> None:
    ego = track("ego", speed=10.0)
    other = track(x=x, y=y, heading=heading, size=(length, width))
    expected = ahead_in_the_corridor(ego, other)
    with pytest.MonkeyPatch.context() as patch:
        if not native:
            patch.setattr(boxes, "engine", lambda: None)
        boxes.between.cache_clear()
        found = float(boxes.between(ego, other).ahead[0])
        boxes.between.cache_clear()
    if expected is not None and expected > 1e-6 and not polygon(ego, 0).intersects(polygon(other, 0)):
        assert found == pytest.approx(expected, abs=1e-6)


def test_the_headway_to_somebody_turned_is_to_what_blocks_the_way() -> None:
    # A car at 45° whose nearest corner lies beside the corridor: it enters at y = 1 on its edge toward the ego.
    ego, other = track("ego", speed=10.0), track(x=12.0, y=3.0, heading=math.pi / 4, size=(6.0, 2.0))
    nearest = 12.0 - 2.0 - (3.0 + 1.0) / math.sqrt(2)  # of its corners, from the ego's front
    headway = criticality(episode(ego, other)).time_headway
    assert headway is not None
    assert headway == pytest.approx(ahead_in_the_corridor(ego, other) / 10.0)  # type: ignore[operator] # pyright: ignore[reportOptionalOperand]
    assert headway > nearest / 10.0 + 0.05
