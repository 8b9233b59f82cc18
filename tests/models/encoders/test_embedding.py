from __future__ import annotations

import hashlib
import importlib
import shutil
import socket
import sys
import unicodedata
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from chatscene.errors import MissingExtra, SettingsError
from chatscene.interpret.nearest import nearest
from chatscene.library.load import Library, load_library
from chatscene.models.encoders import embedding
from chatscene.models.encoders.embedding import (
    EMBEDDERS,
    VOCABULARY,
    Embedder,
    MiniLM,
    encode_cached,
    load_embedder,
    plain,
    tokenize,
)
from chatscene.plugins import make
from chatscene.terms.scenario import Component
from chatscene.testing import check_encoder

TEXTS = ("A pedestrian crosses.", "The oncoming car brakes hard.", "straße, naïve café — 信号 100km/h!")


class Counting:
    """An embedder that counts its calls; each row is one of the axes."""

    name = "counting"
    dimension = 4

    def __init__(self, identity: str = "counting@1") -> None:
        self.identity = identity
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
@settings(max_examples=300)
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


# What every embedder keeps to


TINY = "a tiny model of Sentence-T5's architecture"


def make_tiny_t5(folder: Path) -> Path:
    """Save a Sentence-T5 of random weights: encoder, mean, dense layer, length 1; in halves, as the released ones."""
    whole: Any = pytest.importorskip("sentence_transformers", reason="Sentence-T5 needs the extra t5")
    torch: Any = importlib.import_module("torch")
    cut: Any = importlib.import_module("tokenizers")
    hf: Any = importlib.import_module("transformers")
    parts: Any = _modules()
    alphabet = ["<pad>", "</s>", "<unk>", *"abcdefghijklmnopqrstuvwxyz", "\u2581"]
    tokenizer = cut.Tokenizer(cut.models.Unigram([(piece, -float(i)) for i, piece in enumerate(alphabet)], unk_id=2))
    tokenizer.pre_tokenizer = cut.pre_tokenizers.Metaspace()
    tokenizer.post_processor = cut.processors.TemplateProcessing(single="$A </s>", special_tokens=[("</s>", 1)])
    marks = {"pad_token": "<pad>", "eos_token": "</s>", "unk_token": "<unk>"}
    hf.PreTrainedTokenizerFast(tokenizer_object=tokenizer, **marks).save_pretrained(folder / "bare")
    with torch.random.fork_rng():
        torch.manual_seed(0)
        sizes = {"d_model": 16, "d_kv": 8, "d_ff": 32, "num_layers": 2, "num_heads": 2}
        hf.T5EncoderModel(hf.T5Config(vocab_size=len(alphabet), **sizes)).half().save_pretrained(folder / "bare")
        dense = parts.Dense(16, 12, bias=False, activation_function=torch.nn.Identity())
    modules = [parts.Transformer(str(folder / "bare")), parts.Pooling(16), dense, parts.Normalize()]
    whole.SentenceTransformer(modules=modules, device="cpu").save(str(folder / "whole"))
    return folder / "whole"


def _modules() -> Any:
    """Where the classes of a model's parts are: version 5.7 moved them."""
    try:
        return importlib.import_module("sentence_transformers.sentence_transformer.modules")
    except ImportError:
        return importlib.import_module("sentence_transformers.models")


