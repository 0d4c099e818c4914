"""The road net: a small residual encoder and decoder, two sigmoid maps at half the input size."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import ClassVar

import torch
from torch import Tensor, nn
from torch.nn import functional

STEM, WIDE, EIGHTH, SIXTEENTH, HALF = 16, 32, 48, 88, 24


def conv(inputs: int, outputs: int, stride: int = 1, dilation: int = 1) -> nn.Sequential:
    """A 3x3 convolution, normalized, and what is positive of it."""
    filters = nn.Conv2d(inputs, outputs, 3, stride, dilation, dilation, bias=False)
    return nn.Sequential(filters, nn.BatchNorm2d(outputs), nn.ReLU(inplace=True))


class Residual(nn.Module):
    """Two 3x3 convolutions about a skip."""

    def __init__(self, width: int, dilation: int = 1) -> None:
        super().__init__()
        self.first = conv(width, width, 1, dilation)
        self.second = nn.Conv2d(width, width, 3, 1, dilation, dilation, bias=False)
        self.norm = nn.BatchNorm2d(width)

    def forward(self, x: Tensor) -> Tensor:
        """Features (n, c, h, w) of the same size."""
        return functional.relu(x + self.norm(self.second(self.first(x))))


class RoadNet(nn.Module, ABC):
    """RGB 0..255 (n, 3, h, w), sides multiples of 32, to (n, 2, h/2, w/2): surface, line."""

    origin: ClassVar[str]
    """Where its weights come from, and under which license."""

    @abstractmethod
    def features(self, x: Tensor) -> list[Tensor]:
        """What the part that learns starts from."""

    @abstractmethod
    def decoded(self, features: list[Tensor]) -> Tensor:
        """The two maps before the sigmoid, of features."""

    def logits(self, x: Tensor) -> Tensor:
        """The two maps before the sigmoid."""
        return self.decoded(self.features(x))

    def forward(self, x: Tensor) -> Tensor:
        """Probabilities in [0, 1]; `logits` gives them before the sigmoid."""
        return torch.sigmoid(self.logits(x))


class PlainNet(RoadNet):
    """All of it learned from renderings."""

    origin: ClassVar[str] = (
        "No photograph was used for training, so no third party's rights touch the weights."
    )

    def __init__(self) -> None:
        super().__init__()
        self.stem = nn.Sequential(conv(3, STEM, 2), conv(STEM, STEM))
        self.quarter = nn.Sequential(conv(STEM, WIDE, 2), Residual(WIDE))
        self.eighth = nn.Sequential(conv(WIDE, EIGHTH, 2), Residual(EIGHTH), Residual(EIGHTH, 2))
        deep = [Residual(SIXTEENTH, dilation) for dilation in (1, 2, 4)]
        self.sixteenth = nn.Sequential(conv(EIGHTH, SIXTEENTH, 2), *deep)
        self.to_eighth = nn.Conv2d(SIXTEENTH, EIGHTH, 1)
        self.up_eighth = Residual(EIGHTH)
        self.to_quarter = nn.Conv2d(EIGHTH, WIDE, 1)
        self.up_quarter = Residual(WIDE)
        self.to_half = nn.Conv2d(WIDE, HALF, 1)
        self.skip_half = nn.Conv2d(STEM, HALF, 1)
        self.up_half = conv(HALF, HALF)
        self.head = nn.Conv2d(HALF, 2, 1)
        nn.init.constant_(self.head.bias, -2.5)

    def features(self, x: Tensor) -> list[Tensor]:
        """The picture itself."""
        return [x]

    def decoded(self, features: list[Tensor]) -> Tensor:
        """See `RoadNet.decoded`."""
        (x,) = features
        half = self.stem((x - 115.0) / 60.0)
        quarter = self.quarter(half)
        eighth = self.eighth(quarter)
        deep = self.sixteenth(eighth)
        y = self.up_eighth(twice(self.to_eighth(deep)) + eighth)
        y = self.up_quarter(twice(self.to_quarter(y)) + quarter)
        y = self.up_half(twice(self.to_half(y)) + self.skip_half(half))
        return self.head(y)


def has_half_precision() -> bool:
    """Whether bfloat16 is faster than float32 on this processor; on others it takes far longer."""
    return "AVX512" in torch.backends.cpu.get_cpu_capability()


def twice(x: Tensor) -> Tensor:
    """Twice as large, each value repeated."""
    return functional.interpolate(x, scale_factor=2, mode="nearest")


def loss(logits: Tensor, target: Tensor, weight: Tensor) -> Tensor:
    """2 BCE + soft Dice per map, the line at half weight; (n, 2, h, w), weight (n, 1, h, w)."""
    total = logits.new_zeros(())
    for channel, share in ((0, 1.0), (1, 0.5)):
        z, t, w = logits[:, channel], target[:, channel], weight[:, 0]
        entropy = (functional.binary_cross_entropy_with_logits(z, t, reduction="none") * w).mean()
        p = torch.sigmoid(z) * w
        t = t * w
        dice = 1 - (2 * (p * t).sum() + 1) / ((p * p).sum() + (t * t).sum() + 1)
        total = total + share * (2 * entropy + dice)
    return total
