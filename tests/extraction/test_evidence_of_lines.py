"""Lines of a graph by the evidence along them: how sure each pixel is road."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang_standard.extraction.graphs.dead_end_extension import extend_dead_ends
from roadlang_standard.extraction.graphs.evidence_pruning import (
    discounted_length,
    drop_unworthy,
    mean_evidence,
    prune_by_discounted_length,
)
from roadlang_standard.extraction.graphs.graph import Line
from roadlang_standard.extraction.graphs.linking import link
from tests.extraction.graph_drawings import Point, dense, graph_of, surface


def lit(value: float, *bands: tuple[slice, slice]) -> np.ndarray:
    return surface(100, 200, *bands) * np.float32(value)


def test_the_evidence_of_a_line_is_its_mean() -> None:
    score = lit(0.8, (slice(0, 100), slice(0, 100)))
    line = Line(0, 1, dense((60, 50), (139.0, 50)))
    assert mean_evidence(line, score) == pytest.approx(0.4, abs=0.02)
    # (0.4 - 0.2) / (1 - 0.2) of its 79 px
    assert discounted_length(line, score, 0.2) == pytest.approx(79 / 4, abs=1.5)
    assert discounted_length(line, score, 0.5) == 0.0


@pytest.mark.parametrize(("least", "count"), [(14.0, 3), (16.0, 1)])
def test_dead_ends_go_by_what_they_are_worth(least: float, count: int) -> None:
    """30 px of evidence 0.6 above a floor of 0.2 are worth 15 px."""
    score = lit(0.6, (slice(0, 100), slice(0, 200)))
    graph = graph_of(((20, 40), (100, 40)), ((100, 40), (180, 40)), ((100, 40), (100, 70)))
    prune_by_discounted_length(graph, score, least, 0.2)
    assert len(graph.lines) == count


@pytest.mark.parametrize(("least", "count"), [(29.0, 3), (31.0, 1)])
def test_a_dead_end_at_the_border_needs_half_as_much(least: float, count: int) -> None:
    score = lit(0.6, (slice(0, 100), slice(0, 200)))
    graph = graph_of(((20, 66), (100, 66)), ((100, 66), (180, 66)), ((100, 66), (100, 96)))
    prune_by_discounted_length(graph, score, least, 0.2)
    assert len(graph.lines) == count


@pytest.mark.parametrize(
    ("corners", "least", "count"),
    [(((20, 50), (100, 50)), 39.0, 1), (((20, 50), (100, 50)), 41.0, 0),
     (((50, 2), (50, 98)), 95.0, 1), (((50, 2), (50, 98)), 97.0, 0),
     (((50, 2), (50, 82)), 41.0, 0)],
)  # fmt: skip
def test_parts_go_by_what_they_are_worth_and_half_will_do_across_the_picture(
    corners: tuple[Point, Point], least: float, count: int
) -> None:
    """Evidence of 0.6 above a floor of 0.2 is worth half of each pixel."""
    graph = graph_of(corners)
    drop_unworthy(graph, lit(0.6, (slice(0, 100), slice(0, 200))), least, 0.2)
    assert len(graph.lines) == count


@pytest.mark.parametrize(("gap", "joined"), [(40, True), (56, False)])
def test_a_gap_is_bridged_up_to_a_distance(gap: int, joined: bool) -> None:
    graph = graph_of(((0, 50), (70, 50)), ((70 + gap, 50), (199, 50)))
    link(graph, np.full((100, 200), 0.3, np.float32), 50.0, 0.8, 8.0)
    assert (len(graph.lines) == 1) == joined
    if joined:
        assert graph.lines[0].linked == pytest.approx(gap / 199, abs=0.02)


@pytest.mark.parametrize(("worst", "joined"), [(0.19, True), (0.17, False)])
def test_a_bridge_between_ends_in_one_line_costs_15_percent(worst: float, joined: bool) -> None:
    """Evidence of 0.3 costs -ln 0.3 + 0.05 = 1.25 a pixel, of which 0.15 count: 0.19.

    Half a cell at either end lies on the roads, so that a little less is counted.
    """
    graph = graph_of(((0, 50), (70, 50)), ((100, 50), (199, 50)))
    link(graph, np.full((100, 200), 0.3, np.float32), 50.0, worst, 8.0)
    assert (len(graph.lines) == 1) == joined


def test_a_dead_end_joins_the_road_that_it_runs_into() -> None:
    graph = graph_of(((100, 2), (100, 97)), ((20, 50), (75, 50)))
    score = lit(0.9, (slice(45, 55), slice(0, 200)))
    link(graph, score, 50.0, 0.8, 8.0)
    assert sorted(graph.degree().values()) == [1, 1, 1, 3]
    knot = next(node for node, count in graph.degree().items() if count == 3)
    assert graph.nodes[knot] == pytest.approx([100, 50], abs=2.0)


def test_the_nearest_fainter_line_goes_on() -> None:
    """Two faint bits in a row, 12 px and 8 px apart: the road takes both."""
    score = lit(0.95, (slice(47, 54), slice(0, 80)))
    for columns in (slice(92, 120), slice(128, 170)):
        score[47:54, columns] = 0.5
    graph = graph_of(((0, 50), (77, 50)))
    extend_dead_ends(graph, score, (0.4, 0.27), 7.0, 20.0)
    (line,) = graph.lines
    assert line.points[:, 0].max() > 160
    assert 0.1 < line.linked < 0.3
    short = graph_of(((0, 50), (77, 50)))
    extend_dead_ends(short, score, (0.4, 0.27), 7.0, 10.0)
    assert short.lines[0].points[:, 0].max() == 77


def test_no_bridge_leads_back_along_the_road_that_ends() -> None:
    """A short street in sure evidence ends 60 px from the road that it branches off."""
    graph = graph_of(((0, 90), (100, 90)), ((100, 90), (199, 90)), ((100, 90), (100, 30)))
    score = lit(0.99, (slice(80, 100), slice(0, 200)), (slice(20, 100), slice(90, 110)))
    link(graph, score, 120.0, 0.8, 20.0)
    assert sorted(graph.degree().values()) == [1, 1, 1, 3]
    assert all(line.linked == 0 for line in graph.lines)
