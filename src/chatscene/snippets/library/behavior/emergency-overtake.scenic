#: description = "The emergency vehicle races past the ego in the next lane on its call."
#: rephrasings = [
#:   "An ambulance with lights and siren rushes past us.",
#:   "The fire apparatus, responding to an emergency, passed vehicle 1 at high speed.",
#:   "EMS vehicle code 3, overtakes fast.",
#:   "The emergency vehicle overtakes the VUT at high relative speed in the adjacent lane.",
#:   "A police car with the blue light goes very quick beside us.",
#:   "A wailing fire engine storms by in the other lane.",
#:   "The paramedics hurtle up from the rear and are past.",
#:   "Siren in the mirror, whoosh, blue flashes ahead.",
#:   "An ambulance came belting past in the next lane, blues and twos going.",
#:   "A marked patrol unit responding Code 3 passed Unit 1 in the adjacent lane at high speed.",
#:   "Fire engine on shout, adj lane, flies by ego. Straight line.",
#:   "The emergency vehicle target, with warning devices active, passes the VUT in the adjacent lane at substantially higher speed.",
#:   "Police car with siren goes very fast by me on the other lane.",
#:   "EV on call blasts by one lane over, no lane change, no weaving; check siren handling.",
#:   "The siren rose behind her and then it was there beside her window and gone, hurtling on to somebody else's trouble.",
#:   "Ambulance coming through on your side, running hot, hold your lane and let it fly by.",
#:   "ambulance went past me sooo fast in the other lane, siren n everything",
#:   "A fire appliance answering a 999 call hurtled past traffic in the neighbouring lane.",
#:   "The police vehicle, its siren sounding, went by my client in the lane alongside at considerable speed, yes?",
#:   "Ambulance with siren went zooming in the next lane, all the way past me.",
#:   "Bluelights in the next lane, nee-naw, nee-naw, whoosh, gone before I could pull over.",
#:   "High-speed passing by responding emergency vehicle in adjacent lane.",
#:   "FIRE TRUCK FLIES PAST ON A CALL",
#:   "A police car streaked by in the lane alongside, siren wailing.",
#: ]
#: adversaries = ["emergency-vehicle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "fast"]
#: position = "behind-beside"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 10.0
#: high = 36.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 13.0
#: high = 17.0
#: unit = "m/s"
#: meaning = "how fast it overtakes"

param OPT_ADV_DISTANCE = Range(10, 36)
param OPT_ADV_SPEED = Range(13, 17)

behavior AdvBehavior():
    do KeepStation(advLane, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advLane, 1, 0, globalParameters.OPT_ADV_SPEED)
