"""A situation and a drive: which facts are seen on the tracks, when, and which are not.

Tracks, map and lights alone are read, never a program's text. What has no test here has no finding: which way somebody
faces, lanes, the ego's light, an opened door.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import partial

import numpy as np

from chatscene.program.contacts import SIDES_OF, striker_of
from chatscene.program.deeds import ACTIONS, MOVING, STANDING, Act
from chatscene.program.doing import (
    ACTS,
    TO_SOMEBODY,
    accelerates,
    enters,
    gone_back,
    moved_left,
    room_left,
    since,
    standing,
    stood,
)
from chatscene.program.meaning import (
    EGO_STATES,
    TOGETHER,
    in_between,
    is_place,
    left_of_ego,
    maneuver_of,
)
from chatscene.program.starting import STARTS
from chatscene.program.watching import Seen, watch
from chatscene.terms.actors import manner_of
from chatscene.terms.acts import Action
from chatscene.terms.amount import Amount, Duration
from chatscene.terms.episode import Array, Episode, Track
from chatscene.terms.route import Route
from chatscene.terms.routing import CONTROLS, PLACES
from chatscene.terms.scenario import EgoState, Maneuver
from chatscene.terms.situation import EGO, SEVERAL, Deed, Other, Situation, When
from chatscene.terms.vocabulary import COMES_IN, FROM_NOSE, Breach, EgoRoute, Manner, RoadKind, Side, Where
from chatscene.terms.vocabulary import Act as Said

SLACK = 0.15  # of a number that was said: what a watcher does not see
SLACK_SPEED, SLACK_LENGTH, SLACK_TIME = 0.7, 2.0, 0.5  # [m/s], [m], [s]: the least of it
BACK_SLACK = 0.7  # [m]
OVER = 5  # [steps] over which a deceleration is seen


@dataclass(frozen=True, slots=True, kw_only=True)
class Finding:
    """What a drive shows of a fact.

    Attributes:
        path: The fact.
        shown: Whether it is seen; None where the drive did not come to it.
        told: What was said, and what is seen, in words.
        at: When it is seen [s]; None for what has no moment.
    """

    path: str
    shown: bool | None
    told: str = ""
    at: float | None = None


def judge(situation: Situation, episode: Episode, route: Route, *, through: bool = False) -> tuple[Finding, ...]:
    """What a drive shows of a situation, up to the first contact of the ego.

    Args:
        situation: What was said.
        episode: What happened; a road user of the situation has its id for a name, several have it with a number.
        route: The ego's route.
        through: Judge to the end a drive that went on through a collision.
    """
    return tuple(_Judge(situation, episode, route, through).findings())


def failures(findings: Iterable[Finding]) -> tuple[str, ...]:
    """What is not shown, a sentence each; empty if the drive means what was said."""
    return tuple(f"{one.path}: {one.told}" for one in findings if one.shown is False)


_ROUTES: dict[EgoRoute | None, tuple[Maneuver, ...]] = {
    EgoRoute.STRAIGHT: (Maneuver.STRAIGHT,),
    EgoRoute.LEFT_TURN: (Maneuver.LEFT_TURN,),
    EgoRoute.RIGHT_TURN: (Maneuver.RIGHT_TURN,),
    EgoRoute.TURN: (Maneuver.LEFT_TURN, Maneuver.RIGHT_TURN),
    EgoRoute.LANE_CHANGE_LEFT: (Maneuver.LANE_CHANGE_LEFT,),
    EgoRoute.LANE_CHANGE_RIGHT: (Maneuver.LANE_CHANGE_RIGHT,),
    EgoRoute.LANE_CHANGE: (Maneuver.LANE_CHANGE_LEFT, Maneuver.LANE_CHANGE_RIGHT),
    EgoRoute.BYPASS: (Maneuver.BYPASS,),
    EgoRoute.OVERTAKE: (Maneuver.BYPASS,),
}
_EGO_ACTS = {
    Said.STOP: EgoState.STOPS,
    Said.SLOW_DOWN: EgoState.SLOWS_DOWN,
    Said.BRAKE: EgoState.BRAKES,
}


@dataclass(slots=True)
class _Judge:
    situation: Situation
    episode: Episode
    route: Route
    through: bool
    waits: list[tuple[str, When, Act, Seen]] = field(default_factory=list[tuple[str, When, Act, Seen]])

    @property
    def contact(self) -> int | None:
        """The step of the first contact, after which nothing is judged."""
        return self.episode.collision.step if self.episode.collision is not None and not self.through else None

    def findings(self) -> Iterator[Finding]:
        yield from self._of_road()
        ego = self.situation.ego
        until = None if self.contact is None else self.contact + 1
        speed = self.episode.ego_track.speed[:until]
        if ego.speed is not None:
            yield self._number("ego.speed", ego.speed, speed, SLACK_SPEED, "drives at", most=True)
        for k, deed in enumerate(ego.does):
            yield from self._of_ego(f"ego.does.{k}.act", deed, speed)
        done: dict[str, Act] = {}
        for one in sorted(self.situation.others, key=_waits_for_others):  # who is waited for first
            yield from self._of_other(one, done)
        for path, when, once, seen in self.waits:  # once it is known when everybody did what
            yield from self._when(path, when, once, seen, done)
        yield from self._of_contact()

    # The road and the ego

    def _of_road(self) -> Iterator[Finding]:
        route, road = self.situation.ego.route, self.situation.road
        goes = maneuver_of(self.route)
        if route in _ROUTES:
            yield Finding(path="ego.route", shown=goes in _ROUTES[route], told=f"said {route}, its route goes {goes}")
        if road.control is not None and road.control in CONTROLS:
            there = self.route.control
            right = there is CONTROLS[road.control]
            yield Finding(path="road.control", shown=right, told=f"said {road.control}, the junction has {there}")
        if road.kind is not None and road.kind in PLACES:
            right = is_place(PLACES[road.kind], self.route)
            right = right or (road.kind is RoadKind.ROAD and self.route.junction is None)
            yield Finding(
                path="road.kind", shown=right, told=f"said {road.kind}, the route lies on a {self.route.place}"
            )

    def _of_ego(self, path: str, deed: Deed, speed: Array) -> Iterator[Finding]:
        dt, first = self.episode.dt, self.situation.ego.does[0] is deed
        stood = bool(speed[: round(1.0 / dt)].max() < STANDING)
        course = f"it drives at {speed[0]:.1f} m/s at first and {speed.max():.1f} at most"
        if deed.act is Said.STAND and first:
            yield Finding(path=path, shown=stood, told=f"said stand, {course}", at=0.0)
        elif deed.act is Said.SET_OFF:
            still = np.flatnonzero(speed < STANDING)
            off = bool(still.size and (speed[still[0] :] > MOVING).any())
            yield Finding(path=path, shown=off or None, told=f"said set-off, {course}")
        elif deed.act in _EGO_ACTS:
            state = _EGO_ACTS[deed.act]
            if deed.act is Said.BRAKE and (deed.speed is not None or deed.time is not None):
                state = EgoState.SLOWS_DOWN  # as much as was said, which may be less than half
            yield Finding(path=path, shown=EGO_STATES[state](speed, dt), told=f"said {deed.act}, {course}")

    # Somebody else

    def _of_other(self, one: Other, done: dict[str, Act]) -> Iterator[Finding]:
        at = f"others.{one.id}"
        tracks = self._tracks(one.id)
        if not tracks:
            yield Finding(path=f"{at}.kind", shown=False, told=f"there is no {one.id}")
            return
        body = one.kind.scenic
        kind = tracks[0].kind
        known = kind == body or (one.kind.row.general and manner_of(kind) in (one.kind.moves, None))
        yield Finding(path=f"{at}.kind", shown=known, told=f"said {one.kind}, it is a {kind}")
        enough = len(tracks) > 1 if one.count == SEVERAL else len(tracks) == one.count
        yield Finding(path=f"{at}.count", shown=enough, told=f"said {one.count or 'several'}, there are {len(tracks)}")
        seen = watch(self.episode, self.route, tracks[0], self.contact)
        yield from self._start(one, at, seen)
        yield from self._deeds(one, at, seen, done)

    def _start(self, one: Other, at: str, seen: Seen) -> Iterator[Finding]:
        start = one.starts
        where = f"it starts {seen.lead[0]:.1f} m ahead, {abs(seen.across[0]):.1f} m {_side(seen.across[0])}"
        hides = any(other.hidden_by == one.id for other in self.situation.others)
        if start.where in STARTS and not hides:
            right = bool(STARTS[start.where](seen))
            yield Finding(path=f"{at}.starts.where", shown=right, told=f"said {start.where}, {where}", at=0.0)
        if start.side is not None and start.where is not Where.EXIT_CROSSING:
            left = left_of_ego(seen, self.route)
            right = (left > 0) == (start.side is Side.LEFT)
            yield Finding(path=f"{at}.starts.side", shown=right, told=f"said {start.side}, {where}", at=0.0)
        if start.distance is not None and start.where not in (Where.ARM, Where.ONCOMING):
            nose = 0.5 * (seen.ego.length + seen.track.length) if start.where in FROM_NOSE else 0.0
            lead = np.abs(seen.lead[:1]) - nose
            yield self._number(
                f"{at}.starts.distance", start.distance, lead, SLACK_LENGTH, "starts this far:", cut=False
            )
        if start.speed is not None:
            speed = np.abs(seen.track.speed[:3])
            yield self._number(f"{at}.starts.speed", start.speed, speed, SLACK_SPEED, "starts at", cut=False)
        if one.hidden_by is not None:
            yield Finding(
                path=f"{at}.hidden_by",
                shown=self._hidden(one.hidden_by, seen),
                told=f"said hidden by {one.hidden_by}, which is never between it and the ego",
            )

    def _hidden(self, by: str, seen: Seen) -> bool:
        moved = np.hypot(seen.track.x - seen.track.x[0], seen.track.y - seen.track.y[0])
        steps = np.flatnonzero(moved < 1.0)[::3].tolist()
        return any(in_between(thing, seen.ego, seen.track, step) for thing in self._tracks(by) for step in steps)

    def _deeds(self, one: Other, at: str, seen: Seen, done: dict[str, Act]) -> Iterator[Finding]:
        latest, before, mine = 0, "", list[Act]()
        for k, deed in enumerate(one.does):
            path, act = f"{at}.does.{k}", deed.act
            if act not in ACTS:
                continue
            found = [once for once in self._seen(one, k, seen, latest) if once not in mine or act is Said.STAND]
            lasts = act.row.lasting and act is not Said.STAND
            after = [once for once in found if lasts or once.began >= latest - TOGETHER / seen.dt]
            if not after:
                never = "never does" if self.contact is None else "had not begun to when the ego crashed"
                told = f"said {act}, but it {never}"
                if found:
                    told = f"said {before}, then {act}, but it does it the other way round"
                yield Finding(path=f"{path}.act", shown=False, told=told)
                continue
            once = self._fitting(path, deed, [one for one in after if _due(deed, one, done, seen)] or after, seen)
            mine.append(once)  # one time seen is one deed
            done[f"{one.id}.{k}"] = once
            done.setdefault(f"{one.id}.{act}", once)
            if not act.row.lasting:
                latest, before = max(latest, once.began), str(act)
            yield Finding(path=f"{path}.act", shown=True, told=f"said {act}", at=once.began * seen.dt)
            if deed.to is not None and act in (Said.SWERVE, Said.DRIFT):
                left = moved_left(seen, once)
                right = (left > 0) == (deed.to is Side.LEFT)
                yield Finding(path=f"{path}.to", shown=right, told=f"said {deed.to}, it goes to the {_side(left)}")
            yield from self._amounts(path, deed, once, seen)
            if deed.manner is Manner.SLANTING:
                slants = any(True for _ in ACTIONS[Action.DIAGONAL](seen))
                yield Finding(path=f"{path}.manner", shown=slants, told="said slanting, it goes straight over")
            if deed.breaks is Breach.RED_LIGHT:
                ran = any(True for _ in ACTIONS[Action.RUN_LIGHT](seen))
                yield Finding(
                    path=f"{path}.breaks",
                    shown=ran or (None if self.contact is not None else False),
                    told="said red-light, it passes no red light",
                )
            if deed.when is not None:
                self.waits.append((f"{path}.when", deed.when, once, seen))

    def _seen(self, one: Other, k: int, seen: Seen, latest: int) -> Iterator[Act]:
        """The times that a deed is seen, of which some began before another did that was said before it."""
        act, whom = one.does[k].act, one.does[k].whom
        meets = act is Said.OVERTAKE and one.starts.where is Where.ONCOMING  # it comes over, and is met
        if whom not in (None, EGO) and act in TO_SOMEBODY and not meets:
            yield from (once for once in TO_SOMEBODY[act](self._beside(one, whom)) if self._counts(once, seen))
            return
        stands = act is Said.STAND and k > 0
        sees = standing if stands else ACTS[act]
        if meets:
            sees = enters
        if act is Said.ACCELERATE and (speed := one.does[k].speed) is not None and not speed.than_ego:
            sees = partial(accelerates, to=speed.high)
        for once in sees(seen):
            if self._counts(once, seen):
                yield since(once, latest, seen, stands=stands) if stands or act in COMES_IN else once

    def _beside(self, one: Other, whom: str) -> Seen:
        """Somebody as who is done something to sees it, in the place of the ego."""
        mine, theirs = (self._tracks(name)[0] for name in (one.id, whom))
        return watch(self.episode, self.route, mine, self.contact, of=theirs)

    def _tracks(self, name: str) -> list[Track]:
        """The tracks of somebody, or of all of several."""
        return [track for track in self.episode.tracks if re.fullmatch(rf"{re.escape(name)}(-\d+)?", track.actor)]

    def _fitting(self, path: str, deed: Deed, times: list[Act], seen: Seen) -> Act:
        """The first time that is seen with all numbers that were said, or the first of all."""
        times.sort(key=lambda once: once.began)
        fits = (once for once in times if not failures(self._amounts(path, deed, once, seen)))
        return next(fits, times[0])

    def _counts(self, once: Act, seen: Seen) -> bool:
        """Whether it is done, or under way where a contact cut it short."""
        return once.done is not None if self.contact is None else once.began < len(seen.track.x) - 1

    def _amounts(self, path: str, deed: Deed, once: Act, seen: Seen) -> Iterator[Finding]:
        speed = np.abs(seen.track.speed[once.began :])
        if deed.speed is not None:
            yield self._number(f"{path}.speed", deed.speed, speed, SLACK_SPEED, "goes at")
        if deed.acceleration is not None and len(speed) > OVER:
            change = np.abs(speed[OVER:] - speed[:-OVER]) / (OVER * seen.dt)
            yield self._number(
                f"{path}.acceleration",
                deed.acceleration,
                change[change.argmax() :][:1],
                SLACK_SPEED,
                "changes speed by",
            )
        if (distance := _way_of(deed, once, seen)) is not None:
            path_of, said, found, slack = distance
            yield self._number(f"{path}.{path_of}", said, found, slack, "leaves")
        if deed.time is not None and deed.act in (Said.STOP, Said.STAND, Said.HESITATE):
            first, end = stood(seen, once)
            found = self._number(
                f"{path}.time", deed.time, np.array([(end - first) * seen.dt]), SLACK_TIME, "stands for"
            )
            whole = end < len(seen.track.speed)  # else nobody saw the end of it
            yield found if whole or found.shown else replace(found, shown=None)

    def _when(self, path: str, when: When, once: Act, seen: Seen, done: dict[str, Act]) -> Iterator[Finding]:
        slack = TOGETHER / seen.dt
        for name, reference in (("after", when.after), ("during", when.during)):
            if reference is None or reference.startswith(f"{EGO}."):
                continue
            other = done.get(reference)
            if other is None:
                continue  # which has a finding of its own
            right = once.began >= other.began - slack
            lasts = reference.partition(".")[0] == path.split(".")[1] or self.situation.deed(reference).act.row.lasting
            if name == "during" and other.done is not None and not lasts:  # else it is under way until this begins
                right = right and once.began <= other.done + slack
            told = f"said {name} {reference}, it begins {(once.began - other.began) * seen.dt:.1f} s after that begins"
            yield Finding(path=f"{path}.{name}", shown=right, told=told, at=once.began * seen.dt)
        if (near := when.ego_within) is not None:
            lead, ego = abs(float(seen.lead[once.began])), float(seen.ego.speed[once.began])
            measured = lead / max(ego, 1.0) if isinstance(near, Duration) else lead
            slack_of = SLACK_TIME if isinstance(near, Duration) else SLACK_LENGTH
            most = near.high if math.isfinite(near.high) else near.low
            right = measured <= most * (1 + 2 * SLACK) + 2 * slack_of
            told = f"said within {near}, the ego is at {measured:.1f}"
            yield Finding(path=f"{path}.ego_within", shown=right, told=told, at=once.began * seen.dt)

    def _number(
        self,
        path: str,
        said: Amount,
        seen: Array,
        least_slack: float,
        verb: str,
        *,
        most: bool = False,
        cut: bool = True,
    ) -> Finding:
        """Whether a number was reached at some time, or by the most of all; a contact may have cut it short."""
        base = float(np.percentile(self.episode.ego_track.speed, 90)) if said.than_ego else 0.0  # as nothing held it
        low, high = said.low + base, said.high + base
        slack = max(least_slack, SLACK * abs(low if math.isfinite(low) else high))
        values = seen.max(keepdims=True) if most and seen.size else seen
        right = bool(((values >= low - slack) & (values <= high + slack)).any())
        nearest = float(values[np.abs(values - (low if math.isfinite(low) else high)).argmin()]) if values.size else 0.0
        short = cut and self.contact is not None and nearest < low
        return Finding(
            path=path, shown=right or (None if short else False), told=f"said {said}, it {verb} {nearest:.1f}"
        )

    # Contact

    def _of_contact(self) -> Iterator[Finding]:
        said, collision = self.situation.contact, self.episode.collision
        if said is None:
            return
        if collision is None:
            if said.happens:
                yield Finding(path="contact.happens", shown=None, told="said a contact, there is none")
            return
        if not said.happens:
            yield Finding(path="contact.happens", shown=False, told="said that there is no contact, there is one")
            return
        whom = said.whom or next(one.id for one in self.situation.adversaries)
        right = re.fullmatch(rf"{re.escape(whom)}(-\d+)?", collision.other) is not None
        yield Finding(path="contact.whom", shown=right, told=f"said {whom}, it is {collision.other}")
        if said.ego is not None:
            right = collision.side in SIDES_OF[said.ego]
            yield Finding(path="contact.ego", shown=right, told=f"said {said.ego}, it is the {collision.side}")
        other = next((t for t in self.episode.tracks if t.actor == collision.other), None)
        if said.striker is not None and other is not None:
            striker = striker_of(self.episode, other)
            right = striker is said.striker
            yield Finding(path="contact.striker", shown=right, told=f"said {said.striker}, it is {striker}")


def _waits_for_others(one: Other) -> bool:
    """Whether a deed of somebody waits for one of somebody else."""
    waits = (deed.when for deed in one.does if deed.when is not None)
    named = (name for when in waits for name in (when.after, when.during) if name is not None)
    return any(name.partition(".")[0] not in (one.id, EGO) for name in named)


def _due(deed: Deed, once: Act, done: Mapping[str, Act], seen: Seen) -> bool:
    """Whether a time that a deed is seen is one at which it was due, by what it waits for."""
    references = (deed.when.after, deed.when.during) if deed.when is not None else ()
    others = (done[one] for one in references if one is not None and one in done)
    return all(once.began >= other.began - TOGETHER / seen.dt for other in others)


def _way_of(deed: Deed, once: Act, seen: Seen) -> tuple[str, Amount, Array, float] | None:
    """The room that is left or the way that is covered, if that was said: what was said of it, and what is seen."""
    if deed.act is Said.REVERSE and deed.distance is not None:
        return "distance", deed.distance, gone_back(seen, once), BACK_SLACK
    if deed.act is Said.CUT_IN and once.done is not None and deed.whom in (None, EGO):
        room = room_left(seen, once)
        if deed.distance is not None:
            return "distance", deed.distance, room, SLACK_LENGTH
        if deed.time is not None:
            return "time", deed.time, room / max(float(seen.ego.speed[once.done]), 1.0), SLACK_TIME
    return None


def _side(left: float) -> str:
    return "left" if left > 0 else "right"
