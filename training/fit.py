"""Fit the net: AdamW, warm-up, constant, then linear decay; an average of the weights is kept."""

from __future__ import annotations

import copy
import json
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import torch

from training.net import RoadNet, has_half_precision, loss
from training.reuse import reused


@dataclass(frozen=True)
class Schedule:
    """How long and how fast; ends at `steps`, or after `minutes` if that comes first."""

    steps: int = 6000
    minutes: float = 60.0
    rate: float = 2e-3
    decay: float = 1e-3
    warm_up: int = 100
    constant: float = 0.5
    average: float = 0.998
    uses: int = 1
    """batches that each crop is in"""

    def rate_at(self, step: int, share: float) -> float:
        """Learning rate; `share` is the part of the run that is over, 0..1."""
        warm = min(1.0, (step + 1) / self.warm_up)
        fall = max(0.02, min(1.0, (1 - share) / (1 - self.constant)))
        return self.rate * warm * fall


def fit(
    net: RoadNet,
    feed: Iterator[list[torch.Tensor]],
    schedule: Schedule,
    folder: Path,
    validate: Callable[[RoadNet], dict[str, float]],
    seed: int,
    every: int = 250,
) -> tuple[RoadNet, list[dict[str, float]]]:
    """The averaged net and the history of its scores; a checkpoint every `every` steps.

    What of the net needs no gradient stays as it is.
    """
    net = net.to(memory_format=torch.channels_last)
    average = copy.deepcopy(net)
    learned = [weight for weight in net.parameters() if weight.requires_grad]
    optimizer = torch.optim.AdamW(learned, lr=schedule.rate, weight_decay=schedule.decay)
    history: list[dict[str, float]] = []
    begun, running = time.monotonic(), 0.0
    for step, batch in enumerate(reused(feed, net.features, schedule.uses, seed)):
        share = max(step / schedule.steps, (time.monotonic() - begun) / 60 / schedule.minutes)
        for group in optimizer.param_groups:
            group["lr"] = schedule.rate_at(step, share)
        running += 0.02 * (_step(net, optimizer, *batch) - running)
        _follow(average, net, min(schedule.average, (step + 1) / (step + 10)))
        if (step + 1) % every == 0 or share >= 1:
            scores = {
                "step": step + 1,
                "share": round(share, 3),
                "loss": round(running, 4),
                **validate(average),
            }
            history.append(scores)
            print(json.dumps(scores), flush=True)
            torch.save(average.state_dict(), folder / "checkpoint.pt")
        if share >= 1:
            break
    return average, history


def _step(
    net: RoadNet,
    optimizer: torch.optim.Optimizer,
    features: list[torch.Tensor],
    target: torch.Tensor,
    weight: torch.Tensor,
) -> float:
    net.train()
    with torch.autocast("cpu", torch.bfloat16, enabled=has_half_precision()):
        logits = net.decoded(features)
    value = loss(logits.float(), target, weight)
    optimizer.zero_grad(set_to_none=True)
    value.backward()
    torch.nn.utils.clip_grad_norm_(net.parameters(), 2.0)
    optimizer.step()
    return float(value.detach())


def _follow(average: RoadNet, net: RoadNet, keep: float) -> None:
    with torch.no_grad():
        for kept, fresh in zip(
            average.state_dict().values(), net.state_dict().values(), strict=True
        ):
            if kept.dtype.is_floating_point:
                kept.mul_(keep).add_(fresh, alpha=1 - keep)
            else:
                kept.copy_(fresh)
