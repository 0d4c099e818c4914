"""Aerial-looking scenes with exact center lines and widths."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np

from training.rendering.camera import expose
from training.rendering.extras import Extras, lay_extras
from training.rendering.footways import lay_footways
from training.rendering.frame import (
    Floats,
    Frame,
    Image,
    Layer,
    PlannedRoad,
    Rendering,
    TrueRoad,
    Truth,
    ribbon,
)
from training.rendering.ground import ground
from training.rendering.houses import build, footprints, lay_drives, settle
from training.rendering.layouts.plans import PLANS
from training.rendering.leisure import lay_grounds
from training.rendering.noise import blend
from training.rendering.parking_lots import fill_lots, lay_lots, lay_yards
from training.rendering.pavement import park, pave
from training.rendering.setting import Setting, setting_of
from training.rendering.thickets import overgrow
from training.rendering.trees import Canopy, clear_strip, plant, press, stamp, thrown, woods


def render_aerial(
    plan: str,
    seed: int,
    size: int = 640,
    meters_per_pixel: float = 1.0,
    hidden: float | None = None,
    asphalt: float | None = None,
    plain: bool = False,
    extras: Extras | None = None,
) -> Rendering:
    """A scene of the named plan (see `PLANS`); the same arguments give the same bytes.

    `hidden` asks for that share of the center-line length under crowns or in shadow;
    `asphalt` sets the gray of the road, 0 (black) to 1; `plain` leaves out all but the roads;
    `extras` add what the scene does not have by itself.
    """
    rng = np.random.default_rng([seed, list(PLANS).index(plan)])
    frame = Frame(size, meters_per_pixel)
    roads = PLANS[plan](rng, frame.extent)
    setting = setting_of(rng, frame, plan)
    if asphalt is not None:
        setting = replace(setting, asphalt=asphalt, asphalt_spread=0.01)
    if extras is not None and extras.built_up is not None and setting.dense:
        setting = setting.built_up(extras.built_up)
    if plain:
        setting = setting.emptied()
    if hidden is not None:
        setting = replace(setting, overhang=-3.0, leafless=False)
    near = signed_distance(frame, roads)
    image, shadow, canopy = _paint(rng, setting, roads, near, hidden, extras)
    blend(image, canopy.color, canopy.cover)
    if extras is not None:
        grown = overgrow(np.random.default_rng([extras.seed, 1]), setting, extras, image, near)
        shadow = np.maximum(shadow, grown)
    truth = Truth(
        frame.shape,
        true_roads(frame, roads),
        np.maximum(shadow, canopy.cover) > 0.5,
        meters_per_pixel,
    )
    return Rendering(expose(rng, image), truth)


def _paint(
    rng: np.random.Generator,
    setting: Setting,
    roads: list[PlannedRoad],
    near: Layer,
    hidden: float | None,
    extras: Extras | None,
) -> tuple[Layer, Layer, Canopy]:
    image, water = ground(rng, setting, near)
    if extras is not None:
        lay_extras(setting, extras, image, water)
    if not setting.plain:
        lay_grounds(rng, setting, image)
    buildings, lots = settle(rng, setting, roads, near, water)
    canopy = woods(rng, setting, near, water)
    plant(rng, setting, canopy, near, water, roads)
    if extras is not None and extras.clearing:
        clear_strip(setting, extras, canopy)
    canopy.cover *= 1 - water
    _clear(
        setting, canopy, footprints(setting, buildings, True), footprints(setting, buildings, False)
    )
    if setting.dense and not setting.plain:
        lay_yards(rng, setting, image, near)
    lay_lots(rng, setting, image, lots)
    lay_drives(rng, setting, image, buildings)
    if setting.footways:
        lay_footways(rng, setting, image, roads)
    pave(rng, setting, image, roads)
    picture = (np.clip(image, 0, 1) * 255).astype(np.uint8)
    park(rng, setting, picture, roads)
    image = picture.astype(np.float32) / 255
    height = rng.uniform(4, 11)
    if hidden is not None:
        _hide(rng, setting, canopy, roads, hidden, height)
    shadow = thrown(canopy.shade, setting, height)
    for tall, height in ((True, 12.0), (False, 5.0)):
        roofs = footprints(setting, buildings, tall).astype(np.float32) / 255
        shadow = np.maximum(shadow, thrown(roofs, setting, height))
    shadow = cv2.GaussianBlur(shadow, (0, 0), max(0.3, setting.frame.length(0.4)))
    blue = np.array([0.92, 1.0, 1.05], np.float32)
    image *= 1 - setting.dusk * shadow[..., None] * blue
    picture = (np.clip(image, 0, 1) * 255).astype(np.uint8)
    fill_lots(rng, setting, picture, lots)
    build(rng, setting, picture, buildings)
    return picture.astype(np.float32) / 255, shadow, canopy


def _clear(setting: Setting, canopy: Canopy, *masks: Image) -> None:
    """No crown grows through a roof."""
    reach = 2 * int(setting.frame.length(2.0)) + 1
    for mask in masks:
        keep = (
            1 - cv2.dilate(mask, np.ones((reach, reach), np.uint8)).astype(np.float32) / 255 * 0.9
        )
        canopy.cover *= keep
        canopy.shade *= keep


def _hide(
    rng: np.random.Generator,
    setting: Setting,
    canopy: Canopy,
    roads: list[PlannedRoad],
    share: float,
    height: float,
) -> None:
    """Plant clumps of crowns over and beside the road until `share` of its length is hidden."""
    frame = setting.frame
    line = np.vstack([road.points[1:-1] for road in roads if len(road.points) > 8])
    line = line[((line > 0) & (line < frame.extent)).all(axis=1)]
    at = np.clip(frame.pixels(line).round().astype(int), 0, frame.size - 1)
    stamps = [stamp(rng, setting, frame.length(radius)) for radius in rng.uniform(3.0, 5.0, 8)]
    for _ in range(4 * len(line)):
        shadow = thrown(canopy.shade, setting, height)
        if (
            len(line) == 0
            or (np.maximum(shadow, canopy.cover)[at[:, 1], at[:, 0]] > 0.5).mean() >= share
        ):
            return
        middle = line[int(rng.integers(len(line)))]
        for _ in range(int(rng.integers(2, 6))):
            press(canopy, stamps[int(rng.integers(8))], middle + rng.normal(0, 4.5, 2), setting)


def signed_distance(frame: Frame, roads: list[PlannedRoad]) -> Layer:
    """Meters to the nearest road edge, negative on the road, (h, w)."""
    mask = np.zeros(frame.shape, np.uint8)
    for road in roads:
        window, cover = ribbon(frame.pixels(road.points), frame.length(road.width), frame.shape)
        mask[window] |= (cover > 0.5).astype(np.uint8)
    outside = cv2.distanceTransform(1 - mask, cv2.DIST_L2, 5)
    within = cv2.distanceTransform(mask, cv2.DIST_L2, 5)
    signed = (outside - within) * frame.meters_per_pixel
    return np.asarray(np.minimum(signed, 1e4), np.float32)


def true_roads(frame: Frame, roads: list[PlannedRoad]) -> tuple[TrueRoad, ...]:
    """The roads as they lie in the picture; what only joins them is not among them."""
    return tuple(
        TrueRoad(_pixels(frame, road), frame.length(road.width), road.closed)
        for road in roads
        if road.manner != "apron"
    )


def _pixels(frame: Frame, road: PlannedRoad) -> Floats:
    return frame.pixels(road.points)
