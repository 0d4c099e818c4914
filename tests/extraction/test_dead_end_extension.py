"""Roads that end in shade go on: along fainter evidence, to what faces them, to the rim."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np

from roadlang_standard.extraction.graphs.dead_end_extension import extend_dead_ends
from roadlang_standard.extraction.graphs.dead_ends import dead_ends
from roadlang_standard.extraction.graphs.graph import Graph, Line
from roadlang_standard.extraction.graphs.graph_cleanup import drop_loops, join, prune
from roadlang_standard.extraction.graphs.linking import link
from roadlang_standard.extraction.graphs.tracing import trace
from roadlang_standard.extraction.masks.skeleton import skeleton

SIZE = 200


def evidence(*strokes: Any) -> Any:
    """Strokes (start, end, value) of 7 pixels on nothing."""
    canvas = np.full((SIZE, SIZE), 0.02, np.float32)
    for start, end, value in strokes:
        cv2.line(canvas, start, end, value, 7)
    return cv2.GaussianBlur(canvas, (0, 0), 1.0)


def sure_roads(score: Any) -> Any:
    graph = trace(skeleton(score > 0.8))
    prune(graph, 8)
    join(graph)
    return graph


def test_a_road_goes_on_along_fainter_evidence() -> None:
    score = evidence(((0, 100), (90, 100), 0.95), ((100, 100), (170, 110), 0.5))
    graph = sure_roads(score)
    extend_dead_ends(graph, score, (0.4, 0.27), 7, 50)
    (line,) = graph.lines
    assert line.points[:, 0].max() > 160


def test_a_fainter_line_from_the_side_is_left_out() -> None:
    score = evidence(((0, 100), (199, 100), 0.95), ((100, 108), (100, 170), 0.5))
    graph = sure_roads(score)
    extend_dead_ends(graph, score, (0.4, 0.27), 7, 50)
    assert len(graph.lines) == 1


def test_a_fainter_line_that_turns_away_is_left_out() -> None:
    score = evidence(((0, 100), (90, 100), 0.95), ((100, 110), (100, 180), 0.5))
    graph = sure_roads(score)
    extend_dead_ends(graph, score, (0.4, 0.27), 7, 50)
    assert max(line.points[:, 1].max() for line in graph.lines) < 120


def test_ends_in_one_line_are_joined_across_nothing() -> None:
    score = evidence(((0, 100), (85, 100), 0.95), ((115, 100), (199, 100), 0.95))
    graph = sure_roads(score)
    link(graph, score, 50, 0.8, 7)
    assert len(graph.lines) == 1
    assert 0.1 < graph.lines[0].linked < 0.3


def test_ends_that_do_not_face_each_other_stay_apart() -> None:
    score = evidence(((0, 100), (85, 100), 0.95), ((115, 60), (115, 0), 0.95))
    graph = sure_roads(score)
    link(graph, score, 50, 0.8, 7)
    assert len(graph.lines) == 2


def test_a_road_leaves_the_picture_where_fair_evidence_does() -> None:
    score = evidence(((0, 100), (165, 100), 0.95), ((165, 100), (199, 100), 0.5))
    graph = sure_roads(score)
    assert len(dead_ends(graph, score.shape)) == 1
    link(graph, score, 50, 0.8, 7)
    assert not dead_ends(graph, score.shape)


def test_small_loops_at_a_junction_go_and_turning_circles_stay() -> None:
    for radius, left in ((4, 1), (30, 2)):
        angle = np.linspace(0, 2 * np.pi, 40)
        loop = np.c_[100 - radius + radius * np.cos(angle), 100 + radius * np.sin(angle)]
        graph = Graph({1: np.array([100.0, 100]), 2: np.array([199.0, 100])})
        graph.lines = [Line(1, 1, loop), Line(1, 2, np.array([[100.0, 100], [199, 100]]))]
        drop_loops(graph, 6 * 7)
        assert len(graph.lines) == left
