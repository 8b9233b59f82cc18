#: description = "The adversary is ahead of the ego in its lane, at the line before the intersection."
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"]
#: origin = "NHTSA pre-crash typology: lead vehicle stopped"
#: [slots]
#: position = "ahead"
#: place = "junction"

param OPT_GEO_Y = Range(3, 9)  #: [m] how far before the intersection it starts

advTrajectory = egoRoute
AdvAgent = new AdvClass at pointOn(advTrajectory, egoRoute.eventAt - globalParameters.OPT_GEO_Y),
    facing directionOn(advTrajectory, egoRoute.eventAt - globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
