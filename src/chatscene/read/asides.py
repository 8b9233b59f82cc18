"""What people say beside an edit: courtesy, hedges, what they think of it, and why they want it.

None of it names a fact. Words of the first sort are passed over wherever they stand; why somebody wants something and
what he thinks of it are clauses of their own, which are left out only where they cannot be read, and are listed.
"""

from __future__ import annotations

import re

_SPEAKER = r"(?:we|us|you)"  # in canonical form, whoever says it and whoever is told
_SOFTLY = r"(?:(?:please|just|maybe|perhaps|also|possibly|kindly|now|instead|rather|really|still|only) )*"
_HOW = r"(?:(?:so|much|even|far|way|a lot|a (?:little )?bit|a little|more|less|most|the most|too|really|very|quite|pretty|rather|just|kind of|all|only|not|even) )*"
_OPINION = (
    r"(?:dangerous|risk(?:y|ier)|scar(?:y|ier)|nast(?:y|ier)|boring|eas(?:y|ier|ily)|gentle|difficult|trick(?:y|ier)|tough(?:er)?|"
    r"interesting|exciting|dramatic|realistic|fun|funn(?:y|ier)|cool(?:er)?|nicer?|good|better|best|great|awesome|lovely|amazing|perfect|fine|"
    r"ideal|bad|worse|worst|wrong|okay?|terrible|awful|horrible|annoying|challenging|demanding|critical|safer?|likely|unlikely|plausible|"
    r"typical|common|rare|possible|impossible|feasible|useful|helpful|kind|grateful|happy|glad|pleased|appreciated|welcome|classic|"
    r"unfair|mean|silly|stupid|crazy|sweet|a (?:danger|problem|challenge|shame|pity|surprise))"
)
_WANTED = r"(?:see|have|try|do|get|use|look at|ask for|go with|go for|make it so(?: that)?|say|request|suggest|change it so(?: that)?)"

COURTESY = "|".join(
    (
        # Frames of wishes, which end where the wish begins
        rf"(?:could|can|may|might|would|shall|should|will) {_SPEAKER} {_SOFTLY}(?:{_WANTED}|mind(?: if| to)?|like(?: to(?: {_WANTED})?)?|let(?= us have))",
        rf"(?:could|can|may|might|would|shall|will) {_SPEAKER}(?= (?:{_SOFTLY})?(?:make|let|add|put|swap|replace|remove|change|turn it|set|take|drop|give|place|move|start|switch|have|mirror|flip)\b)",
        rf"{_SPEAKER} (?:do not |would |will |should |might |can |could |have to |just |really |also |only )*(?:think|guess|say|said|mean|meant|wonder|wish|hope|suppose|believe|reckon|feel|imagine|know|bet|like|love|prefer|rather|want|wanted|need|expect|forgot|misremembered|misspoke|mind|ask|see|care|appreciate|suggest|propose)(?: it)?(?: that| if| whether| for)?(?: to (?:{_WANTED}))?(?: it)?(?: if| that)?",
        rf"(?:is|would|will|was) (?:it|that|this|there) (?:also |even |not )?be (?:{_HOW}{_OPINION}|a way|any chance)(?: if| to| for| that| of)?(?: {_WANTED})?",
        rf"is (?:it|that|this|there) (?:also |even |not )?(?:{_HOW}{_OPINION}|a way|any chance|a version|one|a variant|an option)(?: if| to| for| that| of| with)?(?: {_WANTED})?",
        rf"(?:(?:it|that|this|he|she|they|which|there) )?(?:would|will|might|could|may)(?: also| only| even| just| probably| certainly)* be {_HOW}(?:{_OPINION}|harder)(?: for \w+)?(?: to (?:react|see|notice|avoid|handle|stop|brake|spot|deal with|have|do|{_WANTED}))?(?: if| when| to)?",
        rf"if (?:it is |that is |at all )?(?:not )?(?:too much (?:trouble|to ask)|{_HOW}{_OPINION})(?: with us| for us)?",
        rf"if {_SPEAKER} (?:do not mind|like|please|want(?: to)?|can|could|would|may|so wish|will)",
        r"(?:let )?be so (?:kind|good|nice)(?: as)?(?: to)?|be (?:kind|good|nice) enough(?: to)?",
        r"(?:do|does|would|will|could) (?:it|that|this) (?:also |still )?(?:work|make sense)(?: with| as| if| in)?",
        r"(?:what|how) (?:would|will|does|do|could) (?:it|that|this|things) (?:look|be|go|happen)(?: like)?(?: if| with)?|what (?:would )?(?:happens? )?if(?: instead)?|(?:what|how) about|any chance (?:of|that|for)|why (?:not|do not we|(?:do|does|did|should)(?= (?:we|it|he|she|they)\b))|and if|as if(?= it)|only if",
        rf"sorry(?: to (?:bother|trouble) {_SPEAKER})?(?: again)?|(?:thank you|thanks|cheers)(?: (?:very|so) much| a lot)?|excuse us|pardon(?: us)?|my mistake|our mistake|if possible|whenever possible|for (?:us|me)|by the way",
        rf"to (?:be|make (?:it|this|things)|keep it) {_HOW}{_OPINION}|for (?:a change|fun|realism|good measure|once|variety)",
        r"(?:give|show) us|when (?:it|this|that|everything|the scene) (?:begins?|began|starts?|started)",
        # Particles
        r"oh|ooh|ah|aha|er|erm|uh|um|hm+|hmm+|yeah|yep|yup|yes|nah|nope|lol|haha|hehe|wow|yikes|ouch|oops|whoops|man|dude|guys|come on|ok(?:ay)?|alright|all right(?=,| )|right(?=, )|well|hey|hi|hello|dear|"
        r"actually|basically|honestly|frankly|literally|obviously|apparently|maybe|perhaps|possibly|probably|somehow|anyway|anyhow|of course|indeed|really|definitely|certainly|sure|surely|"
        r"like(?=[ ,])|(?:we|you) know|kind of|sort of|or so|or something|or whatever|whatever|and (?:so|stuff)|(?:might|may|could|can) (?:just )?as well(?: be)?|on second thou?ghts?|for example|for instance|such as|say|"
        r"correction|wrong|the wrong|misremembered|please|kindly|thing|stuff",
    )
)
"""Words of courtesy and hedges, which name nothing."""

