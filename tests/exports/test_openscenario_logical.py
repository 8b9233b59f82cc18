"""What a plan says leaves as a logical scenario and comes back as the same plan; what cannot be said is refused."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import lru_cache
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as Xml

import numpy as np
import pytest

from asam_checker import assert_nothing_wrong
from chatscene.ego.policy import load_ego
from chatscene.errors import RunError
from chatscene.exports.exporter import KeptScene
from chatscene.exports.openscenario_logical import OpenScenarioLogical, scenario
from chatscene.exports.plain_numbers import Site, Unsayable
from chatscene.exports.plain_plan import Plain, plainly
from chatscene.exports.retold import retold
from chatscene.imports.import_file import import_scenario
from chatscene.imports.openscenario import read_openscenario
from chatscene.library.load import load_library
from chatscene.maps.network import load_network, resolve_map
from chatscene.search.generators.foreign import read_foreign
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import load_simulator, simulate
from chatscene.terms.actors import BY_CLASS, LIMITS, Manner
from chatscene.terms.episode import Role, Track
from chatscene.terms.plan import FUNCTIONS, Call, Comparison, Expression, Foreign, Kind, Name, Parameter
from chatscene.terms.plan_text import parse_plan, plan_of, print_expression
from chatscene.terms.polyline import Polyline
from chatscene.terms.scenario import Component
from chatscene.terms.scene import Rejected, Scene
from chatscene.terms.snippet import ParameterRange, Snippet
from chatscene.terms.storyboard import EGO_ROUTE, Actor, Start, Storyboard
from chatscene.terms.sums import Sum, number
from chatscene.testing.exporters import planned_scene

X, SOUTH, NORTH = 136.75, -375.0, -275.0  # a street of the town, straight
EGO = Polyline([(X, SOUTH), (X, NORTH)])
PLACED = {name: ParameterRange(name=name, low=5, high=10, unit="m") for name in ("OPT_GEO_X", "OPT_GEO_Y")}
BEHAVIORS = load_library().of(Component.BEHAVIOR)


@pytest.fixture(scope="module")
def kept() -> KeptScene:
    return planned_scene()


@pytest.fixture(scope="module")
def written(kept: KeptScene, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("logical")
    for name, content in OpenScenarioLogical().files(kept).items():
        (folder / name).write_bytes(content)
    return folder / f"{kept.stem}.xosc"


# Every packaged behavior, on lines beside a street


@lru_cache(maxsize=1)
def lane() -> int:
    return int(load_network(resolve_map("town")).laneSectionAt((X, SOUTH + 40)).openDriveID)


def on_foot(behavior: Snippet) -> bool:
    return BY_CLASS[behavior.adversaries[0].row.scenic].row.manner is Manner.WALKS


def site_of(behavior: Snippet) -> Site:
    """An actor beside the street, or on a line of its own along it."""
    lines: dict[str, Polyline] = {"egoRoute": EGO}
    plan = plan_of(behavior)
    assert not isinstance(plan, Foreign)
    across = on_foot(behavior) or any(phase.primitive == "MoveAhead" for phase in plan.phases[:2])

    def value(expression: Expression) -> Any:
        if isinstance(expression, Comparison):
            return True
        is_path = isinstance(expression, Name) and expression.kind is Kind.PATH
        if is_path or (isinstance(expression, Call) and FUNCTIONS[expression.function].gives is Kind.PATH):
            aside = X + 3.5 * len(lines)
            return lines.setdefault(print_expression(expression), Polyline([(aside, SOUTH - 20), (aside, NORTH + 20)]))
        return 42.5

    def start_on(line: Polyline) -> tuple[Sum, Sum, float]:
        along = Sum(20.0, ((1.0, Parameter("OPT_GEO_Y")),))
        if across:
            return along, Sum(2.0, ((1.0, Parameter("OPT_GEO_X")),)), -math.pi / 2
        return along, number(3.5 if line is EGO else 0.0), 0.0

    return Site(
        limits=LIMITS[behavior.adversaries[0].row.scenic],
        grip=math.inf,
        walks=on_foot(behavior),
        prefix="adversary",
        value=value,
        start_on=start_on,
        ego_line=EGO,
        lane_of=lambda _: lane(),
        ranges={p.name: ParameterRange(name=p.name, low=p.low, high=p.high, unit="1") for p in plan.parameters}
        | PLACED,
    )


def track(name: str, kind: str) -> Track:
    limits, still = LIMITS[kind], np.zeros(1)
    role = Role.EGO if name == "ego" else Role.ADVERSARY
    return Track(
        actor=name,
        role=role,
        kind=kind,
        length=limits.length,
        width=limits.width,
        x=still,
        y=still,
        heading=still,
        speed=still,
    )


def board_of(behavior: Snippet, plain: Plain, site: Site) -> Storyboard:
    kind = behavior.adversaries[0].row.scenic
    own = Polyline([(X + 12, SOUTH + 40), (X - 60, SOUTH + 40)])
    lines = {EGO_ROUTE: EGO, **(plain.lines or {"adversaryWay": own})}
    along = Sum(20.0, ((1.0, Parameter("OPT_GEO_Y")),)).expression
    zero = number(0.0).expression
    ego, other = (track(name, kind) for name, kind in (("ego", "Car"), ("adversary", kind)))
    return Storyboard(
        actors=(
            Actor(
                name="ego",
                kind="Car",
                length=ego.length,
                width=ego.width,
                start=Start(line=EGO_ROUTE, along=zero, left=zero, turn=0.0),
            ),
            Actor(
                name="adversary",
                kind=kind,
                length=other.length,
                width=other.width,
                start=Start(line="adversaryWay", along=along, left=zero, turn=0.0),
                plan=plain.plan,
            ),
        ),
        lines=lines,
        lanes=plain.lanes,
        parameters=tuple(sorted(site.ranges.values(), key=lambda one: one.name)),
        values={one.name: round((one.low + one.high) / 2, 6) for one in site.ranges.values()},
    )


def test_what_is_said_of_every_packaged_behavior_is_read_back_as_the_same_plan_from_the_same_start(
    tmp_path: Path,
) -> None:
    said = 0
    for behavior in BEHAVIORS:
        plan = plan_of(behavior)
        assert not isinstance(plan, Foreign)
        site = site_of(behavior)
        try:
            plain = plainly(plan, site)
        except Unsayable as reason:
            assert "phase" in str(reason)
            continue
        said += 1
        board = board_of(behavior, plain, site)
        tracks = {one.name: track(one.name, one.kind) for one in board.actors}
        path = tmp_path / "one.xosc"
        Xml.ElementTree(scenario(board, tracks, "town.xodr", behavior.id, 20.0, 0.1)).write(path)
        back = read_openscenario(path, "town").board
        assert isinstance(back, Storyboard)
        assert back.actors == board.actors, behavior.id
        assert [(p.name, p.low, p.high) for p in back.parameters] == [(p.name, p.low, p.high) for p in board.parameters]
        assert back.values == pytest.approx(board.values)
        assert back.lanes == board.lanes
        for name, line in plain.lines.items():
            if name not in plain.lanes:  # of a lane the map has the line
                assert np.allclose(back.lines[name].points, line.points, atol=1e-6)
    assert said > 80


@pytest.mark.parametrize(
    ("does", "why"),
    [
        ("WeaveOnPath(advTrajectory, 5, 1, 2)", "phase 1.*no action"),
        ("DrivePath(advTrajectory, 5) until gap(self, ego) < 9\n    do ReverseStraight(2)", "phase 2.*no action"),
        ("DrivePath(advTrajectory, 5) until headway(leftLane, ego, self) > 3", "does not follow"),
        ("DrivePath(advTrajectory, 5, 1)", "beside a line"),
        ("DrivePath(advTrajectory, 5) until gap(self, ego) < self.pose[3]", "several live quantities"),
        ("Halt() until egoMeeting > 100 and gap(self, ego) < 3", None),
    ],
)
def test_a_phase_that_the_format_cannot_say_is_refused_by_its_number_and_its_text(does: str, why: str | None) -> None:
    plan = parse_plan(f"behavior AdvBehavior():\n    do {does}\n")
    site = site_of(load_library().get("behavior/lane-brake"))
    if why is None:
        assert plainly(plan, site).plan.phases[0].end
        return
    with pytest.raises(Unsayable, match=why):
        plainly(plan, site)


# One scene, whole


def test_a_scenario_declares_every_parameter_with_its_range_and_the_value_of_the_scene(
    kept: KeptScene, written: Path
) -> None:
    root = Xml.parse(written).getroot()
    declared = {one.attrib["name"]: one for one in root.iter("ParameterDeclaration")}
    assert set(declared) == set(kept.values)
    drawn = Xml.parse(written.with_name(f"{kept.stem}_distribution.xosc")).getroot()
    for one in kept.joined().parameters:
        bounds = [float(bound.attrib["value"]) for bound in declared[one.name].iter("ValueConstraint")]
        assert bounds == [one.low, one.high]
        assert float(declared[one.name].attrib["value"]) == pytest.approx(kept.values[one.name])
        (range_,) = [
            d.find(".//Range") for d in drawn.iter("StochasticDistribution") if d.attrib["parameterName"] == one.name
        ]
        assert range_ is not None
        assert (float(range_.attrib["lowerLimit"]), float(range_.attrib["upperLimit"])) == (one.low, one.high)
    assert drawn.find(".//ScenarioFile").attrib["filepath"] == written.name  # type: ignore[union-attr]


def test_the_ego_is_a_host_with_a_route_and_does_nothing_by_itself(written: Path) -> None:
    root = Xml.parse(written).getroot()
    (ego,) = [one for one in root.iter("ScenarioObject") if one.attrib["name"] == "ego"]
    assert ego.find("ObjectController/Controller[@name='host']") is not None
    (init,) = [one for one in root.iter("Private") if one.attrib["entityRef"] == "ego"]
    assert len(list(init.iter("Waypoint"))) >= 2
    assert "ego" not in {ref.attrib["entityRef"] for group in root.iter("Actors") for ref in group}


def test_what_is_imported_again_runs_as_a_program_of_a_user_and_drives_as_the_scene_did(
    kept: KeptScene, written: Path
) -> None:
    done = import_scenario(written)
    program = read_foreign(done.program).program
    assert done.command == f"chatscene run --program {done.program} --map {written.parent / kept.map.name}"
    simulator = load_simulator(resolve_map("town"), SimulationSettings())
    old = Scene(id="s", scenario_id="planned", route=0, block=0, seed=0, values=kept.values)
    new = replace(old, scenario_id=program.scenario_id)
    first = simulate(simulator, kept.joined(), old, load_ego("idm"))
    second = simulate(simulator, program, new, load_ego("idm"))
    assert not isinstance(first, Rejected)
    assert not isinstance(second, Rejected)
    assert [one.actor for one in first.tracks] == [one.actor for one in second.tracks]
    for one, other in zip(first.tracks, second.tracks, strict=True):
        steps = min(len(one.x), len(other.x))
        assert steps > 30
        assert np.hypot(one.x[:steps] - other.x[:steps], one.y[:steps] - other.y[:steps]).max() < 0.05


def test_a_scene_whose_program_may_not_be_executed_is_refused(kept: KeptScene) -> None:
    def own() -> Any:
        raise RunError("a program of your own")

    with pytest.raises(RunError, match="your own"):
        retold(replace(kept, joined=own))


def test_the_asam_checker_finds_nothing_wrong(caplog: pytest.LogCaptureFixture, written: Path) -> None:
    for path in sorted(written.parent.glob("*.xosc")):
        assert_nothing_wrong(path, caplog, "openscenario")
