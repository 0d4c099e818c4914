"""The tests of roadlang, which compute with the same bits on all x86 processors with AVX2.

OpenBLAS and numpy have loops for each processor, whose last digits differ. What is stored in
`tests/golden` was computed with those for AVX2: where extraction counts points, or junctions are
made smaller in steps, a last digit can become a whole one. Other processors ignore this.
"""

import os

os.environ.setdefault("OPENBLAS_CORETYPE", "Haswell")
# Read when numpy is imported; those before numpy 2.4 know these features by other names.
os.environ.setdefault(
    "NPY_DISABLE_CPU_FEATURES",
    "X86_V4 AVX512F AVX512CD AVX512_SKX AVX512_CLX AVX512_CNL AVX512_ICL AVX512_SPR",
)
