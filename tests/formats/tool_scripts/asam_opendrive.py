"""The ASAM OpenDRIVE checker on many files. Runs with the checker's Python.

Question: a list of files. Answer: by file, how many checkers have completed, and the issues.
"""

from __future__ import annotations

import json
import logging
import sys

from qc_baselib import Configuration, Result
from qc_opendrive import constants
from qc_opendrive.main import run_checks


def checked(file: str) -> tuple[int, list[str]]:
    """How many rules were checked on a file, and what breaks them."""
    config, result = Configuration(), Result()
    config.set_config_param(name="InputFile", value=file)
    name = constants.BUNDLE_NAME
    result.register_checker_bundle(
        name=name, description="", version=constants.BUNDLE_VERSION, summary=""
    )
    run_checks(config, result)
    checkers = result.get_checker_results(name)
    statuses = [checker.status.value for checker in checkers]
    issues = [
        f"{checker.checker_id}: {issue.description}"
        for checker in checkers
        for issue in checker.issues
    ]
    return statuses.count("completed"), issues


def main() -> None:
    """Answer the question on standard input."""
    logging.disable(logging.CRITICAL)
    print(json.dumps({file: checked(file) for file in json.load(sys.stdin)}))


if __name__ == "__main__":
    main()
