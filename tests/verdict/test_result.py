"""The last line of a verdict says what decides it, and what a good number leaves open."""

from __future__ import annotations

from chatscene.verdict.result import in_a_line
from chatscene.verdict.verdict import Draw, Fact, Seen, Verdict

DRIVES = 10


def fact(path: str, shown: int, of: int = DRIVES, *, untold: bool = False, instead: str = "") -> Fact:
    """A fact that the first drives that came to it show."""
    seen = tuple(
        Seen(draw=n, shown=None if untold or n >= of else n < shown, told=instead, at=None) for n in range(DRIVES)
    )
    return Fact(path=path, said="so", seen=seen, untold=untold, instead=instead)


def verdict(*facts: Fact, unasked: tuple[Fact, ...] = (), dead: tuple[str, ...] = ()) -> str:
    wrong = {seen.draw for one in (*facts, *unasked) for seen in one.seen if seen.shown is False}
    draws = tuple(
        Draw(number=n, begin=0.0, seconds=9.0, ending="over", missing=("lacks",) * (n in wrong)) for n in range(DRIVES)
    )
    made = Verdict(
        what="it", kind="program", told="A.", situation={}, draws=draws, facts=facts, unasked=unasked, dead=dead
    )
    return in_a_line(made)


KIND, ACT = fact("others.A.kind", 10), fact("others.A.does.0.act", 9)


def test_a_verdict_of_drives_that_show_all_of_it_says_no_more() -> None:
    assert verdict(KIND) == "shown: 10 of 10 drives show all of it"
    assert verdict(fact("others.A.kind", 0)) == "not shown: 0 of 10 drives show all of it"


def test_what_no_drive_came_to_stands_beside_the_number_of_those_that_show_all() -> None:
    never = verdict(KIND, fact("contact.happens", 0, of=0))
    assert never == ("shown: 10 of 10 drives show all of it, except what they did not reach (contact.happens)")
    some = verdict(KIND, fact("contact.happens", 2, of=2))
    assert some.endswith("what they did not reach (contact.happens in 8 of them)")


def test_what_no_track_tells_stands_there_too_and_a_long_list_is_counted() -> None:
    lanes = [fact(f"road.{name}", 0, untold=True) for name in ("lanes", "ego_lane", "setting", "two_way", "has")]
    assert verdict(KIND, *lanes).endswith(
        "except what tracks cannot show (road.lanes, road.ego_lane, road.setting, road.two_way and 1 more)"
    )


def test_what_nobody_said_is_named_first_where_it_alone_decides() -> None:
    aside = fact("unasked.A.lane", 2, instead="A leaves its line by 2.3 m, which the text does not say")
    assert verdict(KIND, ACT, unasked=(aside,)) == (
        "not shown: A leaves its line by 2.3 m, which the text does not say (8 of 10 drives); "
        "9 of 10 drives show all that was said"
    )
    rare = fact("unasked.A.lane", 8, instead="A goes aside")
    assert verdict(KIND, unasked=(rare,)) == "shown: 8 of 10 drives show all of it"


def test_a_scene_that_is_none_is_named_first() -> None:
    assert verdict(KIND, dead=("the ego never moves",)) == (
        "not shown: the ego never moves; 10 of 10 drives show all that was said"
    )
