#: adversaries = ["bicycle", "motorcycle"]
#: origin = "Euro NCAP CBNAO: the ego turns, a cyclist beside it goes straight on"
#: [slots]
#: side = "right"
#: maneuver = "right-turn"
#: [variants]
#: rider-straight-on-ahead = { position = "ahead-beside", y = [8, 24] }
#: rider-straight-on-behind = { position = "behind-beside", y = [-9, -4], adversaries = ["bicycle"] }
#: rider-straight-on-level = { position = "beside", y = [-2, 4] }
#: rider-straight-on-level-group = { position = "beside", y = [0, 6], group = true }
#: [descriptions]
#: rider-straight-on-ahead = "The adversary rides ahead at the right edge of the ego's lane and goes straight on where the ego turns right."
#: rider-straight-on-behind = "The adversary rides behind the ego on the right, at the edge of its lane, and goes straight on where the ego turns right."
#: rider-straight-on-level = "The adversary rides level with the ego, at the right edge of its lane, and goes straight on where the ego turns right."
#: rider-straight-on-level-group = "A group rides level with the ego at the right edge of its lane, the adversary first, and goes straight on where the ego turns right."

param OPT_GEO_Y = Range$y  #: [m] how far ahead of the ego it starts
param OPT_GEO_X = Range(2.1, 2.6)  #: [m] how far to the right of the ego's line it rides

acrossFrom = oncomingTraffic  # an arm opposite, or there is no straight on
advTrajectory = extended(straightOn(egoRoute), 20).offset(-2.3)
AdvAgent = new AdvClass at pointOn(extended(straightOn(egoRoute), 20), 20 + globalParameters.OPT_GEO_Y, -globalParameters.OPT_GEO_X),
    facing directionOn(advTrajectory, 20 + globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
for back, left in ((2.6, 0.1), (5.2, -0.2)):  #: if group
    new AdvClass at pointOn(extended(straightOn(egoRoute), 20), 20 + globalParameters.OPT_GEO_Y - back, left - globalParameters.OPT_GEO_X),  #: if group
        facing directionOn(advTrajectory, 20 + globalParameters.OPT_GEO_Y - back),  #: if group
        with behavior AdvBehavior()  #: if group
