"""Egos from files: what they were trained to do, and nothing that a file may try to do besides."""

from __future__ import annotations

import contextlib
import json
import math
import zipfile
from functools import partial
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from chatscene.ego.asking import wanting
from chatscene.ego.files import SAFEBENCH_EVERY, load_file
from chatscene.ego.network import Network, NetworkEgo, load_network
from chatscene.ego.observation import ALLOWED, OBSERVATIONS
from chatscene.ego.policy import EgoPolicy, load_ego, observation_of, pedals_of, takes_speed
from chatscene.errors import EgoError
from places import SHARED

DATA = SHARED / "data" / "safebench"
quiet = pytest.mark.filterwarnings("ignore::DeprecationWarning", "ignore::FutureWarning", "ignore::UserWarning")


def network(sizes: tuple[int, ...] = (4, 8, 8, 2), **changes: Any) -> Network:
    rng = np.random.default_rng(1)
    layers = tuple(
        (rng.normal(size=(b, a)).astype(np.float32), rng.normal(size=b).astype(np.float32)) for a, b in pairwise(sizes)
    )
    return Network(layers=layers, **changes)


def observations(count: int = 20) -> np.ndarray[Any, np.dtype[np.float64]]:
    return np.random.default_rng(2).normal(size=(count, 4)) * np.array((1.0, 0.3, 4.0, 0.5))


@pytest.mark.parametrize("hidden", ["relu", "tanh"])
@pytest.mark.parametrize("output", ["tanh", "clip", "sigmoid"])
def test_a_network_computes_what_torch_computes(hidden: str, output: str) -> None:
    torch = pytest.importorskip("torch", reason="the extra 'train' is not installed")
    ours = network(hidden=hidden, output=output)
    activation = {"relu": torch.relu, "tanh": torch.tanh}[hidden]

    def squash(x: Any) -> Any:
        return {"tanh": x.tanh(), "clip": x.clamp(-1, 1), "sigmoid": 2 * x.sigmoid() - 1}[output]

    for observation in observations():
        x = torch.tensor(observation, dtype=torch.float32)
        for weights, bias in ours.layers[:-1]:
            x = activation(torch.from_numpy(weights) @ x + torch.from_numpy(bias))
        weights, bias = ours.layers[-1]
        expected = squash(torch.from_numpy(weights) @ x + torch.from_numpy(bias))
        assert ours(observation) == pytest.approx(expected.tolist(), abs=2e-6)


@pytest.mark.parametrize("hidden", ["relu", "tanh"])
@pytest.mark.parametrize("sizes", [(4, 256, 256, 2), (4, 1, 9, 7, 2), (80, 300, 2)])
def test_a_network_adds_one_product_after_the_other_whatever_the_machine(hidden: str, sizes: tuple[int, ...]) -> None:
    ours = network(sizes, hidden=hidden, output="clip")
    for observation in np.random.default_rng(3).normal(size=(3, sizes[0])):
        x = observation.astype(np.float32)
        for i, (weights, bias) in enumerate(ours.layers):
            if i:
                x = np.maximum(x, 0) if hidden == "relu" else np.array([math.tanh(v) for v in x.tolist()], np.float32)
            total = weights[:, 0] * x[0]
            for column in range(1, len(x)):
                total = total + weights[:, column] * x[column]
            x = total + bias
        assert ours(observation) == tuple(round(max(-1.0, min(1.0, value)), 6) for value in x.tolist())


def test_a_network_is_read_as_it_was_written(tmp_path: Path) -> None:
    ours = network(hidden="tanh", output="clip")
    path = tmp_path / "p.npz"
    path.write_bytes(ours.stored({"observation": "safebench", "seed": 3}))
    again, about = load_network(path)
    assert about == {"observation": "safebench", "seed": 3}
    assert (again.hidden, again.output) == ("tanh", "clip")
    assert all(again(o) == ours(o) for o in observations())
    assert load_ego(str(path)).act(observations(1)[0]) == ours(observations(1)[0])


