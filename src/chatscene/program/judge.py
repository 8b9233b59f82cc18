"""A situation and a drive: which facts are seen on the tracks, when, and which are not.

Tracks, map and lights alone are read, never a program's text. A fact that no track tells has a finding that says so;
amounts for which `chatscene.program.measured` has no test have none.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import partial

import numpy as np

from chatscene.program.contacts import is_of, is_with, of_contact
from chatscene.program.deeds import ACTIONS, MOVING, Act, tailgates
from chatscene.program.doing import (
    ACTS,
    MOST_OF,
    TO_SOMEBODY,
    accelerates,
    drifts,
    enters,
    exits,
    moved_left,
    passes,
    seen_by,
    since,
    standing,
)
from chatscene.program.encounter import encounter
from chatscene.program.finding import Finding, failures, not_judged
from chatscene.program.gone_by import gone_by, has_passed
from chatscene.program.lateral import is_aside, of_lateral
from chatscene.program.meaning import TOGETHER, in_between, left_of_ego
from chatscene.program.measured import SLACK, SLACK_LENGTH, SLACK_SPEED, Yardstick, held_at_most
from chatscene.program.own import of_ego
from chatscene.program.roads import of_road
from chatscene.program.said import LEAVES_LINE, due, gently, to_side, untold, waits_for_ego, waits_for_others
from chatscene.program.sequence import Sequence
from chatscene.program.starting import STARTS, faces
from chatscene.program.unasked import of_somebody, unasked
from chatscene.program.waits import Waiting
from chatscene.program.watching import Seen, percentile, watch
from chatscene.situations.phrases import one_seen
from chatscene.terms.actors import manner_of
from chatscene.terms.acts import Action
from chatscene.terms.arrays import Array
from chatscene.terms.backing import as_it_backs, backs, drive_as_it_backs, turned_about
from chatscene.terms.episode import Episode, Track
from chatscene.terms.mirroring import mirrored_drive, mirrored_route, mirrored_situation, mirrored_words
from chatscene.terms.rolling import as_it_rolls
from chatscene.terms.route import Route
from chatscene.terms.routing import BEGINS
from chatscene.terms.situation import EGO, SEVERAL, Deed, Other, Situation
from chatscene.terms.vocabulary import (
    ASIDE,
    COMES_IN,
    LETS_GO,
    SLOWS,
    Breach,
    EgoRoute,
    Heads,
    Manner,
    Role,
    Side,
    Where,
    acts_of,
)
from chatscene.terms.vocabulary import Act as Said

__all__ = ["Finding", "failures", "judge"]


AVOIDS = SLOWS | acts_of(Heads.ASIDE, Heads.OVER)
"""What somebody behind the ego does so as not to run into it."""
_DRIVES_OUT = frozenset((Where.ARM, Where.ONCOMING))
_EXITS = frozenset((EgoRoute.ROUNDABOUT, EgoRoute.EXIT))
BY_A_LITTLE = 0.6  # [m] by which somebody drifts of whom it is said where across the road it then is, at least about
NEARER = 2.0  # [m] by which an ego comes nearer to somebody whom it is about to overtake


def judge(situation: Situation, episode: Episode, route: Route, *, through: bool = False) -> tuple[Finding, ...]:
    """What a drive shows of a situation, up to the first contact of the ego.

    Args:
        situation: What was said.
        episode: What happened; a road user of the situation has its id for a name, several have it with a number.
        route: The ego's route.
        through: Judge to the end a drive that went on through a collision.
    """
    if route.mirrored:
        said = situation if situation.evidence.mirrored else mirrored_situation(situation)
        found = judge(said, mirrored_drive(episode), replace(mirrored_route(route), mirrored=False), through=through)
        return tuple(replace(one, told=mirrored_words(one.told)) for one in found)
    situation = as_it_rolls(situation)
    if not backs(situation):
        return tuple(_Judge(situation, episode, route, through).findings())
    judged = _Judge(as_it_backs(situation), drive_as_it_backs(episode), route, through).findings()
    return tuple(replace(one, told=_SIDES.sub(lambda side: turned_about(side[0]), one.told)) for one in judged)


_SIDES = re.compile(r"\b(?:left|right|front|rear)\b(?! its)")


@dataclass(slots=True)
class _Judge:
    situation: Situation
    episode: Episode
    route: Route
    through: bool
    measure: Yardstick = field(init=False)
    waiting: Waiting = field(init=False)
    waits: list[tuple[str, Deed, Act, Seen]] = field(default_factory=list[tuple[str, Deed, Act, Seen]])
    seen: dict[str, Seen] = field(default_factory=dict[str, Seen])

    def __post_init__(self) -> None:
        wanted = percentile(self.episode.ego_track.speed, 90)  # as nothing held it
        self.waiting = Waiting(self.situation, self.episode, self.route, self.contact)
        self.measure = Yardstick(ego_speed=wanted, cut=self.contact is not None)

    @property
    def contact(self) -> int | None:
        """The step of the first contact, after which nothing is judged."""
        return self.episode.collision.step if self.episode.collision is not None and not self.through else None

    def findings(self) -> Iterator[Finding]:
        """What is shown; what was said to come of a meeting does not come of one that there was not."""
        found = tuple(self._findings())
        ways = (one.path.partition(".") for one in found if one.shown is False)
        missed = {who for about, _, who in ways if about == "encounter"}
        for one in found:
            if missed and one.shown and (whom := self._comes_of(one.path)) in missed:
                yield replace(one, shown=False, unmet=True, told=f"{one.told}, but the ego does not meet {whom}")
            else:
                yield one

    def _comes_of(self, path: str) -> str | None:
        """For whom the ego does something, or whom it is not to touch; None for any other fact."""
        contact = self.situation.contact
        if path == "contact.happens" and contact is not None and not contact.happens:
            return contact.whom or self.situation.adversaries[0].id
        ego, _, deed = path.partition(".does.")
        number, _, fact = deed.partition(".")
        if ego != EGO or fact != "act":
            return None
        when = self.situation.ego.does[int(number)].when
        return None if when is None or when.after is None else when.after.partition(".")[0]

    def _findings(self) -> Iterator[Finding]:
        until = None if self.contact is None else self.contact + 1
        yield from of_road(self.situation, self.episode, self.route, until)
        ego = self.situation.ego
        speed = self.episode.ego_track.speed[:until]
        if ego.kind is not None:
            kind = self.episode.ego_track.kind
            yield Finding(
                path="ego.kind", shown=kind == ego.kind.scenic, told=f"said {ego.kind}, it is {one_seen(kind)}"
            )
        if ego.speed is not None:
            rises = self.contact is not None and not held_at_most(speed, self.episode.dt)
            drives = self._until_it_gains(speed)
            yield self.measure.number("ego.speed", ego.speed, drives, SLACK_SPEED, "drives at", most=True, cut=rises)
        done: dict[str, Act] = {}
        others = sorted(self.situation.others, key=waits_for_others)  # who is waited for first
        early, late = ([one for one in others if waits_for_ego(one) is waits] for waits in (False, True))
        before = [finding for one in early for finding in self._of_other(one, done)]
        yield from of_ego(self.situation, self.episode, self.route, self.contact, done)
        yield from before
        for one in late:
            yield from self._of_other(one, done)
        for path, deed, once, seen in self.waits:  # once it is known when everybody did what
            yield from self.waiting.of(path, deed, once, seen, done)
        yield from self._of_passing()
        yield from of_contact(self.situation, self.episode)
        if not self.through:
            yield from self._of_encounters(done)
            yield from unasked(self.situation, self.episode, until)

    def _until_it_gains(self, speed: Array) -> Array:
        """The ego's speeds [m/s] until it gains speed to one that was said, which is then another than its own."""
        said = (one.speed for one in self.situation.ego.does if one.act is Said.ACCELERATE)
        gains = next((to for to in said if to is not None), None)
        if gains is None:
            return speed
        seen = watch(self.episode, self.route, self.episode.ego_track, self.contact)
        has = np.flatnonzero(speed > (1.0 - SLACK) * gains.least)
        until = int(has[0]) if has.size else len(speed)
        began, done = None, -1
        for once in accelerates(seen, gains.high):
            if once.began < until and once.began != done:  # else it goes on gaining
                began = once.began
            done = once.done
        return speed if began is None else speed[: max(began, 1)]

    def _of_passing(self) -> Iterator[Finding]:
        """Whether an ego that is to overtake gets by somebody; one that comes nearer and waits has not come to it."""
        if self.situation.ego.route is not EgoRoute.OVERTAKE:
            return
        ego, others = self.episode.ego_track, [t for one in self.situation.others for t in self._tracks(one.id)]
        seen = [watch(self.episode, self.route, ego, self.contact, of=other) for other in others]
        if any(once.done is not None for one in seen for once in passes(one)):
            return
        same_way = [one for one in seen if math.cos(float(one.ego.heading[0] - ego.heading[0])) > 0.0]
        apart = [np.hypot(one.track.x - one.ego.x, one.track.y - one.ego.y) for one in same_way]
        nearer = any(far[0] - far.min() > NEARER for far in apart)
        yield Finding(path="ego.route", shown=None if nearer else False, told="said overtake, it gets by nobody")

    def _of_encounters(self, done: Mapping[str, Act]) -> Iterator[Finding]:
        """Whether all do what was said before the ego has gone by, and it could meet each adversary since that did."""
        for one in self.situation.others:
            seen = self.seen.get(one.id)
            if seen is None or one.role is Role.HIDES:
                continue
            contact = self.situation.contact
            touched = contact is not None and contact.happens and contact.whom in (None, one.id)
            late = gone_by(one, seen, done, touched=touched) or has_passed(self.situation, one, seen, done, self.seen)
            if late is not None:
                yield late
            elif one.role is Role.ADVERSARY:
                began = [
                    done[f"{one.id}.{k}"].began
                    for k, deed in enumerate(one.does)
                    if not deed.act.row.lasting and f"{one.id}.{k}" in done
                ]
                tracks, first = self._tracks(one.id), min(began, default=0)
                found = encounter(self.situation, one, tracks, self.episode, self.route, first)
                yield from () if found is None else (found,)

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
        yield Finding(path=f"{at}.kind", shown=known, told=f"said {one.kind}, it is {one_seen(kind)}")
        enough = len(tracks) > 1 if one.count == SEVERAL else len(tracks) == one.count
        yield Finding(path=f"{at}.count", shown=enough, told=f"said {one.count or 'several'}, there are {len(tracks)}")
        if one.stretch is not None:
            ends = np.array([[track.x[0], track.y[0]] for track in tracks])
            long = np.hypot(*(ends - ends[:1]).T).max(keepdims=True) + tracks[0].length
            yield self.measure.number(f"{at}.stretch", one.stretch, long, tracks[0].length, "is so long:", cut=False)
        seen = self.seen[one.id] = watch(self.episode, self.route, tracks[0], self.contact)
        yield from self._start(one, at, seen)
        yield from self._deeds(one, at, seen, done)
        yield from self._lasting(one, at, seen, done)
        ends = [done[name].done for k in range(len(one.does)) if (name := f"{one.id}.{k}") in done]
        after = max((len(seen.track.x) if end is None else end for end in ends), default=0)
        yield from of_somebody(self.situation, one, seen, self.route, self.episode.tracks, after)

    def _start(self, one: Other, at: str, seen: Seen) -> Iterator[Finding]:
        start = one.starts
        where = f"it starts {seen.lead[0]:.1f} m ahead, {abs(seen.across[0]):.1f} m {_side(seen.across[0])}"
        hides = any(other.hidden_by == one.id for other in self.situation.others)
        if start.where in STARTS and not hides:
            right = bool(STARTS[start.where](seen)) or is_aside(start, seen)
            yield Finding(path=f"{at}.starts.where", shown=right, told=f"said {start.where}, {where}", at=0.0)
        elif not hides:
            yield not_judged(f"{at}.starts.where")
        if start.facing is not None:
            turned = math.degrees(float(seen.bearing[0]))
            told = f"said {start.facing}, it is turned by {turned:.0f} degrees to the left of the ego"
            yield Finding(path=f"{at}.starts.facing", shown=faces(seen, start.facing), told=told, at=0.0)
        if start.side is not None and start.where is not Where.EXIT_CROSSING:
            beside = self.situation.ego.route in BEGINS and start.where is Where.AHEAD_BESIDE
            left = float(seen.across[0]) if beside else left_of_ego(seen, self.route)
            right = (left > 0) == (start.side is Side.LEFT)
            yield Finding(path=f"{at}.starts.side", shown=right, told=f"said {start.side}, {where}", at=0.0)
        if backs(self.situation) and start.distance is not None and self.situation.ego.route is not EgoRoute.REVERSE:
            aside = np.abs(seen.across[:1])  # along the road, across which it looks out of where it stood
            yield self.measure.number(
                f"{at}.starts.distance", start.distance, aside, SLACK_LENGTH, "starts this far:", cut=False
            )
        elif (distance := self.measure.start(f"{at}.starts.distance", start, seen, self.route)) is not None:
            yield distance
        if start.lateral is not None:
            yield from of_lateral(start.lateral, one, f"{at}.starts.lateral", seen)
        if start.speed is not None:
            speed = np.abs(seen.track.speed[:3])
            yield self.measure.number(f"{at}.starts.speed", start.speed, speed, SLACK_SPEED, "starts at", cut=False)
        if one.hidden_by is not None:
            hidden = self._hidden(one.hidden_by, seen, drives=start.where in _DRIVES_OUT)
            between = "is" if hidden else "is not"
            yield Finding(
                path=f"{at}.hidden_by",
                shown=hidden,
                told=f"said hidden by {one.hidden_by}, which {between} between it and the ego when it comes out",
            )

    def _hidden(self, by: str, seen: Seen, *, drives: bool) -> bool:
        """Whether it is hidden when it comes out: within a second before it has moved; who never moves, at any time.

        Who comes driving along another road is hidden on its way.
        """
        if drives:
            apart = np.hypot(seen.track.x - seen.ego.x, seen.track.y - seen.ego.y)
            before = range(int(apart.argmin()) + 1)
            return any(in_between(thing, seen.ego, seen.track, step) for thing in self._tracks(by) for step in before)
        moved = np.hypot(seen.track.x - seen.track.x[0], seen.track.y - seen.track.y[0])
        still = np.flatnonzero(moved < 1.0)
        comes_out = len(still) < len(moved)
        if comes_out:
            still = still[-round(TOGETHER / seen.dt) :]
        steps = still[:: 3 if seen.dt < 0.2 else 1].tolist()
        return any(in_between(thing, seen.ego, seen.track, step) for thing in self._tracks(by) for step in steps)

    def _from_view(self, one: Other, k: int, once: Act, seen: Seen) -> Act:
        """The first deed of who comes driving and is hidden at first, from when it comes into view."""
        drives = one.starts.where in _DRIVES_OUT and abs(float(seen.track.speed[0])) > MOVING
        if k or one.hidden_by is None or not drives:
            return once
        apart = np.hypot(seen.track.x - seen.ego.x, seen.track.y - seen.ego.y)
        hidden = (
            step
            for step in range(int(apart.argmin()), -1, -1)
            for thing in self._tracks(one.hidden_by)
            if in_between(thing, seen.ego, seen.track, step)
        )
        return replace(once, began=next(hidden, once.began))

    def _deeds(self, one: Other, at: str, seen: Seen, done: dict[str, Act]) -> Iterator[Finding]:
        sequence = Sequence.of(one, seen)
        for k, deed in enumerate(one.does):
            path, act = f"{at}.does.{k}", deed.act
            yield from (not_judged(f"{path}.{name}") for name in untold(deed))
            times = (*self._seen(one, k, seen, sequence.since(act)), *self._anew(one, deed, seen, sequence.free(act)))
            found = [once for once in times if sequence.may_be(act, once)]
            after = sequence.after(act, found, during=deed.when is not None and deed.when.during is not None)
            if not after:
                never = "never does" if self.contact is None else "had not begun to when the ego crashed"
                told = f"said {act}, but it {never}"
                if found and sequence.said:
                    told = f"said {sequence.said[-1]}, then {act}, but it does it the other way round"
                yield Finding(path=f"{path}.act", shown=False, told=told)
                continue
            timely = [one for one in after if due(deed, one, done, seen)] or after
            # Who swerves comes back, which is no swerve to the other side; who was on that one before has no need to.
            sided = act is Said.DRIFT or (k > 0 and _other_way(one.does[k - 1], deed))
            once = self._fitting(
                one, path, deed, [once for once in timely if sided and to_side(deed, once, seen)] or timely, seen
            )
            sequence.add(act, once)
            done[f"{one.id}.{k}"] = once
            done.setdefault(f"{one.id}.{act}", once)
            cut = self._cut(one, k, once)
            yield Finding(path=f"{path}.act", shown=True, told=f"said {act}", at=once.began * seen.dt, cut=cut)
            yield from self._how(one, path, deed, once, seen)
            if deed.when is not None:
                self.waits.append((f"{path}.when", deed, self._from_view(one, k, once, seen), seen))

    def _lasting(self, one: Other, at: str, seen: Seen, done: Mapping[str, Act]) -> Iterator[Finding]:
        """How long what goes on is done, until the next deed begins."""
        for k, deed in enumerate(one.does):
            began, ends = done.get(f"{one.id}.{k}"), done.get(f"{one.id}.{k + 1}")
            before = done.get(f"{one.id}.{k - 1}")
            if began is None or (ends is None and k + 1 < len(one.does)):
                continue
            first = began.began if before is None else min(began.began, before.began)
            comes_in = ends is not None and one.does[k + 1].act in COMES_IN
            until = None if ends is None else ends.done if comes_in else ends.began
            yield from self.measure.lasts(f"{at}.does.{k}", deed, first, until, seen, self._toward(deed, seen))

    def _how(self, one: Other, path: str, deed: Deed, once: Act, seen: Seen) -> Iterator[Finding]:
        """How a deed is done: to which side, by which numbers, in which manner, against which rule."""
        if deed.to is not None and deed.act in LEAVES_LINE:
            told = f"said {deed.to}, it goes to the {_side(moved_left(seen, once))}"
            yield Finding(path=f"{path}.to", shown=to_side(deed, once, seen), told=told)
        yield from self._amounts(one, path, deed, once, seen)
        if deed.manner is Manner.SLANTING:
            slants = any(True for _ in ACTIONS[Action.DIAGONAL](seen))
            yield Finding(
                path=f"{path}.manner",
                shown=slants,
                told=f"said slanting, it goes {'aslant' if slants else 'straight'} over",
            )
        if deed.breaks is Breach.RED_LIGHT:
            ran = any(True for _ in ACTIONS[Action.RUN_LIGHT](seen))
            yield Finding(
                path=f"{path}.breaks",
                shown=ran or (None if self.contact is not None else False),
                told=f"said red-light, it passes {'a' if ran else 'no'} red light",
            )
        if deed.lateral is not None:
            yield from of_lateral(deed.lateral, one, f"{path}.lateral", seen, deed, once)

    def _cut(self, one: Other, k: int, once: Act) -> bool:
        """Whether a contact cut a deed short: not the last of whom the ego touches, unless that was to avoid it."""
        crash, deed, contact = self.episode.collision, one.does[k], self.situation.contact
        if crash is None or self.through or once.done is not None or deed.act.row.lasting:
            return False
        later = any(not then.act.row.lasting for then in one.does[k + 1 :])
        avoids = contact is None and one.starts.where is Where.BEHIND and deed.act in AVOIDS
        return later or avoids or not is_with(crash.other, one.id)

    def _seen(self, one: Other, k: int, seen: Seen, latest: int) -> Iterator[Act]:
        """The times that a deed is seen, of which some began before another did that was said before it."""
        act, whom = one.does[k].act, one.does[k].whom
        meets = act is Said.OVERTAKE and one.starts.where is Where.ONCOMING  # it comes over, and is met
        if whom not in (None, EGO) and act in TO_SOMEBODY:
            if not meets or any(self._counts(once, seen) for once in enters(seen)):
                beside = self._beside(one, whom)
                yield from (once for body in beside for once in TO_SOMEBODY[act](body) if self._counts(once, seen))
            return
        stands = act is Said.STAND and k > 0
        sees = partial(standing, since=latest) if stands else enters if meets else self._watcher(one, one.does[k])
        for body in self._lets_go(one, k) if act in LETS_GO else (seen,):
            for once in sees(body):
                if self._counts(once, body):
                    yield since(once, latest, body, stands=stands) if stands or act in COMES_IN else once

    def _anew(self, one: Other, deed: Deed, seen: Seen, free: float) -> Iterator[Act]:
        """The times that a movement is seen of somebody who has done with another: from the line that it is on then."""
        first = math.ceil(free)
        if not 0 < first < len(seen.track.x) - 1 or deed.act in LETS_GO or deed.done_to != EGO:
            return
        later = seen.since(first)
        for once in self._watcher(one, deed)(later):
            if self._counts(once, later):
                yield Act(once.began + first, None if once.done is None else once.done + first)

    def _watcher(self, one: Other, deed: Deed) -> Callable[[Seen], Iterable[Act]]:
        """What sees a deed, as it was said and on such a road."""
        act = deed.act
        in_ring = act is Said.GO_STRAIGHT and one.starts.where is Where.IN_ROUNDABOUT  # it turns with that
        over_arm = act is Said.CROSS and one.starts.where is Where.ARM and one.role is Role.SUPPORTING  # and not ours
        if in_ring or over_arm:
            return ACTS[Said.GO_ALONG]
        if act is Said.BRAKE and gently(deed):
            return ACTS[Said.SLOW_DOWN]
        if act is Said.ACCELERATE and deed.speed is not None and not deed.speed.than_ego:
            return partial(accelerates, to=deed.speed.high)
        if act is Said.TAILGATE and (far := deed.distance) is not None:
            return partial(tailgates, within=(far.high if math.isfinite(far.high) else far.low) + SLACK_LENGTH)
        if act is Said.DRIFT and (deed.distance or deed.lateral) is not None:  # which says where it then is
            far = deed.distance
            most = BY_A_LITTLE if far is None else far.low if math.isfinite(far.low) else far.high
            return partial(drifts, by=MOST_OF * most)
        return exits if act is Said.EXIT and self.situation.ego.route in _EXITS else seen_by(act)

    def _lets_go(self, one: Other, k: int) -> tuple[Seen, ...]:
        """What somebody lets go by a deed: one body, or none if there is no more of them."""
        act = one.does[k].act
        before = sum(deed.act is act for deed in one.does[:k])
        parts = self._tracks(f"{one.id}-{LETS_GO[act]}")[before : before + 1]
        return tuple(watch(self.episode, self.route, part, self.contact) for part in parts)

    def _beside(self, one: Other, whom: str) -> tuple[Seen, ...]:
        """Somebody as seen by whom it does something to, who is in the place of the ego; none if that one is absent."""
        mine = self._tracks(one.id)[0]
        return tuple(
            watch(self.episode, self.route, mine, self.contact, of=theirs) for theirs in self._tracks(whom)[:1]
        )

    def _tracks(self, name: str) -> list[Track]:
        """The tracks of somebody, or of all of several."""
        return [track for track in self.episode.tracks if is_of(track.actor, name)]

    def _fitting(self, one: Other, path: str, deed: Deed, times: list[Act], seen: Seen) -> Act:
        """The first time that is seen with all numbers that were said, or the first of all."""
        times.sort(key=lambda once: once.began)
        fits = (once for once in times if not failures(self._amounts(one, path, deed, once, seen)))
        return next(fits, times[0])

    def _counts(self, once: Act, seen: Seen) -> bool:
        """Whether it is done, or under way where a contact cut it short."""
        return once.done is not None if self.contact is None else once.began < len(seen.track.x) - 1

    def _amounts(self, one: Other, path: str, deed: Deed, once: Act, seen: Seen) -> Iterator[Finding]:
        measure = self.measure
        aside = next((one.speed_aside(k) for k, its in enumerate(one.does) if its is deed), None)
        tells = measure.speed if aside is None else measure.speed_aside
        speed = None if deed.speed is None else tells(f"{path}.speed", deed.speed, seen, once)
        hard = measure.acceleration(path, deed, seen, once)
        way = measure.way(path, deed, once, seen, self._toward(deed, seen))
        found = (speed, hard, way, measure.stand(path, deed, once, seen), measure.time(path, deed, once, seen))
        yield from (one for one in found if one is not None)

    def _toward(self, deed: Deed, seen: Seen) -> Seen:
        """Somebody as who is done something to sees it, if that is another than the ego."""
        if deed.done_to == EGO or not (tracks := self._tracks(deed.done_to)):
            return seen
        return watch(self.episode, self.route, seen.track, self.contact, of=tracks[0])


def _other_way(before: Deed, deed: Deed) -> bool:
    """Whether both lead aside of a line, each to the other side of the other."""
    return {before.act, deed.act} <= ASIDE and {before.to, deed.to} == {Side.LEFT, Side.RIGHT}


def _side(left: float) -> str:
    return "left" if left > 0 else "right"
