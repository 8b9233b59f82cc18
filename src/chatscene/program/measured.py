"""Numbers that were said, and what tracks have of them: speeds that are held, means of braking, gaps of bodies."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from chatscene.program.amounts import FAR, HALF_LANE, LASTS, LONG, gaining_run, losing_run, over_the_line
from chatscene.program.deeds import STANDING, Act
from chatscene.program.doing import gone_aside, gone_back, room_left, stood
from chatscene.program.finding import Finding, not_judged
from chatscene.program.lateral import LANE
from chatscene.program.watching import Seen
from chatscene.terms.amount import Amount
from chatscene.terms.arrays import Array
from chatscene.terms.route import Route
from chatscene.terms.situation import EGO, Deed, Start
from chatscene.terms.vocabulary import ASIDE, BEYOND_JUNCTION, NOSE_TO_TAIL, RESTS, Heads, Tempo, Where, acts_of
from chatscene.terms.vocabulary import Act as Said

SLACK = 0.15  # of a number that was said: what a watcher does not see
SLACK_SPEED, SLACK_LENGTH, SLACK_TIME = 0.7, 1.0, 0.4  # [m/s], [m], [s]: the least of it
SLACK_ACCELERATION = 0.5  # [m/s²]
BACK_SLACK, SLACK_ASIDE = 0.7, 0.2  # [m]
SLACK_OVER = 0.3  # [m/s], sideways
HELD = 1.0  # [s] for which somebody holds a speed, within `SLACK_SPEED`, that it is seen to go at
LEVEL = 2.0  # [s] about its highest speed, after which somebody is seen to gain no more
OVER = 5  # [steps] over which somebody is seen to gain speed


GAINING = acts_of(Tempo.GAINS, Tempo.SETS_OFF, Heads.FROM_EDGE, Heads.THROUGH, Heads.TURNS)
"""By what speed is gained."""
_GAPS = acts_of(Heads.BEFORE, Heads.MERGES)
"""Of what the room that is left is measured."""
_BACKS, _ALONG, _LEVEL = acts_of(Tempo.BACKS), acts_of(Heads.ALONG), acts_of(Heads.LEVEL)
MEASURED = {
    "speed": frozenset(Said),
    "acceleration": frozenset(Said),
    "time": LASTS | RESTS | _GAPS | LONG.keys(),
    "distance": _ALONG | _BACKS | ASIDE | _GAPS | FAR.keys(),
}
"""Of which acts tracks tell an amount, by its name in a deed; of all others it is told as not in tracks."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Yardstick:
    """How numbers of a drive are held against what was said.

    Attributes:
        ego_speed: The speed [m/s] of an ego that nothing holds.
        cut: Whether a contact cut the drive short.
    """

    ego_speed: float
    cut: bool

    def number(
        self, path: str, said: Amount, seen: Array, least: float, verb: str, *, most: bool = False, cut: bool = True
    ) -> Finding:
        """Whether a number is one of those that were seen, or the most of all; a contact may have cut it short."""
        base = self.ego_speed if said.than_ego else 0.0
        low, high = said.low + base, said.high + base
        aim = low if math.isfinite(low) else high
        slack = max(least, SLACK * abs(aim))
        values = seen.max(keepdims=True) if most and seen.size else seen
        right = bool(((values >= low - slack) & (values <= high + slack)).any())
        nearest = float(values[np.abs(values - aim).argmin()]) if values.size else 0.0
        shown = right or (None if cut and self.cut and nearest < low else False)
        return Finding(path=path, shown=shown, told=f"said {said}, it {verb} {nearest:.1f}")

    def start(self, path: str, start: Start, seen: Seen, route: Route) -> Finding | None:
        """The distance of a start: from nose to tail of who goes the ego's way, else from middle to middle.

        Of a place that is named by the junction that it lies beyond, the distance is from there.
        """
        if start.distance is None or start.where in (Where.ARM, Where.ONCOMING):
            return None  # of whom it is how far it has to the junction or to the ego: what the builder makes of it
        if start.where in BEYOND_JUNCTION:
            if route.exit_at is None:
                return not_judged(path)
            beyond = seen.at[:1] - route.exit_at
            found = self.number(path, start.distance, beyond, SLACK_LENGTH, "starts this far:", cut=False)
            return replace(found, told=f"{found.told} beyond the junction")
        bodies = start.where in NOSE_TO_TAIL
        lead = np.abs(seen.lead[:1]) - (seen.ego.length + seen.track.length) / 2 * bodies
        how = "from nose to tail" if bodies else "between the middles"
        found = self.number(path, start.distance, lead, SLACK_LENGTH, "starts this far:", cut=False)
        return replace(found, told=f"{found.told} {how}")

    def speed(self, path: str, said: Amount, seen: Seen, once: Act) -> Finding:
        """The speed of a deed: one that is held or turned at, from just before it began on; not one that is passed."""
        steps = round(HELD / seen.dt)
        values = np.abs(seen.track.speed[max(once.began - steps, 0) :])
        windows = np.lib.stride_tricks.sliding_window_view(values, min(steps, len(values)))
        slow = max(said.most, 0.0) + self.ego_speed * said.than_ego
        least = min(SLACK_SPEED, slow / 3.0)  # who walks at half a speed is seen not to walk at that
        even = np.ptp(windows, axis=1) <= least  # a share of a high speed would call even what brakes from that
        turns = np.flatnonzero(np.diff(np.sign(np.diff(values)))) + 1
        held = np.concatenate((windows.mean(axis=1)[even], values[turns], values[-1:] if self.cut else ()))
        goes = held[held > STANDING]  # to stand is not to go at a low speed
        last = np.abs(seen.track.speed[-round(LEVEL / seen.dt) :])
        rises = len(last) * seen.dt < LEVEL or np.ptp(last) > SLACK_SPEED  # else nothing more was to come
        return self.number(path, said, goes if goes.size else held, least, "goes at", cut=bool(rises))

    def speed_aside(self, path: str, said: Amount, seen: Seen, once: Act) -> Finding:
        """How fast somebody comes aside: the most over a while."""
        steps = round(HELD / seen.dt)
        offset = seen.offset[once.began :]
        over = np.abs(offset[steps:] - offset[:-steps]) / (steps * seen.dt)
        return self.number(path, said, over, SLACK_OVER, "comes aside at", most=True)

    def acceleration(self, path: str, deed: Deed, seen: Seen, once: Act) -> Finding | None:
        """How hard speed changes by a deed: the mean over all of what is lost, or over most of what is gained."""
        speed = np.abs(seen.track.speed[once.began :])
        if deed.acceleration is None or len(speed) <= OVER:
            return None
        runs = gaining_run if deed.act in GAINING else losing_run
        first, end = runs(speed, seen.dt)
        change = abs(float(speed[end] - speed[first])) / ((end - first) * seen.dt)
        return self.number(
            f"{path}.acceleration", deed.acceleration, np.array([change]), SLACK_ACCELERATION, "changes speed by"
        )

    def way(self, path: str, deed: Deed, once: Act, seen: Seen, toward: Seen) -> Finding | None:
        """The room that is left or the way that is covered, if that was said."""
        if deed.act in _BACKS and deed.distance is not None:
            return self.number(f"{path}.distance", deed.distance, gone_back(seen, once), BACK_SLACK, "covers")
        if deed.act in ASIDE and deed.distance is not None:
            aside = gone_aside(seen, once)
            over = aside - 0.5 * (LANE - seen.track.width)  # of the edge of its lane, if it comes to the ego's
            both = np.concatenate((aside, over)) if abs(seen.offset[once.began]) > HALF_LANE else aside
            return self.number(f"{path}.distance", deed.distance, both, SLACK_ASIDE, "leaves its line by")
        if deed.act in _GAPS and once.done is not None and deed.done_to == EGO:
            room = room_left(seen, replace(once, done=over_the_line(seen, once)), once.done)
            if deed.distance is not None:
                return self.number(f"{path}.distance", deed.distance, room, SLACK_LENGTH, "leaves")
            if deed.time is not None:
                seconds = room / max(float(seen.ego.speed[once.done]), 1.0)
                return self.number(f"{path}.time", deed.time, seconds, SLACK_TIME, "leaves")
        if deed.act in FAR and deed.distance is not None:
            values, verb = FAR[deed.act]
            return self.number(f"{path}.distance", deed.distance, values(toward, once), SLACK_LENGTH, verb)
        return None

    def time(self, path: str, deed: Deed, once: Act, seen: Seen) -> Finding | None:
        """How long something takes, if that was said of what ends by itself."""
        if deed.time is None or deed.act not in LONG:
            return None
        values, verb = LONG[deed.act]
        return self.number(f"{path}.time", deed.time, values(seen, once), SLACK_TIME, verb)

    def lasts(self, path: str, deed: Deed, began: int, ends: int | None, seen: Seen, toward: Seen) -> Iterator[Finding]:
        """How long and how far something goes on, at least, until the next deed begins."""
        if deed.act not in LASTS:
            return
        until = len(seen.track.speed) - 1 if ends is None else ends
        seconds = max(until - began, 0) * seen.dt
        if deed.act in _LEVEL:
            level = np.abs(toward.lead[:until]) < (toward.ego.length + toward.track.length) / 2
            seconds = float(level.sum()) * seen.dt
        covered = float(np.abs(seen.track.speed[began:until]).sum()) * seen.dt
        for name, said, value, least in (
            ("time", deed.time, seconds, SLACK_TIME),
            ("distance", deed.distance if deed.act in _ALONG else None, covered, SLACK_LENGTH),
        ):
            if said is None:
                continue
            aim = said.low if math.isfinite(said.low) else 0.0
            right = value >= aim - max(least, SLACK * aim)
            shown = right or (None if ends is None else False)
            yield Finding(path=f"{path}.{name}", shown=shown, told=f"said {said}, it does so for {value:.1f} at most")

    def stand(self, path: str, deed: Deed, once: Act, seen: Seen) -> Finding | None:
        """How long somebody stands, if that was said."""
        if deed.time is None or deed.act not in RESTS:
            return None
        first, end = stood(seen, once)
        found = self.number(f"{path}.time", deed.time, np.array([(end - first) * seen.dt]), SLACK_TIME, "stands for")
        whole = end < len(seen.track.speed)  # else nobody saw the end of it
        return found if whole or found.shown else replace(found, shown=None)


def held_at_most(speed: Array, dt: float) -> bool:
    """Whether somebody holds about its highest speed for a while, so that no more was to come."""
    return int((speed >= speed.max() - SLACK_SPEED).sum()) * dt >= LEVEL
