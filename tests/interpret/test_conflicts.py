"""Reports: the conflicts that they tell are found, what leads to one is read with it, and the rest is listed."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

import chatscene
from chatscene.commands.main import main
from chatscene.errors import NothingFits, SettingsError
from chatscene.interpret.conflicts import MOST_BYTES, conflicts_in
from chatscene.read.reader import LONGEST
from chatscene.runs import asked_run
from chatscene.terms.conflict import Conflict

LOG = """INCIDENT LOG, Riverside depot

1. The car behind us followed far too close while we waited at a red light,
   and then hit us in the rear.

2. The vehicle was washed and the tyres were checked.

3. A pedestrian stepped out from behind a parked truck on the right.

Signed: P. Miller
"""
CLAIM = """Dear Sir or Madam,

I was driving along Station Road, about to turn left.

An oncoming motorcycle went straight on and hit my front right wing.

Nobody was hurt. The wing is dented.
"""


def found(text: str) -> tuple[Conflict, ...]:
    return conflicts_in(text)


def command(*arguments: str) -> Result:
    return CliRunner().invoke(main, arguments, catch_exceptions=False)


def test_several_conflicts_are_several_texts_and_the_rest_is_left_out() -> None:
    first, second = found(LOG)
    assert first.text.startswith("The car behind us followed far too close")
    assert first.text.endswith("hit us in the rear.")
    assert second.text == "A pedestrian stepped out from behind a parked truck on the right."
    assert (second.number, second.of) == (2, 2)
    assert first.left_out == second.left_out
    assert [passage.split()[0] for passage in first.left_out] == ["INCIDENT", "The", "Signed:"]


def test_how_the_ego_drives_is_read_with_the_conflict_that_it_leads_to() -> None:
    (one,) = found(CLAIM)
    assert one.text.startswith("I was driving along Station Road")
    assert one.text.endswith("front right wing.")
    assert one.left_out == ("Dear Sir or Madam,", "Nobody was hurt. The wing is dented.")


def test_how_the_ego_drove_is_read_with_the_last_conflict_if_it_is_told_behind() -> None:
    (one,) = found("A cyclist crosses from the left.\n\nWe were turning right at the junction.")
    assert one.text == "A cyclist crosses from the left. We were turning right at the junction."


def test_a_report_is_as_long_as_it_likes() -> None:
    chatter = "The committee met again and approved the minutes of the previous meeting. "
    (one,) = found(chatter * 60 + "\n\nThe car ahead of us brakes hard.\n\n" + chatter * 3)
    assert one.text == "The car ahead of us brakes hard."
    assert all(len(passage) <= LONGEST for passage in one.left_out)
    assert sum(passage.count("committee") for passage in one.left_out) == 63


def test_a_sentence_of_foreign_names_refuses_no_report() -> None:
    (one,) = found("Los Angeles, La Brea. A cyclist crossed from the left in front of us.")
    assert one.text == "A cyclist crossed from the left in front of us."
    with pytest.raises(NothingFits, match="not look like English"):
        found("Der Radfahrer kam von rechts. Wir fuhren auf der Straße und konnten nicht bremsen.")


def test_a_report_without_a_conflict_is_refused() -> None:
    with pytest.raises(NothingFits, match="no conflict was found in the text: nothing in it"):
        found("Preheat the oven.\n\nWhisk the eggs with sugar.")


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "is empty"),
        (b" \n\t\n", "is empty"),
        (b"\xff\xfe\x00r\x80", "is not UTF-8 text"),
        (b"PK\x03\x04\x00\x00", "is not text"),
        (b"a " * MOST_BYTES, "has 2.0 MB, and at most 1 MB are read"),
        (None, "cannot be read: No such file"),
    ],
)
def test_a_file_that_is_no_report_is_an_error_that_says_why(content: bytes | None, said: str, tmp_path: Path) -> None:
    path = tmp_path / "report.txt"
    if content is not None:
        path.write_bytes(content)
    answer = command("explain", "--report", str(path))
    assert answer.exit_code == 1
    assert said in answer.stderr


def test_explain_shows_every_conflict_and_what_was_left_out(tmp_path: Path) -> None:
    path = tmp_path / "log.txt"
    path.write_text(LOG, encoding="utf-8")
    told = json.loads(command("explain", "--report", str(path), "--json").stdout)
    assert [one["situation"]["about"][:3] for one in told["conflicts"]] == ["The", "A p"]
    assert told["left_out"][-1] == "Signed: P. Miller"
    answer = command("explain", "--report", str(path))
    assert "log.txt has 2 conflicts" in answer.stderr
    assert "left out: Signed: P. Miller" in answer.stderr


def test_a_reading_is_chosen_for_one_conflict_at_a_time(tmp_path: Path) -> None:
    path = tmp_path / "log.txt"
    path.write_text(LOG, encoding="utf-8")
    answer = command("run", "--report", str(path), "--set", "side=left")
    assert answer.exit_code == 2
    assert "--reading and --set need one" in answer.stderr


def test_a_run_keeps_from_which_report_it_is_and_what_was_left_out() -> None:
    _, second = found(LOG)
    record = asked_run(second, ego="idm")
    assert record.text == second.text
    assert record.report is not None
    assert (record.report.number, record.report.of) == (2, 2)
    assert record.report.left_out == list(second.left_out)


def test_python_reads_a_report_of_one_conflict_and_names_what_takes_several(tmp_path: Path) -> None:
    path = tmp_path / "claim.txt"
    path.write_text("Dear all,\n\nthe car ahead of us brakes hard.\n", encoding="utf-8")
    assert chatscene.explain(report=path).situation.about == "the car ahead of us brakes hard."
    path.write_text(LOG, encoding="utf-8")
    with pytest.raises(SettingsError, match=r"has 2 conflicts; run them one by one: \[chatscene.run\(one\) for one"):
        chatscene.run(report=path)
    assert len(chatscene.conflicts(path)) == 2
