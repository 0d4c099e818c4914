"""`emit gltf`: roads, junctions, objects and agents as meshes for engines and 3D editors."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar, Literal

from roadlang.api import option

from .road_backend import RoadBackend

if TYPE_CHECKING:
    from collections.abc import Mapping

    from roadlang.api import Scene, Trace


@dataclass(frozen=True)
class GltfBackend(RoadBackend):
    """A scene as binary glTF 2.0, which Blender, Godot, Unity and Unreal Engine open. Drives are
    written as animations."""

    name: ClassVar[str] = "gltf"
    also_called: ClassVar[tuple[str, ...]] = ("glb", "blender", "unity", "obj", "fbx")
    collision: Literal["godot", "unreal", "none"] = option(
        "godot",
        help="how solid meshes are named: with the suffixes `-col` and `-convcol` of Godot, by "
        "convex meshes with the prefix `UCX_` of Unreal Engine, or not at all",
    )

    def files(self, scene: Scene) -> Mapping[str, bytes]:
        from .gltf.document import document

        return {"glb": document(scene, self.collision)}

    def drive_files(self, scene: Scene, trace: Trace) -> Mapping[str, bytes]:
        from .gltf.document import document

        return {"drive.glb": document(scene, self.collision, trace)}
