"""What is sent to programs that drive, and how their answers are read."""

from __future__ import annotations

import base64
import json
import math
from typing import TYPE_CHECKING, Any

from .program import ProgramFailed

if TYPE_CHECKING:
    from roadlang.api import ObservationBatch, Reading

PROTOCOL = "roadlang.drive/1"
DISTANCES = (5.0, 10.0, 20.0, 30.0, 50.0)
"""Meters ahead at which programs see the path; they belong to this version of the protocol."""
AGENTS = 8
_NUMBERS = (
    "time", "x", "y", "heading", "speed", "acceleration", "yaw_rate", "steering",
    "cross_track_error", "heading_error", "station", "road_offset", "road_width",
)  # fmt: skip


def greeting(seen: ObservationBatch, row: int) -> str:
    """The first line."""
    return json.dumps(
        {
            "protocol": PROTOCOL,
            "agent": str(seen.agent[row]),
            "step": seen.step,
            "wheelbase": float(seen.wheelbase[row]),
            "distances": list(DISTANCES),
        }
    )


def check_greeting(line: str) -> None:
    """The answer to the first line. Raises ProgramFailed."""
    answer = _parsed(line)
    if not isinstance(answer, dict) or answer.get("protocol") != PROTOCOL:
        reason = f'its first line has to be {{"protocol": "{PROTOCOL}"}}, not {_short(line)}'
        raise ProgramFailed(reason)
    if "agent" in answer:  # what it was sent has a steering angle and an acceleration, too
        raise ProgramFailed("it sent back the line it was given, as `cat` does")


def observations(seen: ObservationBatch) -> list[str]:
    """One line for each agent: SI units and radians; what is infinite or unknown is null."""
    import numpy as np

    path = seen.path_ahead(np.array(DISTANCES))
    others = seen.nearest(AGENTS)
    limit = seen.speed_limit_ahead(3.0, 0.0)
    lines = []
    for row in range(len(seen.x)):
        axes = (math.cos(seen.heading[row]), math.sin(seen.heading[row]))
        place = (float(seen.x[row]), float(seen.y[row]))
        message: dict[str, Any] = {
            name: _number(float(getattr(seen, name)[row])) for name in _NUMBERS
        }
        message["speed_limit"] = _number(float(limit[row]))
        message["path"] = [
            _turned(float(x) - place[0], float(y) - place[1], axes)
            for x, y in zip(path[0][:, row], path[1][:, row], strict=True)
        ]
        message["others"] = [
            _other([float(column[row, i]) for column in others], place, axes)
            for i in range(AGENTS)
            if math.isfinite(others[0][row, i])
        ]
        if seen.sensors:
            message["sensors"] = {
                name: _reading(reading.single(row)) for name, reading in seen.sensors.items()
            }
        lines.append(json.dumps(message, allow_nan=False))
    return lines


def _reading(reading: Reading) -> dict[str, Any]:
    """Numbers and rows of numbers as they are; pictures and the like as bytes."""
    import numpy as np

    out: dict[str, Any] = {"time": reading.time}
    for name, value in reading.items():
        array = np.asarray(value)
        if array.ndim > 1:
            bytes_ = array.astype(array.dtype.newbyteorder("<")).tobytes()
            out[name] = {
                "shape": list(array.shape),
                "dtype": array.dtype.name,
                "base64": base64.b64encode(bytes_).decode("ascii"),
            }
        else:
            out[name] = [_number(x) for x in array.tolist()] if array.ndim else _number(value)
    return out


def refuse_unasked(line: str | None) -> None:
    """Raises ProgramFailed for a line that nobody asked for, such as one printed to find a bug."""
    if line is not None:
        raise ProgramFailed(
            f"it wrote a line without being asked: {_short(line)}; it must answer each line with"
            " exactly one line, and write everything else to standard error"
        )


def control(line: str) -> tuple[float, float]:
    """Steering angle and acceleration in an answer. Raises ProgramFailed."""
    answer = _object(line)
    found = []
    for name in ("steering", "acceleration"):
        value = answer.get(name)
        is_number = isinstance(value, int | float) and not isinstance(value, bool)
        if value is None or not is_number or not math.isfinite(value):
            raise ProgramFailed(f"`{name}` has to be a finite number; it answered {_short(line)}")
        found.append(float(value))
    return found[0], found[1]


def _parsed(line: str) -> Any:
    """None of what is no JSON."""
    try:
        return json.loads(line)
    except (ValueError, RecursionError):
        return None


def _object(line: str) -> dict[str, Any]:
    answer = _parsed(line)
    if not isinstance(answer, dict):
        raise ProgramFailed(f"its answer is not a JSON object: {_short(line)}")
    return answer


def _other(
    numbers: list[float], place: tuple[float, float], axes: tuple[float, float]
) -> dict[str, float]:
    x, y, heading, speed = numbers
    ahead, left = _turned(x - place[0], y - place[1], axes)
    speeds = _turned(speed * math.cos(heading), speed * math.sin(heading), axes)
    return {"ahead": ahead, "left": left, "speed_ahead": speeds[0], "speed_left": speeds[1]}


def _turned(x: float, y: float, axes: tuple[float, float]) -> list[float]:
    """Meters ahead and to the left, of meters east and north."""
    return [x * axes[0] + y * axes[1], y * axes[0] - x * axes[1]]


def _number(value: float) -> float | None:
    return value if math.isfinite(value) else None


def _short(line: str) -> str:
    return repr(line if len(line) <= 80 else line[:77] + "...")
