"""MiniLM in torch, to be trained further, and back into the bytes of its file.

The file keeps each matrix as int8 numbers with a scale per column (per row for words and positions). Trained layers
are rounded the same way, then to whole steps from the old ones, and written over them, so that the runtime that loads
the one loads the other, and what changed is small (decision 0042).
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

import numpy as np
import onnx
import torch
from numpy.typing import NDArray
from onnx import numpy_helper
from torch import Tensor, nn

from chatscene.models.encoders.embedding import MiniLM

LAYERS, WIDTH, ATTENTION_HEADS, INNER = 6, 384, 12, 1536
EPSILON = 1e-12
MATRICES = ("query", "key", "value", "output", "up", "down")  # of a layer, in the order of the file
AT_ONCE = 64  # sentences
STEP = 2  # between the int8 numbers that a trained weight may have

Array = NDArray[Any]


class Tuned(nn.Module):
    """The encoder, of which the upper layers are trained.

    Args:
        frozen: How many lower layers are not trained.
        dropout: Of the layers.
    """

    def __init__(self, *, frozen: int, dropout: float) -> None:
        super().__init__()
        self._file = _File()
        layers = [self._file.layer(i, dropout) for i in range(LAYERS)]
        self._lower = nn.ModuleList(layers[:frozen]).eval().requires_grad_(False)
        self.upper = nn.ModuleList(layers[frozen:])

    def train(self, mode: bool = True) -> Tuned:
        """Set what is trained to training or running; the lower layers always run."""
        super().train(mode)
        self._lower.eval()
        return self

    def lower(self, rows: Sequence[Sequence[int]]) -> list[Tensor]:
        """(tokens, D) half-precision states after the lower layers, of each row of token numbers."""
        found: dict[int, Tensor] = {}
        order = sorted(range(len(rows)), key=lambda i: len(rows[i]))
        with torch.no_grad():
            for first in range(0, len(order), AT_ONCE):
                some = order[first : first + AT_ONCE]
                states, padding = padded([self._file.words(rows[i]) for i in some])
                for layer in self._lower:
                    states = layer(states, src_key_padding_mask=padding)
                for i, state in zip(some, states, strict=True):
                    found[i] = state[: len(rows[i])].half().clone()
        return [found[i] for i in range(len(rows))]

    def file_changes(self) -> dict[int, bytes]:
        """What to add to the bytes of the encoder's file, by where they stand."""
        changed: dict[int, bytes] = {}
        for i, layer in enumerate(self.upper, LAYERS - len(self.upper)):
            changed |= self._file.written(i, layer)
        return changed


def padded(states: Sequence[Tensor]) -> tuple[Tensor, Tensor]:
    """(N, tokens, D) states of several texts, and where each has none."""
    together = nn.utils.rnn.pad_sequence(list(states), batch_first=True)
    lengths = torch.tensor([len(state) for state in states])
    return together, torch.arange(together.shape[1])[None, :] >= lengths[:, None]


