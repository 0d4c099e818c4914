"""Parts of numpy that scipy names but commands do not use: they are loaded when they are used."""

from __future__ import annotations

import importlib.util
import sys

_PARTS = ("char", "ctypeslib", "f2py", "fft", "ma", "polynomial", "rec", "strings", "testing")


def defer_parts_of_numpy(needed: tuple[str, ...] = ()) -> None:
    """`import scipy.linalg` names everything that numpy has (array API), which loads all of its
    parts, one for translating Fortran among them: half of the time of that import. Those that are
    `needed` are loaded with it."""
    import numpy as np

    for part in sorted(set(_PARTS) - set(needed)):
        name = f"numpy.{part}"
        found = None if name in sys.modules else importlib.util.find_spec(name)
        if found is None or found.loader is None:
            continue
        found.loader = importlib.util.LazyLoader(found.loader)
        module = importlib.util.module_from_spec(found)
        sys.modules[name] = module
        found.loader.exec_module(module)
        setattr(np, part, module)
