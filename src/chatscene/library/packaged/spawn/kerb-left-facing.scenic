#: description = "The adversary stands parked at the left kerb, on the far side of the road, facing the ego."
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: side = "left"
#: position = "kerb"

param OPT_GEO_Y = Range(20, 40)  #: [m] how far ahead of the ego it stands

advKerb = oppositeLane.offset(-2.1)
AdvAgent = new AdvClass at pointOn(kerbLane, globalParameters.OPT_GEO_Y, 5.6),
    facing directionOn(kerbLane, globalParameters.OPT_GEO_Y, 3.14159),
    with behavior AdvBehavior()
