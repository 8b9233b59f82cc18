"""Small fully connected policies in numpy: what an ego from a file becomes once it is loaded.

What a network answers does not depend on the machine: products are added in float32 one after the other, in the order
of what is multiplied, with nothing fused, and `tanh` is the C library's of a double. No BLAS is asked, whose order is
nobody's promise. The native engine restates this, to the last bit.
"""

from __future__ import annotations

import io
import json
import math
import zipfile
import zlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chatscene.ego.observation import ALLOWED, OBSERVATIONS, USUAL, Observation
from chatscene.ego.planner import ACCELERATION, carried_out
from chatscene.errors import EgoError
from chatscene.files.bounded import MOST_BYTES, check_archive, parse_json

Weights = NDArray[np.float32]
DECIMALS = 6  # of an action: more means nothing to pedals and wheel
NARROW = 8  # outputs below which a layer's sums run along its rows; numpy would add a single column in pairs
HIDDEN = ("relu", "tanh")
OUTPUTS = ("tanh", "clip", "sigmoid", "ways")
# What numpy and zipfile raise for files with flipped or missing bytes, or with something else in them.
_DAMAGED = (
    OSError, ValueError, TypeError, KeyError, EOFError, MemoryError, RecursionError, NotImplementedError,
    zipfile.BadZipFile, zlib.error, OverflowError,
)  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Network:
    """A deterministic policy.

    Attributes:
        layers: For each layer its weights, (out, in), and bias, (out,), float32; the last has two outputs, or
            one for each way.
        hidden: What comes after each layer but the last: ``relu`` or ``tanh``.
        output: What comes after the last: ``tanh``; ``clip`` to [-1, 1]; ``sigmoid``, stretched to [-1, 1]; or
            ``ways``: of the planner's ways (`chatscene.ego.planner`) the one with the greatest number is carried out.
        at_most: The speed that ways do not exceed [m/s]; to one that sees ``traffic``, no more is shown to be allowed.
    """

    layers: tuple[tuple[Weights, Weights], ...]
    hidden: str = "relu"
    output: str = "tanh"
    at_most: float = 0.0
    _columns: tuple[Weights, ...] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        if self.hidden not in HIDDEN or self.output not in OUTPUTS:
            raise EgoError(
                f"a network cannot have {self.hidden!r} layers and {self.output!r} output; "
                f"known: {', '.join(HIDDEN)}; {', '.join(OUTPUTS)}"
            )
        if not self.layers:
            raise EgoError("a network needs at least one layer")
        width = self.layers[0][0].shape[-1]
        for weights, bias in self.layers:
            if weights.ndim != 2 or weights.shape[1] != width or bias.shape != weights.shape[:1]:
                raise EgoError(f"the layers of a network do not fit: {weights.shape} and {bias.shape} after {width}")
            if not (np.isfinite(weights).all() and np.isfinite(bias).all()):
                raise EgoError("a network has weights that are not finite; its training diverged")
            width = weights.shape[0]
        answers = len(ACCELERATION) if self.output == "ways" else 2
        if width != answers:
            meant = "a number for each way" if self.output == "ways" else "acceleration and steering"
            raise EgoError(f"a network must answer with {meant}, {answers}, not with {width} numbers")
        if self.output == "ways" and not 0.0 < self.at_most < math.inf:
            raise EgoError(f"a network that chooses a way needs a speed not to be exceeded, not {self.at_most}")
        looks = [OBSERVATIONS[name] for name in ("actors", "road", "traffic")]
        if self.output == "ways" and self.size not in looks:
            raise EgoError(f"a network that chooses a way looks at {looks} numbers, not {self.size}")
        object.__setattr__(self, "_columns", tuple(np.ascontiguousarray(weights.T) for weights, _ in self.layers))

    @property
    def size(self) -> int:
        """How many numbers it looks at."""
        return int(self.layers[0][0].shape[1])

    def __call__(self, observation: Observation, at_most: float | None = None) -> tuple[float, float]:
        """Acceleration and steering in [-1, 1]."""
        at_most = self.at_most if at_most is None else at_most
        x = observation.astype(np.float32)
        if at_most > 0.0:
            x[ALLOWED:] = np.minimum(x[ALLOWED:], np.float32(at_most))
        relu = self.hidden == "relu"
        for i, (weights, bias) in enumerate(self.layers):
            if i and relu:
                np.maximum(x, 0.0, out=x)
            elif i:
                x = np.array([math.tanh(value) for value in x.tolist()], np.float32)
            x = _summed(weights, self._columns[i], x)
            x += bias
        if self.output == "ways":
            return carried_out(observation, int(x.argmax()), at_most)
        first, second = x.tolist()
        return _squashed(first, self.output), _squashed(second, self.output)

    def stored(self, about: Mapping[str, str | float]) -> bytes:
        """The content of an ``.npz`` file, without pickles: weights and a description. `load_network` reads it."""
        arrays: dict[str, Any] = {
            f"{kind}{i}": array for i, layer in enumerate(self.layers) for kind, array in zip("wb", layer, strict=True)
        }
        sink = io.BytesIO()
        description = json.dumps({"hidden": self.hidden, "output": self.output, "at_most": self.at_most, **about})
        np.savez_compressed(sink, about=np.array(description), **arrays)
        return sink.getvalue()


