"""A model proposes, our code checks, a person decides; a hostile model gets nothing done."""

from __future__ import annotations

import json
import re
import zlib
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner
from numpy.typing import NDArray

from chatscene.commands import proposal as cli_proposal
from chatscene.ego.rule_based import RuleBased
from chatscene.errors import SnippetError
from chatscene.grow import review
from chatscene.grow.draft import Draft, code_faults, slug, snippet_of
from chatscene.grow.lint import Finding
from chatscene.grow.prompt import draft_of, shots, system, vocabulary
from chatscene.grow.propose import Summary, propose
from chatscene.grow.shelf import Shelf
from chatscene.grow.trying import Judge
from chatscene.grow.wordings import Rephrased, rephrase
from chatscene.library.compatibility import ASIDE, STILL
from chatscene.library.load import Library, load_library, load_snippet
from chatscene.library.snippet_file import as_text
from chatscene.maps.network import resolve_map
from chatscene.models.language.checked import CheckedModel
from chatscene.models.language.protocol import Limits
from chatscene.models.language.scripted import Scripted
from chatscene.settings import SimulationSettings
from chatscene.simulate.confined.simulator import ConfinedSimulator
from chatscene.terms.scenario import BaseScenario, Component
from chatscene.terms.snippet import Snippet
from places import ROOT

BASE = BaseScenario.STRAIGHT_OBSTACLE
CODE = """param OPT_ADV_SPEED = Range(1.5, 3)
param OPT_ADV_DISTANCE = Range(25, 45)
param OPT_STOP_TIME = Range(1.2, 2.5)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, 2.5)
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
"""
HALT = "do Halt() for globalParameters.OPT_STOP_TIME seconds"
DRAFT: dict[str, Any] = {
    "name": "Count your change / halfway!",
    "description": "The pedestrian steps off the kerb, stands counting coins for a moment, and then walks on across.",
    "rephrasings": [
        "Somebody on foot sets out over the road, stops to count change, then carries on to the other side.",
        "A walker starts across, pauses over a purse, and resumes.",
        "ped steps out, stands, goes on",
        "This bloke wanders out, has a think about his coins, and off he goes across us.",
        "The pedestrian entered the roadway, halted briefly, and then continued across the path of Vehicle 1.",
    ],
    "adversaries": ["pedestrian"],
    "slots": {"actions": ["cross", "hesitate"]},
    "parameters": [
        {"name": "OPT_ADV_SPEED", "unit": "m/s", "meaning": "how fast it walks"},
        {"name": "OPT_ADV_DISTANCE", "unit": "m", "meaning": "how far the ego is when it sets out"},
        {"name": "OPT_STOP_TIME", "unit": "s", "meaning": "how long it stands"},
    ],
    "code": CODE,
}


def draft(**changes: Any) -> dict[str, Any]:
    return DRAFT | changes


def model(*replies: Any, reasks: int = 0) -> CheckedModel:
    return CheckedModel(Scripted(list(replies)), limits=Limits(reasks=reasks))


class ReadsOnly(Judge):
    """Judges the code alone, so that a test takes no simulation."""

    def faults(self, snippet: Snippet, base: BaseScenario | None) -> tuple[Finding, ...]:
        return code_faults(snippet, Library(tuple(s for s in self.library if s.id != snippet.id)))


def quiet(what: str, done: int, total: int) -> None:
    pass


def reads_only(library: Library) -> Judge:
    return ReadsOnly(library, simulator=None, ego=RuleBased())  # type: ignore[arg-type]


class Words:
    """Embeds a text as the words in it, so that a test needs no encoder."""

    name = identity = "words"
    dimension = 1024

    def encode(self, texts: Sequence[str]) -> NDArray[np.float32]:
        rows = np.zeros((len(texts), self.dimension), dtype=np.float32)
        for row, text in zip(rows, texts, strict=True):
            for word in re.findall(r"[a-z]+", text.lower()):
                row[zlib.crc32(word.encode()) % self.dimension] += 1.0
        return np.asarray(rows / np.maximum(np.linalg.norm(rows, axis=1, keepdims=True), 1e-9), np.float32)


WORDS = Words()


@pytest.fixture(scope="module")
def sandbox() -> Iterator[ConfinedSimulator]:
    with ConfinedSimulator(resolve_map("town"), SimulationSettings()) as simulator:
        yield simulator


def small_library() -> Library:
    """Enough partners for somebody on foot, and one behavior that stops on its way."""
    library = load_library()
    ids = ("behavior/cross-and-stop", "behavior/cross", "geometry/straight-road", "spawn/roadside-right")
    return Library(tuple(library.get(one) for one in sorted(ids)))