def test_a_network_that_cannot_drive_is_refused() -> None:
    with pytest.raises(EgoError, match="3 numbers"):
        network((4, 8, 3))
    with pytest.raises(EgoError, match="not finite"):
        Network(layers=((np.full((2, 4), np.nan, np.float32), np.zeros(2, np.float32)),))
    with pytest.raises(EgoError, match="do not fit"):
        Network(layers=((np.zeros((2, 4), np.float32), np.zeros(3, np.float32)),))


def test_a_network_that_chooses_among_ways_is_kept_with_its_speed_and_refused_without(tmp_path: Path) -> None:
    path = tmp_path / "ways.npz"
    path.write_bytes(network((80, 8, 49), output="ways", at_most=6.5).stored({"observation": "actors"}))
    assert load_network(path)[0].at_most == 6.5
    for sizes, speed in (((80, 8, 49), 0.0), ((80, 8, 49), math.nan), ((80, 8, 49), math.inf), ((4, 8, 49), 6.0)):
        with pytest.raises(EgoError, match="chooses a way"):
            network(sizes, output="ways", at_most=speed)
    with pytest.raises(EgoError, match="a number for each way, 49, not with 2"):
        network((80, 8, 2), output="ways", at_most=6.0)


def test_an_ego_with_frame_skip_holds_its_action_and_forgets_it_at_a_reset() -> None:
    ego = NetworkEgo(network(), name="slow", every=3)
    first, other = observations(2)
    held = ego.act(first)
    assert [ego.act(other), ego.act(other)] == [held, held]
    decided = ego.act(other)
    assert decided != held
    ego.reset()
    assert ego.act(first) == held


@pytest.mark.parametrize("name", ["none.npz", "none.zip", "none.pt", "none.onnx"])
def test_a_missing_file_is_said_to_be_missing(name: str, tmp_path: Path) -> None:
    with pytest.raises(EgoError, match="there is no file"):
        load_ego(str(tmp_path / name))


@pytest.mark.parametrize("suffix", [".npz", ".zip", ".pt", ".onnx"])
def test_a_damaged_file_is_an_error_of_ours(suffix: str, tmp_path: Path) -> None:
    pytest.importorskip("torch", reason="the extra 'train' is not installed")
    path = tmp_path / f"damaged{suffix}"
    path.write_bytes(b"PK\x03\x04 this is not what it seems" * 10)
    with pytest.raises(EgoError, match="damaged"):
        load_file(path)


@pytest.mark.parametrize("flipped", range(12))
def test_flipped_bytes_in_a_network_are_an_error_of_ours_or_harmless(flipped: int, tmp_path: Path) -> None:
    content = bytearray(network((4, 2)).stored({}))
    for position in np.random.default_rng(flipped).integers(len(content), size=8).tolist():
        content[position] ^= 0xFF
    path = tmp_path / "flipped.npz"
    path.write_bytes(content)
    with contextlib.suppress(EgoError):
        load_file(path)


@pytest.mark.parametrize(
    ("about", "weights"),
    [
        ("[]", np.zeros((2, 4))),
        ("{}", np.zeros((2, 4))),
        ('{"hidden": "relu", "output": "tanh"}', np.array([["a"] * 4] * 2)),
        ('{"hidden": "relu", "output": "tanh"}', np.array(1.0)),
        ('{"hidden": "relu", "output": "tanh"}', np.full((2, 4), np.nan)),
        ('{"hidden": "relu", "output": "softmax"}', np.zeros((2, 4))),
    ],
)
def test_an_archive_that_holds_something_else_is_refused_by_name(
    about: str, weights: np.ndarray[Any, Any], tmp_path: Path
) -> None:
    np.savez(tmp_path / "other.npz", about=np.array(about), w0=weights, b0=np.zeros(2))
    with pytest.raises(EgoError, match=r"other\.npz"):
        load_file(tmp_path / "other.npz")


@pytest.mark.parametrize("change", ["no bias", "not finite", "not named", "alone"])
def test_a_checkpoint_without_a_sound_actor_is_refused_by_name(change: str, tmp_path: Path) -> None:
    torch = pytest.importorskip("torch", reason="the extra 'train' is not installed")
    state: dict[Any, Any] = {f"pi.{i}.weight": torch.ones(2, 4 if i == 0 else 2) for i in (0, 2, 4)}
    if change != "no bias":
        state |= {f"pi.{i}.bias": torch.full((2,), torch.nan) for i in (0, 2, 4)}
    if change == "not named":
        state = dict(enumerate(state.values()))
    torch.save(state if change == "alone" else (state, {}), tmp_path / "actor.pt")
    with pytest.raises(EgoError, match=r"actor\.pt"):
        load_file(tmp_path / "actor.pt")


