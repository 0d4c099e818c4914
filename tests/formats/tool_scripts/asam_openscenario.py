"""Checks OpenSCENARIO files with the checker of ASAM: {"files": [...]}.

Answers with [completed rules, issues] for each file: the checker skips rules without a word.
"""

import json
import logging
import sys
from pathlib import Path

logging.disable(logging.CRITICAL)

from qc_baselib import Configuration, Result, StatusType  # noqa: E402
from qc_openscenario import constants  # noqa: E402
from qc_openscenario.main import run_checks  # noqa: E402


def checked(file: str) -> list[object]:
    """Of one file."""
    config, result = Configuration(), Result()
    config.set_config_param(name="InputFile", value=file)
    result.register_checker_bundle(
        name=constants.BUNDLE_NAME, description="", version=constants.BUNDLE_VERSION, summary=""
    )
    result.set_result_version(version=constants.BUNDLE_VERSION)
    run_checks(config, result)
    target = Path(file).with_suffix(".xqar")
    result.write_to_file(str(target))
    bundle = result.get_checker_results(constants.BUNDLE_NAME)
    completed = sum(checker.status == StatusType.COMPLETED for checker in bundle)
    issues = [
        f"{issue.rule_uid}: {issue.description}" for checker in bundle for issue in checker.issues
    ]
    return [completed, issues]


files = json.load(sys.stdin)["files"]
sys.stdout.write(json.dumps([checked(file) for file in files]) + "\n")
