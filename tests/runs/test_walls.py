"""Ways round the sandbox: what a stranger's run folder, library, ego or working folder tries, and what stops it."""

from __future__ import annotations

import io
import json
import os
import socket
import subprocess
import sys
import types
import zipfile
from collections.abc import Callable
from dataclasses import asdict, replace
from operator import itemgetter
from pathlib import Path
from typing import Any
from unittest.mock import Mock

import numpy as np
import pytest
from click.testing import CliRunner
from rich.console import Console

import chatscene as api
from chatscene import pipeline, runs
from chatscene.commands.main import main
from chatscene.ego.network import load_network
from chatscene.ego.policy import load_ego
from chatscene.errors import EgoError, ForeignCodeRefused, RunError, SandboxError, SnippetError
from chatscene.files import bounded
from chatscene.grow import curation
from chatscene.grow.curation import lint_library
from chatscene.grow.lint import Finding, Triple
from chatscene.grow.twins import scenario_of
from chatscene.learn.finetune import scenes
from chatscene.learn.finetune.scenes import kept_scenes
from chatscene.library.load import Library, library_with, load_library, load_snippet
from chatscene.library.snippet_file import as_text
from chatscene.maps.network import resolve_map
from chatscene.program.assemble import assemble
from chatscene.report.terminal import print_understanding, visible
from chatscene.runs import rebuild as rebuilding
from chatscene.runs import replay as replaying
from chatscene.runs.atomic import sweep
from chatscene.runs.digests import write_sealed
from chatscene.runs.executor import Workers
from chatscene.runs.parallel import spread
from chatscene.runs.record import RECORDS
from chatscene.runs.replay import replay
from chatscene.runs.trust import Repeated, follow
from chatscene.search.climb import simulator_of
from chatscene.search.generator import GENERATORS, load_generator
from chatscene.search.generators.retrieved import Retrieved
from chatscene.settings import RetrievalSettings, Settings
from chatscene.simulate.confined import nursery as nurseries
from chatscene.simulate.confined.confinement import LAYERS, Limits
from chatscene.simulate.confined.nursery import Confined
from chatscene.simulate.confined.simulator import ConfinedSimulator
from chatscene.simulate.simulator import Simulator
from chatscene.studies import evaluation
from chatscene.studies.reproduce import METHODS
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.scene import ScenicProgram
from fake_run import TEXT, asked, finished, resealed, started, understanding

TOWN = resolve_map("town")
CONTROL = "\x1b]0;owned\x07\x1b[2J"


def silent(_what: str, _done: int, _total: int) -> None:
    pass


def told(run: runs.Workspace, **changes: Any) -> runs.Workspace:
    """A run whose record says something else; ``retrieval`` and ``search`` go into its settings."""
    path = run.file("run.json")
    record = json.loads(path.read_text())
    del record["digest"]
    for part in ("retrieval", "search"):
        record["settings"][part] |= changes.pop(part, {})
    write_sealed(path, record | changes)  # a digest keeps nobody from making another
    return run


def as_evaluation(run: runs.Workspace, **changes: Any) -> runs.Workspace:
    """A run whose record says that it is an evaluation."""
    return told(run, kind="evaluation", scenes="kept", sources=[], **changes)


@pytest.fixture
def canary(tmp_path: Path) -> Path:
    """A file that is there if a stranger's code ran."""
    return tmp_path / "canary"


@pytest.fixture
def hostile(tmp_path: Path, canary: Path) -> Path:
    """A library with one snippet, sound but for a line that makes a file."""
    folder = tmp_path / "library"
    text = as_text(load_library().get("behavior/cross"))
    evil = text + f'\nopened = open("{canary}", "w")\n'
    (folder / "behavior").mkdir(parents=True)
    (folder / "behavior" / "evil.scenic").write_text(evil)
    return folder


