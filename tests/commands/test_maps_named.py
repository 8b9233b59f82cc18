"""A map that cannot be used, such as one that keeps to both sides, is refused at every door, and the reason is told."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import click
import pytest
from click.testing import CliRunner

from chatscene import runs
from chatscene.commands.main import main
from chatscene.commands.verify import NOT_JUDGED
from chatscene.errors import MapError
from chatscene.exports.export import export
from chatscene.exports.exporter import EXPORTERS
from chatscene.maps.network import PACKAGED
from chatscene.plugins import names
from chatscene.report.viewer import write_report
from chatscene.runs.digests import digest_of
from chatscene.view.looking import compared, listed, still
from fake_run import finished, resealed

REFUSED = "keeps to the left on road '1' (rule LHT) and to the right on road"


def with_a_map(group: click.Group, *before: str) -> Iterator[list[str]]:
    """How each command is called with a map, and else only with what it must be told."""
    for name, command in group.commands.items():
        if isinstance(command, click.Group):
            yield from with_a_map(command, *before, name)
        elif any("--map" in parameter.opts for parameter in command.params):
            must = [part for part in command.params if isinstance(part, click.Argument) and part.required]
            yield [*before, name, *("nothing" for _ in must), "--map"]
        elif any(parameter.name == "map_name" for parameter in command.params):
            yield [*before, name]


@pytest.fixture
def left(tmp_path: Path) -> Path:
    path = tmp_path / "left.xodr"
    path.write_text(PACKAGED["town"].read_text().replace('rule="RHT"', 'rule="LHT"', 1))
    return path


@pytest.mark.parametrize("words", list(with_a_map(main)), ids=" ".join)
def test_every_command_that_takes_a_map_refuses_it_first(
    words: list[str], left: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if words[0] == "serve-carla":
        pytest.importorskip("carla", reason="the extra 'carla' is not installed")
    monkeypatch.chdir(left.parent)
    done = CliRunner().invoke(main, [*words, "left.xodr"])
    assert done.exit_code == (NOT_JUDGED if words[0] == "verify" else 1), done.output
    assert done.output.count("\n") == 1
    assert REFUSED in done.output
    assert list(left.parent.iterdir()) == [left]


def test_a_simulator_is_not_tried_on_a_map_that_is_refused_and_the_map_is_the_reason(left: Path) -> None:
    done = CliRunner().invoke(main, ["doctor", "--simulator", "native", "--map", str(left)])
    assert done.exit_code == 1
    assert "keeps to the left on road" in done.output


@pytest.fixture
def run(left: Path) -> runs.Workspace:
    """One that an earlier version made on such a map, and drove on one side of it all."""
    run = finished(left.parent / "runs" / "older", count=1)
    resealed(run, map_name=str(left), map_digest=digest_of(left))
    return run


@pytest.mark.parametrize("to", names(EXPORTERS))
def test_no_format_is_exported_of_drives_on_such_a_map(to: str, run: runs.Workspace, tmp_path: Path) -> None:
    with pytest.raises(MapError, match="keeps to the left on road '1'"):
        export(run.path, to=to, out=tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_a_run_of_before_on_such_a_map_is_still_looked_at(run: runs.Workspace) -> None:
    assert write_report(run.path).is_file()
    (one,) = listed(run.path.parent)["runs"]
    assert one["status"] == "done"
    assert compared(run.path.parent, "older", "older")["groups"]
    assert still(run.path.parent, "older")["webp"]
