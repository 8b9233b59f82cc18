"""A verdict in words, for a terminal."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from chatscene.verdict.result import in_a_line
from chatscene.verdict.verdict import Answer, Fact, Verdict

_WORDS = {
    Answer.SHOWN: "shown",
    Answer.IN_PART: "in part",
    Answer.NOT_SHOWN: "NOT shown",
    Answer.NOT_REACHED: "not reached",
    Answer.NOT_SEEN: "not in tracks",
}
_MOST = 3  # reasons for which drives were not made that are told; of more, how many


def in_words(verdict: Verdict) -> str:
    """What was judged, what was said, each fact, what else is seen, and what it comes to."""
    return "\n".join(_lines(verdict))


def _lines(verdict: Verdict) -> Iterator[str]:
    many = len(verdict.draws)
    yield f"{verdict.what}: {verdict.kind}, {many} {'drive' if many == 1 else 'drives'}"
    yield f"said: {verdict.told}"
    if verdict.not_read:
        yield f"  no fact was read in: {', '.join(verdict.not_read)}"
    yield from (f"  {name} is {who}" for name, who in verdict.who.items() if name != who)
    yield from (f"  {line}" for line in verdict.notes)
    reasons = _counted(verdict.rejected)
    for reason, times in reasons[:_MOST]:
        yield f"  {times} could not be driven: {reason}"
    if more := sum(times for _, times in reasons[_MOST:]):
        yield f"  {more} more could not be driven"
    if many:
        yield from _facts(verdict.facts)
        yield from _encounters(verdict)
        yield from (f"  unasked      {_in(one)}  {one.instead}" for one in verdict.unasked)
        yield from _careful(verdict)
    yield from (f"  {line}" for line in verdict.dead)
    yield f"{in_a_line(verdict)} (exit status {verdict.status})"


def _facts(facts: Sequence[Fact]) -> Iterator[str]:
    for one in facts:
        at = "" if one.at is None else f"{one.at:.1f} s"
        count = f"{one.shown}/{len(one.judged)}" if one.judged else "-"
        said = f": {one.said}" if one.said else ""
        told = f" ({one.instead})" if one.instead else ""
        given = ", assumed" if one.assumed else ""
        yield f"  {_WORDS[one.answer]:<14} {count:>5}  {at:>7}  {one.path}{said}{given}{told}"


def _encounters(verdict: Verdict) -> Iterator[str]:
    for one in verdict.encounters:
        who = one.path.removeprefix("encounter.")
        at = "" if one.at is None else f", at {one.at:.1f} s"
        told = f": {one.instead}" if one.instead else ""
        yield f"  encounter    the ego could meet {who} in {one.shown} of {len(one.judged)}{at}{told}"
    if not verdict.encounters:
        near = "".join(
            f"; {who} comes no nearer to the ego than {gap:.1f} m" for who, gap in verdict.nearest.items() if gap > 0.0
        )
        yield f"  encounter    nothing that was said needs one{near}"


def _careful(verdict: Verdict) -> Iterator[str]:
    crashes = verdict.crashes
    if not crashes:
        yield "  collisions   none"
        return
    known = [one for one in crashes if one.avoidable is not None]
    helped = f"a careful driver avoids {sum(bool(one.avoidable) for one in known)} of {len(known)}"
    yield f"  collisions   {len(crashes)}; {helped if known else 'it cannot be driven again to see who avoids them'}"


def _in(one: Fact) -> str:
    return f"in {len(one.judged) - one.shown} of {len(one.judged)}"


def _counted(lines: Sequence[str]) -> list[tuple[str, int]]:
    return [(one, lines.count(one)) for one in dict.fromkeys(lines)]
