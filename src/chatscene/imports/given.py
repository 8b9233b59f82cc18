"""What a scenario file gives: its parameters, the numbers made of them, and what of it is taken, noted or refused."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import product

from chatscene.errors import ScenarioError, SnippetError
from chatscene.imports.stranger_xml import Element
from chatscene.terms.plan import Parameter, walk
from chatscene.terms.plan_text import PARAMETERS, parse_expression
from chatscene.terms.snippet import ParameterRange
from chatscene.terms.sums import Sum, number, sum_of, valued

REPORTED = 20  # refusals in one message
DEEPEST = 50  # parameters, each an expression of the next
MOST_CHARACTERS = 4_000  # of an expression with its parameters: each may name another twice
_REFERENCE = re.compile(r"\$([A-Za-z_][A-Za-z0-9_]*)")
_RANGED = frozenset(("double", "int", "integer", "unsignedInt", "unsignedShort"))
_LOWER, _UPPER = frozenset(("greaterOrEqual", "greaterThan")), frozenset(("lessOrEqual", "lessThan"))


class Refused(Exception):  # noqa: N818 - reads as what it says
    """An element says what cannot be said here."""

    def __init__(self, element: Element, why: str) -> None:
        super().__init__(f"line {element.line}: <{element.tag}>: {why}")


@dataclass(slots=True)
class Given:
    """What a file gives.

    Attributes:
        ranges: Parameters that vary, by their name in the file.
        values: The value of every parameter, as written.
        notes: What was taken otherwise than it is written, or left to others, each with its line.
        refusals: What cannot be said here, each with its line.
    """

    ranges: dict[str, ParameterRange] = field(default_factory=dict[str, ParameterRange])
    values: dict[str, str] = field(default_factory=dict[str, str])
    notes: list[str] = field(default_factory=list[str])
    refusals: list[str] = field(default_factory=list[str])

    def declare(self, root: Element) -> None:
        """Read the parameters of a file."""
        for one in (below for group in root.all("ParameterDeclarations") for below in group.inside):
            name, kind = one.attributes.get("name", ""), one.attributes.get("parameterType", "double")
            if not re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]{0,50}", name):
                self.refusals.append(str(Refused(one, f"{name[:40]!r} is no name; use letters, digits and _")))
                continue
            self.values[name] = one.attributes.get("value", "")
            groups = one.all("ConstraintGroup")
            if kind in _RANGED and groups:
                try:
                    self._float(one, self.values[name])
                    self.ranges[name] = self._range(one, name, groups)
                except Refused as reason:
                    self.refusals.append(str(reason))

    def _range(self, declared: Element, name: str, groups: list[Element]) -> ParameterRange:
        if len(groups) > 1:
            raise Refused(declared, "its values lie in one range or another; write one ConstraintGroup")
        bounds: dict[str, float] = {}
        for one in groups[0].inside:
            rule = one.attributes.get("rule", "")
            side = "low" if rule in _LOWER else "high" if rule in _UPPER else None
            if side is None:
                raise Refused(one, f"the rule {rule!r} gives no range; write greaterOrEqual and lessOrEqual")
            bounds[side] = self._float(one, one.attributes.get("value", ""))
        low, high = bounds.get("low"), bounds.get("high")
        if low is None or high is None or low > high:
            raise Refused(declared, "its range has no two ends; write greaterOrEqual and lessOrEqual")
        upper = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).upper()
        return ParameterRange(name=upper if upper.startswith("OPT_") else f"OPT_{upper}", low=low, high=high, unit="1")

    def text(self, element: Element, name: str, default: str | None = None) -> str:
        """What an attribute says; the value of a parameter in its place."""
        written = element.attributes.get(name, default)
        if written is None:
            raise Refused(element, f"it has no attribute {name!r}")
        if (found := _REFERENCE.fullmatch(written)) is not None:
            if found[1] not in self.values:
                raise Refused(element, f"it speaks of ${found[1]}, which the file does not declare")
            return self.values[found[1]]
        return written

    def sum(self, element: Element, name: str, default: str | None = None) -> Sum:
        """The number that an attribute says, of parameters that vary."""
        written = element.attributes.get(name, default)
        if written is None:
            raise Refused(element, f"it has no attribute {name!r}")
        written = written.strip()
        if not written.startswith("$"):
            return number(self._float(element, written))
        try:
            expression = parse_expression(self._filled(element, written, ()))
            found = sum_of(expression)
        except (SnippetError, ZeroDivisionError) as error:
            raise Refused(element, f"{written[:60]!r} is no number that can be said here ({error})") from error
        if found is None:
            raise Refused(element, f"{written[:60]!r} is no number; use + - * / abs max min")
        return found

    def least(self, one: Sum) -> float:
        """The least that a sum is at the ends of the ranges of its parameters."""
        expression = one.expression
        read = {part.name for part in walk(expression) if isinstance(part, Parameter)}
        ends = [[(r.name, r.low), (r.name, r.high)] for r in self.ranges.values() if r.name in read]
        return min(valued(expression, dict(corner)) for corner in product(*ends))

    def _filled(self, element: Element, written: str, within: tuple[str, ...]) -> str:
        """An expression with what each parameter stands for, which may be an expression of others."""
        inner = written[2:-1] if written.startswith("${") and written.endswith("}") else written
        filled = _REFERENCE.sub(lambda one: self._spelled(element, one[1], within), inner)
        if len(filled) > MOST_CHARACTERS:
            raise Refused(element, f"{written[:40]!r} is longer than {MOST_CHARACTERS} characters with its parameters")
        return filled

    def _spelled(self, element: Element, name: str, within: tuple[str, ...]) -> str:
        if name in self.ranges:
            return f"{PARAMETERS}.{self.ranges[name].name}"
        if name not in self.values:
            raise Refused(element, f"it speaks of ${name}, which the file does not declare")
        if name in within or len(within) > DEEPEST:
            raise Refused(element, f"${name} is an expression of itself, or of too many others in a row")
        value = self.values[name].strip()
        if value.startswith("$"):
            return f"({self._filled(element, value, (*within, name))})"
        return f"({self._float(element, value)!r})"

    def number(self, element: Element, name: str, default: str | None = None) -> float:
        """The number that an attribute says, which may not vary."""
        found = self.sum(element, name, default)
        if found.number is None:
            raise Refused(element, f"its {name} varies with a parameter, which can be said of few places here")
        return found.number

    def _float(self, element: Element, written: str) -> float:
        try:
            found = float(written)
        except ValueError:
            raise Refused(element, f"{written[:40]!r} is no number") from None
        if not math.isfinite(found) or abs(found) > 1e6:
            raise Refused(element, f"{written[:40]} is no number within a million")
        return found

    @property
    def nominal(self) -> Mapping[str, float]:
        """The value of each parameter that varies, by its name here."""
        return {one.name: one.clip(float(self.values[name])) for name, one in self.ranges.items()}

    def raise_refusals(self, path: object) -> None:
        """Tell all that was refused.

        Raises:
            ScenarioError: Anything was.
        """
        if self.refusals:
            told = list(dict.fromkeys(self.refusals))
            more = f"\n  and {len(told) - REPORTED} more" if len(told) > REPORTED else ""
            raise ScenarioError(f"{path} cannot be said here:\n  " + "\n  ".join(told[:REPORTED]) + more)
