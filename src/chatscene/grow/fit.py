"""Train the slot classifier: MiniLM's upper layers and a head per slot, on sentences with what they say.

The encoder's words, positions and lower layers stay as they are, so that what is learned from a few hundred sentences
carries over to words they do not have. Needs the extra ``train``.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chatscene.errors import MissingExtra
from chatscene.grow.compose_texts import Labelled
from chatscene.library.load import Library
from chatscene.models.encoders.embedding import plain
from chatscene.models.encoders.wordpiece import tokenize
from chatscene.read.decompose import hear
from chatscene.read.slot_classifier import (
    BEHAVIOR,
    HEADS,
    SCOPE,
    TRUSTED,
    Member,
    SlotClassifier,
    Trust,
    as_class,
    classes_of,
    rule_marks,
)

FROZEN = 3  # of the encoder's six layers
LONGEST = 128  # tokens of a sentence that are learned from
BATCH, ALIKE = 32, 16  # sentences of a step; steps whose sentences are sorted by length together
RATE, HEAD_RATE = 1e-4, 1e-3  # of AdamW, for the encoder and for the heads
WARM_UP = 0.05  # share of the steps
DROPOUT = 0.1

Array = NDArray[Any]
Told = Callable[[str, int, int], None]
Classes = Mapping[str, tuple[str, ...]]  # of each head


def fit(sentences: Sequence[Labelled], classes: Classes, *, epochs: int, seed: int, told: Told) -> Member:
    """Train one member of a classifier.

    Args:
        sentences: What to learn from.
        classes: Of each head.
        epochs: How often each sentence is seen.
        seed: Of the order and the dropout.
        told: Of the steps done.

    Raises:
        MissingExtra: torch or onnx is missing.
    """
    try:
        import torch

        from chatscene.grow.tuned_encoder import Tuned
    except ImportError as error:
        raise MissingExtra(f"training the slot classifier needs {error.name}", extra="train") from error
    rng = random.Random(seed)
    torch.manual_seed(seed)
    targets = {head: targets_of(head, names, sentences) for head, names in classes.items()}
    model = Tuned(frozen=FROZEN, columns=[len(names) for names in classes.values()], dropout=DROPOUT)
    lower = model.lower([tokenize(plain(s.text), LONGEST) for s in sentences])
    optimizer = torch.optim.AdamW(
        [{"params": model.upper.parameters(), "lr": RATE}, {"params": model.heads(), "lr": HEAD_RATE}]
    )
    steps = epochs * -(-len(sentences) // BATCH)
    rates = torch.optim.lr_scheduler.LambdaLR(optimizer, lambda step: _rate(step / steps))
    model.train()
    for step, rows in enumerate((rows for _ in range(epochs) for rows in _batches([len(x) for x in lower], rng)), 1):
        odds = model([lower[i] for i in rows])
        loss = torch.zeros(())
        for head, z in zip(HEADS, odds, strict=True):
            right, known = (torch.from_numpy(part[rows]) for part in targets[head])
            loss = loss + (known * _loss_of(torch, head, z, right)).mean()
        optimizer.zero_grad()
        loss.backward()
        torch.nn.utils.clip_grad_norm_(model.parameters(), 1.0)
        optimizer.step()
        rates.step()
        told("steps", step, steps)
    model.eval()
    return Member(
        changes=model.changes(),
        queries=model.queries.detach().numpy(),
        weights=model.weights.detach().numpy(),
        bias=model.bias.detach().numpy(),
    )


def heads_of(library: Library) -> Classes:
    """The classes of each head: the behaviors are the library's."""
    return {head: classes_of(head, [s.id for s in library if s.component.value == BEHAVIOR]) for head in HEADS}


def joined(members: Sequence[Member], classes: Classes, sentences: Sequence[Labelled]) -> SlotClassifier:
    """A classifier of some members, which counts the patterns beside them as far as they are right: `fit_trust`.

    Args:
        members: What was trained on the same classes.
        classes: Of each head.
        sentences: Written by hand; no member learned from them.
    """
    return fit_trust(SlotClassifier(tuple(members), classes, {head: Trust() for head in TRUSTED}), sentences)