def asked(folder: Path, *replies: Any, n: int = 1, judge: Judge | None = None) -> Summary:
    shelf = Shelf(folder)
    return propose(
        model(*replies),
        Component.BEHAVIOR,
        BASE,
        n,
        shelf=shelf,
        judge=judge or reads_only(shelf.library()),
        progress=quiet,
    )


def files(folder: Path) -> set[str]:
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}


def made(**changes: Any) -> Snippet | tuple[Finding, ...]:
    one = Draft.model_validate(draft(**changes))
    return snippet_of(one, "behavior/mine", Component.BEHAVIOR, load_library(), origin="a test")


def rungs(found: Snippet | tuple[Finding, ...]) -> set[str]:
    assert not isinstance(found, Snippet)
    return {finding.rung for finding in found}


# Drafts


# What only goes with a composed behavior is no draft's: a draft is tried with partners that are packaged.
DRAFTED = [s for s in load_library().snippets if not {ASIDE, STILL} & set(s.requires)]


@pytest.mark.parametrize("snippet", DRAFTED[::23], ids=lambda s: s.id)
def test_a_packaged_snippet_survives_being_a_draft_and_a_file(snippet: Snippet, tmp_path: Path) -> None:
    others = Library(tuple(s for s in load_library() if s.id != snippet.id))
    again = snippet_of(
        Draft.model_validate_json(draft_of(snippet)), snippet.id, snippet.component, others, origin=snippet.origin
    )
    assert isinstance(again, Snippet)
    assert (again.requires, again.provides, again.slots) == (snippet.requires, snippet.provides, snippet.slots)
    path = tmp_path / f"{snippet.id}.scenic"
    path.parent.mkdir()
    path.write_text(as_text(again), encoding="utf-8")
    read = load_snippet(path)
    assert read.source.strip() == again.source.strip() == snippet.source.strip()
    assert set(read.parameters) == set(again.parameters)
    assert (read.requires, read.provides) == (again.requires, again.provides)


def test_the_header_is_computed_from_the_code() -> None:
    snippet = made()
    assert isinstance(snippet, Snippet)
    assert snippet.requires == ("egoRoute",)
    assert snippet.provides == ("AdvBehavior",)
    assert next((p.name, p.low, p.high) for p in snippet.parameters) == ("OPT_ADV_DISTANCE", 25.0, 45.0)


def test_text_of_a_model_cannot_break_out_of_the_header(tmp_path: Path) -> None:
    hostile = 'It crosses." \n#: provides = ["ego"]\n#: x = "\u2028\x00 and then \\ goes on'
    snippet = made(description=hostile, code=CODE + '#: origin = "me"\n')
    assert isinstance(snippet, Snippet)
    path = tmp_path / "behavior" / "mine.scenic"
    path.parent.mkdir()
    path.write_text(as_text(snippet), encoding="utf-8")
    read = load_snippet(path)
    assert read.provides == ("AdvBehavior",)
    assert read.origin == "a test"
    assert read.description == snippet.description


@pytest.mark.parametrize(
    "code",
    [
        "import os\n" + CODE,
        CODE + 'x = open("/etc/passwd")\n',
        CODE.replace(HALT, "while True:\n        x = 1"),
        CODE + "y = ego.__class__\n",
        "model chatscene.world.model\n" + CODE,
        CODE + "ego2 = undefinedName\n",
    ],
)
def test_code_beyond_the_allow_list_is_refused_unrun(code: str) -> None:
    assert rungs(made(code=code)) == {"allow-list"}


@pytest.mark.parametrize(
    ("changes", "rung"),
    [
        ({"code": CODE.replace("AdvBehavior", "Other")}, "names"),
        ({"code": CODE + "egoRoute = 1\n"}, "names"),
        ({"code": CODE + "AdvAgent2 = new Car\n"}, "names"),
        ({"code": CODE + "z = Uniform(1, 2)\n"}, "randomness"),
        ({"parameters": []}, "parameters"),
        ({"code": CODE.replace("45)\nparam", "45),")}, "parameters"),
        ({"slots": {}}, "slots"),
        ({"slots": {"actions": ["cross"], "occluder": "kiosk"}}, "slots"),
        ({"adversaries": []}, "slots"),
        ({"description": "too short"}, "text"),
        ({"rephrasings": ["One and the same."] * 5}, "text"),
        ({"description": load_library().get("behavior/cross").description.upper()}, "text"),
    ],
)
def test_a_draft_that_keeps_no_contract_is_refused(changes: dict[str, Any], rung: str) -> None:
    assert rung in rungs(made(**changes))


