"""What a judge tells of tracks made by hand: who could meet, what nobody said, and numbers as they are measured."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from test_meaning import DT, EGO_SPEED, ROUTE, episode, moving

from chatscene.program.doing import ACTS
from chatscene.program.encounter import meeting, way_of
from chatscene.program.judge import Finding, failures, judge
from chatscene.program.watching import watch
from chatscene.terms.amount import Acceleration, Length, Speed
from chatscene.terms.arrays import Array
from chatscene.terms.episode import Episode, Event, EventKind, Role, SignalTrack, Track
from chatscene.terms.polyline import Polyline
from chatscene.terms.scenario import Maneuver
from chatscene.terms.situation import Contact, Deed, Ego, Other, Road, Situation, Start, When
from chatscene.terms.surroundings import Light
from chatscene.terms.vocabulary import (
    Act,
    EgoLight,
    EgoRoute,
    Facing,
    Part,
    RightOfWay,
    Side,
    Striker,
    UserKind,
    Where,
)
from chatscene.terms.vocabulary import Role as Plays

WALK = 2.0  # [m/s]


def walker(meets_at: float, seconds: float, *, speed: float = WALK) -> Track:
    """Somebody who walks over the road from the right and is in the middle of the ego's lane at a time."""
    return moving(meets_at, -speed * seconds, (200, speed, 90.0), facing=90.0, speed=speed, kind="Pedestrian")


def other(where: Where, *does: Deed, kind: UserKind = UserKind.CAR, name: str = "adversary", **start: object) -> Other:
    return Other(id=name, kind=kind, starts=Start(where=where, **start), does=does)  # type: ignore[arg-type]


def one(*others: Other, **facts: object) -> Situation:
    return Situation(others=others, **facts)  # type: ignore[arg-type]


CROSSES = one(other(Where.ROADSIDE, Deed(act=Act.CROSS), kind=UserKind.PEDESTRIAN))
BRAKES = one(other(Where.AHEAD, Deed(act=Act.BRAKE)))


def found(path: str, said: Situation, seen: Episode) -> Finding | None:
    return next((f for f in judge(said, seen, ROUTE) if f.path == path), None)


def shown(path: str, said: Situation, seen: Episode) -> bool | None:
    finding = found(path, said, seen)
    assert finding is not None, path
    return finding.shown


def with_ego(seen: Episode, speed: Array) -> Episode:
    """The same drive with an ego that goes straight on at other speeds."""
    ego = seen.ego_track
    x = np.concatenate(([0.0], np.cumsum(speed)[:-1])) * DT
    return replace(seen, tracks=(replace(ego, x=x, speed=speed), *seen.tracks[1:]))


# Whether they could meet


@pytest.mark.parametrize(("late", "meets"), [(-0.9, True), (0.0, True), (0.9, True), (-2.5, False), (2.5, False)])
def test_who_crosses_meets_the_ego_if_both_are_there_at_about_one_time(late: float, meets: bool) -> None:
    track = walker(48.0, 48.0 / EGO_SPEED + late)
    assert shown("encounter.adversary", CROSSES, episode(track)) is meets


def test_the_time_between_is_told_and_who_is_first() -> None:
    track = walker(48.0, 48.0 / EGO_SPEED + 2.5)
    ego = episode(track).ego_track
    seen = meeting(ego, way_of(ego, ROUTE.line), track, DT, 0)
    bodies = (0.95 + 0.3) / WALK + (2.25 + 0.3) / EGO_SPEED  # what their sizes take off
    assert seen.ego_first
    assert seen.between == pytest.approx(2.5 - bodies, abs=0.15)
    told = failures(judge(CROSSES, episode(track), ROUTE))
    assert told[-1].startswith("encounter.adversary: they could not meet: it is where their ways meet 1.6 s after")


def test_an_ego_that_stops_for_somebody_could_have_met_them() -> None:
    track = walker(48.0, 48.0 / EGO_SPEED)
    steps = len(track.x)
    brakes = np.concatenate((np.full(25, EGO_SPEED), np.linspace(EGO_SPEED, 0.0, 20), np.zeros(steps - 45)))
    seen = with_ego(episode(track), brakes)
    assert meeting(seen.ego_track, way_of(seen.ego_track, ROUTE.line), track, DT, 0).between == 0.0
    assert shown("encounter.adversary", CROSSES, seen) is True


