"""Draws keyed by (seed, scene, attempt, place, element): each depends on nothing else."""

from __future__ import annotations

import hashlib
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..ir.batch import mix, numbered

Words = NDArray[np.uint64]
_SILVER = np.uint64(0xD1B54A32D192ED03)


def variant_keys(seed: int, scenes: NDArray[np.int64], attempts: NDArray[np.int64]) -> Words:
    """(V,) one word for each candidate."""
    with np.errstate(over="ignore"):
        words = mix(np.full(1, seed % 2**64, np.uint64) ^ _SILVER)
        words = mix(numbered(words, scenes))
        return mix(words + attempts.astype(np.uint64) * _SILVER)


def place_keys(variants: Words, place: str, element: ArrayLike = 0) -> Words:
    """(V,) one word for each candidate at a place; `element`, a number or (V,), numbers its roads
    or copies."""
    return mix(numbered(mix(variants ^ _word(place)), np.asarray(element)))


def retried(words: Words, tries: NDArray[np.int64]) -> Words:
    """The words (V,) of what is drawn again, by the number of the try; those of try 0 as they
    were."""
    again = tries > 0
    if not again.any():
        return words
    with np.errstate(over="ignore"):
        return np.where(again, mix(words ^ (tries.astype(np.uint64) * _SILVER)), words)


@lru_cache(maxsize=4096)
def _word(place: str) -> np.uint64:
    digest = hashlib.blake2b(place.encode(), digest_size=8).digest()
    return np.uint64(int.from_bytes(digest, "little"))
