"""The kept scenes of a run driven again, to be shown beside what happened: by another ego, and braking earlier.

Only what repeats itself to the bit is driven again: a drive that is shown beside another must be of the same scene.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from chatscene.ego.asking import fitted
from chatscene.ego.policy import in_words, load_ego, senses_of
from chatscene.errors import ChatSceneError, RunError
from chatscene.measure.counterfactual import last_moment, latest_braking
from chatscene.runs.crash import Contact, Pace, braking_in_words, last_moment_in_words
from chatscene.runs.rebuild import Remade, remade
from chatscene.runs.record import RunRecord, settings_of
from chatscene.runs.tables import scene_of
from chatscene.runs.trust import Repeated, follow
from chatscene.runs.why import trial_in
from chatscene.runs.workspace import Workspace, read_record
from chatscene.simulate.simulator import simulate
from chatscene.terms.episode import Episode
from chatscene.terms.scene import Rejected

OTHERS = ("idm", "planner")  # who drives beside: the first of them that did not drive itself
TOLD = 4  # of how many crashes it is told when braking would have avoided them; some dozens of drives each
REPEATING = ("native", "embedded")  # simulators that give the same drive again, bit for bit, at no cost to speak of


@dataclass(frozen=True, slots=True, kw_only=True)
class Mark:
    """A moment of a scene."""

    step: int
    said: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Story:
    """How a scene crashed, and until when braking would have avoided it."""

    said: tuple[str, ...]
    marks: tuple[Mark, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Beside:
    """What is shown beside the kept scenes of a run.

    Attributes:
        ego: Who drove them as well; empty if nobody did.
        stories: Of the first crashes, by scene.
        why_not: Why nothing was driven again; empty if it was.
    """

    ego: str = ""
    senses: str = ""
    drives: Mapping[str, Episode] = field(default_factory=dict[str, Episode])
    stories: Mapping[str, Story] = field(default_factory=dict[str, Story])
    why_not: str = ""


def drive_beside(run: Workspace, rows: Sequence[Mapping[str, Any]], *, followed: bool) -> Beside:
    """Drive scenes of a run again: with another ego, and the first that crashed with the brake pressed earlier."""
    if not rows:
        return Beside()
    record = read_record(run, RunRecord)
    simulation = settings_of(record).simulation
    if (where := simulation.simulator) not in REPEATING:
        return Beside(why_not=f"the simulator {where} is not asked twice")
    if not followed:
        try:
            follow(Repeated(), egos_of=[run], simulators_of=[run], joining_of=[run])
        except RunError:
            return Beside(why_not="the run uses code that is not packaged, so it cannot be run here")
    try:
        return _beside(remade(run), record.ego, rows, occlusion=simulation.occlusion)
    except ChatSceneError as error:
        return Beside(why_not=str(error).replace(str(run.path), "the run"))


def _beside(made: Remade, drove: str, rows: Sequence[Mapping[str, Any]], *, occlusion: bool) -> Beside:
    if made.program.as_written:
        return Beside(why_not="the program's own ego drives")
    name = next(one for one in OTHERS if one != drove)
    ego = load_ego(name)
    driven = [simulate(made.simulator, made.program, scene_of(row, made.program), ego) for row in rows]
    crashed = [row for row in rows if row["collision"]][:TOLD]
    return Beside(
        ego=name,
        senses=in_words(senses_of(fitted(ego, made.program), made.program.ego_kind, occlusion=occlusion)),
        drives={one.scene_id: one for one in driven if not isinstance(one, Rejected)},
        stories={row["scene_id"]: _story(made, row) for row in crashed},
    )


def _story(made: Remade, row: Mapping[str, Any]) -> Story:
    trial = trial_in(made, row)
    dt = trial.episode.dt
    contact, pace, risk = Contact.of(trial), Pace.of(trial), trial.risk
    seen = None if risk is None else risk * dt
    last, braking = last_moment(trial), latest_braking(trial)
    moments = {
        "it can be seen coming": risk,
        "last moment for a careful driver's brake": last,
        "last moment for the ego's own brake": braking and braking.step,
        "the ego brakes": braking and braking.own,
    }
    marks = [Mark(step=step, said=said) for said, step in moments.items() if step is not None]
    how = contact.in_words(trial.episode.kinds)
    return Story(
        said=(
            f"{how[0].upper()}{how[1:]}.",
            braking_in_words(braking, contact.time, seen, pace),
            last_moment_in_words(None if last is None else last * dt, contact.time, seen, pace),
        ),
        marks=tuple(sorted(marks, key=lambda mark: mark.step)),
    )
