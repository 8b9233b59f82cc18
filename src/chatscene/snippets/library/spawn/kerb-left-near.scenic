#: description = "The adversary stands parked at the left kerb, close in front of the ego."
#: rephrasings = [
#:   "Parked only a few metres ahead, on the left.",
#:   "right next to our front wing there's one parked on the left",
#:   "parked veh, left kerb, < 20 m",
#:   "Vehicle 2 was parked along the left curb immediately ahead of Vehicle 1.",
#:   "The target is at rest at the offside edge of the carriageway, a short distance from the VUT.",
#:   "It stays stopped on left side, very near to the ego.",
#: ]
#: adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "egoRoute", "kerbLane", "oppositeLane"]
#: provides = ["AdvAgent", "advKerb"]
#: origin = "own code"
#: [slots]
#: side = "left"
#: position = "kerb"
#: distance = "near"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 9.5
#: high = 15.0
#: unit = "m"
#: meaning = "how far ahead of the ego it stands"

param OPT_GEO_Y = Range(9.5, 15)

advKerb = kerbLane.offset(kerbLane.project(*pointOn(oppositeLane, levelOn(oppositeLane, egoRoute, 20), -2.1).coordinates[:2])[1])
AdvAgent = new AdvClass at pointOn(advKerb, globalParameters.OPT_GEO_Y),
    facing directionOn(advKerb, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
