"""The learned reader in torch: the encoder's layers, and a small decoder that writes a situation."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import torch
from torch import Tensor, nn
from torch.nn import functional

from chatscene.read.learned.numbers import Form
from making.reader.dropout import Dropout
from making.reader.tuned_encoder import WIDTH, Tuned, padded

DEPTH, HEADS, INNER, LAYERS = 256, 8, 1024, 2  # of the decoder
MOST_STEPS = 96
DROPOUT = 0.1


class DecoderLayer(nn.Module):
    """Attention to what was written, attention to the text, and a layer of its own; each normalised before."""

    def __init__(self) -> None:
        super().__init__()
        self.own, self.own_out = nn.Linear(DEPTH, 3 * DEPTH), nn.Linear(DEPTH, DEPTH)
        self.ask, self.text, self.text_out = (
            nn.Linear(DEPTH, DEPTH), nn.Linear(DEPTH, 2 * DEPTH), nn.Linear(DEPTH, DEPTH),
        )  # fmt: skip
        self.up, self.down = nn.Linear(DEPTH, INNER), nn.Linear(INNER, DEPTH)
        self.norms = nn.ModuleList(nn.LayerNorm(DEPTH) for _ in range(3))
        self.drop = Dropout(DROPOUT)

    def of_text(self, memory: Tensor) -> tuple[Tensor, Tensor]:
        """Keys and values of the text."""
        keys, values = self.text(memory).chunk(2, -1)
        return _split(keys), _split(values)

    def forward(
        self, x: Tensor, text: tuple[Tensor, Tensor], mask: Tensor, past: tuple[Tensor, Tensor] | None = None
    ) -> tuple[Tensor, tuple[Tensor, Tensor]]:
        """The next states, and keys and values of what was written so far.

        Without a past the tokens are all there, each of which sees those before it; with one there is a single token.
        """
        queries, keys, values = map(_split, self.own(self.norms[0](x)).chunk(3, -1))
        if past is not None:
            keys, values = torch.cat([past[0], keys], 2), torch.cat([past[1], values], 2)
        told = functional.scaled_dot_product_attention(queries, keys, values, is_causal=past is None)
        x = x + self.drop(self.own_out(_joined(told)))
        asked = _split(self.ask(self.norms[1](x)))
        told = functional.scaled_dot_product_attention(asked, *text, attn_mask=mask.to(asked.dtype))
        x = x + self.drop(self.text_out(_joined(told)))
        x = x + self.drop(self.down(functional.gelu(self.up(self.norms[2](x)))))
        return x, (keys, values)


def _split(x: Tensor) -> Tensor:
    n, length, width = x.shape
    return x.view(n, length, HEADS, width // HEADS).transpose(1, 2)


def _joined(x: Tensor) -> Tensor:
    n, heads, length, width = x.shape
    return x.transpose(1, 2).reshape(n, length, heads * width)


class Network(nn.Module):
    """Encoder and decoder.

    Args:
        tokens: How many there are.
        places: How many.
        frozen: Lower layers of the encoder that are not trained.
    """

    def __init__(self, *, tokens: int, places: int, frozen: int) -> None:
        super().__init__()
        self.encoder = Tuned(frozen=frozen, dropout=DROPOUT)
        for layer in self.encoder.upper:
            layer.self_attn.dropout = 0.0  # type: ignore[assignment]
            layer.dropout, layer.dropout1, layer.dropout2 = (Dropout(DROPOUT) for _ in range(3))  # type: ignore[assignment]
        self.memory = nn.Linear(WIDTH, DEPTH)
        self.amount, self.form = nn.Linear(WIDTH, DEPTH), nn.Embedding(len(Form), DEPTH)
        self.token, self.copied = nn.Embedding(tokens, DEPTH), nn.Parameter(torch.zeros(DEPTH))
        self.place, self.at = nn.Embedding(places, DEPTH), nn.Embedding(MOST_STEPS, DEPTH)
        self.layers: Any = nn.ModuleList(DecoderLayer() for _ in range(LAYERS))
        self.norm, self.out, self.point = nn.LayerNorm(DEPTH), nn.Linear(DEPTH, tokens), nn.Linear(DEPTH, DEPTH)
        self.mark, self.marked = nn.Linear(DEPTH, DEPTH), nn.Linear(WIDTH, DEPTH)
        self.seldom = nn.Parameter(torch.tensor(-2.0))  # most words are not those of a fact
        for table in (self.token, self.form, self.place, self.at):
            nn.init.normal_(table.weight, std=0.05)

    def begin_with(self, trained: Mapping[str, Tensor]) -> None:
        """Take the weights of another of these; of its encoder the layers that are trained here, if it trained them."""
        upper = "encoder.upper."
        own = {name for name, _ in self.named_parameters()}
        alike = trained.keys() >= own
        kept = {name: value for name, value in trained.items() if alike or not name.startswith("encoder.")}
        self.load_state_dict(
            {name: value for name, value in kept.items() if name in own or upper in name}, strict=False
        )

    def decoder(self) -> list[nn.Parameter]:
        """What is trained beside the encoder."""
        return [p for name, p in self.named_parameters() if not name.startswith("encoder.")]

    def states(self, lower: Sequence[Tensor]) -> tuple[Tensor, Tensor]:
        """States of texts from what `Tuned.lower` gave, and where there are none."""
        states, padding = padded([state.float() for state in lower])
        for layer in self.encoder.upper:
            states = layer(states, src_key_padding_mask=padding)
        return states, padding

    def amounts(self, states: Tensor, share: Tensor, forms: Tensor) -> Tensor:
        """(N, amounts, depth) from the share that each piece of the text has of each amount."""
        return self.amount(share.to(states.dtype) @ states) + self.form(forms)

    def begun(self, tokens: Tensor, places: Tensor, at: Tensor, copied: Tensor) -> Tensor:
        """What goes into the first layer; `copied` is zero where the token before was none that is copied."""
        return self.token(tokens) + self.place(places) + self.at(at) + copied

    def odds(self, x: Tensor, amounts: Tensor) -> Tensor:
        """(N, steps, tokens and amounts) log-odds of what comes next."""
        x = self.norm(x)
        pointed = self.point(x) @ amounts.transpose(1, 2) / DEPTH**0.5
        return torch.cat([self.out(x), pointed], -1).float()

    def marks(self, x: Tensor, words: Tensor) -> Tensor:
        """(N, steps, pieces) log-odds that a piece of the text is one of the words of the token that went in.

        Args:
            x: States of the steps.
            words: What `marked` makes of the states of the text.
        """
        return (self.mark(self.norm(x)) @ words.transpose(1, 2) / DEPTH**0.5 + self.seldom).float()
