"""A formula as a graph of array operations in which equal parts are one node."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..formula import formulas as f
from ..formula import terms as t
from ..formula.normal_form import normal_form
from .graph_operations import (
    OF_INFINITIES,
    ROBUST,
    TERM_FUNCTIONS,
    Function,
    Measuring,
    NumberOperation,
    Operation,
    PointwiseOperation,
    Reaching,
    Read,
    Sliding,
    greatest,
    least,
    negative,
)
from .sliding_and_until import GREATEST, LEAST


def can_be_infinite(formula: f.Formula) -> bool:
    """Whether terms of a formula can be infinite where its signals are finite."""
    comparisons = (part for part in formula.walk() if isinstance(part, f.Comparison))
    terms = (
        term for part in comparisons for side in (part.left, part.right) for term in side.walk()
    )
    return any(
        math.isinf(term.value)
        if isinstance(term, t.Constant)
        else isinstance(term, t.Arithmetic) and term.op in ("/", "^")
        for term in terms
    )


@dataclass(frozen=True)
class FormulaNode:
    """An operation and the indices of the nodes that feed it; all of them come before it."""

    operation: Operation
    inputs: tuple[int, ...]


class FormulaGraph:
    """Nodes in an order in which they can be computed. `leaves` gives comparisons their value.

    `infinite`: numbers can be infinite, in terms or in signals; of a graph without, signals that
    are raise `InfiniteSignal`.
    """

    def __init__(self, leaves: Mapping[str, Function] = ROBUST, infinite: bool = False) -> None:
        self.leaves = leaves
        self.infinite = infinite
        self.nodes: list[FormulaNode] = []
        self._indices: dict[FormulaNode, int] = {}

    @classmethod
    def of(
        cls,
        formula: f.Formula,
        leaves: Mapping[str, Function] = ROBUST,
        infinite_signals: bool = False,
    ) -> FormulaGraph:
        """The graph of a formula; its last node is the formula itself."""
        graph = cls(leaves, infinite_signals or can_be_infinite(formula))
        graph.formula(normal_form(formula))
        return graph

    def add(self, operation: Operation, *inputs: int) -> int:
        """The index of this node, made only if there is none like it."""
        node = FormulaNode(operation, inputs)
        if node not in self._indices:
            self._indices[node] = len(self.nodes)
            self.nodes.append(node)
        return self._indices[node]

    def term(self, term: t.Term) -> int:
        """Add a term and its parts."""
        match term:
            case t.Constant(value):
                return self.add(NumberOperation(value))
            case t.Variable(name):
                return self.add(Read(name))
        parts = [self.term(part) for part in term.parts]
        if isinstance(term, t.Negate):
            return self.add(PointwiseOperation(negative), *parts)
        if isinstance(term, t.Arithmetic):
            return self.add(self._pointwise(TERM_FUNCTIONS[term.op]), *parts)
        if isinstance(term, t.Apply):
            return self.add(PointwiseOperation(TERM_FUNCTIONS[term.function]), *parts)
        raise TypeError(f"not a term: {term!r}")

    def _pointwise(self, function: Function) -> PointwiseOperation:
        return PointwiseOperation(
            OF_INFINITIES.get(function, function) if self.infinite else function
        )

    def formula(self, formula: f.Formula) -> int:
        """Add a formula in normal form and its parts."""
        match formula:
            case f.Truth(value):
                return self.add(NumberOperation(np.inf if value else -np.inf))
            case f.Comparison(op, left, right):
                leaf = self._pointwise(self.leaves[op])
                return self.add(leaf, self.term(left), self.term(right))
        found = self._extreme_of_side(formula) if isinstance(formula, f.UnaryTemporal) else None
        if found is not None:
            return found
        parts = [self.formula(part) for part in formula.parts]
        match formula:
            case f.Not():
                return self.add(PointwiseOperation(negative), *parts)
            case f.LogicalJunction():
                if not parts:
                    return self.formula(f.Truth(formula.least))
                return self.add(PointwiseOperation(least if formula.least else greatest), *parts)
            case f.UnaryTemporal():
                extreme = LEAST if formula.least else GREATEST
                return self.add(Sliding(extreme, formula.reach, formula.past), *parts)
            case f.SampleStep():
                return self.add(Sliding(GREATEST, formula.reach, formula.past), *parts)
            case f.AtLeast(interval, _, amount, strict, counts):
                return self.add(Measuring(interval, amount, strict, counts), *parts)
            case f.BinaryTemporal(interval):
                return self.add(Reaching(interval, formula.past), *parts)
        raise TypeError(f"not in normal form: {formula!r}")

    def _extreme_of_side(self, formula: f.UnaryTemporal) -> int | None:
        """The node of `always (x < 3)` as 3 less the greatest x: one pass over x, and to the last
        bit the same, as rounding is monotonic. None for what is no comparison with a number."""
        operand = formula.operand
        if self.infinite or self.leaves is not ROBUST or not isinstance(operand, f.Comparison):
            return None
        sides = (operand.left, operand.right)
        if operand.op in ("==", "!=") or sum(isinstance(side, t.Constant) for side in sides) != 1:
            return None
        grows = isinstance(operand.right, t.Constant) == (operand.op in (">", ">="))
        extreme = LEAST if formula.least == grows else GREATEST
        sliding = Sliding(extreme, formula.reach, formula.past)
        nodes = [
            self.term(side) if isinstance(side, t.Constant) else self.add(sliding, self.term(side))
            for side in sides
        ]
        return self.add(self._pointwise(self.leaves[operand.op]), *nodes)
