"""What users of other tools write where something is declared or named; see `habits`."""

from __future__ import annotations

from .habit_statements import EGO, GENTLE, LEAD

DECLARATIONS = [
    # What is written, the code, a part of the help, what the fix puts in its place.
    ("scenario sut.cut_in_ahead:", "RL001", "roadlang does not read OpenSCENARIO DSL", None),
    ("scenario top:\n    v1: vehicle with:\n        keep(it.speed > 1mps)\n", "RL001", "DSL", None),
    ("modifier near:\n    near: car", "RL002", "roadlang does not read OpenSCENARIO DSL", None),
    (EGO + LEAD + "require r: start(lead) > 4m", "RL225", "write `lead.start`", None),
    (
        "network t from [main, other]\nagent a is car on t { route: [(1m, 2m), left] }",
        "RL001",
        "a network is made from an image",
        None,
    ),
    ('scenario until "A bend"', "RL011", "choose another name", None),
    (f"require since: always {GENTLE}", "RL011", "choose another name", None),
    (EGO.replace("12m/s", "-5m/s"), "RL208", "`drive with reverse` backs up", None),
    (
        EGO.replace("pure_pursuit", "choice(pure_pursuit, stanley)"),
        "RL001",
        "the kind after `with` is not drawn at random",
        None,
    ),
    ("param paved = choice(asphalt, 9m)", "RL101", '`"asphalt"`', None),
    ("param wet = choice(9m, wet)", "RL104", '`"wet"`', None),
    (EGO + "agent c is car at right_of(ego)", "RL225", "`beside(ego, right)`", None),
]
