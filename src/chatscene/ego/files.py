"""Egos from files: our own networks, Stable-Baselines3, SafeBench v1, TorchScript, ONNX.

A checkpoint gives its weights and nothing else: nothing in it is unpickled, and of Stable-Baselines3's description
only what is plain text is read. Networks become numpy, so that torch is needed only while they are loaded.
"""

from __future__ import annotations

import io
import re
import zipfile
import zlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import IO, Any

import numpy as np

from chatscene.ego.network import Network, NetworkEgo, ego_of, layers_of, load_network
from chatscene.ego.observation import OBSERVATIONS, Observation
from chatscene.ego.policy import PEDALS, EgoPolicy
from chatscene.errors import EgoError, MissingExtra
from chatscene.files.bounded import check_archive, check_file, parse_json

State = Mapping[str, Any]
_NUMBER = re.compile(r"[-+]?\d+\.?\d*(?:e[-+]?\d+)?")  # as numpy prints it
_ESCAPES = re.compile(r"\x1b\[[0-9;?]*[A-Za-z]|[\x00-\x08\x0b-\x1f\x7f]")  # colours and the like
ONLY_LEARNS = ("critic", "actor_target.", "value_net.", "mlp_extractor.value_net.", "log_std", "actor.log_std")
"""How the weights begin that Stable-Baselines3 keeps beside those of the deterministic policy."""
OWN_EXTRACTOR = "<class 'stable_baselines3.common.torch_layers.FlattenExtractor'>"  # which leaves a row as it is
SAFEBENCH_EVERY = 4  # SafeBench v1 trained at a frame skip of 4: a decision each 0.4 s


def load_file(path: Path) -> EgoPolicy:
    """The ego in a file, by its suffix.

    Raises:
        EgoError: It is missing, damaged, or no policy that can be driven with.
        MissingExtra: It takes torch to read, which is not installed.
    """
    if not path.is_file():
        raise EgoError(f"there is no file {path}; give the path of a policy, or the name of an ego")
    if path.suffix not in _READERS:
        raise EgoError(f"cannot tell what {path} is from its suffix; egos are read from {', '.join(_READERS)}")
    try:
        check_file(path)
        return _READERS[path.suffix](path)
    except (MemoryError, OSError, RecursionError, ValueError) as error:
        raise EgoError(f"cannot read an ego from {path}: {_first_line(error) or type(error).__name__}") from error


def is_plain(path: Path) -> bool:
    """Whether a file's suffix and content are those of weights alone, which cannot carry code."""
    try:
        return path.is_file() and (
            path.suffix in (".npz", ".zip") or (path.suffix == ".pt" and not _carries_code(path))
        )
    except (OSError, ValueError):  # it cannot be read, or unpacks to too much
        return False


def _npz(path: Path) -> EgoPolicy:
    network, about = load_network(path)
    observation = str(about.get("observation", "safebench"))
    _check_size(network.size, path, observation)
    return ego_of(network, about, path.stem)


def _stable_baselines(path: Path) -> EgoPolicy:
    try:
        check_archive(path)
        with zipfile.ZipFile(path) as archive:
            about: dict[str, Any] = dict(parse_json(archive.read("data")))
            weights = archive.read("policy.pth")
    except (OSError, KeyError, ValueError, TypeError, NotImplementedError, zipfile.BadZipFile, zlib.error) as error:
        raise EgoError(f"{path} is not a model saved by Stable-Baselines3: {error}") from error
    state = _state(io.BytesIO(weights), path)
    names, output = _stable_baselines_layers(state, path)
    _check_spaces(about, path)
    choices = _fields(about, "policy_kwargs")
    if about.get("use_sde") and (output == "tanh" or choices.get("squash_output")):
        raise EgoError(f"{path} squashes state-dependent exploration, which is not read; train without use_sde")
    # PPO and A2C use tanh unless told otherwise, SAC, TD3 and DDPG relu; a choice is written out in plain text.
    default = "tanh" if output == "clip" else "relu"
    hidden = _activation(choices["activation_fn"], path) if "activation_fn" in choices else default
    _check_parts(about, choices, state, names, path)
    network = _network(state, names, path, hidden=hidden, output=output)
    marked = {
        key: str(_fields(about, space).get(key))
        for space, key in (("observation_space", "preset"), ("action_space", "pedals"))
        if key in _fields(about, space)
    }
    observation = _check_size(network.size, path, marked.get("preset"))
    pedals = marked.get("pedals", "safebench")
    if pedals not in PEDALS:
        raise EgoError(f"{path} says that its pedals are {pedals!r}; known: {', '.join(PEDALS)}")
    return NetworkEgo(network, name=path.stem, observation=observation, pedals=pedals)


