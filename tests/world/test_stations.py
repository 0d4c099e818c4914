"""Stations: close enough for what is perturbed, and as close as a statement asks for."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from roadlang import testing
from roadlang.diagnostics import DiagnosticError
from roadlang.plugins.discovery import load_registry
from roadlang.scenes.sampling import SamplingResult
from roadlang.semantics import check_text
from tests.straight_road import STRAIGHT

Sample = Callable[..., SamplingResult]
LONG = "road main { draw with waypoints { points: [(0m, 0m), (10km, 0m)] } }\n"


def bent(*passes: str, options: str = "") -> str:
    return f"road bent from main {{ {options}\n" + "\n".join(passes) + "\n}\n"


def gap(road: object) -> float:
    stations = np.array(road.reference_stations)  # type: ignore[attr-defined]
    return float(np.diff(stations).max())


def refusal(sample: Sample, text: str) -> tuple[str, str]:
    with pytest.raises(DiagnosticError) as caught:
        sample(text)
    (diagnostic,) = caught.value.diagnostics
    return diagnostic.code, " ".join((diagnostic.message, *diagnostic.help))


def test_stations_are_a_meter_apart_closer_on_short_and_farther_apart_on_long_roads(
    sample: Sample,
) -> None:
    (straight,) = sample(STRAIGHT).scenes[0].roads
    assert gap(straight) == pytest.approx(1.0)
    short = "road main { draw with waypoints { points: [(0m, 0m), (10m, 0m)] } }"
    assert len(sample(short).scenes[0].roads[0].x) == 51
    assert gap(sample(LONG).scenes[0].roads[0]) == pytest.approx(5.0)


def test_a_wave_as_short_as_two_stations_is_not_lost(sample: Sample) -> None:
    text = STRAIGHT + bent("perturb with sine { amplitude: 0.2m, wavelength: 2m }")
    main, road = sample(text).scenes[0].roads
    assert gap(road) == gap(main) == pytest.approx(0.25)
    assert max(road.y) == pytest.approx(0.2, abs=1e-3)
    assert sample(text + "require near: always (deviation(bent, main) < 0.1m)\n").accepted == 0


def test_a_bump_between_two_stations_of_a_long_road_is_not_lost(sample: Sample) -> None:
    text = LONG + bent("perturb with bump { at: 5002.5m, height: 0.5m, length: 4m }")
    road = sample(text).scenes[0].roads[-1]
    assert max(road.y) == pytest.approx(0.5, abs=0.05)
    assert sum(y > 0 for y in road.y) >= 7
    assert sample(text + "require near: always (deviation(bent, main) < 0.1m)\n").accepted == 0


@pytest.mark.parametrize(
    "perturbation",
    [
        "sine { amplitude: 1m, wavelength: 4m }",
        "sine { amplitude: 1m, wavelength: 4m..90m }",
        "sine { amplitude: 1m, wavelength: 100m - (10m..96m) }",
        "random_walk { amplitude: 1m, correlation: 2m }",
        "harmonics { amplitude: 1m, modes: 100 / 1 }",
        "bump { at: 50m, height: 1m, length: 4m..20m }",
        "sine { amplitude: 1m, wavelength: 100m, over: [50m, 54m] }",
        "sine { amplitude: 1m, wavelength: 100m, over: [50m, 90m], taper: 2m }",
    ],
)
def test_the_shortest_feature_that_may_be_drawn_has_eight_stations(
    sample: Sample, perturbation: str
) -> None:
    text = STRAIGHT + bent(f"perturb with {perturbation.replace('100 / 1', '64')}")
    feature = 2 * 200 / 64 if "modes" in perturbation else 4.0
    (main, *_) = sample(text).scenes[0].roads
    assert gap(main) == pytest.approx(feature / 8, rel=0.02)


def test_all_that_derives_from_a_root_shares_its_stations(sample: Sample) -> None:
    text = (
        STRAIGHT
        + bent("perturb with sine { amplitude: 1m, wavelength: 90m }")
        + "road rough from bent { perturb with sine { amplitude: 0.1m, wavelength: 3m } }\n"
        + "road other { draw with waypoints { points: [(0m, 50m), (200m, 50m)] } }\n"
    )
    gaps = {road.name: gap(road) for road in sample(text).scenes[0].roads}
    assert gaps["main"] == gaps["bent"] == gaps["rough"] == pytest.approx(0.375, rel=0.01)
    assert gaps["other"] == pytest.approx(1.0)


def test_the_roads_of_a_network_are_sampled_for_what_perturbs_them(sample: Sample) -> None:
    town = '''
image plan from """
  ...#...
  #######
  ...#...
