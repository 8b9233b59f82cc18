"""What ASAM's checkers of OpenSCENARIO XML and OpenDRIVE say, for tests of several writers of these."""

from __future__ import annotations

import logging
from pathlib import Path

import pytest


def assert_nothing_wrong(path: Path, caplog: pytest.LogCaptureFixture, checker: str) -> tuple[int, int]:
    """Nothing in a file; how many checks came to their end, of how many. Skips the test where there is no checker.

    Args:
        path: The file.
        caplog: Of the test, for the checker says much.
        checker: Which: ``openscenario`` or ``opendrive``.
    """
    missing = f"ASAM's checker of {checker} is not installed, or has no wheel for this Python"
    baselib = pytest.importorskip("qc_baselib", reason=missing)
    constants = pytest.importorskip(f"qc_{checker}.constants", reason=missing)
    run_checks = pytest.importorskip(f"qc_{checker}.main", reason=missing).run_checks
    caplog.set_level(logging.ERROR)
    configuration, result = baselib.Configuration(), baselib.Result()
    configuration.set_config_param("InputFile", str(path))
    result.register_checker_bundle(name=constants.BUNDLE_NAME, description="", version="1", summary="")
    result.set_result_version("1")
    run_checks(configuration, result)
    checkers = result.get_checker_bundle_result(constants.BUNDLE_NAME).checkers
    assert [issue.description for one in checkers for issue in one.issues] == []
    done = [one.checker_id for one in checkers if one.status is baselib.StatusType.COMPLETED]
    assert [one.checker_id for one in checkers if one.status is baselib.StatusType.ERROR] == []
    assert any(name.endswith("valid_schema") for name in done)
    return len(done), len(checkers)
