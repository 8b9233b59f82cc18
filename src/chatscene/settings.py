"""Every number a run depends on, with the paper's value as the default and its source beside it."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import MISSING, dataclass, field, fields
from numbers import Integral, Real

from chatscene.errors import SettingsError, no_such

SELECTIONS = ("distinct", "shown", "worst", "last")
OBJECTIVES = ("avoidable", "collision")
PHYSICS = ("kinematic", "lagged")
MOST_READINGS = 3  # how many readings of a text are offered
EGO = "planner"  # who drives where no ego is named: it sees everybody and has the whole brake (decision 0077)
SIMULATOR = "native"  # what a run's scenes drive in where no simulator is named (decision 0081)
EXECUTOR = "processes"  # who works on the parts of a run where nobody is named
PAPER_READER = "paper"  # the paper's own way: snippets, by wording alone
READ_AS = ("situation", PAPER_READER)
OFFLINE = "offline"  # the project's own reader, in place of a language model


MANY = (1, 1_000_000)
"""How many of anything that is counted may be asked for."""
SEEDS = (0, 2**63 - 1)
SPEEDS = (1.0, 300.0)
"""What an ego may be asked to drive at [km/h]."""


def whole(name: str, value: object, least: int, most: int) -> int:
    """A whole number that a caller gives, of whatever integer type.

    Raises:
        SettingsError: It is none, or beyond its range.
    """
    number = int(value) if not isinstance(value, bool) and isinstance(value, Integral) else None
    if number is None or not least <= number <= most:
        raise SettingsError(f"{name} must be a whole number from {least:,} to {most:,}, not {value!r}")
    return number


def finite(name: str, value: object, least: float, most: float) -> float:
    """A number that a caller gives, of whatever real type.

    Raises:
        SettingsError: It is none, or beyond its range.
    """
    number = float(value) if not isinstance(value, bool) and isinstance(value, Real) else math.nan
    if not least <= number <= most:  # NaN is neither
        raise SettingsError(f"{name} must be a number from {least:,} to {most:,}, not {value!r}")
    return number


def check_settings(settings: object, limits: Mapping[str, tuple[float, float]]) -> None:
    """Hold every field to its kind and every number to its range; a run's record is as good as what a user typed.

    Raises:
        SettingsError: One is not; the message names it and the range.
    """
    for setting in fields(settings):  # type: ignore[arg-type]
        if setting.default is MISSING:  # a mapping, which is looked at where it is used
            continue
        name, value, kind = setting.name, getattr(settings, setting.name), type(setting.default)
        if name in limits:
            given = (whole if kind is int else finite)(name, value, *limits[name])  # type: ignore[arg-type]
            if type(value) not in (int, float):  # numpy's, which JSON does not know
                object.__setattr__(settings, name, given)
            continue
        fits = type(value) is kind or (kind is float and type(value) is int)
        if not fits or "\0" in str(value):
            raise SettingsError(f"{name} must be {_KINDS[kind]}, not {value!r}")


_KINDS: dict[type, str] = {int: "a whole number", float: "a number", bool: "true or false", str: "text"}


@dataclass(frozen=True, slots=True, kw_only=True)
class SearchSettings:
    """How parameters are moved toward collision (paper, sections 3.3 and 4.2; released code, ``scenic_utils.py``).

    Attributes:
        scenes: Simulations per scenario and route (paper: 50).
        block: Scenes between two range updates (paper: 10).
        keep: Scenes selected per scenario and route (paper: 2).
        avoidable_only: Whether to keep no collision that a careful driver would not have avoided (paper: no).
        routes: Routes per scenario (paper: 10; a run on a laptop starts with 1).
        tries: Draws allowed until one scene spawns without overlap.
        selection: ``distinct``: drives that show what was said first, of these collisions, of these those that a
            careful driver would have avoided, one of each kind of crash before a second of any
            (`chatscene.measure.crash_type`), of these the lowest scores; those in which the ego only waits come last
            of the others. ``shown``: drives that show what was said, of these collisions, of these the lowest scores;
            ``worst``: collisions, whatever they show (paper); ``last``: where the search ended, whatever came of it
            (how the reference ships its baselines).
        sampler: Who says where to look next, one of `chatscene.search.sampler.SAMPLERS` (paper: its own rule).
        objective: What the search is after: ``collision``, the harder the better (paper); ``avoidable``, collisions
            that a careful driver would have avoided before others, and of these those in which the ego struck.
        seed: Everything random derives from it.
    """

    scenes: int = 50
    block: int = 10
    keep: int = 2
    avoidable_only: bool = False
    routes: int = 1
    tries: int = 100
    selection: str = "distinct"
    sampler: str = "quality-diversity"
    objective: str = "avoidable"
    seed: int = 0

    def __post_init__(self) -> None:
        check_settings(
            self,
            {
                "scenes": MANY,
                "block": MANY,
                "keep": MANY,
                "routes": (1, 1_000),
                "tries": (1, 10_000),
                "seed": SEEDS,
            },
        )
        if self.selection not in SELECTIONS:
            raise SettingsError(no_such("selection", self.selection, SELECTIONS))
        if self.objective not in OBJECTIVES:
            raise SettingsError(no_such("objective", self.objective, OBJECTIVES))


PAPER = SearchSettings(routes=10, selection="worst", sampler="paper", objective="collision")
"""The search as in the paper's experiment (section 4.2)."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SimulationSettings:
    """How an episode is stepped, by what, and when it ends (SafeBench v1, ``carla_env.py``).

    Attributes:
        dt: Step [s] (0.1).
        max_steps: Steps after which an episode is cut (300).
        simulator: What runs it, one of `chatscene.simulate.simulator.SIMULATORS`.
        physics: How its bodies answer to pedals and wheel, one of `PHYSICS`: ``kinematic``, at once within what their
            kind can do; ``lagged``, with build-up, yaw lag and a friction circle
            (`chatscene.simulate.embedded.lagged`). A simulator with an engine of its own has no choice here, and says
            in its identity what moves its bodies.
        occlusion: Whether bodies hide others from the ego (`chatscene.terms.sight`).
    """

    dt: float = 0.1
    max_steps: int = 300
    simulator: str = "embedded"
    physics: str = "kinematic"
    occlusion: bool = True

    def __post_init__(self) -> None:
        check_settings(self, {"dt": (0.001, 1.0), "max_steps": (1, 100_000)})
        if self.physics not in PHYSICS:
            raise SettingsError(no_such("physics", self.physics, PHYSICS))