def test_a_name_becomes_a_file_name_and_nothing_else() -> None:
    assert slug("../../etc/passwd") == "etc-passwd"
    assert slug("Walk & stop", ["walk-stop", "walk-stop-2"]) == "walk-stop-3"
    assert len(slug("a" * 300)) <= 48
    with pytest.raises(SnippetError):
        slug("../..")


def test_the_prompt_shows_the_language_and_examples_that_are_drafts() -> None:
    assert "MoveAhead(speed, turn=0)" in vocabulary()
    assert "headway(path, a, b)" in vocabulary()
    assert "oncomingTraffic" not in system(Component.BEHAVIOR, BASE, load_library())
    for component in Component:
        examples = shots(component, BASE, load_library())
        assert len(examples) == 3
        for example in examples:
            assert Draft.model_validate_json(example.reply).code


def test_the_snippet_of_the_documents_keeps_its_contract(tmp_path: Path) -> None:
    page = (ROOT / "docs" / "library.md").read_text(encoding="utf-8")
    (shown,) = re.findall(r"```scenic\n(.*?)```", page, re.DOTALL)
    path = tmp_path / "behavior" / "drop-and-fetch.scenic"
    path.parent.mkdir()
    path.write_text(shown, encoding="utf-8")
    (wordings,) = re.findall(r"```text\n(.*?)```", page, re.DOTALL)
    beside = tmp_path / "wordings" / "behavior" / "drop-and-fetch.txt"
    beside.parent.mkdir(parents=True)
    beside.write_text(wordings, encoding="utf-8")
    assert len(load_snippet(path).rephrasings) == 5
    assert code_faults(load_snippet(path), load_library()) == ()


# The loop


def test_what_passes_waits_with_its_record(tmp_path: Path) -> None:
    summary = asked(tmp_path, DRAFT)
    (kept,) = summary.kept
    assert kept.id == "behavior/count-your-change-halfway"
    assert files(tmp_path) == {
        "proposed/behavior/count-your-change-halfway.scenic",
        "proposed/behavior/count-your-change-halfway.json",
        "proposed/wordings/behavior/count-your-change-halfway.txt",
        "proposed/history.jsonl",
    }
    record = json.loads(kept.path.with_suffix(".json").read_text(encoding="utf-8"))
    assert (record["model"], record["base"], record["drafts"]) == ("scripted", "straight-obstacle", 1)
    assert record["spending"]["calls"] == 1
    read = load_snippet(kept.path)
    assert read.description == DRAFT["description"]
    assert list(read.rephrasings) == DRAFT["rephrasings"]


def test_a_draft_is_mended_with_the_reasons(tmp_path: Path) -> None:
    one = model(draft(code="import os\n" + CODE), draft(slots={}), DRAFT)
    shelf = Shelf(tmp_path)
    summary = propose(one, Component.BEHAVIOR, BASE, 1, shelf=shelf, judge=reads_only(shelf.library()), progress=quiet)
    assert summary.kept[0].attempts == 3
    record = json.loads(summary.kept[0].path.with_suffix(".json").read_text(encoding="utf-8"))
    assert [said[0].partition(":")[0] for said in record["diagnostics"]] == ["allow-list", "slots"]


def test_no_draft_is_mended_more_than_twice_and_none_that_does_not_change(tmp_path: Path) -> None:
    wrong = [draft(slots={}, description=f"A walker does thing number {i}.") for i in range(4)]
    summary = asked(tmp_path, *wrong)
    assert (summary.refused[0].attempts, summary.refused[0].reason) == (3, "slots")
    assert asked(tmp_path, wrong[0], wrong[0], DRAFT).refused[0].attempts == 1


def test_a_refused_name_is_told_to_the_model_that_is_asked_next(tmp_path: Path) -> None:
    wrong = draft(name="dance a jig", slots={})
    asked(tmp_path, wrong, wrong)
    script = Scripted([DRAFT])
    shelf = Shelf(tmp_path)
    next_one = CheckedModel(script, limits=Limits())
    judge = reads_only(shelf.library())
    propose(next_one, Component.BEHAVIOR, BASE, 1, shelf=shelf, judge=judge, progress=quiet)
    assert "dance a jig: slots" in script.asked[0][-1].text


def test_the_same_proposal_twice_is_kept_once(tmp_path: Path) -> None:
    summary = asked(tmp_path, DRAFT, DRAFT, DRAFT, n=2)
    assert len(summary.kept) == 1
    assert summary.reasons == {"text": 1}


