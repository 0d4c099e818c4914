"""A class name stands for one thing, so that who searches for it finds it."""

from __future__ import annotations

import ast
from collections import defaultdict
from dataclasses import replace

from tests.architecture.source_tree import SourceFile, SourceTree, source_tree

SOURCES = source_tree()
TWICE = {
    "Scene": "roadlang.Scene is what Python users get; its `record` is the roadlang.api.Scene that"
    " plugins get and files hold",
}
"""Names that stand for two things, and why."""


def modules_of_classes(sources: SourceTree) -> dict[str, list[str]]:
    """The modules that define each public class."""
    found = defaultdict(list)
    for file in sources.files.values():
        for node in file.tree.body:
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                found[node.name].append(file.module)
    return dict(found)


def test_a_class_name_stands_for_one_thing() -> None:
    twice = {name: where for name, where in modules_of_classes(SOURCES).items() if len(where) > 1}
    assert {name: where for name, where in twice.items() if name not in TWICE} == {}
    assert twice.keys() >= TWICE.keys(), "an exception is not needed any more"


def test_a_name_that_is_used_again_is_noticed() -> None:
    path = "src/roadlang/world/roads/roads.py"
    text = SOURCES.files[path].text + "\n\nclass JunctionPlan:\n    pass\n"
    sources = replace(SOURCES, files={**SOURCES.files, path: SourceFile(path, text)})
    assert len(modules_of_classes(sources)["JunctionPlan"]) == 2
