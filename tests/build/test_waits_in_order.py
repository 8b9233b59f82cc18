"""Who waits for a deed of somebody waits for that one, and not for what was seen before it."""

from __future__ import annotations

import re
from typing import Any

import pytest

from chatscene.build.build import build
from chatscene.errors import NotBuilt
from chatscene.situations.file import read_text
from chatscene.situations.form import from_plain


def deeds(*does: Any) -> list[dict[str, Any]]:
    return [{"act": deed} if isinstance(deed, str) else deed for deed in does]


def waits(start: dict[str, Any], *does: Any, road: dict[str, Any] | None = None, **when: Any) -> list[str]:
    """What A waits for, one after the other, that is seen of B."""
    last = {"act": "brake", "when": when}
    first = {"id": "A", "kind": "car", "starts": {"where": "ahead"}, "does": [last]}
    second = {"id": "B", "kind": "car", "role": "supporting", "starts": start, "does": deeds(*does)}
    said = {"ego": {"speed": "50 km/h"}, "road": road or {}, "others": [first, second]}
    text = build(from_plain(said)).program.source.partition("behavior DoesA():")[2].partition("\nA = ")[0]
    return [one for one in re.findall(r" until (.*)$", text, re.MULTILINE) if re.search(r"\bB\b", one)]


KERB, AHEAD = {"where": "kerb", "side": "right"}, {"where": "ahead-beside", "side": "right"}


def test_who_stands_first_has_gone_before_it_is_seen_to_stop() -> None:
    assert waits(KERB, "stand", "pull-out", "stop", after="B.stop") == ["B.pose[3] > 0.3", "B.pose[3] < 0.1"]


def test_a_second_stop_is_waited_for_behind_the_first_and_behind_setting_off() -> None:
    stops = ({"act": "stop", "time": "2 s"}, "set-off", "stop")
    assert waits(AHEAD, *stops, after="B.2") == ["B.pose[3] < 0.1", "B.pose[3] > 0.3", "B.pose[3] < 0.1"]


def test_what_lasts_is_done_when_the_next_deed_is_seen() -> None:
    assert waits(AHEAD, {"act": "go-along", "time": "5 s"}, "brake", after="B.go-along") == ["B.pose[3] < 0.8 * 13.9"]
    assert waits(AHEAD, {"act": "stand", "time": "3 s"}, "set-off", after="B.stand") == ["B.pose[3] > 0.5"]


def test_who_goes_at_a_speed_brakes_from_that() -> None:
    goes = {"act": "go-along", "speed": "20 km/h", "time": "3 s"}
    assert waits(AHEAD, goes, "brake", during="B.brake") == ["B.pose[3] < 0.8 * 5.56"]


@pytest.mark.parametrize(
    ("does", "when"),
    [
        (({"act": "slow-down", "speed": "20 km/h"}, "brake"), {"during": "B.brake"}),
        (("go-along",), {"after": "B.go-along"}),
    ],
)
def test_what_cannot_be_told_from_what_goes_before_is_refused(does: tuple[Any, ...], when: dict[str, Any]) -> None:
    with pytest.raises(NotBuilt, match=r"others\.A\.does\.0\.when\.(after|during)"):
        waits(AHEAD, *does, **when)


def test_who_goes_over_to_a_lane_farther_off_is_seen_to_leave_its_own() -> None:
    road = {"lanes": 3, "ego_lane": 1}
    change = {"act": "lane-change", "to": "left"}
    start = {"where": "ahead-beside", "side": "left"}
    assert waits(start, change, road=road, after="B.lane-change") == ["abs(offsetFrom(wayB, B)) > 2.2"]


@pytest.mark.parametrize("when", [{"during": "A.0", "delay": "3 s"}, {"after": "A.0", "delay": "1 s"}])
def test_a_delay_that_counts_from_another_moment_than_the_end_of_the_deed_before_is_refused(
    when: dict[str, str],
) -> None:
    does = deeds({"act": "brake", "time": "1 s"}, "accelerate", {"act": "stop", "when": when})
    with pytest.raises(NotBuilt, match=r"others\.A\.does\.2\.when\.delay.*say it after A\.1"):
        build(from_plain({"others": [{"id": "A", "kind": "car", "starts": {"where": "ahead"}, "does": does}]}))


def test_a_later_deed_of_the_egos_wheel_waits_for_a_phase_of_another() -> None:
    later = {"act": "swerve", "to": "right", "when": {"after": "A.stop"}}
    swerves = [{"act": "swerve", "to": "left", "when": {"ego_within": "40 m", "of": "A"}}, later]
    ahead = {"id": "A", "kind": "car", "starts": {"where": "ahead"}, "does": deeds("stop")}
    source = build(from_plain({"ego": {"speed": "50 km/h", "does": swerves}, "others": [ahead]})).program.source
    assert re.search(r"Order\(since=[\d.]+, till=[\d.]+, aside=-2.6, whom='A', phase=\d", source)


@pytest.mark.parametrize(
    ("first", "second", "phases"),
    [
        ("cut-in", "cut-out", ("< 1.3", "> 2.2")),
        ("lane-change, to: left", "lane-change, to: right", ("> 2.2", "< 1.3")),
    ],
)
def test_who_waits_for_a_second_movement_waits_for_the_first_one_before(
    first: str, second: str, phases: tuple[str, str]
) -> None:
    where = "ahead" if "left" in first else "ahead-beside, side: left"
    source = build(
        read_text(
            f"others:\n- {{id: A, kind: car, starts: {{where: {where}}},"
            f" does: [{{act: {first}}}, {{act: {second}}}]}}\n"
            "- {id: B, kind: car, role: supporting, starts: {where: behind},"
            " does: [{act: go-along}, {act: brake, when: {after: A.1}}]}"
        )
    ).program.source
    assert tuple(re.findall(r"offsetFrom\(egoRoute, A\)\) (.*)", source)) == phases


def test_who_waits_until_somebody_has_slowed_waits_for_the_speed_that_was_said() -> None:
    source = build(
        read_text(
            "ego: {speed: 50 km/h}\nothers:\n"
            "- {id: A, kind: car, starts: {where: ahead}, does: [{act: slow-down, speed: 40 km/h}]}\n"
            "- {id: B, kind: car, role: supporting, starts: {where: ahead-beside, side: left},"
            " does: [{act: go-along}, {act: brake, when: {after: A.0}}]}"
        )
    ).program.source
    assert "until A.pose[3] < 11.4" in source  # on the way from 13.9 to 11.1 m/s
