"""Two road users who both do something: the situation has both, and an older run is held against both."""

from __future__ import annotations

import tarfile
from dataclasses import replace
from pathlib import Path

from click.testing import CliRunner

from chatscene import runs
from chatscene.commands.main import main
from chatscene.program.meaning import check_meaning
from chatscene.runs.rebuild import rebuild, remade
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.episode import OTHER, Role
from chatscene.terms.scenario import Position, Slots
from places import FIXTURES

TWO = "A pedestrian crosses the road from the right while an oncoming truck drives straight on."


def test_the_other_is_told_in_words(tmp_path: Path) -> None:
    told = " ".join(CliRunner().invoke(main, ["explain", TWO]).output.split())
    assert "A truck is coming the other way. It is not the danger. It goes straight on." in told
    assert "(others.B.kind: an oncoming truck)" in told
    assert "no words of the text say" not in told
    run = CliRunner().invoke(main, ["run", TWO, "--out", str(tmp_path / "run"), "--routes", "1", "--scenes", "4"])
    assert run.exit_code == 0, run.output
    assert "adversary truck" in (tmp_path / "run" / "report.html").read_text()


def test_what_the_other_of_an_older_run_does_not_do_is_a_failure(tmp_path: Path) -> None:
    with tarfile.open(FIXTURES / "folders-with-composed.tar.xz") as archive:
        archive.extractall(tmp_path, filter="data")
    run = runs.open_run(tmp_path / "beside", runs.RunRecord)
    slots, again = rebuild(run).scenario.slots, remade(run)
    route = again.simulator.route(again.program, 0)
    episodes = [runs.read_episode(run, row["scene_id"]) for row in runs.read_scenes(run)]
    assert {track.role for one in episodes for track in one.tracks if track.actor == OTHER} == {Role.BACKGROUND}
    shown = next(one for one in episodes if not check_meaning(slots, one, route))
    turns = Slots(adversary=AdversaryKind.CAR, actions=(Action.U_TURN,), position=Position.AHEAD)
    assert "said u-turn, but the car" in check_meaning(Slots(others=(turns,)), shown, route)[0]
    alone = replace(shown, tracks=tuple(track for track in shown.tracks if track.actor != OTHER))
    assert "there is no car" in check_meaning(Slots(others=(turns,)), alone, route)[0]
