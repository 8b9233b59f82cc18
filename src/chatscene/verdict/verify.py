"""The verb: hold a scene, a program or a recording against what was said."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from chatscene.program.contacts import is_of
from chatscene.program.deeds import MOVING
from chatscene.program.finding import Finding, failures
from chatscene.settings import VerifySettings
from chatscene.simulate.boxes import least_gap
from chatscene.situations.form import to_plain
from chatscene.situations.phrases import one_seen
from chatscene.situations.words import told
from chatscene.terms.episode import Episode, Role
from chatscene.terms.mirroring import as_said_on
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import RESTS, EgoRoute
from chatscene.verdict.said import Asked
from chatscene.verdict.verdict import Draw, Verdict
from chatscene.verdict.watched import Watched, Watching
from chatscene.verdict.weighing import beside, facts_of, findings_of, with_what_is_seen
from chatscene.verdict.who import Cast, Played, as_cast, cast_of


def weighed(found: Watching, what: str, asked: Asked, settings: VerifySettings) -> Verdict:
    """What drives show of what was said.

    Args:
        found: The drives.
        what: What messages call that of which they are.
        asked: What they are to show.
        settings: In how many of them a fact must be shown.
    """
    situation = as_said_on(asked.situation, keeps_left=any(one.route.mirrored for one in found.drives))
    driven = tuple(one for one in found.drives if len(one.episode.ego_track.x) > 1)
    stepless = len(found.drives) - len(driven)
    dead = [f"{stepless} of {len(found.drives)} drives end without a step"] if stepless else []
    if found.failed:
        tried = len(found.drives) + found.failed
        dead.append(f"the program fails, or does not come to its end, in {found.failed} of {tried} drives")
    told_so = told(situation)
    if not driven:
        return Verdict(
            what=what,
            kind=found.kind,
            told=told_so,
            situation=to_plain(situation),
            not_read=asked.not_read,
            rejected=found.rejected,
            dead=tuple(dead),
            notes=found.notes,
            least=settings.least,
        )
    cast = cast_of(situation, driven)
    played = tuple(as_cast(one.episode, cast) for one in driven)
    episodes = [one.episode for one in played]
    findings = tuple(findings_of(situation, one, here) for one, here in zip(driven, played, strict=True))
    ways = [(here, one.route) for one, here in zip(driven, played, strict=True)]
    every = (facts_of(situation, findings), beside(findings, "encounter."), beside(findings, "unasked."))
    facts, encounters, unasked = (tuple(with_what_is_seen(part, situation, ways)) for part in every)
    return Verdict(
        what=what,
        kind=found.kind,
        told=told_so,
        situation=to_plain(situation),
        not_read=asked.not_read,
        draws=tuple(_draws(driven, played, findings)),
        rejected=found.rejected,
        facts=facts,
        encounters=encounters,
        unasked=unasked,
        nearest=_nearest(situation, episodes),
        dead=(*dead, *_still(situation, episodes, settings.least)),
        notes=(*found.notes, *_cut(played, cast), *_unplayed(driven), *_motionless(situation, episodes)),
        who=_in_words(cast),
        least=settings.least,
        played=tuple(episodes),
    )


def _draws(
    driven: Sequence[Watched], played: Sequence[Played], findings: Sequence[tuple[Finding, ...]]
) -> Iterator[Draw]:
    for number, (one, here, found) in enumerate(zip(driven, played, findings, strict=True)):
        episode, crash = here.episode, here.episode.collision
        yield Draw(
            number=number,
            begin=round(here.begin, 3),
            seconds=round(episode.duration, 3),
            ending=episode.ending.value,
            collision=crash.other if crash else "",
            at=round(here.begin + crash.step * episode.dt, 3) if crash else None,
            impact=round(crash.impact_speed, 3) if crash else None,
            avoidable=one.avoidable,
            missing=failures(found),
            variant=one.variant,
        )


def _nearest(situation: Situation, episodes: Sequence[Episode]) -> dict[str, float]:
    """How near [m] each adversary comes to the ego in any drive; one who is in none of them is left out."""
    found = dict[str, float]()
    for one in situation.adversaries:
        every = [
            least_gap(episode.ego_track, track)
            for episode in episodes
            for track in episode.tracks
            if is_of(track.actor, one.id)
        ]
        if every:
            found[one.id] = min(every)
    return found


def _cut(played: Sequence[Played], cast: Cast) -> Iterator[str]:
    """From when to when drives are judged in which somebody is not there all the time, and who is not judged."""
    who = ", ".join(actor for actors in cast.values() for actor in actors)
    for one in played:
        if one.cut:
            end = one.begin + one.episode.duration
            yield f"judged from {one.begin:.1f} to {end:.1f} s, while {who} and the ego are there"
        if one.left_out:
            yield f"not judged, except contacts: {', '.join(one.left_out)}, absent for part of that time"


def _moves(speed: object) -> bool:
    return bool((np.abs(np.asarray(speed)) > MOVING).any())


def _still(situation: Situation, episodes: Sequence[Episode], least: float) -> Iterator[str]:
    """An ego that never moves, of which nobody said that it stands."""
    stays = any(deed.act in RESTS for deed in situation.ego.does) or situation.ego.route is EgoRoute.PARK
    still = sum(not _moves(one.ego_track.speed) for one in episodes)
    if still > (1.0 - least) * len(episodes) and not stays:
        yield f"the ego never moves in {still} of {len(episodes)} drives, which the text does not say"


def _motionless(situation: Situation, episodes: Sequence[Episode]) -> Iterator[str]:
    """Road users that never move in any drive, and of whom nobody said that they stand."""
    said = {one.id for one in situation.others if not one.does or any(deed.act in RESTS for deed in one.does)}
    for track in episodes[0].adversaries:
        name = track.actor.partition("-")[0]
        if name in said or track.role is not Role.ADVERSARY:
            continue
        if not any(_moves(other.speed) for one in episodes for other in one.tracks if other.actor == track.actor):
            yield f"{track.actor}, {one_seen(track.kind)}, never moves in any drive"


def _unplayed(driven: Sequence[Watched]) -> Iterator[str]:
    every = [line for one in driven for line in one.unplayed]
    for line in dict.fromkeys(every):
        yield f"in {every.count(line)} of {len(driven)} drives, {line}"


def _in_words(cast: Cast) -> dict[str, str]:
    return {name: ", ".join(actors) or "nobody" for name, actors in cast.items()}
