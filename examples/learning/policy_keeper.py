"""Drive as policy.json says, for `drive with process`: the network that train_policy.py trained."""

import json
import math
import sys
from pathlib import Path


def layer(values: list[float], weights: list[float], outputs: int) -> list[float]:
    """One layer of the network: the last row of its weights are the biases."""
    rows = [weights[i : i + outputs] for i in range(0, len(weights), outputs)]
    return [
        math.tanh(sum(v * row[j] for v, row in zip(values, rows, strict=False)) + rows[-1][j])
        for j in range(outputs)
    ]


def main() -> None:
    """Answer each line of standard input with one of standard output."""
    policy = json.loads(Path("policy.json").read_text(encoding="utf-8"))
    inputs, hidden, weights = policy["inputs"], policy["hidden"], policy["weights"]
    most = policy["actions"]  # what the actions 1 and -1 meant in training
    split = (len(inputs) + 1) * hidden
    distances = json.loads(sys.stdin.readline())["distances"]
    print(json.dumps({"protocol": "roadlang.drive/1"}), flush=True)
    for line in sys.stdin:
        seen = json.loads(line)
        for distance, (_, left) in zip(distances, seen["path"], strict=True):
            seen[f"path_left_{distance:g}m"] = left
        values = [seen[name] * scale for name, scale in inputs.items()]
        steering, wish = layer(layer(values, weights[:split], hidden), weights[split:], 2)
        acceleration = wish * most["acceleration" if wish > 0 else "deceleration"]
        answer = {"steering": steering * most["steering"], "acceleration": acceleration}
        print(json.dumps(answer), flush=True)


if __name__ == "__main__":
    main()
