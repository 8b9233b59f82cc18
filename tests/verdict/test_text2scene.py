"""The benchmark of scenes from texts: its tasks are whole, and its scorer tells right from wrong."""

from __future__ import annotations

import importlib
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result

HERE = Path(__file__).parents[2] / "benchmarks" / "text2scene"
AHEAD: dict[str, Any] = {
    "version": 1,
    "others": [{"id": "A", "kind": "car", "starts": {"where": "ahead"}, "does": [{"act": "brake"}]}],
}


@pytest.fixture
def bench(monkeypatch: pytest.MonkeyPatch) -> dict[str, Any]:
    """The programs of the benchmark, by name."""
    monkeypatch.syspath_prepend(str(HERE))
    return {name: importlib.import_module(name) for name in ("tasks", "score")}


def rows() -> list[dict[str, Any]]:
    return [json.loads(line) for line in (HERE / "tasks.jsonl").read_text(encoding="utf-8").splitlines()]


def a_task(name: str) -> dict[str, Any]:
    return {
        "id": name,
        "split": "made",
        "voice": "tester",
        "by": "person",
        "licence": "Apache-2.0",
        "readers": 1,
        "at": {"file": "none", "row": 0},
        "sha256": "",
        "situation": AHEAD,
    }


def test_there_are_five_hundred_tasks_of_ten_voices() -> None:
    found = rows()

    assert len(found) >= 500
    assert len({row["id"] for row in found}) == len(found)
    assert len({row["voice"] for row in found}) >= 10
    assert {row["by"] for row in found} == {"person", "language model"}


def test_the_card_tells_how_many_tasks_each_source_has() -> None:
    card = (HERE / "README.md").read_text(encoding="utf-8")
    found = rows()

    for split in {row["split"] for row in found}:
        number = sum(row["split"] == split for row in found)
        assert f"| `{split}` | {number} |" in card
    persons = sum(row["by"] == "person" for row in found)
    assert f"**{persons} of {len(found)} texts are by persons ({persons / len(found):.0%})**" in card


def test_facts_that_are_kept_are_situations(bench: dict[str, Any]) -> None:
    for task in bench["tasks"].tasks()[::25]:
        assert task.facts.others


def test_a_text_in_this_repository_is_the_one_whose_facts_were_noted(bench: dict[str, Any]) -> None:
    for task in bench["tasks"].tasks():
        if "file" in task.at:
            assert bench["tasks"].text_of(task, None)


def test_a_text_elsewhere_is_told_to_be_missing(bench: dict[str, Any]) -> None:
    elsewhere = next(task for task in bench["tasks"].tasks() if "repository" in task.at)

    with pytest.raises(bench["tasks"].NoTextError, match=r"in a clone of https://github\.com/"):
        bench["tasks"].text_of(elsewhere, None)


