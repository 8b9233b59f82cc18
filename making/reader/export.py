"""The learned reader's decoder as two small graphs for onnxruntime: one for a text, one for each next token."""

from __future__ import annotations

import io
import warnings
from typing import Any

import numpy as np
import onnx
import torch
from onnx import helper, numpy_helper
from torch import Tensor, nn

from making.reader.network import DEPTH, HEADS, LAYERS, Network
from making.reader.tuned_encoder import WIDTH

OPSET = 17
_LEAST = 1024  # numbers of a matrix that is kept in int8


class _Text(nn.Module):
    """What the decoder takes from a text: keys and values of each layer, and the amounts."""

    def __init__(self, network: Network) -> None:
        super().__init__()
        self.network = network

    def forward(self, states: Tensor, share: Tensor, forms: Tensor) -> tuple[Tensor, ...]:
        memory = self.network.memory(states)
        told = [one for layer in self.network.layers for one in layer.of_text(memory)]
        return (*told, self.network.amounts(states, share, forms), self.network.marked(states))


class _Next(nn.Module):
    """The log-odds of what comes next, of several sequences of one text."""

    def __init__(self, network: Network) -> None:
        super().__init__()
        self.network = network

    def forward(self, tokens: Tensor, places: Tensor, at: Tensor, which: Tensor, *given: Tensor) -> Any:
        amounts, words, text, past = given[0], given[1], given[2 : 2 + 2 * LAYERS], given[2 + 2 * LAYERS :]
        network, n = self.network, tokens.shape[0]
        copied = (amounts[0][which.clamp(min=0)] + network.copied) * (which >= 0).float()[:, None]
        x = network.begun(tokens[:, None], places[:, None], at[:, None], copied[:, None])
        kept: list[Tensor] = []
        for i, layer in enumerate(network.layers):
            told = tuple(one.expand(n, -1, -1, -1) for one in text[2 * i : 2 * i + 2])
            x, its = _step(layer, x, told, past[2 * i : 2 * i + 2])
            kept += its
        return (
            network.odds(x, amounts.expand(n, -1, -1))[:, 0],
            network.marks(x, words.expand(n, -1, -1))[:, 0],
            *kept,
        )


def _step(layer: Any, x: Tensor, text: Any, past: Any) -> tuple[Tensor, tuple[Tensor, Tensor]]:
    return layer(x, text, torch.zeros(1, 1, 1, 1), past)


def exported(network: Network) -> tuple[bytes, bytes]:
    """The graphs, with matrices in int8."""
    network.eval()
    names = [f"{what}{i}" for i in range(LAYERS) for what in ("keys", "values")]
    own = [f"own_{name}" for name in names]
    states, share = torch.zeros(1, 5, WIDTH), torch.zeros(1, 2, 5)
    text = _graph(
        _Text(network), (states, share, torch.zeros(1, 2, dtype=torch.long)), ["states", "share", "forms"],
        [*names, "amounts", "words"],
        {"states": {1: "pieces"}, "share": {1: "amounts", 2: "pieces"}, "forms": {1: "amounts"}},
    )  # fmt: skip
    whole = torch.zeros(3, dtype=torch.long)
    width = DEPTH // HEADS
    of_text = torch.zeros(1, 2, DEPTH), torch.zeros(1, 5, DEPTH), *[torch.zeros(1, HEADS, 5, width)] * (2 * LAYERS)
    given = *[whole] * 4, *of_text, *[torch.zeros(3, HEADS, 4, width)] * (2 * LAYERS)
    inputs = ["tokens", "places", "at", "which", "amounts", "words", *names, *own]
    axes = {name: {0: "n"} for name in inputs[:4]} | {name: {0: "n", 2: "steps"} for name in own}
    axes |= {"amounts": {1: "some"}, "words": {1: "pieces"}} | {name: {2: "pieces"} for name in names}
    return text, _graph(_Next(network), given, inputs, ["odds", "marks", *(f"next_{name}" for name in names)], axes)


def _graph(module: nn.Module, given: Any, inputs: list[str], outputs: list[str], axes: Any) -> bytes:
    made: Any = io.BytesIO()
    with warnings.catch_warnings(), torch.no_grad():
        warnings.simplefilter("ignore")
        torch.onnx.export(
            module, given, made, input_names=inputs, output_names=outputs, dynamic_axes=axes, opset_version=OPSET,
            dynamo=False,
        )  # fmt: skip
    return _small(onnx.load_from_string(made.getvalue())).SerializeToString()


def _small(model: Any) -> Any:
    """The same with matrices as int8 numbers, each column with a scale of its own."""
    graph = model.graph
    for one in [one for one in graph.initializer if len(one.dims) == 2 and np.prod(one.dims) >= _LEAST]:
        matrix = numpy_helper.to_array(one).astype(np.float32)
        scale = (np.abs(matrix).max(axis=0) / 127 + 1e-12).astype(np.float32)
        whole = np.round(matrix / scale).astype(np.int8)
        name = one.name
        graph.initializer.remove(one)
        graph.initializer.append(numpy_helper.from_array(whole, f"{name}_q"))
        graph.initializer.append(numpy_helper.from_array(scale, f"{name}_scale"))
        graph.node.insert(0, helper.make_node("DequantizeLinear", [f"{name}_q", f"{name}_scale"], [name], axis=1))
    return model
