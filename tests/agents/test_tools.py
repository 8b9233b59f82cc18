"""Each tool does what its function does, in bounds, and no name leads out of the folder."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from chatscene.errors import SettingsError
from chatscene.mcp import resources
from chatscene.mcp import tool as tooling
from chatscene.mcp.folder import Folder
from chatscene.mcp.resources import KINDS
from chatscene.mcp.server import MOST_TEXT, in_parts
from chatscene.mcp.tools import TOOLS
from chatscene.mcp.words import EXAMPLE, nouns
from chatscene.mcp.working import answered
from chatscene.situations.file import read_text
from folder_of_agents import CALLS, CROSSES, SECRET, SITUATION, called, desk_in, furnished_with_run, paths_of

OUTSIDE = ("../outside/secret", "/etc/passwd", "link/secret", "link-secret", "runs/../../outside/secret", "~/secret")


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return furnished_with_run(tmp_path_factory.mktemp("agents") / "folder")


@pytest.fixture(autouse=True)
def inside(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(folder)  # as the process does that works


def test_every_tool_has_a_call_here_a_description_and_a_schema_that_takes_nothing_else() -> None:
    assert set(CALLS) == set(TOOLS)
    for tool in TOOLS.values():
        assert len(tool.says) > 40
        assert tool.schema["additionalProperties"] is False
        assert all("description" in one or one["type"] == "boolean" for one in tool.schema["properties"].values())


@pytest.mark.parametrize("name", TOOLS)
def test_a_tool_answers_in_words_of_bounded_length(folder: Path, name: str) -> None:
    answer = called(folder, name, **CALLS[name])
    assert "error" not in answer, answer
    assert answer["text"].strip()
    assert str(folder) not in answer["text"]
    assert all(len(part) <= MOST_TEXT for part in in_parts(answer["text"]))


def outside(folder: Path) -> list[str]:
    """Names that lead out of the folder, of every kind of file."""
    named = [
        where + suffix for where in OUTSIDE for suffix in ("", ".yaml", ".csv", ".toml", ".xosc", ".scenic", ".xodr")
    ]
    return [one for one in named if one.startswith("~") or not (folder / one).resolve().is_relative_to(folder)]


@pytest.mark.parametrize("name", TOOLS)
def test_no_path_of_a_tool_leads_out_of_the_folder(folder: Path, name: str) -> None:
    before = {path: path.read_text() for path in (folder.parent / "outside").iterdir()}
    for argument in paths_of(name):
        for where in outside(folder):
            answer = called(folder, name, **{**CALLS[name], argument: where})
            assert "error" in answer, (argument, where, answer)
            assert SECRET not in answer["error"]
    assert {path: path.read_text() for path in (folder.parent / "outside").iterdir()} == before


@pytest.mark.parametrize("name", ["../x", "/x", "x\0y", " ", "x" * 5000, "link/x", "a\nb"])
def test_a_name_that_is_no_path_below_the_folder_is_refused(folder: Path, name: str) -> None:
    with pytest.raises(SettingsError):
        Folder(folder).free(name)


def test_files_that_programs_and_situations_name_are_held_to_the_folder_too(folder: Path) -> None:
    outside = folder.parent / "outside"
    (folder / "far.yaml").write_text(f"map: {outside / 'secret.xodr'}\n{SITUATION}")
    (folder / "far.scenic").write_text(
        "param map = localPath('../outside/secret.xodr')\nmodel scenic.domains.driving.model\nego = new Car\n"
    )
    for tool, arguments in (
        ("build", {"file": "far.yaml"}),
        ("verify", {"what": "drive.csv", "said_file": "far.yaml"}),
        ("verify", {"what": "far.scenic", "said": CROSSES}),
        ("story", {"what": "far.scenic"}),
        ("run", {"file": "far.scenic"}),
        ("run", {"file": "far.yaml"}),
    ):
        answer = called(folder, tool, **arguments)
        assert "outside the folder" in answer["error"], (tool, answer)


@pytest.mark.parametrize("named", ["../outside/secret.xodr", "..\\\\outside.xodr", "link/secret.xodr", "&#46;./x.xodr"])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-16"])
def test_a_scenario_that_names_files_elsewhere_is_refused(folder: Path, named: str, encoding: str) -> None:
    text = (folder / "crash.xosc").read_text().replace("town.xodr", named)
    head, _, body = text.partition("?>")
    assert head.startswith("<?xml")
    (folder / "far.xosc").write_text(f'<?xml version="1.0" encoding="{encoding}"?>{body}', encoding=encoding)
    for tool, arguments in (
        ("import", {"file": "far.xosc", "save_as": "far-imported.scenic"}),
        ("verify", {"what": "far.xosc", "said": CROSSES}),
        ("story", {"what": "far.xosc"}),
    ):
        assert "lies where nothing is opened" in called(folder, tool, **arguments)["error"]


def test_a_run_that_names_a_map_or_an_ego_from_elsewhere_is_refused(folder: Path) -> None:
    record = json.loads((folder / "runs" / "brakes" / "run.json").read_text())
    for changed in ({"map_name": "/etc/x.xodr"}, {"egos": ["../mine.py"]}):
        odd = folder / "odd"
        odd.mkdir(exist_ok=True)
        (odd / "run.json").write_text(json.dumps({**record, **changed}))
        for tool in ("why", "rate", "story"):
            assert "error" in called(folder, tool, **{"what" if tool == "story" else "run": "odd"})


VALUES = """<OpenSCENARIO><ParameterValueDistribution><ScenarioFile filepath="crash.xosc"/><Deterministic>
<DeterministicSingleParameterDistribution parameterName="OPT_A_Y"><DistributionRange stepWidth="0.25"><Range
lowerLimit="18" upperLimit="{most}"/></DistributionRange></DeterministicSingleParameterDistribution></Deterministic>
</ParameterValueDistribution></OpenSCENARIO>"""


def test_an_import_of_many_programs_tells_of_all_and_one_can_be_chosen(folder: Path) -> None:
    for count, most in ((3, 18.5), (25, 24)):
        (folder / f"values-{count}.xosc").write_text(VALUES.format(most=most))
    told = called(folder, "import", file="values-3.xosc", save_as="sets/of.scenic")["text"]
    assert [line for line in told.splitlines() if line.startswith("written")] == [
        f"written: sets/of-{number}.scenic on map town.xodr" for number in (1, 2, 3)
    ]
    assert (folder / "sets" / "of-3.scenic").is_file()
    many = called(folder, "import", file="values-25.xosc", save_as="sets/many.scenic")["text"]
    assert "  and 5 more" in many
    assert "sets/many-21.scenic" not in many
    one = called(folder, "import", file="values-3.xosc", save_as="sets/second.scenic", variant=2)["text"]
    assert "variant 2 of 3" in one
    assert "next: verify sets/second.scenic on map town.xodr" in one
    refused = called(folder, "import", file="crash.xosc", save_as="sets/nobody.scenic", ego="nobody")["error"]
    assert "nobody" in refused


def test_a_program_is_given_its_parameters_and_a_file_its_variant(folder: Path) -> None:
    (folder / "reads.scenic").write_text(
        "model scenic.domains.driving.model\nego = new Car with behavior "
        "FollowLaneBehavior(target_speed=globalParameters.pace)\nterminate after 1 seconds\n"
    )
    assert "--param pace=VALUE" in called(folder, "story", what="reads.scenic")["error"]
    assert "the ego" in called(folder, "story", what="reads.scenic", param={"pace": 9})["text"]
    (folder / "values-two.xosc").write_text(VALUES.format(most=18.25))
    for tool, more in (("story", {}), ("verify", {"said_file": "crosses.yaml", "draws": 1})):
        told = called(folder, tool, what="values-two.xosc", variant=2, **more)["text"]
        assert "variant 2 of 2 of crash.xosc: OPT_A_Y = 18.25" in told


def test_an_import_of_programs_on_several_maps_tells_the_map_of_each(folder: Path) -> None:
    (folder / "other.xodr").write_bytes((folder / "town.xodr").read_bytes())
    where = '<ParameterDeclaration name="where" parameterType="string" value="town.xodr"/></ParameterDeclarations>'
    text = (folder / "crash.xosc").read_text().replace("</ParameterDeclarations>", where, 1)
    (folder / "placed.xosc").write_text(text.replace('filepath="town.xodr"', 'filepath="$where"'))
    both = '<DistributionSet><Element value="town.xodr"/><Element value="other.xodr"/></DistributionSet>'
    (folder / "places.xosc").write_text(
        '<OpenSCENARIO><ParameterValueDistribution><ScenarioFile filepath="placed.xosc"/><Deterministic>'
        f'<DeterministicSingleParameterDistribution parameterName="where">{both}'
        "</DeterministicSingleParameterDistribution>"
        "</Deterministic></ParameterValueDistribution></OpenSCENARIO>"
    )
    told = called(folder, "import", file="places.xosc", save_as="placed.scenic")["text"]
    assert "written: placed-1.scenic on map town.xodr" in told
    assert "written: placed-2.scenic on map other.xodr" in told


def test_arguments_that_are_about_something_else_are_refused_and_none_is_dropped(folder: Path) -> None:
    (folder / "own.scenic").write_text("model scenic.domains.driving.model\nego = new Car\n")
    (folder / "told.txt").write_text(CROSSES)
    for arguments, says in (
        ({"file": "crosses.yaml", "reading": 2}, "`reading` is for a text"),
        ({"file": "own.scenic", "reading": 2}, "`reading` is for a text"),
        ({"file": "own.scenic", "facts": {"side": "left"}}, "`set` change a text or situation"),
        ({"file": "crosses.yaml", "as_written": True}, "are for a program, and none is given"),
        ({"sentence": CROSSES, "as_written": True}, "are for a program, and none is given"),
    ):
        assert says in called(folder, "run", out="dropped", **arguments)["error"], arguments
    assert not (folder / "dropped").exists()
    desk = replace(desk_in(folder), reading={"language_model": "scripted:none.json"})
    for arguments in ({"file": "told.txt"}, {"sentence": CROSSES}):
        answer = answered(desk, {"tool": "run", "arguments": {**arguments, "out": "by-a-model"}})
        assert "none.json" in answer["error"], arguments


def test_a_sentence_that_names_a_file_is_not_read_as_one(folder: Path) -> None:
    answer = called(folder, "verify", what="drive.csv", said="../outside/secret.yaml")
    assert "said_file" in answer["error"]


def test_only_packaged_egos_and_formats_are_taken(folder: Path) -> None:
    assert "no ego" in called(folder, "run", sentence=CROSSES, ego="os:system")["error"]
    assert "no format" in called(folder, "export", run="runs/brakes", to="os:system", out="x")["error"]


def test_what_is_built_is_kept_verified_told_and_edited(folder: Path) -> None:
    built = called(folder, "build", situation=EXAMPLE.split("\n", 1)[1], save_as="kept/one.yaml", show_program=True)
    assert "next: verify kept/one.scenic against kept/one.yaml" in built["text"]
    assert "model chatscene.world.model" in built["text"]
    shown = called(folder, "verify", what="kept/one.scenic", said_file="kept/one.yaml", draws=1)
    assert "shown: 1 of 1" in shown["text"]
    not_shown = called(folder, "verify", what="drive.csv", said="The car ahead brakes hard.")
    assert "NOT shown" in not_shown["text"]
    assert not_shown["text"].endswith("next: story drive.csv")
    changed = called(folder, "edit", file="kept/one.yaml", edit="make it a child", save_as="kept/two.yaml")
    assert "pedestrian → child" in changed["text"]
    assert read_text((folder / "kept" / "two.yaml").read_text()).others[0].kind == "child"
    again = called(folder, "build", file="kept/two.yaml", save_as="kept/one.yaml")
    assert "there already" in again["error"]


def test_a_refusal_says_what_was_not_understood_and_what_to_do(folder: Path) -> None:
    refused = called(folder, "read", sentence="A dragon lands on the bonnet.")["error"]
    assert refused.startswith("NothingFits: ")
    assert "there are no words" in refused
    assert "next: " in refused
    faults = called(folder, "build", situation="others: [{id: A, kind: lorry}]")["error"]
    assert "did you mean truck?" in faults


def test_a_picture_comes_with_a_story_that_asks_for_it(folder: Path) -> None:
    assert called(folder, "story", what="drive.csv")["picture"] == ""
    assert called(folder, "story", what="drive.csv", at=2.0)["picture"]
    assert "no picture at 99 s" in called(folder, "story", what="drive.csv", at=99)["error"]


@pytest.mark.parametrize(
    ("about", "says"),
    [
        ("", "Deed: act, to"),
        ("cut-in", "begins from"),
        ("Act", "brake: loses speed hard"),
        ("others.A.starts.where", "roadside: beside the road"),
        ("ego", "route (EgoRoute)"),
    ],
)
def test_words_are_explained_alone_or_listed_together(folder: Path, about: str, says: str) -> None:
    assert says in called(folder, "vocabulary", about=about)["text"]


def test_every_noun_and_every_table_can_be_asked_for(folder: Path) -> None:
    for name in nouns():
        assert name in called(folder, "vocabulary", about=name)["text"]
    assert "did you mean 'cross'" in called(folder, "vocabulary", about="crosss")["error"]
    assert (
        "'others.A.does.0.speedy'; Deed has act"
        in called(folder, "vocabulary", about="others.A.does.0.speedy")["error"]
    )


RESOURCES = {
    "schema": "chatscene://schema",
    "acts": "chatscene://acts",
    "places": "chatscene://places",
    "vocabulary": "chatscene://vocabulary",
    "word": "chatscene://word/cut-in",
    "file": "chatscene://file/crosses.yaml",
    "report": "chatscene://report/runs/brakes",
    "picture": "chatscene://picture/drive.csv?at=2.5",
}


def resource(folder: Path, uri: str) -> Mapping[str, Any]:
    return answered(desk_in(folder), {"resource": uri})


def test_every_resource_can_be_read(folder: Path) -> None:
    assert set(RESOURCES) == set(KINDS)
    for name, uri in RESOURCES.items():
        found = resource(folder, uri)
        assert found.get("text") or found.get("picture"), found
        assert found["media"] == KINDS[name].media


@pytest.mark.parametrize("kind", ["file", "report", "picture"])
@pytest.mark.parametrize("where", [*OUTSIDE, "%2e%2e/outside/secret", "..%2foutside%2fsecret"])
def test_no_resource_leads_out_of_the_folder(folder: Path, kind: str, where: str) -> None:
    for suffix in (".yaml", ".csv", ".scenic"):
        found = resource(folder, f"chatscene://{kind}/{where}{suffix}")
        assert "error" in found, found
        assert SECRET not in found["error"]


@pytest.mark.parametrize("uri", ["", "x", "http://acts", "chatscene://", "chatscene://[", "chatscene://act"])
def test_an_address_at_which_nothing_stands_is_refused(folder: Path, uri: str) -> None:
    assert "error" in resource(folder, uri)


def test_what_there_is_is_listed_without_links(folder: Path) -> None:
    found = answered(desk_in(folder), {"list": 0})
    names = [one["name"] for one in found["resources"]]
    assert {"schema", "crosses.yaml", "runs/brakes"} <= set(names)
    assert not [name for name in names if name.startswith("link")]
    assert found["next"] is None


def test_what_there_is_is_listed_in_order_of_paths_some_at_a_time(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(resources, "PAGE", 4)
    for name in ("b/z.yaml", "b/run.json", "a.scenic", "b-c/run.json", "run.json", "b/closed/x.yaml", "c.csv"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("")
    (tmp_path / "b" / "pipe.yaml").symlink_to("z.yaml")
    names, begin = list[str](), 0
    while begin is not None:
        page, begin = resources.listed_resources(desk_in(tmp_path), begin)
        assert 0 < len(page) <= 4
        names += [one["uri"].removeprefix("chatscene://") for one in page]
    always = [name for name, kind in KINDS.items() if not kind.behind]
    assert names == [
        *always, "file/a.scenic", "file/b/closed/x.yaml", "report/b", "file/b/z.yaml", "report/b-c", "report/.",
    ]  # fmt: skip
    assert list(Folder(tmp_path).files()) == sorted(Folder(tmp_path).files())


def test_the_kept_scenes_of_a_run_are_some_in_its_answer_and_all_in_its_report(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tooling, "MOST_LISTED", 1)
    ran = called(folder, "run", file="crosses.yaml", scenes=4, out="runs/kept of many")["text"].splitlines()
    report = resource(folder, "chatscene://report/runs/kept%20of%20many")["text"].splitlines()
    begin, kept = ran.index("kept scenes:"), report[report.index("kept scenes:") + 1 :]
    assert ran[begin + 1] == kept[0]
    assert len(kept) > 1
    more = f"  and {len(kept) - 1} more; chatscene://report/runs/kept%20of%20many lists them"
    assert ran[begin + 2] == more
    monkeypatch.setattr(resources, "MOST", 40)
    cut = resource(folder, "chatscene://report/runs/kept%20of%20many")["text"]
    assert cut.endswith("\n… more than 40 characters; the rest is left out")


def test_a_folder_that_is_a_run_itself_is_one_by_the_name_that_is_listed(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = folder / "runs" / "brakes"
    monkeypatch.chdir(run)
    assert next(Folder(run).runs()) == "."
    assert "kept scenes" in resource(run, "chatscene://report/.")["text"]
    assert "error" not in called(run, "story", what=".")


def test_facts_are_of_bounded_length(folder: Path) -> None:
    for facts in ({"others.A.kind": "x" * 201}, {"x" * 201: 1}):
        assert "at most 200 characters" in called(folder, "build", file="crosses.yaml", facts=facts)["error"]
    for most in (1e308, 10**400):
        answer = called(folder, "build", file="crosses.yaml", facts={"others.A.does.0.speed": most})
        assert "a fault of chatscene" not in answer["error"]


def test_a_long_answer_is_cut_at_the_ends_of_lines_and_nothing_is_lost() -> None:
    lines = [f"line {number}" for number in range(2000)]
    parts = in_parts("\n".join(lines))
    assert len(parts) > 1
    assert "\n".join(parts).split("\n") == lines
    assert in_parts("x" * 13_000) == ["x" * 6000, "x" * 6000, "x" * 1000]
