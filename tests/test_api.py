"""The package's own face: its names, its nouns, and that it says what the command line says."""

from __future__ import annotations

import html
import importlib.util
import inspect
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any
from unittest.mock import Mock

import click
import numpy as np
import pytest

import chatscene
import chatscene as api
from chatscene.commands.main import main
from chatscene.errors import ChatSceneError, NothingFits, RunError, SettingsError
from chatscene.report.viewer import write_report
from chatscene.settings import SearchSettings
from chatscene.studies.evaluation import Evaluated
from fake_run import SCENARIO, finished, started
from plainly import UNREAD

BRAKES = UNREAD


@pytest.fixture(scope="module")
def by_hand(tmp_path_factory: pytest.TempPathFactory) -> chatscene.Run:
    run = finished(tmp_path_factory.mktemp("runs") / "by hand", count=2)
    write_report(run.path)
    return chatscene.Run(run.path)


@pytest.fixture(scope="module")
def simulated() -> chatscene.Run:
    return chatscene.run(BRAKES, scenes=3, ego="rule-based", seed=1)


def source_of(frame: str) -> str:
    """The page in a frame."""
    (page,) = re.findall(r'srcdoc="([^"]*)"', frame)
    return html.unescape(page)


@pytest.mark.parametrize("name", chatscene.__all__)
def test_every_public_name_is_there_and_none_is_a_module(name: str) -> None:
    assert getattr(chatscene, name)
    assert name in dir(chatscene)
    # A module of that name would take its place as soon as somebody imports it.
    assert importlib.util.find_spec(f"chatscene.{name}") is None


def test_to_import_the_package_keeps_onnxruntime_from_reporting_unless_the_user_says_otherwise(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    said = "import os, chatscene; print(os.environ['ORT_DISABLE_TELEMETRY'])"
    monkeypatch.delenv("ORT_DISABLE_TELEMETRY", raising=False)
    for own, told in ((None, "1"), ("0", "0")):
        if own is not None:
            monkeypatch.setenv("ORT_DISABLE_TELEMETRY", own)
        done = subprocess.run([sys.executable, "-c", said], capture_output=True, text=True, check=True)
        assert done.stdout.strip() == told


def test_to_import_the_package_loads_nothing_of_it_but_what_stands_in_for_parts_of_scenic() -> None:
    loaded = "import chatscene, sys; print(*(m for m in sys.modules if m.startswith(('chatscene', 'numpy'))))"
    told = subprocess.run([sys.executable, "-c", loaded], capture_output=True, text=True, check=True)
    assert set(told.stdout.split()) == {"chatscene", "chatscene.plane"}


def test_a_name_that_is_not_there_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="no attribute 'simulate_all'"):
        chatscene.simulate_all  # type: ignore[attr-defined]  # noqa: B018


def test_the_package_says_that_it_is_typed() -> None:
    assert (Path(chatscene.__file__).parent / "py.typed").is_file()


# The words that differ: where the command prints or names a folder, a function takes a place or gives a noun.
WORDS: dict[str, dict[str, str]] = {
    "run": {"out": "folder", "map_name": "map"},
    "explain": {},
    "describe": {"count": "n"},
    "resume": {},
    "replay": {},
    "why": {},
    "verify": {},
    "rate": {"what": "folder"},
    "evaluate": {"out": "folder"},
    "export": {},
    "import_scenario": {"map_name": "map"},
    "finetune": {"out": "folder", "sources": "scenes"},
    "train": {"out": "folder", "map_name": "map", "round_": "round"},
}
TOP = click.Context(main)
COMMANDS: dict[str, tuple[click.Command, dict[str, str]]] = {
    verb: (command, words)
    for verb, words in WORDS.items()
    if (command := main.get_command(TOP, verb.removesuffix("_scenario"))) is not None
}


@pytest.mark.parametrize("verb", COMMANDS)
def test_a_function_takes_what_its_command_takes(verb: str) -> None:
    command, words = COMMANDS[verb]
    options = {words.get(str(option.name), str(option.name)) for option in command.params}
    taken = set(inspect.signature(getattr(api, verb)).parameters)
    assert taken - {"settings", "progress", "within"} == options - {"as_json", "show_program"}


@pytest.mark.parametrize("verb", COMMANDS)
def test_the_values_that_a_docstring_and_a_help_quote_are_choices_of_the_option(verb: str) -> None:
    command, words = COMMANDS[verb]
    told = inspect.getdoc(getattr(api, verb)) or ""
    for option in command.params:
        if not isinstance(option, click.Option) or not isinstance(option.type, click.Choice):
            continue
        choices, name = {str(choice) for choice in option.type.choices}, words.get(str(option.name), option.name)
        (entry,) = re.findall(rf"^    {name}: (.*(?:\n     .*)*)", told, re.MULTILINE)
        quoted = set(re.findall(r"``([\w-]+)``", entry))
        assert quoted <= choices, f"{verb}, {name}: its docstring quotes {quoted - choices}; choices are {choices}"
        named = {one for one in choices if re.search(rf"\b{one}\b", option.help or "")}
        assert named in (set(), choices), f"{option.opts[0]}: its help names {named} of {choices}"


