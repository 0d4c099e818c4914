"""`perturb with scale`: bends sharper or flatter."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from roadlang.api import Number, Perturber, option


@dataclass(frozen=True)
class Scale(Perturber):
    """Scale the distance of the road from its chord (closed: from its centroid)."""

    name: ClassVar[str] = "scale"
    factor: Number = option(minimum=0, help="1 leaves the road as it is, 0 makes it straight")
