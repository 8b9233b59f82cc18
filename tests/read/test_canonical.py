"""The same situation is read the same, however its full stop, its case and its ego are written."""

from __future__ import annotations

import json
import re
from importlib.resources import files

import pytest

from chatscene.pipeline import understand
from chatscene.read.canonical import canonical
from chatscene.search.generators.retrieved import Retrieved
from chatscene.settings import RetrievalSettings

BENCHMARK: dict[str, list[str]] = json.loads(
    files("chatscene.search.generators").joinpath("benchmark_scenarios.json").read_text(encoding="utf-8")
)
FORTY = [text for texts in BENCHMARK.values() for text in texts]
EXAMPLES = [
    "the car ahead brakes hard",
    "a motorbike cuts us off from the right",
    "a cyclist cuts across from the left while we turn right",
    "an oncoming car turns left across our path at a traffic light",
    "a pedestrian steps out from behind a bus stop and freezes in front of us",
]
THIRD = {"are": "is", "have": "has", "do": "does", "go": "goes", "pass": "passes", "cross": "crosses", "try": "tries"}


def other_words(text: str, subject: str, be: str, object_: str, owner: str) -> str:
    """A sentence of ours, told of another: "we turn" becomes "the ego turns"."""

    def told(match: re.Match[str]) -> str:
        verb = match[1]
        if subject == "the ego":
            verb = THIRD.get(verb, verb + "s")
        return f"{subject} {be if match[1] == 'are' else verb}"

    text = re.sub(r"\bwe ([a-z]+)", told, text, flags=re.IGNORECASE)
    text = re.sub(r"\bus\b", object_, text)
    return re.sub(r"\bours?\b", owner, text, flags=re.IGNORECASE) if "ours" not in text else text


def variants(text: str) -> list[str]:
    bare = text.rstrip(".")
    return [
        bare,
        f"{bare}.",
        f"{bare}!!!",
        f"  {bare}   .",
        bare.upper(),
        bare.lower(),
        bare.replace(" ", "\n  "),
        other_words(bare, "I", "am", "me", "my"),
        other_words(bare, "the ego", "is", "the ego", "the ego's"),
        other_words(bare, "the ego vehicle", "is", "the ego vehicle", "the ego vehicle's")
        if not re.search(r"\bwe\b", bare, re.IGNORECASE)
        else bare,
    ]


@pytest.mark.parametrize("text", [*FORTY, *EXAMPLES])
def test_full_stop_case_space_and_the_name_of_the_ego_carry_nothing(text: str) -> None:
    assert {canonical(variant) for variant in variants(text)} == {canonical(text)}


def test_what_is_shown_is_the_user_s_own_text() -> None:
    assert understand("A  CAR ahead of Me\nbrakes hard").scenario.text == "A CAR ahead of Me brakes hard"


def test_a_sentence_of_the_benchmark_keeps_its_base_without_its_full_stop() -> None:
    for base, texts in BENCHMARK.items():
        assert Retrieved().read(texts[0].rstrip(".").upper(), RetrievalSettings()).base == base


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("A car cuts off the ego as it turns!!", "a car cuts off us as it turns."),
        ("Before the ego suddenly turns right and stops", "before we suddenly turn right and stop."),
        ("The ego meets a car that turns and stops", "we meet a car that turns and stops."),
        ("the ego's lane", "our lane."),
        ("I'm turning left; it hits me", "we are turning left; it hits us."),
        ("The ego tries to pass a bus", "we try to pass a bus."),
        ("a car behind the ego brakes", "a car behind us brakes."),
        ("Ego-motion is measured", "ego-motion is measured."),
    ],
)  # fmt: skip
def test_the_ego_is_we_us_and_our(text: str, expected: str) -> None:
    assert canonical(text) == expected