FOLLOWERS: dict[str, Callable[[Path], object]] = {
    "resume": pipeline.resume,
    "replay": lambda folder: replay(folder, "x"),
    "evaluate": lambda folder: evaluation.evaluate([folder], folder / "e", egos=["idm"], progress=silent),
    "finetune": lambda folder: kept_scenes([folder]),
}


# Libraries, and plug-ins that are not packaged


SETTINGS = asdict(Settings())
ON_A_MAP: dict[str, Any] = {
    "settings": SETTINGS, "map_name": "town", "map_digest": "", "simulator": {}, "senses": {}, "ego_digests": {},
}  # fmt: skip
BENCHMARK = ON_A_MAP | {"egos": ["idm"], "surrogate": "idm", "generator": "chatscene", "budget": "small"}
LESSONS = {"digest": "", "train": 1, "choice": 1, "test": 1}
FINETUNING = {"settings": {"ego": "sac"}, "ego_digests": {}, "scenes": LESSONS}
TRAINING = {"settings": {}, "map_digest": "", "simulator": {}}
COMPARISON = {"imported": "../mine", "programs": {}, "maps": {}, "settings": {}, "ego_digests": {}, "senses": {}}


def other(part: str, **named: str) -> dict[str, Any]:
    return {"settings": SETTINGS | {part: SETTINGS[part] | named}}


@pytest.mark.parametrize(
    ("kind", "record", "named"),
    [
        ("comparison", COMPARISON | {"egos": ["sys:exit"]}, "--ego sys:exit"),
        ("benchmark", BENCHMARK | {"egos": ["sys:exit"]}, "--ego sys:exit"),
        ("benchmark", BENCHMARK | {"surrogate": "sys:exit"}, "--ego sys:exit"),
        ("benchmark", BENCHMARK | {"generator": "sys:exit"}, "--generator sys:exit"),
        ("benchmark", BENCHMARK | other("search", sampler="sys:exit"), "--sampler sys:exit"),
        ("benchmark", BENCHMARK | other("simulation", simulator="sys:exit"), "--simulator sys:exit"),
        ("benchmark", BENCHMARK | other("retrieval", library="snippets"), "--library snippets"),
        ("benchmark", BENCHMARK | other("retrieval", language_model="gguf:x"), "--language-model gguf:x"),
        ("finetuning", FINETUNING | {"settings": {"ego": "sys:exit"}}, "--ego sys:exit"),
        ("finetuning", FINETUNING | {"settings": {"ego": "sac", "teacher": "sys:exit"}}, "--ego sys:exit"),
        ("finetuning", FINETUNING | {"settings": {"ego": "sac", "simulator": "sys:exit"}}, "--simulator sys:exit"),
        ("training", TRAINING | {"settings": {"simulator": "sys:exit"}}, "--simulator sys:exit"),
    ],
)
def test_whatever_kind_of_folder_names_what_is_not_packaged_is_not_gone_on_with(
    kind: str, record: dict[str, Any], named: str, tmp_path: Path
) -> None:
    run = runs.create(tmp_path / "x", RECORDS[runs.Kind(kind)].model_validate(record))
    done = CliRunner().invoke(main, ["resume", str(run.path)])
    assert done.exit_code == 1, done.output
    assert f"say so: {named}" in done.output
    again = CliRunner().invoke(main, ["resume", str(run.path), *named.split()])
    assert "say so" not in again.output


def test_a_reproduction_names_nothing_and_what_lies_in_it_must_be_what_it_asks_for(tmp_path: Path) -> None:
    settings = {"budget": "small", "avoidable_only": False, "physics": "kinematic", "seed": 0}
    told = {"settings": settings, "tables": ["table1"], "preset": "paper", "choice": "paper"}
    run = runs.create(tmp_path / "r", runs.ReproductionRecord.model_validate(told))
    inner = BENCHMARK | {"generator": "sys:exit"}
    runs.create(run.file("generation") / METHODS[0], runs.BenchmarkRecord.model_validate(inner))
    with pytest.raises(RunError, match="a benchmark with other settings"):
        api.resume(run.path)
    with pytest.raises(RunError, match="does not name the ego 'sac'; it names none"):
        api.resume(run.path, ego="sac")


