from __future__ import annotations

import hashlib
import unicodedata
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from chatscene.errors import MissingExtra, SettingsError
from chatscene.snippets import embedding
from chatscene.snippets.embedding import EMBEDDERS, MiniLM, encode_cached, load_embedder, plain
from chatscene.snippets.wordpiece import VOCABULARY, tokenize

TEXTS = ("A pedestrian crosses.", "The oncoming car brakes hard.", "straße, naïve café — 信号 100km/h!")


class Counting:
    """An embedder that counts its calls; each row is one of the axes."""

    name = "counting"
    dimension = 4

    def __init__(self) -> None:
        self.calls = 0

    def encode(self, texts: Sequence[str]) -> embedding.Vectors:
        self.calls += 1
        return np.eye(4, dtype=np.float32)[[len(text) % 4 for text in texts]]


def test_the_vocabulary_is_that_of_bert_base_uncased() -> None:
    pieces = VOCABULARY.read_text(encoding="utf-8").splitlines()
    assert len(pieces) == len(set(pieces)) == 30522
    assert (pieces[0], pieces[100], pieces[101], pieces[102]) == ("[PAD]", "[UNK]", "[CLS]", "[SEP]")


@pytest.fixture(scope="module")
def reference() -> Any:
    tokenizers = pytest.importorskip("tokenizers", reason="the reference tokenizer is a test extra")
    return tokenizers.BertWordPieceTokenizer(vocab=str(VOCABULARY), lowercase=True)


# Characters that every Unicode version of the last ten years agrees on; for younger ones tables differ.
CHARACTERS = st.characters(max_codepoint=0x9FA5, categories=("L", "Nd", "P", "S", "Zs", "Mn", "Cc")).filter(
    lambda c: unicodedata.ucd_3_2_0.category(c) == unicodedata.category(c)
)


@given(text=st.text(CHARACTERS, max_size=60))
@settings(max_examples=300, deadline=None)
def test_any_text_is_cut_into_the_pieces_the_reference_cuts_it_into(reference: Any, text: str) -> None:
    assert tokenize(text, 10_000) == reference.encode(text).ids


@pytest.mark.parametrize(
    "text", [*TEXTS, "", "a" * 150, "don't e-bike/T-junction", "\u00ad\u200bcar\ttruck\r\nbus", "\uff21\uff22 \u2460"]
)
def test_awkward_text_is_cut_as_the_reference_cuts_it(reference: Any, text: str) -> None:
    assert tokenize(text, 10_000) == reference.encode(text).ids


def test_a_text_too_long_for_the_model_is_cut_between_its_marks() -> None:
    ids = tokenize("car " * 500, 256)
    assert len(ids) == 256
    assert (ids[0], ids[-1]) == (101, 102)


def test_rows_have_length_one_and_do_not_depend_on_what_stands_beside_them() -> None:
    embedder = load_embedder()
    together = embedder.encode(TEXTS)
    assert together.shape == (3, embedder.dimension)
    assert together.dtype == np.float32
    np.testing.assert_allclose(np.linalg.norm(together, axis=1), 1.0, atol=1e-5)
    for i, text in enumerate(TEXTS):
        np.testing.assert_array_equal(embedder.encode([text])[0], together[i])
    assert embedder.encode([]).shape == (0, embedder.dimension)


def test_a_paraphrase_is_nearer_than_another_event() -> None:
    said, same, other = load_embedder().encode(
        ["the car in front slams on the brakes", "The vehicle ahead brakes hard.", "A child runs after a ball."]
    )
    assert said @ same > said @ other + 0.2


def test_words_that_say_nothing_about_what_happens_are_left_out() -> None:
    assert plain("The adversarial car suddenly brakes") == "The car brakes"
    assert plain("suddenly") == "suddenly"  # nothing else is left to encode


def test_an_unknown_embedder_is_refused_with_the_nearest_name() -> None:
    with pytest.raises(SettingsError, match="did you mean 'minilm'"):
        load_embedder("minilm6")


def test_every_embedder_in_the_table_is_a_class_of_that_name() -> None:
    for name, path in EMBEDDERS.items():
        module, _, cls = path.partition(":")
        assert module == embedding.__name__
        assert getattr(embedding, cls).name == name


def _finds_nothing(_name: str) -> None:
    return None


def test_sentence_t5_names_the_extra_it_needs(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("importlib.util.find_spec", _finds_nothing)
    with pytest.raises(MissingExtra, match=r"chatscene\[t5\]"):
        embedding.SentenceT5()


def test_weights_that_are_not_the_pinned_ones_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(MiniLM, "SHA256", hashlib.sha256(b"").hexdigest())
    with pytest.raises(SettingsError, match="not the pinned ones"):
        MiniLM()


def test_a_library_is_encoded_once_and_then_read_from_the_cache(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    embedder = Counting()
    first, again = encode_cached(embedder, TEXTS), encode_cached(embedder, TEXTS)
    assert embedder.calls == 1
    np.testing.assert_array_equal(first, again)
    encode_cached(embedder, TEXTS[:2])
    assert embedder.calls == 2


@pytest.mark.parametrize("damage", [b"", b"not numpy", "short"])
def test_a_damaged_cache_is_computed_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, damage: bytes | str
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    embedder = Counting()
    rows = encode_cached(embedder, TEXTS)
    (file,) = tmp_path.rglob("*.npy")
    file.write_bytes(damage if isinstance(damage, bytes) else file.read_bytes()[:-7])
    np.testing.assert_array_equal(encode_cached(embedder, TEXTS), rows)
    assert embedder.calls == 2
    assert not list(tmp_path.rglob("*.part"))


def test_a_cache_that_cannot_be_written_stops_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("not a folder")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    assert encode_cached(Counting(), TEXTS).shape == (3, 4)