def _activation(told: object, path: Path) -> str:
    """What comes after each layer, if it is one of torch's own."""
    found = re.fullmatch(r"<class 'torch\.nn\.modules\.activation\.(\w+)'>", str(told))
    if found is None:
        raise EgoError(
            f"{path} has layers of {str(told)[:200]}; of activations, only ReLU and Tanh of torch.nn are read; wrap "
            "the policy in a module and give package.module:factory"
        )
    return found[1].lower()


def _check_parts(
    about: Mapping[str, Any], choices: Mapping[str, Any], state: State, names: Sequence[str], path: Path
) -> None:
    """Refuse a policy that does more than its layers do, which would be left out."""
    read = {f"{name}.{part}" for name in names for part in ("weight", "bias")}
    more = [key for key in sorted(map(str, state)) if key not in read and not key.startswith(ONLY_LEARNS)]
    if more:
        raise EgoError(
            f"{path} holds weights beside those of its layers: {', '.join(more[:4])}; a policy with a features "
            "extractor or other parts of its own is not read; wrap it in a module and give package.module:factory"
        )
    extractor = str(choices.get("features_extractor_class", OWN_EXTRACTOR))
    policy = str(_fields(about, "policy_class").get("__module__", "stable_baselines3."))
    if extractor != OWN_EXTRACTOR or not policy.startswith("stable_baselines3."):
        own = extractor if extractor != OWN_EXTRACTOR else f"a policy of {policy}"
        raise EgoError(f"{path} has code of its own, {own}; wrap it in a module and give package.module:factory")


def _check_spaces(about: Mapping[str, Any], path: Path) -> None:
    """Refuse what looks like an ego by the shapes of its weights and is none by its spaces."""
    sees, acts = _fields(about, "observation_space"), _fields(about, "action_space")
    shape = sees.get("_shape")
    row = not shape or (isinstance(shape, list) and len(shape) == 1)
    if not all("Box" in str(space.get(":type:")) for space in (sees, acts)) or not row:
        raise EgoError(
            f"{path} sees {sees.get(':type:')} of shape {shape} and acts in {acts.get(':type:')}; "
            "an ego sees one row of numbers and answers with two continuous ones"
        )
    ends = [{float(number) for number in _NUMBER.findall(str(acts.get(end)))} for end in ("low", "high")]
    if ends != [{-1.0}, {1.0}]:
        raise EgoError(
            f"{path} acts between {acts.get('low')} and {acts.get('high')}, an ego in [-1, 1]; "
            "train it with gymnasium's RescaleAction around the environment"
        )


def _fields(about: Mapping[str, Any], key: str) -> dict[str, Any]:
    """What is plain text of an object that was pickled."""
    value = about.get(key)
    return value if isinstance(value, dict) else {}


def _stable_baselines_layers(state: State, path: Path) -> tuple[list[str], str]:
    """The layers of the deterministic policy, by name and in order, and what follows them."""
    for stem, last, output in (
        ("actor.latent_pi.", "actor.mu", "tanh"),
        ("mlp_extractor.policy_net.", "action_net", "clip"),
        ("actor.mu.", None, "tanh"),
    ):
        numbered = re.compile(re.escape(stem) + r"(\d+)\.weight")
        found = sorted(int(match[1]) for key in state if (match := numbered.fullmatch(key)))
        if f"{last}.weight" in state or (last is None and found):
            return [*(f"{stem}{number}" for number in found), *([last] if last else [])], output
    raise EgoError(
        f"{path} holds no policy of fully connected layers with two continuous actions "
        f"(its weights: {', '.join(sorted(state)[:6])}, ...); wrap it in a module and give package.module:factory"
    )


