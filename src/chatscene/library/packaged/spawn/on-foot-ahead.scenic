#: description = "The adversary is on foot ahead of the ego in its lane, a little to the right, and faces the same way."
#: adversaries = ["pedestrian"]
#: origin = "Euro NCAP CPLA: a pedestrian ahead who walks along the lane"
#: [slots]
#: position = "ahead"

param OPT_GEO_Y = Range(24, 44)  #: [m] how far ahead of the ego it starts
param OPT_GEO_X = Range(0.2, 1.1)  #: [m] how far to the right of the ego's line it starts

AdvAgent = new AdvClass at pointOn(egoRoute, globalParameters.OPT_GEO_Y, -globalParameters.OPT_GEO_X),
    facing directionOn(egoRoute, globalParameters.OPT_GEO_Y, advAlong),
    with behavior AdvBehavior()
