"""Draws keyed by (seed, scene, attempt, place, element): each depends on nothing else."""

from __future__ import annotations

import hashlib
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from ..ir.batch import mix

Words = NDArray[np.uint64]
_GOLDEN = np.uint64(0x9E3779B97F4A7C15)
_SILVER = np.uint64(0xD1B54A32D192ED03)


def variant_keys(seed: int, scenes: NDArray[np.int64], attempts: NDArray[np.int64]) -> Words:
    """(V,) one word for each candidate."""
    with np.errstate(over="ignore"):
        words = mix(np.full(1, seed % 2**64, np.uint64) ^ _SILVER)
        words = mix(words + scenes.astype(np.uint64) * _GOLDEN)
        return mix(words + attempts.astype(np.uint64) * _SILVER)


def place_keys(variants: Words, place: str, element: int = 0) -> Words:
    """(V,) one word for each candidate at a place; `element` numbers its roads or copies."""
    with np.errstate(over="ignore"):
        return mix(mix(variants ^ _word(place)) + np.uint64(element) * _GOLDEN)


@lru_cache(maxsize=4096)
def _word(place: str) -> np.uint64:
    digest = hashlib.blake2b(place.encode(), digest_size=8).digest()
    return np.uint64(int.from_bytes(digest, "little"))
