#: description = "The adversary is positioned behind on the right, between the ego and the kerb."
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: origin = "base scenario right-turn; own code"
#: [slots]
#: side = "right"
#: position = "behind-beside"
#: maneuver = "right-turn"

param OPT_GEO_Y = Range(6, 14)  #: [m] how far behind the ego it starts
param OPT_GEO_X = Range(2.1, 2.6)  #: [m] how far to the right of the ego's line it drives

advTrajectory = extended(egoRoute, 20).offset(-2.3)
AdvAgent = new AdvClass at pointOn(extended(egoRoute, 20), 20 - globalParameters.OPT_GEO_Y, -globalParameters.OPT_GEO_X),
    facing directionOn(extended(egoRoute, 20), 20 - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
