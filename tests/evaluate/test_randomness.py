"""Each draw depends on its seed, scene, attempt, place and element, and on nothing else."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang.evaluate.randomness import place_keys, retried, variant_keys

SCENES = np.array([-1, 0, 0, 1, 5, 10_000], np.int64)
ATTEMPTS = np.array([0, 0, 1, 0, 7, 1 << 40], np.int64)
KEYS = variant_keys(3, SCENES, ATTEMPTS)


def test_keys_differ_by_seed_scene_and_attempt() -> None:
    every = [*KEYS, *variant_keys(4, SCENES, ATTEMPTS), *variant_keys(3, ATTEMPTS, SCENES)]
    # (0, 0), (0, 1) and (1, 0) are in two of them
    assert len({int(key) for key in every}) == 3 * 6 - 3


@pytest.mark.parametrize("row", range(6))
def test_a_key_does_not_depend_on_the_candidates_beside_it(row: int) -> None:
    one = slice(row, row + 1)
    assert variant_keys(3, SCENES[one], ATTEMPTS[one]) == KEYS[one]
    assert place_keys(KEYS[one], "ego/at", 2) == place_keys(KEYS, "ego/at", 2)[one]
    elements = np.arange(6)
    assert place_keys(KEYS, "ego/at", elements)[row] == place_keys(KEYS, "ego/at", row)[row]


def test_keys_of_places_differ_by_place_and_element() -> None:
    places = [("ego/at", 0), ("ego/at", 1), ("ego/at", 2), ("lead/at", 0), ("lead/at", 1)]
    found = np.concatenate([place_keys(KEYS, place, element) for place, element in places])
    assert len(set(found.tolist())) == 5 * 6


def test_a_seed_counts_as_64_bits() -> None:
    assert (variant_keys(3 + 2**64, SCENES, ATTEMPTS) == KEYS).all()
    assert (variant_keys(-1, SCENES, ATTEMPTS) == variant_keys(2**64 - 1, SCENES, ATTEMPTS)).all()


def test_what_is_tried_again_is_drawn_anew_and_the_first_try_is_not() -> None:
    assert (retried(KEYS, np.zeros(6, np.int64)) == KEYS).all()
    tries = np.array([0, 1, 2, 0, 1, 3])
    again = retried(KEYS, tries)
    assert (again == KEYS).tolist() == (tries == 0).tolist()
    assert again[2] != retried(KEYS, np.ones(6, np.int64))[2]
    assert retried(KEYS[1:2], tries[1:2]) == again[1:2]
