"""What every encoder of texts owes; see `chatscene.models.encoders.embedding.Embedder`."""

from __future__ import annotations

import numpy as np

from chatscene.models.encoders.embedding import Embedder, load_embedder
from chatscene.testing.contract import require

_TEXTS = ("A pedestrian crosses.", "The oncoming car brakes hard.", "straße, naïve café — 信号 100km/h!")
_ODD = ("", " ", "car " * 3000, "信号灯前停车", "e\u0301\U0001f697\u200b\0\n", "x" * 5000, "half a \ud83d")


def check_encoder(encoder: str | Embedder) -> None:
    """Hold an encoder to the contract of all.

    Args:
        encoder: An encoder, or its name.

    Raises:
        ContractBroken: It breaks a rule; the message says which.
        SettingsError: There is none of that name, or its weights are missing or broken.
        MissingExtra: Its package is missing.
    """
    made = load_embedder(encoder) if isinstance(encoder, str) else encoder
    rows = made.encode(_TEXTS)
    require(rows.shape == (len(_TEXTS), made.dimension), "a text has a row of the dimension that is told", rows.shape)
    require(rows.dtype == np.float32, "rows are float32", rows.dtype)
    none = made.encode([])
    require(none.shape == (0, made.dimension), "no texts give no rows", none.shape)
    for text in (*_TEXTS, *_ODD):
        length = float(np.linalg.norm(made.encode([text])))
        require(abs(length - 1.0) < 1e-5, "any text has a row of length 1", (text[:20], length))
    together = made.encode([*_TEXTS, "car " * 100])
    for text, row in zip(_TEXTS, together, strict=False):
        alone = np.array_equal(made.encode([text])[0], row)
        require(alone, "a row does not depend on what stands beside its text", text)
    require(len(np.unique(rows, axis=0)) == len(_TEXTS), "different texts have different rows")
    named = made.name not in ("", made.identity)
    require(named, "an identity says more than the name: what the rows depend on", made.identity)
