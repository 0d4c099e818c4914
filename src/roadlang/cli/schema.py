"""`roadlang schema NAME`: the JSON Schemas of what roadlang reads and writes."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import click

from ..diagnostics import Code


@click.command("schema")
@click.argument(
    "words",
    nargs=-1,
    required=True,
    metavar="scene|manifest|trace|scenario|labels|dataset|[VERB] KIND",
)
def command(words: tuple[str, ...]) -> None:
    """Print a JSON Schema.

    `scene` is the format of `emit json`, `manifest` that of manifest.json, `trace` that of the
    traces of `roadlang run`, and `scenario` that of `check --scenario`. `labels` and `dataset` are
    those of `render --dataset`. The name of a kind gives the schema of its options in SI units.
    """
    schemas = {
        "scene": _scene, "manifest": _manifest, "trace": _trace, "scenario": _scenario,
        "labels": _labels, "dataset": _dataset,
    }  # fmt: skip
    named = schemas.get(words[0]) if len(words) == 1 else None
    found = named() if named is not None else _kind(words, schemas)
    click.echo(json.dumps(found, indent=2))


def _scene() -> dict[str, Any]:
    from ..ir.scene_schema import scene_schema
    from ..plugins.json_schema import schema_of_options
    from ..plugins.options import schema_of
    from ..plugins.world_options import WorldOptions

    return scene_schema(schema_of_options(schema_of(WorldOptions)))


def _manifest() -> dict[str, Any]:
    from ..ir.scene_schema import manifest_schema

    return manifest_schema()


def _trace() -> dict[str, Any]:
    from ..ir.trace_document import trace_schema

    return trace_schema()


def _scenario() -> dict[str, Any]:
    from ..ir.scenario_json import scenario_schema

    return scenario_schema()


def _labels() -> dict[str, Any]:
    from ..ir.frame_labels import FrameLabels
    from ..ir.schema import schema_of_dataclass

    return schema_of_dataclass(FrameLabels)


def _dataset() -> dict[str, Any]:
    from ..ir.dataset import Dataset
    from ..ir.schema import schema_of_dataclass

    return schema_of_dataclass(Dataset)


def _kind(words: tuple[str, ...], schemas: dict[str, Callable[[], Any]]) -> Any:
    from ..diagnostics import DiagnosticError, diagnose, did_you_mean
    from ..plugins.discovery import load_registry
    from ..plugins.guard import plugin_guard
    from ..plugins.json_schema import schema_of_kind

    verb, name = (words[0], words[1]) if len(words) > 1 else (None, words[0])
    entries = load_registry().entries
    found = []
    for entry in entries:
        if name in (entry.name, entry.qualified) and verb in (None, entry.verb):
            with plugin_guard(entry, None):
                found.append(schema_of_kind(entry))
    if not found:
        hints = did_you_mean(name, [*schemas, *(entry.name for entry in entries)]) or (
            f"there are {', '.join(schemas)}, and kinds, which `roadlang plugins` lists",
        )
        raise DiagnosticError(
            diagnose(Code.UNKNOWN_CHOICE, what="schema", name=" ".join(words), help=hints)
        )
    return found[0] if len(found) == 1 else found