DRAWS = 10
"""Drives that are made of a program with parameters that nobody searches with."""


@dataclass(frozen=True, slots=True, kw_only=True)
class VerifySettings:
    """How what somebody else wrote or recorded is held against what was said.

    Attributes:
        draws: How many drives of a program are judged, or scenes of a run.
        seed: What their values are drawn by.
        least: The share of the drives that must show a fact, of those that came to it.
        ego: Who drives a program; empty for its own ego, or the usual one where it has none.
        map_name: The map of a program, in place of the one that it names; empty for that one, or else for the first
            packaged one that has what it asks for.
        trust: Whether a program may use all of Scenic and Python, in this process.
        as_written: Whether a program's own ego drives, of an imported scenario as its file says.
        ego_id: Whose track of a recording is the ego's; empty for the one that is marked.
        scene_id: Which scene of a run; empty for those that it keeps.
        within: The folder in which every other file lies that a program names; empty for any.
        budget: Processor time [s] for scenes that cannot be driven, over all drives; then no more are tried.
        variant: Which set of parameter values of a file of such sets, from 1; 0 for as many of them as there are
            drives.
        given: Parameters of a program, or of a file of OpenSCENARIO, by name.
    """

    draws: int = DRAWS
    seed: int = 0
    least: float = 0.5
    budget: float = 60.0
    variant: int = 0
    given: Mapping[str, object] = field(default_factory=dict[str, object])
    ego: str = ""
    map_name: str = ""
    trust: bool = False
    as_written: bool = False
    ego_id: str = ""
    scene_id: str = ""
    within: str = ""

    def __post_init__(self) -> None:
        check_settings(
            self,
            {
                "draws": (1, 1_000),
                "seed": SEEDS,
                "least": (0.0, 1.0),
                "budget": (0.0, 1e6),
                "variant": (0, 10**9),
            },
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class RetrievalSettings:
    """How a text is read, and how a triple of snippets is chosen where one is.

    Attributes:
        candidates: How many candidates per component are kept and shown (the released code looks at 3).
        refuse_below: Confidence under which nothing is run.
        library: Folder of the user's own snippets beside the packaged ones; empty for none.
        embedder: Who measures the wording of behaviors.
        language_model: Who reads sentences; ``offline`` stands for the project's own reader.
        reader: What is made of a text: a ``situation``, which is built, or for which snippets of one's own are chosen,
            and which is refused where it is doubtful; ``paper``: snippets are found by the wording of a sub-description
            per component alone (paper, section 3.3).
        reading: Which of the likeliest readings is taken, from 1; 0 for the likeliest, if it is likely enough.
        stated: Facts that the user says beside the text, such as ``side=left actions=brake,stop``.
    """

    candidates: int = 5
    refuse_below: float = 0.5
    library: str = ""
    embedder: str = "minilm"
    language_model: str = OFFLINE
    reader: str = READ_AS[0]
    reading: int = 0
    stated: str = ""

    def __post_init__(self) -> None:
        check_settings(self, {"candidates": (1, 1_000), "refuse_below": (0.0, 1.0), "reading": (0, MOST_READINGS)})
        if self.reader not in READ_AS:
            raise SettingsError(no_such("reader", self.reader, READ_AS))


@dataclass(frozen=True, slots=True, kw_only=True)
class Settings:
    """All settings of a run."""

    search: SearchSettings = field(default_factory=SearchSettings)
    simulation: SimulationSettings = field(default_factory=SimulationSettings)
    retrieval: RetrievalSettings = field(default_factory=RetrievalSettings)
