import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from chatscene.errors import SettingsError
from chatscene.search.select import Candidate, Selected, select

few = settings(max_examples=60)


def candidate(
    scene_id: str,
    collided: bool,
    score: float,
    avoidable: bool = True,
    *,
    shown: bool = True,
    kind: str = "",
    waits: bool = False,
    cut: int = 0,
    touch: bool | None = None,
    distance: float | None = None,
    happened: bool = True,
    near: float | None = None,
) -> Candidate:
    return Candidate(
        scene_id=scene_id,
        collided=collided,
        shown=shown,
        avoidable=avoidable if collided else None,
        overall_score=score,
        crash_type=kind,
        waits=waits,
        cut=cut,
        touch=touch,
        distance=distance,
        happened=happened,
        near=near,
    )


def test_a_collision_that_shows_what_was_said_is_kept_before_one_that_does_not() -> None:
    unlike, like, calm = candidate("a", True, 0.1, shown=False), candidate("b", True, 0.3), candidate("c", False, 0.05)
    assert [s.scene_id for s in select([unlike, like, calm], count=1)] == ["b"]
    assert [s.scene_id for s in select([unlike, like, calm], count=2)] == ["b", "c"]
    assert [s.scene_id for s in select([unlike, like, calm], count=1, selection="worst")] == ["a"]


def test_a_drive_that_shows_what_was_said_is_kept_before_a_collision_that_does_not() -> None:
    unlike, calm = candidate("a", True, 0.1, shown=False), candidate("b", False, 0.9)
    assert [s.scene_id for s in select([unlike, calm], count=1)] == ["b"]
    assert [s.scene_id for s in select([unlike, calm], count=1, selection="worst")] == ["a"]


def test_the_papers_rule_does_not_look_at_what_was_shown() -> None:
    crowd = [candidate(name, True, score, shown=name in "ac") for name, score in zip("abcd", (4, 3, 2, 1), strict=True)]
    assert [s.scene_id for s in select(crowd, count=2, selection="worst")] == ["c", "d"]
    assert [s.scene_id for s in select(crowd, count=2)] == ["a", "c"]


def test_a_crash_nobody_could_have_avoided_is_left_out_where_avoidable_ones_are_asked_for() -> None:
    hopeless, fair = candidate("a", True, 0.1, avoidable=False), candidate("b", True, 0.3)
    calm = candidate("c", False, 0.9)
    kept = select([hopeless, fair, calm], count=2, avoidable_only=True)
    assert kept == (Selected(scene_id="b", fill_in=False), Selected(scene_id="c", fill_in=True))
    assert [s.scene_id for s in select([hopeless, fair, calm], count=2)] == ["a", "b"]


def test_an_avoidable_crash_is_kept_before_one_that_nobody_avoids_if_it_shows_what_was_read() -> None:
    hopeless, fair = candidate("a", True, 0.1, avoidable=False), candidate("b", True, 0.9)
    assert [s.scene_id for s in select([hopeless, fair], count=1)] == ["b"]
    assert [s.scene_id for s in select([hopeless, fair], count=1, selection="shown")] == ["a"]
    unlike = candidate("c", True, 0.0, shown=False)
    assert [s.scene_id for s in select([hopeless, unlike], count=1)] == ["a"]


def test_one_of_each_kind_of_crash_is_kept_before_a_second_of_any() -> None:
    front, again, rear = (
        candidate(n, True, s, kind=k) for n, s, k in (("a", 0.1, "f"), ("b", 0.2, "f"), ("c", 0.3, "r"))
    )
    assert [s.scene_id for s in select([front, again, rear], count=2)] == ["a", "c"]
    assert [s.scene_id for s in select([front, again, rear], count=2, selection="shown")] == ["a", "b"]
    assert len(select([front, again, rear], count=3)) == 3


def test_a_second_avoidable_crash_of_a_kind_is_kept_before_another_kind_that_nobody_avoids() -> None:
    fair, again = candidate("a", True, 0.1, kind="f"), candidate("b", True, 0.2, kind="f")
    hopeless = candidate("c", True, 0.0, avoidable=False, kind="r")
    assert [s.scene_id for s in select([fair, again, hopeless], count=2)] == ["a", "b"]


def test_a_drive_in_which_the_ego_only_waits_is_kept_only_where_there_is_nothing_else() -> None:
    waiting, calm = candidate("a", False, 0.1, waits=True), candidate("b", False, 0.9)
    assert select([waiting, calm], count=1) == (Selected(scene_id="b", fill_in=True),)
    assert select([waiting], count=1) == (Selected(scene_id="a", fill_in=True),)
    assert [s.scene_id for s in select([waiting, calm], count=1, selection="worst")] == ["a"]


crowds = st.lists(
    st.builds(
        candidate,
        st.integers(0, 99).map(lambda n: f"scene-{n:03d}"),
        st.booleans(),
        st.sampled_from([0.2, 0.4, 0.4, 0.6, 0.8]),
        st.booleans(),
        shown=st.booleans(),
        kind=st.sampled_from("abc"),
    ),
    max_size=12,
    unique_by=lambda c: c.scene_id,
)


