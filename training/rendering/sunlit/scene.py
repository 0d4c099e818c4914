"""A scene of land, roads, houses and single trees under one sun."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np

from training.rendering.aerial import signed_distance, true_roads
from training.rendering.camera import expose
from training.rendering.extras import extras_of, lay_extras
from training.rendering.footways import lay_footways
from training.rendering.frame import Frame, Layer, PlannedRoad, Rendering, Truth
from training.rendering.ground import ground, polygon
from training.rendering.houses import Building, build, footprints, lay_drives, settle
from training.rendering.layouts.plans import PLANS
from training.rendering.leisure import lay_grounds
from training.rendering.noise import blend, fractal, smooth, streaks
from training.rendering.parking_lots import fill_lots, lay_lots, lay_yards
from training.rendering.pavement import park, pave
from training.rendering.setting import Setting, setting_of
from training.rendering.sunlit.sprites import (
    Sprite,
    View,
    bare_tree,
    leafy_tree,
    needle_tree,
)
from training.rendering.sunlit.stand import Stand, grow, spots
from training.rendering.trees import thrown

_SEASONS = (0.75, 0.15, 0.1)


def render_sunlit(plan: str, seed: int, size: int, meters_per_pixel: float) -> Rendering:
    """A scene of the named plan (see `PLANS`); the same arguments give the same bytes."""
    rng = np.random.default_rng([seed, list(PLANS).index(plan), 2])
    finer = 2 if meters_per_pixel > 0.6 else 1
    frame = Frame(size * finer, meters_per_pixel / finer)
    roads = PLANS[plan](rng, frame.extent)
    setting = _lit(rng, setting_of(rng, frame, plan, _SEASONS))
    near = signed_distance(frame, roads)
    image, water = _land(rng, setting, roads, near)
    buildings, lots = settle(rng, setting, roads, near, water)
    wood = _woodland(rng, setting, near, water)
    _floor(rng, setting, image, wood)
    _gardens(rng, setting, image, buildings)
    if setting.dense:
        lay_yards(rng, setting, image, near)
    lay_lots(rng, setting, image, lots)
    lay_drives(rng, setting, image, buildings)
    if setting.footways:
        lay_footways(rng, setting, image, roads)
    pave(rng, setting, image, roads)
    picture = (np.clip(image, 0, 1) * 255).astype(np.uint8)
    park(rng, setting, picture, roads)
    fill_lots(rng, setting, picture, lots)
    stand = _trees(rng, setting, wood, near, water, buildings)
    light = _sunlight(rng, setting, stand, buildings)
    lit = picture.astype(np.float32) / 255 * light
    picture = (np.clip(lit, 0, 1) * 255).astype(np.uint8)
    build(rng, setting, picture, buildings)
    lit = picture.astype(np.float32) / 255
    dim = 0.45 + 0.55 * cv2.GaussianBlur(stand.light, (0, 0), max(0.5, frame.length(0.6)))
    blend(lit, stand.color * dim[..., None], stand.cover)
    if finer > 1:
        lit = cv2.resize(lit, (size, size), interpolation=cv2.INTER_AREA)
    shown = Frame(size, meters_per_pixel)
    hidden = cv2.resize(np.maximum(stand.cover, 1 - stand.light), (size, size)) > 0.5
    truth = Truth(shown.shape, true_roads(shown, roads), hidden, meters_per_pixel)
    return Rendering(expose(rng, lit), truth)


def _lit(rng: np.random.Generator, setting: Setting) -> Setting:
    """Bright light and deep shadows, as on a clear day; leafless woods more often than not."""
    return replace(
        setting,
        slant=rng.uniform(0.5, 1.4),
        dusk=rng.uniform(0.5, 0.85),
        woods=setting.woods + rng.uniform(0.0, 0.5),
        overhang=rng.uniform(-2.0, 0.3),
        homes=setting.homes * rng.uniform(0.6, 1.0),
    )


def _land(
    rng: np.random.Generator, setting: Setting, roads: list[PlannedRoad], near: Layer
) -> tuple[Layer, Layer]:
    image, water = ground(rng, setting, near)
    lay_extras(setting, replace(extras_of(rng), thicket=0.0), image, water)
    lay_grounds(rng, setting, image)
    frame = setting.frame
    patches = fractal(rng, frame, rng.uniform(10, 40), 5, 0.7)
    grain = fractal(rng, frame, 1.2, 2)
    image *= (1 + rng.uniform(0.03, 0.14) * patches + rng.uniform(0.01, 0.07) * grain)[..., None]
    return image, water


def _woodland(rng: np.random.Generator, setting: Setting, near: Layer, water: Layer) -> Layer:
    """How densely trees stand, 0..1 (h, w)."""
    frame = setting.frame
    settled = -rng.uniform(0.3, 1.0) * setting.homes * np.clip(1 - near / rng.uniform(25, 50), 0, 1)
    field = fractal(rng, frame, rng.uniform(80, 400), 5, 0.55) + setting.woods + settled
    cover = np.clip(field * rng.uniform(2, 10), 0, 1)
    margin = -setting.overhang + rng.uniform(0, 2) * np.clip(smooth(rng, frame, 25), 0, 3)
    cover *= near > margin
    return np.asarray(cover * (water < 0.1), np.float32)


def _floor(rng: np.random.Generator, setting: Setting, image: Layer, wood: Layer) -> None:
    """Leaf litter and brush below the trees, in place."""
    frame = setting.frame
    litter = np.array([[0.30, 0.38, 0.47], [0.40, 0.43, 0.52], [0.36, 0.42, 0.44]])
    tone = litter[int(rng.integers(3))] * rng.normal(1, 0.15) * rng.normal(1, 0.05, 3)
    if not setting.leafless:
        tone = np.array(setting.palette["wood"]) * rng.uniform(0.7, 1.3)
    rough = 0.18 * fractal(rng, frame, 25) + 0.12 * fractal(rng, frame, 2.5, 3)
    rough += rng.uniform(0, 0.12) * streaks(rng, frame, 4, setting.sun)
    cover = cv2.GaussianBlur(wood, (0, 0), max(0.8, frame.length(1.5)))
    blend(image, np.clip(tone * (1 + rough[..., None]), 0.02, 1), np.clip(1.4 * cover, 0, 1))


def _gardens(
    rng: np.random.Generator, setting: Setting, image: Layer, buildings: list[Building]
) -> None:
    """Lawn of its own tone about each house, in place."""
    box = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    lawn, soil = np.array(setting.palette["lawn"]), np.array(setting.palette["soil"])
    spread, strong = rng.uniform(0.05, 0.25), rng.uniform(0.2, 0.9)
    for house in buildings:
        if rng.random() < 0.25:
            continue
        spin = np.array(
            [
                [np.cos(house.heading), -np.sin(house.heading)],
                [np.sin(house.heading), np.cos(house.heading)],
            ]
        )
        half = house.half + rng.uniform(4, 16, 2)
        middle = house.center + (house.center - house.door) * rng.uniform(-0.2, 0.5)
        corners = middle + (box * half * rng.uniform(0.85, 1.1, (4, 2))) @ spin.T
        tone = lawn + rng.beta(1, 3) * (soil - lawn)
        tone = np.clip(tone * rng.normal(1, spread) * rng.normal(1, spread / 3, 3), 0.02, 1)
        low = np.floor(setting.frame.pixels(corners.min(axis=0))).astype(int).clip(0)
        high = np.ceil(setting.frame.pixels(corners.max(axis=0))).astype(int).clip(0) + 2
        window = (slice(low[1], high[1]), slice(low[0], high[0]))
        part = image[window]
        if part.size == 0:
            continue
        local = Frame(max(part.shape[:2]), setting.frame.meters_per_pixel)
        cover = polygon(local, corners - low * setting.frame.meters_per_pixel)
        blend(part, tuple(tone), cover[: part.shape[0], : part.shape[1]] * strong)


def _trees(
    rng: np.random.Generator,
    setting: Setting,
    wood: Layer,
    near: Layer,
    water: Layer,
    buildings: list[Building],
) -> Stand:
    frame = setting.frame
    stand = Stand.empty(frame)
    free = (near > -setting.overhang) & (water < 0.1)
    reach = 2 * int(frame.length(1.5)) + 1
    for tall in (True, False):
        roofs = cv2.dilate(footprints(setting, buildings, tall), np.ones((reach, reach), np.uint8))
        free &= roofs < 128
    view = _view(rng, setting)
    evergreen = np.clip(
        3 * (fractal(rng, frame, rng.uniform(20, 90)) + rng.normal(-0.6, 0.8)), 0, 1
    )
    high = rng.uniform(7, 17)
    bare, dark, low = _kinds(rng, setting, view, high)
    open_land = np.clip(setting.trees * 60 / 10000 * (1 + smooth(rng, frame, 40)), 0, 0.6)
    density = np.maximum(wood, open_land) * free
    pitch = rng.uniform(3.0, 6.5) * (high / 12) ** 0.5
    places = spots(rng, frame, density.astype(np.float32), pitch)
    column, row = np.clip(frame.pixels(places).astype(int), 0, frame.size - 1).T
    is_dark = rng.random(len(places)) < np.maximum(evergreen[row, column], 0.06)
    bushes = spots(rng, frame, (density * free).astype(np.float32) * 0.5, rng.uniform(3, 6))
    grow(rng, frame, stand, low, bushes)
    grow(rng, frame, stand, bare, places[~is_dark])
    grow(rng, frame, stand, dark, places[is_dark])
    return stand


def _view(rng: np.random.Generator, setting: Setting) -> View:
    fall = -setting.slant * np.array([np.cos(setting.sun), np.sin(setting.sun)])
    turn = rng.uniform(0, 2 * np.pi)
    lean = rng.uniform(0, 0.3) * np.array([np.cos(turn), np.sin(turn)])
    return View(fall, lean, 1 / setting.frame.meters_per_pixel)


def _kinds(
    rng: np.random.Generator, setting: Setting, view: View, high: float
) -> tuple[list[Sprite], list[Sprite], list[Sprite]]:
    """Trees of the season, evergreens and bushes."""
    bark = np.full(3, rng.uniform(0.3, 0.6)) * [0.97, 0.99, 1.03] * rng.normal(1, 0.04, 3)
    green, leaf = np.array(setting.palette["evergreen"]), np.array(setting.palette["wood"])
    green, leaf = green * rng.uniform(0.9, 1.8), leaf * rng.uniform(0.9, 1.7)
    bare, dark, low = [], [], []
    for _ in range(14):
        tall = high * rng.uniform(0.6, 1.25)
        tone = np.asarray(rng.normal(1, 0.08) * rng.normal(1, 0.03, 3))
        if setting.leafless:
            bare.append(bare_tree(rng, view, tall, bark * tone))
        else:
            bare.append(leafy_tree(rng, view, tall, leaf * tone))
        kind = needle_tree if rng.random() < 0.6 else leafy_tree
        dark.append(kind(rng, view, 0.85 * tall, green * tone))
        brush = leaf if rng.random() < 0.6 else green
        low.append(leafy_tree(rng, view, rng.uniform(1, 3.5), brush * tone * rng.uniform(0.6, 1.4)))
    return bare, dark, low


def _sunlight(
    rng: np.random.Generator, setting: Setting, stand: Stand, buildings: list[Building]
) -> Layer:
    """Light on the ground (h, w, 3): sun where nothing throws a shadow, and the blue of the sky."""
    light = stand.light
    for tall, height in ((True, rng.uniform(8, 14)), (False, rng.uniform(4, 6.5))):
        roofs = footprints(setting, buildings, tall).astype(np.float32) / 255
        light = light * (1 - thrown(roofs, setting, height))
    light = cv2.GaussianBlur(light, (0, 0), max(0.4, setting.frame.length(0.25)))
    sky = np.array([1.12, 1.0, 0.93], np.float32) * np.float32(1 - setting.dusk)
    return np.asarray(sky + (1 - sky) * light[..., None], np.float32)
