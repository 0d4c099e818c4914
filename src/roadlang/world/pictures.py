"""Images: opened or typed, adjusted, and given a scale and a legend."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from ..diagnostics import Code, DiagnosticError, diagnose
from ..evaluate.building import build
from ..evaluate.candidates import CandidateBatch
from ..evaluate.dependencies import draws_in
from ..evaluate.evaluation import evaluate, scalar
from ..evaluate.indexed_scenario import IndexedScenario
from ..images.image_file import OpenedImage, open_image
from ..ir.picture import Picture
from ..ir.scenario import FileSource, Image, TextSource
from ..ir.values import PassCall, Value
from ..plugins.registry import KindEntry

LEAST_SCALE, GREATEST_SCALE = 1e-4, 1e4


@dataclass(frozen=True)
class _Draft:
    """A picture whose scale is not known yet."""

    picture: Picture
    scale: float | None


def picture(name: str, candidates: CandidateBatch) -> Picture:
    """The image of the only candidate. Raises DiagnosticError RL400 to RL408."""
    image = candidates.scenario.images[name]
    candidates = candidates if is_drawn(image, candidates.scenario) else candidates.scenario.fixed
    draft = _draft(image, candidates)
    if draft.scale is None:
        raise DiagnosticError(
            diagnose(
                Code.MISSING_SCALE,
                image.span,
                name=name,
                help="add `scale: 0.35m/px` with the true number",
            )
        )
    if not LEAST_SCALE <= draft.scale <= GREATEST_SCALE or not math.isfinite(draft.scale):
        raise DiagnosticError(
            diagnose(Code.IMPLAUSIBLE_SCALE, image.span, scale=f"{draft.scale:g}m/px")
        )
    return replace(draft.picture, scale=draft.scale)


def is_drawn(image: Image, scenario: IndexedScenario) -> bool:
    """Whether an image differs between candidates."""
    values = [value for link in scenario.chain(image) for _, value in link.options]
    calls = [call for link in scenario.chain(image) for call in link.passes]
    if any(getattr(scenario.kind(call)[1], "is_random", False) for call in calls):
        return True
    return any(True for value in (*values, *calls) for _ in draws_in(value, scenario.values))


def _draft(image: Image, candidates: CandidateBatch) -> _Draft:
    scenario = candidates.scenario

    def make() -> _Draft:
        draft = _base(image, candidates)
        options = {key: scalar(evaluate(value, candidates)) for key, value in image.options}
        if options.get("scale") is not None:
            draft = replace(draft, scale=float(options["scale"]))
        if options.get("legend"):
            legend = {key: _kind_name(item) for key, item in options["legend"].items()}
            draft = replace(draft, picture=replace(draft.picture, legend=legend))
        for call in image.passes:
            if call.verb == "adjust":
                draft = replace(draft, picture=_adjusted(draft.picture, call, candidates))
        return draft

    if is_drawn(image, scenario):
        return candidates.once(("picture", image.name), make)
    return scenario.once(("picture", image.name), make)


def _base(image: Image, candidates: CandidateBatch) -> _Draft:
    source = image.source
    if isinstance(source, TextSource):
        rows = tuple(source.text.rstrip().split("\n")) if source.text.strip() else ()
        if not rows:
            raise DiagnosticError(diagnose(Code.EMPTY_TEXT_IMAGE, image.span, name=image.name))
        return _Draft(Picture(None, 1.0, characters=_squared(rows)), None)
    if isinstance(source, FileSource):
        opened = _opened(source, image, candidates.scenario)
        return _Draft(Picture(opened.pixels, 1.0, path=source.path), opened.scale)
    origin = candidates.scenario.source_of(image)
    assert isinstance(origin, Image)
    return _draft(origin, candidates)


def _squared(rows: tuple[str, ...]) -> tuple[str, ...]:
    width = max(map(len, rows))
    return tuple(row.ljust(width) for row in rows)


def _opened(source: FileSource, image: Image, scenario: IndexedScenario) -> OpenedImage:
    reading = [call for call in image.passes if call.verb == "read"]
    if reading:
        return scenario.once(
            ("read", source.resolved), lambda: _read(source, reading[0], image, scenario)
        )

    def opening() -> OpenedImage:
        opened = open_image(Path(source.resolved), source.path, image.span)
        scenario.digests[source.path] = opened.sha256
        return opened

    return scenario.once(("open", source.resolved), opening)


def _read(
    source: FileSource, call: PassCall, image: Image, scenario: IndexedScenario
) -> OpenedImage:
    from .reading import read_with

    found = read_with(call, source, "image", scenario, image.span)
    pixels = np.asarray(found, np.uint8)
    if pixels.ndim == 2:
        pixels = np.repeat(pixels[..., None], 3, axis=2)
    return OpenedImage(np.ascontiguousarray(pixels[..., :3]), None, scenario.digests[source.path])


def _adjusted(before: Picture, call: PassCall, candidates: CandidateBatch) -> Picture:
    if before.pixels is None:
        raise DiagnosticError(
            diagnose(Code.ADJUST_ON_TEXT_IMAGE, call.span, kind=call.kind.rpartition(".")[2])
        )
    built = build(call, candidates, single=True)
    generator = candidates.random(call.place).generator(0)
    with built.guarded:
        pixels = np.asarray(built.kind.adjust(before.pixels.copy(), generator))
    _check_adjusted(pixels, before, built.entry, call)
    return replace(before, pixels=pixels)


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