def test_who_drives_away_before_the_ego_meets_nobody() -> None:
    pulls_out = one(other(Where.KERB, Deed(act=Act.PULL_OUT)))
    early = moving(60.0, -3.0, (10, 4.0, 20.0), (15, 6.0, 0.0), (150, 12.0, 0.0))
    late = moving(30.0, -3.0, (25, 0.0, 0.0), (10, 2.0, 20.0), (20, 3.0, 0.0), (150, 4.0, 0.0))
    assert shown("encounter.adversary", pulls_out, episode(early)) is False
    assert shown("encounter.adversary", pulls_out, episode(late)) is True


def struck(where: Where, *does: Deed) -> Situation:
    return one(other(where, *does), contact=Contact(whom="adversary", striker=Striker.OTHER))


@pytest.mark.parametrize(("speed", "meets"), [(EGO_SPEED, False), (EGO_SPEED + 0.1, False), (EGO_SPEED + 2.0, True)])
def test_who_only_keeps_its_distance_behind_the_ego_does_not_run_into_it(speed: float, meets: bool) -> None:
    follows = moving(-6.5, 0.0, (60, speed, 0.0), speed=speed)
    assert shown("encounter.adversary", struck(Where.BEHIND, Deed(act=Act.GO_ALONG)), episode(follows)) is meets


@pytest.mark.parametrize(("ahead", "meets"), [(42.0, False), (8.0, True)])
def test_who_backs_far_from_the_ego_does_not_back_into_it(ahead: float, meets: bool) -> None:
    backs = moving(ahead, 0.0, (20, 0.0, 0.0), (10, -1.5, 0.0), (20, -1.5, 0.0), (10, 0.0, 0.0))
    seen = with_ego(episode(backs), np.zeros(len(backs.x)))
    said = struck(Where.AHEAD, Deed(act=Act.STAND), Deed(act=Act.REVERSE))
    assert shown("encounter.adversary", said, seen) is meets


def test_a_leader_that_brakes_is_met_by_an_ego_that_goes_on() -> None:
    seen = episode(moving(20.0, 0.0, (40, 8.0, 0.0), (20, 0.0, 0.0), (100, 0.0, 0.0), speed=8.0))
    assert shown("encounter.adversary", BRAKES, seen) is True


def test_an_ego_that_steers_round_a_leader_that_brakes_could_have_met_it() -> None:
    seen = episode(moving(28.0, 0.0, (20, 0.0, 0.0), (180, 0.0, 0.0), speed=8.0))
    round_it = moving(0.0, 0.0, (25, 5.0, 0.0), (15, 4.0, 35.0), (15, 5.0, 0.0), (145, 8.0, 0.0), speed=8.0)
    steers = replace(round_it, actor=seen.ego_track.actor, role=seen.ego_track.role)
    seen = replace(seen, tracks=(steers, *seen.tracks[1:]))
    assert np.abs(steers.y).max() > 3.0
    assert shown("encounter.adversary", BRAKES, seen) is True


def test_who_need_not_meet_the_ego_is_not_asked_to() -> None:
    goes = one(other(Where.AHEAD, Deed(act=Act.GO_ALONG)))
    seen = episode(moving(30.0, 0.0, (150, 8.0, 0.0), speed=8.0))
    assert found("encounter.adversary", goes, seen) is None
    beside = episode(moving(0.0, -3.5, (150, 8.0, 0.0), speed=8.0))
    assert found("encounter.adversary", one(other(Where.BESIDE, Deed(act=Act.GO_ALONG))), beside) is None
    touches = one(other(Where.BESIDE, Deed(act=Act.GO_ALONG)), contact=Contact())
    assert shown("encounter.adversary", touches, beside) is False


def test_who_yields_need_not_meet_the_ego() -> None:
    yields = one(other(Where.ARM, Deed(act=Act.YIELD)))
    waits = moving(60.0, -30.0, (30, 6.0, 90.0), (20, 0.0, 90.0), (80, 0.0, 90.0), (80, 6.0, 90.0), facing=90, speed=6)
    assert found("encounter.adversary", yields, episode(waits)) is None


