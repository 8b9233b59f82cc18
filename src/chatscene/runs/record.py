"""What `run.json` says, and what one finished block leaves until the tables are written."""

from __future__ import annotations

from dataclasses import asdict
from enum import StrEnum
from typing import Any

from pydantic import BaseModel, ConfigDict, ValidationError

from chatscene.errors import SettingsError
from chatscene.settings import RetrievalSettings, SearchSettings, Settings, SimulationSettings

SCHEMA_VERSION = 2
DIGESTS_SINCE = 2  # version of a folder that keeps a digest of every file, of `run.json` and of each part


class Status(StrEnum):
    """How far a run came."""

    RUNNING = "running"  # or killed: a dead process cannot say so
    DONE = "done"
    FAILED = "failed"  # an error ended it; may be continued
    REFUSED = "refused"  # no program shows what was read in the sentence


class _Frozen(BaseModel):
    model_config = ConfigDict(frozen=True, extra="ignore")


class SourceRecord(_Frozen):
    """A run whose scenes an evaluation drives.

    Attributes:
        folder: Its absolute path.
        scenario_id: Its scenario.
        base: The base scenario it belongs to.
        generator: Who made its scenes.
        first_route: Scenes on earlier routes are left out.
        kept_for: The ego against which its scenes were selected; empty where every scene is driven.
    """

    folder: str
    scenario_id: str
    base: str
    generator: str
    first_route: int = 0
    kept_for: str = ""


class SimulatorRecord(_Frozen):
    """What ran the scenes; see `chatscene.terms.simulator.SimulatorIdentity`.

    Attributes:
        name: Its name in the table of simulators.
        version: Version of what its numbers depend on; empty in the records of older versions.
        physics: How it moves bodies, in a few words; empty in the records of older versions.
    """

    name: str = SimulationSettings().simulator
    version: str = ""
    physics: str = ""


class RunRecord(_Frozen):
    """The content of `run.json`.

    Attributes:
        schema_version: Of the whole folder; this chatscene writes and reads `SCHEMA_VERSION`.
        status: How far the run came.
        reason: Why it failed or was refused; else empty.
        text: The sentence.
        map_name: The map as it was given.
        map_digest: SHA-256 of its file; empty in the records of older versions.
        ego: The ego as it was given; of an evaluation, the egos, comma between them.
        ego_digests: SHA-256 of each ego that is a file, by the ego as it was given.
        senses: What each ego sees and brakes with, by ego, as `chatscene.ego.policy.senses_of` names it.
        generator: Who made the scenes.
        simulator: What ran them.
        command: What the folder holds: a ``run``, or an ``evaluate`` of egos on scenes of runs.
        sources: Of an evaluation: the runs whose scenes were driven.
        failures: Of an evaluation: why an ego was given up, by ego.
        settings: All settings, resolved, as `Settings` nests them.
        versions: Of what the numbers depend on.
        seed: What everything random derives from.
        counts: scenes, ran, rejected, collided, selected, selected_shown, fill_in; empty until there are some.
        timings: Seconds by phase, and whatever else differs between two equal runs (such as ``jobs``).
        files: SHA-256 of every other file, by its path in the folder; empty until the run is finished.
        digest: SHA-256 of `run.json` itself, while this one is empty.
    """

    schema_version: int
    status: Status
    reason: str = ""
    text: str
    map_name: str
    map_digest: str = ""
    ego: str
    ego_digests: dict[str, str] = {}
    senses: dict[str, dict[str, str]] = {}
    generator: str = "chatscene"
    simulator: SimulatorRecord = SimulatorRecord()
    command: str = "run"
    sources: list[SourceRecord] = []
    failures: dict[str, str] = {}
    settings: dict[str, dict[str, Any]]
    versions: dict[str, str] = {}
    seed: int
    counts: dict[str, int] = {}
    timings: dict[str, float] = {}
    files: dict[str, str] = {}
    digest: str = ""

    @property
    def egos(self) -> tuple[str, ...]:
        """Who drives: the surrogate of a run, or the egos of an evaluation."""
        return egos_of(self.command, self.ego)


def egos_of(command: str, ego: str) -> tuple[str, ...]:
    """The egos by name; of an evaluation there is a comma between them."""
    return tuple(ego.split(",")) if command == "evaluate" else (ego,)


class RangeRow(_Frozen):
    """What one parameter was drawn from in one block."""

    parameter: str
    low: float
    high: float
    unit: str
    meaning: str = ""


class SceneRow(_Frozen):
    """One scene, driven or rejected; see `chatscene.runs.tables` for the columns it becomes."""

    scene_id: str
    seed: int
    values: dict[str, float]
    reason: str | None = None  # of a rejection; None for a scene that was driven
    meaning_failures: list[str] = []
    collision: bool | None = None
    impact_speed: float | None = None
    ego: str | None = None
    ending: str | None = None
    route_completion: float | None = None
    dt: float | None = None
    metrics: dict[str, float] = {}
    measurements: dict[str, float | None] = {}
    criticality: dict[str, float | None] = {}
    severity: str | None = None
    fault: str | None = None
    avoidable: bool | None = None


class EventRow(_Frozen):
    """One event of one drive."""

    scene_id: str
    ego: str
    step: int
    kind: str
    actor: str
    other: str
    side: str
    impact_speed: float


class SignalRow(_Frozen):
    """One traffic signal over one drive; see `SignalTrack`."""

    scene_id: str
    ego: str
    role: str
    x0: float
    y0: float
    x1: float
    y1: float
    state: str


class Part(_Frozen):
    """A finished block without its tracks.

    Attributes:
        scenario_id: Which scenario.
        route: Index of the route.
        block: Which block, from 0.
        ranges: What its scenes were drawn from.
        scenes: Driven ones in order, then rejected ones in order.
        events: By scene, then by step.
        signals: By scene.
        tracks: SHA-256 of the file with its tracks.
        digest: SHA-256 of the part itself, while this one is empty.
    """

    scenario_id: str
    route: int
    block: int
    ranges: list[RangeRow]
    scenes: list[SceneRow]
    events: list[EventRow]
    signals: list[SignalRow]
    tracks: str = ""
    digest: str = ""


def settings_to_json(settings: Settings) -> dict[str, dict[str, Any]]:
    """Settings as nested JSON objects; `settings_of` is the inverse."""
    return asdict(settings)


def settings_of(record: RunRecord) -> Settings:
    """The settings a run was started with, to continue it.

    Raises:
        SettingsError: They name something this version does not know, or are out of range.
    """
    given = record.settings
    try:
        return Settings(
            search=SearchSettings(**given.get("search", {})),
            simulation=SimulationSettings(**given.get("simulation", {})),
            retrieval=RetrievalSettings(**given.get("retrieval", {})),
        )
    except TypeError as error:
        raise SettingsError(f"the run's settings are not those of this version of chatscene: {error}") from error


def first_problem(error: ValidationError) -> str:
    """The first complaint of pydantic, as ``field: what is wrong``."""
    problem = error.errors()[0]
    return f"{'.'.join(str(part) for part in problem['loc'])}: {problem['msg'].lower()}"
