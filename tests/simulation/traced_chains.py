"""Chains of computations of columns, drawn at random."""

from __future__ import annotations

from typing import Any

import numpy as np
from hypothesis import strategies as st

from roadlang.geometry.arrays import Floats
from roadlang.simulation.tapes.tape import Tape, TapeProgram, program_of
from roadlang.simulation.tapes.traced import TracedColumn, value_of

Column = Any
ONE = ["negative", "absolute", "floor", "sqrt", "sin", "cos", "tan", "arctan", "tanh", "square"]
TWO = ["add", "subtract", "multiply", "divide", "minimum", "maximum", "arctan2", "hypot",
       "remainder", "fmod"]  # fmt: skip
COMPARED = ["less", "less_equal", "greater", "greater_equal"]
STEPS = st.lists(
    st.one_of(
        st.tuples(st.sampled_from(ONE), st.integers(0, 9)),
        st.tuples(st.sampled_from(TWO), st.integers(0, 9), st.integers(0, 9)),
        st.tuples(st.sampled_from(COMPARED), *[st.integers(0, 9)] * 4),
    ),
    min_size=1,
    max_size=40,
)
STATE = 3


def computed(steps: list[Any], columns: list[Column], constants: list[Column]) -> Column:
    """A chain of computations, each of some that were there before."""
    known = [*columns, *constants]
    for name, *which in steps:
        a, b, c, d = (known[-1 - place % len(known)] for place in (*which, 0, 0, 0)[:4])
        function = getattr(np, name)
        if name in COMPARED:
            both = function(a, b) & (np.less(c, d) | ~np.less(a, c))
            known.append(np.where(both, c, d))
        else:
            known.append(function(a) if name in ONE else function(a, b))
    total = known[-1]
    for one in known[-4:]:
        total = np.where(np.less(one, 1e3), total, one)
    return total


def program_and_result(
    steps: list[Any], agents: int, seed: int, times: int
) -> tuple[TapeProgram, list[Floats], list[Floats]]:
    """A chain as a program, the columns (N,) that it begins with, and what they and the last value
    come to after it was computed by numpy some times."""
    random = np.random.default_rng(seed)
    begin = list(random.normal(size=(STATE, agents)) * 10.0 ** random.uniform(-2, 2))
    constants: list[Column] = [random.normal(size=agents), 0.0, -1.5, np.float64(2.0)]
    tape = Tape(agents, STATE)
    traced = [TracedColumn(tape, number) for number in range(STATE)]
    columns: list[Column] = begin
    with np.errstate(all="ignore"):
        last = computed(steps, traced, constants)
        gives = [value_of(tape, one) for one in (*traced[1:], last + 0.0, last)]
        # The columns change places through computed values, as a state does.
        gives[:2] = [value_of(tape, traced[1] * 1.0), value_of(tape, traced[2] * 1.0)]
        for _ in range(times):
            value = np.array(np.broadcast_to(computed(steps, columns, constants), agents))
            columns = [columns[1] * 1.0, columns[2] * 1.0, value + 0.0]
    return program_of(tape, gives), begin, [*columns, value.astype(np.float64)]
