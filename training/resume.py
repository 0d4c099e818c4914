"""A net to go on training from an exported file: normalizations are unfolded again."""

from __future__ import annotations

from pathlib import Path

import onnx
import torch
from onnx import numpy_helper
from torch import Tensor, nn

from training.net import RoadNet


def resume(net: RoadNet, path: Path, pictures: Tensor) -> None:
    """Give `net` the weights of the same net in an ONNX file.

    The file has each normalization folded into the convolution before it. `pictures`, those that
    the net is to learn from, tell what each has to normalize for the net to compute the same.
    """
    convolutions = [module for module in net.modules() if isinstance(module, nn.Conv2d)]
    norms = [module for module in net.modules() if isinstance(module, nn.BatchNorm2d)]
    order: list[nn.Conv2d] = []
    noted = [module.register_forward_hook(lambda m, *_: order.append(m)) for module in convolutions]
    net.eval()
    net(pictures[:1])
    for hook in noted:
        hook.remove()
    biases: dict[nn.Conv2d, Tensor] = {}
    with torch.no_grad():
        for module, (weight, bias) in zip(order, _stored(path), strict=True):
            module.weight.copy_(weight)
            if module.bias is None:
                biases[module] = bias
            else:
                module.bias.copy_(bias)
        last: list[nn.Conv2d] = []
        hooks = [module.register_forward_hook(lambda m, *_: last.append(m)) for module in biases]
        hooks += [
            norm.register_forward_pre_hook(lambda m, x: _unfold(m, x[0], biases[last[-1]]))
            for norm in norms
        ]
        net(pictures)
    for hook in hooks:
        hook.remove()


def _stored(path: Path) -> list[tuple[Tensor, Tensor]]:
    """Weight and bias of each convolution, in the order in which they are computed."""
    graph = onnx.load(str(path)).graph
    kept = {
        it.name: torch.from_numpy(numpy_helper.to_array(it).copy()).float()
        for it in graph.initializer
    }
    for node in graph.node:
        if node.op_type == "Cast":
            kept[node.output[0]] = kept[node.input[0]]
    return [
        (kept[node.input[1]], kept[node.input[2]]) for node in graph.node if node.op_type == "Conv"
    ]


def _unfold(norm: nn.BatchNorm2d, seen: Tensor, bias: Tensor) -> None:
    """Make `norm` add `bias` to what it sees, and nothing else, while it normalizes it."""
    assert norm.running_mean is not None
    assert norm.running_var is not None
    mean, variance = seen.mean(dim=(0, 2, 3)), seen.var(dim=(0, 2, 3))
    norm.running_mean.copy_(mean)
    norm.running_var.copy_(variance)
    norm.weight.copy_(torch.sqrt(variance + norm.eps))
    norm.bias.copy_(mean + bias)
