"""Plug-ins of all kinds: built in, brought by an installed package, pointed at by the user."""

from __future__ import annotations

import re
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from chatscene import plugins, runs
from chatscene.commands.main import main
from chatscene.ego.policy import EGOS, load_ego
from chatscene.errors import ChatSceneError, MissingExtra, SettingsError
from chatscene.exports.exporter import EXPORTERS
from chatscene.interpret.readers import is_model
from chatscene.models.encoders.embedding import EMBEDDERS
from chatscene.models.language.protocol import LANGUAGE_MODELS, load_language_model
from chatscene.plugins import Kind, Packaged, make, names
from chatscene.read.reader import READERS
from chatscene.runs.executor import EXECUTORS
from chatscene.search.generator import GENERATORS
from chatscene.search.sampler import SAMPLERS, load_sampler
from chatscene.simulate.simulator import SIMULATORS
from places import ROOT

KINDS: tuple[Kind[Any], ...] = (
    *(EGOS, SAMPLERS, GENERATORS, LANGUAGE_MODELS, EMBEDDERS, SIMULATORS),
    *(EXPORTERS, EXECUTORS, READERS),
)
every_kind = pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.noun)

PAGE = (ROOT / "docs" / "plugins.md").read_text()
MIDDLE = PAGE.split("```python\n")[1].split("```")[0]
FAULTS = """
def broken():
    raise RuntimeError("out of order")


def leaves():
    raise SystemExit(0)
"""


