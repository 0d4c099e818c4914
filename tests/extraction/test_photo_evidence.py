"""Two nets: the second has a share in the evidence where the first sees wide roads."""

from __future__ import annotations

import hashlib
from dataclasses import replace
from importlib.resources import files
from typing import Any

import numpy as np
import pytest

from roadlang_standard.extraction.photos.photo_evidence import (
    Seen,
    look,
    share_of_second,
    typical_width,
)
from roadlang_standard.extraction.photos.road_net import Net, Predictor, road_net
from training.rendering.aerial import render_aerial

SIZE = 128


def street(width: int) -> Any:
    """A bright street from left to right on dark ground (h, w, 3)."""
    rng = np.random.default_rng(0)
    picture = rng.integers(40, 60, (SIZE, SIZE, 3))
    picture[SIZE // 2 - width // 2 : SIZE // 2 + width // 2] += 120
    return picture.astype(np.uint8)


def what_is_bright(chance: float) -> Predictor:
    """A net that takes what is bright for road, so surely."""

    def predict(tile: Any) -> Any:
        bright = tile[::2, ::2].mean(axis=2) > 128
        return np.repeat(np.where(bright, chance, 0.05)[None], 2, axis=0).astype(np.float32)

    return predict


def never(tile: Any) -> Any:
    raise AssertionError("the second net was run")


def test_narrow_roads_are_those_of_the_first_net() -> None:
    first = what_is_bright(0.9)
    alone, beside = (look(street(6), Net(first, "", second)) for second in (None, never))
    assert typical_width(alone.surface) < 10
    assert (alone.surface == beside.surface).all()
    assert (alone.blend == beside.blend).all()


def test_of_wide_roads_both_nets_have_a_share_in_the_log_odds() -> None:
    first = what_is_bright(0.9)
    seen = [look(street(28), Net(first, "", what_is_bright(p))) for p in (0.9, 0.4)]
    same, less = (float(it.surface[SIZE // 2, SIZE // 2]) for it in seen)
    share = share_of_second(28)
    assert same == pytest.approx(0.9, abs=1e-4)
    assert less / (1 - less) == pytest.approx(9 ** (1 - share) * (2 / 3) ** share, rel=1e-3)
    assert float(seen[1].blend[SIZE // 2, SIZE // 2]) == pytest.approx(less, abs=1e-3)


def test_the_share_grows_with_the_width_of_the_roads() -> None:
    shares = [share_of_second(width) for width in np.linspace(8, 16, 65).tolist()]
    assert shares == sorted(shares)
    assert shares[0] == share_of_second(10) == 0
    assert shares[-1] == share_of_second(14) < 1
    assert max(np.diff(shares)) < 0.05


def test_the_second_net_that_is_shipped_changes_what_is_seen_of_wide_roads() -> None:
    net = road_net()
    far, near = (render_aerial("bend", 12, SIZE, resolution).image for resolution in (1.0, 0.3))
    assert _difference(far, net) == 0
    assert 0.002 < _difference(near, net) < 0.3


def _difference(picture: Any, net: Net) -> float:
    """Of the evidence of both nets from that of the first alone, on average."""
    both, alone = (look(picture, it) for it in (net, replace(net, second=None)))
    return float(np.abs(both.blend - alone.blend).mean())


def test_a_tiny_picture_is_seen_at_its_size_alone() -> None:
    small: Seen = look(street(28)[:64], Net(what_is_bright(0.9), "", what_is_bright(0.4)))
    assert (small.surface == small.blend).all()


@pytest.mark.parametrize("name", ["roads.onnx", "wide_roads.onnx"])
def test_the_model_card_is_that_of_the_weights(name: str) -> None:
    weights = files("roadlang_standard.extraction.photos") / "weights"
    data = weights.joinpath(name).read_bytes()
    card = weights.joinpath("MODEL_CARD.md").read_text("utf-8")
    assert f"`{name}`" in card
    assert f"{len(data):,} bytes" in card
    assert hashlib.sha256(data).hexdigest() in card
