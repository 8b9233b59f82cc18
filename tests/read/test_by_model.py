"""A language model fills a situation; what it gets wrong is told it in words, and what it says is only data."""

from __future__ import annotations

import copy
import inspect
import json
import re
from collections.abc import Callable
from typing import Any

import pytest

from chatscene.build.build import build
from chatscene.errors import LanguageModelError, NotBuilt, SettingsError
from chatscene.models.language.checked import CheckedModel
from chatscene.models.language.protocol import Example, Limits
from chatscene.models.language.scripted import Scripted
from chatscene.models.language.structured import strict_schema
from chatscene.read import situation_prompt
from chatscene.read.by_model import Answer, ModelReader
from chatscene.read.quotes import MIRRORED, not_in_words, unread
from chatscene.read.reader import LONGEST
from chatscene.read.situation_prompt import EXAMPLES, form, system
from chatscene.situations.facts import with_fact
from chatscene.situations.file import read_text, to_yaml
from chatscene.situations.form import from_plain, schema
from chatscene.terms import surroundings, vocabulary
from chatscene.terms.amount import Speed
from chatscene.terms.nouns import with_article
from chatscene.terms.reading import Verdict
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import Act, RoadKind, UserKind, Word

TEXT = "A blue van on the right pulls out at 25 km/h, and we brake."
ANSWER: dict[str, Any] = {
    "verdict": "situation",
    "reason": "",
    "situation": {
        "others": [
            {
                "id": "A",
                "kind": "van",
                "starts": {"where": "kerb", "side": "right"},
                "does": [{"act": "stand"}, {"act": "pull-out", "speed": "25 km/h"}],
            }
        ],
        "evidence": {"quoted": {"others.A": "van on the right", "others.A.does": "pulls out at 25 km/h"}},
    },
}
WORDS = tuple(one for one in vars(vocabulary).values() if inspect.isclass(one) and issubclass(one, Word) and len(one))


def changed(change: Callable[[dict[str, Any]], object]) -> dict[str, Any]:
    answer = copy.deepcopy(ANSWER)
    change(answer["situation"])
    return answer


def asked(*replies: Any, cannot_build: Callable[[Situation], str] = lambda _: "") -> tuple[ModelReader, Scripted]:
    script = Scripted([one if isinstance(one, str) else json.dumps(one) for one in replies])
    return ModelReader(CheckedModel(script, limits=Limits()), cannot_build), script


def told_again(script: Scripted) -> str:
    return script.asked[-1][-1].text


def unbuilt(situation: Situation) -> str:
    try:
        build(situation)
    except NotBuilt as error:
        return str(error)
    return ""


def test_a_right_answer_is_taken_at_once_with_the_words_that_gave_each_fact() -> None:
    reader, script = asked(ANSWER)
    read = reader.read(TEXT)
    assert len(script.asked) == 1
    assert read.verdict is Verdict.SITUATION
    assert [one.probability for one in read.ranked] == [1.0]
    said = read.ranked[0].situation
    assert said["A"].does[1].speed == Speed.of("25 km/h")
    assert said.about == TEXT
    assert dict(said.evidence.quoted) == ANSWER["situation"]["evidence"]["quoted"]
    assert said.evidence.assumed == ()
    assert read_text(to_yaml(said)).evidence == said.evidence
    assert read.unread == ("brake",)  # no scene shows a colour


def test_a_text_of_left_hand_traffic_is_mirrored_and_that_is_told_and_kept_in_a_file() -> None:
    mirrored = changed(lambda said: said["evidence"].update(mirrored=True))
    mirrored["situation"]["evidence"]["quoted"]["others.A"] = "van on the left"
    reader, _ = asked(mirrored)
    said = reader.read(TEXT.replace("right", "left")).ranked[0].situation
    assert MIRRORED in not_in_words(said)
    assert MIRRORED in not_in_words(read_text(to_yaml(said)))
    assert with_fact(said, "ego.speed", "40 km/h").evidence.mirrored
    assert MIRRORED not in not_in_words(asked(ANSWER)[0].read(TEXT).ranked[0].situation)


def test_fences_thoughts_and_nulls_of_an_old_model_are_passed_over() -> None:
    nulls = changed(lambda said: said.update(road=None, contact=None, around={"light": None}))
    reader, _ = asked(f"<think>hm {{}}</think>Sure!\n```json\n{json.dumps(nulls)}\n```\nAnything else?")
    assert reader.read(TEXT).ranked[0].situation["A"].kind is UserKind.VAN


