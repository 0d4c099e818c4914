"""The scene that a file holds: a map, a scene, or the first scene of a scene file."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from roadlang.commands import report

if TYPE_CHECKING:
    import roadlang
    from roadlang.commands import Diagnostic

SCENE_FILE = ".rl"
_SUMO = ".net.xml"


def opened(name: str) -> roadlang.Scene:
    """The scene of a file. The scene of a map has only its network, called `town`.

    Prints warnings. Raises DiagnosticError if the file cannot be read.
    """
    import roadlang

    path = Path(name)
    if path.suffix.lower() == ".json":
        from ..json_maps import read_json
        from ..read_scene import scene_in

        text, found = read_json(path)
        if _is_scene(found):
            return scene_in(path, text)
    if path.suffix.lower() == SCENE_FILE:
        scenes = roadlang.load(name).sample(1)
        report(scenes.diagnostics)
        return scenes[0]
    return _scene_of_map(path)


def _scene_of_map(path: Path) -> roadlang.Scene:
    import roadlang
    from roadlang.api import read_input
    from roadlang.commands import DiagnosticError

    from ..map_xml import LARGEST

    if not str(path.name) or os.path.isdir(path):
        raise click.UsageError(f"FILE is a folder, {path}: name a map, a scene or a scene file")
    text = _scenario(path)
    if not os.path.exists(path) and not set("*?") & set(str(path)):
        read_input(path, LARGEST)  # RL400
    try:
        scenes = roadlang.loads(text, folder=path.parent).sample(1)
    except DiagnosticError as error:
        raise DiagnosticError(*_about(path, text, error.diagnostics)) from None
    report(_about(path, text, scenes.diagnostics))
    return scenes[0]


def _about(path: Path, text: str, found: Iterable[Diagnostic]) -> Iterator[Diagnostic]:
    """Those of the text that stands for a scene file, which nobody wrote, are about the map."""
    from roadlang.commands import Code

    from ..plans.views import map_named_in

    for diagnostic in found:
        if diagnostic.span is not None and diagnostic.span.source.text == text:
            help = tuple(line for line in diagnostic.help if "in its block" not in line)
            if diagnostic.code == Code.NO_READER and (roads := map_named_in(path)) is not None:
                help = (f"its roads are in `{roads}`: convert that",)
            diagnostic = replace(diagnostic, span=None, path=str(path), help=help)
        yield diagnostic


def _is_scene(found: Any) -> bool:
    """Whether what a JSON file holds is a scene of roadlang; plugins may read other JSON files."""
    return isinstance(found, dict) and str(found.get("schema", "")).startswith("roadlang.scene/")


def _scenario(path: Path) -> str:
    if re.search(r'["\\\n\r]', path.name):
        raise click.BadParameter(f"rename {path.name!r}: its name has a quote or a backslash")
    if path.name.endswith(_SUMO):
        made = f"netconvert -s {path.name} --opendrive-output {path.name.removesuffix(_SUMO)}.xodr"
        raise click.BadParameter(f"networks of SUMO cannot be read; first `{made}`")
    word = re.sub(r"[^A-Za-z0-9_]+", "_", path.stem).strip("_")
    # With the prefix, no name is a keyword or begins with a digit.
    return f'scenario map_{word} "{path.name}"\nnetwork town from "{path.name}"\n'
