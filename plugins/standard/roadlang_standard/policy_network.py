"""Policy networks in ONNX files: loaded with limits, checked, and asked for one agent at a time."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from roadlang.api import Code, DiagnosticError, Reading, diagnose, read_input

LARGEST = 256 * 2**20
"""bytes of a file"""
OUTPUTS = 2
_TYPES = {
    "tensor(float)": np.float32, "tensor(double)": np.float64, "tensor(uint8)": np.uint8,
    "tensor(uint16)": np.uint16, "tensor(int64)": np.int64,
}  # fmt: skip
"""of inputs"""


@dataclass(frozen=True, slots=True)
class Policy:
    """A network with one output (1, 2) for steering and acceleration, and what its inputs are.

    `vector`: the name of the input that gets the vector of numbers, None for none. `readings`: the
    inputs that are called after arrays of sensors, `front.distances`, with sensor and array.
    """

    name: str
    session: Any
    output: str
    vector: Any
    readings: tuple[tuple[Any, str, str], ...]

    def wanted(
        self, vectors: NDArray[np.float32], sensors: Mapping[str, Reading], help: tuple[str, ...]
    ) -> NDArray[np.float64]:
        """What (N, 2) it gives for vectors (N, F) and readings of N agents, within -1 and 1.

        Each agent is asked for alone: the same bytes, whoever else is asked for. Raises RL741, with
        the `help` where F does not fit.
        """
        columns: dict[str, NDArray[Any]] = {}
        if self.vector is not None:
            columns[self.vector.name] = self._fitting(self.vector, vectors, help)
        for input_, sensor, array in self.readings:
            if sensor not in sensors or array not in sensors[sensor]:
                known = [f"{name}.{of}" for name, found in sensors.items() for of in found]
                raise _unusable(
                    self.name,
                    f"its input `{input_.name}` is not a reading of the agent, which has "
                    f"{', '.join(known) or 'no sensors'}",
                )
            columns[input_.name] = self._fitting(input_, np.asarray(sensors[sensor][array]))
        out = np.empty((len(vectors), OUTPUTS))
        for row in range(len(vectors)):
            with _faults_of(self.name, "it fails"):
                given = {name: column[row : row + 1] for name, column in columns.items()}
                (answer,) = self.session.run([self.output], given)
                out[row] = np.asarray(answer, dtype=np.float64).reshape(OUTPUTS)
        if not np.isfinite(out).all():
            raise _unusable(self.name, "it gave a number that is not finite")
        return np.minimum(np.maximum(out, -1.0), 1.0)

    @property
    def width(self) -> int | None:
        """F, where it is fixed."""
        shape = () if self.vector is None else tuple(self.vector.shape)
        return shape[1] if len(shape) == 2 and isinstance(shape[1], int) else None

    def _fitting(
        self, input_: Any, column: NDArray[Any], help: tuple[str, ...] = ()
    ) -> NDArray[Any]:
        """A column (N, ...) as an input takes it. Raises RL741 where the shape is another."""
        shape = column.shape[1:] or (1,)
        if input_.type not in _TYPES or not _fits(input_.shape, shape):
            listed = ", ".join(map(str, shape))
            raise _unusable(
                self.name,
                f"its input `{input_.name}` is {input_.type} {input_.shape}, not float32 "
                f"(1, {listed})",
                help,
            )
        column = column.reshape(len(column), *shape)
        return np.ascontiguousarray(column, dtype=_TYPES[input_.type])


@cache
def policy(path: str) -> Policy:
    """The network in a file. Raises RL741."""
    name = Path(path).name
    session = _session(path, name)
    outputs = session.get_outputs()
    if len(outputs) != 1 or not _fits(outputs[0].shape, (OUTPUTS,)):
        found = ", ".join(f"{each.name} {each.shape}" for each in outputs) or "none"
        raise _unusable(name, f"its outputs are {found}, not (1, {OUTPUTS})")
    vectors, readings = [], []
    for input_ in session.get_inputs():
        sensor, dot, array = input_.name.partition(".")
        if dot and sensor.isidentifier() and array.isidentifier():
            readings.append((input_, sensor, array))
        else:
            vectors.append(input_)
    if len(vectors) > 1:
        listed = ", ".join(input_.name for input_ in vectors)
        raise _unusable(
            name,
            f"of its inputs, {listed} are not named after a reading (`front.distances`); at most "
            "one can take the vector of numbers",
        )
    vector = vectors[0] if vectors else None
    return Policy(name, session, outputs[0].name, vector, tuple(readings))


def _session(path: str, name: str) -> Any:
    try:
        import onnxruntime
    except ImportError:
        help_ = 'pip install "roadlang[onnx]"'
        reason = "the package onnxruntime is not installed"
        fault = diagnose(Code.UNUSABLE_POLICY, file=name, reason=reason, help=help_)
        raise DiagnosticError(fault) from None
    content = read_input(Path(path), LARGEST)  # as bytes: a model cannot name further files
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = options.inter_op_num_threads = 1
    options.log_severity_level = 4
    with _faults_of(name, "it cannot be loaded"):
        providers = ["CPUExecutionProvider"]
        quiet = {"enable_fallback": 0}  # its second try, with the same provider, prints a banner
        return onnxruntime.InferenceSession(content, options, providers=providers, **quiet)


@contextmanager
def _faults_of(name: str, what: str) -> Iterator[None]:
    """What onnxruntime raises becomes a diagnostic about the file.

    It has no base class of errors: it raises ValueError, RuntimeError, and classes of its
    compiled part that it does not export, so that nothing narrower than Exception will do.
    """
    try:
        yield
    except Exception as error:
        raise _unusable(name, f"{what}: {_first_line(error)}") from error


def _fits(shape: Any, wanted: tuple[int, ...]) -> bool:
    """Whether a shape is (1, *wanted); sizes that are not numbers can be any."""
    return (
        isinstance(shape, list)
        and len(shape) == 1 + len(wanted)
        and all(
            found == size or not isinstance(found, int)
            for found, size in zip(shape, (1, *wanted), strict=True)
        )
    )


def _first_line(error: Exception) -> str:
    return (str(error).strip().splitlines() or [type(error).__name__])[0][:300]


def _unusable(name: str, reason: str, help: tuple[str, ...] = ()) -> DiagnosticError:
    return DiagnosticError(diagnose(Code.UNUSABLE_POLICY, file=name, reason=reason, help=help))
