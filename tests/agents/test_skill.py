"""The skill is installed by one command, and says only what there is."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import click
import pytest
import yaml
from click.testing import CliRunner

from chatscene.commands.main import main
from chatscene.mcp.tools import TOOLS
from chatscene.situations.file import read_text
from pages import check_options
from places import ROOT

SKILL = ROOT / "skills" / "chatscene"
PAGES = sorted(SKILL.rglob("*.md"))


def test_one_command_installs_it_and_another_replaces_it(tmp_path: Path) -> None:
    done = CliRunner().invoke(main, ["skill", str(tmp_path)])
    assert done.exit_code == 0, done.output
    made = {path.relative_to(tmp_path / "chatscene"): path.read_bytes() for path in tmp_path.rglob("*.md")}
    assert made == {path.relative_to(SKILL): path.read_bytes() for path in PAGES}
    again = CliRunner().invoke(main, ["skill", str(tmp_path)])
    assert again.exit_code == 1
    assert "--replace" in again.output
    assert CliRunner().invoke(main, ["skill", str(tmp_path), "--replace"]).exit_code == 0


def test_it_names_itself_and_every_tool() -> None:
    _, head, text = (SKILL / "SKILL.md").read_text().split("---\n", 2)
    said = yaml.safe_load(head)
    assert said["name"] == "chatscene"
    assert 50 < len(said["description"]) < 1024
    assert all(re.search(rf"`{name}`|`{name}\b", text) for name in TOOLS)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_its_links_lead_somewhere_and_its_commands_exist(page: Path) -> None:
    text = page.read_text()
    assert all((page.parent / target).exists() for target in re.findall(r"\]\(([^)#]+)\)", text))
    for command in re.findall(r"`(chatscene [^`]+)`", text):
        words = [word if word.isupper() is False else "x" for word in shlex.split(command)]
        try:
            check_options(shlex.join(words))
        except click.BadParameter as error:
            assert "does not exist" in error.message, command


def test_its_situation_is_one(tmp_path: Path) -> None:
    (block,) = re.findall(r"```yaml\n(.*?)```", (SKILL / "references" / "situation.md").read_text(), re.DOTALL)
    (tmp_path / "one.yaml").write_text(block)
    assert read_text(block).others[0].kind == "bicycle"
    built = CliRunner().invoke(main, ["explain", str(tmp_path / "one.yaml")])
    assert built.exit_code == 0, built.output
