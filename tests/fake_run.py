"""A run made by hand: an ego drives straight, a pedestrian steps out from behind a bus stop. No simulator."""

from __future__ import annotations

import json
import math
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import numpy as np

from chatscene.measure.crash_type import crash_type, waits
from chatscene.measure.criticality import criticality, fault
from chatscene.measure.drive import Ran
from chatscene.measure.happening import happened
from chatscene.measure.score import columns, measure
from chatscene.measure.speeds import speeds
from chatscene.report.viewer import write_report
from chatscene.runs import (
    Driven,
    RunRecord,
    SourceRecord,
    Workspace,
    asked_evaluation,
    create,
    explain,
    finish,
    update,
    write_block,
    write_drawing,
    write_program,
)
from chatscene.runs.atomic import write_json
from chatscene.runs.digests import DRAWN, KEPT, digests, write_sealed
from chatscene.runs.record import seen_from
from chatscene.search.explore import Block, outcomes
from chatscene.search.samplers.paper import refine
from chatscene.search.select import Candidate, select
from chatscene.settings import SearchSettings, Settings
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.criticality import Happening
from chatscene.terms.episode import Ending, Episode, Event, EventKind, Role, SignalTrack, Track
from chatscene.terms.frame import About, Note
from chatscene.terms.scenario import BaseScenario, Component, Occluder, Position, Scenario, Side, Slots, SubDescriptions
from chatscene.terms.scene import Rejected, Scene
from chatscene.terms.snippet import Match, ParameterRange, Retrieval, RuledOut, Snippet

SCENARIO = "pedestrian-bus-stop-1f2e"
TEXT = "A pedestrian steps out from behind a bus stop on the right and freezes in front of us."
DECLARED = (
    ParameterRange(name="OPT_ADV_SPEED", low=0.8, high=3.5, unit="m/s", meaning="walking speed"),
    ParameterRange(name="OPT_ADV_DISTANCE", low=8.0, high=40.0, unit="m", meaning="gap at which it starts"),
    ParameterRange(name="OPT_GEO_Y", low=30.0, high=55.0, unit="m", meaning="distance ahead of the ego"),
)
PROGRAM = '''"""A pedestrian steps out from behind a bus stop."""
model chatscene.world.model

param OPT_ADV_SPEED = Range(0.8, 3.5)  # [m/s] walking speed
param OPT_ADV_DISTANCE = Range(8, 40)
param OPT_GEO_Y = Range(30, 55)
AdvClass = Pedestrian

behavior AdvBehavior():
    do Halt() until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 0.5
    do Halt()

egoRoute = selectRoute(maneuver="straight")
ego = new Car at startOf(egoRoute), with route egoRoute
AdvAgent = new AdvClass at pointOn(egoRoute, globalParameters.OPT_GEO_Y, -6), with behavior AdvBehavior()
'''
DT = 0.1


def scene(index: int, values: dict[str, float], *, route: int = 0, block: int = 0, attempt: int = 0) -> Scene:
    suffix = f".{attempt}" if attempt else ""
    return Scene(
        id=f"{SCENARIO}/route-{route:02d}/scene-{index:03d}{suffix}",
        scenario_id=SCENARIO,
        route=route,
        block=block,
        seed=1000 * route + index,
        values=values,
    )


