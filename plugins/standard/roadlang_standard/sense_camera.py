"""`sense with camera`: pictures, in an engine that draws."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar, Literal

from roadlang.api import ListOf, OptionError, ReadingArray, option

from .camera_view import CameraView

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from roadlang.api import SensorRecord

    Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Camera(CameraView):
    """A camera: color, depth and what each pixel shows. Godot renders it."""

    name: ClassVar[str] = "camera"

    outputs: ListOf[Literal["rgb", "depth", "semantic", "instance"]] = option(
        ("rgb",),
        at_least=1,
        help="what a reading holds: `rgb`; `depth`, meters from the camera's plane; `semantic`, "
        "the class of each pixel; `instance`, the number of each thing",
        example="[rgb, depth, semantic]",
    )

    record: ListOf[Literal["png", "mp4"]] = option(
        (),
        help="files that `run` writes in addition to arrays: `png`, a picture of each "
        "output of each reading; `mp4`, a clip of `rgb`",
        example="[png, mp4]",
    )

    def __post_init__(self) -> None:
        super().__post_init__()
        if len(set(self.outputs)) != len(self.outputs):
            raise OptionError("outputs", "names an output twice")
        if "mp4" in self.record and "rgb" not in self.outputs:
            raise OptionError("record", "asks for a clip of `rgb`, which is not one of the outputs")

    def arrays(self) -> dict[str, ReadingArray]:
        """Arrays of (height, width), from the top left."""
        shape = (round(self.height), round(self.width))
        known = {
            "rgb": ReadingArray((*shape, 3), "uint8", 0, 255),
            "depth": ReadingArray(shape, "float32", 0.0, unit="m"),
            "semantic": ReadingArray(shape, "uint8", 0, 255),
            "instance": ReadingArray(shape, "uint16", 0, 65535),
        }
        return {name: known[name] for name in self.outputs}

    def files(self, record: SensorRecord) -> dict[str, bytes]:
        """Pictures of all readings, numbered, and a clip, as far as they are wanted."""
        from .camera_pictures import clip_of, png_of

        files = {}
        if "png" in self.record:
            files = {
                f"{number:06d}.{output}.png": png_of(output, picture)
                for output, pictures in record.arrays.items()
                for number, picture in enumerate(pictures)
            }
        if "mp4" in self.record and len(record.time):
            files["mp4"] = clip_of(record.arrays["rgb"], _rate(record.time), "clip.mp4")
        return files


def _rate(time: Floats) -> float:
    """Pictures a second, by the most common time between two."""
    import numpy as np

    intervals = np.diff(time)
    return 1.0 / float(np.median(intervals)) if len(intervals) else 1.0