def _torch(path: Path) -> EgoPolicy:
    """TorchScript, which carries its code, or a checkpoint of SafeBench v1."""
    return _torchscript(path) if _carries_code(path) else _safebench(path)


def _carries_code(source: Path | IO[bytes]) -> bool:
    """Whether a file of PyTorch is TorchScript, which torch would run; either kind of file must be of sound size."""
    if not zipfile.is_zipfile(source):
        return False  # older checkpoints are no archives; torch says what is wrong with a damaged one
    try:
        return any("/code/" in name or name.endswith("/constants.pkl") for name in check_archive(source))
    except (NotImplementedError, zipfile.BadZipFile):
        return False


def _torchscript(path: Path) -> EgoPolicy:
    torch = _import_torch()
    try:
        module = torch.jit.load(str(path), map_location="cpu").eval()
    except (RuntimeError, ValueError) as error:
        raise EgoError(f"cannot read TorchScript from {path}: {_first_line(error)}") from error

    def ask(observation: np.ndarray[Any, Any]) -> Any:
        with torch.no_grad():
            return module(torch.from_numpy(observation)).numpy()

    first = next((one.shape for name, one in module.named_parameters() if name.endswith("weight")), ())
    return _asked(ask, path, _wanted(first))


def _wanted(shape: Sequence[Any]) -> str:
    """What a model takes, by the shape of its input or of its first layer; empty if it may be an observation."""
    if len(shape) != 2 or not isinstance(shape[1], int):
        return f"an input of shape {list(shape)}" if len(shape) > 2 else ""
    return "" if shape[1] in OBSERVATIONS.values() else f"{shape[1]} numbers"


def _onnx(path: Path) -> EgoPolicy:
    import onnxruntime

    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = options.inter_op_num_threads = 1
    try:
        session = onnxruntime.InferenceSession(str(path), options, providers=["CPUExecutionProvider"])
    except Exception as error:
        raise EgoError(f"cannot read an ONNX model from {path}: {_first_line(error)}") from error
    inputs = session.get_inputs()
    if len(inputs) != 1:
        raise EgoError(f"the model in {path} wants {len(inputs)} inputs; an ego sees one row of numbers")
    name, shape = inputs[0].name, inputs[0].shape

    def ask(observation: np.ndarray[Any, Any]) -> Any:
        return session.run(None, {name: observation})[0]

    return _asked(ask, path, _wanted(shape))


class _Asked:
    """An ego that asks a model of its own kind, one observation at a time."""

    pedals = "safebench"

    def __init__(self, ask: Callable[[np.ndarray[Any, Any]], Any], name: str, observation: str) -> None:
        self.name = name
        self.observation = observation
        self._ask = ask

    def act(self, observation: Observation) -> tuple[float, float]:
        answer = np.asarray(self._ask(observation.astype(np.float32)[None]), dtype=float).ravel()
        if answer.shape != (2,):
            raise EgoError(
                f"the model {self.name!r} answers with {answer.size} numbers, not with 2, acceleration and steering"
            )
        first, second = answer.tolist()
        return round(first, 6), round(second, 6)


def _asked(ask: Callable[[np.ndarray[Any, Any]], Any], path: Path, wants: str) -> EgoPolicy:
    """The ego of a model, whose preset is found by trying which size of input it takes."""
    problems: list[str] = []
    for observation, size in OBSERVATIONS.items():
        ego = _Asked(ask, path.stem, observation)
        try:
            answer = ego.act(np.zeros(size))
        except EgoError:
            raise
        except Exception as error:  # noqa: BLE001 - whatever a stranger's model raises for a wrong size
            problems.append(f"{observation} ({size}): {_first_line(error)}")
        else:
            if not np.isfinite(answer).all():
                raise EgoError(f"the model in {path} answers {answer} to zeros; its training diverged")
            return ego
    if wants:
        raise EgoError(f"the model in {path} takes {wants}; observations are {_sizes()}")
    raise EgoError(f"the model in {path} takes none of the observations: {'; '.join(problems)}")


