"""The kinds in the wheel, and where the core may have their names in quotes."""

from __future__ import annotations

import ast

from tests.architecture.source_tree import SourceTree, dotted

WORDS = {
    "columns of traces, fields of scenes and networks": (
        "acceleration collision confidence contacts cross_track_error curvature gap heading lane"
        " lane_offset length off_road present progress red_light route_progress speed_limit"
        " speed start station steering width x y yaw_rate"
    ),
    "words of the language, its units and its near misses": (
        "ahead_of auto behind beside drive front pixels random road route scale scene signals time"
    ),
    "functions and modules of the geometry": "clearance crossing frechet margin",
    "users of lanes": "pedestrian",
    "junctions, their rules, turns and conflicts": (
        "all_way_stop junction merge right_first stop straight yield"
    ),
    "the side of the road, `world { traffic: left }`": "traffic",
    "types of JSON Schema": "integer",
}
"""Names of kinds that mean something else wherever the core has them in quotes. The rule cannot
tell the two apart; a name that is in no file any more has to go."""
DEFAULT_KINDS = {
    "src/roadlang/ir/category.py": frozenset({
        "ambulance", "animal", "barrier", "bicycle", "building", "bus", "bush", "car",
        "cone", "crosswalk", "fence", "guardrail", "hedge", "lamp", "motorcycle", "pole", "sign",
        "taxi", "tractor", "traffic_light", "trailer", "tree", "truck", "van", "wall",
    }),
    "src/roadlang/semantics/lower/statements.py": frozenset({"builtin"}),
    "src/roadlang/session/emitting.py": frozenset({"json", "svg"}),
    "src/roadlang/session/scene.py": frozenset({"svg"}),
}  # fmt: skip
"""Kinds that stand for none: `run` without a `simulate`, a file without an `emit`, the figure of a
scene in a notebook. A choice of the front door, which a kind cannot make for itself. Categories of
agents and objects have the names of the kinds that are nothing but that."""


def shipped_kinds(sources: SourceTree) -> frozenset[str]:
    """The names of the kinds in the wheel."""
    names = set()
    for file in sources.plugins:
        for node in file.nodes(ast.AnnAssign):
            value = node.value.value if isinstance(node.value, ast.Constant) else None
            if dotted(node.target) == "name" and isinstance(value, str):
                names.add(value)
    return frozenset(names) - {""}
