"""The tables of an index over runs, column by column: what each holds, and in which unit."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

import pyarrow as pa

from chatscene.report.measures import MEASURES
from chatscene.runs.tables import EVENTS, SCENES
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.criticality import CRITICALITY, Fault, Happening, Severity
from chatscene.terms.episode import Ending, EventKind
from chatscene.terms.scenario import (
    BaseScenario,
    Control,
    Distance,
    EgoState,
    Maneuver,
    Occluder,
    Place,
    Position,
    Side,
    Site,
)
from chatscene.terms.surroundings import Light, Surface, Weather

TEXT, TEXTS, NUMBER, WHOLE, TRUTH = pa.string(), pa.list_(pa.string()), pa.float64(), pa.int64(), pa.bool_()
IN_SQL = {
    pa.string(): "VARCHAR",
    pa.list_(pa.string()): "VARCHAR[]",
    pa.float64(): "DOUBLE",
    pa.int32(): "INTEGER",
    pa.int64(): "BIGINT",
    pa.uint64(): "UBIGINT",
    pa.bool_(): "BOOLEAN",
}


@dataclass(frozen=True, slots=True)
class Column:
    """A column of a table.

    Attributes:
        unit: Of its numbers, such as ``m/s``; empty where they have none.
    """

    name: str
    meaning: str
    unit: str = ""
    type: Any = TEXT

    @property
    def in_sql(self) -> str:
        """Its type as SQL names it."""
        return IN_SQL[self.type]

    def as_dict(self) -> dict[str, str]:
        """For a script."""
        return {"column": self.name, "type": self.in_sql, "unit": self.unit, "meaning": self.meaning}


def _one_of(what: str, values: type[StrEnum]) -> str:
    return f"{what}: {', '.join(f'`{one}`' for one in values)}"


_RUN = Column("run", "the run: its path below DIR")
_SCENARIO = Column("scenario_id", "the scenario")
_SCENE = Column("scene_id", "the scene; unique together with `run`")

_RUNS = (
    _RUN,
    Column("folder", "absolute path of its folder"),
    Column("text", "the sentence with its edits, or the name of your own program"),
    Column("generator", "the generator"),
    Column(
        "status",
        "`done`; `refused`: no scenes; `running`, `failed`, or `stopped` (such as killed): not yet in the other tables",
    ),
    Column("reason", "why it was refused or failed; else empty"),
    Column("seed", "seed of the run", type=WHOLE),
    Column("ego", "the ego that scenes were searched against"),
    Column("map", "the map, as given"),
    Column("sampler", "the sampler"),
    Column("simulator", "the simulator"),
    Column("simulator_version", "its version; null in older folders"),
    Column("physics", "`kinematic` or `lagged`"),
    Column("version", "version of chatscene that began the run"),
    Column("schema_version", "schema version of the folder", type=WHOLE),
    Column("edited_from", "absolute path of the run that it edits, else null"),
    Column("scenes", "scenes, driven or rejected; null, like all counts, until the search ends", type=WHOLE),
    Column("ran", "driven scenes", type=WHOLE),
    Column("rejected", "rejected scenes", type=WHOLE),
    Column("collided", "scenes with a collision", type=WHOLE),
    Column("off_road", "scenes in which the ego left the road; null, like the next two, in older folders", type=WHOLE),
    Column("timeout", "scenes that ran out of time", type=WHOLE),
    Column("waiting", "scenes in which the ego waits behind a road user to the end", type=WHOLE),
    Column("selected", "kept scenes", type=WHOLE),
    Column("fill_in", "kept scenes without a collision", type=WHOLE),
    Column(
        "ego_speed",
        "median of `ego_speed_before`; null, like the next two, in older folders",
        "m/s",
        NUMBER,
    ),
    Column("other_speed", "median of `other_speed_before`", "m/s", NUMBER),
    Column("impact_speed", "highest impact speed; null without a collision", "m/s", NUMBER),
    Column("seconds", "wall time of all commands that worked on it", "s", NUMBER),
)

_FACTS = (
    _RUN,
    _SCENARIO,
    Column("base", _one_of("base scenario", BaseScenario)),
    Column(
        "adversary", _one_of("kind of the adversary in the program; in the text, if the run was refused", AdversaryKind)
    ),
    Column("actions", _one_of("what the adversary does, in order; empty if not said", Action), type=TEXTS),
    Column("side", _one_of("side of the ego that the adversary comes from", Side)),
    Column("position", _one_of("where the adversary starts, in the ego's frame", Position)),
    Column("start_distance", _one_of("how far away it starts (slot `distance`)", Distance)),
    Column("occluder", _one_of("what hides the adversary at first", Occluder)),
    Column("in_group", "whether it comes with others of its kind (slot `group`)", type=TRUTH),
    Column("others", "how many other road users act", type=WHOLE),
    Column("maneuver", _one_of("what the ego's route does", Maneuver)),
    Column("ego_state", _one_of("what the ego does before the hazard appears (slot `ego`)", EgoState)),
    Column("leader", "whether a slow vehicle drives ahead of the ego", type=TRUTH),
    Column("blocker", "whether a parked vehicle stands in the ego's lane", type=TRUTH),
    Column("place", _one_of("where it happens", Place)),
    Column("site", _one_of("what the ego's route passes", Site)),
    Column("control", _one_of("how the junction is controlled", Control)),
    Column("lanes", "lanes in the ego's direction", type=WHOLE),
    Column("two_way", "whether an oncoming lane is beside the ego's", type=TRUTH),
    Column("behavior", "snippet of the behavior, if snippets were chosen"),
    Column("geometry", "snippet of the road geometry"),
    Column("spawn", "snippet of the spawn position"),
)

_RISK = "probability that {}, by a published curve; 0.5 means a half or more; null without a curve"
_OF_SCENES: dict[str, tuple[str, str]] = {
    "scenario_id": (_SCENARIO.meaning, ""),
    "route_id": ("the route", ""),
    "block": ("the block of the search, from 0", ""),
    "seed": ("seed of the scene", ""),
    "status": ("`ran` or `rejected`; if rejected, all columns after `reason` are null or false", ""),
    "reason": ("why it was rejected", ""),
    "selected": ("whether it was kept", ""),
    "fill_in": ("whether it was kept without a collision", ""),
    "collision": ("whether the ego collided", ""),
    "avoidable": ("whether a careful driver would have avoided the collision; null without one", ""),
    "fault": (_one_of("who struck whom; null without a collision", Fault), ""),
    "impact_speed": ("relative speed at the first collision; null without one", "m/s"),
    "severity": (_one_of("ISO 26262 class of that speed; null without a collision", Severity), ""),
    "crash_type": ("kind of crash: who struck whom, with which part, where; null without a collision", ""),
    "ego_kind": ("class of the ego", ""),
    "other_kind": (
        "class of the other: the road user or object it collides with, else the nearest adversary; null if none",
        "",
    ),
    "happened": (_one_of("the most severe event; null in older folders", Happening), ""),
    "happened_at": ("its time; for `nothing`, when an adversary was closest", "s"),
    "gap_in_time": ("smallest time gap between the ego and an adversary; null without one", "s"),
    "meaning_ok": ("whether the drive shows all facts that were read", ""),
    "meaning_failures": ("facts that it does not show", ""),
    "ego": ("the ego", ""),
    "ending": (_one_of("how the drive ended", Ending), ""),
    "route_completion": ("driven share of the route, up to 1", ""),
    "dt": ("time step", "s"),
    "light": (_one_of("light", Light), ""),
    "weather": (_one_of("weather", Weather), ""),
    "surface": (_one_of("road surface", Surface), ""),
    **{column: (one.meaning, one.unit) for column, one in CRITICALITY.items()},
    "encounter_time": ("when the encounter begins: just before either brakes for it", "s"),
    "ego_speed_before": ("the ego's speed then", "m/s"),
    "other_speed_before": ("the other's speed then", "m/s"),
    "ego_speed_most": ("the ego's highest speed until the closest approach or the contact", "m/s"),
    "other_speed_most": ("the other's highest speed until then", "m/s"),
    "ego_braking_most": ("the ego's hardest braking until then", "m/s²"),
    "other_braking_most": ("the other's hardest braking until then", "m/s²"),
    "ego_speed_at_impact": (
        "the ego's speed just before the first collision; null, like the next ten, without one",
        "m/s",
    ),
    "other_speed_at_impact": ("the other's speed then", "m/s"),
    "closing_speed": ("component of `impact_speed` along the line of contact", "m/s"),
    "impact_angle": ("the other's heading minus the ego's: 0 same direction, ±π oncoming", "rad"),
    "ego_delta_v": ("change of the ego's velocity in the impact, computed from the masses", "m/s"),
    "other_delta_v": ("the same for the other; null for fixed objects", "m/s"),
    "ego_injury_risk": (_RISK.format("somebody in or on the ego is seriously injured or dies (MAIS 3+)"), ""),
    "other_injury_risk": (_RISK.format("the other is seriously injured or dies (MAIS 3+)"), ""),
    "ego_death_risk": (_RISK.format("the ego, on foot, dies"), ""),
    "other_death_risk": (_RISK.format("the other dies"), ""),
    "friction_demand": (
        "largest share of the road's friction that a wheeled road user needs before a contact; above 1 tyres slide",
        "",
    ),
    "raw_collided": ("1 if the ego collided", ""),
    "raw_red_lights": ("red lights run", ""),
    "raw_stop_signs": ("stop signs ignored", ""),
    "raw_off_road": ("distance driven off the driving lanes", "m"),
    "raw_distance_to_route": ("mean distance to the route", "m"),
    "raw_completion": ("share of the route that counts as driven: all, if the drive is over as the ego goes on", ""),
    "raw_time": ("duration, if the route is completed", "s"),
    "raw_acceleration": ("mean magnitude of acceleration", "m/s²"),
    "raw_yaw_rate": ("summed change of yaw over duration; crossing ±π counts as a full turn", "rad/s"),
    "raw_yaw_rate_unwrapped": ("the same, unwrapped", "rad/s"),
    "raw_lane_invasions": ("lane markings crossed", ""),
    "raw_duration": ("duration", "s"),
}


def _scenes() -> tuple[Column, ...]:
    metrics = {name: one for name, one in MEASURES.items() if name not in _OF_SCENES}
    told = _OF_SCENES | {name: (one.in_one, one.unit) for name, one in metrics.items()}
    types = {field.name: field.type for field in SCENES}
    first = [name for name in told if not name.startswith("raw_")]
    ordered = [*first, *(name for name in told if name not in first)]
    return (_RUN, _SCENE, *(Column(name, *told[name], types.get(name, NUMBER)) for name in ordered))


_PARAMETERS = (
    _RUN,
    _SCENE,
    Column("name", "the parameter, `OPT_…`"),
    Column("value", "its value in this scene", "as `unit` says", NUMBER),
    Column("unit", "unit of `value`, `low` and `high`; empty where they have none"),
    Column("low", "lower limit of its block; null if not kept", "as `unit` says", NUMBER),
    Column("high", "upper limit", "as `unit` says", NUMBER),
    Column("meaning", "its meaning"),
)

_OF_EVENTS: dict[str, tuple[str, str]] = {
    "ego": ("the ego", ""),
    "step": ("the step, from 0; the time is `step * dt`", ""),
    "kind": (_one_of("what happened", EventKind), ""),
    "actor": ("the road user", ""),
    "other": ("the other road user or object", ""),
    "side": ("struck side of the ego in a collision; else empty", ""),
    "impact_speed": ("relative speed in a collision", "m/s"),
    "earlier": ("in a collision: how long before `step` contact began, as a share of a step", ""),
}
_EVENTS = (_RUN, _SCENE, *(Column(name, *_OF_EVENTS[name], EVENTS.field(name).type) for name in _OF_EVENTS))

TABLES: Mapping[str, tuple[Column, ...]] = {
    "runs": _RUNS,
    "facts": _FACTS,
    "scenes": _scenes(),
    "parameters": _PARAMETERS,
    "events": _EVENTS,
}
"""Every table with its columns. `scenes` has further ones where runs have metrics of one's own."""

ROWS: Mapping[str, str] = {
    "runs": "a row per run",
    "facts": "a row per run and scenario: what was said and chosen; null if not said",
    "scenes": "a row per scene, driven or rejected, of finished runs",
    "parameters": "a row per scene and parameter",
    "events": "a row per event of a drive",
}
"""What a row of each table is."""


def schema_of(table: str) -> Any:
    """The columns of a table as Arrow has them."""
    return pa.schema([(column.name, column.type) for column in TABLES[table]])
