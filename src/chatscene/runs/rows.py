"""What one finished block leaves until the tables are written: rows of scenes, ranges, events and signals."""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict


class _Row(BaseModel):
    model_config = ConfigDict(frozen=True, extra="ignore")


class RangeRow(_Row):
    """What one parameter was drawn from in one block."""

    parameter: str
    low: float
    high: float
    unit: str
    meaning: str = ""


class SceneRow(_Row):
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
    light: str | None = None
    weather: str | None = None
    surface: str | None = None
    metrics: dict[str, float] = {}
    measurements: dict[str, float | None] = {}
    criticality: dict[str, float | None] = {}
    speeds: dict[str, float | None] = {}
    ego_kind: str | None = None
    other_kind: str | None = None
    severity: str | None = None
    fault: str | None = None
    avoidable: bool | None = None
    crash_type: str = ""
    happened: str | None = None
    happened_at: float | None = None
    gap_in_time: float | None = None
    waits: bool = False  # for the search and the selection alone, as the next two
    cut: int = 0
    touch: bool | None = None
    stepped: str = ""  # by which simulator
    instead: str = ""  # why not by the one that was asked for
    unplayed: list[str] = []  # what of a program of one's own did not take place


class EventRow(_Row):
    """One event of one drive."""

    scene_id: str
    ego: str
    step: int
    kind: str
    actor: str
    other: str
    side: str
    impact_speed: float
    earlier: float = 0.0


class SignalRow(_Row):
    """One traffic signal over one drive; see `SignalTrack`."""

    scene_id: str
    ego: str
    role: str
    x0: float
    y0: float
    x1: float
    y1: float
    state: str


class Part(_Row):
    """A finished block without its tracks.

    Attributes:
        scenes: Driven ones in order, then rejected ones in order.
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
