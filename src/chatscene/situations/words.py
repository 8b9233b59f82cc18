"""A situation in plain English: a few short sentences, in which each fact that was said is told once.

The phrases are those of `chatscene.situations.phrases`; this puts them in order. What was not said is not told.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from itertools import chain
from typing import TypeVar

from chatscene.situations.naming import (
    Form,
    Named,
    Words,
    called_of,
    filled,
    form_of,
    joined,
    named_by,
    numeral,
    ordinal,
    sentence,
    target_of,
)
from chatscene.situations.phrases import (
    ACTS,
    AHEAD,
    AWAY,
    BREACHES,
    CONTROLS,
    EGO_LIGHTS,
    FACINGS,
    FEATURES,
    KINDS,
    LATERAL_PHRASES,
    LIGHTS,
    MANNERS,
    PARTS,
    PLACES,
    ROADS,
    ROLES,
    ROUTES,
    SETTINGS,
    SIDES,
    STRIKERS,
    SURFACES,
    VOICES,
    WEATHERS,
    Me,
    Voice,
)
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.amount import Amount
from chatscene.terms.backing import backs
from chatscene.terms.nouns import with_article
from chatscene.terms.situation import EGO, SEVERAL, Contact, Deed, Lateral, Other, Road, Situation, When
from chatscene.terms.vocabulary import Manner, Striker

W = TypeVar("W")
TITLE = 200
_BOUNDS = re.compile(r"at (?P<which>most|least) (?P<amount>.*)")
_THAN = re.compile(r" (?P<more>more|less) than the ego$")
_FASTER = {"more": "faster", "less": "slower"}
_FIRST_SV = re.compile(r"\b(?P<the>[Tt]he) SV(?P<own>'s)?")
_A_SENTENCE = 2  # deeds that one holds
_GOES, _RIDES = "[drive/drives/driving]", "[ride/rides/riding]"
_IS = "[are/is/being]"


def told(situation: Situation, voice: Voice = Voice.PLAIN) -> str:
    """A situation in a few short sentences; nothing of one that says nothing."""
    return _whole(situation, voice).text


def facts_told(situation: Situation, voice: Voice = Voice.PLAIN) -> tuple[tuple[str, str], ...]:
    """The path of each fact of a situation, and the words of `told` that tell it, in their order."""
    whole = _whole(situation, voice)
    in_order = sorted(whole.facts, key=lambda fact: (fact[1], -fact[2]))
    return tuple((path, whole.text[low:high]) for path, low, high in in_order)


def title(situation: Situation, most: int = TITLE) -> str:
    """What a situation that nobody gave a name is called: as many of its first sentences as there is room for."""
    made = ""
    for one in _Telling.of(situation, Voice.PLAIN).sentences():
        longer = f"{made} {one.text}".strip()
        if len(longer) > most:
            return made or f"{longer[: most - 1].rsplit(' ', 1)[0]}…"
        made = longer
    return made


def _whole(situation: Situation, voice: Voice) -> Words:
    whole = joined(_Telling.of(situation, voice).sentences(), by=" ", last=" ")
    return whole.with_first(_FIRST_SV, r"\g<the> subject vehicle\g<own> (SV\g<own>)")


class _Telling(Named):
    """How one situation is told."""

    @property
    def _me(self) -> Me:
        return VOICES[self.voice]

    @property
    def _my_form(self) -> Form:
        return Form.SEVERAL if self._me.several else Form.ONE

    @property
    def _my_way(self) -> str:
        """The verb for the ego's way of moving."""
        kind = self.situation.ego.kind
        return _RIDES if kind is not None and kind.moves is Moves.RIDES else _GOES

    def sentences(self) -> Iterator[Words]:
        """Each sentence, in order."""
        own = tuple(self._deeds(EGO, self._me.does))
        waits = any(name != EGO for deed in self.situation.ego.does for name in named_by(deed))
        told = (
            (self._vehicle(), self._ego(), self._exit()),
            self._road(),
            () if waits else own,
            self._others(),
            own if waits else (),
            (self._contact(), self._around()),
        )
        return filter(None, chain.from_iterable(told))

    # The ego and the road

    def _vehicle(self) -> Words:
        """What the ego is."""
        kind = self.situation.ego.kind
        if kind is None:
            return Words()
        named = Words(KINDS[kind].vehicle or KINDS[kind].one).tells("ego.kind")
        slots = {"goes": self._filled(self._my_way, self._my_form), "kind": named}
        return sentence(self._me.does, " ", self._filled(self._me.has, self._my_form, slots))

    def _ego(self) -> Words:
        ego, road = self.situation.ego, self.situation.road
        way = None if ego.route is None else ROUTES[ego.route]
        goes = {"goes": self._filled(self._my_way, self._my_form)}
        does = Words() if way is None else self._filled(way.does, self._my_form, goes).tells("ego.route")
        place = Words(ROADS[road.kind]).tells("road.kind") if road.kind is not None else Words()
        if way is not None and way.at is not None and way.at is road.kind:
            does, place = does.tells("road.kind"), Words()
        where = joined(filter(None, (place, _word("road.setting", road.setting, SETTINGS))), by=" ", last=" ")
        drives = self._filled(self._my_way, self._my_form)
        if ego.speed is not None:
            pace = self._pace(ego.speed, "ego.speed")
            if way is not None and way.paced:
                does = does + " " + pace
            else:
                does = drives + " " + pace + (" and " if does else "") + does
        elif not does and where:
            does = self._filled(_IS, self._my_form)
        return sentence(self._me.does, " ", does, " " if where else "", where) if does else Words()

    def _exit(self) -> Words:
        """By which exit the ego leaves a roundabout."""
        number = self.situation.ego.exit
        if number is None:
            return Words()
        takes = self._filled("[take/takes/taking] the ", self._my_form)
        return sentence(self._me.does, " ", takes, Words(f"{ordinal(number - 1)} exit").tells("ego.exit"))

    def _meeting(self, road: Road) -> Words:
        """How many roads meet, how large a roundabout is, and where a side road lies."""
        arms = Words() if road.arms is None else Words(f"{numeral(road.arms)} roads meet there").tells("road.arms")
        across = self._amount(road.diameter, "road.diameter")
        size = Words("it is ") + across + " across" if across else Words()
        side = Words() if road.side_road is None else Words("there is a side road on ") + self._me.own + " "
        side = side + Words(road.side_road).tells("road.side_road") if road.side_road is not None else side
        return sentence(joined(filter(None, (arms, size, side)), last=", and "))

    def _road(self) -> Iterator[Words]:
        road = self.situation.road
        yield self._meeting(road)
        control = _word("road.control", road.control, CONTROLS)
        light = _word("road.ego_light", road.ego_light, EGO_LIGHTS)
        whose = f", and {self._me.its} " if control else f"{self._me.own} traffic light "
        yield sentence(control, whose if light else "", light)
        yield self._lanes(road)
        is_so = {None: "", True: "is two-way", False: "is one-way"}[road.two_way]
        has: list[Words] = []
        if road.speed_limit is not None:
            has.append(Words("a speed limit of ") + self._amount(road.speed_limit, "road.speed_limit"))
        has += [_word(f"road.has.{i}", one, FEATURES) for i, one in enumerate(road.has)]
        holds = [Words(is_so).tells("road.two_way")] if is_so else []
        holds += [Words("has ") + joined(has)] if has else []
        if holds:
            yield sentence("the road ", joined(holds))

    def _lanes(self, road: Road) -> Words:
        lanes = lane = Words()
        if road.lanes is not None:
            many = f"{numeral(road.lanes)} lane{'s' * (road.lanes != 1)}"
            lanes = Words(f"there {'is' if road.lanes == 1 else 'are'} ") + Words(many).tells("road.lanes")
            lanes += f" in {self._me.own} direction"
        if road.ego_lane is not None:
            end = "out" if road.ego_lane > 0 else "in"
            rank = abs(road.ego_lane) - 1
            which = f"{ordinal(rank)} lane from the {end}side" if rank else f"{end}{'n' * (end == 'in')}ermost lane"
            lane = self._filled(f"{self._me.does} {_IS} in the ", self._my_form) + Words(which).tells("road.ego_lane")
        return sentence(joined(filter(None, (lanes, lane)), last=", and "))

    # Those others

    def _others(self) -> Iterator[Words]:
        if self.apart:
            yield from chain.from_iterable(self._introduced(one) for one in self.order)
        for one in self.order:
            if not self.apart:
                yield from self._introduced(one)
            yield from self._deeds(one.id, self._subject(one))

    def _introduced(self, one: Other) -> Iterator[Words]:
        at, form, starts = f"others.{one.id}", form_of(one), one.starts
        slots = {
            "side": _word(f"{at}.starts.side", starts.side, SIDES),
            "distance": self._amount(starts.distance, f"{at}.starts.distance"),
        }
        phrase = PLACES[starts.where]
        if backs(self.situation):
            phrase = phrase.replace(AHEAD, AWAY)
        place = self._filled(phrase, form, slots).tells(f"{at}.starts.where")
        asides = Words()
        if one.stretch is not None:
            asides += Words(", in a row ") + self._amount(one.stretch, f"{at}.stretch") + " long"
        if starts.facing is not None:
            asides += Words(", ") + self._filled(FACINGS[starts.facing], form).tells(f"{at}.starts.facing")
        asides += self._lateral(starts.lateral, form, f"{at}.starts.lateral")
        if one.hidden_by is not None:
            hidden = Words(f", at first hidden from {self._me.object} by {self.names[one.hidden_by]}")
            asides += hidden.tells(f"{at}.hidden_by")
        drives = Words()
        if starts.speed is not None and not one.does:
            drives = Words(", and " if "," in place.text + asides.text else " and ") + self._at_first(one)
        yield sentence(self._noun(one), " ", self._filled(_IS, form), " ", place, asides, drives)
        role = ROLES[one.role]
        if role is not None:
            yield sentence(self._subject(one), " ", self._filled(role, form).tells(f"{at}.role"))

    def _noun(self, one: Other) -> Words:
        """Somebody who was not named before."""
        at, noun, rank = f"others.{one.id}", KINDS[one.kind], self.rank[one.id]
        article, _, bare = noun.one.partition(" ")
        if one.count == 1:
            kind = Words(bare).tells(f"{at}.kind")
        else:
            many = "several" if one.count == SEVERAL else numeral(one.count)
            kind = Words(many).tells(f"{at}.count") + " " + Words(noun.many).tells(f"{at}.kind")
        if self.voice is Voice.PROTOCOL:
            return Words(f"{target_of(one)}, {article} " if one.count == 1 else f"{target_of(one)}, ") + kind + ","
        if one.count == 1:
            return Words(f"{with_article(ordinal(rank))} " if rank else f"{article} ") + kind
        return Words(f"{with_article(ordinal(rank))} group of ") + kind if rank else kind

    def _subject(self, one: Other) -> str:
        """Somebody who was named in the sentence before."""
        if self.voice is Voice.PROTOCOL or self.apart:
            return self.names[one.id]
        if one.hidden_by is None and one.count != 1:
            return "they"
        if one.hidden_by is None and not KINDS[one.kind].somebody:
            return "it"
        only_yet = not self.rank[one.id]  # others who are called so are told of later
        return f"the {called_of(one)}" if only_yet else self.names[one.id]

    def _at_first(self, one: Other) -> Words:
        """The speed at which somebody starts."""
        drives = self._filled(KINDS[one.kind].goes, form_of(one))
        return drives + " " + self._pace(one.starts.speed, f"others.{one.id}.starts.speed")

    # What is done

    def _deeds(self, who: str, subject: str) -> Iterator[Words]:
        clauses = [self._deed(who, i, deed) for i, deed in enumerate(self.situation.does(who))]
        if clauses and who != EGO and self.situation[who].starts.speed is not None:
            clauses.insert(0, self._at_first(self.situation[who]))
        for i in range(0, len(clauses), _A_SENTENCE):
            lead = f"after that, {subject} " if i else f"{subject} "
            yield sentence(Words(lead), joined(clauses[i : i + _A_SENTENCE], last=", then "))

    def _deed(self, who: str, i: int, deed: Deed) -> Words:
        at = f"ego.does.{i}" if who == EGO else f"others.{who}.does.{i}"
        doing, form = ACTS[deed.act], self._form_of(who)
        slots: dict[str, Words] = {
            "goes": self._goes(who, form),
            "whom": self._whom(who, deed, f"{at}.whom"),
            "to": _word(f"{at}.to", deed.to, SIDES),
            "pace": self._pace(deed.speed, f"{at}.speed"),
            "speed": self._amount(deed.speed, f"{at}.speed"),
            "acceleration": self._amount(deed.acceleration, f"{at}.acceleration"),
            "distance": self._amount(deed.distance, f"{at}.distance"),
            "time": self._amount(deed.time, f"{at}.time"),
            "breaks": _word(f"{at}.breaks", deed.breaks, BREACHES),
        }
        made = _in_a_manner(self._filled(doing.does, form, slots).tells(f"{at}.act"), deed.manner, f"{at}.manner")
        whom = doing.whom if deed.act.row.whom else doing.whom or " for {whom}"
        for phrase in (
            doing.to, whom, doing.speed, doing.acceleration, doing.distance, doing.time, " {breaks}",
        ):  # fmt: skip
            made += self._filled(f"<{phrase}>", form, slots)
        return made + self._lateral(deed.lateral, form, f"{at}.lateral") + self._when(who, deed.when, f"{at}.when")

    def _lateral(self, lateral: Lateral | None, form: Form, at: str) -> Words:
        """Where across the road somebody is."""
        if lateral is None:
            return Words()
        amounts = {
            "offset": lateral.offset, "edge": lateral.edge, "overlap": lateral.overlap, "clearance": lateral.clearance,
            "beyond": lateral.beyond,
        }  # fmt: skip
        slots = {name: self._amount(one, f"{at}.{name}") for name, one in amounts.items()}
        slots["side"] = _word(f"{at}.side", lateral.side, SIDES)
        *numbers, sideways = LATERAL_PHRASES
        said = next((one for one in numbers if slots[one.partition("{")[2].partition("}")[0]]), sideways)
        return Words(", ") + self._filled(said, form, slots)

    def _when(self, who: str, when: When | None, at: str) -> Words:
        if when is None:
            return Words()
        said: list[Words] = []
        later = self._amount(when.delay, f"{at}.delay")
        if later and when.after is None and when.during is None:
            said.append(later + " later")
        if when.after is not None:
            after = Words(f"after {self._reference(who, when.after, lasting=False)}").tells(f"{at}.after")
            said.append(later + " " + after if later else after)
        if when.during is not None:
            since = f"from when {self._reference(who, when.during, lasting=True)}"
            since = since if later else f"while {self._reference(who, when.during, lasting=True)}"
            during = Words(since).tells(f"{at}.during")
            said.append(later + " " + during if later and when.after is None else during)
        if when.ego_within is not None:
            near = self._filled(f"when {self._me.does} {_IS} ", self._my_form) + self._amount(when.ego_within) + " away"
            far = Words(f" from {self.names[when.of]}").tells(f"{at}.of") if when.of is not None else Words()
            said.append(near.tells(f"{at}.ego_within") + far)
        return Words(" ") + joined(said) if said else Words()

    def _reference(self, who: str, reference: str, *, lasting: bool) -> str:
        """A deed, as another waits for it."""
        whose = reference.partition(".")[0]
        deed, deeds = self.situation.deed(reference), self.situation.does(whose)
        if whose == EGO:
            subject = self._me.does
        else:
            subject = self._subject(self.situation[whose]) if whose == who else self.names[whose]
        form = self._form_of(whose)
        verb = Form.ING if lasting else form
        slots = {"goes": self._goes(whose, verb), "whom": self._whom(whose, deed)}
        does = self._filled(ACTS[deed.act].does, verb, slots)
        alike = [one for one in deeds if one.act is deed.act]
        which = f" for the {ordinal(next(i for i, one in enumerate(alike) if one is deed))} time"
        being = f"{self._filled(_IS, form).text} " if lasting else ""
        return f"{subject} {being}{does.text}{which if len(alike) > 1 else ''}"

    def _whom(self, who: str, deed: Deed, *paths: str) -> Words:
        """Whom a deed is done to, who is the ego where nobody is named."""
        if deed.whom is None and not deed.act.row.whom:
            return Words()
        if deed.whom is None:
            return Words("somebody" if who == EGO else self._me.object)
        if deed.whom == who:
            name = self._me.itself if who == EGO else "themselves" if self._form_of(who) is Form.SEVERAL else "itself"
        else:
            name = self._me.object if deed.whom == EGO else self.names[deed.whom]
        return Words(name).tells(*paths)

    def _goes(self, who: str, form: Form) -> Words:
        return self._filled(self._my_way if who == EGO else KINDS[self.situation[who].kind].goes, form)

    def _form_of(self, who: str) -> Form:
        return self._my_form if who == EGO else form_of(self.situation[who])

    # How it ends, and what is about

    def _contact(self) -> Words:
        contact = self.situation.contact
        if contact is None:
            return Words()
        other, form = self._touched(contact)
        none = "" if contact.happens else "there is no contact"
        if none and contact.striker is contact.ego is contact.other is contact.at is None:
            of_it = Words(" with ") + other if contact.whom is not None else Words()
            return sentence(Words(none).tells("contact.happens"), of_it)
        mine, its = (_word(f"contact.{one}", getattr(contact, one), PARTS) for one in ("ego", "other"))
        ends = Words(f", but {none}").tells("contact.happens") if none else Words()
        if contact.at is not None:
            point = Words()
            if contact.behind_nose is not None:
                behind = self._amount(contact.behind_nose, "contact.behind_nose")
                point = Words(" with a point ") + behind + " of its length behind its nose"
            ends = Words(", at ") + self._amount(contact.at, "contact.at") + f" of {self._me.own} width" + point + ends
        by_other = contact.striker is Striker.OTHER
        form = form if by_other else self._my_form
        verb = self._filled(STRIKERS[contact.striker], form if contact.happens else Form.WOULD)
        my_own = Words(f"{self._me.own} ") + mine
        if by_other:
            who, whom = other, my_own if mine else Words(self._me.object)
            by = Words(" with the ") + its if its else Words()
        else:
            who, whom = Words(self._me.does), Words("the ") + its + " of " + other if its else other
            by = Words(" with ") + my_own if mine else Words()
        if contact.striker is not None:
            verb = verb.tells("contact.striker")
        return sentence(who, " ", verb, " ", whom, by, ends)

    def _touched(self, contact: Contact) -> tuple[Words, Form]:
        """Whom the ego touches, who is the first adversary where nobody is named."""
        if contact.whom is not None:
            return Words(self.names[contact.whom]).tells("contact.whom"), self._form_of(contact.whom)
        for one in self.situation.adversaries[:1]:
            return Words(self.names[one.id]), form_of(one)
        return Words("somebody"), Form.ONE

    def _around(self) -> Words:
        around = self.situation.around
        return sentence(
            joined(
                filter(
                    None,
                    (
                        _word("around.light", around.light, LIGHTS),
                        _word("around.weather", around.weather, WEATHERS),
                        _word("around.surface", around.surface, SURFACES),
                    ),
                )
            )
        )

    # Amounts and slots

    def _filled(self, phrase: str, form: Form, slots: Mapping[str, Words] | None = None) -> Words:
        return filled(phrase, form, {"ego": Words(self._me.object), "egos": Words(self._me.own), **(slots or {})})

    def _amount(self, amount: Amount | None, *paths: str) -> Words:
        """An amount as it was said: *20 m*, *20 m or more*, *20 m more than us*; nothing of none."""
        if amount is None:
            return Words()
        said = str(amount)
        if bound := _BOUNDS.fullmatch(said):
            said = f"{bound['amount']} or {'less' if bound['which'] == 'most' else 'more'}"
        return Words(_THAN.sub(rf" \g<more> than {self._me.object}", said)).tells(*paths)

    def _pace(self, speed: Amount | None, path: str) -> Words:
        """A speed at which somebody moves: *at 50 km/h*, *20 km/h faster than us*; nothing of none."""
        if speed is None:
            return Words()
        said = str(speed)
        if than := _THAN.search(said):
            return Words(f"{said[: than.start()]} {_FASTER[than['more']]} than {self._me.object}").tells(path)
        return (Words("at ") + self._amount(speed)).tells(path)


def _word(path: str, word: W | None, phrases: Mapping[W, str]) -> Words:
    """The phrase of a word; nothing of what was not said."""
    return Words() if word is None else Words(phrases[word]).tells(path)


def _in_a_manner(does: Words, manner: Manner | None, path: str) -> Words:
    """What is done, and how."""
    if manner is None:
        return does
    before, after = (Words(part).tells(*[path] * bool(part)) for part in MANNERS[manner].split("{does}"))
    return before + does + after
