"""An ego that was said to stand: from the sentence to a crash that it could not have avoided."""

from pathlib import Path

import pytest
from click.testing import CliRunner

from chatscene.commands.main import main
from chatscene.runs import open_run, read_episode, read_events, read_explanation, read_scenes
from chatscene.runs.rebuild import rebuild
from chatscene.runs.replay import replay
from chatscene.terms.episode import Role
from chatscene.terms.scenario import EgoState

SENTENCE = "While we wait at a red light, a car drives into us from behind."


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    at = tmp_path_factory.mktemp("waiting") / "run"
    done = CliRunner().invoke(main, ["run", SENTENCE, "--ego", "rule-based", "--scenes", "3", "--out", str(at)])
    assert done.exit_code == 0, done.output
    return at


def test_an_ego_that_waits_at_a_red_light_is_struck_from_behind(folder: Path) -> None:
    run = open_run(folder)
    rows, events = read_scenes(run), read_events(run)
    assert all(row["meaning_ok"] and row["collision"] for row in rows)
    assert {row["fault"] for row in rows} == {"adversary-into-ego"}
    assert {event["side"] for event in events} == {"rear"}
    assert [row["avoidable"] for row in rows] == [False] * 3


def test_it_stands_before_its_line_and_its_light_is_red(folder: Path) -> None:
    run = open_run(folder)
    scene = read_scenes(run)[0]["scene_id"]
    episode = read_episode(run, scene)
    assert episode.ego_track.speed.max() == 0.0
    light = next(signal for signal in episode.signals if signal.role == Role.EGO)
    assert set(light.state) == {"r"}
    middle = ((light.x0 + light.x1) / 2, (light.y0 + light.y1) / 2)
    away = ((middle[0] - episode.ego_track.x[0]) ** 2 + (middle[1] - episode.ego_track.y[0]) ** 2) ** 0.5
    assert episode.ego_track.length / 2 < away < 5.0


def test_the_orders_are_explained_and_kept(folder: Path) -> None:
    run = open_run(folder)
    told = read_explanation(run)["scenarios"][0]
    assert told["slots"]["ego"] == "stands"
    assert "We stand still." in told["told"]
    assert next(word["fact"] for word in told["words"] if word["text"] == "wait").startswith("ego.does")
    assert "We stand still." in (folder / "report.html").read_text(encoding="utf-8")
    made = rebuild(run)
    scenario, program = made.scenario, made.program
    assert scenario.slots.ego is EgoState.STANDS
    assert "with orders (Order(at_most=0),)" in program.source


def test_a_replay_holds_the_ego_to_its_orders(folder: Path) -> None:
    assert replay(folder, read_scenes(open_run(folder))[0]["scene_id"]).identical