def drive(concrete: Scene, steps: int = 100) -> Episode:
    """The ego at 9 m/s brakes late for a pedestrian that starts when it is near."""
    walking, gap, ahead = (concrete.values[p.name] for p in DECLARED)
    ego = _ego_and_walker(walking, gap, ahead, steps)
    x, speed, walker, crash = ego
    count = len(x)
    constant = np.full(count, -1.75)
    tracks = (
        _track("ego", Role.EGO, "Car", x, constant, np.zeros(count), speed, 4.9, 2.1),
        _track(
            "adversary",
            Role.ADVERSARY,
            "Pedestrian",
            np.full(count, ahead),
            walker,
            np.full(count, math.pi / 2),
            np.diff(walker, prepend=walker[:1]) / DT,
            0.6,
            0.6,
        ),
        _track(
            "bus-stop",
            Role.OCCLUDER,
            "BusStop",
            np.full(count, ahead - 4),
            np.full(count, -5.0),
            np.zeros(count),
            np.zeros(count),
            3.6,
            1.4,
        ),
        _track(
            "oncoming",
            Role.BACKGROUND,
            "Truck",
            95 - 8 * DT * np.arange(count),
            np.full(count, 1.75),
            np.full(count, math.pi),
            np.full(count, 8.0),
            7.5,
            2.4,
        ),
    )
    events = (
        Event(kind=EventKind.LANE_INVASION, step=6, other="broken"),
        *(
            [
                Event(
                    kind=EventKind.COLLISION,
                    step=count - 1,
                    other="adversary",
                    side="front",
                    impact_speed=float(speed[-1]),
                )
            ]
            if crash
            else []
        ),
    )
    state = "g" * min(count, 45) + "y" * min(max(count - 45, 0), 15) + "r" * max(count - 60, 0)
    return Episode(
        scene_id=concrete.id,
        ego="rule-based",
        dt=DT,
        tracks=tracks,
        events=events,
        signals=(
            SignalTrack(x0=78, y0=-3.5, x1=78, y1=0, state=state, role="ego"),
            SignalTrack(x0=92, y0=3.5, x1=92, y1=0, state=state, role="other"),
        ),
        ending=Ending.COLLISION if crash else Ending.TIMEOUT,
        route_completion=float(x[-1] / 100),
        distance_to_route=np.abs(0.05 * np.sin(0.1 * np.arange(count))),
        off_road=np.arange(count) == 3,
    )


def _ego_and_walker(walking: float, gap: float, ahead: float, steps: int) -> tuple[Any, Any, Any, bool]:
    x, v, y = [0.0], [9.0], [-6.0]
    for _ in range(steps):
        near = ahead - x[-1]
        moving = near < gap and y[-1] < -1.6
        y.append(y[-1] + (walking * DT if moving else 0.0))
        braking = y[-1] > -3.2 and near > 0
        v.append(max(v[-1] - (3.5 * DT if braking else 0.0), 0.0))
        x.append(x[-1] + v[-1] * DT)
        if abs(ahead - x[-1]) < 2.75 and abs(y[-1] + 1.75) < 1.35 and v[-1] > 0:
            return np.array(x), np.array(v), np.array(y), True
    return np.array(x), np.array(v), np.array(y), False


def _track(
    actor: str, role: Role, kind: str, x: Any, y: Any, heading: Any, speed: Any, length: float, width: float
) -> Track:
    return Track(actor=actor, role=role, kind=kind, length=length, width=width, x=x, y=y, heading=heading, speed=speed)


def block(
    number: int,
    ranges: tuple[ParameterRange, ...] = DECLARED,
    *,
    route: int = 0,
    scenes: int = 10,
    steps: int = 100,
) -> Block:
    """A block of driven scenes and one rejected draw."""
    rng = np.random.default_rng([route, number])
    ran: list[Ran] = []
    for index in range(number * scenes, (number + 1) * scenes):
        concrete = scene(index, _drawn(ranges, rng), route=route, block=number)
        episode = drive(concrete, steps)
        meaning = () if index % 7 else ("cross: the adversary stays 2.1 m beside the ego's path",)
        measurements = measure(episode)
        ran.append(
            Ran(
                scene=concrete,
                episode=episode,
                measurements=measurements,
                metrics=columns(measurements),
                meaning=meaning,
                speeds=speeds(episode),
                criticality=criticality(episode),
                fault=fault(episode),
                avoidable=None if episode.collision is None else index % 3 > 0,
                crash_type=crash_type(episode),
                happened=happened(episode),
                waits=waits(episode),
            )
        )
    refused = scene(number * scenes, _drawn(ranges, rng), route=route, block=number, attempt=1)
    rejected = (Rejected(scene=refused, reason="bus-stop overlaps adversary"),)
    return Block(scenario_id=SCENARIO, route=route, number=number, ranges=ranges, ran=tuple(ran), rejected=rejected)


def _drawn(ranges: tuple[ParameterRange, ...], rng: np.random.Generator) -> dict[str, float]:
    return {p.name: round(float(rng.uniform(p.low, p.high)), 4) for p in ranges}


