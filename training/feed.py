"""Batches without end from a pool of scenes, several crops per scene read."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import cv2
import numpy as np
import torch
from torch.utils.data import DataLoader, IterableDataset

from training.augment import crop
from training.pool import load, scenes

_CROPS_PER_READ = 4
_BUFFER = 96


class Crops(IterableDataset[tuple[np.ndarray, np.ndarray, np.ndarray]]):
    """Crops in a shuffled stream; the folder may grow while it is read."""

    def __init__(self, folder: Path, seed: int) -> None:
        self.folder, self.seed = folder, seed

    def __iter__(self) -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray]]:
        cv2.setNumThreads(1)
        info = torch.utils.data.get_worker_info()
        rng = np.random.default_rng([self.seed, info.id if info else 0])
        buffer: list[tuple[np.ndarray, np.ndarray, np.ndarray]] = []
        while True:
            ready = scenes(self.folder)
            for index in rng.permutation(len(ready))[:100]:
                scene = load(ready[index])
                buffer += [crop(rng, scene) for _ in range(_CROPS_PER_READ)]
                while len(buffer) > _BUFFER:
                    spot = int(rng.integers(len(buffer)))
                    buffer[spot], buffer[-1] = buffer[-1], buffer[spot]
                    yield buffer.pop()


def batches(folder: Path, seed: int, size: int, workers: int) -> Iterator[list[torch.Tensor]]:
    """Image (n, 3, 256, 256), target (n, 2, 128, 128), weight (n, 1, 128, 128)."""
    loader = DataLoader(
        Crops(folder, seed),
        batch_size=size,
        num_workers=workers,
        prefetch_factor=4 if workers else None,
    )
    for image, target, weight in loader:
        yield [
            image.permute(0, 3, 1, 2).contiguous(memory_format=torch.channels_last),
            target,
            weight,
        ]
