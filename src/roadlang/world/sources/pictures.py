"""Images: opened or typed, adjusted, and given a scale and a legend."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ...diagnostics import Code, Diagnostic, DiagnosticError, diagnose
from ...evaluate.candidates import CandidateBatch
from ...evaluate.evaluation import build, evaluate
from ...evaluate.indexed_scenario import IndexedScenario
from ...evaluate.kind_instance import scalar
from ...images.image_scale import unusable_world_file
from ...ir.picture import Picture
from ...ir.scenario import FileSource, Input, ScenarioImage, TextSource
from ...ir.values import PassCall, Value
from ...plugins.registry import KindEntry
from ..placement_faults import missing_scale, no_place_on_earth
from .reading import read_file

if TYPE_CHECKING:
    from ...images.placed_pixels import PlacedPixels

LEAST_SCALE, GREATEST_SCALE = 1e-4, 1e4


@dataclass(frozen=True, eq=False)
class LoadedPicture:
    """`inputs`: the files that it was read from; `origin`: latitude and longitude of its lower left
    corner, degrees, where they are known; `warnings`: of its place."""

    picture: Picture
    inputs: tuple[Input, ...]
    origin: tuple[float, float] | None = None
    warnings: tuple[Diagnostic, ...] = ()


@dataclass(frozen=True, eq=False)
class _UnscaledPicture:
    """A picture whose scale and place may not be known yet."""

    picture: Picture
    scale: float | None
    inputs: tuple[Input, ...] = ()
    origin: tuple[float, float] | None = None
    warnings: tuple[Diagnostic, ...] = ()
    world_file: str | None = None
    """What is wrong with the one beside it."""


def load_picture(name: str, candidates: CandidateBatch) -> LoadedPicture:
    """The image of the only candidate. Raises DiagnosticError RL400 to RL408."""
    image = candidates.scenario.images[name]
    draft = _draft(image, candidates)
    if draft.scale is None:
        raise DiagnosticError(missing_scale(image, draft.world_file))
    if not LEAST_SCALE <= draft.scale <= GREATEST_SCALE or not math.isfinite(draft.scale):
        raise DiagnosticError(
            diagnose(Code.IMPLAUSIBLE_SCALE, image.span, scale=f"{draft.scale:g}m/px")
        )
    picture = replace(draft.picture, scale=draft.scale)
    return LoadedPicture(picture, draft.inputs, draft.origin, draft.warnings)


def picture_of(shown: PlacedPixels, scale: float, path: str) -> Picture:
    """A picture file, for extractors. `scale`: meters per pixel, whatever the file says."""
    return Picture(shown.pixels, scale, path=path, file=shown.file, north_up=shown.north_up)


def _draft(image: ScenarioImage, candidates: CandidateBatch) -> _UnscaledPicture:
    drawn = candidates.scenario.is_varying(image.name)
    return candidates.root(("picture", image.name), drawn, partial(_adjusted, image))


def _adjusted(image: ScenarioImage, candidates: CandidateBatch) -> _UnscaledPicture:
    """The picture with its scale and legend, after all its passes."""
    draft = _base(image, candidates)
    options = {key: scalar(evaluate(value, candidates)) for key, value in image.options.items()}
    if options.get("scale") is not None:
        draft = replace(draft, scale=float(options["scale"]))
    if options.get("origin") is not None:
        draft = replace(draft, origin=_degrees(options["origin"], image), warnings=())
    if options.get("legend"):
        legend = {key: _kind_name(item) for key, item in options["legend"].items()}
        draft = replace(draft, picture=replace(draft.picture, legend=legend))
    for call in image.passes:
        if call.verb == "adjust":
            draft = replace(draft, picture=_after(call, draft.picture, candidates))
    return draft


def _degrees(origin: tuple[float, float], image: ScenarioImage) -> tuple[float, float]:
    """Latitude and longitude. Raises RL480 for what is not a latitude and longitude."""
    latitude, longitude = map(math.degrees, origin)
    fault = no_place_on_earth(image, latitude, longitude)
    if fault is not None:
        raise DiagnosticError(fault)
    return latitude, longitude


def _base(image: ScenarioImage, candidates: CandidateBatch) -> _UnscaledPicture:
    source = image.source
    if isinstance(source, TextSource):
        rows = tuple(source.text.rstrip().split("\n")) if source.text.strip() else ()
        if not rows:
            raise DiagnosticError(diagnose(Code.EMPTY_TEXT_IMAGE, image.span, name=image.name))
        return _UnscaledPicture(Picture(None, 1.0, characters=_squared(rows)), None)
    if isinstance(source, FileSource):
        return _from_file(source, image, candidates.scenario)
    origin = candidates.scenario.source_of(image)
    assert isinstance(origin, ScenarioImage)
    return _draft(origin, candidates)


def _squared(rows: tuple[str, ...]) -> tuple[str, ...]:
    width = max(map(len, rows))
    return tuple(row.ljust(width) for row in rows)


def _from_file(
    source: FileSource, image: ScenarioImage, scenario: IndexedScenario
) -> _UnscaledPicture:
    has_reader = any(call.verb == "read" for call in image.passes)

    def make() -> _UnscaledPicture:
        if has_reader:
            return _read(source, image, scenario)
        from ...images.image_file import open_image  # it loads OpenCV

        opened = open_image(Path(source.resolved), source.path, image.span)
        inputs = tuple(Input(*item) for item in opened.inputs)
        shown = opened.shown
        picture = picture_of(shown, 1.0, source.path)
        scale = opened.scale
        fault = unusable_world_file(Path(source.resolved)) if scale is None else None
        return _UnscaledPicture(picture, scale, inputs, shown.origin, opened.warnings, fault)

    # Pictures that are opened are shared; what a reader makes of one depends on its options.
    key = ("image read", image.name) if has_reader else ("image opened", source.resolved)
    return scenario.once(key, make)


def _read(source: FileSource, image: ScenarioImage, scenario: IndexedScenario) -> _UnscaledPicture:
    content = read_file(source, "image", image.passes, scenario, image.span)
    pixels = np.asarray(content.value, np.uint8)
    if pixels.ndim == 2:
        pixels = np.repeat(pixels[..., None], 3, axis=2)
    pixels = np.ascontiguousarray(pixels)
    return _UnscaledPicture(Picture(pixels, 1.0, path=source.path), None, content.inputs)


def _after(call: PassCall, before: Picture, candidates: CandidateBatch) -> Picture:
    if before.pixels is None:
        raise DiagnosticError(
            diagnose(Code.ADJUST_ON_TEXT_IMAGE, call.span, kind=call.kind.rpartition(".")[2])
        )
    built = build(call, candidates, single=True)
    generator = candidates.random(call.place).generator(0)
    with built.guarded:
        pixels = np.asarray(built.kind.adjust(before.pixels.copy(), generator))
    _check_adjusted(pixels, before, built.entry, call)
    return candidates.scenario.observed(call, replace(before, pixels=pixels))


def _check_adjusted(pixels: Any, before: Picture, entry: KindEntry, call: PassCall) -> None:
    assert before.pixels is not None
    if pixels.shape != before.pixels.shape or pixels.dtype != np.uint8:
        found = f"{pixels.dtype} pixels of shape {pixels.shape}"
        raise DiagnosticError(
            diagnose(
                Code.WRONG_PLUGIN_RESULT,
                call.span,
                kind=f"{entry.verb} {entry.qualified}",
                plugin=str(entry.origin),
                fault=f"gave {found}, not uint8 of shape {before.pixels.shape}",
            )
        )


def _kind_name(item: Value | str) -> str:
    """A legend's value: "road", or the plain name of an object kind."""
    return item.kind if isinstance(item, PassCall) else str(getattr(item, "name", item))
