"""A situation whose road users have other names."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from chatscene.terms.situation import Deed, Situation


def renamed(situation: Situation, names: Mapping[str, str]) -> Situation:
    """A situation in which others have other ids, and whoever speaks of them speaks of these."""

    def of(name: str | None) -> str | None:
        return names.get(name, name) if name is not None else None

    def of_deed(name: str | None) -> str | None:
        if name is None:
            return None
        who, dot, number = name.rpartition(".")
        return f"{of(who)}{dot}{number}"

    def deed(one: Deed) -> Deed:
        when = one.when and replace(
            one.when, after=of_deed(one.when.after), during=of_deed(one.when.during), of=of(one.when.of)
        )
        return replace(one, whom=of(one.whom), when=when)

    others = tuple(
        replace(one, id=of(one.id) or one.id, hidden_by=of(one.hidden_by), does=tuple(map(deed, one.does)))
        for one in situation.others
    )
    contact = situation.contact and replace(situation.contact, whom=of(situation.contact.whom))
    ego = replace(situation.ego, does=tuple(map(deed, situation.ego.does)))
    return replace(situation, ego=ego, others=others, contact=contact)
