"""JSON for a person is written as Python's own module writes it."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from chatscene.files.indented import indented
from chatscene.terms.episode import Ending

LEAVES = st.none() | st.booleans() | st.integers() | st.floats() | st.text()
CONTENT = st.recursive(
    LEAVES, lambda inner: st.lists(inner) | st.lists(st.floats()) | st.dictionaries(st.text(), inner), max_leaves=30
)


def own(content: Any) -> str:
    return json.dumps(content, indent=1, ensure_ascii=False)


@given(CONTENT)
def test_any_content_is_the_same_text(content: Any) -> None:
    assert indented(content) == own(content)


@pytest.mark.parametrize(
    "content",
    [
        {2: "a", 2.5: "b", None: "c", True: "d", Ending.OVER: Ending.OVER},
        [np.float64(0.1), 0.2, math.nan, -math.inf, -0.0],
        ((1.0, 2.0), (), {}, [[]], "ä\n\u2028\U0001f600"),
    ],
)
def test_so_is_what_is_no_plain_json_in_python(content: Any) -> None:
    assert indented(content) == own(content)


def test_what_is_no_json_is_refused_alike() -> None:
    with pytest.raises(TypeError, match="not JSON serializable"):
        indented({"a": [object()]})
