"""OpenDRIVE files of random networks, judged by the ASAM checker and by netconvert:
`python -m benchmarks.formats --qc .../qc_opendrive --netconvert .../netconvert`."""

from __future__ import annotations

import argparse
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

import roadlang
from benchmarks.formats.judges import checked, converted
from benchmarks.junctions.random_networks import KINDS, random_network
from roadlang.api import Extraction, Extractor, Integer, Picture, String, option
from roadlang.ir.scene import Scene
from roadlang.testing import sample
from roadlang_formats.emit_opendrive import OpenDriveBackend

_EXAMPLES = Path(__file__).parents[2] / "examples"
_TEXT = """
image plan from \"\"\"
##
\"\"\" {{ scale: 20m/px }}
network town from plan {{
  extract with made_up {{ kind: "{kind}", seed: {seed} }}
  lanes: {lanes}, speed_limit: 50km/h{more}
  perturb with sine {{ amplitude: 0m..2m, wavelength: 40m..90m }}
}}
"""
_MORE = ("", ", sidewalks: 2m", "\n  control with signals", "\n  control with stop")


@dataclass(frozen=True)
class MadeUp(Extractor):
    """A random network, whatever the picture."""

    name: ClassVar[str] = "made_up"
    kind: String = option("town", help="of the network")
    seed: Integer = option(0, help="of the network")

    def extract(self, picture: Picture) -> Extraction:
        """The network alone."""
        return Extraction(random_network(self.kind, int(self.seed)).network)


def main() -> None:
    """Prints each faulty file, and the sums."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--qc", help="the ASAM OpenDRIVE checker, qc_opendrive")
    parser.add_argument("--netconvert", help="of SUMO")
    parser.add_argument("--networks", type=int, default=2, help="of each kind")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--version", default="1.8")
    options = parser.parse_args()
    backend = OpenDriveBackend(version=options.version)
    sums: Counter[str] = Counter()
    spent = 0.0
    with tempfile.TemporaryDirectory() as folder:
        for name, scene in _scenes(options.networks, options.seed):
            begun = time.process_time()
            text = backend.files(scene)["xodr"]
            spent += time.process_time() - begun
            file = Path(folder) / "scene.xodr"
            file.write_text(text, encoding="utf-8")
            sums["files"] += 1
            faults: list[str] = []
            if options.qc:
                completed, issues = checked(options.qc, file)
                faults += [f"{count} times {rule}" for rule, count in issues.items()]
                faults += [f"only {completed} rules checked"] if completed < 22 else []
            if options.netconvert:
                faults += converted(options.netconvert, file, scene)
            sums["faulty"] += bool(faults)
            for fault in faults:
                print(f"{name}: {fault}", flush=True)
    print(dict(sums), f"{1000 * spent / sums['files']:.0f} ms a file")


def _scenes(count: int, seed: int) -> Iterator[tuple[str, Scene]]:
    for path in sorted(_EXAMPLES.glob("*.rl")):
        yield path.stem, roadlang.load(path).sample(1, seed=seed)[0].record
    for number in range(count):
        for place, kind in enumerate(KINDS):
            turn = number + place
            more, lanes = _MORE[turn % len(_MORE)], max(2, 1 + turn % 4)
            text = _TEXT.format(kind=kind, seed=seed * 1000 + number, lanes=lanes, more=more)
            yield f"{kind} {number}", sample(text, 1, kinds=[MadeUp], seed=seed)[0].record


if __name__ == "__main__":
    main()
