# ruff: noqa: E501 - elements stand in one line each
"""What others' scenarios hold beyond plans: catalogs, variants, stories that are played event by event."""

from __future__ import annotations

import math
import re
import xml.etree.ElementTree as Xml
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import chatscene
from chatscene.errors import (
    ChatSceneError,
    ForeignCodeRefused,
    ProgramError,
    ProgramStopped,
    ScenarioError,
    SettingsError,
)
from chatscene.imports.given import Given, Refused, calculated
from chatscene.imports.import_file import import_scenario, written
from chatscene.imports.shapes import shape_of, thinned
from chatscene.imports.stranger_xml import Element, read_xml
from chatscene.imports.variants import variants_of
from chatscene.imports.written_story import written_story
from chatscene.maps.curves import normalise
from chatscene.maps.network import resolve_map
from chatscene.search.generators.foreign import foreign_program
from chatscene.simulate.simulator import Simulator, simulate
from chatscene.terms.episode import Episode
from chatscene.terms.scene import Rejected, Scene, ScenicProgram
from chatscene.terms.storyboard import Storyboard
from played import DISTANCE, STATE, TIME, driven, read, speed, story
from red_team.scenario_files import CAR, NEAR, SLOWS, alone, event, scenario, variants

# Parameters and expressions


@pytest.mark.parametrize(
    ("text", "value"),
    [("1/4*pi", math.pi / 4), ("round(2.5)", 3.0), ("sqrt(16)-pow(2,3)", -4.0), ("7 % 4", 3.0), ("not (1 > 2)", 1.0)],
)
def test_an_expression_has_the_value_that_the_standard_gives_it(text: str, value: float) -> None:
    assert calculated(text) == pytest.approx(value)


@pytest.mark.parametrize("text", ["open(1)", "1/0", "a.b", "[1]", "9**9**9", "(" * 3000])
def test_what_is_no_expression_of_numbers_has_no_value(text: str) -> None:
    with pytest.raises(ValueError):
        calculated(text)


def test_a_parameter_that_stands_where_nothing_may_vary_keeps_its_value_and_that_is_noted(beside: Path) -> None:
    found = read(beside, scenario(place='<WorldPosition x="136.75" y="${-365 + $near}" h="1.5708"/>'))
    assert any("$near stands where nothing may vary here; it keeps the value 20" in note for note in found.notes)
    assert "OPT_NEAR" not in str(found.board)


def test_a_parameter_with_one_bound_keeps_its_value_and_that_is_noted(beside: Path) -> None:
    found = read(beside, scenario().replace('<ValueConstraint rule="lessOrEqual" value="30"/>', ""))
    assert any("$near keeps the value 20" in note for note in found.notes)


def test_a_parameter_that_is_declared_with_its_dollar_is_that_parameter(beside: Path) -> None:
    plain, dollar = read(beside, scenario()), read(beside, scenario().replace('name="near"', 'name="$near"'))
    assert str(dollar.board) == str(plain.board)


# Catalogs


def with_catalog(folder: Path, reference: str) -> str:
    (folder / "cars").mkdir()
    body = CAR.replace('length="4.5"', 'length="$long"').replace(
        "<BoundingBox>", '<ParameterDeclarations><ParameterDeclaration name="long" parameterType="double" value="4"/></ParameterDeclarations><BoundingBox>'
    )  # fmt: skip
    (folder / "cars" / "all.xosc").write_text(f'<OpenSCENARIO><Catalog name="cars">{body}</Catalog></OpenSCENARIO>')
    where = '<CatalogLocations><VehicleCatalog><Directory path=".\\cars"/></VehicleCatalog></CatalogLocations>'
    return scenario(body=reference).replace("<CatalogLocations/>", where)


def test_a_body_of_a_catalog_has_the_parameters_that_are_assigned(beside: Path) -> None:
    assigned = (
        '<ParameterAssignments><ParameterAssignment parameterRef="long" value="${2 + 3}"/></ParameterAssignments>'
    )
    text = with_catalog(beside, f'<CatalogReference catalogName="cars" entryName="v">{assigned}</CatalogReference>')
    found = read(beside, text)
    assert [actor.length for actor in found.board.actors] == [4.5, 5.0]  # type: ignore[union-attr]
    plainly = read(beside, text.replace(assigned, ""))
    assert [actor.length for actor in plainly.board.actors] == [4.5, 4.0]  # type: ignore[union-attr]


def test_parameters_of_catalogs_that_grow_are_refused_before_they_are_written_out(beside: Path) -> None:
    text = with_catalog(beside, '<CatalogReference catalogName="cars" entryName="v"/>')
    body = (beside / "cars" / "all.xosc").read_text()
    declared = '<ParameterDeclaration name="long" parameterType="double" value="4"/>'
    grown = declared.replace('"4"', f'"{"4" * 5_000}"')
    (beside / "cars" / "all.xosc").write_text(body.replace(declared, grown).replace('"$long"', '"${$long + $long}"'))
    with pytest.raises(ScenarioError, match="has more than 10000 characters with its parameters"):
        read(beside, text)


