import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from chatscene.errors import SettingsError
from chatscene.evaluate.score import average_displacement, columns, measure, score, wilson
from chatscene.terms.episode import Ending, Episode, Event, EventKind, Role, Track
from chatscene.terms.metrics import Measurements, Mode

DT = 0.1
BLANK = Measurements(
    collided=False, red_lights=0, stop_signs=0, off_road=0.0, distance_to_route=0.0, completion=1.0,
    time=30.0, acceleration=0.0, yaw_rate=0.0, yaw_rate_unwrapped=0.0, lane_invasions=0, duration=30.0,
)  # fmt: skip


def with_(**changes: object) -> Measurements:
    from dataclasses import replace

    return replace(BLANK, **changes)  # type: ignore[arg-type]


def track(
    x: list[float],
    y: list[float] | None = None,
    heading: list[float] | None = None,
    speed: list[float] | None = None,
) -> Track:
    zero = [0.0] * len(x)
    return Track(
        actor="ego", role=Role.EGO, kind="Car", length=4.9, width=2.1,
        x=np.array(x), y=np.array(y or zero), heading=np.array(heading or zero), speed=np.array(speed or zero),
    )  # fmt: skip


def episode(
    ego: Track,
    *,
    events: tuple[Event, ...] = (),
    ending: Ending = Ending.TIMEOUT,
    completion: float = 0.5,
    off: list[bool] | None = None,
    distance: list[float] | None = None,
) -> Episode:
    steps = len(ego.x)
    return Episode(
        scene_id="s", ego="e", dt=DT, tracks=(ego,), events=events, signals=(), ending=ending,
        route_completion=completion, distance_to_route=np.array(distance or [0.0] * steps),
        off_road=np.array(off or [False] * steps),
    )  # fmt: skip


def test_counts_come_from_events() -> None:
    kinds = [
        EventKind.RED_LIGHT,
        EventKind.RED_LIGHT,
        EventKind.STOP_SIGN,
        EventKind.LANE_INVASION,
        EventKind.COLLISION,
    ]
    m = measure(episode(track([0.0, 1.0]), events=tuple(Event(kind=k, step=1) for k in kinds)))
    assert (m.red_lights, m.stop_signs, m.lane_invasions, m.collided) == (2, 1, 1, True)


def test_off_road_metres_count_one_frame_longer_than_the_flag() -> None:
    m = measure(episode(track([0.0, 1.0, 2.0, 3.0, 4.0]), off=[False, False, True, False, False]))
    assert m.off_road == pytest.approx(2.0)


def test_acceleration_is_that_of_the_velocity_vector() -> None:
    m = measure(episode(track([0.0, 0.1, 0.3], speed=[1.0, 1.0, 2.0])))
    assert m.acceleration == pytest.approx((0 + 0 + 10) / 3)


def test_yaw_over_the_seam_counts_a_full_turn_in_paper_mode_only() -> None:
    heading = [math.pi - 0.1, math.pi + 0.1]
    m = measure(episode(track([0.0, 0.1], heading=heading)))
    assert m.yaw_rate_unwrapped == pytest.approx(0.2 / DT)
    assert m.yaw_rate == pytest.approx((2 * math.pi - 0.2) / DT)


def test_time_is_known_only_of_a_run_that_arrived() -> None:
    ego = track([0.0, 1.0, 2.0])
    assert measure(episode(ego, ending=Ending.ARRIVED)).time == pytest.approx(0.2)
    assert measure(episode(ego)).time is None


@pytest.mark.parametrize("mode", list(Mode))
@pytest.mark.parametrize(
    ("metric", "change", "expected"),
    [
        ("collision_rate", {"collided": True}, 0.5),
        ("red_light", {"red_lights": 1}, 0.5),
        ("stop_sign", {"stop_signs": 1}, 0.5),
        ("off_road", {"off_road": 10.0}, 0.1),
        ("route_following", {"distance_to_route": 2.0}, 0.8),
        ("completion", {"completion": 0.4}, 0.7),
        ("acceleration", {"acceleration": 4.0}, 0.25),
        ("lane_invasion", {"lane_invasions": 4}, 0.1),
    ],
)
def test_each_metric_by_hand_over_two_runs(mode: Mode, metric: str, change: dict[str, object], expected: float) -> None:
    assert getattr(score([BLANK, with_(**change)], mode=mode), metric) == pytest.approx(expected)


def test_time_spent_ignores_unfinished_runs_in_paper_mode_and_charges_them_in_corrected() -> None:
    runs = [BLANK, with_(time=None)]
    assert score(runs, mode=Mode.PAPER).time_spent == pytest.approx(0.5)
    assert score(runs, mode=Mode.CORRECTED).time_spent == pytest.approx(0.75)
    assert score([with_(time=None)], mode=Mode.PAPER).time_spent == 0.0
    assert score([with_(time=None)], mode=Mode.CORRECTED).time_spent == 1.0


def test_yaw_velocity_is_wrapped_in_paper_mode_and_not_in_corrected() -> None:
    runs = [with_(yaw_rate=1.5, yaw_rate_unwrapped=0.3)]
    assert score(runs, mode=Mode.PAPER).yaw_velocity == pytest.approx(0.5)
    assert score(runs, mode=Mode.CORRECTED).yaw_velocity == pytest.approx(0.1)


def test_paper_mode_does_not_clip_and_corrected_does() -> None:
    runs = [with_(red_lights=3)]
    assert score(runs, mode=Mode.PAPER).red_light == 3.0
    assert score(runs, mode=Mode.CORRECTED).red_light == 1.0


def test_nothing_cannot_be_scored() -> None:
    with pytest.raises(SettingsError):
        score([])


anything = st.builds(
    Measurements,
    collided=st.booleans(), red_lights=st.integers(0, 5), stop_signs=st.integers(0, 5),
    off_road=st.floats(0, 200), distance_to_route=st.floats(0, 30), completion=st.floats(0, 1),
    time=st.none() | st.floats(0, 100), acceleration=st.floats(0, 50), yaw_rate=st.floats(0, 50),
    yaw_rate_unwrapped=st.floats(0, 50), lane_invasions=st.integers(0, 100), duration=st.floats(0.1, 60),
)  # fmt: skip


@settings(max_examples=50)
@given(st.lists(anything, min_size=1, max_size=6))
def test_corrected_numbers_stay_between_nothing_and_all(runs: list[Measurements]) -> None:
    metrics = score(runs, mode=Mode.CORRECTED)
    assert all(0.0 <= getattr(metrics, name) <= 1.0 for name in metrics.__slots__)
    assert 0.0 <= metrics.overall_score <= 1.0


@settings(max_examples=50)
@given(anything, st.integers(1, 4))
def test_a_run_repeated_scores_like_itself(run: Measurements, times: int) -> None:
    assert score([run] * times).overall_score == pytest.approx(score([run]).overall_score)
    assert columns(run)["overall_score"] == score([run]).overall_score


def test_displacement_is_the_mean_distance_while_both_run() -> None:
    assert average_displacement(track([0.0, 1.0, 2.0]), track([0.0, 1.0], [3.0, 5.0])) == pytest.approx(4.0)


def test_the_wilson_interval_of_known_cases() -> None:
    assert wilson(0, 0) == (0.0, 1.0)
    low, high = wilson(8, 10)
    assert (low, high) == (pytest.approx(0.490, abs=0.001), pytest.approx(0.943, abs=0.001))