def blocks(count: int = 5, *, route: int = 0, scenes: int = 10, steps: int = 100) -> list[Block]:
    """Blocks whose ranges move toward what collided."""
    done: list[Block] = []
    hits: list[dict[str, float]] = []
    for number in range(count):
        done.append(block(number, refine(DECLARED, hits), route=route, scenes=scenes, steps=steps))
        hits += [dict(outcome.values) for outcome in outcomes(done[-1]) if outcome.collided]
    return done


def drawing() -> dict[str, Any]:
    """A straight road with sidewalks that meets another at x = 85."""

    def box(x0: float, y0: float, x1: float, y1: float) -> list[list[float]]:
        return [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]

    return {
        "roads": [
            [box(-60, -3.5, 80, 3.5)],
            [box(90, -3.5, 200, 3.5)],
            [box(81.5, -80, 88.5, -5)],
            [box(81.5, 5, 88.5, 80)],
        ],
        "junctions": [
            [[[78, -3.5], [81.5, -6], [88.5, -6], [92, -3.5], [92, 3.5], [88.5, 6], [81.5, 6], [78, 3.5]]],
        ],
        "shoulders": [],
        "sidewalks": [
            [box(-60, -6.5, 78, -4)],
            [box(-60, 4, 78, 26), box(-50, 8, 70, 24)],  # around a block
            [box(92, -6.5, 200, -4)],
            [box(92, 4, 200, 6.5)],
        ],
        "lane_boundaries": [
            {"points": [[-60, 0], [78, 0]], "kind": "centre"},
            {"points": [[92, 0], [200, 0]], "kind": "centre"},
            {"points": [[-60, -3.5], [78, -3.5]], "kind": "solid"},
            {"points": [[-60, 3.5], [78, 3.5]], "kind": "solid"},
            {"points": [[85, -80], [85, -6]], "kind": "dashed"},
            {"points": [[85, 6], [85, 80]], "kind": "dashed"},
        ],
        "stop_lines": [
            {"control": "signal", "points": [[78, -3.5], [78, 0]]},
            {"control": "signal", "points": [[92, 0], [92, 3.5]]},
        ],
        "routes": {f"{SCENARIO}/route-00": [[0, -1.75], [100, -1.75]]},
    }


def _snippet(component: Component, name: str, description: str) -> Snippet:
    return Snippet(
        id=f"{component.value}/{name}",
        component=component,
        description=description,
        rephrasings=(),
        slots=Slots(),
    )


def _match(component: Component, name: str, description: str, similarity: float, *conflicts: str) -> Match:
    return Match(
        snippet=_snippet(component, name, description),
        similarity=similarity,
        agreement=0.5 if conflicts else 1.0,
        score=similarity * (0.75 if conflicts else 1.0),
        nearest=description,
        conflicts=conflicts,
    )


def understanding(text: str = TEXT) -> tuple[Scenario, Retrieval]:
    scenario = Scenario(
        id=SCENARIO,
        text=text,
        base=BaseScenario.STRAIGHT_OBSTACLE,
        parts=SubDescriptions(
            behavior="steps out and freezes in front of the ego",
            geometry="a straight road",
            spawn="behind a bus stop on the right",
        ),
        slots=Slots(
            adversary=AdversaryKind.PEDESTRIAN,
            actions=(Action.CROSS, Action.STOP),
            side=Side.RIGHT,
            position=Position.ROADSIDE,
            occluder=Occluder.BUS_STOP,
        ),
        notes=(Note(about=About.STATED, said=("side=right",)),),
    )
    candidates = {
        Component.BEHAVIOR: (
            _match(Component.BEHAVIOR, "cross-and-stop", "Crosses the road and stops in the ego's lane.", 0.83),
            _match(
                Component.BEHAVIOR,
                "cross-hesitate",
                "Starts to cross, pauses, goes on.",
                0.71,
                "actions: said stop, does hesitate",
            ),
            _match(Component.BEHAVIOR, "cross", "Crosses the road at a constant speed.", 0.66),
        ),
        Component.GEOMETRY: (
            _match(Component.GEOMETRY, "straight-road", "A straight road.", 0.94),
            _match(Component.GEOMETRY, "straight-two-lanes", "A straight road with two lanes each way.", 0.78),
        ),
        Component.SPAWN: (
            _match(Component.SPAWN, "behind-bus-stop-right", "Behind a bus stop on the right.", 0.97),
            _match(
                Component.SPAWN,
                "behind-bus-stop-left",
                "Behind a bus stop on the left.",
                0.93,
                "side: said right, does left",
            ),
        ),
    }
    retrieval = Retrieval(
        behavior=candidates[Component.BEHAVIOR][0],
        geometry=candidates[Component.GEOMETRY][0],
        spawn=candidates[Component.SPAWN][0],
        adversary=AdversaryKind.PEDESTRIAN,
        confidence=0.86,
        candidates=candidates,
        ruled_out=(
            RuledOut(
                snippet_id="behavior/emerge-and-freeze",
                reason="needs advTrajectory, which no spawn here provides",
            ),
        ),
    )
    return scenario, retrieval