def load_network(path: Path) -> tuple[Network, dict[str, Any]]:
    """A network and its description from an ``.npz`` file.

    Raises:
        EgoError: It is missing, damaged, or no network.
    """
    try:
        check_archive(path)
        with np.load(path, allow_pickle=False) as stored:
            about: dict[str, Any] = dict(parse_json(str(stored["about"])))
            hidden, output = str(about.pop("hidden")), str(about.pop("output"))
            at_most = float(about.pop("at_most", 0.0))  # files of before there were ways have none
            layers = tuple(
                (_float32(stored[f"w{i}"]), _float32(stored[f"b{i}"])) for i in range((len(stored.files) - 1) // 2)
            )
    except _DAMAGED as error:
        raise EgoError(f"cannot read a network from {path}: {error}; save or train it again") from error
    try:
        return Network(layers=layers, hidden=hidden, output=output, at_most=at_most), about
    except EgoError as error:
        raise EgoError(f"{path}: {error}") from error


def layers_of(state: Mapping[str, NDArray[Any]], names: Sequence[str]) -> tuple[tuple[Weights, Weights], ...]:
    """The layers of those names in a PyTorch state dict, as float32.

    Raises:
        EgoError: One of them is not there, or is not numbers.
    """
    try:
        pairs = [(state[f"{name}.weight"], state[f"{name}.bias"]) for name in names]
        count = sum(np.size(array) for pair in pairs for array in pair)
        if 4 * count > MOST_BYTES:  # a small file can hold many: a tensor may repeat one number without end
            raise EgoError(f"a network has {count} weights, and at most {MOST_BYTES // 4} are read")
        return tuple((_float32(weights), _float32(bias)) for weights, bias in pairs)
    except KeyError as error:
        raise EgoError(f"a network lacks the weights {error}; each layer needs weights and a bias") from error
    except (TypeError, ValueError) as error:
        raise EgoError(f"a network has weights that are not numbers: {error}") from error


def _float32(array: Any) -> Weights:
    with np.errstate(over="ignore"):  # what does not fit becomes infinite, and is refused as that
        return np.ascontiguousarray(array, dtype=np.float32)


def _summed(weights: Weights, columns: Weights, x: Weights) -> Weights:
    """The sums of products of a layer, (out,): each added in the order of the inputs."""
    if len(weights) < NARROW:
        return np.cumsum(weights * x, axis=1)[:, -1]
    if not x.all():  # most are zero after relu, and what they add is zero
        told = x.nonzero()[0]
        columns, x = columns[told], x[told]
    return np.add.reduce(columns * x[:, None], axis=0)  # row upon row, since the sum is not along the last axis


def _squashed(value: float, output: str) -> float:
    if output == "tanh":
        value = math.tanh(value)
    elif output == "sigmoid":
        value = math.tanh(0.5 * value)  # 2 / (1 + exp(-x)) - 1, without overflow
    return round(max(-1.0, min(1.0, value)), DECIMALS)


class NetworkEgo:
    """An ego that asks a network.

    Args:
        network: What decides.
        name: How it is called in tables.
        observation: What it looks at, a preset of `chatscene.ego.observation`.
        pedals: One of `chatscene.ego.policy.PEDALS`.
        every: It decides at each `every`-th step and holds the action in between (SafeBench's frame skip).
        trained_for: The speed that it was trained to drive at [m/s], and drives at most; 0 where none was said.
        wants: The speed that is wanted of it [m/s]; None where nothing is.

    Attributes:
        at_most: What it does not exceed [m/s] if it sees ``traffic`` or chooses among ways: what is wanted, else that
            of SafeBench or of the network.
    """

    def __init__(
        self,
        network: Network,
        *,
        name: str,
        observation: str = "safebench",
        pedals: str = "safebench",
        every: int = 1,
        trained_for: float = 0.0,
        wants: float | None = None,
    ) -> None:
        self.name = name
        self.observation = observation
        self.pedals = pedals
        self.network = network
        self.every = every
        self.trained_for = trained_for
        self.at_most = network.at_most
        if observation == "traffic":
            self.at_most = min(USUAL if wants is None else wants, trained_for or math.inf)
        self.reset()

    @property
    def wanting(self) -> Callable[[float], NetworkEgo] | None:
        """Gives the same ego with a wanted speed [m/s]; None of one that does not see how fast it may drive."""
        return self._wanting if self.observation == "traffic" else None

    def _wanting(self, speed: float) -> NetworkEgo:
        return NetworkEgo(
            self.network,
            name=self.name,
            observation=self.observation,
            pedals=self.pedals,
            every=self.every,
            trained_for=self.trained_for,
            wants=speed,
        )

    def reset(self) -> None:
        """Begin an episode."""
        self._left = 0
        self._held = (0.0, 0.0)

    def act(self, observation: Observation) -> tuple[float, float]:
        """Decide, or hold what was decided."""
        if self._left == 0:
            self._left = self.every
            self._held = self.network(observation, self.at_most)
        self._left -= 1
        return self._held


def ego_of(network: Network, about: Mapping[str, Any], name: str) -> NetworkEgo:
    """The ego of a network and its description (`load_network`).

    Raises:
        EgoError: The speed that it was trained for is none.
    """
    speed = about.get("speed", 0.0)
    if not isinstance(speed, float | int) or not 0.0 <= speed < math.inf:
        raise EgoError(f"the policy {name} was trained for a speed of {speed!r} km/h; a number from 0 on is one")
    observation, pedals = str(about.get("observation", "safebench")), str(about.get("pedals", "safebench"))
    return NetworkEgo(network, name=name, observation=observation, pedals=pedals, trained_for=speed / 3.6)
