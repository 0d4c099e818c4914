"""Maps of the ROS map server: a YAML file that names an image and says what its pixels mean.

https://wiki.ros.org/map_server and nav2_map_server, mode "trinary": of a pixel's mean value v,
occupied is (255 - v) / 255, or v / 255 where `negate` is set. A cell is free below `free_thresh`,
occupied above `occupied_thresh`, and unknown between them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from pathlib import Path
from reprlib import Repr
from typing import TYPE_CHECKING, Any

from roadlang.api import Code, DiagnosticError, diagnose, read_image, read_input

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import Extraction

_LARGEST = 100_000
"""bytes of a YAML file: it has six lines"""
_LARGEST_SIDE = 1e5
"""meters"""
_FARTHEST = 1e7
"""meters of the origin from (0, 0)"""
_SHORT = Repr()
"""What is quoted of a wrong value: aliases of aliases may stand for billions of items."""
_SHORT.maxlevel = 2
_WORDS = {"true": True, "yes": True, "on": True, "false": False, "no": False, "off": False}


@dataclass(frozen=True)
class MapRecord:
    """What the YAML file says; `origin` is the pose of the lower left pixel: x, y, yaw."""

    image: str
    resolution: float
    origin: tuple[float, float, float]
    negate: bool
    occupied_thresh: float
    free_thresh: float


@dataclass(frozen=True, eq=False)
class GridMap:
    """`free`: (height, width) cells that are free, row 0 at the top; `resolution` in m/px."""

    free: NDArray[np.bool_]
    resolution: float
    origin: tuple[float, float, float]

    def placed(self, extraction: Extraction) -> Extraction:
        """Roads with the image's corner at (0, 0) turned and moved to where the map has it."""
        x, y, yaw = self.origin
        turn = [[math.cos(yaw), -math.sin(yaw)], [math.sin(yaw), math.cos(yaw)]]
        network = extraction.network.transformed(turn, (x, y))
        return replace(extraction, network=network, mask=None)


def read_map(path: Path) -> GridMap:
    """The map of a YAML file. Raises `DiagnosticError` RL428, and RL400 to RL405 for the image."""
    import numpy as np

    record = read_record(path)
    pixels = read_image(path.parent / record.image)
    mean = pixels.astype(np.float64).mean(axis=2)
    occupied = (mean if record.negate else 255.0 - mean) / 255.0
    free = occupied < record.free_thresh
    side = record.resolution * max(free.shape)
    if side > _LARGEST_SIDE:
        raise _fault(path, f"it is {side / 1e3:g}km wide, and 100km is the most; see `resolution`")
    if not free.any():
        raise _fault(path, "no pixel of its image is free; look at `negate` and `free_thresh`")
    return GridMap(free, record.resolution, record.origin)


def read_record(path: Path) -> MapRecord:
    """What the YAML file says. Raises `DiagnosticError` RL428."""
    import yaml

    try:
        text = read_input(path, _LARGEST).decode("utf-8-sig")
        # Scalars as texts: the safe loader reads YAML 1.1, where `010` is 8 and `1:30` is 90.
        record = yaml.load(text, Loader=yaml.BaseLoader)  # noqa: S506
    except (yaml.YAMLError, UnicodeDecodeError, RecursionError) as error:
        raise _fault(path, f"it is not YAML: {' '.join(str(error).split())}") from None
    if not isinstance(record, dict):
        raise _fault(path, "it is not a map of `image`, `resolution`, `origin`, ...")
    mode = record.get("mode", "trinary")
    if mode != "trinary":
        shown = mode if isinstance(mode, str) else _SHORT.repr(mode)
        raise _fault(path, f"its mode is `{shown}`, and `trinary` can be read")
    image = record.get("image")
    if not isinstance(image, str) or not image or "\0" in image:
        raise _fault(path, "`image` is not the name of a file")
    found = MapRecord(
        image,
        _number(path, record, "resolution", None),
        _origin(path, record),
        _is_set(path, record, "negate"),
        _number(path, record, "occupied_thresh", 0.65),
        _number(path, record, "free_thresh", 0.196),
    )
    if found.resolution <= 0:
        raise _fault(path, f"`resolution` is {found.resolution:g}, and must be above 0")
    if not 0 <= found.free_thresh <= found.occupied_thresh <= 1:
        raise _fault(path, "`free_thresh` and `occupied_thresh` must rise from 0 to 1")
    return found


def _is_set(path: Path, record: dict[str, Any], key: str) -> bool:
    value = record.get(key, "false")
    found = _WORDS.get(value.lower()) if isinstance(value, str) else None
    return bool(_number(path, record, key, None)) if found is None else found


def _origin(path: Path, record: dict[str, Any]) -> tuple[float, float, float]:
    written = record.get("origin", [0.0, 0.0, 0.0])
    if not isinstance(written, list) or len(written) not in (2, 3):
        raise _fault(path, "`origin` is not [x, y, yaw]")
    numbers: dict[str, Any] = {str(index): value for index, value in enumerate(written)}
    x, y, yaw = (_number(path, numbers, str(index), 0.0, "origin") for index in range(3))
    if math.hypot(x, y) > _FARTHEST:
        raise _fault(path, "`origin` is more than 10,000km away")
    return x, y, yaw


def _number(
    path: Path, record: dict[str, Any], key: str, default: float | None, shown: str = ""
) -> float:
    value = record.get(key, default)
    if value in (None, "", "~", "null"):
        raise _fault(path, f"`{key}` is missing")
    try:
        is_number = isinstance(value, float) or (isinstance(value, str) and "_" not in value)
        number = float(value) if is_number else math.nan
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise _fault(path, f"`{shown or key}` is not a number: {_SHORT.repr(value)}")
    return number


def _fault(path: Path, reason: str) -> DiagnosticError:
    return DiagnosticError(diagnose(Code.UNREADABLE_MAP, file=path.name, reason=reason))
