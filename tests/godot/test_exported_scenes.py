"""Scenes as files of Godot and glTF: they open where roadlang is not."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import numpy as np
import pytest

from roadlang.api import Scene
from roadlang_godot.engines import engine as engines
from roadlang_godot.faults import EngineError
from roadlang_godot.net.session import Session
from roadlang_godot.rendering.exported_scenes import exported
from roadlang_godot.rendering.pictures import build
from tests.godot.godot_scenes import call, car, pieces, road, scene, straight, thing

pytestmark = pytest.mark.godot

PROJECT_FILE = 'config_version=5\n\n[application]\nconfig/name="empty"\n'
READER = """extends SceneTree


func _initialize() -> void:
	await process_frame
	var file := GLTFDocument.new()
	var state := GLTFState.new()
	file.append_from_file("scene.glb", state)
	var scene: PackedScene = load("res://scene.tscn")
	var out := {"tscn": _described(scene.instantiate())}
	out["glb"] = _described(file.generate_scene(state))
	print("found: ", JSON.stringify(out))
	quit()


func _described(root: Node) -> Dictionary:
	get_root().add_child(root)
	var first: VisualInstance3D = _all(root.get_node("Roads"), "VisualInstance3D")[0]
	var box := first.global_transform * first.get_aabb()
	for drawn: VisualInstance3D in _all(root.get_node("Roads"), "VisualInstance3D"):
		box = box.merge(drawn.global_transform * drawn.get_aabb())
	var trees: Array[Array] = []
	for node: Node3D in _all(root.get_node("Objects"), "Node3D"):
		if node is MeshInstance3D:
			trees.append([node.global_position.x, node.global_position.z])
		elif node is MultiMeshInstance3D:
			var many: MultiMesh = (node as MultiMeshInstance3D).multimesh
			var buffer := many.buffer
			for i in range(0, buffer.size(), buffer.size() / many.instance_count):
				trees.append([buffer[i + 3], buffer[i + 11]])
	trees.sort()
	var corners: Array[Array] = []
	for camera: Camera3D in _all(root, "Camera3D"):
		var tall := tan(deg_to_rad(0.5 * camera.fov))
		for x: float in [box.position.x, box.end.x]:
			for z: float in [box.position.z, box.end.z]:
				var seen := camera.transform.affine_inverse() * Vector3(x, 0.0, z)
				corners.append([-seen.x / seen.z / tall / 16.0 * 9.0, -seen.y / seen.z / tall])
	var ego: Node3D = _all(root.get_node("Agents/ego"), "MeshInstance3D")[0]
	return {
		"road": [box.position.x, box.end.x, box.position.z, box.end.z],
		"trees": trees,
		"corners": corners,
		"ego": [ego.global_position.x, ego.global_position.z],
		"paint": root.find_children("Paint*", "MeshInstance3D", true, false).size(),
		"bodies": _all(root, "StaticBody3D").size(),
	}


func _all(root: Node, type: String) -> Array[Node]:
	return root.find_children("*", type, true, false)
"""


def _sent() -> Scene:
    main = road("main", pieces(straight(80)), width=7.0)
    trees = [thing("tree", x, 9.0) for x in (10.0, 30.0, 50.0)]
    return scene(main, agents=[car("ego", main, 20.0, call("lane_follow"))], objects=trees)


def test_a_scene_of_godot_needs_no_file_and_no_script(session: Session) -> None:
    layout = build(session, _sent())
    first, second = (exported(session, layout, "tscn") for _ in range(2))
    assert first == second
    assert b"shader_type spatial" in first
    assert b"ext_resource" not in first
    assert b"res://" not in first


def test_a_gltf_file_has_no_plates_of_shade_below_vehicles(session: Session) -> None:
    content = exported(session, build(session, _sent()), "glb")
    length = int.from_bytes(content[12:16], "little")
    described = json.loads(content[20 : 20 + length])
    assert len(described["materials"]) > 3
    assert not [one for one in described["materials"] if one.get("alphaMode") == "BLEND"]


def test_other_formats_are_refused(session: Session) -> None:
    layout = build(session, _sent())
    with pytest.raises(EngineError, match="an export is tscn or glb"):
        exported(session, layout, "obj")


@pytest.mark.slow
def test_both_files_open_in_a_project_without_roadlang(session: Session, tmp_path: Path) -> None:
    layout = build(session, _sent())
    (tmp_path / "project.godot").write_text(PROJECT_FILE)
    (tmp_path / "reader.gd").write_text(READER)
    for format in ("tscn", "glb"):
        (tmp_path / f"scene.{format}").write_bytes(exported(session, layout, format))
    done = subprocess.run(
        [str(engines.find()), "--headless", "--path", str(tmp_path), "-s", "reader.gd"],
        capture_output=True,
        text=True,
    )
    assert "ERROR: " not in done.stdout + done.stderr
    found = json.loads(done.stdout.partition("found: ")[2].splitlines()[0])
    left, top = layout.frame.x, layout.frame.y
    for format, one in found.items():
        assert one["road"] == pytest.approx(
            [0.0 - left, 80.0 - left, top - 3.5, top + 3.5], abs=0.02
        )
        trees = [value for tree in one["trees"] for value in tree]
        wanted = [value for x in (10.0, 30.0, 50.0) for value in (x - left, top - 9.0)]
        assert trees == pytest.approx(wanted, abs=0.001)
        assert one["ego"] == pytest.approx([20.0 - left, top], abs=3.0)
        assert (one["paint"] > 0) == (format == "glb")
        assert (one["bodies"] > 0) == (format == "tscn")
        if format == "tscn":
            seen = np.array(one["corners"])
            assert (np.abs(seen) < 1.0).all(), "all of it is in the picture"
            assert np.ptp(seen, axis=0).max() > 1.2, "and fills it"
