"""What kind of crash a crash is, so that a second of a kind can be told from another kind; and what is none at all."""

from __future__ import annotations

import math

from chatscene.measure.criticality import fault, part_struck, severity_of
from chatscene.measure.sums import sums
from chatscene.terms.arrays import paces
from chatscene.terms.episode import Episode

PLACE = 10.0  # [m] of the ego's way within which two crashes are in one place
HEADED = ("same way", "to the left", "oncoming", "to the right")  # the other, as the ego sees it, by quarter turns


def crash_type(episode: Episode) -> str:
    """The kind of a drive's first collision, in words; empty without one.

    Two are of one kind if the same party struck the other, the same parts of the same kinds of road user met, the
    severity is of one class, the other headed the same way to a quarter turn, and the ego had driven as far to
    `PLACE`. What the values of parameters were is no part of it.
    """
    crash, who = episode.collision, fault(episode)
    if crash is None or who is None:
        return ""
    ego = episode.ego_track
    other = next(track for track in episode.tracks if track.actor == crash.other)
    driven = float(paces(ego.x[: crash.step + 1], ego.y[: crash.step + 1]).sum())
    turned = float(other.heading[crash.step] - ego.heading[crash.step])
    struck = f"{other.kind} {part_struck(other, ego, crash)}".strip()
    headed = HEADED[round(turned / (math.pi / 2)) % 4]
    severity = severity_of(crash.impact_speed, other)
    return f"{who}, {crash.side} and {struck}, {headed}, {severity}, after {int(driven // PLACE * PLACE)} m"


def waits(episode: Episode) -> bool:
    """Whether the ego stands at the end beside or behind somebody who stands as well, and both have for a while.

    It is no crash, and no near miss: a drive whose time ran out in front of a blocker tells nothing of the ego.
    """
    return sums(episode).waits
