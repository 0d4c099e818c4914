"""The loops inside numpy's functions, by their addresses.

The sine that numpy computes differs in the last bit from that of other libraries, and from one
processor to the next. A compiled loop that has to give the same bits calls numpy's own loops.
"""

from __future__ import annotations

import ctypes
from functools import cache
from typing import Any

import numpy as np


class _Function(ctypes.Structure):
    """`PyUFuncObject` of numpy's public header `ufuncobject.h`, after the head that all objects
    have."""

    _fields_ = (
        ("inputs", ctypes.c_int),
        ("outputs", ctypes.c_int),
        ("arguments", ctypes.c_int),
        ("identity", ctypes.c_int),
        ("loops", ctypes.POINTER(ctypes.c_void_p)),
        ("data", ctypes.POINTER(ctypes.c_void_p)),
        ("types", ctypes.c_int),
        ("reserved", ctypes.c_int),
        ("name", ctypes.c_char_p),
    )


@cache
def loop_of(function: np.ufunc) -> tuple[int, int] | None:
    """The address of the loop of a function of numpy on numbers, and what it is called with beside
    its arrays; None where there is no such loop."""
    types = f"{'d' * function.nin}->{'d' * function.nout}"
    if types not in function.types or getattr(np, function.__name__, None) is not function:
        return None
    # `object.__basicsize__`: of the head
    found: Any = _Function.from_address(id(function) + object.__basicsize__)
    said = (function.nin, function.nout, function.nargs, function.ntypes)
    if (found.inputs, found.outputs, found.arguments, found.types) != said:
        return None
    if found.name != function.__name__.encode():
        return None
    number = function.types.index(types)
    return found.loops[number], (found.data[number] if found.data else 0) or 0
