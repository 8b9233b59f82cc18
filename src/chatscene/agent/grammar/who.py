"""How people name road users.

Written by us, after the way crash reports, test protocols, driving schools and people at the kitchen table speak.
"""

from __future__ import annotations

from chatscene.agent.grammar.inflection import listed
from chatscene.terms.scenario import AdversaryKind

# After a colon stands the pronoun, where it is not the kind's usual one.

NOUNS: dict[AdversaryKind, tuple[str, ...]] = {
    AdversaryKind.PEDESTRIAN: listed(
        """pedestrian | pedestrian | pedestrian | child | kid | man:he | woman:she | boy:he | girl:she | jogger
        runner | old man:he | elderly woman:she | young man:he | teenager | student | walker | passer-by
        schoolchild | person | tourist | old lady:she | man with a suitcase:he | woman with a pram:she
        person on foot | dog walker | little girl:she | schoolboy:he"""
    ),
    AdversaryKind.BICYCLE: listed(
        """cyclist | cyclist | cyclist | bicycle:it | bicyclist | bike rider | e-bike rider | bike:it | cargo bike:it
        boy on a bike:he | woman on a bicycle:she | bike courier | cycle courier | man on a bicycle:he
        racing cyclist | young cyclist | child on a bike | e-bike:it | delivery cyclist"""
    ),
    AdversaryKind.MOTORCYCLE: listed(
        """motorcyclist | motorcyclist | motorcycle:it | motorcycle:it | motorbike:it | biker | moped:it | scooter:it
        scooter rider | motor scooter:it | motorcycle courier | moped rider | rider on a motorbike
        motorbike rider | man on a scooter:he | woman on a motorcycle:she"""
    ),
    AdversaryKind.CAR: listed(
        """car | car | car | car | sedan | SUV | van | taxi | hatchback | estate car | minivan | cab | convertible
        sports car | station wagon | vehicle | delivery van | limousine | jeep | family car | small car
        rental car"""
    ),
    AdversaryKind.TRUCK: listed(
        """truck | truck | lorry | HGV | semi-trailer truck | tractor-trailer | delivery truck | dump truck
        box truck | articulated lorry | tipper truck | garbage truck | refuse lorry | heavy goods vehicle
        flatbed truck | tanker truck | removal lorry"""
    ),
    AdversaryKind.BUS: listed(
        """bus | bus | bus | city bus | coach | school bus | double-decker bus | tour bus | articulated bus
        shuttle bus | night bus | tourist coach | commuter bus"""
    ),
    AdversaryKind.EMERGENCY_VEHICLE: listed(
        """ambulance | ambulance | police car | fire engine | fire truck | patrol car | squad car | emergency vehicle
        rescue vehicle | police van | ambulance on an emergency call | police car with its siren on
        fire engine with flashing lights | emergency ambulance"""
    ),
}
UNNAMED = listed("road user | traffic participant | other party in traffic")
COLOURS = listed("white | black | silver | blue | dark | grey | yellow | green")
GROUPS = listed(
    """two {many} | two {many} | a group of {many} | several {many} | a couple of {many} | three {many}
    a pair of {many} | a handful of {many} | a number of {many} | some {many}"""
)