WORSE_THAN = rf"(?:(?:(?:would|will|might|could) be|is|are) )?{_HOW}{_OPINION} than"
"""Before what is to go: a lorry "would be worse than a car"."""

# Clauses

_WHY = r"(?:because|since|given that|seeing (?:as|that)|considering|as if|as though|otherwise|so as to|in order to|like (?:it|he|she|they)|or else)"
_PART = re.compile(
    rf"[,;.]\s+|\s+(?=(?:{_WHY})\b)|(?<!,) (?=so (?:let|make|put|use|add|have|do|give|remove|try|slow|set|it should|we)\b)"
)
_REASON = re.compile(
    rf"(?:and |but |just )?(?:{_WHY}\b|as (?:it|he|she|they|that|this|those|there|we|the|a)\b|if\b.*\bwould\b)"
)
_SO = re.compile(r"(?:and )?so\b(?! that)")
_OF_ALL = r"(?:nobody|no one|everybody|everyone|people|hardly|usually|normally|generally|often|seldom|rarely|typically|these days)"
_COMMENT = re.compile(rf"\b(?:(?<=\w )too (?!and\b|but\b)\w+|{_OF_ALL}|{_OPINION}|harder (?:to|for))(?![\w'])")
_EXCLAIMED = re.compile(r"(?:what an?|such an?|how) (?:\w+ )?\w+$")
_WISH = re.compile(
    r"(?:and |then |but |now |just |please )*(?:make|let|have|use|put|set|add|give|take|drop|remove|replace)\b"
)


def without_comments(text: str) -> tuple[str, tuple[str, ...]]:
    """An edit in canonical form without the clauses that only say why, or what somebody thinks of it; and these."""
    clauses = [one.strip() for one in _PART.split(text) if one.strip()]
    kept: list[str] = []
    comments: list[str] = []
    for clause, following in zip(clauses, [*clauses[1:], ""], strict=True):
        told = _REASON.match(clause) or _SO.match(following) or _COMMENT.search(clause) or _EXCLAIMED.match(clause)
        (comments if told and not _WISH.match(clause) else kept).append(clause)
    return ", ".join(kept), tuple(comments)
