#: description = "The adversary stands parked at the right kerb, close in front of the ego."
#: rephrasings = [
#:   "Parked only a few metres ahead, on the right.",
#:   "right next to our front wing there's one parked on the right",
#:   "parked veh, right kerb, < 20 m",
#:   "Vehicle 2 was parked along the right curb immediately ahead of Vehicle 1.",
#:   "The target is at rest at the nearside edge of the carriageway, a short distance from the VUT.",
#:   "It stays stopped on right side, very near to the ego.",
#: ]
#: adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "egoRoute", "kerbLane"]
#: provides = ["AdvAgent", "advKerb", "advRoom"]
#: origin = "own code"
#: [slots]
#: side = "right"
#: position = "kerb"
#: distance = "near"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 9.5
#: high = 15.0
#: unit = "m"
#: meaning = "how far ahead of the ego it stands"

param OPT_GEO_Y = Range(9.5, 15)

advKerb = kerbLane.offset(kerbLane.project(*besideRoad(egoRoute, 20, "right", 1.3).coordinates[:2])[1])
advRoom = 12  # [m], free behind it along the kerb
AdvAgent = new AdvClass at pointOn(advKerb, globalParameters.OPT_GEO_Y),
    facing directionOn(advKerb, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
