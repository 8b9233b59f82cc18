#: description = "The adversary stands parked at the left kerb, on the far side of the road, facing the ego."
#: rephrasings = [
#:   "Parked across the street on its own side, nose toward the ego.",
#:   "there's one parked over the road, pointing at us",
#:   "parked veh, far kerb, opposing direction",
#:   "Vehicle 2 was legally parked along the opposite curb, facing Vehicle 1.",
#:   "The target is at rest at the edge of the opposing lane, oriented toward the VUT.",
#:   "It stays stopped on the other side of the street and looks to the ego.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "kerbLane", "oppositeLane"]
#: provides = ["AdvAgent", "advKerb"]
#: origin = "own code"
#: [slots]
#: side = "left"
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 20.0
#: high = 40.0
#: unit = "m"
#: meaning = "how far ahead of the ego it stands"

param OPT_GEO_Y = Range(20, 40)

advKerb = oppositeLane.offset(-2.1)
AdvAgent = new AdvClass at pointOn(kerbLane, globalParameters.OPT_GEO_Y, 5.6),
    facing directionOn(kerbLane, globalParameters.OPT_GEO_Y, 3.14159),
    with behavior AdvBehavior()
