"""One command: render, train, validate, export, write the model card.

python -m training --folder work/roadnet --photos FOLDER_WITH_MANIFEST
"""

from __future__ import annotations

import argparse
import json
from dataclasses import asdict
from pathlib import Path

import cv2
import torch

from training import measure, pool
from training.card import Run, card
from training.decoder import TransferNet
from training.export import export
from training.feed import batches
from training.fit import Schedule, fit
from training.net import PlainNet, RoadNet
from training.resume import resume

WEIGHTS = (
    Path(__file__).parents[1]
    / "plugins/standard/roadlang_standard/extraction/photos/weights/roads.onnx"
)
_VALIDATION_SEED = 77


def main() -> None:
    """Read the options and run all steps; those whose results are there are not repeated."""
    told = _options()
    cv2.setNumThreads(1)
    torch.manual_seed(told.seed)
    torch.set_num_threads(told.threads)
    pool.render(told.folder / "pool", told.seed, told.scenes, told.jobs)
    pool.render(told.folder / "validation", _VALIDATION_SEED, 12, told.jobs)
    rendered = measure.renderings(told.folder / "validation", 12)
    photos = measure.photos(told.photos) if told.photos else []

    def validate(net: RoadNet) -> dict[str, float]:
        scores = {"renderings": round(measure.relaxed_f1(net, rendered), 4)}
        if photos:
            scores["photos"] = round(measure.relaxed_f1(net, photos), 4)
        return scores

    schedule = Schedule(told.steps, told.minutes, told.rate, uses=told.uses)
    feed = batches(told.folder / "pool", told.seed, told.batch, told.workers)
    net, history = fit(_net(told), feed, schedule, told.folder, validate, told.seed)
    torch.save(net.state_dict(), told.folder / "final.pt")
    difference = export(net, told.output)
    run = Run(told.seed, told.scenes, told.batch, asdict(schedule), history, difference)
    told.output.with_suffix(".md").write_text(card(run, net, told.output))
    (told.folder / "history.json").write_text(json.dumps(history, indent=1))


def _net(told: argparse.Namespace) -> RoadNet:
    """The net to train, from where it is to go on."""
    net: RoadNet = PlainNet()
    if told.encoder is not None:
        net = TransferNet()
        net.encoder.load_pretrained(told.encoder)
    if told.start is not None and told.start.suffix == ".onnx":
        pictures, *_ = next(batches(told.folder / "pool", told.seed, 2 * told.batch, 0))
        resume(net, told.start, pictures)
    elif told.start is not None:
        net.load_state_dict(torch.load(told.start))
    return net


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m training", description=__doc__)
    parser.add_argument("--folder", type=Path, default=Path("out/roadnet"), help="scenes, weights")
    parser.add_argument("--photos", type=Path, help="photos with a manifest.json, to validate on")
    parser.add_argument("--output", type=Path, default=WEIGHTS, help="the ONNX file to write")
    parser.add_argument("--start", type=Path, help="weights (.pt, .onnx) to go on from")
    parser.add_argument(
        "--encoder", type=Path, help="weights (.pth) of EfficientNet-Lite0 to learn a decoder for"
    )
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--scenes", type=int, default=1200, help="scenes to render")
    parser.add_argument("--steps", type=int, default=5000)
    parser.add_argument("--minutes", type=float, default=90.0, help="end after this long at most")
    parser.add_argument("--rate", type=float, default=2e-3)
    parser.add_argument("--batch", type=int, default=12)
    parser.add_argument(
        "--uses", type=int, default=1, help="batches that each crop is in, on average"
    )
    parser.add_argument("--threads", type=int, default=1, help="of the net")
    parser.add_argument("--workers", type=int, default=1, help="processes that make crops")
    parser.add_argument("--jobs", type=int, default=2, help="processes that render")
    return parser.parse_args()


if __name__ == "__main__":
    main()
