import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from chatscene.errors import SettingsError
from chatscene.measure.score import COLUMNS, average_displacement, columns, measure, score, wilson
from chatscene.terms.episode import Ending, Episode, Event, EventKind, Role, Track
from chatscene.terms.metrics import Measurements, Metrics, Mode

DT = 0.1
few = settings(max_examples=50)


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
    ego: Track | None = None,
    *,
    kinds: tuple[EventKind, ...] = (),
    ending: Ending = Ending.TIMEOUT,
    completion: float = 0.5,
    off: list[bool] | None = None,
    distance: list[float] | None = None,
) -> Episode:
    ego = ego or track([0.0] * 5)
    steps = len(ego.x)
    return Episode(
        scene_id="s", ego="e", dt=DT, tracks=(ego,), signals=(), ending=ending, route_completion=completion,
        events=tuple(Event(kind=kind, step=1) for kind in kinds),
        distance_to_route=np.array(distance or [0.0] * steps), off_road=np.array(off or [False] * steps),
    )  # fmt: skip


ARRIVED = episode(ending=Ending.ARRIVED, completion=1.0)
STUCK = episode(completion=0.4)

# Each row: a metric, the episodes, and its value by hand in paper and in corrected mode.
BY_HAND: list[tuple[str, list[Episode], float, float]] = [
    ("collision_rate", [episode(kinds=(EventKind.COLLISION,)), ARRIVED, STUCK, STUCK], 0.25, 0.25),
    ("red_light", [episode(kinds=(EventKind.RED_LIGHT,)), ARRIVED], 0.5, 0.5),
    ("red_light", [episode(kinds=(EventKind.RED_LIGHT,) * 3), ARRIVED], 1.5, 1.0),
    ("stop_sign", [episode(kinds=(EventKind.STOP_SIGN,)), ARRIVED, ARRIVED, STUCK], 0.25, 0.25),
    ("stop_sign", [episode(kinds=(EventKind.STOP_SIGN,) * 2)], 2.0, 1.0),
    # 5 m a step; the flag is up in one row, so the steps into it and out of it count: 10 m of 50.
    ("off_road", [episode(track([0, 5, 10, 15, 20]), off=[False, False, True, False, False])], 0.2, 0.2),
    ("off_road", [episode(track([0, 3, 3], [0, 4, 9]), off=[True, False, False]), ARRIVED], 0.05, 0.05),
    ("off_road", [episode(track([0, 60]), off=[True, True])], 1.2, 1.0),
    ("route_following", [episode(distance=[1.0, 2.0, 3.0, 2.0, 2.0]), ARRIVED], 0.8, 0.8),
    ("route_following", [episode(distance=[7.0] * 5)], 0.0, 0.0),
    ("completion", [ARRIVED, STUCK], 0.7, 0.7),
    # 60 steps of 0.1 s are 6 s, a tenth of a minute.
    ("time_spent", [episode(track([0.0] * 61), completion=1.0)], 0.1, 0.1),
    ("time_spent", [episode(track([0.0] * 61), completion=1.0), STUCK], 0.1, 0.55),
    ("time_spent", [STUCK, STUCK], 0.0, 1.0),
    ("time_spent", [episode(track([0.0] * 901), completion=1.0)], 1.5, 1.0),
    # 0 then 0.8 m/s in 0.1 s: 0 and 8 m/s², on average half of 8.
    ("acceleration", [episode(track([0, 0, 0], speed=[1.0, 1.0, 1.8]))], 0.5, 0.5),
    # Steady 0.4 m/s, turned by 60°: the velocity changes by as much as it is.
    ("acceleration", [episode(track([0, 0], heading=[0, math.pi / 3], speed=[0.4, 0.4]))], 0.5, 0.5),
    ("acceleration", [episode(track([0, 0], speed=[2.0, 0.0]))], 2.5, 1.0),
    # 0.06 rad there and 0.06 rad back in 0.2 s: 0.6 rad/s.
    ("yaw_velocity", [episode(track([0, 0, 0], heading=[0.0, 0.06, 0.0]))], 0.2, 0.2),
    # The same over the seam at ±π: two full turns more, less what was turned.
    ("yaw_velocity", [episode(track([0, 0, 0], heading=[3.12, 3.18, 3.12]))], (4 * math.pi - 0.12) / 0.6, 0.2),
    ("lane_invasion", [episode(kinds=(EventKind.LANE_INVASION,) * 8), ARRIVED], 0.2, 0.2),
    ("lane_invasion", [episode(kinds=(EventKind.LANE_INVASION,) * 30)], 1.5, 1.0),
]  # fmt: skip


