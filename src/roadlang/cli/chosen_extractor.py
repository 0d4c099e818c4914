"""Runs the extractor that a command line chooses, with the options that it states."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

import click

from ..diagnostics import Code

if TYPE_CHECKING:
    from ..ir.picture import Extraction, Picture
    from ..plugins.options import OptionSchema
    from ..plugins.registry import KindEntry


def extracted(
    picture: Picture, scale: float | None, arguments: dict[str, Any]
) -> tuple[Extraction, float]:
    """Run the kind with those of the options that were given; what it found, its CPU seconds.

    Raises DiagnosticError RL425 for a kind that is unknown, RL426 for an option that it lacks,
    `click.UsageError` for one that it needs.
    """
    from ..diagnostics import DiagnosticError, diagnose
    from ..plugins.guard import plugin_guard
    from ..plugins.options import schema_of
    from ..plugins.results import check_extraction

    entry = _extractor(arguments["kind"])
    with plugin_guard(entry, None):
        kind = entry.load()
    options = _options(picture, scale, arguments)
    schema = schema_of(kind)
    fields = {option.name for option in schema}
    unfit = sorted(set(options) - fields - {"resolution"})
    if unfit:
        raise DiagnosticError(
            diagnose(
                Code.UNSUPPORTED_EXTRACTOR_OPTION,
                kind=arguments["kind"],
                option=f"--{unfit[0].replace('_', '-')}",
            )
        )
    _check_required(arguments["kind"], schema, options)
    with plugin_guard(entry, None):
        extractor: Any = kind(**{key: value for key, value in options.items() if key in fields})
        _load()
        started = time.process_time()
        found = extractor.extract(picture)
        seconds = time.process_time() - started
    check_extraction(found, entry, None)
    return found, seconds


def _check_required(kind: str, schema: tuple[OptionSchema, ...], options: dict[str, Any]) -> None:
    """Raises `click.UsageError` for an option that the kind requires and that was not given."""
    for option in schema:
        if option.required and option.name not in options:
            flag = f"--{option.name.replace('_', '-')}"
            known = any(flag in parameter.opts for parameter in _parameters())
            where = f"give `{flag}`" if known else "set it in a scene file, in `extract with`"
            raise click.UsageError(f"`--with {kind}` needs `{option.name}`: {where}.")


def _parameters() -> list[click.Parameter]:
    return click.get_current_context().command.params


def _extractor(name: str) -> KindEntry:
    from ..diagnostics import DiagnosticError, diagnose, did_you_mean
    from ..plugins.discovery import load_registry
    from ..plugins.finding import find_entry
    from ..plugins.registry import UnknownKind

    registry = load_registry()
    try:
        return find_entry(registry, "extract", name)
    except UnknownKind:
        names = registry.names("extract")
        hints = (*did_you_mean(name, names), f"the extractors are {', '.join(names)}")
        raise DiagnosticError(diagnose(Code.UNKNOWN_EXTRACTOR, kind=name, help=hints)) from None


def _options(picture: Picture, scale: float | None, arguments: dict[str, Any]) -> dict[str, Any]:
    options: dict[str, Any] = {}
    if scale is None:
        options["resolution"] = "unknown"
    if arguments["width"] is not None:
        options["width"] = arguments["width"] * picture.file_scale
    if arguments["leave_out"]:
        options["leave_out"] = tuple(((a, b), (c, d)) for a, b, c, d in arguments["leave_out"])
    for name in ("threshold", "through", "only_through", "model"):
        if arguments[name]:
            options[name] = arguments[name]
    return options


def _load() -> None:
    """Import what extractors need, so that the time that is printed is that of the picture."""
    from importlib import import_module

    from .deferred_modules import defer_parts_of_numpy

    defer_parts_of_numpy(needed=("ma",))  # `numpy.median` asks for masked arrays
    for name in (
        "cv2",
        "scipy.ndimage",
        "scipy.sparse.csgraph",
        "scipy.sparse.linalg",
        "scipy.spatial",
    ):
        import_module(name)
