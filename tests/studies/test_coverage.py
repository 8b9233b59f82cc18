"""The coverage desk: catalogues, what of them is served, and how that is told."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from chatscene import pipeline
from chatscene.commands.main import main
from chatscene.errors import RunError, SettingsError
from chatscene.runs import Workspace
from chatscene.runs.executor import Workers
from chatscene.runs.progress import Progress, silent
from chatscene.settings import SearchSettings, Settings
from chatscene.studies.catalogue import PACKAGED, load_catalogue, slug
from chatscene.studies.coverage import Asked, as_json, cover, write
from chatscene.terms.coverage import Answer, Catalogue, Entry, Fared, Tally
from places import SHARED

NAMES = {
    "nhtsa": "NHTSA-37",
    "ncap": "EuroNCAP",
    "r157": "UN-R157",
    "iso34502": "ISO34502/JAMA",
    "leaderboard": "CARLA-LB2",
    "challenge": "CARLA-challenge",
}
HERE = Catalogue(
    name="mine",
    title="Mine",
    entries=(
        Entry(name="brakes", sentence="The car ahead brakes hard."),
        Entry(name="lands", sentence="A dragon lands on the bonnet."),
        Entry(name="skids", reason="Nobody else takes part."),
    ),
)


@pytest.mark.parametrize("name", PACKAGED)
def test_a_packaged_catalogue_has_every_entry_by_its_name(name: str) -> None:
    listed = SHARED / "data" / "catalogues.json"
    if not listed.is_file():
        pytest.skip("needs the names of the catalogues' entries, which are not of this repository")
    entries = json.loads(listed.read_text())["catalogues"][NAMES[name]]
    assert [entry.name for entry in load_catalogue(name).entries] == [entry["name"] for entry in entries]


@pytest.mark.parametrize("name", PACKAGED)
def test_an_entry_of_a_packaged_catalogue_is_one_sentence_or_a_reason(name: str) -> None:
    for entry in load_catalogue(name).entries:
        assert bool(entry.sentence) != bool(entry.reason), entry.name
        said = entry.sentence or entry.reason
        assert said[0].isupper(), entry.name
        assert said.endswith("."), entry.name
        assert len(said.split()) <= 26, entry.name


def written(folder: Path, text: str) -> str:
    path = folder / "mine.toml"
    path.write_text(text, encoding="utf-8")
    return str(path)


def test_a_catalogue_of_ones_own_is_a_file_of_names_and_sentences(tmp_path: Path) -> None:
    file = written(tmp_path, 'title = "Ours"\n[[entry]]\nname = "a"\nsentence = "A car\\n brakes."\n')
    catalogue = load_catalogue(file)
    assert (catalogue.name, catalogue.title) == ("mine", "Ours")
    assert catalogue.entries == (Entry(name="a", sentence="A car brakes."),)


def test_a_catalogue_may_begin_with_a_mark_of_its_encoding(tmp_path: Path) -> None:
    file = written(tmp_path, '\ufeff[[entry]]\nname = "a"\nsentence = "A car brakes."\n')
    assert load_catalogue(file).entries == (Entry(name="a", sentence="A car brakes."),)


WRONG = {
    "no entry": ("", "has no entry; write one"),
    "not TOML": ("[[entry]\n", "is not TOML"),
    "a list": ('entry = ["a"]', r"an entry is a table under \[\[entry\]\]"),
    "no name": ('[[entry]]\nsentence = "A car brakes."', "entry 1 has no name"),
    "a name of signs": ('[[entry]]\nname = "-"\nsentence = "A car brakes."', "has no name"),
    "no sentence": ('[[entry]]\nname = "a"', r"entry 1 \('a'\) has no sentence"),
    "an empty sentence": ('[[entry]]\nname = "a"\nsentence = " "', "has no sentence"),
    "both": ('[[entry]]\nname = "a"\nsentence = "A car brakes."\nreason = "None."', "remove one of them"),
    "a number": ('[[entry]]\nname = "a"\nsentence = 3', "sentence must be text, not 3"),
    "another key": ('[[entry]]\nname = "a"\nsentense = "A car brakes."', "did you mean 'sentence'"),
    "another table": ('[[entries]]\nname = "a"', "did you mean 'entry'"),
    "a title of numbers": ('title = 3\n[[entry]]\nname = "a"\nreason = "None."', "title must be text"),
    "a long sentence": (f'[[entry]]\nname = "a"\nsentence = "{"a " * 2000}"', "more than 2000 characters"),
    "twice": ('[[entry]]\nname = "a"\nreason = "No."\n' * 2, "two entries 'a'; give one of them another name"),
    "alike": (
        '[[entry]]\nname = "cut in"\nreason = "No."\n[[entry]]\nname = "cut-in"\nreason = "No."',
        "two entries 'cut-in' and 'cut in', which differ in signs only",
    ),
}


@pytest.mark.parametrize("wrong", WRONG)
def test_what_is_wrong_with_a_catalogue_is_said(wrong: str, tmp_path: Path) -> None:
    text, message = WRONG[wrong]
    with pytest.raises(SettingsError, match=message):
        load_catalogue(written(tmp_path, text))


def test_a_catalogue_that_is_not_there_is_told_with_those_that_are(tmp_path: Path) -> None:
    with pytest.raises(SettingsError, match="did you mean 'nhtsa'"):
        load_catalogue("nhsta")
    with pytest.raises(SettingsError, match=r"there is no file .*none.toml; the packaged catalogues are nhtsa, ncap"):
        load_catalogue(str(tmp_path / "none.toml"))
    with pytest.raises(SettingsError, match="cannot be read"):
        (tmp_path / "folder.toml").mkdir()
        load_catalogue(str(tmp_path / "folder.toml"))
    (tmp_path / "latin.toml").write_bytes('title = "é"'.encode("latin-1"))
    with pytest.raises(SettingsError, match="cannot be read"):
        load_catalogue(str(tmp_path / "latin.toml"))


def test_two_catalogues_of_one_name_are_refused() -> None:
    with pytest.raises(SettingsError, match="two catalogues are called 'mine'"):
        cover([HERE, HERE], Asked(), progress=silent)


def test_an_entry_is_served_or_refused_or_out_of_reach() -> None:
    rows = cover([HERE], Asked(), progress=silent)
    assert [row.answer for row in rows] == [Answer.SERVED, Answer.REFUSED, Answer.OUT_OF_REACH]
    served, refused, beyond = rows
    assert "the ego drives at 50 km/h" in " ".join(served.unused)
    assert served.slots["adversary"] == "car"
    assert not served.reasons
    assert refused.reasons
    assert not refused.snippet_ids
    assert beyond.reasons == ("Nobody else takes part.",)
    assert Tally.of(rows).in_words() == "1 served of 2 in reach, of 3 entries"


def test_what_a_script_is_told_has_a_row_for_every_entry() -> None:
    told = as_json([HERE], Asked(), cover([HERE], Asked(), progress=silent))
    (catalogue,) = json.loads(json.dumps(told))["catalogues"]
    assert {key: told[key] for key in ("map", "seed", "scenes", "egos")} == {
        "map": None,
        "seed": 0,
        "scenes": 0,
        "egos": [],
    }
    assert set(catalogue["rows"][0]) == {
        "name",
        "sentence",
        "answer",
        "reasons",
        "slots",
        "unused",
        "snippet_ids",
        "confidence",
        "fared",
        "failures",
        "missed",
        "searched",
    }
    assert {key: value for key, value in catalogue.items() if key != "rows"} == {
        "name": "mine",
        "title": "Mine",
        "entries": 3,
        "in_reach": 2,
        "served": 1,
        "shown": None,
    }
    assert [row["name"] for row in catalogue["rows"]] == ["brakes", "lands", "skids"]
    assert [row["answer"] for row in catalogue["rows"]] == ["served", "refused", "out of reach"]


def test_names_make_folders() -> None:
    assert slug("Vehicle(s) turning - same direction") == "vehicle-s-turning-same-direction"


# Driven, and run


FEW = Settings(search=SearchSettings(scenes=2, block=2))
PAIR = Catalogue(
    name="pair",
    title="A pair",
    entries=(
        Entry(name="brakes", sentence="The car ahead brakes hard."),
        Entry(name="stops", sentence="The truck ahead stops suddenly."),
    ),
)


def test_drawn_scenes_are_driven_by_every_ego_and_held_against_what_was_read() -> None:
    asked = Asked(scenes=1, egos=("rule-based", "idm"))
    (row, *_) = cover([HERE], asked, progress=silent)
    assert [(fared.ego, fared.scenes) for fared in row.fared] == [("rule-based", 1), ("idm", 1)]
    assert row.shown == row.scenes == 2
    assert not row.missed
    assert all(fared.avoidable <= fared.collisions <= 1 for fared in row.fared)
    assert Tally.of([row]).in_words().endswith("1 shown in at least 90 % of the drives")


def test_filling_goes_on_where_it_was_killed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    asked = Asked(settings=FEW, egos=("rule-based",), folder=tmp_path / "out", fill=True)
    ran: list[str] = []
    search, draw = pipeline.search, pipeline.write_gif

    def counted(run: Workspace, workers: Workers, progress: Progress) -> None:
        ran.append(run.path.name)
        search(run, workers, progress)

    def killed(_: Path) -> Path:
        raise KeyboardInterrupt

    monkeypatch.setattr(pipeline, "search", counted)
    monkeypatch.setattr(pipeline, "write_gif", killed)
    with pytest.raises(KeyboardInterrupt):
        cover([PAIR], asked, progress=silent)
    monkeypatch.setattr(pipeline, "write_gif", draw)
    rows = cover([PAIR], asked, progress=silent)
    assert [name.partition("-")[0] for name in ran] == ["brakes", "brakes", "stops"]
    again = cover([PAIR], asked, progress=silent)
    assert again == rows
    assert len(ran) == 3  # what is done is not done again
    for row in rows:
        assert row.searched
        assert row.searched.status == "done"
        assert row.searched.counts["ran"] == 2
        assert row.picture.startswith(b"RIFF")
        assert (tmp_path / "out" / row.searched.folder / "report.html").is_file()
    page = write(tmp_path / "out", [PAIR], asked, rows).read_text(encoding="utf-8")
    assert page.count("data:image/webp;base64,") == page.count("Report of its run") == 2
    told = json.loads((tmp_path / "out" / "coverage.json").read_text())
    assert told["catalogues"][0]["rows"][0]["searched"]["counts"]["ran"] == 2
    with pytest.raises(RunError, match="egos was"):
        cover([PAIR], replace(asked, egos=("idm",)), progress=silent)


def test_nothing_is_filled_without_a_folder() -> None:
    with pytest.raises(SettingsError, match="--out"):
        cover([HERE], Asked(fill=True), progress=silent)


def test_the_page_names_and_links_what_asks_for_a_look(tmp_path: Path) -> None:
    brakes, lands, skids = cover([HERE], Asked(), progress=silent)
    fared = (Fared(ego="idm", scenes=10, shown=8, collisions=0, avoidable=0),)
    rows = [replace(brakes, fared=fared), lands, skids]
    page = write(tmp_path, [HERE], Asked(), rows).read_text(encoding="utf-8")
    assert '<b>Not served:</b> <a href="#0-1">lands</a>.' in page
    assert '<b>Shown in less than 90 % of the drives:</b> <a href="#0-0">brakes</a>.' in page
    assert page.count('id="0-1"') == page.count('id="0-0"') == 1


def test_the_page_runs_nothing_that_a_catalogue_says(tmp_path: Path) -> None:
    nasty = "<script>alert(1)</script>"
    catalogue = Catalogue(name="n", title=nasty, entries=(Entry(name=nasty, reason=nasty),))
    rows = cover([catalogue], Asked(), progress=silent)
    page = write(tmp_path, [catalogue], Asked(), rows).read_text(encoding="utf-8")
    assert "<script" not in page
    assert "script-src" not in page
    assert page.count("&lt;script&gt;alert(1)") >= 3


# The command


def told(*arguments: str) -> Result:
    return CliRunner().invoke(main, ["coverage", *arguments])


def test_the_command_prints_a_row_for_every_entry(tmp_path: Path) -> None:
    file = written(tmp_path, '[[entry]]\nname = "b[1]"\nsentence = "The car ahead brakes hard."\n')
    answer = told("--catalogue", file)
    assert answer.exit_code == 0
    assert "b[1]" in answer.stdout
    assert "the ego drives at 50 km/h" in answer.stdout
    assert "1 served of 1 in reach, of 1 entries" in answer.stdout
    assert json.loads(told("--catalogue", file, "--json").stdout)["catalogues"][0]["name"] == "mine"


def test_the_command_says_what_is_wrong() -> None:
    assert told("--catalogue", "nhsta").exit_code == 1
    assert told("--catalogue", "r157", "--fill").exit_code == 2


def test_an_ego_that_fails_or_prints_costs_no_other_its_drives_nor_a_script_its_json(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "stacks_of_coverage.py").write_text(
        "class Raises:\n    def act(self, observation):\n        print('loud')\n        raise KeyError('lookup')\n"
    )
    (tmp_path / "mine.toml").write_text(
        '[[entry]]\nname = "brakes"\nsentence = "The car ahead brakes hard."\n', encoding="utf-8"
    )
    monkeypatch.chdir(tmp_path)
    asked = ["coverage", "--catalogue", "mine.toml", "--drive", "--scenes", "1", "--json"]
    done = CliRunner().invoke(main, [*asked, "--ego", "stacks_of_coverage:Raises", "--ego", "idm"])
    assert done.exit_code == 1
    (row,) = json.loads(done.stdout)["catalogues"][0]["rows"]
    assert [one["ego"] for one in row["fared"]] == ["idm"]
    assert list(row["failures"]) == ["stacks_of_coverage:Raises"]
    assert "loud" in done.stderr
    assert "stacks_of_coverage:Raises: brakes: the ego 'Raises' fails at step 0" in done.stderr
