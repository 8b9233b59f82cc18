#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: side = "right"
#: position = "kerb"
#: [variants]
#: kerb-right        = { y = [16, 30] }
#: kerb-right-far    = { y = [38, 58], maneuver = "straight", place = "road", distance = "far" }
#: kerb-right-near   = { y = [9.5, 15], distance = "near", adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"] }
#: kerb-right-in-row = { y = [20, 34], place = "road", occluder = "parked-car", adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"] }
#: [descriptions]
#: kerb-right        = "The adversary stands parked at the right kerb ahead of the ego."
#: kerb-right-far    = "The adversary stands parked at the right kerb, far ahead of the ego."
#: kerb-right-near   = "The adversary stands parked at the right kerb, close in front of the ego."
#: kerb-right-in-row = "The adversary stands at the right kerb behind another parked car."

param OPT_GEO_Y = Range$y  #: [m] how far ahead of the ego it stands

advKerb = kerbLane.offset(kerbLane.project(*besideRoad(egoRoute, 20, "right", 1.3).coordinates[:2])[1])
advRoom = 12  # [m], free behind it along the kerb  #: unless occluder
AdvAgent = new AdvClass at pointOn(advKerb, globalParameters.OPT_GEO_Y),
    facing directionOn(advKerb, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
new Car at pointOn(advKerb, globalParameters.OPT_GEO_Y - 8.2),  #: if occluder
    facing directionOn(advKerb, globalParameters.OPT_GEO_Y - 8.2),  #: if occluder
    with label "parked-car"  #: if occluder
