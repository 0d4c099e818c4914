"""Roads of the SBFT tool competition for cyber-physical systems: as road points, and by its rules.

The rules are those of its validator (`code_pipeline/validation.py` of
github.com/sbft-cps-tool-competition/cps-tool-competition, commit 40ec9d9), computed for many roads
at once.
"""
