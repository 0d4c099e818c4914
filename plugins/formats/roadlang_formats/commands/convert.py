"""`roadlang convert A B`: writes a map in another format."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

import click

from roadlang.commands import echo

if TYPE_CHECKING:
    from collections.abc import Mapping

    from roadlang.commands import DiagnosticError

KINDS = {
    ".xodr": "opendrive",
    ".json": "json",
    ".svg": "svg",
    ".xosc": "openscenario",
    ".net.xml": "sumo",
    ".glb": "gltf",
    ".scenic": "scenic",
    ".mjcf.xml": "mujoco",
    ".cr.xml": "commonroad",
    ".lanelet2.osm": "lanelet2",
    ".geojson": "geojson",
}
"""The kind of `emit` for each file name extension."""
_QUOTES = {'"': "&quot;"}
_PROGRAMS = ("scenic",)
"""Files with names in string literals; those of other formats are XML."""


@click.command("convert")
@click.argument("source", metavar="FILE")
@click.argument("target", metavar="OUTPUT")
@click.option(
    "--emit",
    "kind",
    metavar="KIND",
    help="Output format, if the extension does not determine it or with options, as in a scene "
    'file: `opendrive{version: "1.6"}`.',
)
def command(source: str, target: str, kind: str | None) -> None:
    """Convert a map, or the first scene of a scene file, to another format.

    FILE is a map (.xodr, .osm, ...), a scene (.json) or a scene file (.rl). The extension of
    OUTPUT selects its format: .xodr, .svg, .json, or that of any other `emit`.
    """
    from roadlang.commands import emitted_files, keep_inputs, write_all

    from .opening import opened

    path = _named_file(target)
    output = _kind(path.name) if kind is None else _one_output(kind)
    scene = opened(source)
    files = emitted_files(output, scene.record, scene.registry)
    names = _names(path.name, output, list(files))
    files = _renamed(files, scene.record.stem, names)
    keep_inputs([path.parent / name for name in names.values()], [source])
    for written in write_all(path.parent, {names[end]: files[end] for end in sorted(files)}):
        echo(f"{written}: {len(written.read_bytes()):,} bytes")


def _named_file(target: str) -> Path:
    """Raises `click.UsageError` for a folder or nothing."""
    if not target or os.path.isdir(target):
        problem = f"{target} is a folder" if target else "OUTPUT is empty"
        example = Path(target or ".") / "town.xodr"
        raise click.UsageError(f"{problem}: name a file, such as {example}")
    return Path(target).absolute()


def _one_output(text: str) -> str:
    """`svg{size: 800px}`. Raises `click.UsageError` for none or several."""
    from roadlang.commands import parse_outputs

    outputs = parse_outputs(text)
    if len(outputs) != 1:
        raise click.UsageError(f"--emit {text!r}: name one format; `convert` writes one")
    return outputs[0]


def _kind(name: str) -> str:
    """The `emit` that the extension of an output selects."""
    fitting = [ending for ending in KINDS if name.lower().endswith(ending)]
    if not fitting:
        extensions = ", ".join(KINDS)
        raise _unknown(name, f"use the extension {extensions}, or select a format with `--emit`")
    return KINDS[max(fitting, key=len)]


def _names(name: str, output: str, endings: list[str]) -> dict[str, str]:
    """The names of files by their endings, one of which `name` has, in letters of any size."""
    if not endings:
        raise click.UsageError(f"`emit {output}` writes no file of a scene")
    fitting = [ending for ending in endings if name.lower().endswith(f".{ending}")]
    if not fitting:
        extensions = " or ".join(f".{ending}" for ending in endings)
        raise _unknown(name, f"this format is written with the extension {extensions}")
    named = max(fitting, key=len)
    stem = name[: -len(named) - 1]
    return {ending: name if ending == named else f"{stem}.{ending}" for ending in endings}


def _renamed(files: Mapping[str, bytes], before: str, names: Mapping[str, str]) -> dict[str, bytes]:
    """Files that name each other, with the names that they get."""
    import json
    import re
    from xml.sax.saxutils import escape

    if len(files) < 2:
        return dict(files)
    endings = sorted(files, key=len, reverse=True)
    pattern = re.compile(rf"{re.escape(before)}\.({'|'.join(map(re.escape, endings))})".encode())
    renamed = {}
    for ending, content in files.items():

        def name(found: re.Match[bytes], ending: str = ending) -> bytes:
            new = names[found[1].decode()]
            return (json.dumps(new)[1:-1] if ending in _PROGRAMS else escape(new, _QUOTES)).encode()

        renamed[ending] = pattern.sub(name, content)
    return renamed


def _unknown(name: str, help: str) -> DiagnosticError:
    from roadlang.commands import Code, DiagnosticError, diagnose

    suffix = Path(name).suffix or name
    return DiagnosticError(
        diagnose(Code.UNKNOWN_CHOICE, what="output format", name=suffix, help=help)
    )