def test_the_catalogs_of_a_file_have_one_bound_together(beside: Path) -> None:
    text = with_catalog(beside, '<CatalogReference catalogName="cars" entryName="v"/>')
    for name in ("0", "1"):
        (beside / "cars" / f"{name}.xosc").write_text(f"<OpenSCENARIO>{'<a/>' * 110_000}</OpenSCENARIO>")
    with pytest.raises(ScenarioError, match=r"could not be read: .*1\.xosc, line 1: it has more than 89999 elements"):
        read(beside, text)


def test_a_catalog_is_found_by_its_file_too_and_each_of_a_name_is_looked_into(beside: Path) -> None:
    text = with_catalog(beside, '<CatalogReference catalogName="all" entryName="v"/>')
    assert len(read(beside, text).board.actors) == 2  # type: ignore[union-attr]
    (beside / "cars" / "Other.xosc").write_text(
        '<OpenSCENARIO><Catalog name="cars"><Other name="o"/></Catalog></OpenSCENARIO>'
    )
    assert len(read(beside, text.replace('"all"', '"cars"')).board.actors) == 2  # type: ignore[union-attr]


def test_an_entry_that_a_catalog_lacks_is_refused_by_its_line(beside: Path) -> None:
    text = with_catalog(beside, '<CatalogReference catalogName="cars" entryName="w"/>')
    with pytest.raises(ScenarioError, match=r"line \d+: <CatalogReference>: the catalog 'cars' has no entry 'w'"):
        read(beside, text)


def test_what_is_refused_in_a_catalog_is_told_by_its_file(beside: Path) -> None:
    text = with_catalog(beside, '<CatalogReference catalogName="cars" entryName="v"/>')
    body = (beside / "cars" / "all.xosc").read_text()
    (beside / "cars" / "all.xosc").write_text(body.replace('"car"', '"submarine"'))
    with pytest.raises(ScenarioError, match=r"all\.xosc, line 1: <Vehicle>: no road user is known as 'submarine'"):
        read(beside, text)


def test_what_is_noted_of_a_catalog_is_told_by_its_file(beside: Path) -> None:
    faster = SLOWS.replace('value="0"', 'value="9"')
    (beside / "moves").mkdir()
    moves = f'<Catalog name="moves"><Maneuver name="m">{event(faster)}</Maneuver></Catalog>'
    (beside / "moves" / "all.xosc").write_text(f"<OpenSCENARIO>{moves}</OpenSCENARIO>")
    where = '<CatalogLocations><ManeuverCatalog><Directory path="moves"/></ManeuverCatalog></CatalogLocations>'
    text = scenario().replace("<CatalogLocations/>", where)
    own = text[text.index("<Maneuver ") : text.index("</ManeuverGroup>")]
    found = read(beside, text.replace(own, '<CatalogReference catalogName="moves" entryName="m"/>'))
    assert isinstance(found.board, Storyboard)
    assert any(re.match(r"all\.xosc, line \d+: the pedal is held", note) for note in found.notes)


def test_a_map_in_another_folder_is_found_by_its_path_from_the_file(beside: Path) -> None:
    (beside / "deep").mkdir()
    assert read(beside / "deep", scenario(map_name="../town.xodr")).map_path == beside / "town.xodr"


def test_where_only_one_folder_is_open_no_other_file_is_read(beside: Path) -> None:
    (beside / "deep").mkdir()
    (beside / "deep" / "theirs.xosc").write_text(scenario(map_name="../town.xodr"))
    with pytest.raises(ScenarioError, match="lies where nothing is opened"):
        import_scenario(beside / "deep" / "theirs.xosc", within=beside / "deep")
    text = with_catalog(beside, '<CatalogReference catalogName="cars" entryName="v"/>').replace(".\\cars", "../cars")
    (beside / "deep" / "theirs.xosc").write_text(text)
    with pytest.raises(ScenarioError, match="no folder that the file names has a catalog 'cars'"):
        import_scenario(beside / "deep" / "theirs.xosc", map_name="town", within=beside / "deep")


