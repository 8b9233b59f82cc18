import pytest
from hypothesis import given
from hypothesis import strategies as st

from chatscene.errors import SettingsError
from chatscene.search.refine import refine
from chatscene.search.sample import draw, scene_seed
from chatscene.search.select import Candidate, Selected, select
from chatscene.terms.snippet import ParameterRange

SPEED = ParameterRange(name="OPT_ADV_SPEED", low=0.0, high=5.0, unit="m/s")
GAP = ParameterRange(name="OPT_ADV_DISTANCE", low=0.0, high=15.0, unit="m")


def test_ranges_move_to_mean_and_population_deviation_rounded_to_two_places() -> None:
    moved = refine([SPEED], [{"OPT_ADV_SPEED": 1.0}, {"OPT_ADV_SPEED": 2.0}, {"OPT_ADV_SPEED": 4.0}])
    assert (moved[0].low, moved[0].high) == (1.09, 3.58)


def test_fewer_than_two_collisions_leave_the_declared_ranges() -> None:
    assert refine([SPEED, GAP], [{"OPT_ADV_SPEED": 1.0, "OPT_ADV_DISTANCE": 3.0}]) == (SPEED, GAP)


bounds = st.tuples(st.floats(-50, 50), st.floats(0, 50))


@given(bounds, st.lists(st.floats(0, 1), max_size=8))
def test_a_refined_range_never_leaves_the_declared_one(bound: tuple[float, float], shares: list[float]) -> None:
    low, width = bound
    declared = ParameterRange(name="OPT_X", low=low, high=low + width, unit="m")
    (moved,) = refine([declared], [{"OPT_X": declared.clip(low + share * width)} for share in shares])
    assert declared.low <= moved.low <= moved.high <= declared.high


@given(bounds, st.integers(0, 2**32 - 1))
def test_a_drawn_value_lies_in_its_range(bound: tuple[float, float], seed: int) -> None:
    low, width = bound
    declared = ParameterRange(name="OPT_X", low=low, high=low + width, unit="m")
    assert declared.low <= draw([declared], seed=seed)["OPT_X"] <= declared.high


def test_a_parameter_keeps_its_value_when_another_is_added() -> None:
    assert draw([SPEED], seed=7)["OPT_ADV_SPEED"] == draw([GAP, SPEED], seed=7)["OPT_ADV_SPEED"]


def test_scenes_have_seeds_of_their_own() -> None:
    seeds = {scene_seed(0, f"a/route-00/scene-{n:03d}") for n in range(500)} | {scene_seed(1, "a/route-00/scene-000")}
    assert len(seeds) == 501
    assert scene_seed(0, "a") == scene_seed(0, "a")


def candidate(name: str, collided: bool, score: float) -> Candidate:
    return Candidate(scene_id=name, collided=collided, overall_score=score)


def test_collisions_come_first_and_the_lowest_scores_among_them() -> None:
    kept = select(
        [
            candidate("a", False, 0.1),
            candidate("b", True, 0.5),
            candidate("c", True, 0.3),
            candidate("d", True, 0.4),
        ],
        count=2,
    )
    assert kept == (Selected(scene_id="c", fill_in=False), Selected(scene_id="d", fill_in=False))


def test_too_few_collisions_are_filled_up_and_flagged() -> None:
    kept = select([candidate("a", False, 0.9), candidate("b", True, 0.5), candidate("c", False, 0.7)], count=2)
    assert kept == (Selected(scene_id="b", fill_in=False), Selected(scene_id="c", fill_in=True))


def test_selection_does_not_depend_on_the_order_of_the_candidates() -> None:
    scenes = [candidate(name, True, 0.5) for name in "abcde"]
    assert select(scenes, count=2) == select(scenes[::-1], count=2)


def test_keeping_nothing_is_refused() -> None:
    with pytest.raises(SettingsError):
        select([], count=0)