def test_answers_are_right_part_wrong_refused_or_missing_and_are_judged_once(
    bench: dict[str, Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    answers = tmp_path / "answers"
    answers.mkdir()
    listed = tmp_path / "tasks.jsonl"
    names = ("shown", "fast", "leaves", "unbuilt", "forbidden", "absent")
    fast = {**AHEAD, "ego": {"speed": "70 km/h"}}
    tasks = {name: a_task(name) for name in names} | {"fast": {**a_task("fast"), "situation": fast}}
    listed.write_text("".join(json.dumps(tasks[name]) + "\n" for name in names), encoding="utf-8")
    car = AHEAD["others"][0]
    leaves = {**AHEAD, "others": [{**car, "does": [{"act": "accelerate"}]}]}
    for name, said in (("shown", AHEAD), ("fast", AHEAD), ("leaves", leaves), ("unbuilt", {"version": 1})):
        (answers / f"{name}.json").write_text(json.dumps(said), encoding="utf-8")
    (answers / "forbidden.scenic").write_text("import os\nego = new Object\n", encoding="utf-8")

    first = score(bench, answers, listed)

    counts = json.loads(first.stdout)["all"]
    assert counts == {
        "tasks": 6, "right": 1, "part": 1, "wrong": 1, "refused": 2, "missing": 1, "score": round(1 / 6, 4),
    }  # fmt: skip
    kept = (tmp_path / "answers.rows.jsonl").read_bytes()
    told = {row["id"]: row["why"] for row in map(json.loads, kept.decode().splitlines())}
    assert any("ego.speed" in line for line in told["fast"])
    assert any("does.0.act" in line for line in told["leaves"])
    assert str(tmp_path) not in kept.decode()

    def never(*_: object) -> None:
        raise AssertionError("it was judged before")

    monkeypatch.setattr(bench["score"], "judged", never)
    assert score(bench, answers, listed).stdout == first.stdout
    assert (tmp_path / "answers.rows.jsonl").read_bytes() == kept


SCENARIO = (
    '<OpenSCENARIO><CatalogLocations><VehicleCatalog><Directory path="cars"/></VehicleCatalog></CatalogLocations>'
    '<RoadNetwork><LogicFile filepath="{}"/></RoadNetwork></OpenSCENARIO>'
)
VALUES = (
    '<OpenSCENARIO><ParameterValueDistribution><ScenarioFile filepath="deep/one.xosc"/>'
    "</ParameterValueDistribution></OpenSCENARIO>"
)


@pytest.mark.parametrize(
    ("answer", "refers"),
    [
        ("a.scenic", {"maps/a.xodr"}),
        ("computed.scenic", {"maps/a.xodr", "maps/b.xodr", "b.xodr"}),
        ("a.xosc", {"maps/a.xodr", "cars/all.xosc"}),
        ("named.xosc", {"b.xodr", "cars/all.xosc"}),
        ("values.xosc", {"deep/one.xosc", "maps/b.xodr"}),
        ("a.json", set[str]()),
    ],
)
def test_an_answer_is_judged_again_once_a_file_that_it_refers_to_is_another(
    answer: str, refers: set[str], bench: dict[str, Any], tmp_path: Path
) -> None:
    for name in ("maps/a.xodr", "maps/b.xodr", "cars/all.xosc", "deep/one.xosc"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text("<OpenSCENARIO/>")
    (tmp_path / "a.scenic").write_text("param map = localPath('maps/a.xodr')\n")
    (tmp_path / "computed.scenic").write_text("param map = localPath(f'maps/{globalParameters.town}.xodr')\n")
    (tmp_path / "a.xosc").write_text(SCENARIO.format(".\\maps\\a.xodr"))
    (tmp_path / "named.xosc").write_text(SCENARIO.format("b"))
    (tmp_path / "b.xodr").write_text("")
    (tmp_path / "values.xosc").write_text(VALUES)
    (tmp_path / "deep" / "one.xosc").write_text(SCENARIO.format("../maps/b.xodr"))
    (tmp_path / "a.json").write_text(json.dumps(AHEAD))
    task, settings = bench["tasks"].tasks()[0], bench["score"].VerifySettings()

    def key() -> str:
        return bench["score"].key_of(task, tmp_path / answer, settings)

    others = {str(one.relative_to(tmp_path)) for one in tmp_path.rglob("*.x*")} - {answer}
    assert {one for one in others if _edited_gives_another(tmp_path / one, key)} == refers


def _edited_gives_another(file: Path, key: Callable[[], str]) -> bool:
    before, text = key(), file.read_text()
    file.write_text(f"{text}<!-- edited -->")
    after = key()
    file.write_text(text)
    assert key() == before
    return after != before


def score(bench: dict[str, Any], answers: Path, listed: Path) -> Result:
    asked = [str(answers), "--tasks", str(listed), "--draws", "1", "--jobs", "1", "--json"]
    made = CliRunner().invoke(bench["score"].main, asked, catch_exceptions=False)
    assert made.exit_code == 0, made.output
    return made


def test_the_answers_that_the_card_shows_are_right(bench: dict[str, Any], tmp_path: Path) -> None:
    card = (HERE / "README.md").read_text(encoding="utf-8")
    for kind, at in (("scenic", "```scenic\n"), ("yaml", "```yaml\n")):
        folder = tmp_path / kind
        folder.mkdir()
        (folder / f"kept-second-101.{kind}").write_text(card.split(at)[1].split("```")[0], encoding="utf-8")
        asked = [str(folder), "--task", "kept-second-101", "--draws", "1", "--jobs", "1", "--at-least", "1"]

        assert CliRunner().invoke(bench["score"].main, asked).exit_code == 0


def test_a_harness_gets_a_file_of_each_task_and_a_status_of_one(bench: dict[str, Any], tmp_path: Path) -> None:
    made = CliRunner().invoke(bench["tasks"].main, ["--split", "kept", "--split", "paf", "--each", str(tmp_path / "t")])
    answers = tmp_path / "answers"
    answers.mkdir()
    (answers / "kept_004.yaml").write_text("version: 1\n", encoding="utf-8")
    one, *others = sorted((tmp_path / "t").iterdir())

    assert "left out: in a clone of https://github.com/una-auxme/paf" in made.stderr
    assert len(others) + 1 == sum(row["split"] == "kept" for row in rows())
    assert json.loads(one.read_text(encoding="utf-8")).keys() == {"id", "split", "text"}
    texts = tmp_path / "texts.jsonl"
    texts.write_text(one.read_text(encoding="utf-8"), encoding="utf-8")
    scored = CliRunner().invoke(
        bench["score"].main, [str(answers), "--texts", str(texts), "--at-least", "0.5", "--why", "--jobs", "1"]
    )
    assert scored.exit_code == 1
    assert "| all | 1 | 0 | 0 | 0 | 0 | 1 | 0.0% |" in scored.stdout
    assert f"missing {one.stem}: there is no {one.stem}.scenic" in scored.stdout
    assert "1 files answer no task: their names are no ids, such as kept_004" in scored.stderr
