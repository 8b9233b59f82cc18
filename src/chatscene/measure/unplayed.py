"""What a program of one's own has that a drive did not show: phases that never began, a line that was driven off."""

from __future__ import annotations

import re

from chatscene.library.waiting_words import begins_in_words, to_do_in_words
from chatscene.terms.episode import Episode, Track
from chatscene.terms.plan import Kind, Name, Phase, Plan
from chatscene.terms.polyline import Polyline
from chatscene.terms.scene import ScenicProgram
from chatscene.terms.written_plans import WrittenPlan, written_plans

_POINT = re.compile(r"\(\s*(-?\d+(?:\.\d+)?)\s*,\s*(-?\d+(?:\.\d+)?)\s*\)")
_BEYOND = 1.0  # [m] past the end of a line from which on somebody has driven off it


def unplayed(program: ScenicProgram, episode: Episode) -> tuple[str, ...]:
    """What did not take place in a drive, in words that are the same for every drive in which it did not.

    Args:
        program: What was driven; of one that was made here, the drive is judged by what was said instead.
        episode: The drive.
    """
    if not program.own or not episode.reached:
        return ()
    plans, tracks = written_plans(program.source), {track.actor: track for track in episode.tracks}
    told: list[str] = []
    for actor, reached in episode.reached.items():
        plan = plans.get(reached.behavior)
        if isinstance(plan, WrittenPlan):
            phases = plan.plan.phases
            told += _never_began(actor, plan.plan, reached.phase)
            told += _off_its_line(tracks[actor], phases[min(reached.phase, len(phases) - 1)], program.source)
    return tuple(told)


def _never_began(actor: str, plan: Plan, reached: int) -> list[str]:
    """Phases after the last that began; in a loop, they may have begun in a round before."""
    if plan.loop is not None and reached >= plan.loop:
        return []
    left = [
        phase
        for number, phase in enumerate(plan.phases)
        if number > reached and not _goes_on(phase, plan.phases[number - 1])
    ]
    if not left:
        return []
    more = f", and {len(left) - 1} more after that" if len(left) > 1 else ""
    begins = begins_in_words(plan.phases[reached].end)
    return [f"this never began: {actor} was to {to_do_in_words(left[0])}, {begins}{more}"]


def _goes_on(phase: Phase, before: Phase) -> bool:
    """Whether a phase only goes on with what was done before, as one does who waits for the next.

    Who drives on as fast along the same line, only farther aside of it, is still moving over.
    """
    named = slice(2) if phase.primitive == "DrivePath" else slice(None)
    did = before.primitive, before.arguments[named]
    return before.end is not None and (phase.primitive, phase.arguments[named]) == did


def _off_its_line(track: Track, phase: Phase, source: str) -> list[str]:
    """Whether somebody went on where the line ends that is followed, as the lines of a road do where that ends."""
    for argument in phase.arguments:
        if isinstance(argument, Name) and argument.kind is Kind.PATH:
            line = _line(argument.id, source)
            if line is not None and _beyond(line, track) > _BEYOND:
                return [f"{track.actor} drives on past the end of its line {argument.id}"]
    return []


def _line(name: str, source: str) -> Polyline | None:
    """The line of a name, where the program has it point by point."""
    found = re.search(rf"^{name} *= *lineThrough\(([-.,()\s\d]*)\)[ \t]*$", source, re.MULTILINE)
    points = _POINT.findall(found[1]) if found else []
    return Polyline([(float(x), float(y)) for x, y in points]) if len(set(points)) > 1 else None


def _beyond(line: Polyline, track: Track) -> float:
    """How far [m] past the end of a line somebody is at last; below 0 before it."""
    xs, ys, _, hxs, hys = line.columns
    x, y = float(track.x[-1]), float(track.y[-1])
    if line.project(x, y)[0] < line.length:
        return -1.0
    return (x - xs[-1]) * hxs[-1] + (y - ys[-1]) * hys[-1]