def naming(run: runs.Workspace, option: str, value: str) -> runs.Workspace:
    if option == "generator":
        return told(run, generator=value)
    return told(run, search={option: value}) if option == "sampler" else told(run, retrieval={option: value})


READ_BY = [("embedder", "sentence-t5:weights"), ("language_model", "gguf:weights.gguf")]


@pytest.mark.parametrize(
    ("command", "option", "value"),
    [(command, "library", "snippets") for command in ("resume", "replay", "evaluate")]
    + [(command, "generator", "mine:make") for command in ("resume", "replay", "evaluate")]
    + [("resume", "sampler", "antigravity:x")]
    + [("resume", option, value) for option, value in READ_BY],
)
def test_a_record_that_names_what_is_not_packaged_is_not_followed(
    command: str, option: str, value: str, tmp_path: Path
) -> None:
    run = naming(finished(tmp_path / "run", count=1), option, value)
    with pytest.raises(RunError, match=rf"names the .* '{value}'.*--{option.replace('_', '-')} {value}"):
        FOLLOWERS[command](run.path)


def test_nobody_trains_on_a_folders_snippets(tmp_path: Path) -> None:
    run = told(finished(tmp_path / "run", count=1), retrieval={"library": "snippets"})
    with pytest.raises(RunError, match="code that is not packaged"):
        kept_scenes([run.path])


def test_nobody_trains_on_scenes_of_a_generator_that_is_not_packaged(tmp_path: Path) -> None:
    run = told(finished(tmp_path / "run", count=1), generator="sys:exit")
    with pytest.raises(RunError, match="code that is not packaged"):
        kept_scenes([run.path])


