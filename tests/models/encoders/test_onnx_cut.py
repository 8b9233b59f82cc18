"""An encoder that is run in parts reads as the whole file does, to the last bit."""

from __future__ import annotations

import numpy as np
import onnxruntime
import pytest
from numpy.typing import NDArray

from chatscene.models.encoders.embedding import MiniLM, plain, tokenize
from chatscene.models.encoders.onnx_cut import OnnxFile
from chatscene.read.learned.weights import load

TEXTS = ("", "A bus!", "A cyclist rides out from the left and stops in front of us.", "the van waits, and " * 80)


def session(content: bytes) -> onnxruntime.InferenceSession:
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = options.inter_op_num_threads = 1
    return onnxruntime.InferenceSession(content, options, providers=["CPUExecutionProvider"])


def states(whole: onnxruntime.InferenceSession, text: str) -> NDArray[np.float32]:
    ids = np.array([tokenize(plain(text), MiniLM.LONGEST)], np.int64)
    feed = {"input_ids": ids, "attention_mask": np.ones_like(ids), "token_type_ids": np.zeros_like(ids)}
    (found,) = whole.run(None, feed)
    return np.asarray(found)[0]


def test_the_parts_give_the_states_of_the_whole_file_to_the_last_bit() -> None:
    whole, parts = session(MiniLM.content()), MiniLM()
    for text in TEXTS:
        np.testing.assert_array_equal(parts.states(text), states(whole, text))


def test_upper_layers_that_were_trained_further_are_those_of_the_changed_file() -> None:
    changes = dict(load().changes)
    content = bytearray(MiniLM.content())
    for at, difference in changes.items():
        numbers = np.frombuffer(content, np.uint8)[at : at + len(difference)]
        numbers += np.frombuffer(difference, np.uint8)
    whole, parts = session(bytes(content)), MiniLM(changes)
    for text in TEXTS:
        np.testing.assert_array_equal(parts.states(text), states(whole, text))


def test_encoders_are_told_apart_by_what_was_trained() -> None:
    changes = dict(load().changes)
    at, difference = next(iter(changes.items()))
    first, second = MiniLM(changes), MiniLM({**changes, at: bytes(len(difference))})
    assert len({MiniLM().identity, first.identity, second.identity}) == 3
    assert MiniLM().identity == f"minilm@{MiniLM.SHA256}"


@pytest.mark.parametrize("where", ["in the lower layers", "beyond the end of an array"])
def test_a_change_of_what_all_encoders_share_is_refused(where: str) -> None:
    at, difference = next(iter(dict(load().changes).items()))
    changes = {1_000_000: b"\1"} if where == "in the lower layers" else {at: difference + bytes(10_000_000)}
    with pytest.raises(ValueError, match=r"share|broadcast"):
        MiniLM(changes).states("a bus")


def test_an_array_of_the_file_is_found_by_its_name() -> None:
    scales = OnnxFile(MiniLM.content()).array("inner.embeddings.word_embeddings.weight_scale", np.float32)
    assert scales.shape == (30522,)
    assert np.all(scales > 0)
