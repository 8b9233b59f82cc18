#: origin = "own code"
#: [variants]
#: standing-ahead              = { position = "ahead", y = [34, 54], adversaries = ["box"] }
#: standing-ahead-group        = { position = "ahead", y = [34, 54], group = true, across = true, adversaries = ["box"] }
#: standing-ahead-row          = { position = "ahead", y = [34, 54], group = true, row = true, adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"] }
#: standing-edge-left          = { position = "ahead", side = "left", along = "edge", y = [34, 54], x = [0.9, 1.6], adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"] }
#: standing-edge-right         = { position = "ahead", side = "right", along = "edge", y = [34, 54], x = [-1.6, -0.9], adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"] }
#: standing-in-first-lane      = { position = "ahead", place = "road", along = "left", y = [8, 22], adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle", "box"] }
#: standing-in-first-lane-group = { position = "ahead", place = "road", along = "left", y = [8, 22], group = true, across = true, adversaries = ["box"] }
#: standing-in-first-lane-row  = { position = "ahead", place = "road", along = "left", y = [8, 22], group = true, row = true, adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle"] }
#: standing-round-corner       = { position = "beyond", place = "junction", along = "corner", y = [6, 16], adversaries = ["car", "truck", "bus", "motorcycle", "bicycle", "emergency-vehicle", "box"] }
#: standing-round-corner-group = { position = "beyond", place = "junction", along = "corner", y = [6, 16], group = true, across = true, adversaries = ["box"] }
#: standing-round-corner-row   = { position = "beyond", place = "junction", along = "corner", y = [6, 16], group = true, row = true, adversaries = ["car", "truck", "motorcycle", "bicycle", "emergency-vehicle"] }
#: [descriptions]
#: standing-ahead              = "A thing lies some forty metres ahead of the ego in its lane."
#: standing-ahead-group        = "Things lie across the ego's lane, some forty metres ahead."
#: standing-ahead-row          = "Two of a kind stand one behind the other in the ego's lane, the adversary first."
#: standing-edge-left          = "The adversary stands at the left edge of the ego's lane and leaves a part of it free."
#: standing-edge-right         = "The adversary stands at the right edge of the ego's lane and leaves a part of it free."
#: standing-in-first-lane      = "The adversary stands in the lane that the ego leaves, behind the place where it has left it."
#: standing-in-first-lane-group = "Things lie across the lane that the ego leaves, behind the place where it has left it."
#: standing-in-first-lane-row  = "Two of a kind stand one behind the other in the lane that the ego leaves."
#: standing-round-corner       = "The adversary stands just behind the junction in the lane that the ego comes into."
#: standing-round-corner-group = "Things lie across the lane that the ego comes into, just behind the junction."
#: standing-round-corner-row   = "Two of a kind stand just behind the junction in the lane that the ego comes into."

param OPT_GEO_Y = Range$y  #: unless along left  #: unless along corner  #: [m] how far ahead of the ego it starts
param OPT_GEO_Y = Range$y  #: if along left  #: [m] how far beyond the place where the ego has left its lane it stands
param OPT_GEO_Y = Range$y  #: if along corner  #: [m] how far beyond the end of the intersection it stands
param OPT_GEO_X = Range$x  #: if along edge  #: [m] how far to the left of the middle of the ego's lane it stands

standsOn = egoRoute  #: unless along left
standsOn = ownLane(egoRoute)  #: if along left
standsFrom = 0  #: unless along left  #: unless along corner
standsFrom = laneLeft  #: if along left
standsFrom = egoRoute.exitAt  #: if along corner
AdvAgent = new AdvClass at pointOn(standsOn, standsFrom + globalParameters.OPT_GEO_Y),  #: unless along edge
    facing directionOn(standsOn, standsFrom + globalParameters.OPT_GEO_Y, advStill),  #: unless along edge
    with behavior AdvBehavior()  #: unless along edge
AdvAgent = new AdvClass at pointOn(standsOn, standsFrom + globalParameters.OPT_GEO_Y, globalParameters.OPT_GEO_X + advAside),  #: if along edge
    facing directionOn(standsOn, standsFrom + globalParameters.OPT_GEO_Y, advStill),  #: if along edge
    with behavior AdvBehavior()  #: if along edge
new AdvClass at pointOn(standsOn, standsFrom + globalParameters.OPT_GEO_Y + AdvAgent.length + 1.4, 0.3),  #: if row
    facing directionOn(standsOn, standsFrom + globalParameters.OPT_GEO_Y + AdvAgent.length + 1.4, advStill - 0.15),  #: if row
    with behavior AdvBehavior()  #: if row
for back, left in ((1.2, 1.2), (-1.2, -1.2)):  #: if across
    new AdvClass at pointOn(standsOn, standsFrom + globalParameters.OPT_GEO_Y - back, left),  #: if across
        facing directionOn(standsOn, standsFrom + globalParameters.OPT_GEO_Y - back, advStill),  #: if across
        with behavior AdvBehavior()  #: if across
