"""The compiled motion moves several agents at once."""

from __future__ import annotations

import platform

import numpy as np
import pytest

from roadlang.simulation.vehicles import compiled, kernels

numba = pytest.importorskip("numba")

AGENTS = 40


def motion() -> tuple[object, ...]:
    """What the loop over agents is called with, of cars on straight lines."""
    column = np.ones(AGENTS)
    before = tuple(column.copy() for _ in range(10))
    cars, numbers = np.ones((13, AGENTS)), np.ones((4, AGENTS))
    first = np.arange(AGENTS)
    table = np.zeros((AGENTS + 2, 8))
    walks = np.zeros(AGENTS, bool)
    after = np.empty((10, AGENTS))
    return (before, after), cars, walks, (column, column), (first, numbers), table, 2, 0.02


@pytest.mark.slow
@pytest.mark.skipif(platform.machine() != "x86_64", reason="reads the instructions of x86-64")
def test_square_roots_and_divisions_are_those_of_several_agents_at_once() -> None:
    compiled._register_formulas()
    loop = numba.njit(nogil=True, **compiled.OPTIONS)(kernels.advanced)
    loop(*motion())
    (assembly,) = loop.inspect_asm().values()
    assert "sqrtpd" in assembly
    assert "divpd" in assembly
    assert "sqrtsd" not in assembly  # one agent after the other
