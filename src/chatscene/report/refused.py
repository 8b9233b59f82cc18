"""Why a sentence was refused, for a script or a page: the reasons, what was read, what it may say, one that works."""

from __future__ import annotations

from typing import Any

from chatscene.errors import MeansSomethingElse, NothingFits


def suggested(text: str, embedder: str) -> str:
    """A sentence like one that was refused, and that is served."""
    from chatscene.interpret.suggest import suggestion
    from chatscene.models.encoders.embedding import load_embedder

    return suggestion(text, load_embedder(embedder))


def refusal(error: NothingFits | MeansSomethingElse, text: str, embedder: str) -> dict[str, Any]:
    """A refusal for a script."""
    fits = isinstance(error, NothingFits)
    readings = error.readings if fits else ()
    return {
        "text": text,
        "refused": type(error).__name__,
        "message": str(error),
        "reasons": list(error.reasons) if fits else [str(error)],
        "confidence": error.confidence if fits else None,
        "understood": error.understood if fits else "",
        "words": list(error.words) if fits else [],
        "readings": [one.as_dict() for one in readings],
        "candidates": error.nearest if fits else {},
        "suggestion": suggested(text, embedder) if text and not readings else None,
    }
