"""What a run came to, in a few lines."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from chatscene import runs
from chatscene.measure.score import wilson
from chatscene.report.egos import egos_in_words
from chatscene.report.how_fast import TOLD_BY, how_fast
from chatscene.report.what_happened import kept_in_words

SHORTEST = 0.1  # [s] of a phase that is told


@dataclass(frozen=True, slots=True, kw_only=True)
class Summary:
    """What a run came to.

    Attributes:
        counts: As in `run.json`.
        seconds: Wall time, of every call that worked on the folder.
        phases: Of these, how many went where, by phase; empty where that was not recorded.
        ego: Who drove, and what it sees: no collision rate means anything without it.
        stepped: Who stepped the drives; empty where that was not recorded.
        fast: How fast who was, in words; empty where that was not kept.
        kept: What happened in the scenes that are kept, in words; empty where that was not kept.
    """

    counts: Mapping[str, int]
    seconds: float
    ego: str
    phases: Mapping[str, float] = field(default_factory=dict[str, float])
    stepped: str = ""
    fast: str = ""
    kept: str = ""

    @classmethod
    def of(cls, run: runs.Workspace) -> Summary:
        """The summary of a run."""
        record = runs.read_record(run)
        return cls(
            counts=runs.read_counts(run),
            seconds=record.timings.get("total", 0.0),
            ego=egos_in_words(record)[0],
            phases={name: spent for name, spent in record.timings.items() if name != "total"},
            stepped=stepped_in_words(record),
            fast=how_fast(runs.each_scene(run, TOLD_BY), whole=lambda row: _whole(run, row)),
            kept=kept_in_words(runs.read_scenes(run, selected=True)),
        )

    def in_words(self) -> str:
        """Lines for a person: what came of it, how fast, what the ego sees, who stepped it, where the time went."""
        ran = self.counts["ran"]
        rejected = f", {self.counts['rejected']} draws rejected" if self.counts["rejected"] else ""
        kept, fill_in = self.counts["selected"], self.counts["fill_in"]
        unlike = kept - self.counts.get("selected_shown", kept)  # folders of before it was counted
        but = [self.kept] if self.kept else [f"{fill_in} without a collision"] * bool(fill_in)
        but += [f"{unlike} that {'does' if unlike == 1 else 'do'} not show all that was read"] * bool(unlike)
        phases = "; ".join(f"{name} {spent:.1f} s" for name, spent in self.phases.items() if spent >= SHORTEST)
        return (
            f"{ran} scene{'s' * (ran != 1)} in {self.seconds:.1f} s{rejected}: "
            f"the ego {outcomes_in_words(self.counts)}; {kept} kept"
            + (f" ({', '.join(but)})" if but else "")
            + (f"\n{self.fast}" if self.fast else "")
            + f"\n{self.ego}"
            + (f"\n{self.stepped}" if self.stepped else "")
            + (f"\ntime: {phases}" if phases else "")
        )


def _whole(run: runs.Workspace, row: Mapping[str, Any]) -> Mapping[str, Any]:
    return runs.read_scenes(run, ids=[row["scene_id"]])[0]


def outcomes_in_words(counts: Mapping[str, int]) -> str:
    """What the ego did in the drives, in one line: no collision alone is not yet a drive that went well."""
    ran, collided = counts["ran"], counts["collided"]
    low, high = wilson(collided, ran)
    told = [f"collided in {collided} ({collided / max(ran, 1):.0%}, 95 % interval {low:.0%} to {high:.0%})"]
    if (off := counts.get("off_road")) is not None:
        told.append(f"left the road in {off}")
    if late := counts.get("timeout"):
        told.append(f"ran out of time in {late}")
    if waiting := counts.get("waiting"):
        told.append(f"waited behind somebody to the end in {waiting}")
    return ", ".join(told)


def stepped_in_words(record: runs.MapRecord) -> str:
    """One line: which simulator stepped how many drives, and why not the one that was asked for."""
    if not record.stepped:
        return ""
    shares = ", ".join(f"{count} by {name}" for name, count in record.stepped.items())
    why = "; ".join(
        f"{len(scenes)} scene{'s' * (len(scenes) > 1)}: {reason}" for reason, scenes in record.instead.items()
    )
    return f"stepped: {shares}" + (f" (not by {record.simulator.name}: {why})" if why else "")