def _safebench(path: Path) -> EgoPolicy:
    """A checkpoint of SafeBench v1: a pair of state dicts, of the actor and of the critic.

    The sign of its steering is that of its environment, which negates it; ours does not (decision 0015).
    """
    stored = _state(path, path)
    if not (isinstance(stored, tuple) and stored and isinstance(stored[0], Mapping)):
        raise EgoError(f"{path} is neither TorchScript nor a checkpoint of SafeBench v1 (actor and critic)")
    actor: State = stored[0]
    for names, output in (
        (("net.0", "net.2", "mu_layer"), "tanh"),  # SAC
        (("pi.0", "pi.2", "pi.4"), "tanh"),  # TD3
        (("mu_net.0", "mu_net.2", "mu_net.4"), "sigmoid"),  # PPO
    ):
        if all(f"{name}.weight" in actor for name in names):
            network = _network(actor, names, path, hidden="relu", output=output)
            weights, bias = network.layers[-1]
            signs = np.array((1.0, -1.0), np.float32)
            turned = (weights * signs[:, None], bias * signs)
            network = replace(network, layers=(*network.layers[:-1], turned))
            observation = _check_size(network.size, path)
            return NetworkEgo(network, name=path.stem, observation=observation, every=SAFEBENCH_EVERY)
    raise EgoError(f"{path}: no actor of SafeBench v1 has the weights {', '.join(sorted(map(str, actor))[:6])}")


def _network(state: State, names: Sequence[str], path: Path, *, hidden: str, output: str) -> Network:
    try:
        return Network(layers=layers_of(state, names), hidden=hidden, output=output)
    except EgoError as error:
        raise EgoError(f"{path}: {error}") from error


def _check_size(size: int, path: Path, observation: str | None = None) -> str:
    """The preset of observations of that size."""
    for name, numbers in OBSERVATIONS.items():
        if numbers == size and observation in (None, name):
            return name
    raise EgoError(f"the policy in {path} looks at {size} numbers; observations are {_sizes()}")


def _sizes() -> str:
    return ", ".join(f"{name} ({numbers})" for name, numbers in OBSERVATIONS.items())


def _state(source: Path | IO[bytes], path: Path) -> Any:
    """What a file of PyTorch holds, tensors as arrays; anything that would run code is refused."""
    import pickle

    torch = _import_torch()
    if _carries_code(source):
        raise EgoError(f"cannot read weights from {path}: it holds TorchScript, which is code; only tensors are read")
    if not isinstance(source, Path):
        source.seek(0)
    try:
        stored = torch.load(source, map_location="cpu", weights_only=True)
    except (pickle.UnpicklingError, RuntimeError, EOFError, OSError, ValueError, KeyError) as error:
        raise EgoError(f"cannot read weights from {path}: {_first_line(error)}; only tensors are read") from error

    def plain(value: Any) -> Any:
        if isinstance(value, torch.Tensor):
            return value.detach().numpy()
        if isinstance(value, Mapping):
            return {key: plain(item) for key, item in value.items()}
        return tuple(plain(item) for item in value) if isinstance(value, list | tuple) else value

    try:
        return plain(stored)
    except (TypeError, RuntimeError) as error:  # numbers that numpy has not, or no numbers at all
        raise EgoError(f"cannot read weights from {path}: {_first_line(error)}; store them as float32") from error


def _import_torch() -> Any:
    try:
        import torch
    except ImportError as error:
        raise MissingExtra("reading this policy needs torch", extra="train") from error
    return torch


def _first_line(error: Exception) -> str:
    """The first line of what a library says, without its commands to the terminal."""
    return _ESCAPES.sub("", str(error)).strip().partition("\n")[0][:200]


_READERS: dict[str, Callable[[Path], EgoPolicy]] = {
    ".npz": _npz,
    ".zip": _stable_baselines,
    ".pt": _torch,
    ".onnx": _onnx,
}
