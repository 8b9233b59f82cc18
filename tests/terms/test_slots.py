"""One table of slots: what may be in them, and that nobody else lists them."""

from __future__ import annotations

import ast
from dataclasses import fields

import pytest

from chatscene.library.load import load_library
from chatscene.terms.scenario import Component, Slots
from chatscene.terms.slots import SLOTS, slots_of
from places import ROOT

SOURCE = ROOT / "src" / "chatscene"
KNOWN = {SOURCE / "terms" / "slots.py", SOURCE / "terms" / "scenario.py"}
ELSEWHERE = {}
MANY = 4  # of a list of slots; two or three stand together for reasons of their own


def test_the_table_has_every_slot_in_the_order_of_its_fields() -> None:
    assert list(SLOTS) == [field.name for field in fields(Slots) if field.name not in ("actions", "others")]


@pytest.mark.parametrize("component", list(Component))
def test_snippets_fill_what_the_table_says_of_their_component(component: Component) -> None:
    may = {*slots_of(component), *(name for name, slot in SLOTS.items() if slot.shared), "actions"}
    for snippet in load_library().of(component):
        said = snippet.slots.said()
        assert set(said) <= may, snippet.id
        assert all(
            value is False or value in SLOTS[name].values for name, value in said.items() if name != "actions"
        ), snippet.id


def test_what_is_about_was_added() -> None:
    assert all(slot.added for slot in SLOTS.values() if slot.about)


def test_no_other_file_lists_the_slots() -> None:
    found: set[str] = set()
    for path in set(SOURCE.rglob("*.py")) - KNOWN:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Tuple | ast.List | ast.Set):
                named = [e.value for e in node.elts if isinstance(e, ast.Constant) and e.value in SLOTS]
                if len(named) >= MANY:
                    found.add(str(path.relative_to(SOURCE)))
    assert found == set(ELSEWHERE)
