"""A crash in words: who struck whom, how fast both were at which moment, and until when it could have been avoided."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from chatscene.measure.counterfactual import Braking, Trial
from chatscene.measure.criticality import fault, part_struck
from chatscene.measure.severity import in_kmh, none_told, told
from chatscene.measure.speeds import risks, speeds
from chatscene.measure.struck import struck_in_words
from chatscene.simulate.striking import Strike, strike
from chatscene.terms.actors import named, noun_of
from chatscene.terms.arrays import Array
from chatscene.terms.criticality import Fault
from chatscene.terms.speeds import Speeds


@dataclass(frozen=True, slots=True, kw_only=True)
class Contact:
    """Who struck whom.

    Attributes:
        time: When [s].
        ego_part: Where on the ego: ``front``, ``rear``, ``left`` or ``right``.
        other_part: Where on the other; empty of a walker or a thing.
        ego_speed: Before the step that ended in contact [m/s].
        other_speed: The same [m/s].
        impact_speed: Their relative speed then [m/s].
    """

    time: float
    other: str
    kind: str
    fault: Fault
    strike: Strike
    ego_part: str
    other_part: str
    ego_speed: float
    other_speed: float
    impact_speed: float

    @classmethod
    def of(cls, trial: Trial) -> Contact:
        """How a scene crashed."""
        episode, crash, struck = trial.episode, trial.crash, trial.struck
        who, how = fault(episode), strike(episode)
        assert who is not None and how is not None
        return cls(
            time=round(crash.step * episode.dt, 6),
            other=struck.actor,
            kind=struck.kind,
            fault=who,
            strike=how,
            ego_part=crash.side,
            other_part=part_struck(struck, episode.ego_track, crash),
            ego_speed=float(episode.ego_track.speed[max(crash.step - 1, 0)]),
            other_speed=float(struck.speed[max(crash.step - 1, 0)]),
            impact_speed=crash.impact_speed,
        )

    def in_words(self, kinds: Mapping[str, str]) -> str:
        """One sentence, without its end."""
        called = named(self.other, self.kind, kinds)
        met = struck_in_words(self.strike, ("the ego", self.ego_part), (called, self.other_part), past=True)
        return (
            f"at {self.time:.1f} s {met}: ego at {in_kmh(self.ego_speed)}, "
            f"{noun_of(self.kind)} at {in_kmh(self.other_speed)}, impact speed {in_kmh(self.impact_speed)}"
        )


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Pace:
    """How fast the ego and whom it struck were over time, and what the impact did.

    Attributes:
        ego: (T,) The ego's speed [m/s], without a sign.
        other: (T,) The other's.
        dt: Length of a step [s].
        speeds: The same in numbers, before the encounter and at the impact.
        harm: What published injury-risk curves say of such an impact, in clauses; empty if none is of it.
    """

    ego: Array
    other: Array
    noun: str
    dt: float
    speeds: Speeds
    harm: tuple[str, ...]

    @classmethod
    def of(cls, trial: Trial) -> Pace:
        """Of a scene that crashed."""
        episode = trial.episode
        return cls(
            ego=np.abs(episode.ego_track.speed),
            other=np.abs(trial.struck.speed),
            noun=noun_of(trial.struck.kind),
            dt=episode.dt,
            speeds=speeds(episode),
            harm=told(*risks(episode)),
        )

    def at(self, time: float) -> str:
        """How fast both were at a time [s], in words."""
        ego, other = self._at(time)
        return f"ego at {in_kmh(ego)}, {self.noun} at {in_kmh(other)}"

    def moment(self, time: float) -> dict[str, float]:
        """The same for a script: ``time`` [s], ``ego_speed`` and ``other_speed`` [m/s]."""
        return dict(zip(("time", "ego_speed", "other_speed"), (time, *self._at(time)), strict=True))

    def in_words(self) -> str:
        """How fast both were before the encounter, and what such an impact does."""
        begins = self.speeds.encounter_time or 0.0
        how = f"As the encounter began, at {begins:.1f} s: {self.at(begins)}."
        harm = "; ".join(self.harm) or none_told(
            (self.speeds.ego_kind, self.speeds.other_kind), (self.speeds.ego_delta_v, self.speeds.other_delta_v)
        )
        return f"{how} {harm[0].upper()}{harm[1:]}."

    def _at(self, time: float) -> tuple[float, float]:
        step = min(round(time / self.dt), len(self.ego) - 1)
        return float(self.ego[step]), float(self.other[step])


def last_moment_in_words(moment: float | None, contact: float, risk: float | None, pace: Pace) -> str:
    """Until when a careful driver's braking avoids a crash; times in the scene [s]."""
    if moment is None:
        return "At no moment does a careful driver's braking avoid the crash."
    when = f"{moment:.1f} s, {contact - moment:.1f} s before the contact{_foreseen(moment, risk)} ({pace.at(moment)})"
    return f"The last moment at which a careful driver's braking avoids the crash is {when}."


def braking_in_words(braking: Braking | None, contact: float, risk: float | None, pace: Pace) -> str:
    """From when on the ego's own braking avoids a crash.

    Args:
        braking: The latest that does.
        contact: When it crashed [s].
        risk: From when on it can be seen coming [s].
        pace: How fast both were.
    """
    dt = pace.dt
    if braking is None:
        return "The ego does not avoid the crash by braking as hard as it can, from whatever moment on."
    begins, own = braking.step * dt, braking.own
    if own is None:
        how = "it did not brake"
    elif braking.let_go is not None:
        how = f"it braked from {own * dt:.1f} to {braking.let_go * dt:.1f} s, and let go"
    elif own > braking.step:
        how = f"{(own - braking.step) * dt:.1f} s earlier than it did"
    else:
        how = f"it braked from {own * dt:.1f} s on, but less hard"
    when = f"{begins:.1f} s on, {contact - begins:.1f} s before the contact{_foreseen(begins, risk)}"
    when += f" ({pace.at(begins)})"
    return (
        f"The ego avoids the crash if it brakes as hard as it can ({braking.deceleration:g} m/s²) from {when}; {how}."
    )


def _foreseen(time: float, risk: float | None) -> str:
    return ", before it can be seen coming" if risk is not None and time < risk - 1e-6 else ""
