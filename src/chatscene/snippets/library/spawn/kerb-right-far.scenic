#: description = "The adversary stands parked at the right kerb, far ahead of the ego."
#: rephrasings = [
#:   "Parked a long way down the street on the right.",
#:   "much further up there's one parked on the right",
#:   "parked veh, right kerb, > 35 m",
#:   "Vehicle 2 was parked along the right curb well ahead of Vehicle 1.",
#:   "The target is at rest at the nearside edge of the carriageway, a large distance from the VUT.",
#:   "It stays stopped on right side, far from the ego.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "egoRoute", "kerbLane"]
#: provides = ["AdvAgent", "advKerb", "advRoom"]
#: origin = "own code"
#: [slots]
#: side = "right"
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

advKerb = kerbLane.offset(kerbLane.project(*besideRoad(egoRoute, 20, "right", 1.3).coordinates[:2])[1])
advRoom = 12  # [m], free behind it along the kerb
AdvAgent = new AdvClass at pointOn(advKerb, globalParameters.OPT_GEO_Y),
    facing directionOn(advKerb, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
