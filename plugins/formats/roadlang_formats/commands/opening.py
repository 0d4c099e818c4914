"""The scene that a file holds: a map, a scene, or the first scene of a scene file."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from roadlang.commands import report

if TYPE_CHECKING:
    import roadlang

SCENE_FILE = ".rl"
_SUMO = ".net.xml"


def opened(name: str) -> roadlang.Scene:
    """The scene of a file. The scene of a map has only its network, called `town`.

    Prints warnings. Raises DiagnosticError if the file cannot be read.
    """
    import roadlang
    from roadlang.api import read_input

    from ..map_xml import LARGEST

    path = Path(name)
    if path.suffix.lower() == ".json":
        from ..json_maps import read_json
        from ..read_scene import scene_in

        text, found = read_json(path)
        if _is_scene(found):
            return scene_in(path, text)
    if path.suffix.lower() == SCENE_FILE:
        loaded = roadlang.load(name)
    else:
        text = _scenario(path)
        if not path.exists() and not set("*?") & set(name):
            read_input(path, LARGEST)  # RL400, without the line of a scene file that is not there
        loaded = roadlang.loads(text, folder=path.parent)
    scenes = loaded.sample(1)
    report(scenes.diagnostics)
    return scenes[0]


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