def _rate(done: float) -> float:
    """Factor of the learning rate: up in a straight line, and down to nothing in another."""
    return min(1.0, done / WARM_UP) * max(0.0, 1.0 - done)


def _loss_of(torch: Any, head: str, odds: Any, right: Any) -> Any:
    """(N,) how unlikely what is right is: of one class, or of several that are each there or not."""
    if head == "actions":
        return torch.nn.functional.binary_cross_entropy_with_logits(odds, right, reduction="none").sum(1)
    return -(right * odds.log_softmax(1)).sum(1)


def _batches(lengths: Sequence[int], rng: random.Random) -> list[list[int]]:
    """Rows in random order, in batches whose texts are of similar length."""
    order = rng.sample(range(len(lengths)), len(lengths))
    span = BATCH * ALIKE
    chunks = [sorted(order[i : i + span], key=lambda row: lengths[row]) for i in range(0, len(order), span)]
    batches = [chunk[i : i + BATCH] for chunk in chunks for i in range(0, len(chunk), BATCH)]
    rng.shuffle(batches)
    return batches


def targets_of(head: str, classes: tuple[str, ...], sentences: Sequence[Labelled]) -> tuple[Array, Array]:
    """(N, classes) what is right, and (N,) whether it is known."""
    place = {name: i for i, name in enumerate(classes)}
    target = np.zeros((len(sentences), len(classes)), np.float32)
    known = np.ones(len(sentences), np.float32)
    for row, sentence in enumerate(sentences):
        if head == "actions":
            right = [place[action] for action in sentence.slots.actions]
        elif head == SCOPE:
            right = [place[str(sentence.in_scope)]]
        elif head == BEHAVIOR:
            right = [place[name] for name in sentence.behaviors if name in place]
        else:
            right = [place[as_class(getattr(sentence.slots, head))]]
        if head in sentence.open or (head == BEHAVIOR and not right):
            known[row] = 0.0
        elif right:
            target[row, right] = 1.0 if head == "actions" else 1.0 / len(right)
    return target, known


# Trust in the patterns

_ODDS, _FOUND, _SILENT = (0.3, 0.6, 1.0, 1.5), (0.0, 1.0, 2.0, 4.0, 8.0), (0.0, 1.0, 2.0, 4.0)
# Patterns know words of the field ("unprotected", "overtake") that few of the sentences written by hand have.
_LEAST = {"maneuver": 2.0, "control": 4.0, "position": 1.0}  # of what they found


def fit_trust(classifier: SlotClassifier, sentences: Sequence[Labelled]) -> SlotClassifier:
    """Find how much the patterns count beside the classifier: the likeliest of a grid.

    Args:
        classifier: One that did not learn from these sentences.
        sentences: Written by hand.
    """
    encoders = classifier.encoders()
    odds = [classifier.log_odds([encoder.states(s.text) for encoder in encoders]) for s in sentences]
    rules = [hear(s.text).outright for s in sentences]
    trust: dict[str, Trust] = {}
    for head in TRUSTED:
        classes = classifier.classes[head]
        target, known = targets_of(head, classes, sentences)
        rows = np.stack([each[head] for each in odds])
        marks = np.stack([rule_marks(head, classes, slots) for slots in rules])
        silent = [-s for s in _SILENT] if head == "actions" else _SILENT
        found = [least for least in _FOUND if least >= _LEAST.get(head, 0.0)]
        grid = [Trust(*values) for values in product(_ODDS, found, silent)]
        losses = [_loss(t.joined(rows, marks), target, known, one_of=head != "actions") for t in grid]
        trust[head] = grid[int(np.argmin(losses))] if known.any() else Trust()
    return replace(classifier, trust=trust)


def _loss(z: Array, target: Array, known: Array, *, one_of: bool) -> float:
    if not one_of:
        return float((known[:, None] * (np.logaddexp(0, z) - target * z)).sum())
    z = z - z.max(axis=1, keepdims=True)
    return float(-(known[:, None] * target * (z - np.log(np.exp(z).sum(axis=1, keepdims=True)))).sum())
