"""What a learner needs to go on after a kill: arrays and plain values in an ``.npz`` file. Nothing is unpickled.

The file holds each array by its number, and ``tree``, JSON that says where each belongs.
"""

from __future__ import annotations

import io
import json
from collections.abc import Generator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any, cast
from zipfile import ZIP_STORED, BadZipFile, ZipFile

import numpy as np
import torch

from chatscene.errors import ChatSceneError, RunError
from chatscene.files.bounded import parse_json
from chatscene.runs.atomic import write_bytes

_DOES_NOT_FIT = (
    *(OSError, RuntimeError, EOFError, LookupError, AttributeError, TypeError, ValueError, MemoryError),
    *(BadZipFile, ChatSceneError),
)


def keep(path: Path, state: Mapping[str, Any]) -> None:
    """Write a learner's state: mappings, lists and tuples of tensors, arrays and plain values."""
    arrays: list[Any] = []
    tree = np.array(json.dumps(_packed(state, arrays)))
    sink = io.BytesIO()
    np.savez(sink, tree=tree, **{f"{i}": array for i, array in enumerate(arrays)})
    write_bytes(path, sink.getvalue())


@contextmanager
def kept(path: Path) -> Generator[dict[str, Any]]:
    """What `keep` wrote, to be taken up inside.

    Raises:
        RunError: It is damaged, or does not fit the learner that takes it up.
    """
    try:
        if not path.exists() and (before := path.with_suffix(".pt")).exists():
            raise RunError(f"{before.name} is of a version that kept states otherwise, and is not read any more")
        with ZipFile(path) as archive:
            if any(info.compress_type != ZIP_STORED for info in archive.infolist()):
                raise ValueError("it is compressed, which no state is that was kept here")  # nor unpacks to more
        with np.load(path, allow_pickle=False) as stored:
            state = _unpacked(parse_json(str(stored["tree"])), stored)
        yield state
    except _DOES_NOT_FIT as error:
        raise RunError(f"cannot read {path}: {error}; delete {path.parent} and begin again") from error


def _packed(value: Any, arrays: list[Any]) -> Any:
    """A value as JSON has it; arrays are put aside."""
    if isinstance(value, torch.Tensor | np.ndarray):
        arrays.append(value.numpy() if isinstance(value, torch.Tensor) else value)
        return {"tensor" if isinstance(value, torch.Tensor) else "array": len(arrays) - 1}
    if isinstance(value, Mapping):
        pairs = cast("Mapping[Any, Any]", value).items()
        return {"map": [[key, _packed(one, arrays)] for key, one in pairs]}  # optimizers have numbers for keys
    if isinstance(value, list | tuple):
        several = cast("list[Any]", value)
        return {"list" if isinstance(value, list) else "tuple": [_packed(one, arrays) for one in several]}
    return value


def _unpacked(value: Any, arrays: Any) -> Any:
    match value:
        case {"tensor": number}:
            return torch.from_numpy(arrays[f"{number}"])
        case {"array": number}:
            return arrays[f"{number}"]
        case {"map": pairs}:
            return {key: _unpacked(one, arrays) for key, one in pairs}
        case {"list": several}:
            return [_unpacked(one, arrays) for one in several]
        case {"tuple": several}:
            return tuple(_unpacked(one, arrays) for one in several)
        case _:
            return value
