"""The state of a learner: arrays and plain values, which come back as they were, and nothing that is unpickled."""

from __future__ import annotations

import pickle
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("torch", reason="the extra 'train' is not installed")

import torch

from chatscene.errors import RunError
from chatscene.learn.state import keep, kept


def test_a_state_comes_back_as_it_was(tmp_path: Path) -> None:
    layer = torch.nn.Linear(3, 2)
    optimizer = torch.optim.Adam(layer.parameters())
    layer(torch.ones(3)).sum().backward()
    optimizer.step()
    state: dict[str, Any] = {
        "optimizer": optimizer.state_dict(),
        "rows": np.arange(6, dtype=np.uint8).reshape(2, 3),
        "full": True,
    }
    keep(tmp_path / "state.npz", state)
    with kept(tmp_path / "state.npz") as found:
        assert found["full"] is True
        assert found["rows"].dtype == np.uint8
        assert np.array_equal(found["rows"], state["rows"])
        other = torch.optim.Adam(torch.nn.Linear(3, 2).parameters())
        other.load_state_dict(found["optimizer"])
    mine, theirs = optimizer.state_dict(), other.state_dict()
    assert mine["param_groups"] == theirs["param_groups"]
    for number, moments in mine["state"].items():
        assert all(torch.equal(value, theirs["state"][number][name]) for name, value in moments.items())


def test_the_same_state_is_the_same_file(tmp_path: Path) -> None:
    for name in ("a", "b"):
        keep(tmp_path / name, {"x": torch.arange(5), "y": [1.5, None, ("two", 3)]})
    assert (tmp_path / "a").read_bytes() == (tmp_path / "b").read_bytes()


class _Runs:
    def __reduce__(self) -> tuple[object, tuple[str]]:
        return pytest.fail, ("it was unpickled",)


def test_nothing_in_a_state_is_unpickled(tmp_path: Path) -> None:
    path = tmp_path / "state.npz"
    np.savez(path, tree=np.array([_Runs()], dtype=object))
    with pytest.raises(RunError, match="cannot read"), kept(path):
        pass
    path.write_bytes(pickle.dumps(_Runs()))
    with pytest.raises(RunError, match="cannot read"), kept(path):
        pass


def test_a_state_that_would_unpack_to_more_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "state.npz"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("tree.npy", bytes(1_000_000))
    with pytest.raises(RunError, match="it is compressed"), kept(path):
        pass


def test_a_state_of_before_is_named(tmp_path: Path) -> None:
    (tmp_path / "state.pt").write_bytes(b"")
    with (
        pytest.raises(RunError, match=r"state\.pt is of a version that kept states otherwise"),
        kept(tmp_path / "state.npz"),
    ):
        pass


def test_what_does_not_fit_whoever_takes_it_up_is_said_with_its_file(tmp_path: Path) -> None:
    keep(tmp_path / "state.npz", {"network": torch.nn.Linear(3, 2).state_dict()})
    with pytest.raises(RunError, match=r"cannot read .*state\.npz"), kept(tmp_path / "state.npz") as state:
        torch.nn.Linear(4, 2).load_state_dict(state["network"])
