"""`roadlang convert A B`: writes a map in another format."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from roadlang.commands import Code, DiagnosticError, diagnose, echo

from .opening import opened

if TYPE_CHECKING:
    from roadlang.api import Backend

KINDS = {
    ".xodr": "opendrive",
    ".json": "json",
    ".svg": "svg",
    ".xosc": "openscenario",
    ".net.xml": "sumo",
    ".glb": "gltf",
    ".scenic": "scenic",
}
"""The kind of `emit` for each file name extension."""


@click.command("convert")
@click.argument("source", metavar="FILE")
@click.argument("target", metavar="OUTPUT")
@click.option(
    "--emit", "kind", metavar="KIND", help="Output format, if the extension does not determine it."
)
def command(source: str, target: str, kind: str | None) -> None:
    """Convert a map, or the first scene of a scene file, to another format.

    FILE is a map (.xodr, .osm, ...), a scene (.json) or a scene file (.rl). The extension of
    OUTPUT selects its format: .xodr, .svg, .json, or that of any other `emit`.
    """
    path = Path(target).absolute()
    ending, kind = _format(path.name, kind)
    scene = opened(source)
    files = {
        end: content if isinstance(content, bytes) else content.encode()
        for end, content in _backend(scene.registry, kind).files(scene.record).items()
    }
    from roadlang.commands import write_all

    stem = path.name[: -len(ending) - 1] if ending in files else path.name.partition(".")[0]
    for written in write_all(path.parent, {f"{stem}.{end}": files[end] for end in sorted(files)}):
        echo(f"{written}: {len(written.read_bytes()):,} bytes")


def _format(name: str, kind: str | None) -> tuple[str, str]:
    """The extension of an output, without its dot, and its kind."""
    fitting = [ending for ending in KINDS if name.lower().endswith(ending)]
    if kind is not None:
        _, _, ending = name.partition(".")
        return ending, kind
    if not fitting:
        help_ = f"use the extension {', '.join(KINDS)}, or select a format with `--emit`"
        raise DiagnosticError(
            diagnose(Code.UNKNOWN_CHOICE, what="output format", name=Path(name).suffix, help=help_)
        )
    ending = max(fitting, key=len)
    return name[len(name) - len(ending) + 1 :], KINDS[ending]


def _backend(registry: Any, kind: str) -> Backend:
    """The backend of an installed kind. Raises RL471 if the kind is not installed."""
    try:
        found: Backend = registry.find("emit", kind).load()()
    except LookupError:
        raise DiagnosticError(diagnose(Code.KIND_NOT_INSTALLED, kind=f"emit {kind}")) from None
    return found