@pytest.mark.parametrize(("begins", "meets"), [(20.0, True), (0.0, False)])
def test_who_turns_round_beside_an_ego_that_has_gone_by_meets_nobody(begins: float, meets: bool) -> None:
    rounds = one(other(Where.AHEAD_BESIDE, Deed(act=Act.U_TURN), side=Side.RIGHT))
    track = moving(begins, -3.5, (20, 3.0, 0.0), (40, 3.0, 180.0), (100, 6.0, 180.0), speed=8.0)
    assert shown("others.adversary.does.0.act", rounds, episode(track)) is True
    assert shown("encounter.adversary", rounds, episode(track)) is meets


def test_what_the_ego_does_for_somebody_whom_it_does_not_meet_is_not_shown_but_no_reason_to_refuse() -> None:
    rounds = other(Where.AHEAD_BESIDE, Deed(act=Act.U_TURN), side=Side.RIGHT)
    answers = Ego(does=(Deed(act=Act.SWERVE, when=When(after="adversary.u-turn")),))
    said = Situation(ego=answers, others=(rounds,), contact=Contact(whom="adversary", happens=False))
    late = episode(moving(1.5, -3.5, (20, 3.0, 0.0), (40, 3.0, 180.0), (100, 6.0, 180.0), speed=8.0))
    y = np.interp(np.arange(len(late.ego_track.x)), (60, 70, 90), (0.0, 2.0, 0.0))
    late = replace(late, tracks=(replace(late.ego_track, y=y), *late.tracks[1:]))
    judged = judge(said, late, ROUTE)
    missed = [one.partition(":")[0] for one in failures(judged)]
    assert missed == ["ego.does.0.act", "contact.happens", "encounter.adversary"]
    assert not failures(judged, met=False)


@pytest.mark.parametrize(("where", "asked"), [(Where.ON_RAMP, True), (Where.BESIDE, False)])
def test_who_stops_in_front_stops_before_the_ego_has_gone_by(where: Where, asked: bool) -> None:
    stops = one(other(where, Deed(act=Act.STOP)))
    track = moving(2.0, -3.5, (30, 8.0, 0.0), (20, 0.0, 0.0), (100, 0.0, 0.0), speed=8.0)
    assert (found("encounter.adversary", stops, episode(track)) is not None) is asked
    ahead = replace(track, x=track.x + 60.0)
    assert found("encounter.adversary", stops, episode(ahead)) is None


def test_who_sets_off_the_other_way_when_the_ego_has_passed_is_too_late_though_it_goes_on_for_long() -> None:
    goes = Deed(act=Act.GO_ALONG, when=When(after="B.brake"))
    waits = one(other(Where.ONCOMING, goes), replace(other(Where.AHEAD, Deed(act=Act.BRAKE)), id="B"))
    comes = moving(30.0, 3.5, (80, 0.0, 180.0), (100, 8.0, 180.0), facing=180.0)
    leads = replace(moving(60.0, 0.0, (40, 8.0, 0.0), (20, 2.0, 0.0), (120, 2.0, 0.0), speed=8.0), actor="B")
    seen = episode(comes)
    finding = found("encounter.adversary", waits, replace(seen, tracks=(*seen.tracks, leads)))
    assert finding is not None
    assert finding.shown is False
    assert finding.told.endswith("s before it does its go-along")
    assert finding.late is not None
    assert finding.late.seconds > 3.0
    assert finding.late.metres < -20.0