class Asked(Exception):  # noqa: N818
    """Stands for the work; holds what was asked for."""


@pytest.mark.parametrize(
    ("verb", "work", "places"),
    [
        ("run", "chatscene.pipeline.run", (BRAKES, "x")),
        ("describe", "chatscene.sentences.describe_with_model.describe_for", ()),
        ("finetune", "chatscene.learn.finetune.finetune", ("scenes", "x")),
        ("train", "chatscene.learn.train.train", ("x",)),
    ],
)
def test_what_is_not_said_is_what_the_command_takes_for_it(
    verb: str, work: str, places: tuple[str, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    command, words = COMMANDS[verb]
    defaults = {
        words.get(str(option.name), str(option.name)): option.get_default(click.Context(command))
        for option in command.params
        if isinstance(option, click.Option) and not option.required
    }
    taken = set(inspect.signature(getattr(api, verb)).parameters) - {"folder", "jobs"}

    def ask(*arguments: object, **named: object) -> None:
        raise Asked(arguments, named)

    def asked(**said: object) -> object:
        with pytest.raises(Asked) as found:
            getattr(api, verb)(*places, **said)
        return found.value.args

    monkeypatch.setattr(work, ask)
    said = {name: value for name, value in defaults.items() if name in taken and value is not None}
    assert "seed" in said
    assert asked() == asked(**said)


def test_a_run_without_a_folder_has_one_that_stays(simulated: chatscene.Run) -> None:
    assert simulated.folder.is_dir()
    assert simulated.report.is_file()
    assert simulated.scenes.num_rows == 3
    assert "3 scenes" in repr(simulated)
    first, summary, _ = str(simulated).partition("3 scenes in")
    assert summary
    assert first.splitlines() == simulated.told_first
    assert "not read: 'xylophone'" in simulated.told_first
    assert str(simulated).endswith(f"report: {simulated.report}")


def test_a_scene_of_a_run_is_simulated_again_bit_for_bit(simulated: chatscene.Run) -> None:
    assert simulated.best.replay().identical
    assert chatscene.replay(str(simulated.folder), simulated.best.id).identical


def test_a_scene_goes_on_with_another_ego_from_a_moment_on(simulated: chatscene.Run) -> None:
    whole, came = simulated.best.episode, simulated.best.branch(at=1.0, ego="idm")
    assert came.ego.startswith(f"{whole.ego}, then ")
    assert np.array_equal(came.ego_track.speed[:11], whole.ego_track.speed[:11])
    with pytest.raises(SettingsError, match="from the beginning of the scene, 0"):
        simulated.best.branch(at=-0.1, ego="idm")


def test_a_scene_is_an_environment_that_begins_as_it_did(simulated: chatscene.Run) -> None:
    pytest.importorskip("gymnasium", reason="the extra 'gym' is not installed")
    scene, ego = simulated.best, chatscene.load_ego("rule-based")
    env = scene.env(ego_observation="safebench")
    seen, _ = env.reset()
    for _ in range(len(scene.episode.ego_track.x) - 1):
        seen, *_ = env.step(np.asarray(ego.act(seen.astype(float)), np.float32))
    again = env.episode("rule-based")
    env.close()
    # The environment hands on single precision, so that the last bits of what the ego does are others.
    for track, twin in zip(scene.episode.tracks, again.tracks, strict=True):
        assert (track.actor, track.kind) == (twin.actor, twin.kind)
        assert twin.x == pytest.approx(track.x, abs=1e-3)


def test_a_finished_run_goes_on_to_what_it_is(simulated: chatscene.Run) -> None:
    again = chatscene.resume(str(simulated.folder))
    assert isinstance(again, chatscene.Run)
    assert again.scenes == simulated.scenes


def test_a_run_that_was_gone_on_with_knows_what_was_named_again(simulated: chatscene.Run) -> None:
    again = chatscene.resume(simulated.folder, embedder="minilm")
    assert isinstance(again, chatscene.Run)
    assert again.repeated.embedder == ("minilm",)


def test_egos_are_measured_on_the_kept_scenes(simulated: chatscene.Run, tmp_path: Path) -> None:
    evaluated = chatscene.evaluate(simulated, tmp_path / "e", ego="idm")
    assert "avoidability" in evaluated.tables
    again = chatscene.resume(tmp_path / "e")
    assert isinstance(again, Evaluated)
    assert again.tables == evaluated.tables


def test_a_run_shows_the_best_scenes_first(by_hand: chatscene.Run) -> None:
    kept = by_hand.kept
    assert kept[0].id == by_hand.best.id
    assert {scene.id for scene in kept} == {row["scene_id"] for row in by_hand.scenes.to_pylist() if row["selected"]}
    assert by_hand.scene(by_hand.best.id).row == by_hand.best.row


def test_a_scene_has_its_program_its_values_and_its_tracks(by_hand: chatscene.Run) -> None:
    scene = by_hand.best
    assert "behavior AdvBehavior" in scene.program
    assert set(scene.values) == {"OPT_ADV_SPEED", "OPT_ADV_DISTANCE", "OPT_GEO_Y"}
    assert scene.tracks.num_rows == sum(len(track.x) for track in scene.episode.tracks)
    assert set(scene.tracks.column("scene_id").to_pylist()) == {scene.id}
    assert scene.id in repr(scene)
    assert "kept" in repr(scene)


def test_a_scene_that_was_not_driven_cannot_be_had(by_hand: chatscene.Run) -> None:
    for scene_id in (f"{SCENARIO}/route-00/scene-000.1", "nothing"):
        with pytest.raises(RunError, match="no scene"):
            by_hand.scene(scene_id)


def test_a_printed_run_says_which_words_were_not_read(simulated: chatscene.Run, by_hand: chatscene.Run) -> None:
    assert "not read: 'xylophone'" in str(simulated).splitlines()
    assert "not read" not in str(by_hand)


def test_a_folder_that_is_no_finished_run_is_refused(tmp_path: Path) -> None:
    started(tmp_path / "cut")
    with pytest.raises(RunError, match="was interrupted; continue with: chatscene resume"):
        chatscene.Run(tmp_path / "cut")
    with pytest.raises(RunError, match="not a run folder"):
        chatscene.Run(tmp_path)


def test_a_notebook_shows_the_report_in_a_frame_that_reaches_nothing(by_hand: chatscene.Run) -> None:
    frame = by_hand._repr_html_()  # pyright: ignore[reportPrivateUsage]
    assert frame.startswith('<iframe sandbox="allow-scripts" srcdoc="')
    assert source_of(frame) == by_hand.report.read_text(encoding="utf-8")
    assert frame.count("<") == 2  # the frame's own: all of the page is quoted


def test_a_notebook_shows_a_scene_as_a_picture_of_its_own(by_hand: chatscene.Run) -> None:
    shown = by_hand.best._repr_html_()  # pyright: ignore[reportPrivateUsage]
    assert shown.startswith('<img src="data:image/gif;base64,R0lGOD')


def test_a_reading_is_text_and_a_page() -> None:
    understood = chatscene.explain("A <b>cyclist</b> rides out from the left & stops in front of us.")
    assert "bicycle" in str(understood)
    assert "model chatscene.world.model" in understood.program.source
    frame = understood._repr_html_()  # pyright: ignore[reportPrivateUsage]
    page = source_of(frame)
    assert frame.count("<") == 2
    assert "A &lt;b&gt;cyclist&lt;/b&gt; rides out" in page
    assert "<b>cyclist" not in page
    assert "default-src 'none'" in html.unescape(page)


def test_a_refusal_is_the_error_of_the_command() -> None:
    with pytest.raises(NothingFits, match=r"\S"):
        chatscene.explain("a dragon lands on the bonnet")


def test_made_up_sentences_can_be_served() -> None:
    (one, other) = chatscene.describe(2, base="right-turn")
    assert one.text != other.text
    assert chatscene.explain(one.text).scenario.base == "right-turn"


def test_a_sentence_and_a_program_are_not_run_at_once(tmp_path: Path) -> None:
    with pytest.raises(SettingsError, match="only one of them"):
        chatscene.run(BRAKES, tmp_path / "x", program="mine.scenic")


def test_a_folder_of_programs_is_not_one_program(tmp_path: Path) -> None:
    source = chatscene.explain(BRAKES).program.source
    for name in ("one", "two"):
        (tmp_path / f"{name}.scenic").write_text(source)
    with pytest.raises(SettingsError, match="holds 2 programs"):
        chatscene.run(program=tmp_path)


_NAMING: dict[str, Callable[[str], object]] = {
    "folder": lambda name: chatscene.run("a car ahead brakes hard", name),
    "program": lambda name: chatscene.run(program=name),
    "library": lambda name: chatscene.run("a car ahead brakes hard", library=name),
    "replay": lambda name: chatscene.replay(name, "one"),
    "sql": lambda name: chatscene.sql("SELECT 1", name),
    "import": chatscene.import_scenario,
}


@pytest.mark.parametrize("call", _NAMING.values(), ids=_NAMING)
def test_a_name_with_a_nul_is_no_path(call: Callable[[str], object]) -> None:
    with pytest.raises(ChatSceneError, match="is not a path: it holds a NUL character"):
        call("run\0s")


def test_a_run_of_an_ego_of_ones_own_is_judged_and_told_without_loading_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "theirs.py").write_text("from chatscene.ego.rule_based import RuleBased\nmake = RuleBased\n")
    monkeypatch.syspath_prepend(str(tmp_path))
    done = chatscene.run("the car ahead brakes hard", tmp_path / "run", ego="theirs:make", scenes=1, routes=1)
    assert done.repeated.ego == ("theirs:make",)
    monkeypatch.setattr("chatscene.ego.policy.load_ego", Mock(side_effect=AssertionError("it drove already")))
    for what in (done, done.folder):
        assert chatscene.verify(what).facts
        assert chatscene.story(what).told
    with pytest.raises(SettingsError, match="driven already"):
        chatscene.verify(done, ego="idm")


@pytest.mark.parametrize("command", ["replay", "rate"])
def test_what_takes_a_folder_takes_its_run(command: str, simulated: chatscene.Run) -> None:
    options: dict[str, Any] = {"scenes": 0} if command == "rate" else {}
    assert getattr(chatscene, command)(simulated, **options) == getattr(chatscene, command)(simulated.folder, **options)


def test_a_run_knows_who_searched_and_read_so_that_it_can_be_edited(simulated: chatscene.Run) -> None:
    assert simulated.repeated.sampler == ("quality-diversity",)
    assert simulated.understood


@pytest.mark.parametrize("option", ["library", "language_model", "reader"])
def test_how_a_text_is_read_is_refused_beside_a_situation(option: str, tmp_path: Path) -> None:
    said = chatscene.explain(BRAKES).situation
    value: Any = {"library": str(tmp_path), "language_model": "gguf:none", "reader": "paper"}[option]
    verbs: tuple[Callable[..., Any], ...] = (chatscene.explain, chatscene.run)
    for verb in verbs:
        with pytest.raises(SettingsError, match=f"`{option}` is for reading a text"):
            verb(said, **{option: value})


def test_bad_arguments_are_errors_of_ours(simulated: chatscene.Run) -> None:
    with pytest.raises(SettingsError, match="n is -1"):
        chatscene.describe(-1)
    with pytest.raises(SettingsError, match="foo"):
        chatscene.describe(1, base="foo")
    with pytest.raises(SettingsError, match="-5"):
        chatscene.rate(simulated, scenes=-5)
    with pytest.raises(SettingsError, match="within"):
        chatscene.run(BRAKES, within="x")


@pytest.mark.parametrize("speed", [0, -5, float("nan"), 5000, "fast", True])
def test_a_speed_that_no_command_takes_is_refused_by_functions_too(speed: Any) -> None:
    with pytest.raises(SettingsError, match=r"speed must be a number from 1\.0 to 300\.0"):
        chatscene.evaluate("nowhere", ego="idm", speed=speed)


@pytest.mark.parametrize("seed", [-1, 1.5, True, 2**63])
def test_a_seed_is_a_whole_number(seed: Any) -> None:
    with pytest.raises(SettingsError, match="seed must be a whole number from 0 to"):
        chatscene.rate("nowhere", scenes=5, seed=seed)
    with pytest.raises(SettingsError, match="seed must be a whole number from 0 to"):
        SearchSettings(seed=seed)
    with pytest.raises(SettingsError, match="scenes must be a whole number"):
        chatscene.rate("nowhere", scenes=1.5)  # type: ignore[arg-type] # pyright: ignore[reportArgumentType]


def test_a_whole_number_of_numpy_is_one() -> None:
    seed = SearchSettings(seed=np.int64(3)).seed  # type: ignore[arg-type] # pyright: ignore[reportArgumentType]
    assert (seed, type(seed)) == (3, int)


def test_an_ego_that_is_an_object_is_refused_where_a_name_is_taken() -> None:
    ego: Any = SimpleNamespace(act=None)
    with pytest.raises(SettingsError, match=r"is no name: give a name, a file or package\.module:factory"):
        chatscene.evaluate("nowhere", ego=ego)
    with pytest.raises(SettingsError, match="is no name"):
        chatscene.run("the car ahead brakes hard", scenes=1, ego=ego)
    with pytest.raises(SettingsError, match="is not a path"):
        chatscene.evaluate(ego)