@pytest.fixture(scope="module")
def tiny_t5(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return make_tiny_t5(tmp_path_factory.mktemp("t5"))


@pytest.fixture(params=[*EMBEDDERS.built_in, TINY])
def each(request: pytest.FixtureRequest) -> Embedder:
    """Every embedder in the table whose weights are here, and one of each class whatever is here."""
    if request.param == TINY:
        return load_embedder(f"t5:{request.getfixturevalue('tiny_t5')}")
    try:
        return load_embedder(request.param)
    except (MissingExtra, SettingsError) as error:
        if request.param == "minilm":
            raise
        pytest.skip(str(error))


def test_every_embedder_keeps_the_contract(each: Embedder) -> None:
    check_encoder(each)


def test_what_lies_beyond_the_longest_text_is_not_read(each: Embedder) -> None:
    np.testing.assert_array_equal(each.encode(["car " * 3000]), each.encode(["car " * 4000]))


def test_an_embedder_is_found_by_its_name_and_told_apart_by_its_identity(each: Embedder) -> None:
    assert load_embedder(each.name) is each
    name, _, content = each.identity.rpartition("@")
    assert name == each.name
    assert len(content) >= 32


def test_a_paraphrase_is_nearer_than_another_event() -> None:
    said, same, other = load_embedder().encode(
        ["the car in front slams on the brakes", "The vehicle ahead brakes hard.", "A child runs after a ball."]
    )
    assert said @ same > said @ other + 0.2


def test_words_that_say_nothing_about_what_happens_are_left_out() -> None:
    assert plain("The adversarial car suddenly brakes") == "The car brakes"
    assert plain("suddenly") == "suddenly"  # nothing else is left to encode


def test_half_a_character_is_replaced() -> None:
    assert plain("a \udcffcar") == "a ?car"


def test_an_unknown_embedder_is_refused_with_the_nearest_name() -> None:
    with pytest.raises(SettingsError, match="did you mean 'minilm'"):
        load_embedder("minilm6")


def test_the_default_embedder_is_loaded_once_however_it_is_called() -> None:
    assert load_embedder() is load_embedder("minilm") is load_embedder(name="minilm")


# Sentence-T5


@pytest.mark.parametrize("name", ["sentence-t5-base", "sentence-t5-large", "t5:/some/folder"])
def test_sentence_t5_names_the_extra_it_needs(monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    monkeypatch.setitem(sys.modules, "sentence_transformers", None)
    with pytest.raises(MissingExtra, match=rf"{name}.*\[t5\]"):
        load_embedder(name)


@pytest.fixture
def offline(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object) -> None:
        raise AssertionError("something went to the network")

    monkeypatch.setattr(socket.socket, "connect", refuse)
    monkeypatch.setattr(socket, "getaddrinfo", refuse)


@pytest.mark.usefixtures("offline")
@pytest.mark.parametrize("name", ["t5:/no/such/folder", "t5:nobody/no-such-model", "t5:not a name"])
def test_weights_that_are_not_here_are_not_fetched_and_the_message_says_how_to(name: str) -> None:
    pytest.importorskip("sentence_transformers", reason="Sentence-T5 needs the extra t5")
    with pytest.raises(SettingsError, match=r"beforehand with: hf download sentence-transformers/sentence-t5-large"):
        load_embedder(name)


@pytest.mark.usefixtures("offline")
def test_a_model_that_was_fetched_before_is_found_by_its_name(tiny_t5: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fetched(name: str, *, local_files_only: bool) -> str:
        assert name == "sentence-transformers/sentence-t5-base"
        assert local_files_only
        return str(tiny_t5)

    monkeypatch.setattr("huggingface_hub.snapshot_download", fetched)
    embedder = make(EMBEDDERS, "sentence-t5-base")
    assert (embedder.name, embedder.dimension) == ("sentence-t5-base", 12)


def test_a_tiny_t5_gives_the_rows_of_its_definition(tiny_t5: Path) -> None:
    """Mean of the encoder's states, times the dense layer, scaled: computed by hand from the saved tensors."""
    torch: Any = pytest.importorskip("torch", reason="Sentence-T5 needs the extra t5")
    transformers: Any = importlib.import_module("transformers")
    tensors: Any = importlib.import_module("safetensors.torch")
    encoder = transformers.T5EncoderModel.from_pretrained(tiny_t5).float().eval()
    tokenizer = transformers.AutoTokenizer.from_pretrained(tiny_t5)
    dense = tensors.load_file(tiny_t5 / "2_Dense" / "model.safetensors")["linear.weight"].float()
    with torch.no_grad():
        states = encoder(**tokenizer("a car stops", return_tensors="pt")).last_hidden_state[0]
        row = (dense @ states.mean(dim=0)).numpy()
    ours = load_embedder(f"t5:{tiny_t5}").encode(["a car stops"])[0]
    np.testing.assert_allclose(ours, row / np.linalg.norm(row), atol=1e-5)


@pytest.mark.usefixtures("offline")
def test_the_identity_of_a_model_is_that_of_its_content(tiny_t5: Path, tmp_path: Path) -> None:
    copied, changed = (Path(shutil.copytree(tiny_t5, tmp_path / name)) for name in ("copied", "changed"))
    weights = changed / "2_Dense" / "model.safetensors"
    content = bytearray(weights.read_bytes())
    content[-1] ^= 1  # one bit of one weight
    weights.write_bytes(content)
    ours, same, other = (
        load_embedder(f"t5:{folder}").identity.rpartition("@")[2] for folder in (tiny_t5, copied, changed)
    )
    assert ours == same != other


@pytest.mark.parametrize("damage", ["weights", "dense", "modules", "module", "tokenizer", "empty"])
def test_a_broken_model_is_refused_with_its_folder(tiny_t5: Path, tmp_path: Path, damage: str) -> None:
    folder = Path(shutil.copytree(tiny_t5, tmp_path / damage))
    broken = {
        "weights": ("model.safetensors", b"short"),
        "dense": ("2_Dense/model.safetensors", b""),
        "modules": ("modules.json", b"{"),
        "module": ("modules.json", b'[{"idx": 0, "name": "0", "path": "", "type": "sentence_transformers.Nothing"}]'),
        "tokenizer": ("tokenizer.json", b"{}"),
        "empty": ("config.json", b""),
    }
    name, content = broken[damage]
    (folder / name).write_bytes(content)
    with pytest.raises(SettingsError, match=f"{damage} holds no model that sentence-transformers can load"):
        load_embedder(f"t5:{folder}")


def test_switching_the_embedder_switches_the_index(
    tiny_t5: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    small = Library(load_library().of(Component.GEOMETRY)[:4])
    ours, other = load_embedder(), load_embedder(f"t5:{tiny_t5}")

    def similar(embedder: Embedder) -> list[tuple[str, float]]:
        return [
            (s.id, cosine)
            for s, cosine in nearest("a road", Component.GEOMETRY, small, embedder, count=4, lexical_weight=0.0)
        ]

    first, switched, back = similar(ours), similar(other), similar(ours)
    assert first == back
    assert sorted(first) != sorted(switched)
    assert {np.load(file).shape[1] for file in tmp_path.rglob("*.npy")} == {ours.dimension, other.dimension}


# The cache


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
    encode_cached(Counting("counting@2"), TEXTS)  # other weights of the same name, another file
    assert len(list(tmp_path.rglob("*.npy"))) == 3


def test_of_many_texts_another_one_costs_a_piece_of_the_cache_and_the_rows_stay_the_same(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(embedding, "PIECE", 20)
    embedder, many = Counting(), [f"car {i} brakes" for i in range(400)]
    rows = encode_cached(embedder, many)
    np.testing.assert_array_equal(rows, embedder.encode(many))
    pieces, embedder.calls = len(list(tmp_path.rglob("*.npy"))), 0
    assert 10 < pieces < 40
    more = encode_cached(embedder, ["another", *many, many[0]])
    assert 1 <= embedder.calls <= 2
    np.testing.assert_array_equal(more[1:-1], rows)
    np.testing.assert_array_equal(more[-1], rows[0])


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
    assert not list(tmp_path.rglob("*.tmp"))


def test_a_cache_that_cannot_be_written_stops_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("not a folder")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    assert encode_cached(Counting(), TEXTS).shape == (3, 4)


@pytest.mark.parametrize("fault", [MemoryError(), RuntimeError("Exception during initialization: std::bad_alloc")])
def test_too_little_memory_for_the_encoder_is_said_in_a_sentence(
    fault: Exception, monkeypatch: pytest.MonkeyPatch
) -> None:
    def session(*_: object, **__: object) -> None:
        raise fault

    monkeypatch.setattr("onnxruntime.InferenceSession", session)
    with pytest.raises(SettingsError, match="too little memory for the encoder"):
        vars(embedding)["_Layers"](b"")