@pytest.mark.parametrize(("brakes", "timely"), [(20, False), (75, True)])
def test_who_acts_after_the_ego_steered_acts_after_that_and_the_ego_after_what_it_waits_for(
    brakes: int, timely: bool
) -> None:
    steers = Ego(does=(Deed(act=Act.SWERVE, to=Side.LEFT, when=When(after="B.brake")),))
    follows = other(Where.BEHIND, Deed(act=Act.BRAKE, when=When(after="ego.swerve")))
    said = Situation(ego=steers, others=(follows, replace(other(Where.AHEAD, Deed(act=Act.BRAKE)), id="B")))
    seen = episode(
        moving(-12.0, 0.0, (brakes, EGO_SPEED, 0.0), (20, 0.0, 0.0), (160 - brakes, 0.0, 0.0), speed=EGO_SPEED)
    )
    leads = replace(moving(60.0, 0.0, (40, 8.0, 0.0), (20, 2.0, 0.0), (120, 2.0, 0.0), speed=8.0), actor="B")
    early = seen.ego_track
    y = np.interp(np.arange(len(early.x)), (5, 15, 25, 55, 75, 95), (0.0, 1.5, 0.0, 0.0, 2.5, 0.0))
    seen = replace(seen, tracks=(replace(early, y=y), seen.tracks[1], leads))
    steered = found("ego.does.0.act", said, seen)
    assert steered is not None
    assert (steered.shown, round(steered.at or 0.0, 1)) == (True, 5.8)
    assert shown("others.adversary.does.0.when.after", said, seen) is timely


def test_who_drifts_over_behind_the_ego_meets_it_only_by_coming_nearer() -> None:
    drifts = one(other(Where.BEHIND_BESIDE, Deed(act=Act.DRIFT, to=Side.LEFT), side=Side.RIGHT))
    over = ((20, 1.0, 0.0), (20, 1.0, 10.0), (20, 1.0, 0.0), (120, 1.0, 0.0))
    slower = moving(-10.0, -3.5, *((n, fast * (EGO_SPEED - 1.0), to) for n, fast, to in over), speed=EGO_SPEED - 1.0)
    faster = moving(-16.0, -3.5, *((n, fast * (EGO_SPEED + 4.0), to) for n, fast, to in over), speed=EGO_SPEED + 4.0)
    assert shown("encounter.adversary", drifts, episode(slower)) is False
    assert shown("encounter.adversary", drifts, episode(faster)) is True


def test_a_drive_that_ends_with_somebody_else_did_not_come_to_the_encounter() -> None:
    seen = episode(walker(100.0, 100.0 / EGO_SPEED - 5.0), contact=10)
    elsewhere = replace(seen, events=(replace(seen.events[0], other="B"),))
    assert shown("encounter.adversary", replace(CROSSES, contact=Contact()), elsewhere) is None


# What nobody said


def test_a_contact_with_somebody_who_is_not_the_adversary_is_told() -> None:
    both = one(*CROSSES.others, replace(other(Where.BEHIND, name="B"), role=Plays.SUPPORTING))
    seen = episode(walker(48.0, 6.0), contact=10)
    seen = replace(seen, events=(replace(seen.events[0], other="B"),))
    assert shown("unasked.contact", both, seen) is False
    assert found("unasked.contact", CROSSES, episode(walker(48.0, 6.0), contact=55)) is None


@pytest.mark.parametrize("role", [Plays.SUPPORTING, Plays.HIDES])
def test_two_others_whose_bodies_are_in_each_other_are_told(role: Plays) -> None:
    stands = replace(other(Where.AHEAD, Deed(act=Act.STAND), name="B"), role=role)
    both = one(other(Where.AHEAD, Deed(act=Act.GO_ALONG)), stands)
    still = replace(moving(50.0, 0.0, (100, 0.0, 0.0)), actor="B")
    for aside, told in ((0.0, False), (3.5, None)):
        seen = episode(moving(30.0, aside, (100, 8.0, 0.0), speed=8.0))
        finding = found("unasked.adversary-B", both, replace(seen, tracks=(*seen.tracks, still)))
        assert (None if finding is None else finding.shown) is told


def test_a_light_or_a_sign_that_the_ego_runs_is_told_if_nobody_gave_it_one() -> None:
    seen = episode(walker(48.0, 6.0))
    for kind, road in ((EventKind.RED_LIGHT, Road(ego_light=EgoLight.RED)), (EventKind.STOP_SIGN, SIGN)):
        runs = replace(seen, events=(Event(kind=kind, step=20),))
        assert shown(f"unasked.{kind}", CROSSES, runs) is False
        assert found(f"unasked.{kind}", replace(CROSSES, road=road), runs) is None