class _File:
    """The encoder's file, by the names of its arrays."""

    def __init__(self) -> None:
        self._content = MiniLM.content()
        self._arrays = _arrays(self._content)
        numbered = (re.fullmatch(r"val_(\d+)_q", name) for name in self._arrays)
        self._matrices = [f"val_{number}" for number in sorted(int(m[1]) for m in numbered if m)]
        part = "inner.embeddings"
        self._words, self._positions = (
            self._whole(f"{part}.{name}_embeddings.weight") for name in ("word", "position")
        )
        self._type = torch.from_numpy(self._arrays[f"{part}.token_type_embeddings.weight"][0].copy())
        self._weight, self._bias = (
            torch.from_numpy(self._arrays[f"{part}.LayerNorm.{name}"].copy()) for name in ("weight", "bias")
        )

    def words(self, tokens: Sequence[int]) -> Tensor:
        """(tokens, D) what goes into the first layer."""
        x = self._words[torch.tensor(tokens)] + self._positions[: len(tokens)] + self._type
        return nn.functional.layer_norm(x, (WIDTH,), self._weight, self._bias, EPSILON)

    def layer(self, i: int, dropout: float) -> nn.TransformerEncoderLayer:
        """One layer with the weights of the file."""
        layer = nn.TransformerEncoderLayer(
            WIDTH, ATTENTION_HEADS, INNER, dropout, "gelu", layer_norm_eps=EPSILON, batch_first=True
        )
        matrices = dict(zip(MATRICES, (self._whole(name).T for name in self._of(i)), strict=True))
        vectors = {name: torch.from_numpy(self._arrays[at].copy()) for name, at in _vectors(i).items()}
        layer.load_state_dict(
            {
                "self_attn.in_proj_weight": torch.cat([matrices[name] for name in MATRICES[:3]]),
                "self_attn.in_proj_bias": torch.cat([vectors[name] for name in MATRICES[:3]]),
                "self_attn.out_proj.weight": matrices["output"],
                "self_attn.out_proj.bias": vectors["output"],
                "linear1.weight": matrices["up"],
                "linear1.bias": vectors["up"],
                "linear2.weight": matrices["down"],
                "linear2.bias": vectors["down"],
                **{name: vectors[name] for name in vectors if name.startswith("norm")},
            }
        )
        return layer

    def written(self, i: int, layer: nn.Module) -> dict[int, bytes]:
        """What a layer's weights add to the bytes of the file, by where they stand."""
        state = {name: value.detach().numpy() for name, value in layer.state_dict().items()}
        in_weights = np.split(state["self_attn.in_proj_weight"], 3)
        matrices = [*in_weights, *(state[f"{n}.weight"] for n in ("self_attn.out_proj", "linear1", "linear2"))]
        in_biases = dict(zip(MATRICES[:3], np.split(state["self_attn.in_proj_bias"], 3), strict=True))
        vectors = {
            **in_biases,
            "output": state["self_attn.out_proj.bias"],
            "up": state["linear1.bias"],
            "down": state["linear2.bias"],
            **{name: state[name] for name in state if name.startswith("norm")},
        }
        changed: dict[int, bytes] = {}
        for name, matrix in zip(self._of(i), matrices, strict=True):
            scale = (np.abs(matrix.T).max(axis=0, keepdims=True) / 127).astype(np.float32)
            changed |= self._over(f"{name}_q", in_steps(self._arrays[f"{name}_q"], matrix.T / scale))
            changed |= self._over(f"{name}_scale", scale)
        for name, at in _vectors(i).items():
            changed |= self._over(at, vectors[name])
        return changed

    def _of(self, i: int) -> list[str]:
        return self._matrices[len(MATRICES) * i : len(MATRICES) * (i + 1)]

    def _whole(self, name: str) -> Tensor:
        return torch.from_numpy(self._arrays[f"{name}_q"].astype(np.float32) * self._arrays[f"{name}_scale"])

    def _over(self, name: str, new: Array) -> dict[int, bytes]:
        """What an array's new bytes add to its old ones, by where they stand in the file."""
        old = self._arrays[name]
        if (old.shape, old.dtype) != (new.shape, new.dtype) or self._content.count(old.tobytes()) != 1:
            raise AssertionError(f"{name} cannot be written over")
        before, after = (np.frombuffer(array.tobytes(), np.uint8) for array in (old, new))
        return {self._content.index(old.tobytes()): (after - before).tobytes()}


def _arrays(content: bytes) -> dict[str, Array]:
    """Every array of a model's file, by its name."""
    return {i.name: numpy_helper.to_array(i) for i in onnx.load_from_string(content).graph.initializer}


def in_steps(old: Array, new: Array) -> Array:
    """Int8 numbers that differ from the old ones by whole steps, as near to the new ones as that allows.

    Args:
        old: Int8 numbers.
        new: Numbers from -127 to 127, of any kind.
    """
    nearest = old + STEP * np.round((new - old) / STEP)
    return (nearest - STEP * (nearest > 127) + STEP * (nearest < -128)).astype(np.int8)


def _vectors(i: int) -> dict[str, str]:
    """The names of a layer's vectors, here and in the file."""
    layer = f"inner.encoder.layer.{i}"
    return {
        **{name: f"{layer}.attention.self.{name}.bias" for name in MATRICES[:3]},
        "output": f"{layer}.attention.output.dense.bias",
        "up": f"{layer}.intermediate.dense.bias",
        "down": f"{layer}.output.dense.bias",
        **{f"norm1.{part}": f"{layer}.attention.output.LayerNorm.{part}" for part in ("weight", "bias")},
        **{f"norm2.{part}": f"{layer}.output.LayerNorm.{part}" for part in ("weight", "bias")},
    }
