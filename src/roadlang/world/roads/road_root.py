"""A road before any `perturb`."""

from __future__ import annotations

from dataclasses import dataclass

from ...diagnostics import Diagnostic
from ...geometry import CrossSection, CurveFrame, Path, WidthProfile
from ...ir.scenario import Input, ScenarioNetwork


@dataclass(frozen=True)
class LimitChange:
    """Where on a road another speed limit begins: arc length of its root, m/s (None: none)."""

    start: float
    speed_limit: float | None


@dataclass(frozen=True, eq=False)
class RoadRoot:
    """A road before any `perturb`.

    `section`, `lanes`: the lanes that its file gives it; `path`: the path of the network that it
    was selected as; `inputs`: the files that it was made from; `confidence`: that of the extractor
    in its network; of a road joined of several, `limits`: the speed limits along it, `starts`:
    where its parts begin, `warnings`: those about its parts.
    """

    id: str
    frame: CurveFrame
    width: WidthProfile | None = None
    section: CrossSection | None = None
    path: Path | None = None
    network: ScenarioNetwork | None = None
    inputs: tuple[Input, ...] = ()
    confidence: float = 1.0
    lanes: int | None = None
    limits: tuple[LimitChange, ...] = ()
    is_joined: bool = False
    starts: tuple[float, ...] = ()
    warnings: tuple[Diagnostic, ...] = ()
