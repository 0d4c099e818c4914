"""Networks of a scene that do not lie beside each other as they do on Earth."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from ..diagnostics import Code, Diagnostic, diagnose
from ..evaluate.candidates import CandidateBatch
from ..geometry.earth.local_projection import LocalProjection
from ..ir.scenario import ScenarioImage, ScenarioNetwork
from ..world.networks.networks import network_root

_SAME = 1.0
"""Meters between two origins that count as one."""

Placed = tuple[ScenarioNetwork, tuple[float, float]]


def origin_warnings(
    networks: Sequence[ScenarioNetwork], candidates: CandidateBatch
) -> tuple[Diagnostic, ...]:
    """RL445 for each network whose origin on Earth is not that of the first that has one."""
    roots = ((network, network_root(network, candidates).network) for network in networks)
    placed = [(network, root.origin) for network, root in roots if root.origin is not None]
    return tuple(_warnings(placed, candidates))


def _warnings(placed: list[Placed], candidates: CandidateBatch) -> Iterator[Diagnostic]:
    for network, origin in placed[1:]:
        first, first_origin = placed[0]
        away = math.hypot(*LocalProjection(*first_origin).point(*origin))
        if away <= _SAME:
            continue
        is_picture = isinstance(candidates.scenario.source_of(network), ScenarioImage)
        changed, wanted = (first.name, origin) if is_picture else (network.name, first_origin)
        latitude, longitude = (f"{degrees:.7g}deg" for degrees in wanted)
        yield diagnose(
            Code.PLACES_APART,
            network.span,
            name=first.name,
            other=network.name,
            distance=f"{away:.0f}m" if away < 10_000.0 else f"{away / 1000.0:.0f}km",
            help=f"read `{changed}` around the other: `origin: ({latitude}, {longitude})` in the "
            "block of its `read with`, as in `read with osm { origin: ... }`",
        )
