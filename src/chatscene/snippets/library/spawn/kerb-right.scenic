#: description = "The adversary stands parked at the right kerb ahead of the ego."
#: rephrasings = [
#:   "A vehicle is parked on our side of the street a bit further on.",
#:   "Stationary at the right-hand edge of the carriageway, in front of the ego.",
#:   "parked veh, right kerb, ahead",
#:   "Vehicle 2 was legally parked along the right curb.",
#:   "It waits at the side of the road to the right, like a taxi or a delivery van that has just dropped something off.",
#:   "The target is positioned at rest beside the VUT's lane, on the nearside shoulder.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "egoRoute", "kerbLane"]
#: provides = ["AdvAgent", "advKerb", "advRoom"]
#: origin = "own code"
#: [slots]
#: side = "right"
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 16.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far ahead of the ego it stands"

param OPT_GEO_Y = Range(16, 30)

advKerb = kerbLane.offset(kerbLane.project(*besideRoad(egoRoute, 20, "right", 1.3).coordinates[:2])[1])
advRoom = 12  # [m], free behind it along the kerb
AdvAgent = new AdvClass at pointOn(advKerb, globalParameters.OPT_GEO_Y),
    facing directionOn(advKerb, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