""" { scale: 12m/px, legend: { "#": road } }
network town from plan { extract with pixels }
network bent from town { perturb with bump { at: 15m, height: 0.2m, length: 2m } }
road through from bent { select: longest }
'''
    roads = sample(town).scenes[0].roads
    assert len(roads) > 4
    assert max(map(gap, roads)) <= 0.25 + 1e-9


def test_a_statement_sets_how_far_apart_stations_are(sample: Sample) -> None:
    for written, expected in (("0.1m", 0.1), ("20m", 20.0), ("3m", 200 / 67)):
        text = STRAIGHT.replace("width: 8m", f"station_spacing: {written}")
        assert gap(sample(text).scenes[0].roads[0]) == pytest.approx(expected)
    wave = "perturb with sine { amplitude: 1m, wavelength: 90m }"
    derived = STRAIGHT + bent(wave, options="station_spacing: 0.5m")
    assert [gap(r) for r in sample(derived).scenes[0].roads] == pytest.approx([0.5, 0.5])


def test_a_wave_is_shown_also_where_the_spacing_is_written(sample: Sample) -> None:
    text = STRAIGHT.replace("width: 8m", "station_spacing: 5m")
    text += bent("perturb with sine { amplitude: 1m, wavelength: 8m }")
    assert gap(sample(text).scenes[0].roads[0]) == pytest.approx(1.0)


def test_the_most_stations_and_not_one_more(sample: Sample) -> None:
    text = LONG.replace("} }", "}, station_spacing: 0.5m }")
    assert len(sample(text).scenes[0].roads[0].x) == 20_001
    code, message = refusal(sample, text.replace("0.5m", "0.4999m"))
    assert code == "RL419"
    assert "20,006" in message
    assert "write `station_spacing: 0.5m`" in message
    bump = "perturb with bump { at: 50m, height: 0.1m, length: LENGTH }"
    assert sample(LONG + bent(bump.replace("LENGTH", "4m"))).accepted == 1
    code, message = refusal(sample, LONG + bent(bump.replace("LENGTH", "3.99m")))
    assert code == "RL418"
    assert "show what is 4m long" in message
    # 20,000.5 gaps are 20,001 of them, with 20,002 stations at their ends.
    assert refusal(sample, LONG + bent(bump.replace("LENGTH", "3.9999m")))[0] == "RL418"


def test_the_smallest_of_several_spacings_counts(sample: Sample) -> None:
    text = STRAIGHT.replace("width: 8m", "width: 8m, station_spacing: 5m")
    wave = "perturb with sine { amplitude: 1m, wavelength: 90m }"
    text += bent(wave, options="station_spacing: 0.5m")
    assert [gap(road) for road in sample(text).scenes[0].roads] == pytest.approx([0.5, 0.5])


def test_the_spacing_cannot_be_random(sample: Sample, tmp_path: Path) -> None:
    text = STRAIGHT.replace("width: 8m", "station_spacing: 0.5m..1m")
    _, diagnostics = check_text(text, tmp_path / "scene.rl", {}, load_registry())
    assert [d.code for d in diagnostics] == ["RL229"]


def test_draws_that_no_stations_are_set_for_are_rejected_where_they_are_too_short(
    sample: Sample,
) -> None:
    """A normal distribution has no least value: nothing says how close the stations must be."""
    text = STRAIGHT + bent("perturb with sine { amplitude: 1m, wavelength: normal(9m, 0.7m) }")
    result = sample(text, 30)
    drawn = [scene.draws["bent/perturb 1/wavelength"] for scene in result.scenes]
    assert 8.0 <= min(drawn) < 9.0
    (row,) = [row for row in result.table if "8 stations" in row.text]
    assert row.rejected > 0


def test_intervals_that_are_drawn_must_hold_stations_too(sample: Sample) -> None:
    text = STRAIGHT + (
        "param a = 40m..60m\n"
        + bent("perturb with sine { amplitude: 1m, wavelength: 90m, over: [a, a + (1m..20m)] }")
    )
    result = sample(text, 20)
    assert any("8 stations" in row.text for row in result.table)
    for scene in result.scenes:
        road = scene.roads[-1]
        assert sum(abs(y) > 1e-6 for y in road.y) >= 8


@pytest.mark.parametrize(("spacing", "shortest"), [("1m", 8.0), ("2m", 16.0), ("3m", 24.0)])
def test_waves_of_unbounded_draws_are_refused_where_stations_would_hide_them(
    sample: Sample, spacing: str, shortest: float
) -> None:
    """A `normal` may draw any wavelength; a wave takes eight stations."""
    wave = "perturb with sine { amplitude: 0.1m, wavelength: normal(26m, 6m) }"
    text = STRAIGHT + bent(wave, options=f"station_spacing: {spacing}")
    drawn = [
        value
        for scene in testing.sample(text, 60)
        for place, value in scene.draws.items()
        if "wavelength" in place
    ]
    assert len(drawn) == 60
    assert min(drawn) >= 0.99 * shortest
    assert min(drawn) < max(16.0, shortest + 2.0)  # what the stations show is not refused
