"""Runs in the environment of Scenic: python scenic_rate.py PROGRAM SCENES.

Prints scenes for each second of processor time, without what reading the program takes, and the
share of Scenic's iterations that were scenes.
"""

import random
import sys
import time
import warnings

import numpy
import scenic

warnings.simplefilter("ignore")
program, count = sys.argv[1], int(sys.argv[2])
random.seed(1)
numpy.random.seed(1)  # noqa: NPY002 - what Scenic draws with
scenario = scenic.scenarioFromFile(program, mode2D=True)
scenario.generate(maxIterations=1_000_000)
start, iterations = time.process_time(), 0
for _ in range(count):
    iterations += scenario.generate(maxIterations=1_000_000)[1]
print(count / (time.process_time() - start), count / iterations)
