"""What ASAM's checker of OpenSCENARIO XML says, for tests of several exporters."""

from __future__ import annotations

import logging
from pathlib import Path

import pytest


def assert_nothing_wrong(path: Path, caplog: pytest.LogCaptureFixture) -> tuple[int, int]:
    """Nothing in a file; how many checks came to their end, of how many. Skips the test where there is no checker."""
    missing = "asam-qc-openscenarioxml is not installed"
    baselib = pytest.importorskip("qc_baselib", reason=missing)
    constants = pytest.importorskip("qc_openscenario.constants", reason=missing)
    run_checks = pytest.importorskip("qc_openscenario.main", reason=missing).run_checks
    caplog.set_level(logging.ERROR)
    configuration, result = baselib.Configuration(), baselib.Result()
    configuration.set_config_param("InputFile", str(path))
    result.register_checker_bundle(name=constants.BUNDLE_NAME, description="", version="1", summary="")
    result.set_result_version("1")
    run_checks(configuration, result)
    checkers = result.get_checker_bundle_result(constants.BUNDLE_NAME).checkers
    assert [issue.description for checker in checkers for issue in checker.issues] == []
    done = [checker.checker_id for checker in checkers if checker.status is baselib.StatusType.COMPLETED]
    assert "check_asam_xosc_xml_valid_schema" in done
    return len(done), len(checkers)
