"""From a skeleton to nodes and lines."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np

from roadlang_standard.extraction.graphs.graph import Graph, Line
from roadlang_standard.extraction.graphs.graph_cleanup import contract, join, prune
from roadlang_standard.extraction.graphs.tracing import trace
from roadlang_standard.extraction.masks.skeleton import skeleton


def drawn(*strokes: Any, thickness: int = 5, size: int = 120) -> Any:
    canvas = np.zeros((size, size), np.uint8)
    for start, end in strokes:
        cv2.line(canvas, start, end, 1, thickness)
    return canvas > 0


def test_a_cross_has_one_junction_and_four_arms() -> None:
    graph = trace(skeleton(drawn(((60, 5), (60, 115)), ((5, 60), (115, 60)))))
    contract(graph, 6)
    assert sorted(graph.degree().values()) == [1, 1, 1, 1, 4]
    (junction,) = [key for key, count in graph.degree().items() if count == 4]
    assert np.hypot(*(graph.nodes[junction] - 60)) < 2


def test_a_loop_without_ends_is_one_closed_line() -> None:
    canvas = np.zeros((120, 120), np.uint8)
    cv2.ellipse(canvas, (60, 60), (45, 30), 20, 0, 360, 1, 5)
    graph = trace(skeleton(canvas > 0))
    join(graph)
    assert [line.closed for line in graph.lines] == [True]


def test_stubs_go_and_what_they_split_is_one_line_again() -> None:
    graph = trace(skeleton(drawn(((5, 60), (115, 60)), ((60, 60), (60, 70)))))
    prune(graph, 14)
    assert len(graph.lines) == 1
    assert graph.lines[0].length > 95


def test_twin_junctions_become_one() -> None:
    graph = Graph({1: np.array([0.0, 0]), 2: np.array([4.0, 0])})
    for node, tips in ((1, [(-30, 20), (-30, -20)]), (2, [(34, 20), (34, -20)])):
        for tip in tips:
            end = graph.add_node(np.array(tip, float))
            graph.lines.append(Line(node, end, np.array([graph.nodes[node], tip], float)))
    graph.lines.append(Line(1, 2, np.array([[0.0, 0], [4, 0]])))
    contract(graph, 6)
    assert sorted(graph.degree().values()) == [1, 1, 1, 1, 4]
