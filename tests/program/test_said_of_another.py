"""What a false claim was once called shown for: standing, an ego that comes over, going back, what a contact cut."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
from test_doing import SWINGS, does
from test_encounter import BRAKES, ROUTE, episode, found, moving, one, other, shown

import chatscene
from chatscene.build.build import build
from chatscene.program.doing import ACTS
from chatscene.program.watching import watch
from chatscene.situations.file import read_text
from chatscene.terms.amount import Length, Speed
from chatscene.terms.episode import Event, EventKind, Track
from chatscene.terms.polyline import Polyline
from chatscene.terms.scenario import Maneuver
from chatscene.terms.situation import Deed, Ego, When
from chatscene.terms.vocabulary import Act, Breach, UserKind, Where

ALONG = np.arange(0.0, 121.0, 1.0)
SWUNG = replace(
    ROUTE,
    maneuver=Maneuver.BYPASS,
    line=Polyline(np.column_stack([ALONG, 3.5 * np.clip((ALONG - 30.0) / 15.0, 0.0, 1.0)])),
)
"""A route that swings out into the next lane."""
STARTS_LATE = moving(40.0, -6.0, (15, 0.0, 90.0), (5, 1.4, 90.0), (60, 1.4, 90.0), facing=90.0, kind="Pedestrian")
BACKS_UP = moving(30.0, 0.0, (15, 0.0, 0.0), (10, 0.0, 0.0), (10, -2.0, 0.0), (20, -2.0, 0.0), speed=8.0)


def test_an_ego_that_comes_over_makes_nobody_enter_its_lane() -> None:
    against = moving(110.0, 3.5, (80, 8.0, 180.0), facing=180.0, speed=8.0)
    assert not does(Act.ENTER, against, SWUNG)
    assert not does(Act.ENTER, moving(110.0, 1.7, (80, 8.0, 180.0), facing=180.0, speed=8.0))


def test_who_stands_at_first_does_not_go_at_a_low_speed() -> None:
    for said, right in (("2 km/h", False), ("5 km/h", True)):
        walks = other(Where.ROADSIDE, Deed(act=Act.CROSS, speed=Speed.of(said)), kind=UserKind.PEDESTRIAN)
        assert shown("others.adversary.does.0.speed", one(walks), episode(STARTS_LATE)) is right


def test_a_speed_that_is_held_below_what_was_said_is_not_on_its_way_when_a_contact_comes() -> None:
    goes = one(other(Where.AHEAD, Deed(act=Act.GO_ALONG, speed=Speed.of("60 km/h"))))
    held = moving(30.0, 0.0, (60, 8.0, 0.0), speed=8.0)
    gains = moving(30.0, 0.0, (60, 14.0, 0.0), speed=3.0)
    for track, right in ((held, False), (gains, None)):
        assert shown("others.adversary.does.0.speed", goes, episode(track, contact=55)) is right


def test_to_go_back_is_told_where_nobody_said_it() -> None:
    assert shown("unasked.adversary.back", BRAKES, episode(BACKS_UP)) is False
    said = one(other(Where.AHEAD, Deed(act=Act.BRAKE), Deed(act=Act.REVERSE)))
    assert found("unasked.adversary.back", said, episode(BACKS_UP)) is None


def test_a_car_that_comes_back_to_its_line_has_not_turned_back() -> None:
    assert not does(Act.TURN_BACK, SWINGS)


def test_an_exit_begins_when_somebody_leaves_for_good() -> None:
    out_and_back = ((6, 8.0, 20.0), (6, 8.0, 20.0), (6, 8.0, 0.0), (6, 8.0, -20.0), (6, 8.0, -20.0), (6, 8.0, 0.0))
    leaves = moving(20.0, 0.0, *out_and_back, (10, 8.0, 0.0), (10, 8.0, 20.0), (60, 8.0, 20.0), speed=8.0)
    exits = list(ACTS[Act.EXIT](watch(episode(leaves), ROUTE, leaves)))
    assert [once.began > 30 for once in exits] == [True]


def test_a_deed_that_a_contact_with_somebody_else_cut_short_is_not_reached(tmp_path: Path) -> None:
    rows = ["time,id,kind,x,y,heading,speed,ego"]
    for step in range(60):
        now = step / 10
        aside = 3.5 - max(0.0, now - 3.0)
        rows.append(f"{now},car1,car,{10 * now},0,0,10,1")
        rows.append(f"{now},stands,truck,42,0,0,0,0")
        rows.append(f"{now},comes,van,{5 + 10 * now},{aside},{-math.atan(0.1) * (now > 3.0)},10,0")
    (tmp_path / "drive.csv").write_text("\n".join(rows))
    said = read_text(
        "others:\n"
        "- {id: A, kind: truck, starts: {where: ahead}, does: [{act: stand}]}\n"
        "- {id: B, kind: van, starts: {where: beside, side: left}, does: [{act: cut-in}]}"
    )
    verdict = chatscene.verify(tmp_path / "drive.csv", said)
    cut = next(fact for fact in verdict.facts if fact.path == "others.B.does.0.act")
    assert cut.judged == ()
    assert "a contact came before it was done" in cut.seen[0].told


def _built(text: str) -> str:
    return build(read_text(text)).program.source


def test_what_is_built_shows_what_it_was_found_to_lack() -> None:
    out = _built(
        "others: [{id: A, kind: car, starts: {where: driveway, side: right},"
        " does: [{act: enter}, {act: stop}, {act: reverse}]}]"
    )
    assert "do ReverseStraight(globalParameters.OPT_A_BACK) for globalParameters.OPT_A_BACK_TIME seconds" in out
    back = _built(
        "others: [{id: A, kind: child, starts: {where: roadside, side: left},"
        " does: [{act: cross, speed: 2.88 km/h}, {act: turn-back, manner: fast}]}]"
    )
    assert "do MoveAhead(0.8) until" in back
    assert "do MoveAhead(globalParameters.OPT_A_SPEED_1, 3.14159)" in back
    against = _built(
        "{ego: {route: lane-change-left}, others: [{id: A, kind: motorcycle,"
        " starts: {where: oncoming-in-our-lane}, does: [{act: go-along}]}]}"
    )
    assert "wayA = lastLane(egoRoute)" in against
    assert "param signals = 'ego-green'" in _built(
        "{ego: {route: straight}, road: {kind: junction}, others: [{id: A, kind: van, starts: {where: behind}}]}"
    )


def _called(track: Track, name: str) -> Track:
    return replace(track, actor=name)


def test_a_distance_between_two_others_is_measured_up_to_the_contact() -> None:
    behind = _called(moving(12.0, 0.0, (100, 8.0, 0.0), speed=8.0), "A")
    before = _called(moving(40.0, 0.0, (100, 8.0, 0.0), speed=8.0), "B")
    alone = episode(behind, contact=60, through=True)  # as the ladder drives, which goes on
    seen = replace(alone, tracks=(*alone.tracks, before))
    follows = one(
        other(Where.AHEAD, Deed(act=Act.FOLLOW, whom="B", distance=Length.of("24 m")), name="A"),
        other(Where.AHEAD, Deed(act=Act.GO_ALONG), name="B"),
    )
    assert shown("others.A.does.0.distance", follows, seen) is not None


def test_a_deed_to_somebody_who_is_not_there_is_not_shown() -> None:
    alone = episode(_called(moving(12.0, 0.0, (100, 8.0, 0.0), speed=8.0), "A"))
    overtakes = one(
        other(Where.AHEAD, Deed(act=Act.OVERTAKE, whom="B"), name="A"),
        other(Where.AHEAD, Deed(act=Act.BRAKE, when=When(ego_within=Length.of("10 m"), of="C")), name="B"),
    )
    assert shown("others.A.does.0.act", overtakes, alone) is False
    assert shown("others.B.kind", overtakes, alone) is False


def test_the_only_one_who_is_there_is_somebody_although_two_were_said(tmp_path: Path) -> None:
    rows = ["time,id,kind,x,y,heading,speed,ego"]
    for step in range(100):
        rows += [f"{step / 10},me,car,{step},0,0,10,1", f"{step / 10},it,car,{20 + step},0,0,10,0"]
    (tmp_path / "drive.csv").write_text("\n".join(rows))
    said = read_text(
        "others:\n"
        "- {id: A, kind: car, starts: {where: ahead}, does: [{act: go-along}]}\n"
        "- {id: B, kind: pedestrian, starts: {where: roadside, side: left}, does: [{act: cross}]}"
    )
    assert chatscene.verify(tmp_path / "drive.csv", said).who["A"] == "it"


def test_what_is_told_of_a_rule_that_is_broken_is_what_is_seen() -> None:
    said = replace(BRAKES, ego=Ego(does=(Deed(act=Act.GO_ALONG, breaks=Breach.RED_LIGHT),)))
    drive = episode(moving(40.0, 0.0, (100, 8.0, 0.0), speed=8.0), contact=50)
    for step, right in ((30, True), (70, None)):  # the second is after the contact
        ran = Event(step=step, kind=EventKind.RED_LIGHT)
        seen = found("ego.does.0.breaks", said, replace(drive, events=(*drive.events, ran)))
        assert seen is not None
        assert seen.shown is right
        assert ("breaks" in seen.told) is (right is True)