@pytest.mark.parametrize(
    ("wrong", "told"),
    [
        (changed(lambda said: said["evidence"]["quoted"].update({"others.A": "a red van"})), "'a red van' is not in"),
        (changed(lambda said: said["evidence"]["quoted"].update({"others.A": "lue van"})), "'lue van' is not in"),
        (changed(lambda said: said["evidence"]["quoted"].update({"ego.speed": "25 km/h"})), "'ego.speed' leads to no"),
        (changed(lambda said: said.pop("evidence")), "evidence.quoted is empty"),
        (changed(lambda said: said["others"][0].update(kind="vam")), "others.A.kind: 'vam' is none of car, van"),
        (changed(lambda said: said["others"][0]["starts"].update(where="ahead")), "others.A.starts.side: ahead has no"),
        (changed(lambda said: said["others"][0].update(wheels=4)), "others.A.wheels: there is no 'wheels' here"),
        (changed(lambda said: said["others"][0]["does"][1].update(speed=25)), "does.1.speed: 25 has no unit"),
        (changed(lambda said: said["others"][0]["does"][1].update(speed="25")), "does.1.speed: '25' has no unit"),
        (changed(lambda said: said["others"][0].update(count=10**9)), "others.A.count: 1000000000 is too many"),
        (
            changed(lambda said: said["others"][0].update(does=[{"act": "stand"}] * 21)),
            "others.A.does: 21 deeds are too many",
        ),
        (changed(lambda said: said["others"].clear()), "others: nobody is there"),
        (
            changed(lambda said: said.update(ego={"does": [{"act": "cut-in"}]})),
            "ego.does.0.act: the ego cannot cut-in",
        ),
        ({"verdict": "situation", "reason": "", "situation": None}, "situation: is missing"),
        ({"verdict": "no-situation", "reason": " ", "situation": None}, "reason: say in one sentence"),
        ({"verdict": "perhaps", "reason": "", "situation": None}, "verdict: Input should be 'situation'"),
        ("no idea", "holds no JSON object"),
    ],
)
def test_what_is_wrong_is_told_in_words_and_mended(wrong: Any, told: str) -> None:
    reader, script = asked(wrong, ANSWER)
    assert reader.read(TEXT).ranked[0].situation["A"].does[1].act is Act.PULL_OUT
    assert len(script.asked) == 2
    assert told in told_again(script)


def test_asked_again_a_model_is_not_told_the_schema_that_the_rules_tell_in_words() -> None:
    reader, script = asked("no idea", ANSWER)
    reader.read(TEXT)
    assert len(told_again(script)) < 300


def test_quotes_are_compared_without_case_white_space_and_the_form_of_apostrophes() -> None:
    reader, _ = asked(changed(lambda said: said["evidence"].update(quoted={"others.A": "The VAN's  driver"})))
    assert reader.read("Here the van\u2019s\ndriver pulls out.").unread == ("pulls",)


def test_a_fact_without_words_is_assumed_by_its_path() -> None:
    said = changed(lambda said: said.update(ego={"speed": "50 km/h"}, around={"light": "night"}))
    assert asked(said)[0].read(TEXT).ranked[0].situation.evidence.assumed == ("ego.speed", "around.light")


def test_words_that_no_quote_covers_are_told_in_runs_without_the_small_words_around_them() -> None:
    text = "We don't see it: the van, driven by a pizza boy on the phone, comes from the left."
    said = from_plain(
        {
            "others": [{"id": "A", "kind": "van", "starts": {"where": "ahead"}}],
            "evidence": {"quoted": {"others.A.kind": "van", "others.A.starts": "comes from the left"}},
        }
    )
    assert unread(said, text) == ("driven by a pizza boy on the phone", "don't see")


def test_a_model_that_is_never_right_is_an_error_that_names_the_faults_after_two_repairs() -> None:
    wrong = changed(lambda said: said["others"][0].update(kind="vam"))
    reader, script = asked(wrong, wrong, wrong, ANSWER)
    with pytest.raises(LanguageModelError, match=r"in 3 attempts; the last one: others\.A\.kind: 'vam' is none of"):
        reader.read(TEXT)
    assert len(script.asked) == 3


@pytest.mark.parametrize("verdict", [Verdict.NO_SITUATION, Verdict.OUT_OF_REACH])
def test_a_text_that_cannot_be_told_gives_the_verdict_with_the_models_reason(verdict: Verdict) -> None:
    reason = "It is\x1b[31m a " + "very " * 200
    read = asked({"verdict": verdict, "reason": reason, "situation": None})[0].read("Write me a poem.")
    assert (read.verdict, read.ranked) == (verdict, ())
    assert read.reason.startswith("It is[31m a very")
    assert len(read.reason) <= 300


def test_what_cannot_be_built_is_told_and_mended() -> None:
    rails = changed(lambda said: said.update(road={"kind": "rail-crossing", "ego_light": "turns-red"}))
    reader, script = asked(rails, ANSWER, cannot_build=unbuilt)
    assert reader.read(TEXT).ranked[0].situation.road.kind is not RoadKind.RAIL_CROSSING
    assert "it cannot be built: cannot be built yet: road.ego_light: turns-red" in told_again(script)


def test_what_can_never_be_built_is_given_as_it_was_said() -> None:
    rails = changed(lambda said: said.update(road={"kind": "rail-crossing", "ego_light": "turns-red"}))
    reader, _ = asked(rails, rails, rails, cannot_build=unbuilt)
    read = reader.read(TEXT)
    assert read.verdict is Verdict.SITUATION
    with pytest.raises(NotBuilt, match=r"road\.ego_light: turns-red"):
        build(read.ranked[0].situation)


