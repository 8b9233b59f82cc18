"""A folder of others' scenarios becomes a folder of programs, with a row for each file."""

from __future__ import annotations

import json
import re
import shlex
from pathlib import Path

import pytest
from click.testing import CliRunner

from chatscene.commands.main import main
from chatscene.errors import SettingsError
from chatscene.imports.import_file import import_scenario
from chatscene.imports.import_folder import import_folder
from chatscene.search.generators.foreign import foreign_files, read_foreign
from chatscene.studies.imported_entries import catalogue_of
from red_team.scenario_files import scenario


@pytest.fixture
def theirs(beside: Path) -> Path:
    """Two scenarios that are read, one in a folder, one that is not, a catalog, and values for a scenario."""
    (beside / "deep").mkdir()
    (beside / "a.xosc").write_text(scenario())
    (beside / "deep" / "b.xosc").write_text(scenario(map_name="../town.xodr"))
    (beside / "cars.xosc").write_text('<OpenSCENARIO><Catalog name="cars"/></OpenSCENARIO>')
    (beside / "gone.xosc").write_text(scenario(map_name="gone.xodr"))
    both = '<DistributionSet><Element value="20"/><Element value="far"/><Element value="30"/></DistributionSet>'
    (beside / "values.xosc").write_text(
        '<OpenSCENARIO><ParameterValueDistribution><ScenarioFile filepath="a.xosc"/><Deterministic>'
        f'<DeterministicSingleParameterDistribution parameterName="near">{both}'
        "</DeterministicSingleParameterDistribution></Deterministic></ParameterValueDistribution></OpenSCENARIO>"
    )
    return beside


def test_a_folder_of_scenarios_becomes_a_folder_of_programs_and_each_file_has_a_row(theirs: Path) -> None:
    out = theirs / "mine"
    done = CliRunner().invoke(main, ["import", str(theirs), "--out", str(out)], catch_exceptions=False)
    assert done.exit_code == 0
    rows = done.output.splitlines()
    assert [row.partition(":")[0] for row in rows[:-1]] == [
        "a.xosc", "cars.xosc", "deep/b.xosc", "gone.xosc", "values.xosc",
    ]  # fmt: skip
    assert rows[0].startswith(f"a.xosc: a.scenic on map {theirs / 'town.xodr'}")
    assert "a catalog" in rows[1]
    assert "REFUSED: " in rows[3]
    assert "does not lie there" in rows[3]
    assert re.search(r"-1.scenic and 1 more, WITHOUT 1 variant: line \d+: .*'far' is not a number.* on map", rows[4])
    assert rows[-1] == f"5 files: 3 became 4 programs in {out}, 1 were refused, 1 are catalogs"
    assert [str(one.relative_to(out)) for one in foreign_files(out)] == [
        "a.scenic", "deep/b.scenic", "values-1.scenic", "values-3.scenic",
    ]  # fmt: skip
    assert all(read_foreign(one).program.source for one in foreign_files(out))


def test_the_rows_of_a_folder_are_json_too_and_nothing_is_overwritten(theirs: Path) -> None:
    arguments = ["import", str(theirs), "--out", str(theirs / "mine"), "--json"]
    rows = json.loads(CliRunner().invoke(main, arguments, catch_exceptions=False).output)
    assert [row["became"] for row in rows] == ["programs", "catalog", "programs", "refused", "programs"]
    assert rows[4]["programs"] == ["values-1.scenic", "values-3.scenic"]
    assert [one.startswith("variant 2 of ") for one in rows[4]["without"]] == [True]
    with pytest.raises(SettingsError, match="is not an empty folder"):
        import_folder(theirs, theirs / "mine")


def test_a_folder_needs_a_place_for_its_programs(theirs: Path, tmp_path: Path) -> None:
    for more in ([], ["--out", "x", "--variant", "1"], ["--out", "x", "--param", "near=3"]):
        done = CliRunner().invoke(main, ["import", str(theirs), *more])
        assert "a folder needs --out" in done.output
    (tmp_path / "empty").mkdir()
    with pytest.raises(SettingsError, match=r"holds no \.xosc file"):
        import_folder(tmp_path / "empty", tmp_path / "out")


def test_no_program_of_a_folder_takes_the_name_of_another(theirs: Path) -> None:
    (theirs / "values-1.xosc").write_text(scenario())
    (theirs / "a-1.xosc").write_text(scenario())
    (theirs / "a.XOSC").write_text(scenario())
    found = {str(one.file): one for one in import_folder(theirs, theirs / "mine").files}
    assert [str(one) for one in found["values.xosc"].programs] == ["values_-1.scenic", "values_-3.scenic"]
    assert [str(one) for one in found["values-1.xosc"].programs] == ["values-1.scenic"]
    assert {str(found[name].programs[0]) for name in ("a.xosc", "a.XOSC")} == {"a.scenic", "a_2.scenic"}


def test_a_folder_whose_import_was_interrupted_is_told_to_be_one(theirs: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("chatscene.imports.import_folder.import_scenario", interrupted)
    with pytest.raises(KeyboardInterrupt):
        import_folder(theirs, theirs / "mine")
    with pytest.raises(SettingsError, match="delete it, if an import was interrupted there"):
        import_folder(theirs, theirs / "mine")
    with pytest.raises(SettingsError, match="has not come to its end; wait for it, or delete it and import again"):
        catalogue_of(theirs / "mine")


def test_the_command_that_is_printed_can_be_pasted(beside: Path) -> None:
    (beside / "a b$.xosc").write_text(scenario())
    made = import_scenario(beside / "a b$.xosc")
    assert shlex.split(made.command)[3] == str(beside / "a b$.scenic")
