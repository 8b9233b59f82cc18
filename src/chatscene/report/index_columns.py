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
from chatscene.terms.criticality import Fault, Happening, Severity
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
_IN_SQL = {
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
        name: Its name.
        meaning: What it holds.
        unit: Of its numbers, such as ``m/s``; empty where they have none.
        type: Its type, one of Arrow's.
    """

    name: str
    meaning: str
    unit: str = ""
    type: Any = TEXT

    @property
    def in_sql(self) -> str:
        """Its type as SQL names it."""
        return _IN_SQL[self.type]

    def as_dict(self) -> dict[str, str]:
        """For a script."""
        return {"column": self.name, "type": self.in_sql, "unit": self.unit, "meaning": self.meaning}


def _one_of(what: str, values: type[StrEnum]) -> str:
    return f"{what}: {', '.join(f'`{one}`' for one in values)}"


_RUN = Column("run", "the run: its path below the folder that is asked")
_SCENARIO = Column("scenario_id", "the scenario")
_SCENE = Column("scene_id", "the scene; together with `run`, no other has it")

_RUNS = (
    _RUN,
    Column("folder", "absolute path of its folder"),
    Column("text", "the sentence with its edits; the name of a program of one's own"),
    Column("generator", "who made the scenes"),
    Column(
        "status",
        "`done`; `refused`: it has no scenes; `running`, `failed` or `stopped`: its scenes are in no table yet. It is "
        "`stopped` where no process of this machine is at work on it, such as one that was killed",
    ),
    Column("reason", "why it was refused or failed; else empty"),
    Column("seed", "what everything random derives from", type=WHOLE),
    Column("ego", "the ego that scenes were searched against"),
    Column("map", "the map, as it was given"),
    Column("sampler", "who said where to look next"),
    Column("simulator", "what the scenes ran in"),
    Column("simulator_version", "version of what its numbers depend on; null in older folders"),
    Column("physics", "how bodies answer to pedals and wheel: `kinematic` or `lagged`"),
    Column("version", "of chatscene, that began it"),
    Column("schema_version", "of the folder", type=WHOLE),
    Column("edited_from", "absolute path of the run of which it is an edit; null if it is none"),
    Column("scenes", "scenes, driven or rejected; null, like all counts, until all are searched", type=WHOLE),
    Column("ran", "scenes that were driven", type=WHOLE),
    Column("rejected", "scenes that were rejected", type=WHOLE),
    Column("collided", "scenes with a collision", type=WHOLE),
    Column("off_road", "scenes in which the ego left the road; null, like the next two, in older folders", type=WHOLE),
    Column("timeout", "scenes that ran out of time", type=WHOLE),
    Column("waiting", "scenes in which the ego waited behind somebody to the end", type=WHOLE),
    Column("selected", "scenes that were kept", type=WHOLE),
    Column("fill_in", "of these, scenes without a collision", type=WHOLE),
    Column(
        "ego_speed",
        "median over its drives of `ego_speed_before`; null, like the next two, in older folders",
        "m/s",
        NUMBER,
    ),
    Column("other_speed", "median of `other_speed_before`", "m/s", NUMBER),
    Column("impact_speed", "highest speed of approach at a collision; null without one", "m/s", NUMBER),
    Column("seconds", "wall time of all calls that worked on it", "s", NUMBER),
)

_FACTS = (
    _RUN,
    _SCENARIO,
    Column("base", _one_of("base scenario", BaseScenario)),
    Column(
        "adversary", _one_of("kind of the adversary in the program, or, of a refused run, that was said", AdversaryKind)
    ),
    Column("actions", _one_of("what the adversary does, in order; empty where nothing was said", Action), type=TEXTS),
    Column("side", _one_of("side of the ego that the adversary comes from", Side)),
    Column("position", _one_of("where the adversary starts, in the ego's frame", Position)),
    Column("start_distance", _one_of("how far off it starts (the slot `distance`)", Distance)),
    Column("occluder", _one_of("what hides the adversary at first", Occluder)),
    Column("in_group", "whether others of its kind stand or go with it (the slot `group`)", type=TRUTH),
    Column("others", "how many others do something beside the adversary", type=WHOLE),
    Column("maneuver", _one_of("what the ego's route does", Maneuver)),
    Column("ego_state", _one_of("what the ego does at the pedals (the slot `ego`)", EgoState)),
    Column("leader", "whether a slow vehicle leads the ego", type=TRUTH),
    Column("blocker", "whether a parked vehicle stands in the ego's lane", type=TRUTH),
    Column("place", _one_of("where it happens", Place)),
    Column("site", _one_of("what the ego's way leads along or through", Site)),
    Column("control", _one_of("how the junction is controlled", Control)),
    Column("lanes", "lanes of the ego's direction", type=WHOLE),
    Column("two_way", "whether a lane of the opposite direction lies beside the ego's", type=TRUTH),
    Column("behavior", "the snippet that was chosen for the behavior"),
    Column("geometry", "the snippet that was chosen for the road geometry"),
    Column("spawn", "the snippet that was chosen for the spawn position"),
)

_RISK = "probability that who {}, by a published curve; 0.5 stands for a half or more, null where none holds"
_OF_SCENES: dict[str, tuple[str, str]] = {
    "scenario_id": (_SCENARIO.meaning, ""),
    "route_id": ("the route", ""),
    "block": ("the block in which it was searched, from 0", ""),
    "seed": ("what its draws derive from", ""),
    "status": ("`ran` or `rejected`; of a rejected scene, all that follows `reason` is null or false", ""),
    "reason": ("why it was rejected", ""),
    "selected": ("whether it was kept", ""),
    "fill_in": ("whether it was kept although nothing collided", ""),
    "collision": ("whether the ego collided", ""),
    "avoidable": ("whether a careful driver would have avoided the collision; null without one", ""),
    "fault": (_one_of("who struck whom; null without a collision", Fault), ""),
    "impact_speed": ("speed of approach at the first collision; null without one", "m/s"),
    "severity": (_one_of("class of ISO 26262 that follows from it; null without a collision", Severity), ""),
    "crash_type": ("which kind of crash it is: who struck whom with what and where; null without a collision", ""),
    "ego_kind": ("class of the ego", ""),
    "other_kind": (
        "class of whom the ego meets: whom it collides with, else the adversary that came nearest; null if nobody",
        "",
    ),
    "happened": (_one_of("the gravest of what happened; null in folders of before", Happening), ""),
    "happened_at": ("when; of nothing, when the ego was nearest to an adversary", "s"),
    "gap_in_time": ("nearest gap in time between the ego and an adversary; null where there was none", "s"),
    "meaning_ok": ("whether the drive shows all that was read in the sentence", ""),
    "meaning_failures": ("what it does not show", ""),
    "ego": ("who drove", ""),
    "ending": (_one_of("how the drive ended", Ending), ""),
    "route_completion": ("share of the route that was driven, up to 1", ""),
    "dt": ("time step", "s"),
    "light": (_one_of("how light it was", Light), ""),
    "weather": (_one_of("what fell or hung in the air", Weather), ""),
    "surface": (_one_of("the state of the road", Surface), ""),
    "time_to_collision": ("least time until the ego and an adversary would touch if both went on", "s"),
    "post_encroachment_time": ("least time between one leaving a place and the other coming to it", "s"),
    "time_headway": ("least time that the ego needed to where an adversary ahead was", "s"),
    "deceleration_required": ("greatest braking that just avoids an adversary ahead", "m/s²"),
    "distance": ("least gap between the ego and an adversary; 0 in a contact", "m"),
    "encounter_time": ("when the encounter begins: the last moment before either of them brakes for it", "s"),
    "ego_speed_before": ("the ego's speed then", "m/s"),
    "other_speed_before": ("the speed of whom it meets then", "m/s"),
    "ego_speed_most": ("the ego's highest speed up to the nearest moment or the contact", "m/s"),
    "other_speed_most": ("the highest speed of whom it meets up to then", "m/s"),
    "ego_braking_most": ("the ego's hardest braking up to then", "m/s²"),
    "other_braking_most": ("the hardest braking of whom it meets up to then", "m/s²"),
    "ego_speed_at_impact": ("the ego's speed just before the first collision; null, like the next ten, without", "m/s"),
    "other_speed_at_impact": ("the speed of whom or what it strikes then", "m/s"),
    "closing_speed": ("the part of `impact_speed` along the line of contact", "m/s"),
    "impact_angle": ("heading of whom it strikes less the ego's: 0 is the same way, ±π oncoming", "rad"),
    "ego_delta_v": ("by how much the impact changes the ego's velocity, by the masses", "m/s"),
    "other_delta_v": ("the same of whom it strikes; null of a thing that stands", "m/s"),
    "ego_injury_risk": (_RISK.format("on or in the ego is seriously injured or dies (MAIS 3+)"), ""),
    "other_injury_risk": (_RISK.format("it strikes is seriously injured or dies (MAIS 3+)"), ""),
    "ego_death_risk": (_RISK.format("is the ego, on foot, dies"), ""),
    "other_death_risk": (_RISK.format("it strikes dies"), ""),
    "friction_demand": (
        "largest share of the road's friction that anybody on wheels took before a contact, along and across together; "
        "above 1 it is more than tyres hold",
        "",
    ),
    "raw_collided": ("1 if the ego collided", ""),
    "raw_red_lights": ("red lights run", ""),
    "raw_stop_signs": ("stop signs ignored", ""),
    "raw_off_road": ("driven off the driving lanes", "m"),
    "raw_distance_to_route": ("mean distance to the route", "m"),
    "raw_completion": ("share of the route that was driven, up to 1", ""),
    "raw_time": ("duration, if the route was completed", "s"),
    "raw_acceleration": ("mean magnitude of acceleration", "m/s²"),
    "raw_yaw_rate": ("summed change of yaw over duration, a full turn for each crossing of ±π", "rad/s"),
    "raw_yaw_rate_unwrapped": ("the same without those turns", "rad/s"),
    "raw_lane_invasions": ("lane markings crossed", ""),
    "raw_duration": ("duration", "s"),
}


def _scenes() -> tuple[Column, ...]:
    metrics = {name: one for name, one in MEASURES.items() if name not in _OF_SCENES}
    told = _OF_SCENES | {name: (f"{one.name}: {one.of}; more is {one.more}", one.unit) for name, one in metrics.items()}
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
    Column(
        "low", "least value that the scene's block drew from; null where that was not kept", "as `unit` says", NUMBER
    ),
    Column("high", "greatest one", "as `unit` says", NUMBER),
    Column("meaning", "what it is"),
)

_OF_EVENTS: dict[str, tuple[str, str]] = {
    "ego": ("who drove", ""),
    "step": ("when: the step, from 0; `step * dt` is the time", ""),
    "kind": (_one_of("what happened", EventKind), ""),
    "actor": ("whose it is", ""),
    "other": ("with whom, or with what", ""),
    "side": ("side of the ego that was struck, of a collision; else empty", ""),
    "impact_speed": ("speed of approach, of a collision", "m/s"),
    "earlier": ("of a collision: how long before `step` the two began to touch, as a share of a step", ""),
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
    "facts": "a row per run and scenario: what was said and chosen; null is what was not said",
    "scenes": "a row per scene, driven or rejected, of runs that are done",
    "parameters": "a row per scene and parameter",
    "events": "a row per event of a drive",
}
"""What a row of each table is."""


def schema_of(table: str) -> Any:
    """The columns of a table as Arrow has them."""
    return pa.schema([(column.name, column.type) for column in TABLES[table]])
