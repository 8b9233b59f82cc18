"""Programs, scenes and rejections.

Paper: section 3.1 ("Scenario", "Scene").
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import lru_cache

from chatscene.terms.actors import LIMITS, AdversaryKind, Limits
from chatscene.terms.snippet import ParameterRange

_WANTED = re.compile(r"^ego\s*=\s*new\b[^#]*?\bwith\s+wantedSpeed\s+(\d+(?:\.\d+)?)\s*(?:,|$)", re.MULTILINE)
_TOP = re.compile(r"^ego\s*=\s*new\b[^#\n]*?\bwith\s+topSpeed\s+(\d+(?:\.\d+)?)\s*(?:,|$)", re.MULTILINE)
_KEEPS = re.compile(r"^ego\s*=\s*new\b[^#]*?\bwith\s+keepsLimits\s+(True|False)\s*(?:,|$)", re.MULTILINE)
_PLACED = re.compile(r"^ego\s*=\s*new\s+(\w+)", re.MULTILINE)

CAR = AdversaryKind.CAR.row.scenic
"""The class of an ego of which nothing else is said."""
AS_WRITTEN = "AsWritten"
"""The behavior of an ego that does what an imported file says: only where that is asked for, and no ego under test."""
OWN_MODEL = "chatscene.world.model"
"""The world model of programs whose scenes are their parameters, no more: Scenic draws nothing in them."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ScenicProgram:
    """A complete Scenic program, joined from a triple of snippets or written by a user.

    Attributes:
        scenario_id: The scenario it expresses.
        source: The text; `scenic` compiles it as it stands.
        parameters: The declared ranges of everything that can be tuned in it.
        snippet_ids: Behavior, geometry, spawn.
        digest: Hash of `source`, hexadecimal.
        model: The world model that it is written for, as its `model` line says.
        as_written: Whether its own ego drives, as the program has it, and the ego under test only rides along.
        wanted_speed: What the ego under test is to drive at [m/s], as `with wantedSpeed` says; else None.
        keeps_limits: Whether the limits of the roads hold for it besides, as `with keepsLimits` says.
        ego_kind: The class of the ego, as the line says that places it; that of a car where none says so.
        own: What a user calls a program of his own, such as its file; empty for one that was made here.
    """

    scenario_id: str
    source: str
    parameters: tuple[ParameterRange, ...]
    snippet_ids: tuple[str, ...]
    digest: str = field(init=False)
    wanted_speed: float | None = field(init=False, compare=False)
    keeps_limits: bool = field(init=False, compare=False)
    ego_kind: str = field(init=False, compare=False)
    model: str = OWN_MODEL
    as_written: bool = False
    own: str = field(default="", compare=False)

    def __post_init__(self) -> None:
        object.__setattr__(
            self, "digest", hashlib.blake2b(self.source.encode(errors="surrogatepass"), digest_size=8).hexdigest()
        )
        found = None if self.drawn else _WANTED.search(self.source)
        object.__setattr__(self, "wanted_speed", float(found[1]) if found else None)
        keeps = None if self.drawn else _KEEPS.search(self.source)
        object.__setattr__(self, "keeps_limits", keeps is not None and keeps[1] == "True")
        placed = None if self.drawn else _PLACED.search(self.source)
        kind = placed[1] if placed else CAR
        object.__setattr__(self, "ego_kind", kind if kind in LIMITS else CAR)

    @property
    def ego_limits(self) -> Limits:
        """What the ego's vehicle can do."""
        return LIMITS[self.ego_kind] if self.drawn else _limits(self.source, self.ego_kind)

    @property
    def called(self) -> str:
        """What messages call it."""
        if self.own:
            return f"your program {self.own}"
        parts = f" ({', '.join(self.snippet_ids)})" if self.snippet_ids else ""
        return f"program {self.scenario_id!r}{parts}"

    @property
    def filename(self) -> str:
        """What Scenic calls its text."""
        return f"<{self.scenario_id}>"

    @property
    def drawn(self) -> bool:
        """Whether Scenic draws where things stand, so that each scene has a place and a route of its own."""
        return self.model != OWN_MODEL


@lru_cache(maxsize=64)
def _limits(source: str, kind: str) -> Limits:
    """What an ego of a class can do, as a program says it, which every drive asks."""
    found, limits = _TOP.search(source), LIMITS[kind]
    return replace(limits, top_speed=float(found[1])) if found else limits


def at_speed(program: ScenicProgram, speed: float) -> ScenicProgram:
    """A program whose ego is to drive at a speed, if none was said of it.

    One that is the speed of the road gives way, and so does what the ego begins at, if that is the same; what was said
    stays, and so does a program in which nothing can be wanted of the ego under test.

    Args:
        program: Which.
        speed: What is wanted [m/s].
    """
    if program.drawn or program.as_written or (program.wanted_speed is not None and not program.keeps_limits):
        return program
    source, number = program.source, f"{speed:.4g}"
    placed, found = _PLACED.search(source), _WANTED.search(source)
    if placed is None:
        return program
    if found is None:
        follows = source[placed.end() :].partition("\n")[0].partition("#")[0].strip()
        wanted = f" with wantedSpeed {number}" + ("," if follows else "")
        return replace(program, source=source[: placed.end()] + wanted + source[placed.end() :])
    begins = rf"(?:{re.escape(found[1])}(?![\d.])|speedOn\([^()]*\))"  # at what it wants, as far as it may
    told = re.sub(rf"(\bwith\s+(?:wantedSpeed|speed)\s+){begins}", rf"\g<1>{number}", found[0])
    source = source[: found.start()] + told + source[found.end() :]
    return replace(program, source=re.sub(r"(\bwith\s+keepsLimits\s+)True\b", r"\1False", source, count=1))


@dataclass(frozen=True, slots=True, kw_only=True)
class Scene:
    """One concrete instance of a scenario: enough to replay it exactly.

    Attributes:
        id: ``<scenario>/route-<k>/scene-<n>``.
        scenario_id: The scenario it belongs to.
        route: Index of the route on the map, for the program's geometry.
        block: Which of the blocks between two range updates it was drawn in.
        seed: The seed its values were drawn with; they are stored, never drawn again. Whatever else a program draws,
            it draws with this seed.
        values: The concrete value of each ``OPT_`` parameter, in the unit its range declares.
    """

    id: str
    scenario_id: str
    route: int
    block: int
    seed: int
    values: Mapping[str, float]


@dataclass(frozen=True, slots=True, kw_only=True)
class Rejected:
    """A scene that could not be run, with the reason; counted and shown, never dropped.

    Attributes:
        scene: Which one.
        reason: Why, in words.
        draws: How many draws of its places were tried.
        spent: The processor time [s] that they took.
        without: Whether its map has no such place, so that no scene of the program can be run there.
    """

    scene: Scene
    reason: str
    draws: int = 1
    spent: float = field(default=0.0, compare=False)
    without: bool = False
