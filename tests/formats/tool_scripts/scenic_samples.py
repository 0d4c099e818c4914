"""Samples Scenic programs: {"programs": [paths], "samples": n} on the standard input.

Answers for each program with its error, or with the draws that its samples took, and the lanes of
its objects: the id that OpenDRIVE has for the lane, and how far (radians) the object's heading is
from the lane's direction; null for none. Where lanes of both directions lie on the same ground,
it is the one that the object faces along: Scenic's own query answers with any of them.
"""

import json
import math
import sys
import warnings

import scenic

warnings.simplefilter("ignore")


def lane_of(thing, network):
    found = [
        [section.openDriveID, abs(math.remainder(turn, math.tau))]
        for section in network.laneSections
        if section.containsPoint(thing.position)
        for turn in [thing.heading - float(section.orientation[thing.position].yaw)]
    ]
    return min(found, key=lambda lane: lane[1], default=None)


def sampled(path, count):
    scenario = scenic.scenarioFromFile(path, mode2D=True)
    draws = 0
    for _ in range(count):
        scene, tries = scenario.generate(maxIterations=20)
        draws += tries
    network = scene.workspace.network
    return {
        "draws": draws,
        "lanes": {thing.name: lane_of(thing, network) for thing in scene.objects},
    }


question = json.load(sys.stdin)
answers = {}
for program in question["programs"]:
    try:
        answers[program] = sampled(program, question["samples"])
    except Exception as error:  # noqa: BLE001 - whatever Scenic says is the answer
        answers[program] = {"error": f"{type(error).__name__}: {error}"}
print(json.dumps(answers))
