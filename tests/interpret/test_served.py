"""A sentence that was once served wrongly."""

from __future__ import annotations

import pytest

from chatscene.errors import NothingFits
from chatscene.report.understood import understand


def test_who_was_served_from_the_other_side_is_refused_for_it() -> None:
    with pytest.raises(NothingFits, match="nothing in the library does this"):
        understand("A car turns left out of a side road on our left and ends up in our lane.")
