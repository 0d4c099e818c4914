"""The card that goes with the weights: what they are, how they were made, how far to trust them."""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from training.net import RoadNet, has_half_precision


@dataclass(frozen=True)
class Run:
    """The settings of a training run and what it measured."""

    seed: int
    scenes: int
    batch: int
    schedule: dict[str, Any]
    history: list[dict[str, float]]
    difference: float


def card(run: Run, net: RoadNet, weights: Path) -> str:
    """Markdown."""
    count = sum(parameter.numel() for parameter in net.parameters())
    numbers = "bfloat16" if has_half_precision() else "float32"
    digest = hashlib.sha256(weights.read_bytes()).hexdigest()
    rows = "\n".join(f"| {' | '.join(str(v) for v in row.values())} |" for row in run.history[-8:])
    head = " | ".join(run.history[-1]) if run.history else "step"
    rule = "|".join(["---"] * (head.count("|") + 1))
    return f"""# The neural network of roadlang

`{weights.name}`: {count:,} parameters, {weights.stat().st_size:,} bytes, sha256 `{digest}`.

**What it does.** RGB in 0..255 (1, 3, h, w), sides multiples of 32, to two maps (1, 2, h/2, w/2)
in 0..1: road surface, and nearness to a center line. OpenCV reads it; weights are stored as float16
(greatest difference from the trained network {run.difference:.1e}).

**Data.** {run.scenes} scenes of the project's own seeded renderer (`rendering/`), seed {run.seed},
640 px (512 under one sun), 0.25 to 1.25 m/px. {net.origin}
Photos, where given, were used only for validation.

**Recipe.** `python -m training`; batch {run.batch} of 256 px crops, {numbers} on the CPU,
`{json.dumps(run.schedule)}`.

**Scores while training** (relaxed F1 of ridge pixels at 3 px):

| {head} |
|{rule}|
{rows}

**Limits.** Made for photos from straight above in visible light, 0.25 to 1.5 m a pixel. Driveways,
parking lots, railways and beaches are sometimes taken for roads; roads under closed crowns are
missed. Confidence is fitted to the evidence along roads of the shipped network: fit it again for
this one.
"""
