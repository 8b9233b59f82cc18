#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: side = "left"
#: position = "kerb"
#: [variants]
#: kerb-left      = { y = [16, 30] }
#: kerb-left-far  = { y = [38, 58], maneuver = "straight", place = "road", distance = "far" }
#: kerb-left-near = { y = [9.5, 15], distance = "near", adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"] }
#: [descriptions]
#: kerb-left      = "The adversary stands parked at the left kerb, across the oncoming lane, facing the way the ego drives."
#: kerb-left-far  = "The adversary stands parked at the left kerb, far ahead of the ego."
#: kerb-left-near = "The adversary stands parked at the left kerb, close in front of the ego."

param OPT_GEO_Y = Range$y  #: [m] how far ahead of the ego it stands

advKerb = kerbLane.offset(kerbLane.project(*pointOn(oppositeLane, levelOn(oppositeLane, egoRoute, 20), -2.1).coordinates[:2])[1])
AdvAgent = new AdvClass at pointOn(advKerb, globalParameters.OPT_GEO_Y),
    facing directionOn(advKerb, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
