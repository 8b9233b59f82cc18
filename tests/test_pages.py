"""Whoever follows a page for users from its top to its end gets what it says: every command is run, or says why not."""

from __future__ import annotations

import re
import shlex
import shutil
import subprocess
from pathlib import Path

import click
import pytest
from click.testing import CliRunner

from chatscene.commands.main import main
from pages import Step, Written, check_options, steps_of
from places import ROOT

PAGES = sorted([*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md")])
USERS = [page for page in PAGES if page.name != "CHANGELOG.md" and not {"decisions", "lab"} & set(page.parts)]
MADE_BEFORE = {  # what pages take for there, as those before them made it
    "runs/left": "an oncoming car turns left across our path at a traffic light",
    "runs/cyclist": "A cyclist crosses from the left in front of us.",
}
ANYWHERE = ("chatscene doctor", "chatscene map check town", "chatscene schema", "chatscene coverage")


def named(page: Path) -> str:
    return str(page.relative_to(ROOT))


class Shell:
    """Says commands in a folder; a run that was made in another one is copied from there.

    What no folder has a part in is said once.
    """

    def __init__(self, kept: Path) -> None:
        self._kept = kept
        self._runs: dict[str, tuple[Path, str]] = {}
        self._told: dict[str, tuple[int, str]] = {}

    def say(self, command: str) -> tuple[int, str]:
        """The status and all that is printed."""
        if command in self._told:
            return self._told[command]
        before, _, own = command.rpartition(" | ")
        if not own.startswith("chatscene "):
            done = subprocess.run(["bash", "-c", command], capture_output=True, text=True, check=False)
            return done.returncode, done.stdout + done.stderr
        given = subprocess.run(["bash", "-c", before], capture_output=True, text=True, check=True).stdout
        words = shlex.split(own)[1:]
        out = Path(words[words.index("--out") + 1]) if words[0] == "run" and "--out" in words else None
        if out and command in self._runs:
            folder, told = self._runs[command]
            shutil.copytree(folder, out)
            return 0, told
        done = CliRunner().invoke(main, words, input=given, catch_exceptions=False)
        if out and done.exit_code == 0 and out.is_dir():
            self._runs[command] = (self._kept / str(len(self._runs)), done.output)
            shutil.copytree(out, self._runs[command][0])
        if command in ANYWHERE:
            self._told[command] = done.exit_code, done.output
        return done.exit_code, done.output


@pytest.fixture(scope="session")
def shell(tmp_path_factory: pytest.TempPathFactory) -> Shell:
    return Shell(tmp_path_factory.mktemp("kept"))


@pytest.mark.parametrize(
    "page", [page for page in USERS if any(isinstance(s, Step) for s in steps_of(page))], ids=named
)
def test_every_command_of_a_page_does_what_it_says_or_says_why_it_is_not_run(
    page: Path, shell: Shell, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)

    def interrupted(_: object) -> None:  # else it serves for ever
        raise KeyboardInterrupt

    monkeypatch.setattr("chatscene.view.server.Server.serve_forever", interrupted)
    monkeypatch.setattr("webbrowser.open", bool)  # else it opens a browser
    steps = steps_of(page)
    made = {said for step in steps if isinstance(step, Step) for said in re.findall(r"--out (\S+)", step.command)}
    for step in steps:
        if isinstance(step, Written):
            Path(step.name).parent.mkdir(parents=True, exist_ok=True)
            Path(step.name).write_text(step.content, encoding="utf-8")
        elif step.not_run:
            check_unrun(step.command)
        else:
            for folder, text in MADE_BEFORE.items():
                if re.search(rf"\b{folder}\b", step.command) and folder not in made:
                    made.add(folder)
                    assert shell.say(f'chatscene run "{text}" --scenes 10 --routes 1 --out {folder}')[0] == 0
            status, told = shell.say(step.command)
            assert status == step.status, f"{step.command}\n{told}"
            plain = " ".join(told.split())
            for line in step.said:
                assert " ".join(line.split()) in plain, f"{step.command}\n{told}"


def check_unrun(command: str) -> None:
    """What can be known of a command without running it: its options, or that what it runs is there."""
    words = command.split()
    if words[0] == "chatscene":
        check_options(command)
    elif words[0] == "make":
        assert f"\n{words[1]}:" in (ROOT / "Makefile").read_text()
    elif words[0] == "python" and words[1] != "-m":
        assert (ROOT / words[1]).exists(), command


def test_an_option_that_there_is_not_is_noticed_though_its_command_is_not_run() -> None:
    check_options("chatscene train --algorithm sac --out egos/sac")
    for wrong in ("chatscene train --algorithms sac", "chatscene trains", "chatscene map chek town"):
        with pytest.raises(click.UsageError):
            check_options(wrong)
