"""From a text to the likeliest sequences: a beam that writes nothing against the grammar.

One thread and one text at a time, so that a text is read the same whatever stands beside it (decision 0027).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chatscene.models.encoders.embedding import MiniLM
from chatscene.read.learned.grammar import BEGUN, COPIED, END, grammar
from chatscene.read.learned.numbers import Found
from chatscene.read.learned.sequence import Step
from chatscene.read.learned.text import Read
from chatscene.read.learned.weights import Weights
from chatscene.terms.arrays import fixed

Floats = NDArray[np.float32]

WIDTH = 24
"""Sequences that are followed at once."""
LONGEST = 96
"""Tokens of a sequence."""
_NEVER = -1e9
_FAINT = math.log(1e-3)
"""What has begun so much less likely than the likeliest is not followed: all that it could become together is less."""
_LAYERS, _HEADS, _DEPTH = 2, 8, 256


@dataclass(frozen=True, slots=True, eq=False)
class Written:
    """A sequence, and how likely it is.

    Attributes:
        found: The amounts of the text that it copies, by the number of the step.
        marks: Of each step but the last, the log-odds of each piece of the text that it is one of its words.
    """

    steps: tuple[Step, ...]
    likely: float
    found: tuple[tuple[int, Found], ...] = ()
    marks: tuple[Floats, ...] = ()


@dataclass(frozen=True, slots=True)
class _Begun:
    place: str
    token: int
    which: int
    likely: float
    steps: tuple[Step, ...]
    found: tuple[tuple[int, Found], ...]
    marks: tuple[Floats, ...]

    def marked(self, marks: Floats) -> _Begun:
        return _Begun(self.place, self.token, self.which, self.likely, self.steps, self.found, (*self.marks, marks))


class Decoder:
    """What was learned, ready to read."""

    def __init__(self, weights: Weights) -> None:
        self._weights = weights
        self._encoder = MiniLM(weights.changes)
        self._grammar = grammar()
        self._tokens = weights.tokens
        self._places = {name: i for i, name in enumerate(weights.places)}
        number = {token: i for i, token in enumerate(self._tokens)}
        own = {i: number[token] for i, token in enumerate(self._grammar.tokens) if token in number}
        self._of = {  # what was trained of what the grammar allows; the vocabulary may have grown since
            place: tuple(own[i] for i in some if i in own) for place, some in self._grammar.of.items()
        }
        self._next = {
            (place, own[i]): there
            for (place, i), there in self._grammar.next.items()
            if i in own and there in self._places
        }

    @cached_property
    def _text(self) -> Any:
        return _session(self._weights.text)

    @cached_property
    def _following(self) -> Any:
        return _session(self._weights.following)

    @cached_property
    def _follow(self) -> NDArray[np.bool_]:
        made = np.zeros((len(self._places), len(self._tokens)), bool)
        for (place, token), there in self._next.items():
            if place in self._places and there in self._places:
                made[self._places[place], token] = True
        return fixed(made)

    def written(self, read: Read) -> tuple[Written, ...]:
        """The likeliest sequences of a text, the likeliest first."""
        states = self._encoder.states_of(read.pieces)
        share, forms = _spans(read)
        *told, amounts, words = self._text.run(None, {"states": states[None], "share": share, "forms": forms})
        given = {f"{what}{i}": told[2 * i + k] for i in range(_LAYERS) for k, what in enumerate(("keys", "values"))}
        past = {f"own_{name}": np.zeros((1, _HEADS, 0, _DEPTH // _HEADS), np.float32) for name in given}
        given |= {"amounts": amounts, "words": words}
        alive, done = [_Begun(BEGUN, 0, -1, 0.0, (), (), ())], list[Written]()
        allowed: dict[str, NDArray[np.bool_]] = {}
        for at in range(LONGEST):
            odds, marks, *kept = self._following.run(None, {**given, **past, **self._fed(alive, at)})
            if at:
                alive = [one.marked(its) for one, its in zip(alive, marks, strict=True)]
            for place in {one.place for one in alive} - allowed.keys():
                allowed[place] = self._allowed(place, read.amounts, odds.shape[1])
            likely = _likely(odds, np.stack([allowed[one.place] for one in alive]))
            scores = np.array([one.likely for one in alive])[:, None] + likely
            best = np.argsort(-scores, axis=None, kind="stable")[: WIDTH + len(done)]
            ways = [divmod(int(i), scores.shape[1]) for i in best if scores.flat[i] > _NEVER / 2]
            nexts = [(row, self._on(alive[row], token, float(scores[row, token]), read)) for row, token in ways]
            done += [Written(one.steps, one.likely, one.found, one.marks) for _, one in nexts if one.place == END]
            nexts = [(row, one) for row, one in nexts if one.place != END][:WIDTH]
            done = sorted(done, key=lambda one: -one.likely)[:WIDTH]
            if len(done) == WIDTH:
                nexts = [(row, one) for row, one in nexts if one.likely > done[-1].likely]
            likeliest = max(one.likely for one in (*done[:1], *(one for _, one in nexts))) if nexts else 0.0
            nexts = [(row, one) for row, one in nexts if one.likely > likeliest + _FAINT]
            if not nexts:
                break
            rows = [row for row, _ in nexts]
            alive = [one for _, one in nexts]
            past = {name: each[rows] for name, each in zip(past, kept, strict=True)}
        return tuple(done)

    def _fed(self, alive: Sequence[_Begun], at: int) -> dict[str, NDArray[np.int64]]:
        n = len(alive)
        return {
            "tokens": np.array([max(one.token, 0) for one in alive], np.int64),
            "places": np.array([self._places[one.place] for one in alive], np.int64),
            "at": np.full(n, at, np.int64),
            "which": np.array([one.which for one in alive], np.int64),
        }

    def _allowed(self, place: str, amounts: Sequence[Found], width: int) -> NDArray[np.bool_]:
        """What the grammar allows after a place: tokens, and amounts of the text."""
        tokens, row = len(self._tokens), np.zeros(width, bool)
        row[:tokens] = self._follow[self._places[place]]
        for there in self._grammar.follow[place]:
            kinds = self._grammar.amounts.get(there, ())
            row[tokens : tokens + len(amounts)] |= np.array(
                [isinstance(found.amount, kinds) for found in amounts], bool
            )
            if there.endswith(COPIED) or not (after := self._grammar.follow[there]) or not after[0].endswith(COPIED):
                continue
            wanted = self._grammar.amounts[after[0]]
            if not any(isinstance(found.amount, wanted) for found in amounts):
                row[list(self._of[there])] = False  # nothing to copy
        return row

    def _on(self, one: _Begun, token: int, likely: float, read: Read) -> _Begun:
        tokens = len(self._tokens)
        if token < tokens:
            place = self._next[one.place, token]
            step = Step(place, self._tokens[token])
            return _Begun(place, token, -1, likely, (*one.steps, step), one.found, one.marks)
        place = next(there for there in self._grammar.follow[one.place] if there.endswith(COPIED))
        found = read.amounts[token - tokens]
        step = Step(place, None, found.amount)
        copied = (*one.found, (len(one.steps), found))
        return _Begun(place, 0, token - tokens, likely, (*one.steps, step), copied, one.marks)


def _likely(odds: Floats, allowed: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Logarithms of the probabilities of what is allowed next."""
    z = np.where(allowed, odds.astype(np.float64), _NEVER)
    z -= z.max(axis=1, keepdims=True)
    return np.where(allowed, z - np.log(np.exp(z).sum(axis=1, keepdims=True)), _NEVER)


def _spans(read: Read) -> tuple[Floats, NDArray[np.int64]]:
    """Of each amount the share of each piece, and its form; at least one of them."""
    share = np.zeros((1, max(1, len(read.amounts)), len(read.pieces)), np.float32)
    forms = np.zeros(share.shape[:2], np.int64)
    for k, (found, (low, high)) in enumerate(zip(read.amounts, read.spans, strict=True)):
        share[0, k, low:high] = 1 / (high - low)
        forms[0, k] = int(found.form)
    return share, forms


def _session(graph: bytes) -> Any:
    import onnxruntime

    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = options.inter_op_num_threads = 1
    options.enable_cpu_mem_arena = False
    options.log_severity_level = 4
    return onnxruntime.InferenceSession(graph, options, providers=["CPUExecutionProvider"])