@pytest.mark.parametrize("name", ["policy.txt", "policy.ZIP"])
def test_an_unknown_suffix_is_refused_with_the_known_ones(name: str, tmp_path: Path) -> None:
    (tmp_path / name).write_bytes(b"")
    with pytest.raises(EgoError, match=r"suffix.*\.npz, \.zip, \.pt, \.onnx"):
        load_file(tmp_path / name)


class _Exploit:
    """What unpickling would run."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def __reduce__(self) -> Any:
        return (Path.write_text, (self.path, "owned"))


def test_code_in_a_checkpoint_is_refused_and_not_run(tmp_path: Path) -> None:
    torch = pytest.importorskip("torch", reason="the extra 'train' is not installed")
    trace = tmp_path / "trace.txt"
    torch.save((_Exploit(trace), {}), tmp_path / "bad.pt")
    with pytest.raises(EgoError, match="only tensors are read"):
        load_file(tmp_path / "bad.pt")
    with zipfile.ZipFile(tmp_path / "bad.zip", "w") as archive:
        archive.writestr("data", json.dumps({}))
        archive.write(tmp_path / "bad.pt", "policy.pth")
    with pytest.raises(EgoError, match="only tensors are read"):
        load_file(tmp_path / "bad.zip")
    assert not trace.exists()


def stable_baselines_model(algorithm: str, *, actions: Any = None, sees: Any = None, **options: Any) -> Any:
    sb3 = pytest.importorskip("stable_baselines3", reason="the extra 'train' is not installed")
    import gymnasium

    class Still(gymnasium.Env[Any, Any]):
        observation_space = sees or gymnasium.spaces.Box(-100.0, 100.0, (4,), np.float32)
        action_space = actions or gymnasium.spaces.Box(-1.0, 1.0, (2,), np.float32)

    options = {"policy": "MlpPolicy", "policy_kwargs": {"net_arch": [8, 8]}, **options}
    return getattr(sb3, algorithm)(env=Still(), seed=5, device="cpu", **options)


@quiet
@pytest.mark.parametrize("algorithm", ["SAC", "TD3", "PPO"])
@pytest.mark.parametrize("choice", [{}, {"activation_fn": "Tanh"}, {"activation_fn": "ReLU"}, {"net_arch": []}])
def test_a_model_of_stable_baselines_acts_as_it_does_there(
    algorithm: str, choice: dict[str, Any], tmp_path: Path
) -> None:
    torch = pytest.importorskip("torch", reason="the extra 'train' is not installed")
    kwargs = {"net_arch": [8, 8], **choice}
    if "activation_fn" in choice:
        kwargs["activation_fn"] = getattr(torch.nn, choice["activation_fn"])
    model = stable_baselines_model(algorithm, policy_kwargs=kwargs)
    model.save(tmp_path / "model.zip")
    ego = load_file(tmp_path / "model.zip")
    for observation in observations():
        expected = model.predict(observation.astype(np.float32), deterministic=True)[0]
        assert ego.act(observation) == pytest.approx(expected.tolist(), abs=1e-5)


@quiet
def test_a_model_keeps_what_its_environment_showed_it_and_what_its_actions_meant(tmp_path: Path) -> None:
    pytest.importorskip("torch", reason="the extra 'train' is not installed")
    sb3 = pytest.importorskip("stable_baselines3", reason="the extra 'train' is not installed")
    gymnasium = pytest.importorskip("gymnasium", reason="the extra 'gym' is not installed")
    pytest.importorskip("chatscene.gym")  # which registers the environment

    asked = {"pedals": "full-brake", "ego_observation": "road"}
    env = gymnasium.make("chatscene/Drive-v0", **asked)
    sb3.PPO("MlpPolicy", env, policy_kwargs={"net_arch": [8]}, device="cpu").save(tmp_path / "model.zip")
    ego = load_file(tmp_path / "model.zip")
    assert (pedals_of(ego), observation_of(ego)) == ("full-brake", "road")
    stable_baselines_model("PPO").save(tmp_path / "other.zip")
    assert pedals_of(load_file(tmp_path / "other.zip")) == "safebench"


@quiet
@pytest.mark.parametrize(
    ("algorithm", "change", "says"),
    [
        ("PPO", "discrete", "Discrete.*two continuous ones"),
        ("SAC", "wide", r"between \[-3. -3.\] and \[3. 3.\].*RescaleAction"),
        ("PPO", "picture", r"shape \[2, 2\].*one row of numbers"),
        ("PPO", "parts", "Dict.*one row of numbers"),
        ("SAC", "leaky", "'leakyrelu' layers"),
        ("SAC", "partial", "layers of functools.partial"),
        ("PPO", "called", r"layers of <class '.*Tanh'>"),
        ("PPO", "extractor", r"weights beside those of its layers: features_extractor\.layer\.bias"),
        ("SAC", "extractor", r"weights beside those of its layers: actor\.features_extractor\.layer\.bias"),
        ("PPO", "scaling", "code of its own, .*Scaling"),
        ("SAC", "sde", "without use_sde"),
        ("DQN", "discrete", "fully connected layers with two continuous actions"),
    ],
)
def test_a_model_that_only_looks_like_an_ego_is_refused(algorithm: str, change: str, says: str, tmp_path: Path) -> None:
    torch = pytest.importorskip("torch", reason="the extra 'train' is not installed")
    spaces = pytest.importorskip("gymnasium", reason="the extra 'train' is not installed").spaces
    pair = spaces.Box(-1.0, 1.0, (2,), np.float32)
    options: dict[str, dict[str, Any]] = {
        "discrete": {"actions": spaces.Discrete(2)},
        "wide": {"actions": spaces.Box(-3.0, 3.0, (2,), np.float32)},
        "picture": {"sees": spaces.Box(-1.0, 1.0, (2, 2), np.float32)},
        "parts": {"sees": spaces.Dict({"a": pair, "b": pair}), "policy": "MultiInputPolicy"},
        "leaky": {"policy_kwargs": {"net_arch": [8], "activation_fn": torch.nn.LeakyReLU}},
        "sde": {"use_sde": True},
        "partial": {"policy_kwargs": {"net_arch": [8], "activation_fn": partial(torch.nn.LeakyReLU, 0.3)}},
        "called": {"policy_kwargs": {"net_arch": [8], "activation_fn": type("Tanh", (torch.nn.ReLU,), {})}},
    }
    if change in ("extractor", "scaling"):
        layers = pytest.importorskip("stable_baselines3.common.torch_layers")

        class Scaling(layers.BaseFeaturesExtractor):
            def __init__(self, space: Any) -> None:
                super().__init__(space, features_dim=4)
                if change == "extractor":
                    self.layer = torch.nn.Linear(4, 4)

            def forward(self, seen: Any) -> Any:
                return 0.5 * seen

        options[change] = {"policy_kwargs": {"net_arch": [8], "features_extractor_class": Scaling}}
    stable_baselines_model(algorithm, **options[change]).save(tmp_path / "model.zip")
    with pytest.raises(EgoError, match=f"model.zip.*{says}"):
        load_file(tmp_path / "model.zip")


@quiet
def test_a_policy_that_sees_something_else_is_refused_with_the_sizes(tmp_path: Path) -> None:
    (tmp_path / "p.npz").write_bytes(network((7, 8, 2)).stored({"observation": "safebench", "pedals": "safebench"}))
    with pytest.raises(EgoError, match=r"looks at 7 numbers; observations are safebench \(4\)"):
        load_file(tmp_path / "p.npz")


@quiet
def test_torchscript_and_onnx_act_as_the_network_they_were_made_from(tmp_path: Path) -> None:
    torch = pytest.importorskip("torch", reason="the extra 'train' is not installed")
    onnx = pytest.importorskip("onnx", reason="the extra 'onnx' is not installed")
    ours = network((4, 8, 2))
    (w0, b0), (w1, b1) = ours.layers
    module = torch.nn.Sequential(torch.nn.Linear(4, 8), torch.nn.ReLU(), torch.nn.Linear(8, 2), torch.nn.Tanh())
    with torch.no_grad():
        for layer, weights, bias in ((module[0], w0, b0), (module[2], w1, b1)):
            layer.weight.copy_(torch.from_numpy(weights))
            layer.bias.copy_(torch.from_numpy(bias))
    torch.jit.trace(module, torch.zeros(1, 4)).save(str(tmp_path / "p.pt"))
    helper = onnx.helper
    graph = helper.make_graph(
        [
            helper.make_node("Gemm", ["x", "w0", "b0"], ["h"], transB=1),
            helper.make_node("Relu", ["h"], ["r"]),
            helper.make_node("Gemm", ["r", "w1", "b1"], ["o"], transB=1),
            helper.make_node("Tanh", ["o"], ["y"]),
        ],
        "policy",
        [helper.make_tensor_value_info("x", onnx.TensorProto.FLOAT, [1, 4])],
        [helper.make_tensor_value_info("y", onnx.TensorProto.FLOAT, [1, 2])],
        [onnx.numpy_helper.from_array(a, n) for n, a in (("w0", w0), ("b0", b0), ("w1", w1), ("b1", b1))],
    )
    made = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 17)], ir_version=9)
    onnx.save(made, str(tmp_path / "p.onnx"))
    for name in ("p.pt", "p.onnx"):
        ego = load_file(tmp_path / name)
        for observation in observations(5):
            assert ego.act(observation) == pytest.approx(ours(observation), abs=3e-6)


@quiet
def test_a_torchscript_of_other_sizes_is_refused_with_both_sizes(tmp_path: Path) -> None:
    torch = pytest.importorskip("torch", reason="the extra 'train' is not installed")
    torch.jit.trace(torch.nn.Linear(10, 2), torch.zeros(1, 10)).save(str(tmp_path / "in.pt"))
    with pytest.raises(EgoError, match=r"takes 10 numbers; observations are safebench \(4\), .*traffic \(\d+\)$"):
        load_file(tmp_path / "in.pt")
    torch.jit.trace(torch.nn.Conv2d(3, 2, 3), torch.zeros(1, 3, 8, 8)).save(str(tmp_path / "image.pt"))
    with pytest.raises(EgoError, match=r"takes an input of shape \[2, 3, 3, 3\]; observations are"):
        load_file(tmp_path / "image.pt")
    torch.jit.trace(torch.nn.Linear(4, 3), torch.zeros(1, 4)).save(str(tmp_path / "out.pt"))
    with pytest.raises(EgoError, match=r"answers with 3 numbers, not with 2"):
        load_file(tmp_path / "out.pt")


def test_an_onnx_model_of_other_sizes_is_refused_with_both_sizes(tmp_path: Path) -> None:
    onnx = pytest.importorskip("onnx", reason="the extra 'onnx' is not installed")
    helper = onnx.helper
    for name, shape in (("row", [1, 10]), ("image", [1, 3, 8, 8])):
        node = helper.make_node("Tanh", ["x"], ["y"])
        ends = [[helper.make_tensor_value_info(end, onnx.TensorProto.FLOAT, shape)] for end in "xy"]
        graph = helper.make_graph([node], "policy", *ends)
        made = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 17)], ir_version=9)
        onnx.save(made, str(tmp_path / f"{name}.onnx"))
    with pytest.raises(EgoError, match=r"takes 10 numbers; observations are safebench \(4\), .*traffic \(\d+\)$"):
        load_file(tmp_path / "row.onnx")
    with pytest.raises(EgoError, match=r"takes an input of shape \[1, 3, 8, 8\]; observations are"):
        load_file(tmp_path / "image.onnx")


@quiet
def test_what_a_library_says_of_a_file_is_told_without_its_colours(tmp_path: Path) -> None:
    torch = pytest.importorskip("torch", reason="the extra 'train' is not installed")
    torch.save(torch.nn.Linear(4, 2), str(tmp_path / "whole.pt"))
    with pytest.raises(EgoError, match="cannot read weights from") as refused:
        load_file(tmp_path / "whole.pt")
    assert "\x1b" not in str(refused.value)
    assert "[1m" not in str(refused.value)


@pytest.mark.skipif(not DATA.is_dir(), reason="SafeBench's checkpoints are not beside this checkout")
@pytest.mark.parametrize("name", ["sac", "sac_0", "ppo_0", "td3_0"])
class TestSafeBenchCheckpoints:
    def ego(self, name: str) -> EgoPolicy:
        pytest.importorskip("torch", reason="the extra 'train' is not installed")
        return load_file(DATA / f"{name}.pt")

    def test_it_steers_back_to_its_route_from_both_sides(self, name: str) -> None:
        turned_left, turned_right = self.ego(name), self.ego(name)
        assert turned_left.act(np.array((0.0, 0.3, 6.0, 0.0)))[1] > 0.3
        assert turned_right.act(np.array((0.0, -0.3, 6.0, 0.0)))[1] < -0.3

    def test_it_sets_off_and_decides_at_every_fourth_step(self, name: str) -> None:
        ego = self.ego(name)
        first = ego.act(np.zeros(4))
        assert first[0] > 0.3
        elsewhere = np.array((1.0, 0.2, 8.0, 1.0))
        assert [ego.act(elsewhere) for _ in range(SAFEBENCH_EVERY - 1)] == [first] * (SAFEBENCH_EVERY - 1)
        assert ego.act(elsewhere) != first


@pytest.mark.parametrize("kind", ["Parameter", "bfloat16"])
def test_weights_of_another_kind_are_read_or_refused_in_words(kind: str, tmp_path: Path) -> None:
    torch = pytest.importorskip("torch", reason="the extra 'train' is not installed")
    make = torch.nn.Parameter if kind == "Parameter" else torch.Tensor.bfloat16
    state = {f"pi.{i}.{what}": make(torch.ones(*shape)) for i in (0, 2, 4) for what, shape in
             (("weight", (2, 4 if i == 0 else 2)), ("bias", (2,)))}  # fmt: skip
    torch.save((state, {}), tmp_path / "ego.pt")
    if kind == "Parameter":
        assert load_file(tmp_path / "ego.pt")
    else:
        with pytest.raises(EgoError, match="store them as float32"):
            load_file(tmp_path / "ego.pt")


def test_a_network_that_sees_how_fast_it_may_drive_is_shown_no_more_than_is_wanted(tmp_path: Path) -> None:
    path = tmp_path / "swift.npz"
    swift = network((OBSERVATIONS["traffic"], 8, 2), output="clip")
    path.write_bytes(swift.stored({"observation": "traffic", "pedals": "full-brake", "speed": 72.0}))
    ego = load_ego(str(path))
    assert takes_speed(ego)
    seen = np.random.default_rng(4).normal(size=OBSERVATIONS["traffic"])
    seen[ALLOWED] = 30.0
    for wanted, shown in ((None, 8.0), (12.0, 12.0), (20.0, 20.0), (25.0, 20.0)):  # it was trained for 20 m/s at most
        told = np.append(seen[:ALLOWED], shown)
        assert wanting(ego, wanted).act(seen) == swift(told)
    seen[ALLOWED] = 5.0
    assert wanting(ego, 12.0).act(seen) == swift(seen)


def test_a_network_that_does_not_see_how_fast_it_may_drive_is_told_no_speed() -> None:
    road = NetworkEgo(network((OBSERVATIONS["road"], 8, 2)), name="slow", observation="road")
    assert not takes_speed(road)
    assert wanting(road, 20.0) is road


@pytest.mark.parametrize("speed", ["fast", -3.0, math.nan, math.inf])
def test_a_network_that_was_trained_for_no_speed_that_there_is_is_refused(speed: float | str, tmp_path: Path) -> None:
    about: dict[str, float | str] = {"observation": "traffic", "speed": speed}
    (tmp_path / "odd.npz").write_bytes(network((OBSERVATIONS["traffic"], 8, 2)).stored(about))
    with pytest.raises(EgoError, match="odd was trained for a speed of"):
        load_ego(str(tmp_path / "odd.npz"))
