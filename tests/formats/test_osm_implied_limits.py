"""Speed limits that OpenStreetMap writes as words."""

from __future__ import annotations

import pytest

from roadlang_formats.osm_reading.implied_limits import implied_limit
from roadlang_formats.osm_reading.way_lanes import speed_limit, way_lanes

KMH = 1 / 3.6
MPH = 0.44704


@pytest.mark.parametrize(
    ("written", "limit"),
    [
        ("DE:urban", 50 * KMH),
        (" DE:rural ", 100 * KMH),
        ("fr:rural", 80 * KMH),
        ("IT:motorway", 130 * KMH),
        ("AT:trunk", 100 * KMH),
        ("PL:living_street", 20 * KMH),
        ("DE:living_street", 7 * KMH),
        ("GB:nsl_single", 60 * MPH),
        ("GB:nsl_dual", 70 * MPH),
        ("UK:motorway", 70 * MPH),
        ("GB:zone20", 20 * MPH),
        ("DE:zone:30", 30 * KMH),
        ("BE:zone30", 30 * KMH),
        ("DE:30", 30 * KMH),
        ("walk", 7 * KMH),
    ],
)
def test_words_have_the_limit_of_their_country(written: str, limit: float) -> None:
    assert speed_limit(written) == pytest.approx(limit)


@pytest.mark.parametrize(
    "written",
    ["none", "signals", "variable", "DE:motorway", "US:urban", "DE:nowhere", "DE:0", "sign", "DE:"],
)
def test_other_words_have_none(written: str) -> None:
    assert implied_limit(written) is None
    assert speed_limit(written) is None


@pytest.mark.parametrize(
    ("tags", "limit"),
    [
        ({"maxspeed:type": "GB:nsl_single"}, 60 * MPH),
        ({"maxspeed:type": "sign", "source:maxspeed": "DE:urban"}, 50 * KMH),
        ({"zone:traffic": "FR:urban"}, 50 * KMH),
        ({"zone:maxspeed": "DE:30"}, 30 * KMH),
        ({"maxspeed": "40", "source:maxspeed": "DE:urban"}, 40 * KMH),
        ({"maxspeed": "none", "source:maxspeed": "DE:rural"}, None),
        ({"source:maxspeed": "survey"}, None),
    ],
)
def test_the_kind_of_limit_counts_where_the_limit_is_missing(
    tags: dict[str, str], limit: float | None
) -> None:
    lanes = way_lanes({"highway": "primary", **tags})
    expected = None if limit is None else pytest.approx(limit)
    assert (lanes.forward_limit, lanes.backward_limit) == (expected, expected)


@pytest.mark.parametrize(
    ("tags", "forward", "backward"),
    [
        ({"maxspeed:forward": "50", "maxspeed:backward": "30"}, 50 * KMH, 30 * KMH),
        ({"maxspeed": "70", "maxspeed:backward": "30 mph"}, 70 * KMH, 30 * MPH),
        ({"maxspeed:forward": "DE:urban"}, 50 * KMH, None),
        ({"maxspeed": "50", "maxspeed:forward": "none"}, None, 50 * KMH),
    ],
)
def test_the_limit_of_a_direction_counts_first(
    tags: dict[str, str], forward: float | None, backward: float | None
) -> None:
    lanes = way_lanes({"highway": "primary", **tags})
    found = lanes.forward_limit, lanes.backward_limit
    assert found == (
        None if forward is None else pytest.approx(forward),
        None if backward is None else pytest.approx(backward),
    )
