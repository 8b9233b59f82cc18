#: description = "The adversary stands parked at the left kerb, far ahead of the ego."
#: rephrasings = [
#:   "Parked a long way down the street on the left.",
#:   "much further up there's one parked on the left",
#:   "parked veh, left kerb, > 35 m",
#:   "Vehicle 2 was parked along the left curb well ahead of Vehicle 1.",
#:   "The target is at rest at the offside edge of the carriageway, a large distance from the VUT.",
#:   "It stays stopped on left side, far from the ego.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "egoRoute", "kerbLane", "oppositeLane"]
#: provides = ["AdvAgent", "advKerb"]
#: origin = "own code"
#: [slots]
#: side = "left"
#: position = "kerb"
#: distance = "far"
#: place = "road"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 38.0
#: high = 58.0
#: unit = "m"
#: meaning = "how far ahead of the ego it stands"

param OPT_GEO_Y = Range(38, 58)

advKerb = kerbLane.offset(kerbLane.project(*pointOn(oppositeLane, levelOn(oppositeLane, egoRoute, 20), -2.1).coordinates[:2])[1])
AdvAgent = new AdvClass at pointOn(advKerb, globalParameters.OPT_GEO_Y),
    facing directionOn(advKerb, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