SIGN = Road(control=RightOfWay.STOP_SIGN)


def test_two_who_drive_through_each_other_are_told() -> None:
    a = moving(20.0, 0.0, (100, 8.0, 0.0), speed=8.0)
    b = replace(moving(60.0, 0.0, (100, 0.0, 0.0)), actor="B", role=Role.BACKGROUND)
    both = one(other(Where.AHEAD, Deed(act=Act.GO_ALONG)), other(Where.AHEAD, Deed(act=Act.STAND), name="B"))
    seen = episode(a)
    assert shown("unasked.adversary-B", both, replace(seen, tracks=(*seen.tracks, b))) is False
    aside = replace(b, y=b.y - 3.0)
    assert found("unasked.adversary-B", both, replace(seen, tracks=(*seen.tracks, aside))) is None


def test_a_leader_that_brakes_more_often_than_was_said_is_told() -> None:
    brakes = (10, 4.0, 0.0), (30, 8.0, 0.0), (10, 8.0, 0.0), (20, 0.0, 0.0), (50, 0.0, 0.0)
    seen = episode(moving(20.0, 0.0, *brakes, speed=8.0))
    assert shown("unasked.adversary", BRAKES, seen) is False
    twice = one(other(Where.AHEAD, Deed(act=Act.BRAKE), Deed(act=Act.BRAKE)))
    assert found("unasked.adversary", twice, seen) is None


def test_who_goes_along_and_leaves_its_lane_is_told() -> None:
    goes = one(other(Where.AHEAD, Deed(act=Act.GO_ALONG)))
    leaves = moving(20.0, 0.0, (30, 8.0, 0.0), (10, 8.0, 20.0), (15, 8.0, 0.0), (60, 8.0, 0.0), speed=8.0)
    assert shown("unasked.adversary.lane", goes, episode(leaves)) is False
    stays = moving(20.0, 0.0, (120, 8.0, 0.0), speed=8.0)
    assert found("unasked.adversary.lane", goes, episode(stays)) is None


def test_who_keeps_its_lane_while_the_ego_changes_its_own_has_left_none_and_taken_no_exit() -> None:
    over = np.column_stack([np.arange(300.0), 3.5 * np.clip((np.arange(300.0) - 60.0) / 40.0, 0.0, 1.0)])
    route = replace(ROUTE, line=Polyline(over), maneuver=Maneuver.LANE_CHANGE_LEFT, event_at=60.0)
    goes = one(other(Where.AHEAD, Deed(act=Act.GO_ALONG)), ego=Ego(route=EgoRoute.LANE_CHANGE_LEFT))
    for left in (0.0, 3.5):  # in the lane that the ego leaves, and in the one that it comes to
        stays = moving(20.0, left, (120, 8.0, 0.0), speed=8.0)
        told = [f.told for f in judge(goes, episode(stays), route) if f.path.startswith("unasked")]
        assert not told
        assert not list(ACTS[Act.EXIT](watch(episode(stays), route, stays)))
    leaves = moving(20.0, 0.0, (30, 8.0, 0.0), (10, 8.0, 20.0), (15, 8.0, 0.0), (60, 8.0, 0.0), speed=8.0)
    (told,) = (f.told for f in judge(goes, episode(leaves), route) if f.path == "unasked.adversary.lane")
    assert told.startswith("adversary leaves its line by ")


# Numbers


def test_a_distance_is_from_nose_to_tail_of_who_goes_the_same_way_and_else_between_the_middles() -> None:
    seen = episode(moving(24.5, 0.0, (40, 8.0, 0.0), (20, 0.0, 0.0), (40, 0.0, 0.0), speed=8.0))
    said = one(other(Where.AHEAD, Deed(act=Act.BRAKE), distance=Length.of("20 m")))
    finding = found("others.adversary.starts.distance", said, seen)
    assert finding is not None
    assert finding.shown
    assert finding.told == "said 20 m, it starts this far: 20.0 from nose to tail"
    apart = one(other(Where.ROADSIDE, Deed(act=Act.CROSS), kind=UserKind.PEDESTRIAN, distance=Length.of("48 m")))
    finding = found("others.adversary.starts.distance", apart, episode(walker(48.0, 6.0)))
    assert finding is not None
    assert finding.told.endswith("48.0 between the middles")


