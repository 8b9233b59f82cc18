"""From what the judge tells of each drive to what all of them show of each fact."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from chatscene.program.doing import ACTS
from chatscene.program.finding import UNTOLD, Finding, not_judged
from chatscene.program.judge import judge
from chatscene.program.watching import watch
from chatscene.situations.facts import said_in, within
from chatscene.terms.route import Route
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import GOES_ON, LETS_GO, PLAIN
from chatscene.verdict.verdict import Fact, Seen
from chatscene.verdict.watched import Watched
from chatscene.verdict.who import Played

WITHOUT_MAP = ("road", "around")
"""What tracks alone do not tell, where there is no map, no light and nobody who says what surrounds them."""
GENERAL = PLAIN | GOES_ON | frozenset(LETS_GO)
"""What is seen of nearly everybody, or of a body that is let go: it tells nothing of whoever does another deed."""
_BESIDE = ("encounter.", "unasked.")
_MOST_INSTEAD = 5  # deeds that are told of somebody who does another than was said


def findings_of(situation: Situation, one: Watched, played: Played) -> tuple[Finding, ...]:
    """What a drive shows, of a drive of which nothing else is known than tracks no more than they tell.

    Args:
        situation: What was said.
        one: The drive.
        played: The same, in which everybody has the name of who is meant.
    """
    found = (_as_known(finding, one) for finding in judge(situation, played.episode, one.route))
    begin = played.begin
    return tuple(one if one.at is None else replace(one, at=one.at + begin) for one in found)


def _as_known(finding: Finding, one: Watched) -> Finding:
    if finding.cut and finding.shown:
        return replace(finding, shown=None, told=f"{finding.told}, and a contact came before it was done")
    if not one.mapped and finding.path.partition(".")[0] in WITHOUT_MAP:
        return not_judged(finding.path)
    if not one.mapped and finding.path == "ego.route" and one.episode.collision is not None and not finding.shown:
        return replace(finding, shown=None)  # where it was bound for when it crashed no track tells
    if not one.tested and finding.path == "contact.happens" and finding.shown is None:
        return replace(finding, shown=False)  # nobody else drove who could have helped it
    return finding


def facts_of(situation: Situation, found: Sequence[Sequence[Finding]]) -> tuple[Fact, ...]:
    """What drives show of each fact that was said, in the order in which facts stand.

    Args:
        situation: What was said.
        found: What the judge tells of each drive.
    """
    told = {f.path for one in found for f in one if not f.path.startswith(_BESIDE)}
    said = dict(said_in(situation))
    values: dict[str, str] = {}
    for path, value in said.items():
        whole = next((one for one in told if within(path, (one,))), path)
        values[whole] = f"{values[whole]}, {value}" if whole in values else str(value)
    paths = [*values, *sorted(told - values.keys())]  # such as that there is one of somebody, which nobody wrote
    seen = _by_path(found)
    assumed = set(situation.evidence.assumed)
    facts = [
        Fact(
            path=path,
            said=values.get(path, ""),
            seen=seen.get(path, ()),
            untold=path not in told or all(one.told == UNTOLD for one in seen[path]),
            assumed=within(path, assumed),
        )
        for path in paths
    ]
    undone = {one.path.removesuffix(".act") for one in facts if one.path.endswith(".act") and not one.shown}
    return tuple(replace(one, untold=False) if not one.seen and within(one.path, undone) else one for one in facts)


def beside(found: Sequence[Sequence[Finding]], prefix: str) -> tuple[Fact, ...]:
    """Encounters, or what nobody said: a finding that a drive has none of counts as shown in it, if nobody said it.

    What was said asks for an encounter if it does so in most drives.
    """
    seen = _by_path([[f for f in one if f.path.startswith(prefix)] for one in found])
    if prefix.startswith("encounter"):
        seen = {path: there for path, there in seen.items() if 2 * len(there) >= len(found)}
    if prefix.startswith("unasked"):
        draws = range(len(found))
        seen = {
            path: tuple(
                next((s for s in there if s.draw == n), Seen(draw=n, shown=True, told="", at=None)) for n in draws
            )
            for path, there in seen.items()
        }
    return tuple(Fact(path=path, seen=there) for path, there in sorted(seen.items()))


def _by_path(found: Sequence[Iterable[Finding]]) -> dict[str, tuple[Seen, ...]]:
    """What each drive shows of each path; of several findings of one in a drive, the one that is against it."""
    seen: dict[str, dict[int, Seen]] = {}
    for draw, findings in enumerate(found):
        for one in findings:
            here = seen.setdefault(one.path, {})
            before = here.get(draw)
            if before is None or _RANK[one.shown] < _RANK[before.shown]:
                here[draw] = Seen(draw=draw, shown=one.shown, told=one.told, at=one.at)
    return {path: tuple(there.values()) for path, there in seen.items()}


_RANK = {False: 0, True: 1, None: 2}


def with_what_is_seen(
    facts: Iterable[Fact], situation: Situation, drives: Sequence[tuple[Played, Route]]
) -> Iterator[Fact]:
    """Facts that are not shown, with what is seen in their place: the deed that was said, other deeds."""
    for fact in facts:
        wrong = [one for one in fact.seen if one.shown is False]
        if not wrong:
            yield fact
            continue
        told, _ = Counter(one.told for one in wrong).most_common(1)[0]
        parts = fact.path.split(".")
        act = len(parts) == 5 and parts[0] == "others" and parts[-1] == "act"
        if act and (does := ", ".join(_seen_of(parts[1], situation, *drives[wrong[0].draw]))):
            told = f"{told}; it is seen to {does}"
        yield replace(fact, instead=told)


def _seen_of(name: str, situation: Situation, played: Played, route: Route) -> Iterator[str]:
    """What somebody is seen to do, in order, with the time at which it begins."""
    episode = played.episode
    tracks = [track for track in episode.tracks if track.actor in (name, f"{name}-1")]
    if not tracks:
        return
    crash = episode.collision
    seen = watch(episode, route, tracks[0], crash.step if crash else None)
    moves = situation[name].kind.moves
    may = [(act, sees) for act, sees in ACTS.items() if moves in act.row.by and act not in GENERAL]
    first_of = {sees: act for act, sees in reversed(may)}  # of acts that tracks do not tell apart
    began: Mapping[str, int] = {
        act.value: first.began
        for act, sees in may
        if first_of[sees] is act
        and (first := next((one for one in sees(seen) if crash or one.done is not None), None)) is not None
    }
    for act, step in sorted(began.items(), key=lambda one: one[1])[:_MOST_INSTEAD]:
        yield f"{act} at {played.begin + step * episode.dt:.1f} s"
