"""Fit how sure a reading is: what speaks for a sentence being served, weighed by likelihood.

    python benchmarks/confidence.py

Sentences that the classifier did not learn from: the packaged ones to fit with that are kept back, and the packaged
ones out of scope that nothing else learns from. Prints the weights (`retrieve.CONFIDENCE`) and, by five-fold
cross-validation, how many of either kind are refused below some confidences.
"""

from __future__ import annotations

import numpy as np
from scipy.optimize import minimize

from chatscene.grow.curation import FITTING, kept_back
from chatscene.interpret.decide import scenario_of
from chatscene.interpret.retrieve import CONFIDENCE, doubts, retrieve
from chatscene.library.load import load_library
from chatscene.models.encoders.embedding import load_embedder
from chatscene.settings import RetrievalSettings
from chatscene.studies.reading import load_sentences

RIDGE = 0.01


def main() -> None:
    sentences = [s for s in load_sentences(FITTING) if kept_back(s)] + list(load_sentences("out-of-scope"))
    library, embedder, anything = load_library(), load_embedder(), RetrievalSettings(refuse_below=0.0)
    rows = []
    for sentence in sentences:
        scenario = scenario_of(sentence.text)
        found = retrieve(scenario, library, embedder, anything)
        told = doubts(scenario, scenario.frame, found.behavior.snippet, library, embedder)
        rows.append([told[name] for name in CONFIDENCE])
    x, served = np.array(rows), np.array([s.in_scope for s in sentences], float)
    odds = np.empty(len(x))
    order = np.random.default_rng(0).permutation(len(x))
    for fold in range(5):
        left = order[fold::5]
        used = np.setdiff1d(order, left)
        odds[left] = x[left] @ fit(x[used], served[used])
    print("; ".join(f"{name} {weight:.2f}" for name, weight in zip(CONFIDENCE, fit(x, served), strict=True)))
    for below in (0.2, 0.3, 0.4, 0.5):
        refused = odds < np.log(below / (1 - below))
        rates = ", ".join(
            f"{np.mean(refused[these]):.3f} of {int(these.sum())} {what}"
            for what, these in (("in scope", served > 0), ("out of scope", served == 0))
        )
        print(f"below {below} refused, cross-validated: {rates}")


def fit(x: np.ndarray, served: np.ndarray) -> np.ndarray:
    weight = np.where(served > 0, 0.5 / served.sum(), 0.5 / (1 - served).sum())
    spread = x.std(axis=0)
    spread[0] = 0.0  # the base is not held back

    def loss(w: np.ndarray) -> tuple[float, np.ndarray]:
        z = x @ w
        p = 1 / (1 + np.exp(-z))
        told = weight @ (served * np.logaddexp(0, -z) + (1 - served) * np.logaddexp(0, z))
        held = RIDGE * w * spread**2
        return told + 0.5 * held @ w, x.T @ (weight * (p - served)) + held

    return minimize(loss, np.zeros(x.shape[1]), jac=True).x


if __name__ == "__main__":
    main()