def test_the_distance_of_who_is_beyond_a_junction_is_from_there() -> None:
    through = replace(ROUTE, junction="junction", event_at=60.0, exit_at=80.0)
    for where, kind, across in ((Where.EXIT, UserKind.CAR, 0.0), (Where.EXIT_CROSSING, UserKind.PEDESTRIAN, -6.0)):
        said = one(other(where, Deed(act=Act.STAND), kind=kind, distance=Length.of("5 m")))
        for along, right in ((85.0, True), (5.0, False)):
            seen = episode(moving(along, across, (60, 0.0, 0.0), kind=kind.scenic))
            (finding,) = (f for f in judge(said, seen, through) if f.path.endswith("starts.distance"))
            assert finding.shown is right
            assert finding.told.endswith("beyond the junction")
        (unknown,) = (f for f in judge(said, seen, replace(through, exit_at=None)) if f.path.endswith("distance"))
        assert unknown.shown is None, "where nobody knows where the junction ends"


def test_braking_is_its_mean_and_not_its_peak() -> None:
    track = moving(30.0, 0.0, (20, 8.0, 0.0), (12, 2.0, 0.0), (2, 0.0, 0.0), (60, 0.0, 0.0), speed=8.0)

    def said(amount: str) -> bool | None:
        deed = Deed(act=Act.BRAKE, acceleration=Acceleration.of(amount))
        return shown("others.adversary.does.0.acceleration", one(other(Where.AHEAD, deed)), episode(track))

    assert said("5.7 m/s²") is True  # 8 m/s in 1.4 s, at last with 10 m/s²
    assert said("10 m/s²") is False


def test_a_speed_is_held_and_not_passed() -> None:
    passes = moving(30.0, 0.0, (20, 8.0, 0.0), (20, 0.0, 0.0), (60, 0.0, 0.0), speed=8.0)
    holds = moving(30.0, 0.0, (20, 8.0, 0.0), (10, 4.0, 0.0), (60, 4.0, 0.0), speed=8.0)
    said = one(other(Where.AHEAD, Deed(act=Act.BRAKE, speed=Speed.of("4 m/s"))))
    assert shown("others.adversary.does.0.speed", said, episode(passes)) is False
    assert shown("others.adversary.does.0.speed", said, episode(holds)) is True


def test_who_brakes_from_a_high_speed_holds_none_on_the_way() -> None:
    brakes = moving(60.0, 0.0, (20, 20.0, 0.0), (40, 0.0, 0.0), (20, 0.0, 0.0), speed=20.0)  # with 5 m/s²
    said = one(other(Where.AHEAD, Deed(act=Act.BRAKE, speed=Speed.of("14 m/s"))))
    assert shown("others.adversary.does.0.speed", said, episode(brakes)) is False


# Starts, lights, deeds to others, contacts


def test_which_way_somebody_faces_is_seen() -> None:
    for facing, right in ((Facing.ACROSS, True), (Facing.ALONG, False), (Facing.AGAINST, False)):
        said = one(other(Where.ROADSIDE, Deed(act=Act.CROSS), kind=UserKind.PEDESTRIAN, facing=facing))
        assert shown("others.adversary.starts.facing", said, episode(walker(48.0, 6.0))) is right


@pytest.mark.parametrize(
    ("light", "state", "right"),
    [
        (EgoLight.GREEN, "g" * 200, True),
        (EgoLight.GREEN, "r" * 200, False),
        (EgoLight.RED, "r" * 200, True),
        (EgoLight.TURNS_GREEN, "r" * 50 + "g" * 150, True),
        (EgoLight.TURNS_GREEN, "g" * 200, False),
        (EgoLight.TURNS_RED, "g" * 50 + "y" * 20 + "r" * 130, True),
    ],
)
def test_the_light_that_the_ego_has_is_seen(light: EgoLight, state: str, right: bool) -> None:
    seen = episode(walker(48.0, 6.0))
    own = SignalTrack(x0=40.0, y0=-2.0, x1=40.0, y1=2.0, state=state, role="ego")
    said = replace(CROSSES, road=Road(ego_light=light))
    assert shown("road.ego_light", said, replace(seen, signals=(own,))) is right
    assert shown("road.ego_light", said, replace(seen, signals=())) is False