def test_a_hostile_model_ends_in_counted_refusals_and_writes_nothing(tmp_path: Path) -> None:
    folder = tmp_path / "deep" / "own"
    hostile = [
        draft(name="../../../escape", code="import os\nos.system('true')\n" + CODE),
        draft(name="/tmp/absolute", code=CODE + f'x = open("{tmp_path}/stolen", "w")\n'),
        draft(name="loop", code=CODE.replace(HALT, "while True:\n        pass")),
        draft(name="..", code=CODE),
        "x" * 300_000,
        draft(code="x = 1\n" * 1200),
        "I will not.",
    ]
    summary = asked(
        folder, *[reply for one in hostile for reply in (one, one)[: 1 if isinstance(one, str) else 2]], n=7
    )
    assert not summary.kept
    assert summary.reasons == {"allow-list": 4, "reply": 2, "name": 1}
    assert files(tmp_path) == {"deep/own/proposed/history.jsonl"}


def test_a_model_that_says_nothing_usable_is_not_asked_for_ever(tmp_path: Path) -> None:
    assert asked(tmp_path, *["no"] * 20, n=20).reasons == {"reply": 3}


# Trials, behind both walls


def test_a_sound_proposal_passes_its_trials(sandbox: ConfinedSimulator) -> None:
    snippet = made()
    assert isinstance(snippet, Snippet)
    assert Judge(small_library(), sandbox, RuleBased(), scenes=3).faults(snippet, BASE) == ()


def test_a_claim_that_the_drives_do_not_show_is_refused(sandbox: ConfinedSimulator) -> None:
    snippet = made(slots={"actions": ["weave"]})
    assert isinstance(snippet, Snippet)
    assert rungs(Judge(small_library(), sandbox, RuleBased(), scenes=2).faults(snippet, BASE)) == {"means"}


def test_a_copy_of_a_snippet_is_found_on_its_tracks(sandbox: ConfinedSimulator) -> None:
    cross = load_library().get("behavior/cross-and-stop")
    copy = json.loads(draft_of(cross)) | {key: DRAFT[key] for key in ("name", "description", "rephrasings")}
    snippet = snippet_of(
        Draft.model_validate(copy | {"adversaries": ["pedestrian"]}),
        "behavior/copy", Component.BEHAVIOR, small_library(), origin="a test",
    )  # fmt: skip
    assert isinstance(snippet, Snippet)
    faults = Judge(small_library(), sandbox, RuleBased(), scenes=1).faults(snippet, BASE)
    assert [(f.rung, "cross-and-stop" in f.message) for f in faults] == [("distinct", True)]


def test_a_geometry_of_another_base_scenario_is_refused() -> None:
    library = load_library()
    left = library.get("geometry/left-turn")
    judge = Judge(library, simulator=None, ego=RuleBased())  # type: ignore[arg-type]
    assert rungs(judge.faults(left, BASE)) == {"base"}


# The queue


def queued(folder: Path) -> tuple[Shelf, str]:
    return Shelf(folder), asked(folder, DRAFT).kept[0].id


def test_what_waits_is_listed_and_a_damaged_file_says_so(tmp_path: Path) -> None:
    shelf, one = queued(tmp_path)
    (tmp_path / "proposed" / "spawn").mkdir()
    (tmp_path / "proposed" / "spawn" / "broken.scenic").write_text("#: nonsense\n", encoding="utf-8")
    sound, broken = review.pending(shelf)
    assert (sound.id, sound.fault, sound.model) == (one, "", "scripted")
    assert "TOML" in broken.fault


def test_a_proposal_that_is_no_plan_waits_and_says_so(tmp_path: Path) -> None:
    code = DRAFT["code"].replace(HALT, f"{HALT}\n    wait")
    (kept,) = asked(tmp_path, {**DRAFT, "code": code}).kept
    (one,) = review.pending(Shelf(tmp_path))
    assert (one.id, one.fault) == (kept.id, "")
    assert one.says.startswith(f"{DRAFT['description']} (no plan: line 10: 'wait'")


def test_an_accepted_proposal_is_a_snippet_of_the_library(tmp_path: Path) -> None:
    shelf, one = queued(tmp_path)
    path = review.accept(shelf, one, make_judge=reads_only, embedder=Words)
    assert path == tmp_path / f"{one}.scenic"
    assert shelf.library().get(one).description == DRAFT["description"]
    assert list(shelf.library().get(one).rephrasings) == DRAFT["rephrasings"]
    assert shelf.ids() == ()
    assert files(tmp_path / "proposed") == {"history.jsonl"}
    assert [event["event"] for event in shelf.history()] == ["proposed", "accepted"]