@pytest.mark.parametrize("name", ["{folder}/town.xodr", "town", "town.xodr", "in/../../town.xodr"])
def test_no_link_and_no_name_leads_out_of_the_open_folder(
    name: str, beside: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (folder := beside / "deep").mkdir()
    (folder / "a" / "b").mkdir(parents=True)
    (folder / "in").symlink_to(folder / "a" / "b")
    if not name.startswith("in"):
        (folder / "town.xodr").symlink_to(resolve_map("town"))
    (folder / "a" / "town.xodr").write_text("<OpenDRIVE/>")
    (folder / "theirs.xosc").write_text(scenario(map_name=name.format(folder=folder)))
    monkeypatch.chdir(beside)
    with pytest.raises(ScenarioError, match="lies where nothing is opened"):
        import_scenario(folder / "theirs.xosc", within=folder)


def test_a_bare_name_is_no_file_of_the_working_directory(beside: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (folder := beside / "deep").mkdir()
    (beside / "Town").symlink_to(resolve_map("town"))
    monkeypatch.chdir(beside)
    with pytest.raises(ScenarioError, match=r"'[^']*Town\.xodr' does not lie there"):
        read(folder, scenario(map_name="Town"))
    assert read(folder, scenario(map_name="town")).map_path == resolve_map("town")


# Files that end a reading


def routed(waypoints: str) -> str:
    """A scenario whose road user is put on a route."""
    inside = '<InRoutePosition><FromRoadCoordinates pathS="1" t="0"/></InRoutePosition>'
    return scenario(
        place=f'<RoutePosition><RouteRef><Route name="r" closed="false">{waypoints}</Route></RouteRef>{inside}</RoutePosition>'
    )


NEARBY = '<WorldPosition x="136.75" y="-330" h="1.570796"/>'
WAYPOINT = '<Waypoint routeStrategy="shortest"><Position>{}</Position></Waypoint>'
AT = '<WorldPosition x="{}" y="-340" h="0"/>'
SLIVER = "".join(f"<Vertex><Position>{AT.format(x)}</Position></Vertex>" for x in (136.7549, 136.7551))
FOLLOWS = f'<RoutingAction><FollowTrajectoryAction><TrajectoryRef><Trajectory name="t" closed="false"><Shape><Polyline>{SLIVER}</Polyline></Shape></Trajectory></TrajectoryRef><TimeReference><None/></TimeReference></FollowTrajectoryAction></RoutingAction>'
CONTINUOUS = (
    '<SpeedActionTarget><RelativeTargetSpeed entityRef="ego" value="0" continuous="$nobody"/></SpeedActionTarget>'
)


@pytest.mark.parametrize(
    ("text", "why"),
    [
        (scenario().replace('<Private entityRef="lead">', '<Private entityRef="$nobody">'), r"\$nobody"),
        (scenario().replace("</Entities>", '<EntitySelection name="all"><Members><EntityRef entityRef="$nobody"/></Members></EntitySelection></Entities>'), r"\$nobody"),
        (scenario(events=event(DISTANCE)).replace('<SpeedActionTarget><AbsoluteTargetSpeed value="5"/></SpeedActionTarget>', CONTINUOUS), r"\$nobody"),
        (scenario(events=event(DISTANCE).replace("<Event ", '<Event maximumExecutionCount="²" ')), "'²' is not a number"),
        (scenario(events=event(DISTANCE).replace("<Event ", '<Event maximumExecutionCount="--5" ')), "'--5' is not a number"),
        (scenario(events=event(DISTANCE).replace("<Event ", '<Event maximumExecutionCount="1.5" ')), "to be a whole number"),
        (routed(WAYPOINT.format(AT.format(136))), "not a line of two points"),
        (routed(""), "not a route of two waypoints"),
        (routed("".join(WAYPOINT.format(f'<RoadPosition roadId="1" s="{s}" t="0"/>') for s in (1, 900_000))), "900000 m is not on it"),
        (scenario(events=event(FOLLOWS)), "not a line of two points"),
        (scenario(events=event("<LongitudinalAction/>")), "this is not supported here"),
    ],
    ids=[*"abcdefghijk"],
)  # fmt: skip
def test_whatever_cannot_be_read_is_refused_by_its_line(text: str, why: str, beside: Path) -> None:
    with pytest.raises(ScenarioError, match=rf"cannot be said here:\n(.*\n)*  line \d+: .*{why}"):
        read(beside, text)


# Variants


STEPS = '<Deterministic><DeterministicSingleParameterDistribution parameterName="near"><DistributionRange stepWidth="{}"><Range lowerLimit="10" upperLimit="30"/></DistributionRange></DeterministicSingleParameterDistribution></Deterministic>'


def test_each_set_of_parameter_values_is_a_program(beside: Path) -> None:
    path = variants(beside, STEPS.format(10))
    done = import_scenario(path)
    assert [one.name for one in done.programs] == ["values-1.scenic", "values-2.scenic", "values-3.scenic"]
    assert "< 10.0" in done.programs[0].read_text()
    assert "'lessThan', 30," in done.programs[2].read_text()  # which holds from the beginning on: no edge rises
    (alone,) = import_scenario(path, out=beside / "one.scenic", variant=2).programs
    assert alone.read_text() == done.programs[1].read_text()


@pytest.mark.parametrize("variant", [-1, 0, 4])
def test_a_variant_that_a_file_does_not_have_is_refused(variant: int, beside: Path) -> None:
    with pytest.raises(SettingsError, match=f"variants 1 to 3, and no {variant}"):
        import_scenario(variants(beside, STEPS.format(10)), variant=variant)


SETS = '<Deterministic><DeterministicSingleParameterDistribution parameterName="{}"><DistributionSet>{}</DistributionSet></DeterministicSingleParameterDistribution></Deterministic>'


def sets(name: str, *values: str) -> str:
    return SETS.format(name, "".join(f'<Element value="{value}"/>' for value in values))


def test_each_variant_is_run_on_the_map_that_it_names(beside: Path) -> None:
    (beside / "other.xodr").symlink_to(resolve_map("town"))
    path = variants(beside, sets("where", "town.xodr", "other.xodr"))
    declared = '<ParameterDeclaration name="where" parameterType="string" value="town.xodr"/></ParameterDeclarations>'
    text = scenario(map_name="$where").replace("</ParameterDeclarations>", declared)
    (beside / "theirs.xosc").write_text(text)
    done = import_scenario(path)
    assert [one.name for one in done.maps] == ["town.xodr", "other.xodr"]
    assert done.map_path == done.maps[0]
    assert any(f"values-2.scenic lies on another map, {beside / 'other.xodr'}" in note for note in done.notes)


def test_where_one_variant_is_refused_no_program_is_written(beside: Path) -> None:
    with pytest.raises(ScenarioError, match=r"variant 2 of .*values\.xosc, near = far: .*\n.*'far' is not a number"):
        import_scenario(variants(beside, sets("near", "20", "far")))
    assert not list(beside.glob("*.scenic"))
    (beside / "values-2.scenic").write_text("mine")
    with pytest.raises(SettingsError, match=r"values-2\.scenic is there already"):
        import_scenario(variants(beside, sets("near", "20", "30")))
    assert [one.name for one in beside.glob("*.scenic")] == ["values-2.scenic"]


def test_that_nothing_is_overwritten_is_looked_at_once_and_before_a_file_is_read(
    beside: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    looked: list[Path] = []
    monkeypatch.setattr("chatscene.imports.import_file._free", looked.append)
    import_scenario(variants(beside, sets("near", "20", "30")))
    assert [one.name for one in looked] == ["values-1.scenic", "values-2.scenic"]


def test_where_one_program_cannot_be_written_none_is_there(beside: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(path: Path, content: bytes) -> None:
        if path.name == "values-2.scenic":
            raise OSError(28, "No space left on device")
        path.write_bytes(content)

    monkeypatch.setattr("chatscene.imports.import_file.write_whole", full)
    with pytest.raises(SettingsError, match=r"cannot write .*values-2\.scenic: No space left"):
        import_scenario(variants(beside, sets("near", "20", "30")))
    assert not list(beside.glob("*.scenic"))


def test_every_variant_is_held_to_what_a_program_of_a_user_may_be(
    beside: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def bounded(name: str, source: str) -> None:
        if "'lessThan', 30," in source:
            raise ForeignCodeRefused("it is too long")

    monkeypatch.setattr("chatscene.imports.import_file.foreign_program", bounded)
    with pytest.raises(ScenarioError, match=r"variant 3 of .*it is too long"):
        import_scenario(variants(beside, STEPS.format(10)))


@pytest.mark.parametrize("second", [sets("near", "1"), '<Stochastic><StochasticDistribution parameterName="near"><NormalDistribution expectedValue="5" variance="4"/></StochasticDistribution></Stochastic>'])  # fmt: skip
def test_a_parameter_whose_values_are_told_twice_is_refused(second: str, beside: Path) -> None:
    with pytest.raises(ScenarioError, match=r"line \d+: .*the values of \$near are given twice"):
        import_scenario(variants(beside, STEPS.format(0.1) + second))


def test_a_file_is_read_once_however_many_variants_it_has(beside: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    opened: list[str] = []

    def counting(path: Path, **how: object) -> Element:
        opened.append(path.name)
        return read_xml(path, **how)  # type: ignore[arg-type]

    for name in ("import_file", "openscenario", "catalogs"):
        monkeypatch.setattr(f"chatscene.imports.{name}.read_xml", counting)
    text = with_catalog(beside, '<CatalogReference catalogName="cars" entryName="v"/>')
    path = variants(beside, STEPS.format(10))
    (beside / "theirs.xosc").write_text(text)
    import_scenario(path)
    assert opened == ["values.xosc", "theirs.xosc", "all.xosc"]
    opened.clear()
    import_scenario(beside / "theirs.xosc", out=beside / "one.scenic")
    assert opened == ["theirs.xosc", "all.xosc"]


def test_a_range_of_very_many_steps_is_searched_and_that_is_noted(beside: Path) -> None:
    done = import_scenario(variants(beside, STEPS.format(0.1)))
    assert "param OPT_NEAR = Range(10.0, 30.0)" in done.program.read_text()
    assert any("201 variants are too many programs" in note for note in done.notes)


def test_values_that_belong_together_are_taken_together_and_drawn_ones_vary(tmp_path: Path) -> None:
    pairs = "".join(
        f'<ParameterValueSet><ParameterAssignment parameterRef="a" value="{a}"/><ParameterAssignment parameterRef="b" value="{b}"/></ParameterValueSet>'
        for a, b in ((1, 2), (3, 4))
    )
    inner = f"<Deterministic><DeterministicMultiParameterDistribution><ValueSetDistribution>{pairs}</ValueSetDistribution></DeterministicMultiParameterDistribution></Deterministic>"
    drawn = '<Stochastic><StochasticDistribution parameterName="c"><NormalDistribution expectedValue="5" variance="4"/></StochasticDistribution></Stochastic>'
    path = variants(tmp_path, inner + drawn)
    found = variants_of(read_xml(path), path)
    assert found is not None
    assert [dict(found.number(n)) for n in (1, 2)] == [{"a": "1", "b": "2"}, {"a": "3", "b": "4"}]
    assert found.spans == {"c": (-1.0, 11.0)}


@pytest.mark.parametrize("axes", [3, 2_000])
def test_more_variants_than_are_read_are_refused_before_they_are_made(axes: int, beside: Path) -> None:
    one = STEPS.format(0.02).removeprefix("<Deterministic>").removesuffix("</Deterministic>")
    path = variants(beside, f"<Deterministic>{one * axes}</Deterministic>")
    with pytest.raises(ScenarioError, match="has more than 1000000 variants"):
        variants_of(read_xml(path), path)


SLOWS_DOWN = "The car ahead brakes hard."


def test_drives_are_spread_over_the_variants_and_which_are_judged_is_told(beside: Path) -> None:
    verdict = chatscene.verify(path := variants(beside, STEPS.format(10)), SLOWS_DOWN, draws=4)
    assert [one.variant for one in verdict.draws] == [1, 1, 2, 3]
    assert "judged, with how many drives, of 3 variants: 1 (2), 2 (1), 3 (1)" in verdict.notes
    assert [one["variant"] for one in verdict.as_dict()["draws"]] == [1, 1, 2, 3]
    chosen = chatscene.verify(path, SLOWS_DOWN, draws=1, variant=3)
    assert [one.variant for one in chosen.draws] == [3]
    assert "variant 3 of 3 of theirs.xosc: near = 30" in chosen.notes
    assert "variant 2 of 3 of theirs.xosc: near = 20" in str(chatscene.story(path, variant=2))
    with pytest.raises(SettingsError, match="variants 1 to 3, and no 4"):
        chatscene.verify(path, SLOWS_DOWN, variant=4)
    with pytest.raises(SettingsError, match="sets the values of 'near' itself"):
        chatscene.verify(path, SLOWS_DOWN, param={"near": 12})


def test_a_variant_that_cannot_be_imported_or_driven_is_told_and_the_others_are_judged(beside: Path) -> None:
    verdict = chatscene.verify(variants(beside, sets("near", "20", "far", "30")), SLOWS_DOWN, draws=3)
    assert [one.variant for one in verdict.draws] == [1, 1, 3]
    assert re.match(r"NOT judged: variant 2 of .*values\.xosc, near = far: .* 'far' is not a number", verdict.notes[0])
    assert verdict.status == chatscene.verify(beside / "values.xosc", SLOWS_DOWN, draws=1, variant=1).status
    with pytest.raises(ScenarioError, match=r"variant 1 of .*near = far"):
        chatscene.verify(variants(beside, sets("near", "far", "away")), SLOWS_DOWN, draws=3)


@pytest.mark.parametrize("kind", [ProgramError, ProgramStopped])
def test_what_is_told_of_variants_is_told_of_those_that_were_driven(
    kind: type[ChatSceneError], beside: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    made, fails = simulate, {"2/0", "2/1", "3/1"}  # which drive of which variant

    def fail(simulator: Simulator, program: ScenicProgram, scene: Scene, *more: Any, **how: Any) -> Episode | Rejected:
        variant, number = program.scenario_id[-1], int(scene.id[-3:])
        if f"{variant}/{number % 2}" in fails:
            raise kind(f"{scene.id} fails while it runs\n  in line 1")
        return made(simulator, program, scene, *more, **how)

    monkeypatch.setattr("chatscene.verdict.programs.simulate", fail)
    verdict = chatscene.verify(variants(beside, STEPS.format(10)), SLOWS_DOWN, draws=6)
    assert [one.variant for one in verdict.draws] == [1, 1, 3]
    assert "judged, with how many drives, of 3 variants: 1 (2), 3 (1)" in verdict.notes
    assert [note for note in verdict.notes if note.startswith("NOT judged: variant 2")]
    assert verdict.dead == ("the program fails, or does not come to its end, in 3 of 6 drives",)


def test_a_few_of_many_variants_are_spread_over_all(beside: Path) -> None:
    done = import_scenario(variants(beside, STEPS.format(0.1)), at_most=3)
    assert (done.variants, done.count) == ((1, 68, 135), 201)
    assert "< 16.7" in done.programs[1].read_text()


def test_a_parameter_that_a_file_declares_can_be_given_and_no_other(beside: Path) -> None:
    (path := beside / "theirs.xosc").write_text(scenario())
    done = import_scenario(path, given={"near": 12})
    assert "< 12.0" in done.program.read_text()
    with pytest.raises(SettingsError, match="parameter 'far'"):
        import_scenario(path, out=beside / "two.scenic", given={"far": 12})
    with pytest.raises(SettingsError, match=r"near is given \[1\]"):
        import_scenario(path, out=beside / "two.scenic", given={"near": [1]})


# Shapes


@pytest.mark.parametrize(
    ("inner", "why"),
    [
        ('<ClothoidSpline>' + '<ClothoidSplineSegment length="900" curvatureStart="0" curvatureEnd="0"/>' * 12 + "</ClothoidSpline>", "more than 20000 points"),
        ('<Clothoid curvature="0" curvaturePrime="0" length="1000000"/>', "more than 20000 points"),
        ('<Clothoid curvature="0" curvaturePrime="0" length="0.001"/>', "not a line of two points"),
        ('<Nurbs order="13"/>', "its order is 13"),
        ("<Nurbs order=\"2\">" + "<ControlPoint/>" * 2_501 + "</Nurbs>", "more than 20000 points"),
    ],
)  # fmt: skip
def test_a_shape_of_too_many_points_is_refused_before_they_are_made(inner: str, why: str, tmp_path: Path) -> None:
    with pytest.raises(Refused, match=why):
        shape_of(shaped(tmp_path, inner), Given(), _place)


def test_a_segment_of_a_spline_begins_where_and_when_it_says(tmp_path: Path) -> None:
    segment = '<ClothoidSplineSegment length="10" curvatureStart="0" curvatureEnd="0" timeStart="{}" hOffset="{}">{}</ClothoidSplineSegment>'
    elsewhere = '<PositionStart><WorldPosition x="20" y="5"/></PositionStart>'
    parts = segment.format(0, 0, "") + segment.format(2, "${pi / 2}", "") + segment.format(3, 0, elsewhere)
    found = shape_of(shaped(tmp_path, f'<ClothoidSpline timeEnd="8">{parts}</ClothoidSpline>'), Given(), _place)
    assert found.times is not None
    at = dict(zip(found.times, found.points, strict=True))
    assert at[0] == pytest.approx((0, 0))
    assert at[2] == pytest.approx((10, 0))
    assert at[3] == pytest.approx((10, 10))
    assert at[8] == pytest.approx((30, 5))
    assert (20.0, 5.0) in found.points


def shaped(folder: Path, inner: str) -> Element:
    path = folder / "shape.xosc"
    path.write_text(f"<Trajectory><Shape>{inner}</Shape></Trajectory>")
    return read_xml(path)


def _place(position: Element) -> tuple[float, float, float]:
    one = position.inside[0]
    return float(one.attributes["x"]), float(one.attributes["y"]), 0.0


def test_a_clothoid_without_a_place_bends_from_where_its_follower_is(tmp_path: Path) -> None:
    found = shape_of(
        shaped(tmp_path, '<Clothoid curvature="0.1" curvaturePrime="0" length="15.707963"/>'), Given(), _place
    )
    assert found.points[-1] == pytest.approx((10.0, 10.0), abs=0.01)


def test_a_nurbs_of_order_two_is_the_polyline_of_its_control_points(tmp_path: Path) -> None:
    at = '<ControlPoint><Position><WorldPosition x="{}" y="{}"/></Position></ControlPoint>'
    points = at.format(0, 0) + at.format(10, 0) + at.format(10, 10)
    knots = "".join(f'<Knot value="{k}"/>' for k in (0, 0, 1, 2, 2))
    found = shape_of(shaped(tmp_path, f'<Nurbs order="2">{points}{knots}</Nurbs>'), Given(), _place)
    kept = [found.points[i] for i in thinned(found.points, 0.01)]
    assert kept == [pytest.approx(one) for one in ((0, 0), (10, 0), (10, 10))]


def test_a_curve_by_its_arc_length_is_the_same_with_a_parameter_from_0_to_1() -> None:
    text = '<r><geometry length="10"><paramPoly3 aU="1" bU="2" cU="3" dU="4" aV="0" bV="0" cV="0.5" dV="0" pRange="arcLength"/></geometry></r>'
    geometry = Xml.fromstring(text).find("geometry")
    assert geometry is not None
    normalise(geometry)
    curve = geometry.find("paramPoly3")
    assert curve is not None
    assert [float(curve.get(name, 0)) for name in ("aU", "bU", "cU", "dU", "cV")] == [1.0, 20.0, 300.0, 4000.0, 50.0]


# Stories


def test_a_speed_that_is_told_with_a_time_is_reached_in_that_time(beside: Path) -> None:
    text = scenario(events=event(speed(8), TIME.format(1)) + event(DISTANCE, TIME.format(90), "later"))
    track = next(t for t in driven(beside, text, 60).tracks if t.actor == "adversary")
    assert float(track.speed[10]) == pytest.approx(5.0, abs=0.1)
    assert float(track.speed[21]) == pytest.approx(6.5, abs=0.3)
    assert float(track.speed[35]) == pytest.approx(8.0, abs=0.1)


@pytest.mark.parametrize(
    "path",
    ["m::first", "first", "a::g::m::first", "s::a::g::m::first", "$which"],
    ids=lambda path: path.replace("::", "-"),
)
def test_an_event_that_waits_for_another_begins_when_that_is_over(path: str, beside: Path) -> None:
    waits = STATE.format("event", path, "completeState")
    text = scenario(events=event(speed(7), TIME.format(1), "first") + event(speed(2), waits, "second") + event(DISTANCE, TIME.format(90), "later"))  # fmt: skip
    which = '<ParameterDeclaration name="which" parameterType="string" value="s::a::g::m::first"/>'
    text = text.replace("<ParameterDeclarations>", f"<ParameterDeclarations>{which}", 1)
    track = next(t for t in driven(beside, text, 70).tracks if t.actor == "adversary")
    fastest = int(np.argmax(track.speed))
    assert 28 <= fastest <= 34
    assert float(track.speed[60]) == pytest.approx(2.0, abs=0.2)


@pytest.mark.parametrize(("state", "slows"), [("stopTransition", True), ("endTransition", False)])
def test_who_waits_for_an_event_to_be_stopped_does_not_wait_for_its_end(state: str, slows: bool, beside: Path) -> None:
    waits = STATE.format("event", "first", state)
    text = scenario(events=event(speed(9, 30), TIME.format(1), "first") + event(speed(7), TIME.format(2), "second") + event(speed(1), waits, "third") + event(DISTANCE, TIME.format(90), "later"))  # fmt: skip
    track = next(t for t in driven(beside, text, 60).tracks if t.actor == "adversary")
    assert (float(track.speed[-1]) < 2.0) is slows


def test_an_event_overwrites_none_of_another_maneuver(beside: Path) -> None:
    later = event(DISTANCE, TIME.format(90), "later") + '</Maneuver><Maneuver name="n">'
    first = event(speed(9, 4), TIME.format(1), "first")
    beside_it = '<LateralAction><LaneOffsetAction continuous="false"><LaneOffsetActionDynamics dynamicsShape="step"/><LaneOffsetTarget><AbsoluteTargetLaneOffset value="0.5"/></LaneOffsetTarget></LaneOffsetAction></LateralAction>'
    text = scenario(events=first + later + event(beside_it, TIME.format(2), "second") + event(speed(1), STATE.format("event", "first", "stopTransition"), "third"))  # fmt: skip
    track = next(t for t in driven(beside, text, 55).tracks if t.actor == "adversary")
    assert float(track.speed[-1]) > 8.5


def with_another(text: str, name: str, like: str) -> str:
    """A scenario with one road user more, who stands."""
    two = text[text.index(f'<ScenarioObject name="{like}"') : text.index("</Entities>")].replace(
        f'"{like}"', f'"{name}"'
    )
    init = f'<Private entityRef="{name}"><PrivateAction><TeleportAction><Position>{NEARBY}</Position></TeleportAction></PrivateAction></Private>'
    return text.replace("</Entities>", f"{two}</Entities>").replace("</Actions></Init>", f"{init}</Actions></Init>")


def test_road_users_of_a_plan_whose_names_are_alike_keep_their_own_lines_and_labels(beside: Path) -> None:
    found = read(beside, with_another(scenario(name="lead-1"), "lead_1", "lead-1").replace('"lead"', '"lead-1"')).board
    assert isinstance(found, Storyboard)
    assert [one.start.line for one in found.actors] == ["egoRoute", "alead_1Way", "lead_1Way"]
    found = read(beside, with_another(scenario(name="é"), "ö", "é").replace('"lead"', '"é"')).board
    assert isinstance(found, Storyboard)
    assert [one.start.line for one in found.actors] == ["egoRoute", "a_Way", "a__2Way"]
    third = replace(found, actors=(*found.actors, replace(found.actors[2], name="ü")))
    assert re.findall(r"label '([^']*)'", written(third, "theirs.xosc")) == ["--2", "--3"]


def test_parts_and_road_users_whose_names_are_alike_in_a_program_keep_their_own(beside: Path) -> None:
    waits = STATE.format("event", "é", "completeState")
    events = event(speed(7), TIME.format(1), "é") + event(speed(6), TIME.format(9), "ü") + event(speed(2), waits, "x")
    text = scenario(events=events + event(DISTANCE, TIME.format(90), "later"), name="ä")
    found = story(beside, with_another(text, "ö", "ä"))
    assert [one.name for one in found.members] == ["ego", "_", "__2"]
    told = str(found.acts)
    assert "'_', 'parallel'" not in told
    assert "('rising', 0.0, 'element', 'event', '__3', 'completeState')" in told
    program = written_story(found, "theirs.xosc")
    labels = re.findall(r"label '([^']*)'", program)
    assert len(set(labels)) == len(labels)


@pytest.mark.parametrize(
    ("asked", "why"),
    [(("story", "s", "completeState"), "the type 'story'"), (("event", "first", "skipTransition"), "the state 'skipTransition'")],
)  # fmt: skip
def test_a_type_or_state_that_no_part_has_here_is_refused(asked: tuple[str, str, str], why: str, beside: Path) -> None:
    with pytest.raises(ScenarioError, match=rf"line \d+: <StoryboardElementStateCondition>: {why}"):
        read(beside, scenario(events=event(DISTANCE, STATE.format(*asked))))


def test_that_nothing_has_the_name_that_is_waited_for_is_noted(beside: Path) -> None:
    waits = STATE.format("event", "nobody", "completeState")
    found = read(beside, scenario(events=event(DISTANCE, TIME.format(1)) + event(speed(1), waits, "then")))
    assert any("there is no event 'nobody'; this never holds" in note for note in found.notes)


def test_who_goes_across_on_a_line_of_the_file_comes_to_its_end(beside: Path) -> None:
    line = '<Polyline><Vertex><Position><WorldPosition x="136.75" y="-340"/></Position></Vertex><Vertex><Position><WorldPosition x="136.75" y="-310"/></Position></Vertex></Polyline>'
    follows = f'<RoutingAction><FollowTrajectoryAction><TrajectoryRef><Trajectory name="t" closed="false"><Shape>{line}</Shape></Trajectory></TrajectoryRef><TimeReference><None/></TimeReference></FollowTrajectoryAction></RoutingAction>'
    text = scenario(events=event(follows, TIME.format(1)) + event(speed(6), TIME.format(1), "too") + event(DISTANCE, TIME.format(90), "later"))  # fmt: skip
    track = next(t for t in driven(beside, text, 70).tracks if t.actor == "adversary")
    assert float(track.y[-1]) > -312
    assert abs(float(track.x[-1]) - 136.75) < 0.3


def test_the_end_that_a_file_tells_ends_the_drive(beside: Path) -> None:
    stop = f'<StopTrigger><ConditionGroup><Condition name="x" delay="1" conditionEdge="none">{TIME.format(1)}</Condition></ConditionGroup></StopTrigger></Storyboard>'
    text = scenario(events=event(DISTANCE, TIME.format(1))).replace("<StopTrigger/></Storyboard>", stop)
    found = driven(beside, text)
    assert str(found.ending) == "scenario-done"
    assert 20 <= len(found.tracks[0].x) <= 23


@pytest.mark.parametrize("text", [scenario().replace('entityRef="lead"/></Actors>', 'entityRef="ego"/></Actors>')])
def test_a_file_in_which_only_the_ego_does_something_has_the_other_as_adversary(text: str, beside: Path) -> None:
    board = story(beside, text.replace('<AbsoluteTargetSpeed value="5"/>', '<AbsoluteTargetSpeed value="0"/>'))
    assert [one.acts for one in board.members] == [True, False]  # what the ego does is kept
    program = written_story(board, "theirs.xosc")
    assert "AdvBehavior" not in program
    assert "with role 'adversary'" in program
    foreign_program("theirs", program)


def test_a_file_with_nobody_but_an_ego_is_a_program(beside: Path) -> None:
    foreign_program("theirs", written_story(story(beside, alone()), "theirs.xosc"))


def test_the_ego_may_be_named_and_else_the_first_vehicle_is_taken_and_that_is_noted(beside: Path) -> None:
    text = scenario().replace('"ego"', '"first"')
    assert any("first is used; name another with --ego: lead" in note for note in read(beside, text).notes)
    assert read(beside, text.replace('"first"', '"VUT"')).board.actors[0].name == "ego"  # type: ignore[union-attr]
    with pytest.raises(ScenarioError, match="there is no 'nobody' that could be the ego"):
        read(beside, text, ego="nobody")


@pytest.mark.parametrize(
    ("action", "why"),
    [
        ("<TrailerAction><DisconnectTrailerAction/></TrailerAction>", "<DisconnectTrailerAction>: this is not supported here"),
        ('<ControllerAction><OverrideControllerValueAction><Brake active="true" value="1"/></OverrideControllerValueAction></ControllerAction>', "it takes over pedals"),
    ],
)  # fmt: skip
def test_what_has_a_meaning_and_is_not_played_is_refused_by_its_line(action: str, why: str, beside: Path) -> None:
    with pytest.raises(ScenarioError, match=rf"line \d+: .*{why}"):
        read(beside, scenario(events=event(action)))


@pytest.mark.parametrize(
    ("action", "told"),
    [
        ("<VisibilityAction/>", "everybody is visible"),
        ("<AppearanceAction/>", "lamps and looks are not shown"),
        ("<ControllerAction/>", "controllers are not taken"),
    ],
)
def test_what_has_no_meaning_for_the_conflict_is_left_out_and_that_is_noted(
    action: str, told: str, beside: Path
) -> None:
    found = read(beside, scenario(events=event(action) + event(SLOWS, NEAR, "then")))
    assert any(told in note and note.startswith("line ") for note in found.notes)


def test_the_page_names_every_action_and_condition_that_is_read_and_no_other() -> None:
    root = Path(__file__).parents[2]
    page = (root / "docs" / "imports.md").read_text(encoding="utf-8")
    source = "".join(
        (root / "src" / "chatscene" / "imports" / f"{name}.py").read_text(encoding="utf-8")
        for name in ("story_actions", "story_conditions", "opening", "told_as_story")
    )
    rows = [row.split("|")[1:3] for row in page.splitlines() if row.startswith("| `")]
    named = {name for what, _ in rows for name in re.findall(r"\w+(?:Action|Condition)\b", what)}
    refused = {n for what, how in rows if "refused" in how for n in re.findall(r"\w+(?:Action|Condition)\b", what)}
    read_here = set(re.findall(r'"(\w+(?:Action|Condition))"', source)) - {"GlobalAction", "PrivateAction", "ByEntityCondition", "ByValueCondition", "SetAction", "ModifyAction", "ControllerAction", "RoutingAction", "LongitudinalAction", "EntityAction", "EntityCondition"}  # fmt: skip
    assert read_here - {"SetMonitorAction", "ParameterSetAction", "VariableSetAction"} <= named
    assert not refused & read_here
    missing = {name for name in named - refused if f'"{name}"' not in source}
    assert missing <= {"AssignControllerAction"}  # told as its ControllerAction