def install(place: Path, package: str, entry_points: str, code: str) -> None:
    """A distribution as `pip install` leaves it: its module and what it says of itself."""
    (place / f"{package}.py").write_text(code)
    told = place / f"{package}-1.0.dist-info"
    told.mkdir()
    (told / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {package}\nVersion: 1.0\n")
    (told / "entry_points.txt").write_text(entry_points)


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A folder where packages are installed."""
    place = tmp_path / "site-packages"
    place.mkdir()
    monkeypatch.syspath_prepend(place)
    before = set(sys.modules)
    yield place
    for module in set(sys.modules) - before:
        if Path(str(getattr(sys.modules[module], "__file__", ""))).parent in (place, tmp_path):
            del sys.modules[module]


@pytest.fixture
def middle(place: Path) -> str:
    """The name of a sampler that another package brings: that of the documents."""
    project = tomllib.loads(PAGE.split("```toml\n")[1].split("```")[0])["project"]
    [(group, brought)] = project["entry-points"].items()
    [(name, value)] = brought.items()
    install(place, project["name"].replace("-", "_"), f"[{group}]\n{name} = {value}\n", MIDDLE)
    return name


@every_kind
def test_an_unknown_name_is_refused_with_the_nearest_and_what_else_there_is(kind: Kind[Any]) -> None:
    known = min(kind.built_in)
    with pytest.raises(kind.error, match=rf"no {kind.noun} '{known}x'; did you mean '{known}'.*package.module:factory"):
        make(kind, f"{known}x")


@every_kind
def test_what_another_package_brings_is_one_more_name_of_its_kind(kind: Kind[Any], place: Path) -> None:
    code = f"class Other:\n    def {kind.method}(self):\n        return 7\n"
    install(place, "other_package", f"[{kind.group}]\nother-package = other_package:Other\n", code)
    assert names(kind) == sorted([*kind.built_in, "other-package"])
    assert type(make(kind, "other-package")).__name__ == "Other"
    with pytest.raises(kind.error, match="did you mean 'other-package'"):
        make(kind, "other-packag")


def test_a_sampler_of_another_package_searches_by_its_name(middle: str, tmp_path: Path) -> None:
    folder = tmp_path / "run"
    text = "A delivery van ahead of us brakes hard on a straight road."
    command = ["run", text, "--sampler", middle, "--scenes", "2", "--routes", "1", "--out", str(folder)]
    done = CliRunner().invoke(main, command)
    assert done.exit_code == 0, done.output
    run = runs.open_run(folder)
    declared = {row["parameter"]: (row["low"] + row["high"]) / 2 for row in runs.read_ranges(run)}
    scenes = list(runs.read_scenes(run))
    assert len(scenes) == 2
    for scene in scenes:
        assert {name: scene[name] for name in declared} == pytest.approx(declared)

    refused = CliRunner().invoke(main, ["resume", str(folder)])
    assert refused.exit_code == 1
    assert "--sampler middle" in refused.output
    assert CliRunner().invoke(main, ["resume", str(folder), "--sampler", middle]).exit_code == 0


def test_what_is_built_in_is_never_replaced(place: Path) -> None:
    install(place, "usurper", "[chatscene.samplers]\nrandom = usurper:Middle\n", MIDDLE)
    assert type(load_sampler("random")).__name__ == "Uniform"


def test_the_page_lists_every_kind() -> None:
    assert [row.split(" | ")[2] for row in PAGE.splitlines() if row.startswith("| ") and "`chatscene." in row] == [
        f"`{kind.group}`" for kind in KINDS
    ]


@pytest.mark.parametrize(("kind", "command"), [(SAMPLERS, "run"), (EXPORTERS, "export")])
def test_a_help_names_all_that_is_built_in(kind: Kind[Any], command: str) -> None:
    output = CliRunner().invoke(main, [command, "--help"]).output
    helped = re.split(r"[\s,:]+", re.sub(r"-\s+", "-", output))  # lines break behind a hyphen
    for name in kind.built_in:
        assert name in helped, f"chatscene {command} --help does not name the {kind.noun} {name}"


def test_a_plug_in_of_ours_is_a_file_that_says_its_name(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "samplers").mkdir()
    (tmp_path / "samplers" / "helper.py").write_text("HELPS = 1\n")
    said = (
        'PLUGIN = {\n    "name": "halton",\n    "makes": "Halton",\n    "needs": "search",\n    "what": "evenly",\n}\n'
    )
    (tmp_path / "samplers" / "even.py").write_text(said)
    monkeypatch.setattr(plugins, "_HERE", tmp_path)
    assert dict(Packaged("samplers")) == {"halton": "chatscene.samplers.even:Halton [search]"}
    (tmp_path / "samplers" / "odd.py").write_text(said)
    with pytest.raises(ValueError, match=r"odd\.py: PLUGIN is to have a name of its own"):
        len(Packaged("samplers"))


def test_a_name_that_two_packages_bring_stands_for_neither(place: Path) -> None:
    for package in ("one_package", "two_package"):
        install(place, package, f"[chatscene.samplers]\nmiddle = {package}:Middle\n", MIDDLE)
    with pytest.raises(SettingsError, match=r"several packages .*'middle' \(one_package:Middle, two_package:Middle\)"):
        load_sampler("middle")


def test_a_package_that_another_one_needs_is_named_with_the_extra_that_brings_it(place: Path) -> None:
    install(
        place, "heavy_sampler", "[chatscene.samplers]\nheavy = heavy_sampler:X [gpu]\n", "import no_such_package_\n"
    )
    with pytest.raises(MissingExtra, match=r"'heavy' needs no_such_package_.*pip install \"heavy_sampler\[gpu\]\""):
        load_sampler("heavy")


def test_a_fault_in_a_package_is_no_missing_extra(place: Path) -> None:
    code = "from heavy_fault import nothing\n"
    install(place, "heavy_fault", "[chatscene.samplers]\nheavy = heavy_fault:X [gpu]\n", code)
    with pytest.raises(SettingsError, match="cannot import 'heavy_fault:X"):
        load_sampler("heavy")


@pytest.mark.parametrize("value", ["", "middle_of", "..:x", "middle_of:"])
def test_a_package_that_names_no_factory_is_told_so(value: str, place: Path) -> None:
    install(place, "middle_of", f"[chatscene.samplers]\nmiddle = {value}\n", MIDDLE)
    with pytest.raises(SettingsError, match="'middle'"):
        load_sampler("middle")


def test_a_sampler_of_the_users_own_is_found_in_the_working_folder(
    tmp_path: Path, place: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "a_sampler_of_mine.py").write_text(MIDDLE + FAULTS)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", [entry for entry in sys.path if entry not in ("", str(tmp_path))])
    before = list(sys.path)
    assert type(load_sampler("a_sampler_of_mine:Middle")).__name__ == "Middle"
    assert sys.path == before
    for name, reason in (("broken", "out of order"), ("leaves", "SystemExit"), ("Proposal", "fails"), ("no", "has no")):
        with pytest.raises(SettingsError, match=reason):
            load_sampler(f"a_sampler_of_mine:{name}")


def test_a_language_model_of_the_users_own_takes_what_stands_behind_it(place: Path) -> None:
    code = """
class Model:
    price, identity = None, {}

    def __init__(self, which, *, limits):
        self.name = which

    def complete(self, messages, schema):
        raise NotImplementedError
"""
    install(place, "model_of_mine", "[chatscene.language_models]\nmine = model_of_mine:Model\n", code)
    for name in ("mine:small:7b", "model_of_mine:Model:small:7b"):
        assert load_language_model(name).name == "small:7b"


def test_every_built_in_name_leads_somewhere() -> None:
    for kind in KINDS:
        for name in kind.built_in:
            with pytest.raises(
                ChatSceneError, match=r"fails: TypeError|needs (carla|ray)"
            ):  # not in every test environment
                make(kind, name, *range(9), no_such_argument=0)


READS = """
from chatscene.read.reader import check_text
from chatscene.situations.form import from_plain
from chatscene.terms.reading import Ranked, SituationReading, Verdict


class Mine:
    name = "mine"

    def read(self, text):
        check_text(text)
        told = {"others": [{"id": "A", "kind": "bus", "starts": {"where": "ahead"}, "does": [{"act": "brake"}]}]}
        told["evidence"] = {"quoted": {"others.A": text.split()[0]}}
        ranked = (Ranked(situation=from_plain(told), probability=1.0),)
        return SituationReading(text=text, reader=self.name, verdict=Verdict.SITUATION, ranked=ranked)
"""


def test_a_reader_of_another_package_reads_where_a_language_model_may(place: Path) -> None:
    install(place, "reads_mine", "[chatscene.readers]\nmine = reads_mine:Mine\n", READS)
    for name in ("mine", "reads_mine:Mine"):
        done = CliRunner().invoke(main, ["explain", "Whatever is said", "--language-model", name])
        assert done.exit_code == 0, done.output
        assert "bus" in done.output


def test_a_name_is_of_a_reader_or_of_a_language_model() -> None:
    assert not any(map(is_model, ("offline", "mine", "my_stack:reader", "my_stack.reading:make")))
    assert all(map(is_model, ("openai:gpt-4", "gguf", "opnai:gpt-4", "gguf:a.gguf", "my_stack.models:make:large")))


def test_code_that_changes_the_working_folder_leaves_the_users_paths_where_they_are(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "moving_stack.py").write_text(
        "import os\n\nos.chdir('/')\n\nclass Ego:\n    def __init__(self):\n        os.chdir('/')\n\n"
        "    def act(self, observation):\n        return 0.0, 0.0\n"
    )
    monkeypatch.chdir(tmp_path)
    load_ego("moving_stack:Ego")
    assert Path.cwd() == tmp_path
