"""A whole scene as one figure: title, map, legend."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from roadlang.api import shown_junctions

from . import actors, furniture, ghost, labels, palette, photo, profiles
from .agent_routes import agent_routes
from .ids import network_ids
from .legend import legend_of
from .markup import element, group, text, title
from .ribbon import Ribbon, Ribbons
from .roads import roads
from .selection import Selection, select
from .tightest import tight_places
from .viewport import Viewport, bounds, fitted
from .violations import violations

if TYPE_CHECKING:
    from roadlang.api import Picture, Scene
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Style:
    """What a drawing shows; `size` is its width in pixels."""

    size: float = 1024.0
    ghost: bool = True
    labels: bool = True
    legend: bool = True
    stations: bool = True
    ids: bool = True
    profiles: bool = True
    photo: Picture | None = None
    fade: float = 0.35

    @property
    def font(self) -> float:
        """Pixels of the labels: the same share of a small and a large figure."""
        return max(self.size / 78, 7.0)


def draw(scene: Scene, style: Style) -> str:
    """The SVG document of a scene."""
    size, pad = style.font, 1.2 * style.font
    top = pad + 2.3 * size
    viewport = fitted(bounds(scene), pad, top, style.size - 2 * pad)
    below = top + viewport.height + 0.9 * size
    bar = 0.26 * viewport.width
    legend = legend_of(scene, viewport.width - bar, size) if style.legend else None
    foot = max(0.0 if legend is None else legend.height, 2.6 * size)
    plots = profiles.rows_of(scene) if style.profiles else []
    strip = below + foot + 0.8 * size
    parts = [
        element("defs", furniture.clip(viewport, "map")),
        _heading(scene, style, pad, pad + 1.2 * size),
        map_of(scene, viewport, style),
        furniture.frame(viewport),
        furniture.north_arrow(
            viewport.x + viewport.width - 1.9 * size, viewport.y + 3.4 * size, size
        ),
        furniture.world_note(scene, viewport, size),
        furniture.scale_bar(viewport, size, style.size - pad - 2.2 * size, below + 0.3 * size),
        "" if legend is None else legend.drawn(pad, below - 0.2 * size),
        profiles.profiles(plots, pad, strip, viewport.width, size),
    ]
    bottom = strip + profiles.height(plots, size) if plots else below + foot
    return document(parts, style.size, bottom + pad, _described(scene))


def map_of(scene: Scene, viewport: Viewport, style: Style, clip: str = "map") -> str:
    """The map alone, clipped to its rectangle."""
    selection = select(scene)
    ribbons = Ribbons(scene, viewport)
    measured = _measured(scene, selection, ribbons, viewport) if style.stations else []
    numbers = [
        box
        for ribbon, others in measured
        for box in furniture.station_boxes(ribbon, viewport, style.font, others)
    ]
    parts = [
        furniture.ground(viewport),
        photo.beneath(style.photo, viewport, style.fade) if style.photo is not None else "",
        ghost.context(ribbons[name] for name in selection.context),
        ghost.ghosts(ribbons[name] for name in selection.ghosts) if style.ghost else "",
        roads(scene, ribbons, selection.full, viewport),
        ghost.versions((ribbons[name] for name in selection.versions), style.font),
        ghost.routes((ribbons[name] for name in selection.routes), style.font),
        _road_names(scene, selection, ribbons, style),
        ghost.ghost_lines(ribbons[name] for name in selection.ghosts) if style.ghost else "",
        violations(scene, ribbons),
        actors.objects(scene, viewport),
        *(
            furniture.station_marks(ribbon, viewport, style.font, others)
            for ribbon, others in measured
        ),
        network_ids(scene, selection.full, viewport, style.font) if style.ids else "",
        agent_routes(scene, viewport, style.font),
        actors.agents(scene, viewport),
        tight_places(scene, ribbons, style.font, numbers)
        if style.profiles and style.labels
        else "",
        labels.actor_labels(scene, viewport, style.font, numbers) if style.labels else "",
    ]
    return group(parts, class_="map", clip_path=f"url(#{clip})")


def _road_names(
    scene: Scene, selection: Selection, ribbons: Mapping[str, Ribbon], style: Style
) -> str:
    """Of what is drawn in full and is no road of a network."""
    if not style.labels:
        return ""
    full = [r.name for r in scene.roads if r.name in selection.full and r.network is None]
    return labels.road_names((ribbons[name] for name in full), style.font)


def _measured(
    scene: Scene, selection: Selection, ribbons: Mapping[str, Ribbon], viewport: Viewport
) -> list[tuple[Ribbon, list[Floats]]]:
    """What is drawn with marks of its arc length, each with the surfaces of all other roads."""
    names = [
        road.name for road in scene.roads if road.name in selection.measured and not road.network
    ]
    if not names:
        return []
    areas = [viewport.place(place.area) for place in shown_junctions(scene, set(selection.full))]
    return [
        (
            ribbons[name],
            [ribbons[other].outline() for other in selection.full if other != name] + areas,
        )
        for name in names
    ]


def _heading(scene: Scene, style: Style, x: float, base: float) -> str:
    caption = scene.title or scene.name
    provenance = scene.provenance
    note = f"{scene.name} · scene {scene.index} · seed {provenance.seed}"
    room = int((style.size - 3 * x) / (0.62 * style.font)) - len(note)
    shown = caption if len(caption) <= room else caption[: max(room - 1, 1)].rstrip() + "…"
    size = style.font
    return group(
        [
            text(shown, x, base, font_size=1.3 * size, font_weight="700", fill=palette.INK),
            text(note, style.size - x, base, text_anchor="end", font_size=0.9 * size,
                 fill=palette.MUTED_INK),
        ],
        class_="heading",
    )  # fmt: skip


def _described(scene: Scene) -> str:
    return f"{scene.title or scene.name}: scene {scene.index}, seed {scene.provenance.seed}"


def document(parts: list[str], width: float, height: float, description: str) -> str:
    """An SVG document on white."""
    body = [
        title(description),
        element("rect", width="100%", height="100%", fill="#ffffff"),
        *(part for part in parts if part),
    ]
    svg = element(
        "svg",
        "\n",
        "\n".join(body),
        "\n",
        xmlns="http://www.w3.org/2000/svg",
        viewBox=f"0 0 {width:.0f} {height:.0f}",
        width=f"{width:.0f}",
        height=f"{height:.0f}",
        font_family=palette.FONT,
    )
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{svg}\n'
