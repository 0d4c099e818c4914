"""Policy networks in ONNX files: loaded with limits, checked, and asked for one agent at a time."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from roadlang.api import Code, DiagnosticError, diagnose, read_input

LARGEST = 256 * 2**20
"""bytes of a file"""
OUTPUTS = 2


@cache
def policy(path: str, inputs: int) -> Callable[[NDArray[np.float32]], NDArray[np.float64]]:
    """What (N, 2) a network gives for vectors (N, `inputs`), within -1 and 1.

    Each row is computed alone: the same bytes, whoever else is asked for. Raises RL741.
    """
    name = Path(path).name
    session = _session(path, name)
    (input_,), (found,) = _only(session.get_inputs(), name), _only(session.get_outputs(), name)
    if input_.type != "tensor(float)" or not _fits(input_.shape, inputs):
        raise _unusable(
            name, f"its input is {input_.type} {input_.shape}, not float32 (1, {inputs})"
        )
    if not _fits(found.shape, OUTPUTS):
        raise _unusable(name, f"its output has the shape {found.shape}, not (1, {OUTPUTS})")

    def wanted(vectors: NDArray[np.float32]) -> NDArray[np.float64]:
        out = np.empty((len(vectors), OUTPUTS))
        for row in range(len(vectors)):
            with _faults_of(name, "it fails"):
                (answer,) = session.run([found.name], {input_.name: vectors[row : row + 1]})
                out[row] = np.asarray(answer, dtype=np.float64).reshape(OUTPUTS)
        if not np.isfinite(out).all():
            raise _unusable(name, "it gave a number that is not finite")
        return np.minimum(np.maximum(out, -1.0), 1.0)

    return wanted


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
        return onnxruntime.InferenceSession(content, options, providers=providers)


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


def _only(ends: Any, name: str) -> list[Any]:
    if len(ends) != 1:
        names = ", ".join(end.name for end in ends) or "none"
        raise _unusable(name, f"it has to have one input and one output, not {names}")
    return list(ends)


def _fits(shape: Any, size: int) -> bool:
    """Whether a shape is (1, size), or (any number, size)."""
    return (
        isinstance(shape, list)
        and len(shape) == 2
        and (shape[0] == 1 or not isinstance(shape[0], int))
        and (shape[1] == size or not isinstance(shape[1], int))
    )


def _first_line(error: Exception) -> str:
    return (str(error).strip().splitlines() or [type(error).__name__])[0][:300]


def _unusable(name: str, reason: str) -> DiagnosticError:
    return DiagnosticError(diagnose(Code.UNUSABLE_POLICY, file=name, reason=reason))
