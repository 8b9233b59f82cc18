"""The egos that ship with the package, trained here; `docs/lab/egos.md` has commands, seeds, curves and figures."""

from __future__ import annotations

from functools import cache
from importlib.resources import as_file, files
from typing import Any

from chatscene.ego.network import Network, NetworkEgo, ego_of, load_network


@cache
def _network(name: str) -> tuple[Network, dict[str, Any]]:
    """A network, read once for all egos of it: an evaluation makes one for each task."""
    with as_file(files("chatscene.ego").joinpath("weights", f"{name}.npz")) as path:
        return load_network(path)


def _load(name: str) -> NetworkEgo:
    return ego_of(*_network(name), name)


def sac() -> NetworkEgo:
    """Soft actor-critic, the default surrogate."""
    return _load("sac")


def ppo() -> NetworkEgo:
    """Proximal policy optimisation."""
    return _load("ppo")


def td3() -> NetworkEgo:
    """Twin delayed deep deterministic policy gradient."""
    return _load("td3")