@pytest.mark.parametrize(("metric", "episodes", "paper", "corrected"), BY_HAND)
def test_each_metric_is_what_the_hand_computes(
    metric: str, episodes: list[Episode], paper: float, corrected: float
) -> None:
    measured = [measure(each) for each in episodes]
    assert getattr(score(measured, mode=Mode.PAPER), metric) == pytest.approx(paper)
    assert getattr(score(measured, mode=Mode.CORRECTED), metric) == pytest.approx(corrected)


def test_every_metric_has_a_case_by_hand() -> None:
    assert {metric for metric, *_ in BY_HAND} == set(Metrics.__slots__) == set(COLUMNS)


def test_counts_of_different_events_do_not_mix() -> None:
    kinds = (EventKind.RED_LIGHT, EventKind.RED_LIGHT, EventKind.STOP_SIGN, EventKind.LANE_INVASION, EventKind.OFF_ROAD)
    m = measure(episode(kinds=kinds))
    assert (m.red_lights, m.stop_signs, m.lane_invasions, m.collided) == (2, 1, 1, False)


@few
@given(st.lists(st.floats(-0.3, 0.3), min_size=1, max_size=30), st.floats(-10, 10))
def test_the_two_yaw_rates_differ_by_what_crossing_the_seam_adds(turns: list[float], start: float) -> None:
    heading = np.cumsum([start, *turns])
    if np.abs(np.remainder(heading, 2 * math.pi) - math.pi).min() < 1e-5:
        return  # on the seam itself
    m = measure(episode(track([0.0] * len(heading), heading=heading.tolist())))
    crossed = np.diff(np.floor((heading - math.pi) / (2 * math.pi))) != 0
    added = (2 * math.pi - 2 * np.abs(np.diff(heading)[crossed])).sum()
    assert (m.yaw_rate - m.yaw_rate_unwrapped) * m.duration == pytest.approx(added, abs=1e-4)


def test_the_seam_belongs_to_the_side_it_has_in_carla() -> None:
    # Heading due west is yaw +180° there; a little counter-clockwise of it is +179.9°, clockwise -179.9°.
    under = measure(episode(track([0, 0], heading=[math.pi, math.pi - 1e-3])))
    over = measure(episode(track([0, 0], heading=[math.pi, math.pi + 1e-3])))
    assert under.yaw_rate == pytest.approx((2 * math.pi - 1e-3) / DT, rel=1e-4)
    assert over.yaw_rate == pytest.approx(1e-3 / DT, rel=1e-2)


def test_rounding_on_a_road_due_west_turns_nobody() -> None:
    m = measure(episode(track([0.0] * 4, heading=[math.pi, math.pi - 1e-11, math.pi + 1e-11, math.pi])))
    assert m.yaw_rate == pytest.approx(0.0, abs=1e-9)


def test_an_episode_that_ended_before_its_first_step_is_measured_as_nothing() -> None:
    m = measure(episode(track([3.0], speed=[5.0]), kinds=(EventKind.COLLISION,), completion=0.0))
    assert (m.duration, m.acceleration, m.yaw_rate, m.yaw_rate_unwrapped, m.off_road) == (0, 0, 0, 0, 0)


def test_nothing_cannot_be_scored() -> None:
    with pytest.raises(SettingsError, match="no episode"):
        score([])


def test_the_overall_score_of_perfect_driving_is_one_and_of_the_worst_nothing() -> None:
    perfect = Metrics(
        collision_rate=0, red_light=0, stop_sign=0, off_road=0, route_following=1,
        completion=1, time_spent=0, acceleration=0, yaw_velocity=0, lane_invasion=0,
    )  # fmt: skip
    worst = Metrics(**{name: 1 - getattr(perfect, name) for name in Metrics.__slots__})
    for level in ("safety_level", "functionality_level", "etiquette_level", "overall_score"):
        assert getattr(perfect, level) == pytest.approx(1.0)
        assert getattr(worst, level) == pytest.approx(0.0)


anything = st.builds(
    Measurements,
    collided=st.booleans(), red_lights=st.integers(0, 5), stop_signs=st.integers(0, 5),
    off_road=st.floats(0, 200), distance_to_route=st.floats(0, 30), completion=st.floats(0, 1),
    time=st.none() | st.floats(0, 100), acceleration=st.floats(0, 50), yaw_rate=st.floats(0, 50),
    yaw_rate_unwrapped=st.floats(0, 50), lane_invasions=st.integers(0, 100), duration=st.floats(0.1, 60),
)  # fmt: skip
modes = st.sampled_from(list(Mode))


