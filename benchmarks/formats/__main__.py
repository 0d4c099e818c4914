"""Files of random networks, judged by the ASAM checker, by netconvert and by SUMO:
`python -m benchmarks.formats --qc .../qc_opendrive --netconvert .../netconvert --sumo .../sumo`."""

from __future__ import annotations

import argparse
import itertools
import tempfile
import time
from collections import Counter
from pathlib import Path

from benchmarks.formats.corpus import example_scenes, random_scenes
from benchmarks.formats.drives import driven_in_mujoco, driven_in_sumo
from benchmarks.formats.judges import checked, converted
from roadlang_formats.emit_opendrive import OpenDriveBackend


def main() -> None:
    """Prints each faulty file, and the sums."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--qc", help="the ASAM OpenDRIVE checker, qc_opendrive")
    parser.add_argument("--netconvert", help="of SUMO")
    parser.add_argument("--sumo", help="the program: scenes with traffic are driven in it")
    parser.add_argument(
        "--mujoco", help="a Python with MuJoCo, in which one car of each scene drives"
    )
    parser.add_argument("--networks", type=int, default=2, help="of each kind")
    parser.add_argument("--examples", action=argparse.BooleanOptionalAction, default=True)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--version", default="1.8")
    options = parser.parse_args()
    backend = OpenDriveBackend(version=options.version)
    sums: Counter[str] = Counter()
    spent = 0.0
    with tempfile.TemporaryDirectory() as folder:
        made = random_scenes(options.networks, options.seed, bool(options.sumo or options.mujoco))
        scenes = (example_scenes(options.seed) if options.examples else (), made)
        for name, scene in itertools.chain(*scenes):
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
                faults += converted(options.netconvert, file)
            if options.sumo:
                faults += driven_in_sumo(options.sumo, scene, Path(folder))
            if options.mujoco:
                faults += driven_in_mujoco(options.mujoco, scene, Path(folder))
            sums["faulty"] += bool(faults)
            for fault in faults:
                print(f"{name}: {fault}", flush=True)
    print(dict(sums), f"{1000 * spent / sums['files']:.0f} ms a file")


if __name__ == "__main__":
    main()
