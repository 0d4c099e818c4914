"""A lane keeper with a PID controller, for `drive with process`: JSON lines in and out.

It knows nothing of roadlang; see docs/learning.md for the lines.
"""

import json
import sys

SPEED = 15.0  # m/s


def main() -> None:
    """Answer each line of standard input with one of standard output."""
    step = json.loads(sys.stdin.readline())["step"]
    print(json.dumps({"protocol": "roadlang.drive/1"}), flush=True)
    total, before = 0.0, 0.0
    for line in sys.stdin:
        seen = json.loads(line)
        error = seen["path"][1][1]  # how far to the left the path is, 10 m ahead
        total = max(-2.0, min(2.0, total + error * step))
        rate = (error - before) / step
        before = error
        steering = 0.06 * error + 0.01 * total + 0.005 * rate
        acceleration = max(-4.0, min(3.0, 1.0 * (SPEED - seen["speed"])))
        print(json.dumps({"steering": steering, "acceleration": acceleration}), flush=True)


if __name__ == "__main__":
    main()
