"""What a learner needs to go on after a kill: tensors and plain numbers in a file, and nothing that could run code."""

from __future__ import annotations

import io
import pickle
from collections.abc import Generator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import torch

from chatscene.errors import RunError
from chatscene.runs.atomic import write_bytes


def keep(path: Path, state: Mapping[str, Any]) -> None:
    """Write a learner's state."""
    sink = io.BytesIO()
    torch.save(dict(state), sink)
    write_bytes(path, sink.getvalue())


@contextmanager
def kept(path: Path) -> Generator[dict[str, Any]]:
    """What `keep` wrote, to be taken up inside.

    Raises:
        RunError: It is damaged, or does not fit the learner that takes it up.
    """
    try:
        yield torch.load(path, weights_only=True)
    except (OSError, RuntimeError, EOFError, KeyError, ValueError, pickle.UnpicklingError) as error:
        raise RunError(f"cannot read {path}: {error}; delete {path.parent} and fine-tune again") from error
