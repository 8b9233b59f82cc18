#: description = "The adversary is positioned ahead on the right, at the kerb of the ego's approach."
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: origin = "base scenario right-turn; own code"
#: [slots]
#: side = "right"
#: position = "ahead-beside"
#: maneuver = "right-turn"

param OPT_GEO_Y = Range(8, 20)  #: [m] how far ahead of the ego it starts
param OPT_GEO_X = Range(2.1, 2.6)  #: [m] how far to the right of the ego's line it starts

advTrajectory = egoRoute
AdvAgent = new AdvClass at pointOn(egoRoute, globalParameters.OPT_GEO_Y, -globalParameters.OPT_GEO_X),
    facing directionOn(egoRoute, globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
