"""What a verdict comes to, in one line: what decides it, how many drives show what was said, what they leave open."""

from __future__ import annotations

from collections.abc import Iterator

from chatscene.verdict.verdict import VERDICTS, Fact, Verdict

_MOST = 4  # paths that are named; of more, how many


def in_a_line(verdict: Verdict) -> str:
    """The answer, then what decides it if that is nothing that was said, then how many drives show what was said.

    What no drive came to, or no track tells, stands beside that number: a drive shows nothing of it.
    """
    return f"{VERDICTS[verdict.status]}: {'; '.join(_parts(verdict))}"


def _parts(verdict: Verdict) -> Iterator[str]:
    many = len(verdict.draws)
    unasked = [one for one in verdict.unasked if one.fails(verdict.least)]
    said = [one for one in (*verdict.facts, *verdict.encounters) if one.fails(verdict.least)]
    if not verdict.judged or said or not (unasked or verdict.dead):
        shows = {one.number for one in verdict.draws if not one.missing}
        yield f"{len(shows)} of {many} drives show all of it{_but(verdict, shows)}"
        return
    yield from (f"{one.instead} ({len(one.judged) - one.shown} of {many} drives)" for one in unasked)
    yield from verdict.dead
    shows = _showing_what_was_said(verdict)
    yield f"{len(shows)} of {many} drives show all that was said{_but(verdict, shows)}"


def _showing_what_was_said(verdict: Verdict) -> set[int]:
    """The drives that show all that was said, whatever else happens in them."""
    wrong = {
        seen.draw
        for one in (*verdict.facts, *verdict.encounters)
        if not one.assumed
        for seen in one.seen
        if seen.shown is False
    }
    return {one.number for one in verdict.draws} - wrong


def _but(verdict: Verdict, shows: set[int]) -> str:
    """What those drives say nothing about."""
    if not shows:
        return ""
    said = [one for one in verdict.facts if not one.assumed]
    open_in = {one.path: len(shows - {seen.draw for seen in one.judged}) for one in said if not _untold(one)}
    missed = [path if n == len(shows) else f"{path} in {n} of them" for path, n in open_in.items() if n]
    untold = [one.path for one in said if _untold(one)]
    groups = [f"what they did not reach ({_listed(missed)})"] * bool(missed)
    groups += [f"what tracks cannot show ({_listed(untold)})"] * bool(untold)
    return f", except {' and '.join(groups)}" if groups else ""


def _untold(one: Fact) -> bool:
    return one.untold and not one.judged


def _listed(paths: list[str]) -> str:
    more = len(paths) - _MOST
    return ", ".join(paths[:_MOST]) + (f" and {more} more" if more > 0 else "")
