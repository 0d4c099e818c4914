"""Export the net as ONNX with half-precision weights, and check it against OpenCV."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import onnx
import torch
from onnx import TensorProto, helper, numpy_helper

from training.net import RoadNet


def export(net: RoadNet, path: Path) -> float:
    """Write `path`; the greatest difference between the net and OpenCV's reading of the file."""
    net = net.eval().float()
    dummy = torch.full((1, 3, 256, 256), 115.0)
    torch.onnx.export(
        net,
        (dummy,),
        str(path),
        opset_version=11,
        input_names=["image"],
        output_names=["maps"],
        dynamo=False,
    )
    model = halved(onnx.load(str(path)))
    model.doc_string = net.origin
    onnx.save(model, str(path))
    rng = np.random.default_rng(0)
    image = rng.uniform(0, 255, (1, 3, 256, 256)).astype(np.float32)
    reader = cv2.dnn.readNetFromONNX(str(path))
    reader.setInput(image)
    with torch.no_grad():
        expected = net(torch.from_numpy(image)).numpy()
    return float(np.abs(reader.forward() - expected).max())


def halved(model: onnx.ModelProto) -> onnx.ModelProto:
    """The model with its large weights stored as float16 and cast back when it is read."""
    graph = model.graph
    kept, casts = [], []
    for weight in graph.initializer:
        values = numpy_helper.to_array(weight)
        if weight.data_type != TensorProto.FLOAT or values.size < 256:
            kept.append(weight)
            continue
        stored = numpy_helper.from_array(values.astype(np.float16), weight.name + "_half")
        kept.append(stored)
        casts.append(helper.make_node("Cast", [stored.name], [weight.name], to=TensorProto.FLOAT))
    nodes = [*casts, *graph.node]
    del graph.initializer[:], graph.node[:]
    graph.initializer.extend(kept)
    graph.node.extend(nodes)
    return model