def asked(**told: Any) -> RunRecord:
    """What is asked of a run, without a look at what it names."""
    fields: dict[str, Any] = {
        "text": TEXT,
        "program": None,
        "settings": asdict(Settings()),
        "map_name": "town",
        "map_digest": "",
        "egos": ["rule-based"],
        "ego_digests": {},
        "senses": {},
        "generator": "chatscene",
        "simulator": {},
    }
    return RunRecord.model_validate(fields | told)


def started(folder: Path, *, text: str = TEXT, program: str = PROGRAM, routes: int = 1) -> Workspace:
    """A run folder up to the first block."""
    settings = Settings(search=SearchSettings(seed=7, routes=routes))
    run = create(folder, asked(text=text, settings=asdict(settings)))
    write_json(run.file("explanation.json"), explain(text, [understanding(text)]))
    write_program(run, SCENARIO, program)
    write_drawing(run, drawing())
    return run


def selection(done: list[Block], keep: int = 2) -> dict[str, bool]:
    """The scenes to keep, by id; True marks a fill-in."""
    candidates = [
        Candidate(
            scene_id=ran.scene.id,
            collided=ran.episode.collision is not None,
            shown=not ran.meaning,
            avoidable=ran.avoidable,
            overall_score=ran.metrics["overall_score"],
            crash_type=ran.crash_type,
            waits=ran.waits,
            happened=ran.happened.kind is not Happening.NOTHING,
            near=ran.happened.seconds,
        )
        for one in done
        for ran in one.ran
    ]
    return {kept.scene_id: kept.fill_in for kept in select(candidates, count=keep)}


def finished(
    folder: Path,
    *,
    text: str = TEXT,
    program: str = PROGRAM,
    count: int = 5,
    routes: int = 1,
    steps: int = 100,
) -> Workspace:
    """A whole run folder."""
    run = started(folder, text=text, program=program, routes=routes)
    selected: dict[str, bool] = {}
    expected = [(SCENARIO, route, number) for route in range(routes) for number in range(count)]
    for route in range(routes):
        done = blocks(count, route=route, steps=steps)
        for one in done:
            write_block(run, one)
        selected |= selection(done)
    finish(run, selected=selected, expected=expected)
    update(run, timings={"understand": 0.4, "search": 11.2, "jobs": 2})
    return run


def resealed(run: Workspace, **told: Any) -> None:
    """Let the record say something else, and have it hold the digests of what is in the folder now."""
    path = run.file("run.json")
    content = json.loads(path.read_text()) | told
    del content["digest"]
    if content["files"]:
        content["files"] = digests(run.path, (*KEPT, *DRAWN))
    write_sealed(path, content)


def evaluated(folder: Path, *, text: str = TEXT, kept_for: str = "idm", reported: bool = True) -> Workspace:
    """Ten scenes, driven by an ego that collides in some, and by one that comes too late to collide in any."""
    source = finished(folder / "run", text=text, count=1)
    if reported:
        write_report(source.path)
    told = SourceRecord(
        folder=seen_from(folder / "compared", source.path),
        scenario_id=SCENARIO,
        base="straight-obstacle",
        generator="chatscene",
        kept_for=kept_for,
        map_name="town",
    )
    asked = asked_evaluation([told], scenes=Driven.EVERY, egos=["idm", "planner"], settings=Settings())
    run = create(folder / "compared", asked)
    for number, steps in enumerate((100, 20)):
        write_block(run, replace(block(0, steps=steps), number=number))
    finish(run, selected={}, expected=[(SCENARIO, 0, 0), (SCENARIO, 0, 1)])
    return run
