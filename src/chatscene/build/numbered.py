"""A phase of a deed with the numbers that were said of that deed, and of no other."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from chatscene.build.asked import ENDS_THERE, Meets
from chatscene.build.deeds import Steps
from chatscene.build.gaps import backs_by
from chatscene.build.lateral import goes_aside
from chatscene.build.numbers import FIRM, PACES
from chatscene.build.paces import Pace, Speed
from chatscene.build.place import LANE, NEXT_LANE
from chatscene.build.rates import brakes_by, goes_so_far, rate_of, throttles_by
from chatscene.build.relations import speed_of
from chatscene.build.sideways import speed_aside
from chatscene.build.standing_before import BACKS_AT, BACKS_FOR, backs_into_ego
from chatscene.build.towards import done_to
from chatscene.errors import NotBuilt
from chatscene.terms.situation import EGO, Deed
from chatscene.terms.vocabulary import GOES_ON, Act, Manner, Side, Where

if TYPE_CHECKING:
    from chatscene.build.phases import Phases

_FAR = ("AMPLITUDE", "SWERVE", "DRIFT")
A_LITTLE = 0.3  # of the range of how far somebody leaves its line, up to which it does a little
WAVE = 20.0  # [m], five times as far as a tracker looks ahead: a shorter wave is cut
PIECES = 2  # of three in which somebody drifts: in the last it is nearly there
SETS_OUT = 0.2  # [s] that it takes to settle
USUAL_TOP, KEEPS_UP = 25.0, 5.0  # [m/s] of who keeps a distance, at most; faster than an ego that is as fast
LEVEL_WITH = 1.1  # times the speed of whom it keeps level with, the most that somebody then has
SWINGS = 0.8  # of a wave, the least that is seen
SOONEST, LATEST = 2.0, 8.0  # [s] in which somebody drifts at least, and at most if only a bound was said
WEAVES = 1.0, 10.0  # [s], from and to, that somebody weaves, if only a bound was said
SLOWER = 2.0  # times as long, of who drifts slowly
JUST_BACK = 0.7  # [m] that somebody goes back who then stays in the lane
BACK, DRIFTS = 1.5, 8.0  # [m] that somebody goes back; that it goes on while it drifts by a third


def of_deed(phases: Phases, k: int, text: str, steps: Steps) -> str:
    """A phase of a deed, with the numbers that were said of that deed and of no other."""
    actor, deed = phases.actor, phases.actor.deeds[k]
    numbers, at = actor.numbers, f"{actor.path}.does.{k}"
    speed = phases.paces.after[k]
    if steps.binds.get("acceleration") == "THROTTLE" and _at_a_rate(phases, k, steps):
        throttles_by(actor, k, phases.body, phases.paces.before[k], speed, phases.paces.held(speed))
        text = renamed(text, "THROTTLE", f"THROTTLE_{k}")
    changed = {Pace.GAINS: "FAST", Pace.LOSES: "SLOW"}.get(steps.pace)
    text = renamed(text, changed, speed.name) if changed else text
    text = _lasts(phases, k, held_at(phases, renamed(text, "SPEED", speed.name or "SPEED"), speed), speed)
    if deed.act is Act.REVERSE and deed.distance is not None:
        text = renamed(renamed(text, "BACK", f"BACK_{k}"), "BACK_TIME", backs_by(actor, k))
    elif deed.act is Act.REVERSE and deed.time is None and backs_into_ego(actor.ledger.situation, actor.one):
        numbers.narrow("BACK", *BACKS_AT)
        numbers.narrow("BACK_TIME", *BACKS_FOR)
    text = _bound(phases, k, text, steps, changed)
    if (far := goes_aside(actor, k)) is not None and "distance" in steps.binds:
        own = f"{(name := steps.binds['distance'])}_{k}"
        numbers.measure(own, *far, "m", "how far from its line it goes", f"{at}.lateral")
        text = renamed(text, name, own)
    if deed.act is Act.OVERTAKE and "FAST" in steps.binds.values():
        text = renamed(text, "FAST", f"FAST_{k}")
    begins = k == 0 and actor.one.starts.where is Where.BESIDE and actor.first is None
    if deed.act is Act.KEEP_LEVEL and begins and deed.whom in (None, EGO):
        text = renamed(text, "LEVEL", "Y")  # as level as it begins
    behind = actor.one.starts.where is Where.BEHIND and "$Y" in actor.stand.at
    if deed.act is Act.FOLLOW and k == 0 and behind and actor.first is None:
        text = text.replace("-(ego.length + self.length) / 2 - $ROOM", "-$Y")  # as far behind as it begins
        actor.ledger.take(f"{at}.distance")  # which is that, too
    if deed.act is Act.KEEP_LEVEL and numbers.is_said("SPEED"):
        text = text.replace(", 25, 2)", ", $SPEED, 0.97 * $SPEED)")  # which it does not give up
    level = LEVEL_WITH * speed_of(actor.ledger.situation, done_to(deed), actor.ego_speed)
    top = max(actor.ego_speed + KEEPS_UP, level if deed.act is Act.KEEP_LEVEL else 0.0)
    if top > USUAL_TOP:
        text = text.replace(f", {USUAL_TOP:g})", f", {top:.4g})").replace(f", {USUAL_TOP:g}, 2)", f", {top:.4g}, 2)")
    return _braking(phases, k, text, steps)


def held_at(phases: Phases, text: str, speed: Speed) -> str:
    """A phase that ends when a speed is reached, with the share of it that its pedals hold."""
    if "{held}" not in text:
        return text
    if not speed.name:
        low, high, *_ = phases.actor.numbers.range_of("SPEED")
        speed = Speed("SPEED", low, high)
    return text.replace("{held}", f"{phases.paces.held(speed):g}")


def _lasts(phases: Phases, k: int, text: str, speed: Speed) -> str:
    """A phase with the time that it takes somebody to get so far that it is seen."""
    deed = phases.actor.deeds[k]
    if deed.act is Act.WEAVE and deed.time is not None:
        if deed.time.high < SWINGS * max(3.0, WAVE / phases.actor.ego_speed):
            at = f"{phases.actor.path}.does.{k}.time"
            raise NotBuilt(f"{at}: {deed.time} is too short to weave from side to side")
        low, high = deed.time.drawn(*WEAVES)
        at = f"{phases.actor.path}.does.{k}.time"
        phases.actor.numbers.measure(f"WEAVE_TIME_{k}", low, high, "s", "for how long it weaves", at)
        text = text.replace("{weaves} seconds", f"$WEAVE_TIME_{k} seconds")
    if deed.act is Act.DRIFT and deed.time is not None:  # in three pieces, and some time behind each
        at = f"{phases.actor.path}.does.{k}.time"
        if deed.time.high < SOONEST:
            raise NotBuilt(f"{at}: {deed.time} is too short to drift: at least {SOONEST:g} s")
        low, high = ((one - SETS_OUT) / PIECES for one in deed.time.drawn(SOONEST, LATEST))
        phases.actor.numbers.measure(f"DRIFT_TIME_{k}", low, high, "s", "how long a piece of its drift takes", at)
        text = text.replace("{drift} seconds", f"$DRIFT_TIME_{k} seconds")
    slow = deed.act is Act.DRIFT and deed.manner is Manner.SLOW
    if slow:
        phases.actor.ledger.take(f"{phases.actor.path}.does.{k}.manner")
    goes = 0.5 * (speed.low + speed.high) if speed.name else phases.actor.numbers.middle("SPEED")
    period = max(3.0, WAVE / goes)
    text = text.replace("{period}", f"{period:.2g}").replace("{weaves}", f"{1.5 * period:.2g}")
    drift = (SLOWER if slow else 1.0) * max(0.9, DRIFTS / goes)
    if deed.act is Act.DRIFT and (aside := speed_aside(phases.actor, k)) is not None:
        phases.actor.ledger.take(f"{phases.actor.path}.does.{k}.speed")
        usual = phases.actor.numbers.middle("DRIFT")
        drift = (usual if deed.distance is None else deed.distance.near(usual)) / (PIECES + 1) / aside.near(0.5)
    turns = phases.actor.seconds_to_turn(goes)
    far = JUST_BACK if phases.actor.then(k) in ENDS_THERE else BACK
    return text.replace("{back}", f"{max(1.0, turns) + far / goes:.2g}").replace("{drift}", f"{drift:.2g}")


def _bound(phases: Phases, k: int, text: str, steps: Steps, changed: str | None) -> str:
    """A phase with the amounts that were said of its deed, but for those that its pace or its rate has."""
    actor, deed = phases.actor, phases.actor.deeds[k]
    numbers, at = actor.numbers, f"{actor.path}.does.{k}"
    for amount, name in steps.binds.items():
        if (said := getattr(deed, amount)) is None or name in (changed, "SPEED", "THROTTLE"):
            continue
        if amount == "distance" and deed.act is Act.GO_ALONG:
            text = renamed(text, "GO_TIME", goes_so_far(actor, k, phases.paces.after[k]))
            continue
        own = f"{name}_{k}"
        if amount == "speed" and deed.act is Act.OVERTAKE and own in numbers.bound:
            text = renamed(text, name, own)
            continue
        numbers.bind(own, said, f"{at}.{amount}")
        if name in ("DRIFT", "SWERVE") and _over_the_edge(phases, deed):
            numbers.move(own, 0.5 * (LANE - actor.limits.width))
        text = renamed(text, name, own)
    return text


def _braking(phases: Phases, k: int, text: str, steps: Steps) -> str:
    """A phase that brakes as hard as was said, or as it began to."""
    actor, deed = phases.actor, phases.actor.deeds[k]
    numbers, at = actor.numbers, f"{actor.path}.does.{k}"
    if "$BRAKE" in text and brakes_by(
        actor, k, phases.paces.before[k], phases.paces.after[k], loses=steps.pace is Pace.LOSES
    ):
        return renamed(text, "BRAKE", f"BRAKE_{k}")
    if phases.goes_on_braking(k) and deed.acceleration is None and f"BRAKE_{k - 1}" in numbers.ranges:
        text = renamed(text, "BRAKE", f"BRAKE_{k - 1}")
    if deed.manner is not None and deed.manner in FIRM and deed.acceleration is None and "$BRAKE" in text:
        numbers.narrow(f"BRAKE_{k}", FIRM[deed.manner], 1.0)
        text = renamed(text, "BRAKE", f"BRAKE_{k}")
        actor.ledger.take(f"{at}.manner")
    elif deed.manner is Manner.SLIGHT and (name := next((one for one in _FAR if f"${one}" in text), "")):
        low, high, *_ = numbers.range_of(name)
        numbers.narrow(f"{name}_{k}", low, low + A_LITTLE * (high - low))
        text = renamed(text, name, f"{name}_{k}")
        actor.ledger.take(f"{at}.manner")
    elif _shows_nothing_more(deed, lasting=steps.lasting):
        actor.ledger.take(f"{at}.manner")
    return text


def _shows_nothing_more(deed: Deed, *, lasting: bool) -> bool:
    """Whether a manner is there anyway: a number says it, or nobody shows beforehand what it is about to do."""
    sudden = deed.manner is Manner.SUDDEN and (deed.act not in GOES_ON or not lasting)
    return sudden or (deed.manner in PACES and deed.manner is not None and deed.speed is not None)


def _over_the_edge(phases: Phases, deed: Deed) -> bool:
    """Whether somebody leaves its lane for the ego's: what was said is then how far it is over the edge of that."""
    start, toward = phases.actor.one.starts, phases.actor.stand.meets is Meets.TOWARD
    away = start.side if not toward else Side.LEFT
    return (toward or start.where in NEXT_LANE) and deed.to is not away


def _at_a_rate(phases: Phases, k: int, steps: Steps) -> bool:
    """Whether it was said how hard, or in which time, speed is gained by a deed."""
    deed = phases.actor.deeds[k]
    timed = (deed.time or deed.distance) is not None and steps.binds.get("time") == "THROTTLE"
    return timed or rate_of(phases.actor, k) is not None


def renamed(text: str, name: str, own: str) -> str:
    """A text that reads another parameter in the place of one."""
    return re.sub(rf"\${name}(?![A-Z0-9_])", f"${own}", text)
