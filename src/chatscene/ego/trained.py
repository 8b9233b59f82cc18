"""The egos that ship with the package, trained here; `docs/lab/egos.md` has commands, seeds, curves and figures."""

from __future__ import annotations

from importlib.resources import as_file, files

from chatscene.ego.network import NetworkEgo, ego_of, load_network


def _load(name: str) -> NetworkEgo:
    with as_file(files("chatscene.ego").joinpath("weights", f"{name}.npz")) as path:
        network, about = load_network(path)
    return ego_of(network, about, name)


def sac() -> NetworkEgo:
    """Soft actor-critic, the default surrogate."""
    return _load("sac")


def ppo() -> NetworkEgo:
    """Proximal policy optimisation."""
    return _load("ppo")


def td3() -> NetworkEgo:
    """Twin delayed deep deterministic policy gradient."""
    return _load("td3")