def test_what_was_made_worse_in_the_queue_is_not_accepted(tmp_path: Path) -> None:
    shelf, one = queued(tmp_path)
    path = shelf.place(one)
    path.write_text(path.read_text(encoding="utf-8") + "import os\n", encoding="utf-8")
    with pytest.raises(SnippetError, match="allow-list"):
        review.accept(shelf, one, make_judge=reads_only, embedder=Words)
    assert files(tmp_path / "proposed") >= {f"{one}.scenic"}
    assert not (tmp_path / f"{one}.scenic").exists()


def test_a_rejected_proposal_leaves_its_reason(tmp_path: Path) -> None:
    shelf, one = queued(tmp_path)
    review.reject(shelf, one, "nobody does that")
    assert shelf.ids() == ()
    assert list(shelf.history())[-1]["why"] == "nobody does that"
    assert files(tmp_path) == {"proposed/history.jsonl"}


def test_an_edited_proposal_is_checked_again(tmp_path: Path) -> None:
    shelf, one = queued(tmp_path)
    text = review.text_of(shelf, one)
    worse = text.replace(HALT, "do Nothing()")
    faults = review.edit(shelf, one, worse, make_judge=reads_only, embedder=Words)
    assert "Nothing" in faults[0].message
    assert review.edit(shelf, one, text, make_judge=reads_only, embedder=Words) == ()


@pytest.mark.parametrize(
    "bad", ["../x", "behavior/../../x", "/etc/passwd", "behavior/x/../y", "behavior/X", "behavior/x\n", "b/x", ""]
)
def test_an_id_names_nothing_outside_of_the_queue(bad: str, tmp_path: Path) -> None:
    shelf = Shelf(tmp_path)
    for act in (
        lambda: review.reject(shelf, bad, "no"),
        lambda: review.accept(shelf, bad, make_judge=reads_only, embedder=Words),
        lambda: review.text_of(shelf, bad),
    ):
        with pytest.raises(SnippetError, match="is not an id"):
            act()


# Wordings


def with_snippet(folder: Path) -> tuple[Shelf, str]:
    shelf, one = queued(folder)
    review.accept(shelf, one, make_judge=reads_only, embedder=Words)
    return shelf, one


def wordings(shelf: Shelf, one: str, *replies: list[str], n: int) -> Rephrased:
    said = model(*({"wordings": reply} for reply in replies))
    return rephrase(said, one, n, shelf=shelf, embedder=WORDS)


def test_wordings_are_checked_queued_and_accepted(tmp_path: Path) -> None:
    shelf, one = with_snippet(tmp_path)
    good = "The pedestrian sets off over the road, stands there counting coins, then walks on."
    bad = [DRAFT["rephrasings"][0].upper(), "no", "The car ahead slams on its brakes.", good]
    found = wordings(shelf, one, [good, *bad], [], [], n=3)
    assert found.kept == (good,)
    assert sorted(refusal.reason for refusal in found.refused) == ["duplicate", "elsewhere", "text"]
    assert shelf.ids() == (f"rephrasings/{one}",)
    review.accept(shelf, f"rephrasings/{one}", make_judge=reads_only, embedder=Words)
    assert shelf.library().get(one).rephrasings[-1] == good
    assert shelf.ids() == ()


def test_wordings_of_a_packaged_snippet_are_not_proposed_beside_it(tmp_path: Path) -> None:
    with pytest.raises(SnippetError, match="packaged"):
        wordings(Shelf(tmp_path), "behavior/cross", [], n=1)


# The command line


def test_the_commands_say_what_waits_and_what_was_done(tmp_path: Path) -> None:
    shelf, one = queued(tmp_path)
    run, own = CliRunner(), ["--library", str(tmp_path)]
    listed = run.invoke(cli_proposal.pending, own)
    assert one in listed.output
    assert "1 wait" in listed.output
    assert json.loads(run.invoke(cli_proposal.pending, [*own, "--json"]).output)[0]["id"] == one
    done = run.invoke(cli_proposal.reject, [one, "--why", "dull", *own])
    assert done.output == f"rejected: {one}\n"
    assert shelf.ids() == ()


def test_proposing_says_how_many_were_refused_and_why(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    script = tmp_path / "replies.json"
    script.write_text(json.dumps([draft(code="import os\n" + CODE)] * 2), encoding="utf-8")
    done = CliRunner().invoke(
        cli_proposal.propose,
        ["--component", "behavior", "--base", BASE.value, "--n", "1", "--json",
         "--language-model", f"scripted:{script}", "--library", str(tmp_path / "own")],
    )  # fmt: skip
    assert done.exit_code == 0, done.output
    assert json.loads(done.stdout)["reasons"] == {"allow-list": 1}