def test_collisions_come_first_and_the_lowest_scores_among_them() -> None:
    scenes = [
        candidate("a", False, 0.1),
        candidate("b", True, 0.5),
        candidate("c", True, 0.3),
        candidate("d", True, 0.4),
    ]
    kept = select(scenes, count=2)
    assert kept == (Selected(scene_id="c", fill_in=False), Selected(scene_id="d", fill_in=False))


def test_too_few_collisions_are_filled_up_with_the_lowest_scores_and_flagged() -> None:
    scenes = [candidate("a", False, 0.9), candidate("b", True, 0.95), candidate("c", False, 0.7)]
    kept = select(scenes, count=2)
    assert kept == (Selected(scene_id="b", fill_in=False), Selected(scene_id="c", fill_in=True))


def test_without_any_collision_everything_kept_is_a_fill_in() -> None:
    kept = select([candidate("a", False, 0.9), candidate("b", False, 0.7)], count=1)
    assert kept == (Selected(scene_id="b", fill_in=True),)


def test_what_is_kept_stands_in_the_order_of_ids_not_of_scores() -> None:
    kept = select([candidate("z", True, 0.1), candidate("a", True, 0.2)], count=2)
    assert [each.scene_id for each in kept] == ["a", "z"]


def test_equal_scores_are_decided_by_id() -> None:
    scenes = [candidate(name, True, 0.5) for name in "dbca"]
    assert [each.scene_id for each in select(scenes, count=2)] == ["a", "b"]


@few
@given(crowds, st.integers(1, 5))
def test_selection_does_not_depend_on_the_order_of_the_candidates(crowd: list[Candidate], count: int) -> None:
    assert select(crowd, count=count) == select(iter(crowd[::-1]), count=count)


@few
@given(crowds, st.integers(1, 5))
def test_as_many_are_kept_as_asked_for_or_as_there_are(crowd: list[Candidate], count: int) -> None:
    kept = select(crowd, count=count)
    assert len(kept) == min(count, len(crowd))
    assert {each.scene_id for each in kept if not each.fill_in} <= {each.scene_id for each in crowd if each.collided}


@few
@given(crowds, st.integers(1, 5))
def test_nothing_left_out_is_worth_more_than_anything_kept(crowd: list[Candidate], count: int) -> None:
    kept = {each.scene_id for each in select(crowd, count=count)}
    worth = {c.scene_id: (not c.shown, not c.collided, c.avoidable is False) for c in crowd}
    inside = [worth[name] for name in worth if name in kept]
    outside = [worth[name] for name in worth if name not in kept]
    assert not outside or max(inside) <= min(outside)


@pytest.mark.parametrize("count", [0, -1])
def test_keeping_nothing_is_refused(count: int) -> None:
    with pytest.raises(SettingsError, match="at least one"):
        select([], count=count)


def test_where_no_contact_was_said_the_nearest_drive_without_one_is_kept_and_is_no_fill_in() -> None:
    hit = candidate("a", True, 0.1, shown=False, touch=False)
    near = candidate("b", False, 0.9, touch=False, distance=0.4)
    far = candidate("c", False, 0.2, touch=False, distance=6.0)
    assert select([hit, near, far], count=1) == (Selected(scene_id="b", fill_in=False),)
    assert [s.scene_id for s in select([hit, near, far], count=2, selection="shown")] == ["b", "c"]
    unlike = candidate("d", False, 0.2, shown=False, touch=False, distance=6.0)
    assert select([hit, unlike], count=1) == (Selected(scene_id="d", fill_in=False),)
    assert [s.scene_id for s in select([hit, near, far], count=1, selection="worst")] == ["a"]


def test_a_drive_in_which_all_is_seen_to_its_end_is_kept_before_one_that_a_contact_cut_short() -> None:
    cut, whole, calm = candidate("a", True, 0.1, cut=2), candidate("b", True, 0.9), candidate("c", False, 0.9)
    assert [s.scene_id for s in select([cut, whole, calm], count=1)] == ["b"]
    assert [s.scene_id for s in select([cut, calm], count=1)] == ["c"]
    assert [s.scene_id for s in select([cut, calm], count=1, selection="worst")] == ["a"]


def test_a_drive_in_which_something_happened_is_kept_before_one_in_which_nothing_did_and_the_nearest_first() -> None:
    dull, near = candidate("a", False, 0.1, happened=False), candidate("b", False, 0.9, near=1.4)
    nearer, crash = candidate("c", False, 0.9, near=0.8), candidate("d", True, 0.95)
    assert [s.scene_id for s in select([dull, near], count=1)] == ["b"]
    assert [s.scene_id for s in select([dull, near, nearer], count=1)] == ["c"]
    assert [s.scene_id for s in select([dull, near, nearer, crash], count=2)] == ["c", "d"]
    assert [s.scene_id for s in select([dull, near, nearer, crash], count=2, selection="worst")] == ["a", "d"]
    assert [s.scene_id for s in select([dull], count=2)] == ["a"], "nothing better is there"
