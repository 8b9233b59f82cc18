"""Fit how far a reading is trusted: what speaks for every fact of it being right, weighed by likelihood.

    python benchmarks/confidence.py LEFT_OUT TEXTS…

TEXTS, in the order in which the classifier learned from them, are read by the classifiers in LEFT_OUT that did not
(`chatscene library fit --left-out LEFT_OUT --texts …`); of the packaged sentences those held out, those out of scope,
and those to fit with that the classifier has not seen are read by itself. Prints the weights (`trust.ACCOUNT`,
`retrieve.CONFIDENCE`) and, by cross-validation over the styles of writing, how many texts of each set are served
rightly and wrongly at some thresholds, how well right is told from wrong, and the calibration error.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import click
import numpy as np
from labelled import auc

from chatscene.errors import ChatSceneError
from chatscene.grow.course import FOLDS, fold_of
from chatscene.grow.curation import FITTING, kept_back
from chatscene.interpret.decide import likeliest_together, understood
from chatscene.interpret.retrieve import CONFIDENCE, doubts, retrieve
from chatscene.interpret.trust import ACCOUNT, speaks_for_account
from chatscene.library.load import load_library
from chatscene.models.encoders.embedding import load_embedder
from chatscene.read.decompose import hear
from chatscene.read.reading import read
from chatscene.read.slot_classifier import believed_by, load_classifier
from chatscene.settings import RetrievalSettings
from chatscene.studies.facts import differing
from chatscene.studies.reading import Sentence, load_sentences
from chatscene.terms.frame import Frame

PARTS, RIDGE, BINS = 8, 1.0, 5
THRESHOLDS = (0.5, 0.6, 0.7)


@dataclass(frozen=True)
class Row:
    """What is weighed of one text, and whether either reading of it is right."""

    group: str
    style: str
    in_scope: bool
    whole: bool = False
    account: list[float] | None = None
    account_right: bool = False
    guess: list[float] | None = None
    guess_right: bool = False


def known(left_out: Path, texts: Sequence[Path]) -> Iterator[tuple[str, Sentence, Frame]]:
    """Group, sentence with its facts, and how it is read by who did not learn from it."""
    folds = [load_classifier(left_out / f"{fold}.npz") for fold in range(FOLDS)]
    encoders = [fold.encoders() for fold in folds]
    for i, path in enumerate(texts):
        for one in load_sentences(path):
            frame, fold = hear(one.text), fold_of(i)
            if not frame.whole:
                frame = replace(frame, beliefs=believed_by(folds[fold], encoders[fold], frame))
            yield path.stem, one, frame
    packaged = {name: load_sentences(name) for name in ("held-out", "out-of-scope")}
    packaged["kept back"] = tuple(one for one in load_sentences(FITTING) if kept_back(one))
    for name, sentences in packaged.items():
        for one in sentences:
            yield name, one, read(one.text)


def row_of(group: str, sentence: Sentence, frame: Frame) -> Row:
    library, embedder = load_library(), load_embedder()
    style, in_scope, said = sentence.style, sentence.in_scope, sentence.slots
    if frame.whole:
        return Row(group, style, in_scope, whole=True, account_right=in_scope and not differing(said, frame.outright))
    guess, account = likeliest_together(frame, RetrievalSettings()), frame.account
    told = list(speaks_for_account(frame, account, guess).values()) if account else None
    scenario = understood(frame, guess, frame.notes)
    try:
        found = retrieve(scenario, library, embedder, RetrievalSettings(refuse_below=0.0))
        against = list(doubts(scenario, frame, found.behavior.snippet, library, embedder).values())
    except ChatSceneError:
        against = None
    return Row(
        group,
        style,
        in_scope,
        account=told,
        account_right=bool(account) and in_scope and not differing(said, account.slots),
        guess=against,
        guess_right=in_scope and not differing(said, guess),
    )


def fit(x: np.ndarray, y: np.ndarray, weight: np.ndarray) -> np.ndarray:
    """Logistic regression of weighted rows, held back by the spread of each column but the first."""
    spread = x.std(axis=0)
    held = RIDGE * np.r_[0.0, np.where(spread > 0, spread, 1.0)[1:] ** 2]
    w = np.zeros(x.shape[1])
    for _ in range(60):
        p = 1 / (1 + np.exp(-x @ w))
        slope = x.T @ (weight * (p - y)) + held * w
        w -= np.linalg.solve((x.T * (weight * p * (1 - p))) @ x + np.diag(held + 1e-6), slope)
    return w


def balanced(groups: list[str]) -> np.ndarray:
    """The weight of each row: every group weighs the same, since our own sentences are many and much alike."""
    count = Counter(groups)
    return np.array([len(groups) / len(count) / count[group] for group in groups])


def cross_validated(x: np.ndarray, y: np.ndarray, styles: list[tuple[str, str]]) -> np.ndarray:
    """Probabilities of rows whose styles were left out of the fit."""
    order = sorted(set(styles))
    np.random.default_rng(0).shuffle(order)
    p, weight = np.zeros(len(x)), balanced([group for group, _ in styles])
    for fold in range(PARTS):
        left = {tuple(style) for style in order[fold::PARTS]}
        out = np.array([style in left for style in styles])
        p[out] = 1 / (1 + np.exp(-x[out] @ fit(x[~out], y[~out], weight[~out])))
    return p


@click.command()
@click.argument("left_out", type=click.Path(exists=True, file_okay=False, path_type=Path))
@click.argument("texts", nargs=-1, type=click.Path(exists=True, dir_okay=False, path_type=Path))
def main(left_out: Path, texts: tuple[Path, ...]) -> None:
    rows = [row_of(*one) for one in known(left_out, texts)]
    sure: dict[int, tuple[float, bool]] = {}
    weights = {}
    for what, names in (("guess", CONFIDENCE), ("account", ACCOUNT)):
        have = [(i, row) for i, row in enumerate(rows) if getattr(row, what) is not None]
        x = np.array([getattr(row, what) for _, row in have])
        y = np.array([getattr(row, f"{what}_right") for _, row in have], float)
        weights[what] = dict(zip(names, fit(x, y, balanced([row.group for _, row in have])), strict=True))
        for (i, row), p in zip(have, cross_validated(x, y, [(r.group, r.style) for _, r in have]), strict=True):
            if p >= sure.get(i, (0.0, False))[0]:  # the likelier of the two stands
                sure[i] = float(p), getattr(row, f"{what}_right")
    for what, found in weights.items():
        print(what, ", ".join(f'"{name}": {weight:.2f}' for name, weight in found.items()))
    p, y = np.array([one[0] for one in sure.values()]), np.array([one[1] for one in sure.values()], float)
    bins = np.minimum((p * BINS).astype(int), BINS - 1)
    error = sum(
        abs(p[bins == b].mean() - y[bins == b].mean()) * np.mean(bins == b) for b in range(BINS) if any(bins == b)
    )
    print(f"cross-validated: AUC {auc(list(sure.values())):.2f}, calibration error {error:.3f}")
    for threshold in THRESHOLDS:
        told = []
        for group in dict.fromkeys(row.group for row in rows):
            here = [(i, row) for i, row in enumerate(rows) if row.group == group]
            served = [row.account_right for _, row in here if row.whole]
            served += [sure[i][1] for i, _ in here if i in sure and sure[i][0] >= threshold]
            told.append(
                f"{group} {sum(served)} right, {len(served) - sum(served)} wrong of {sum(r.in_scope for _, r in here)}"
            )
        print(f"served from {threshold}: {'; '.join(told)}")


if __name__ == "__main__":
    main()