@few
@given(st.lists(anything, min_size=1, max_size=6))
def test_corrected_numbers_stay_between_nothing_and_all(runs: list[Measurements]) -> None:
    metrics = score(runs, mode=Mode.CORRECTED)
    assert all(0.0 <= getattr(metrics, name) <= 1.0 for name in Metrics.__slots__)
    for level in ("safety_level", "functionality_level", "etiquette_level", "overall_score"):
        assert -1e-12 <= getattr(metrics, level) <= 1.0 + 1e-12


@few
@given(st.lists(anything, min_size=1, max_size=6), modes)
def test_one_more_collision_lowers_the_overall_score(runs: list[Measurements], mode: Mode) -> None:
    safe = [replace(run, collided=False) for run in runs]
    hit = [replace(safe[0], collided=True), *safe[1:]]
    assert score(hit, mode=mode).overall_score < score(safe, mode=mode).overall_score


@few
@given(st.lists(anything, min_size=1, max_size=6), modes)
def test_arriving_never_scores_worse_than_not_arriving_in_corrected_mode(runs: list[Measurements], mode: Mode) -> None:
    late = [replace(run, time=run.duration) for run in runs]
    never = [replace(run, time=None) for run in runs]
    arrived, failed = score(late, mode=mode), score(never, mode=mode)
    if mode is Mode.CORRECTED:
        assert arrived.overall_score >= failed.overall_score
    else:
        assert arrived.overall_score < failed.overall_score  # the quirk: failing costs no time


@few
@given(anything, st.integers(1, 4), modes)
def test_a_run_repeated_scores_like_itself(run: Measurements, times: int, mode: Mode) -> None:
    repeated, once = score([run] * times, mode=mode), score([run], mode=mode)
    for name in Metrics.__slots__:
        assert getattr(repeated, name) == pytest.approx(getattr(once, name))


@few
@given(st.lists(anything, min_size=2, max_size=6), modes)
def test_the_order_of_the_runs_does_not_matter(runs: list[Measurements], mode: Mode) -> None:
    assert score(runs, mode=mode) == score(runs[::-1], mode=mode)


@few
@given(anything)
def test_the_columns_of_a_run_are_its_paper_metrics(run: Measurements) -> None:
    row, metrics = columns(run), score([run], mode=Mode.PAPER)
    assert list(row) == ["cr", "rr", "ss", "or", "rf", "comp", "ts", "acc", "yv", "li", "overall_score"]
    assert row["overall_score"] == metrics.overall_score
    assert all(row[column] == getattr(metrics, name) for name, column in COLUMNS.items())
    assert all(type(value) is float for value in row.values())


def test_displacement_is_the_mean_distance_while_both_run() -> None:
    assert average_displacement([track([0, 1, 2]), track([0, 1], [3, 5])]) == pytest.approx(4.0)


def test_displacement_averages_over_every_pair() -> None:
    still = [track([0, 0]), track([3, 3]), track([9, 9])]
    assert average_displacement(still) == pytest.approx((3 + 6 + 9) / 3)


def test_displacement_of_one_track_is_refused() -> None:
    with pytest.raises(SettingsError, match="pairs"):
        average_displacement([track([0.0])])


def test_the_wilson_interval_of_known_cases() -> None:
    assert wilson(0, 0) == (0.0, 1.0)
    assert wilson(8, 10) == pytest.approx((0.4902, 0.9433), abs=1e-4)
    assert wilson(0, 10) == pytest.approx((0.0, 0.2775), abs=1e-4)
    assert wilson(5, 10, z=1.0) == pytest.approx((0.3492, 0.6508), abs=1e-4)


@few
@given(st.integers(1, 500), st.floats(0, 1), st.floats(0, 4))
def test_a_wilson_interval_holds_its_rate_and_stays_a_rate(trials: int, share: float, z: float) -> None:
    successes = round(share * trials)
    low, high = wilson(successes, trials, z)
    assert 0.0 <= low <= successes / trials <= high <= 1.0
    mirrored = wilson(trials - successes, trials, z)
    assert (1 - mirrored[1], 1 - mirrored[0]) == pytest.approx((low, high), abs=1e-9)


@pytest.mark.parametrize(("successes", "trials"), [(3, 2), (-1, 2), (0, -1)])
def test_impossible_counts_make_no_rate(successes: int, trials: int) -> None:
    with pytest.raises(SettingsError, match="no rate"):
        wilson(successes, trials)
