"""What the instructions of a tape do: numbers that the compiled loop knows."""

from __future__ import annotations

from collections.abc import Mapping

(
    ADD, SUBTRACT, MULTIPLY, DIVIDE, NEGATIVE, ABSOLUTE, FLOOR, SQRT, LESS, LESS_EQUAL, AND, OR,
    NOT, WHERE, COPY, CALL_ONE, CALL_TWO, FRAME, VALUE_OF_CELL, MOVE, RECORD, FINITE, SKIP, BEND,
    CELL, LIMITS, WATCH,
) = range(27)  # fmt: skip
"""`CALL_ONE` and `CALL_TWO` call a function of numpy, of one and of two columns. `FRAME` looks up
lines, `VALUE_OF_CELL` a column of their cells; `MOVE` is some steps of the vehicles; `RECORD` is a
sample; `FINITE` ends the tape where a number is infinite or NaN; `SKIP` leaves out the next
instructions where a truth value is true of nobody. With numpy alone: `BEND` looks up
curvatures and headings of lines, `CELL` how far into a cell of a line it is, and the first five
columns of the cell; `LIMITS` and `WATCH` ask whether agents are far from any limit."""

BY_NAME: Mapping[str, int] = {
    "add": ADD, "subtract": SUBTRACT, "multiply": MULTIPLY, "divide": DIVIDE,
    "negative": NEGATIVE, "absolute": ABSOLUTE, "floor": FLOOR, "sqrt": SQRT,
}  # fmt: skip
"""Functions of numpy on numbers whose results the arithmetic of IEEE 754 defines to the last bit:
the compiled loop computes them itself."""
