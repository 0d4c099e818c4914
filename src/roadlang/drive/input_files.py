"""What humans wanted who drove, as files beside the trace."""

from __future__ import annotations

from ..ir.trace import Trace

_COLUMNS = "time,steering,acceleration"


def input_files(trace: Trace) -> dict[str, str]:
    """By file ending, `ego.inputs.csv`: seconds, radians and m/s^2, to the last bit."""
    return {
        f"{name}.inputs.csv".replace("/", "-"): "\n".join(
            [_COLUMNS, *(",".join(map(repr, row)) for row in rows.tolist()), ""]
        )
        for name, rows in trace.inputs.items()
    }
