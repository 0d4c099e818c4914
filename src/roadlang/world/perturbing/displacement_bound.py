"""How far a pass can move a road, as its kind states it for candidates whose draws are known."""

from __future__ import annotations

import numpy as np

from ...evaluate.kind_instance import KindInstance, row_of_kind
from ...geometry.arrays import Floats
from ...plugins.guard import wrong_result
from ...plugins.kinds import implements


def displacement_bound(built: KindInstance, count: int) -> Floats:
    """(V,) or (1,) meters, V being `count`. Raises RL474 for what is not a bound.

    A kind that is written for one variant is evaluated for one after the other.
    """
    kind = built.kind
    with built.guarded:
        if implements(type(kind), "displacements") or not implements(type(kind), "displacement"):
            stated = kind.displacement_bound()
        else:
            stated = [row_of_kind(kind, row).displacement_bound() for row in range(count)]
        bound = np.asarray(stated, dtype=np.float64).reshape(-1)
    if bound.size not in (1, count) or not (bound >= 0.0).all():
        fault = f"gave a displacement bound that is not valid: {bound[:3]}"
        raise wrong_result(built.entry, built.call.span, fault)
    return bound