def test_a_model_names_no_map_and_no_version() -> None:
    said = changed(lambda said: said.update(map="/etc/passwd", version=99, about="mine"))
    situation = asked(said)[0].read(TEXT).ranked[0].situation
    assert (situation.map, situation.version, situation.about) == (None, 1, TEXT)


def test_a_text_of_many_pages_is_refused_before_anybody_is_asked() -> None:
    reader, script = asked(ANSWER)
    with pytest.raises(SettingsError, match="use at most 2000 for one situation"):
        reader.read("x" * (LONGEST + 1))
    assert not script.asked


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda one: one.text[:30])
def test_the_examples_of_the_prompt_are_what_they_ask_for_and_can_be_built(example: Example) -> None:
    reader, script = asked(example.reply, cannot_build=unbuilt)
    read = reader.read(example.text)
    assert len(script.asked) == 1
    assert read.verdict is Verdict(json.loads(example.reply)["verdict"])
    assert not any(one.situation.evidence.assumed for one in read.ranked)


@pytest.mark.parametrize("table", [*WORDS, surroundings.Light, surroundings.Weather, surroundings.Surface])
def test_the_prompt_has_every_word_with_its_meaning(table: Any) -> None:
    told = system().split(f"\n# {table.__name__}", 1)[1].split("\n#", 1)[0]
    for word in table:
        meaning = getattr(word, "meaning", "")
        says_no_more = meaning in ("", word, with_article(word.replace("-", " ")))
        assert str(word) in told.splitlines()[0] if says_no_more else f"\n{word}: {meaning}" in told


def test_the_prompt_has_every_field_but_those_that_are_no_models() -> None:
    fields = system().split("\nFields", 1)[1].split("\nWords:", 1)[0]
    ours = {"version", "about", "map", "assumed", "open", "unbuilt", "keeps_left"}
    for part in (schema(), *schema()["$defs"].values()):
        for name in set(part.get("properties", ())) - ours:
            assert re.search(rf"[\n ,]{name}(?: \(|[:.,\n])", fields)


def test_a_new_word_is_in_the_prompt_and_in_the_schema_by_itself(monkeypatch: pytest.MonkeyPatch) -> None:
    grown = schema()
    grown["$defs"]["Act"]["enum"].append("hover")
    grown["$defs"]["Act"]["description"] += "\nhover: floats above the road"
    monkeypatch.setattr(situation_prompt, "schema", lambda: copy.deepcopy(grown))
    assert "\nhover: floats above the road\n" in system.__wrapped__()
    assert "hover" in form.__wrapped__()["$defs"]["Act"]["enum"]


LONGEST_PROMPT = 17_700  # characters: docs/lab/language-models.md has what that leaves of a context of 8,192 tokens


def test_the_prompt_stays_short_enough_for_small_models() -> None:
    characters = len(system()) + sum(len(one.text) + len(one.reply) for one in EXAMPLES)
    assert characters < LONGEST_PROMPT, (
        f"the prompt has {characters} characters. A new word has some 70: shorten its meaning, or those of others"
        " in terms/vocabulary.py. If it must grow, run benchmarks/prompt_length.py and raise LONGEST_PROMPT, with"
        " docs/lab/language-models.md, 'How long the prompt may be', and the context in docs/language-models.md"
    )


def test_a_model_is_held_to_a_schema_of_which_what_was_not_said_may_be_left_out() -> None:
    held = json.dumps(form())
    assert "description" not in held
    assert '"assumed"' not in held
    assert form()["$defs"]["Deed"]["required"] == ["act"]
    assert len(held) < len(json.dumps(schema())) / 2
    assert set(strict_schema(Answer)["properties"]) == set(form()["properties"])


def test_words_that_are_quoted_for_a_part_of_which_nothing_is_said_are_told_as_not_read() -> None:
    text = "We drive on, and a dog runs out."
    dog = {"id": "A", "kind": "dog", "starts": {"where": "roadside"}, "does": [{"act": "cross"}]}
    quoted = {"ego": "We drive on", "others.A": "a dog runs out"}
    reply = {"verdict": "situation", "reason": "", "situation": {"others": [dog], "evidence": {"quoted": quoted}}}
    read = ModelReader(CheckedModel(Scripted([reply]), limits=Limits(reasks=0))).read(text)
    assert list(read.ranked[0].situation.evidence.quoted) == ["others.A"]


def test_an_ego_that_is_said_to_be_a_vehicle_is_one_by_itself() -> None:
    said = changed(lambda said: said.update(ego={"kind": "vehicle", "speed": "40 km/h"}))
    reader, script = asked(said)
    ego = reader.read(TEXT).ranked[0].situation.ego
    assert (ego.kind, ego.speed, len(script.asked)) == (None, Speed.of("40 km/h"), 1)
