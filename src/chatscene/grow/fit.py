"""Train the slot classifier: MiniLM's upper layers and a head per slot, on sentences with what they say.

The encoder's words, positions and lower layers stay as they are, so that what is learned from a few hundred sentences
carries over to words they do not have. Needs the extra ``train``.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
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
from chatscene.terms.scenario import Slots

FROZEN = 3  # of the encoder's six layers
LONGEST = 128  # tokens of a sentence that are learned from
BATCH, ALIKE = 32, 16  # sentences of a step; steps whose sentences are sorted by length together
RATE, HEAD_RATE = 1e-4, 1e-3  # of AdamW, for the encoder and for the heads
WARM_UP = 0.05  # share of the steps
DROPOUT = 0.1

Array = NDArray[Any]
Told = Callable[[str, int, int], None]
Classes = Mapping[str, tuple[str, ...]]  # of each head


def fit(
    sentences: Sequence[Labelled],
    classes: Classes,
    *,
    epochs: int,
    seed: int,
    told: Told,
    onward: tuple[Member, Classes] | None = None,
) -> Member:
    """Train one member of a classifier.

    Args:
        sentences: What to learn from.
        classes: Of each head.
        epochs: How often each sentence is seen.
        seed: Of the order and the dropout.
        told: Of the steps done.
        onward: A member to begin with, and its classes; what it has no class for begins anew. None to begin with the
            encoder as it is.

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
    columns = [len(names) for names in classes.values()]
    model = Tuned(frozen=FROZEN, columns=columns, dropout=DROPOUT, changes=onward[0].changes if onward else None)
    if onward:
        for parameter, values in zip(model.heads(), _heads_of(*onward, classes), strict=True):
            parameter.data.copy_(torch.from_numpy(values))
    lower = model.lower([tokenize(plain(hear(s.text).told), LONGEST) for s in sentences])
    optimizer = torch.optim.AdamW(
        [{"params": model.upper.parameters(), "lr": RATE}, {"params": model.heads(), "lr": HEAD_RATE}]
    )
    steps = epochs * -(-len(sentences) // BATCH)
    rates = torch.optim.lr_scheduler.LambdaLR(optimizer, lambda step: _rate(step / steps))
    model.train()
    for step, rows in enumerate((rows for _ in range(epochs) for rows in batches([len(x) for x in lower], rng)), 1):
        odds = model([lower[i] for i in rows])
        loss = torch.zeros(())
        for head, z in zip(classes, odds, strict=True):
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


def _heads_of(member: Member, old: Classes, classes: Classes) -> tuple[Array, Array, Array]:
    """A member's queries, weights and biases, for other classes: those that it has by their names, the others zero."""
    rows = {head: row for row, head in enumerate(old)}
    at = {pair: i for i, pair in enumerate((head, name) for head, names in old.items() for name in names)}
    queries = np.zeros((len(classes), member.queries.shape[1]), np.float32)
    for row, head in enumerate(classes):
        if head in rows:
            queries[row] = member.queries[rows[head]]
    wanted = [at.get((head, name)) for head, names in classes.items() for name in names]
    weights = np.zeros((member.weights.shape[0], len(wanted)), np.float32)
    bias = np.zeros(len(wanted), np.float32)
    for column, found in enumerate(wanted):
        if found is not None:
            weights[:, column], bias[column] = member.weights[:, found], member.bias[found]
    return queries, weights, bias


def _rate(done: float) -> float:
    """Factor of the learning rate: up in a straight line, and down to nothing in another."""
    return min(1.0, done / WARM_UP) * max(0.0, 1.0 - done)


def _loss_of(torch: Any, head: str, odds: Any, right: Any) -> Any:
    """(N,) how unlikely what is right is: of several that are each there or not, or that it is one of some."""
    if head == "actions":
        return torch.nn.functional.binary_cross_entropy_with_logits(odds, right, reduction="none").sum(1)
    return -odds.log_softmax(1).masked_fill(right == 0, -1e4).logsumexp(1)


def batches(lengths: Sequence[int], rng: random.Random) -> list[list[int]]:
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
            target[row, right] = 1.0
    return target, known


# Trust in the patterns and the account

_ODDS, _FOUND, _SILENT = (0.3, 0.6, 1.0, 1.5), (0.0, 1.0, 2.0, 4.0, 8.0), (0.0, 1.0, 2.0, 4.0)
_TOLD, _UNTOLD = (0.0, 0.5, 1.0, 2.0, 4.0), (0.0, 0.5, 1.0, 2.0)
# Patterns know words of the field ("unprotected", "overtake") that few of the sentences written by hand have.
_LEAST = {"maneuver": 2.0, "control": 4.0, "position": 1.0}  # of what they found


@dataclass(frozen=True, slots=True)
class Unseen:
    """A sentence as a classifier sees it that did not learn from it.

    Attributes:
        sentence: With what it says.
        outright: What the patterns found.
        account: What was made out clause by clause; None where nothing was.
        odds: Log-odds of each class of each head.
    """

    sentence: Labelled
    outright: Slots
    account: Slots | None
    odds: Mapping[str, Array]


def unseen(classifier: SlotClassifier, sentences: Sequence[Labelled]) -> list[Unseen]:
    """Sentences as a classifier sees them that did not learn from them."""
    encoders = classifier.encoders()
    found: list[Unseen] = []
    for sentence in sentences:
        frame = hear(sentence.text)
        odds = classifier.log_odds([encoder.states(frame.told) for encoder in encoders])
        found.append(Unseen(sentence, frame.outright, frame.account.slots if frame.account else None, odds))
    return found


def trust_of(classes: Classes, rows: Sequence[Unseen]) -> dict[str, Trust]:
    """How much the patterns and the account count beside a classifier, per slot: the likeliest of a grid.

    Args:
        classes: Of each head.
        rows: Sentences that nobody learned from who says something of them.
    """
    sentences = [row.sentence for row in rows]
    trust: dict[str, Trust] = {}
    for head in TRUSTED:
        target, known = targets_of(head, classes[head], sentences)
        odds = np.stack([row.odds[head] for row in rows])
        marks = np.stack([rule_marks(head, classes[head], row.outright) for row in rows])
        account = np.stack([rule_marks(head, classes[head], row.account) for row in rows])
        silent, untold = ([-s for s in part] if head == "actions" else part for part in (_SILENT, _UNTOLD))
        found = [least for least in _FOUND if least >= _LEAST.get(head, 0.0)]
        grid = [Trust(*values) for values in product(_ODDS, found, silent, _TOLD, untold)]
        losses = [_loss(t.joined(odds, marks, account), target, known, one_of=head != "actions") for t in grid]
        trust[head] = grid[int(np.argmin(losses))] if known.any() else Trust()
    return trust


def _loss(z: Array, target: Array, known: Array, *, one_of: bool) -> float:
    if not one_of:
        return float((known[:, None] * (np.logaddexp(0, z) - target * z)).sum())
    z = z - z.max(axis=1, keepdims=True)
    return float(-(known[:, None] * target * (z - np.log(np.exp(z).sum(axis=1, keepdims=True)))).sum())
