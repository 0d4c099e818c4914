"""The same motion, compiled by numba where that is installed: the same formulas, the same bits."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Iterable, Sequence
from functools import cache
from types import ModuleType
from typing import Any

import numpy as np

from ...geometry.arrays import Floats, Integers
from ...geometry.curves.bend_speeds import STRAIGHT
from ...geometry.numbers import compiling
from ...geometry.numbers.compiling import OPTIONS as OPTIONS
from ...geometry.numbers.compiling import is_installed as is_installed
from ..lines import line_loops, lines
from ..lines.line_nodes import Spacing
from ..lines.line_sources import LineSource
from . import kernels
from . import vehicle_dynamics as dynamics
from .bodies import Bodies
from .motion import Motion, Track


def advance(
    motion: Motion, car: Bodies, track: Track, wanted: tuple[Floats, Floats], steps: int, dt: float
) -> None:
    """What `motion.advance` does, to the last bit."""
    before = motion.columns
    after = np.empty((len(before), len(motion.along)))
    places = (track.first, track.places)
    kernel()((before, after), car.stacked, car.walks, wanted, places, track.lines.table, steps, dt)
    (
        motion.along, motion.offset, motion.speed, motion.slide, motion.yaw_rate, motion.cosine,
        motion.sine, motion.tangent, motion.line_heading, motion.acceleration,
    ) = after  # fmt: skip


def line_frames(track: Track, along: Floats) -> Floats:
    """What `poses.line_frames` does of (N,), to the last bit."""
    out = np.empty((5, len(along)))
    frames_kernel()(along, track.first, track.places, track.lines.table, out)
    return out


def frames_ahead(track: Track, along: Floats) -> tuple[Integers, Floats]:
    """What `poses.frames_ahead` does of (K, N), to the last bit."""
    out, cells = np.empty((5, *along.shape)), np.empty(along.shape, dtype=np.int64)
    ahead_kernel()(along, track.first, track.places, track.lines.table, out, cells)
    return cells, out


def points_beside(track: Track, along: Floats, left: Floats) -> tuple[Floats, Floats]:
    """What `poses.points_beside` does, to the last bit."""
    out, aside = np.empty((2, *along.shape)), np.empty(along.shape)
    aside[:] = left
    beside_kernel()(along, aside, track.first, track.places, track.lines.table, out)
    return out[0], out[1]


def looked_up(values: Floats, shift: Integers, track: Track, along: Floats) -> Floats:
    """(N,) the values of the cells at arc lengths; those of an agent are `shift` after those that
    the table of its line has."""
    out = np.empty(len(along))
    lookup_kernel()(values, shift, along, track.first, track.places, out)
    return out


def line_nodes(sources: Sequence[LineSource], spacing: Spacing, nodes: int) -> Floats:
    """What `line_nodes.line_nodes` does, to the last bit."""
    begin = np.zeros(len(sources) + 1, dtype=np.int64)
    np.cumsum([len(one.s) for one in sources], out=begin[1:])
    points = np.empty((5, begin[-1]))
    np.concatenate([one.s for one in sources], out=points[0])
    np.concatenate([one.x for one in sources], out=points[1])
    np.concatenate([one.y for one in sources], out=points[2])
    np.concatenate([one.heading for one in sources], out=points[3])
    np.concatenate([one.widths for one in sources], out=points[4])
    ends = points[3, np.concatenate([begin[:-1], begin[1:] - 1])].tolist()
    directions = np.array([*map(math.cos, ends), *map(math.sin, ends)]).reshape(2, 2, -1)
    out = np.empty((4, len(sources), nodes))
    rows = (spacing.counts, spacing.pads, spacing.meters, spacing.length, spacing.turn)
    nodes_kernel()(begin, points, rows, spacing.closed, directions, out)
    return out


def line_table(nodes: Floats, spacing: Floats, out: Floats) -> None:
    """What `lines.line_table` does, to the last bit."""
    table_kernel()(nodes, spacing, lines.cells_around(spacing), out)


def planned(table: Floats, first: Integers, squares: tuple[Floats, Floats], cells: int) -> Floats:
    """(N, M) what `bend_speeds.planned` does for open lines, to the last bit. `first`: (N,) where
    their tables begin; `squares`: lateral accelerations, and by how much squared speeds may grow
    from one cell to the one before."""
    out = np.empty((len(first), cells))
    plans_kernel()(table, first, *squares, STRAIGHT, out)
    return out


def gaps_in_corridors(pairs: Any, window: Any, outlines: Any, limits: Any) -> Any:
    """(P,) the gaps of `corridors.nearest_in_corridor`, to the last bit, and cosines and sines of
    the lines there. `pairs`, `limits`: those of the kernel."""
    out = np.empty((3, len(pairs[0])))
    lines = (window.x, window.y, window.cosine, window.sine)
    corridors_kernel()(
        pairs, lines, window.swept, (window.s, window.view), outlines.columns, limits, out
    )
    return out


LOADING = 0.5
"""Seconds of processor time that it takes about to load the compiled motion; to compile it, once
after an installation, takes longer."""
PER_STEP, PER_AGENT = 8e-5, 1e-7
"""Seconds of processor time that a step takes about without it, and with each agent more."""
DRIVES = 0.2
"""Seconds that scenes which are driven side by side take about without it."""
LINES = 200
"""Lines whose tables numpy makes in about the time in which compiled loops for them are loaded,
where numba is."""
LINES_AT_ONCE = 96
"""Lines whose nodes are found and tables filled together by compiled loops."""
_is_loaded = [False]
_lines = [0]
_worked = [0.0]
"""Estimated seconds of this process: it decides which of two motions is used, which are the same to
the last bit."""


def expect(times: float) -> None:
    """This process will drive scenes side by side so many times: where that pays for loading the
    compiled motion, it is used from the first time on."""
    _worked[0] += times * DRIVES


def is_loaded() -> bool:
    """Whether the compiled loop is there already."""
    return _is_loaded[0]


def pays_for_lines(count: int) -> bool:
    """Whether to use the compiled loops for the tables of that many lines more, which are the same
    to the last bit: once the work of this process, with this, would have paid for loading them."""
    _lines[0] += count
    return is_loaded() or ("numba" in sys.modules and _lines[0] > LINES)


def pays(steps: float, agents: int) -> bool:
    """Whether to use the compiled motion for that many steps more: once the work of this process,
    with this, would have paid for loading it."""
    if not is_installed():
        return False
    _worked[0] += steps * (PER_STEP + PER_AGENT * agents)
    return is_loaded() or _worked[0] > LOADING


@cache
def kernel() -> Any:
    """The compiled loop over agents and steps."""
    found = compile_loop(kernels.advanced)
    _is_loaded[0] = True
    return found


@cache
def frames_kernel() -> Any:
    """The compiled loop over places on lines."""
    return compile_loop(kernels.framed)


@cache
def ahead_kernel() -> Any:
    """The compiled loop over several places on each line."""
    return compile_loop(kernels.framed_ahead)


@cache
def beside_kernel() -> Any:
    """The compiled loop over places beside lines."""
    return compile_loop(kernels.points_beside)


@cache
def nodes_kernel() -> Any:
    """The compiled loop over points of lines."""
    return compile_loop(line_loops.line_nodes, line_loops)


@cache
def table_kernel() -> Any:
    """The compiled loop over the cells of lines."""
    return compile_loop(line_loops.line_table, line_loops)


@cache
def plans_kernel() -> Any:
    """The compiled loop over cells before bends."""
    return compile_loop(kernels.planned)


@cache
def lookup_kernel() -> Any:
    """The compiled loop over values of cells."""
    return compile_loop(kernels.looked_up)


@cache
def corridors_kernel() -> Any:
    """The compiled loop over pairs of an agent and what may be in its way."""
    return compile_loop(kernels.gaps_in_corridors)


def compile_loop(loop: Callable[..., Any], *more: ModuleType) -> Any:
    """Takes half a second the first time, and more where it has to compile: once, and anew when
    the formulas change. `more`: modules beside those here, of what the loop calls."""
    _register_formulas()
    return compiling.compiled(loop, _digest(*more))


def _digest(*more: ModuleType) -> str:
    """Of the text of everything that is compiled."""
    return compiling.digest_of(kernels, dynamics, lines, *more)


def register(formulas: Iterable[Callable[..., Any]], loops: Iterable[Callable[..., Any]]) -> None:
    """Make functions known to numba: formulas are put in where they are called."""
    register_jitable = compiling.loaded().extending.register_jitable
    for formula in formulas:
        # A call that is left in the loop over agents keeps it from computing several at once.
        register_jitable(forceinline=True, **OPTIONS)(formula)
    for loop in loops:
        register_jitable(**OPTIONS)(loop)


@cache
def _register_formulas() -> None:
    """Make the functions that loops call known to numba."""
    extending = compiling.loaded().extending
    register(
        (
            dynamics.steered, dynamics.approach, dynamics.brush, dynamics.brush_share,
            dynamics.demand, dynamics.forces, dynamics.axle_forces, dynamics.loads,
            dynamics.loads_after, dynamics.accelerated, dynamics.pushed, dynamics.walked,
            dynamics.displaced, dynamics.turned,
            dynamics.driven, dynamics.moved, lines.on_arc, kernels.place_on_line, kernels.drive,
            kernels.drive_abreast, kernels.turn_abreast, kernels.move_abreast,
        ),
        (
            kernels.advanced, kernels.framed, kernels.framed_ahead, kernels.points_beside,
            kernels.looked_up,
            line_loops.line_nodes, line_loops.line_table, kernels.planned,
            kernels.gaps_in_corridors, kernels.nearest_sample, kernels.widest,
        ),
    )  # fmt: skip
    extending.register_jitable(inline="always", **OPTIONS)(kernels.fill)
    # Of numbers, and with NaN only where both are NaN.
    overload = extending.overload
    overload(dynamics.least, jit_options=OPTIONS)(lambda a, b: lambda a, b: b if b < a else a)
    overload(dynamics.greatest, jit_options=OPTIONS)(lambda a, b: lambda a, b: b if b > a else a)
