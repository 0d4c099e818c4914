"""CPU time of whole commands, in units of a bare `python -c pass`.

python -m benchmarks.startup           # beside the baseline
python -m benchmarks.startup --save    # make this the baseline
python -m benchmarks.startup --quick   # one round, to see that it works
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

from benchmarks.baseline import bare_interpreter, process_seconds, report

EXAMPLES = Path(__file__).parents[1] / "examples"


def main() -> int:
    """Measure the commands that people run most."""
    with tempfile.TemporaryDirectory() as folder:
        commands = {
            "--help": ["--help"],
            "compile --help": ["compile", "--help"],
            "check hairpin.rl": ["check", str(EXAMPLES / "hairpin.rl")],
            "check traffic.rl": ["check", str(EXAMPLES / "traffic.rl")],
            "compile street.rl": ["compile", str(EXAMPLES / "street.rl"), "-o", folder],
        }
        unit = bare_interpreter()
        print(f"unit: {1000 * unit:.1f} ms of CPU time")
        times = {
            name: process_seconds([sys.executable, "-m", "roadlang", *words]) / unit
            for name, words in commands.items()
        }
    return report("start-up", times)


if __name__ == "__main__":
    sys.exit(main())
