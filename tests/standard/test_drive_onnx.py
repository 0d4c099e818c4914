"""Policy networks that drive: the same as in an environment, and checked before they do."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Any

import numpy as np
import onnx
import pytest
from onnx import TensorProto, helper, numpy_helper

import roadlang
from roadlang import testing
from roadlang.cli.main import run
from roadlang.envs import SceneEnv

FEATURES = 19
SCENE = """
road main { draw with waypoints { points: [(0m, 0m), (60m, 10m), (120m, 0m)] }, width: 8m }
agent ego is car on main at 5m { drive with onnx { model: "policy.onnx", agents: 0 } }
expect near: always (abs(ego.cross_track_error) < 2m)
"""


def network(
    path: Path, weights: np.ndarray[Any, Any] | None = None, *, inputs: int = FEATURES
) -> np.ndarray[Any, Any]:
    """A linear policy in a file, and its weights (F + 1, 2)."""
    if weights is None:
        weights = np.zeros((inputs + 1, 2))
        weights[0, 1], weights[-1, 1] = -0.2, 1.0  # 5 m/s
        weights[min(12, inputs), 0] = 0.15  # path_left_10m
    outputs = weights.shape[1]
    graph = helper.make_graph(
        [helper.make_node("Gemm", ["seen", "weights", "bias"], ["action"])],
        "policy",
        [helper.make_tensor_value_info("seen", TensorProto.FLOAT, ["batch", inputs])],
        [helper.make_tensor_value_info("action", TensorProto.FLOAT, ["batch", outputs])],
        [
            numpy_helper.from_array(weights[:-1].astype(np.float32), "weights"),
            numpy_helper.from_array(weights[-1].astype(np.float32), "bias"),
        ],
    )
    opset = [helper.make_opsetid("", 17)]
    onnx.save(helper.make_model(graph, opset_imports=opset, ir_version=8), path)
    return weights


def test_a_policy_drives(tmp_path: Path) -> None:
    network(tmp_path / "policy.onnx")
    scenes = testing.sample(SCENE, 2, folder=tmp_path)
    drive = scenes.run("builtin", duration=10.0)[0]
    assert drive.verdicts["near"].satisfied
    assert drive.trace.agents["ego"].speed[-1] == pytest.approx(5.0, abs=0.5)


@pytest.mark.parametrize("kind", ["car", "bus", "motorcycle"])
def test_it_drives_as_in_an_environment(kind: str, tmp_path: Path) -> None:
    """Whatever can steer farther than others does so at the same output."""
    weights = network(tmp_path / "policy.onnx")
    scenes = testing.sample(SCENE.replace("is car", f"is {kind}"), 1, folder=tmp_path)
    steps = {"control_step": 0.1, "vehicle_step": 0.05, "step": 0.1, "duration": 4.0}
    ego = scenes.run("builtin", **steps)[0].trace.agents["ego"]
    env = SceneEnv(list(scenes), agents=0)
    assert len(env.names) == FEATURES
    seen, _ = env.reset(seed=0)
    for step in range(1, 41):
        action = seen.astype(np.float64) @ weights[:-1] + weights[-1]
        seen, *_ = env.step(np.clip(action, -1.0, 1.0).astype(np.float32))
        assert seen[0] == pytest.approx(ego.speed[step], abs=1e-5)
        assert seen[4] == pytest.approx(ego.cross_track_error[step], abs=1e-5)


def test_the_option_sets_the_angle_for_an_output_of_one(tmp_path: Path) -> None:
    weights = np.zeros((FEATURES + 1, 2))
    weights[-1] = 1.0, 0.2
    network(tmp_path / "policy.onnx", weights)
    text = SCENE.replace("agents: 0", "agents: 0, steering: 5deg")
    (drive,) = testing.sample(text, 1, folder=tmp_path).run("builtin", duration=2.0)
    assert np.degrees(drive.trace.agents["ego"].steering[-1]) == pytest.approx(5.0, abs=0.01)


def test_the_digest_of_the_network_is_in_the_manifest(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    network(tmp_path / "policy.onnx")
    (tmp_path / "scene.rl").write_text(SCENE)
    assert run(["compile", "scene.rl", "-o", "out", "--emit", "json"]) == 0
    inputs = json.loads((tmp_path / "out" / "manifest.json").read_text())["inputs"]
    digest = hashlib.sha256((tmp_path / "policy.onnx").read_bytes()).hexdigest()
    assert digest in inputs.values()


@pytest.mark.parametrize(
    ("made", "reason"),
    [
        (lambda path: path.write_bytes(b"no network"), "it cannot be loaded"),
        (lambda path: network(path, inputs=7), r"not float32 (1, 19)"),
        (lambda path: network(path, inputs=29), "the network fits with `agents: 2`"),
        (lambda path: network(path, np.zeros((FEATURES + 1, 3))), r"not (1, 2)"),
        (lambda path: network(path, np.full((FEATURES + 1, 2), np.nan)), "is not finite"),
    ],
)
def test_what_is_wrong_with_a_network(tmp_path: Path, made: Any, reason: str) -> None:
    made(tmp_path / "policy.onnx")
    scenes = testing.sample(SCENE, 1, folder=tmp_path)
    with pytest.raises(roadlang.DiagnosticError) as found:
        scenes.run("builtin", duration=1.0)
    assert "error[RL741]" in str(found.value)
    assert "drive with onnx" in str(found.value)
    assert reason in str(found.value)


def test_a_damaged_network_gives_no_more_than_the_error(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    """onnxruntime shows a banner where it tries again."""
    path = tmp_path / "policy.onnx"
    network(path)
    path.write_bytes(path.read_bytes().replace(b"Gemm", b"Ge\x9bm"))
    with pytest.raises(roadlang.DiagnosticError, match="it cannot be loaded"):
        testing.sample(SCENE, 1, folder=tmp_path).run("builtin", duration=1.0)
    assert capfd.readouterr() == ("", "")


def seeing(path: Path, reading: str, shape: list[int]) -> None:
    """A network that brakes by 0.05 for each meter that a ray reads less than 40 m."""
    values = [
        numpy_helper.from_array(np.array([[-1]], np.int64).ravel(), "flat"),
        numpy_helper.from_array(np.array([[0.0, 0.05]], np.float32), "gain"),
        numpy_helper.from_array(np.array([[0.0, -2.0]], np.float32), "offset"),
        numpy_helper.from_array(np.zeros((FEATURES, 2), np.float32), "none"),
    ]
    nodes = [
        helper.make_node("ReduceMin", ["rays"], ["least"], keepdims=1, axes=[1]),
        helper.make_node("MatMul", ["least", "gain"], ["scaled"]),
        helper.make_node("Add", ["scaled", "offset"], ["pedals"]),
        helper.make_node("MatMul", ["state", "none"], ["steering"]),
        helper.make_node("Add", ["pedals", "steering"], ["action"]),
    ]
    inputs = [
        helper.make_tensor_value_info("state", TensorProto.FLOAT, ["batch", FEATURES]),
        helper.make_tensor_value_info(reading, TensorProto.FLOAT, ["batch", *shape]),
    ]
    nodes[0].input[0] = reading
    output = helper.make_tensor_value_info("action", TensorProto.FLOAT, ["batch", 2])
    graph = helper.make_graph(nodes, "policy", inputs, [output], values)
    opset = [helper.make_opsetid("", 17)]
    onnx.save(helper.make_model(graph, opset_imports=opset, ir_version=8), path)


LIDAR = """
road main { draw with waypoints { points: [(0m, 0m), (200m, 0m)] }, width: 8m }
agent ego is car on main at 5m {
  start_speed: 10m/s
  drive with onnx { model: "policy.onnx", agents: 0, acceleration: 1m/s^2 }
  sense with ranges as front { rays: 3, angle: 2deg, range: 60m, at: (2.2m, 0m, 0.5m) }
}
agent van is van on main at 90m
"""


def test_inputs_called_after_readings_get_them(tmp_path: Path) -> None:
    seeing(tmp_path / "policy.onnx", "front.distances", [3])
    (drive,) = testing.sample(LIDAR, 1, folder=tmp_path).run("builtin", duration=20.0)
    ego = drive.trace.agents["ego"]
    assert ego.speed.max() > 11.0
    assert ego.contacts[-1] == 0.0
    assert ego.speed[-1] == pytest.approx(0.0, abs=0.1)


@pytest.mark.parametrize(
    ("reading", "shape", "reason"),
    [
        (
            "rear.distances",
            [3],
            "not a reading of the agent, which has front.distances, front.angles",
        ),
        ("front.distances", [4], "not float32 (1, 3)"),
        ("rays", [3], "are not named after a reading"),
    ],
)
def test_what_is_wrong_with_inputs_for_readings(
    tmp_path: Path, reading: str, shape: list[int], reason: str
) -> None:
    seeing(tmp_path / "policy.onnx", reading, shape)
    scenes = testing.sample(LIDAR, 1, folder=tmp_path)
    with pytest.raises(roadlang.DiagnosticError) as found:
        scenes.run("builtin", duration=1.0)
    assert "error[RL741]" in str(found.value)
    assert reason in str(found.value)


def test_without_onnxruntime_the_error_names_the_extra(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    network(tmp_path / "policy.onnx")
    monkeypatch.setitem(__import__("sys").modules, "onnxruntime", None)
    scenes = testing.sample(SCENE, 1, folder=tmp_path)
    with pytest.raises(roadlang.DiagnosticError, match=r"roadlang\[onnx\]"):
        scenes.run("builtin", duration=1.0)