def test_who_comes_into_the_lane_behind_the_ego_does_not_cut_in() -> None:
    cuts_in = one(other(Where.BEHIND_BESIDE, Deed(act=Act.CUT_IN), side=Side.RIGHT))
    behind = moving(-15.0, -3.5, (20, 8.0, 0.0), (10, 8.0, 20.0), (12, 8.0, 0.0), (60, 8.0, 0.0), speed=8.0)
    ahead = replace(behind, x=behind.x + 30.0)
    path = "others.adversary.does.0.act"
    assert shown(path, cuts_in, episode(behind)) is False
    assert shown(path, cuts_in, episode(ahead)) is True


def test_who_overtakes_somebody_gets_by_that_one() -> None:
    overtakes = Deed(act=Act.OVERTAKE, whom="B")
    both = one(other(Where.ONCOMING, overtakes), other(Where.ONCOMING, Deed(act=Act.GO_ALONG), name="B"))
    comes = replace(moving(150.0, 3.5, (82, 6.0, 180.0), facing=180, speed=6.0), actor="B", role=Role.BACKGROUND)
    out = ((10, 10.0, 200.0), (12, 10.0, 180.0))
    passes = moving(165.0, 3.5, *out, (60, 12.0, 180.0), facing=180, speed=10.0)
    stays = moving(165.0, 3.5, (10, 6.0, 210.0), (14, 6.0, 180.0), (58, 6.0, 180.0), facing=180, speed=6.0)
    for track, right in ((passes, True), (stays, False)):
        seen = episode(track)
        assert shown("others.adversary.does.0.act", both, replace(seen, tracks=(*seen.tracks, comes))) is right


def test_an_ego_that_overtakes_gets_by_somebody() -> None:
    said = one(other(Where.AHEAD, Deed(act=Act.GO_ALONG)), ego=Ego(route=EgoRoute.OVERTAKE))
    fast, slow = (moving(20.0, 0.0, (150, speed, 0.0), speed=speed) for speed in (10.0, 4.0))
    told = "ego.route: said overtake, it gets by nobody"
    assert told in failures(judge(said, episode(fast), ROUTE))
    assert told not in failures(judge(said, episode(slow), ROUTE))


def test_who_hides_somebody_does_so_when_that_one_comes_out() -> None:
    child = moving(60.0, -6.0, (45, 0.0, 90.0), (5, 2.0, 90.0), (60, 2.0, 90.0), facing=90.0, kind="Pedestrian")
    said = one(replace(CROSSES.others[0], hidden_by="B"), other(Where.KERB, Deed(act=Act.STAND), name="B"))
    seen = episode(child)
    for x, right in ((55.0, True), (30.0, False)):  # the ego has gone by the other when the child comes out
        thing = replace(moving(x, -3.5, (110, 0.0, 0.0)), actor="B", role=Role.OCCLUDER)
        assert shown("others.adversary.hidden_by", said, replace(seen, tracks=(*seen.tracks, thing))) is right


def test_the_part_of_the_other_that_is_touched_is_judged() -> None:
    track = moving(40.0, -16.0, (100, 4.0, 90.0), facing=90.0, speed=4.0)
    seen = episode(track, contact=41)
    for part, right in ((Part.LEFT, True), (Part.RIGHT, False), (Part.FRONT, False)):
        said = one(other(Where.ARM, Deed(act=Act.GO_STRAIGHT)), contact=Contact(other=part))
        assert shown("contact.other", said, seen) is right


def test_light_is_judged_and_what_no_track_tells_says_so() -> None:
    said = replace(CROSSES, around=replace(CROSSES.around, light=Light.NIGHT), road=Road(lanes=2))
    seen = episode(walker(48.0, 6.0))
    assert shown("around.light", said, seen) is False
    finding = found("road.lanes", said, seen)
    assert finding == Finding(path="road.lanes", shown=None, told="not judged from tracks")
