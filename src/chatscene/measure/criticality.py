"""How close a drive came to harm, and who ran into whom; `docs/metrics.md` has each measure's definition.

All measures compare the ego with each adversary, over all steps at once, and keep the worst. Bodies are their boxes.
None of it depends on where the scene lies or which way it is turned.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

from chatscene.measure.sums import sums
from chatscene.simulate.contact import side_touched
from chatscene.simulate.striking import strike
from chatscene.terms.actors import BY_CLASS, LIMITS
from chatscene.terms.criticality import Criticality, Fault, Severity
from chatscene.terms.episode import Episode, Event, Role, Track

# Above which impact speed [m/s] S1, S2 and S3 begin; decision 0012 has the sources.
SEVERITY_VULNERABLE = (0.0, 29 / 3.6, 10.8)
SEVERITY_OCCUPANT = (7 / 3.6, 35 / 3.6, 52.5 / 3.6)


def criticality(episode: Episode) -> Criticality:
    """The measures of a drive; None where one does not apply."""
    crash, found = episode.collision, sums(episode)
    pairs = found.pairs
    touched = crash is not None and any(one.actor == crash.other for one in episode.adversaries)  # or between two steps
    return Criticality(
        time_to_collision=0.0 if touched else _least(soonest for _, _, soonest, *_ in pairs),
        post_encroachment_time=0.0 if touched else _least(steps * episode.dt for steps in found.parted),
        time_headway=_least(headway for *_, headway, _ in pairs),
        deceleration_required=max((braking for *_, braking in pairs if braking > 0.0), default=None),
        distance=0.0 if touched else _least(gap for gap, *_ in pairs),
        impact_speed=None if crash is None else crash.impact_speed,
        severity=None if crash is None else severity_of(crash.impact_speed, _struck(episode, crash)),
    )


def fault(episode: Episode) -> Fault | None:
    """Who struck whom in the first collision of a drive; None without one.

    `chatscene.simulate.striking` has the rule.
    """
    crash, struck = episode.collision, strike(episode)
    if crash is None or struck is None:
        return None
    if struck.static:
        return Fault.EGO_INTO_STATIC
    adversary = _struck(episode, crash).role is Role.ADVERSARY
    if struck.by_ego:
        return Fault.EGO_INTO_ADVERSARY if adversary else Fault.EGO_INTO_BACKGROUND
    return Fault.ADVERSARY_INTO_EGO if adversary else Fault.BACKGROUND_INTO_EGO


def part_struck(track: Track, by: Track, crash: Event) -> str:
    """Where on a vehicle another one touches it in a crash: ``front``, ``rear``, ``left`` or ``right``; else empty."""
    if track.kind not in LIMITS or not LIMITS[track.kind].wheelbase:
        return ""
    return side_touched(track, by, crash.step, crash.earlier)


def _struck(episode: Episode, crash: Event) -> Track:
    return next(track for track in episode.tracks if track.actor == crash.other)


def severity_of(speed: float, other: Track) -> Severity:
    """The class of injury that an impact speed [m/s] stands for, where the ego meets that road user or thing."""
    kind = BY_CLASS.get(other.kind)
    begins = SEVERITY_VULNERABLE if kind and kind.is_vulnerable else SEVERITY_OCCUPANT
    return list(Severity)[sum(speed > begin for begin in begins)]


def _least(values: Iterable[float]) -> float | None:
    return min((value for value in values if math.isfinite(value)), default=None)
