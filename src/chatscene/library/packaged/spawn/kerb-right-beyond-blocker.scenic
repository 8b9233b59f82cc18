#: description = "A parked car blocks the ego's lane and the adversary stands at the right kerb beyond it."
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: origin = "own code"
#: [slots]
#: side = "right"
#: position = "kerb"
#: maneuver = "bypass"
#: blocker = true

param OPT_BLOCKER_Y = Range(-3, 3)  #: [m] how far along the middle of the bypass the parked vehicle stands
param OPT_GEO_Y = Range(28, 38)  #: [m] how far beyond the middle of the bypass it stands

new Car at pointOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),
    facing directionOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),
    with label "blocker"
advKerb = blockedLane.offset(-3.1)
advRoom = 12  # [m], free behind it along the kerb
AdvAgent = new AdvClass at pointOn(advKerb, egoRoute.eventAt + globalParameters.OPT_GEO_Y),
    facing directionOn(advKerb, egoRoute.eventAt + globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