@pytest.mark.parametrize("command", ["replay", "evaluate", "finetune"])
@pytest.mark.parametrize(("option", "value"), READ_BY)
def test_who_read_the_sentence_need_not_be_named_where_it_is_not_read_again(
    command: str, option: str, value: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = told(finished(tmp_path / "run", count=1), retrieval={option: value})

    def rebuild(_run: runs.Workspace) -> None:
        raise Seen

    for module in (rebuilding, evaluation, scenes):
        monkeypatch.setattr(module, "rebuild", rebuild)
    if command == "replay":
        monkeypatch.setattr(replaying, "read_episode", Mock())
        monkeypatch.setattr(replaying, "read_scenes", Mock(return_value=[{"scene_id": "x"}]))
    with pytest.raises(Seen):
        FOLLOWERS[command](run.path)


def test_what_is_repeated_is_followed_and_must_be_what_the_record_names(tmp_path: Path) -> None:
    run = told(finished(tmp_path / "run", count=1), retrieval={"library": "snippets"}, egos=["mine:make"])
    repeated = Repeated(library=("snippets",), ego=("mine:make",))
    follow(repeated, egos_of=[run], reading_of=[run])
    with pytest.raises(RunError, match=r"does not name the library 'other'; it names 'snippets'"):
        follow(replace(repeated, library=("snippets", "other")), egos_of=[run], reading_of=[run])
    with pytest.raises(RunError, match=r"does not name the language model 'gguf:x'"):
        follow(replace(repeated, language_model=("gguf:x",)), egos_of=[run], reading_of=[run])


def test_the_commands_hand_on_what_is_repeated(tmp_path: Path) -> None:
    run = told(finished(tmp_path / "run", count=1), retrieval={"library": "none"})
    for command in (["resume", str(run.path)], ["replay", str(run.path), "x"], ["evaluate", str(run.path)]):
        assert "say so: --library none" in CliRunner().invoke(main, command).output
        said = CliRunner().invoke(main, [*command, "--library", "other"]).output
        assert "say so: --library none" in said
        assert "say so" not in CliRunner().invoke(main, [*command, "--library", "none"]).output


def test_programs_with_a_folders_snippets_run_in_the_confined_process(hostile: Path, canary: Path) -> None:
    settings = Settings(retrieval=RetrievalSettings(library=str(hostile)))
    assert simulator_of(Retrieved(), TOWN, Settings()).identity.name == "embedded"
    simulator = simulator_of(Retrieved(), TOWN, settings)
    assert isinstance(simulator, ConfinedSimulator)
    library = library_with(str(hostile))
    parts = [library.get(i) for i in ("behavior/evil", "geometry/straight-road", "spawn/roadside-right")]
    triple = (parts[0], parts[1], parts[2])
    program = assemble(scenario_of(triple), triple, AdversaryKind.PEDESTRIAN)
    with pytest.raises(ForeignCodeRefused, match="open"):
        simulator.routes(program)
    assert not canary.exists()


def test_a_folders_snippets_pass_the_allow_list_and_run_confined_in_lint(
    hostile: Path, canary: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (hostile / "behavior" / "mine.scenic").write_text(as_text(load_library().get("behavior/cross")))
    library = library_with(str(hostile))
    ids = ("behavior/evil", "behavior/mine", "geometry/straight-road", "spawn/roadside-right")
    few = Library(tuple(library.get(i) for i in ids))
    tried: list[tuple[str, type[Simulator]]] = []

    def try_triple(triple: Triple, _kind: AdversaryKind, simulator: Simulator, *_: object) -> tuple[Finding, ...]:
        tried.append((triple[0].id, type(simulator)))
        return ()

    monkeypatch.setattr(curation, "library_with", Mock(return_value=few))
    monkeypatch.setattr(curation, "try_triple", try_triple)
    monkeypatch.setattr(curation, "alike", Mock(return_value=set[Finding]()))
    _, findings = lint_library(str(hostile), scenes=1, progress=silent)
    assert {(f.snippet_id, f.rung) for f in findings} == {("behavior/evil", "allow-list")}
    assert set(tried) == {("behavior/mine", ConfinedSimulator)}
    assert not canary.exists()


# Egos that a record names


def forged(tmp_path: Path, ego: str, digests: dict[str, str] | None = None) -> runs.Workspace:
    return told(finished(tmp_path / "run", count=1), egos=[ego], ego_digests=digests or {})


@pytest.mark.parametrize("command", ["resume", "replay"])
def test_a_record_does_not_have_a_module_of_the_working_folder_imported(
    command: str, tmp_path: Path, canary: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "evil_stack.py").write_text(f"open({str(canary)!r}, 'w')\n")
    monkeypatch.chdir(tmp_path)
    run = forged(tmp_path, "evil_stack:make")
    with pytest.raises(RunError, match=r"may run code of its own.*--ego evil_stack:make"):
        FOLLOWERS[command](run.path)
    assert not canary.exists()


def test_an_evaluation_that_names_an_ego_is_followed_no_further(tmp_path: Path) -> None:
    run = as_evaluation(finished(tmp_path / "run", count=1), egos=["sac", "sys:exit"])
    with pytest.raises(RunError, match=r"--ego sys:exit"):
        evaluation.resume(run.path)


def test_replay_does_not_end_well_because_a_record_says_sys_exit(tmp_path: Path) -> None:
    run = forged(tmp_path, "sys:exit")
    done = CliRunner().invoke(main, ["replay", str(run.path), "x"])
    assert done.exit_code == 1
    assert "--ego sys:exit" in done.output


@pytest.mark.parametrize("name", ["sys:exit", "antigravity_:x", ".:x", ":", "os:abort_", "operator:truediv"])
def test_whatever_the_code_of_an_ego_raises_is_an_error_of_the_ego(name: str) -> None:
    with pytest.raises(EgoError):
        load_ego(name)


def weights(path: Path) -> Path:
    path.write_bytes((Path(runs.__file__).parents[1] / "ego" / "weights" / "sac.npz").read_bytes())
    return path


def test_plain_weights_are_followed_while_they_are_those_of_the_record(tmp_path: Path) -> None:
    path = weights(tmp_path / "mine.npz")
    run = runs.create(tmp_path / "run", runs.asked_run(TEXT, ego=str(path)))
    follow(Repeated(), egos_of=[run])
    path.write_bytes(path.read_bytes() + b" ")
    with pytest.raises(RunError, match="SHA-256 differs"):
        follow(Repeated(ego=(str(path),)), egos_of=[run])


def test_weights_without_a_digest_must_be_repeated(tmp_path: Path) -> None:
    path = str(weights(tmp_path / "mine.npz"))
    with pytest.raises(RunError, match="no SHA-256"):
        follow(Repeated(), egos_of=[forged(tmp_path, path)])


def test_a_record_of_an_evaluation_is_not_replayed_as_a_run(
    tmp_path: Path, canary: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    evil = "run.evil:x.npz"
    run = finished(tmp_path / "run", count=1)
    with pytest.raises(RunError, match="holds a run, and this takes the folder of an evaluation"):
        evaluation.resume(run.path)
    as_evaluation(run, egos=[evil, "sac"], ego_digests={evil: "0"})
    (run.path / "evil.py").write_text(f"open({str(canary)!r}, 'w')\n")
    for command in ("replay", "resume"):
        with pytest.raises(RunError, match="holds an evaluation, and this takes the folder of a run"):
            FOLLOWERS[command](run.path)
    with pytest.raises(RunError, match="may run code of its own"):
        follow(Repeated(), egos_of=[run])
    assert not canary.exists()


@pytest.mark.parametrize("suffix", [".pt", ".onnx"])
def test_a_model_that_carries_code_is_not_followed_though_its_digest_is_right(suffix: str, tmp_path: Path) -> None:
    path = tmp_path / f"model{suffix}"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("model/code/__torch__.py", "")
    digests = runs.ego_digests([str(path)])
    run = runs.create(tmp_path / "run", asked(egos=[str(path)], ego_digests=digests))
    assert runs.read_record(run).ego_digests
    with pytest.raises(RunError, match="may run code of its own"):
        follow(Repeated(), egos_of=[run])


def test_a_bomb_in_a_record_is_said_to_be_no_plain_weights(tmp_path: Path) -> None:
    path = tmp_path / "bomb.pt"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("archive/data.pkl", bytes(300_000_000))
    with pytest.raises(RunError, match="may run code of its own"):
        follow(Repeated(), egos_of=[forged(tmp_path, str(path))])


@pytest.mark.filterwarnings("ignore:.*torch.jit:DeprecationWarning")
def test_torchscript_in_a_file_of_weights_is_not_run(tmp_path: Path) -> None:
    torch = pytest.importorskip("torch", reason="the extra 'train' is not installed")
    inner = io.BytesIO()
    torch.jit.save(torch.jit.script(torch.nn.Linear(4, 2)), inner)
    with zipfile.ZipFile(tmp_path / "model.zip", "w") as archive:
        archive.writestr("data", "{}")
        archive.writestr("policy.pth", inner.getvalue())
    with pytest.raises(EgoError, match="TorchScript, which is code"):
        load_ego(str(tmp_path / "model.zip"))


# The working folder


def test_the_working_folder_is_looked_at_last_and_only_while_an_ego_of_the_user_is_loaded(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "a_stack_of_mine.py").write_text(
        "import sys\nPLACES = list(sys.path)\nclass Still:\n    def act(self, observation):\n        return 0.0, 0.0\n"
    )
    (tmp_path / "intelligent_driver.py").write_text("")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", [place for place in sys.path if place not in ("", str(tmp_path))])
    before = list(sys.path)
    seen: list[list[str]] = []
    imported = __import__("importlib").import_module

    def spy(name: str) -> types.ModuleType:
        seen.append(list(sys.path))
        return imported(name)

    monkeypatch.setattr("importlib.import_module", spy)
    load_ego("idm")
    assert str(tmp_path) not in seen[-1]
    load_ego("a_stack_of_mine:Still")
    assert seen[-1] == [*before, str(tmp_path)]
    assert sys.path == before
    del sys.modules["a_stack_of_mine"]


def test_python_m_chatscene_imports_nothing_from_the_working_folder(tmp_path: Path, canary: Path) -> None:
    (tmp_path / "click.py").write_text(f"open({str(canary)!r}, 'w')\n")
    done = subprocess.run(
        [sys.executable, "-m", "chatscene", "--version"], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert not canary.exists()
    assert done.returncode == 0, done.stderr


def test_processes_that_are_started_import_nothing_from_the_working_folder(
    tmp_path: Path, canary: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "pickle.py").write_text(f"open({str(canary)!r}, 'w')\n")
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("PYTHONSAFEPATH", raising=False)
    assert sorted(spread(itemgetter, 0, ["ab", "cd"], workers=Workers(2))) == ["a", "c"]
    assert not canary.exists()
    assert "PYTHONSAFEPATH" not in os.environ


# Evaluations


FOREIGN = """model chatscene.world.model
param OPT_GEO_Y = Range(30, 55)
behavior AdvBehavior():
    do Halt()
egoRoute = selectRoute(maneuver="straight")
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute
AdvAgent = new Pedestrian at besideRoad(egoRoute, globalParameters.OPT_GEO_Y, "right", 1), with behavior AdvBehavior()
"""


class Seen(Exception):  # noqa: N818
    """Raised in the place of a drive."""


def test_an_evaluation_drives_a_strangers_program_in_the_confined_process(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = finished(tmp_path / "run", program=FOREIGN)
    scenario = runs.read_explanation(run)["scenarios"][0]
    assert scenario["base"] is not None
    resealed(run, generator="program", text="", program={"name": scenario["scenario_id"], "source": FOREIGN})
    simulators: list[Simulator] = []

    def drive(_program: ScenicProgram, *_: Any, simulator: Simulator, **__: Any) -> None:
        simulators.append(simulator)
        raise Seen

    monkeypatch.setattr(evaluation, "drive_all", drive)
    with pytest.raises(Seen):
        evaluation.evaluate([run.path], tmp_path / "e", egos=["idm"], progress=silent)
    assert [type(simulator) for simulator in simulators] == [ConfinedSimulator]


def test_only_what_is_packaged_is_run_in_the_process_of_the_command() -> None:
    trusted = {
        name
        for name in GENERATORS.built_in
        if not isinstance(simulator_of(load_generator(name), TOWN, Settings()), ConfinedSimulator)
    }
    assert trusted == set(GENERATORS.built_in) - {"program", "program-as-written"}


# Layers of the second wall


def greeted(monkeypatch: pytest.MonkeyPatch, missing: str, user: int) -> tuple[str, ...]:
    """What a process finds that is confined by all layers but one."""
    ours, theirs = socket.socketpair()
    layers = [layer for layer in LAYERS if layer != missing]
    theirs.sendall(json.dumps({"layers": layers}).encode() + b"\n{}\n")
    monkeypatch.setattr(nurseries.os, "geteuid", lambda: user)
    confined = Confined(Mock(), Limits(), 0, ours)
    with theirs:
        confined.greet(ScenicProgram(scenario_id="x", source="", parameters=(), snippet_ids=()))
    return confined.layers


@pytest.mark.parametrize("missing", ["landlock", "namespaces"])
def test_a_strangers_program_that_lacks_a_layer_runs_with_a_warning(
    missing: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    with pytest.warns(RuntimeWarning, match=f"run without {missing} here"):
        assert missing not in greeted(monkeypatch, missing, user=1000)


def test_root_runs_nothing_of_a_strangers_where_files_stay_open(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(SandboxError, match="no Landlock, and to root every file is open"):
        greeted(monkeypatch, "landlock", user=0)


# Bounds


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bounded, "MOST_BYTES", 1_000_000)


@pytest.mark.usefixtures("small")
@pytest.mark.parametrize("suffix", [".npz", ".zip", ".pt"])
def test_an_ego_that_unpacks_to_too_much_is_one_message(suffix: str, tmp_path: Path) -> None:
    if suffix != ".npz":
        pytest.importorskip("torch", reason="the extra 'train' is not installed")
    path = tmp_path / f"bomb{suffix}"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("model/data.pkl" if suffix == ".pt" else "data", b"0" * 2_000_000)
    assert path.stat().st_size < 10_000
    with pytest.raises(EgoError, match=r"unpack to 2 MB, and at most"):
        load_ego(str(path))


@pytest.mark.parametrize("suffix", [".npz", ".zip", ".pt", ".onnx"])
def test_a_huge_ego_is_not_read(suffix: str, tmp_path: Path) -> None:
    path = tmp_path / f"huge{suffix}"
    with path.open("wb") as file:
        file.truncate(2 * bounded.MOST_BYTES)  # takes no room
    with pytest.raises(EgoError, match=r"has 512 MB, and at most 256 MB"):
        load_ego(str(path))


def test_an_array_that_claims_ten_trillion_numbers_is_one_message(tmp_path: Path) -> None:
    claimed = io.BytesIO()
    np.lib.format.write_array_header_1_0(claimed, {"descr": "<f4", "fortran_order": False, "shape": (10**13,)})
    about = io.BytesIO()
    np.save(about, np.array('{"hidden": "relu", "output": "tanh"}'))
    with zipfile.ZipFile(tmp_path / "huge.npz", "w") as archive:
        for name, content in {"about": about, "w0": claimed, "b0": claimed}.items():
            archive.writestr(f"{name}.npy", content.getvalue())
    with pytest.raises(EgoError, match=r"huge\.npz"):
        load_network(tmp_path / "huge.npz")


def test_a_tensor_that_repeats_one_number_without_end_is_one_message(tmp_path: Path) -> None:
    torch = pytest.importorskip("torch", reason="the extra 'train' is not installed")
    huge = torch.zeros(1).expand(10**12).reshape(10**6, 10**6)
    state = {f"pi.{i}.{kind}": huge for i in (0, 2, 4) for kind in ("weight", "bias")}
    torch.save((state, {}), tmp_path / "huge.pt")
    with pytest.raises(EgoError, match="weights, and at most"):
        load_ego(str(tmp_path / "huge.pt"))


DEEP = "[" * 100_000


def test_a_hundred_thousand_brackets_are_one_message_wherever_json_is_read(tmp_path: Path) -> None:
    run = started(tmp_path / "run")
    run.file("explanation.json").write_text(DEEP)
    with pytest.raises(RunError, match=r"explanation\.json is not valid JSON.*nested too deeply"):
        runs.read_explanation(run)
    run.file("run.json").write_text(DEEP)
    with pytest.raises(RunError, match=r"run\.json is not valid JSON.*nested too deeply"):
        runs.open_run(run.path)
    np.savez(tmp_path / "deep.npz", about=np.array(DEEP))
    with zipfile.ZipFile(tmp_path / "deep.zip", "w") as archive:
        archive.writestr("data", DEEP)
        archive.writestr("policy.pth", "")
    for name in ("deep.npz", "deep.zip"):
        with pytest.raises(EgoError, match="nested too deeply"):
            load_ego(str(tmp_path / name))


def test_a_header_of_a_hundred_thousand_brackets_is_one_message(tmp_path: Path) -> None:
    path = tmp_path / "behavior" / "deep.scenic"
    path.parent.mkdir()
    path.write_text(f"#: description = {DEEP}\n")
    with pytest.raises(SnippetError, match=r"deep\.scenic"):
        load_snippet(path)


# The terminal


def test_brackets_in_a_text_are_shown_and_not_obeyed() -> None:
    scenario, retrieval = understanding("x [/] y")
    scenario = replace(
        scenario, parts=replace(scenario.parts, behavior=f"[/] {CONTROL}"), notes=("[/bold] [red]", CONTROL)
    )
    stream = io.StringIO()
    source = f"# [/] {CONTROL}"
    understood = Mock(scenario=scenario, retrieval=retrieval, program=Mock(source=source))
    print_understanding(Console(file=stream, width=200, force_terminal=False), understood, show_program=True)
    shown = stream.getvalue()
    assert "[/bold] [red]" in shown
    assert "\x1b" not in shown
    assert "\x07" not in shown


def test_what_steers_a_terminal_is_shown_as_its_code() -> None:
    assert visible("ä \x1b[2J\x07\u202e\ud800\n\tend") == "ä \\x1b[2J\\x07\\u202e\\ud800\n\tend"


@pytest.mark.parametrize("command", [["list"], ["search", "a pedestrian"], ["show", "behavior/loud"]])
def test_descriptions_of_a_strangers_library_do_not_steer_the_terminal(command: list[str], tmp_path: Path) -> None:
    text = as_text(load_library().get("behavior/cross"))
    loud = text.replace('description = "', 'description = "A pedestrian [/] \\u001b]0;owned\\u0007', 1)
    (tmp_path / "behavior").mkdir()
    (tmp_path / "behavior" / "loud.scenic").write_text(loud)
    done = CliRunner().invoke(main, ["library", *command, "--library", str(tmp_path)])
    assert done.exit_code == 0, done.output
    assert "\\x1b]0;owned" in done.output
    assert "\x1b" not in done.output


def test_an_error_message_does_not_steer_the_terminal(tmp_path: Path) -> None:
    run = told(finished(tmp_path / "run", count=1), egos=[f"{CONTROL}:x"])
    done = CliRunner().invoke(main, ["resume", str(run.path)])
    assert done.exit_code == 1
    assert "\x1b" not in done.output


# What is swept away


def test_a_new_run_deletes_nothing_of_the_users(tmp_path: Path) -> None:
    names = ("thesis.tmp", ".thesis.tmp", ".run.json.tmp", "run.json.41.tmp")
    for number, name in enumerate(names):
        folder = tmp_path / str(number)
        folder.mkdir()
        (folder / name).write_text("precious")
        with pytest.raises(RunError, match="not empty"):
            started(folder)
        sweep(folder)
        assert (folder / name).read_text() == "precious"


# Files that are none


@pytest.mark.parametrize("name", ["parts", "episodes", "programs", "tables"])
def test_a_link_in_a_run_folder_is_not_followed(name: str, tmp_path: Path) -> None:
    theirs = tmp_path / "theirs"
    theirs.mkdir()
    thesis = theirs / "thesis.json"
    thesis.write_text("mine")
    run = started(tmp_path / "run")
    if run.file(name).is_dir():
        run.file(name).rename(tmp_path / "moved")
    run.file(name).symlink_to(theirs)
    with pytest.raises(RunError, match=f"{name} is a link"):
        pipeline.resume(run.path)
    runs.update(run, status=runs.Status.REFUSED)
    with pytest.raises(RunError, match=f"{name} is a link"):
        runs.create(run.path, asked())
    assert [*theirs.iterdir()] == [thesis]


def test_a_pipe_in_place_of_a_file_is_one_message(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=1)
    (program,) = run.file("programs").glob("*.scenic")
    program.unlink()
    os.mkfifo(program)
    with pytest.raises(RunError, match="it is no file but a pipe or a device"):
        runs.read_programs(run)
