#: description = "A parked car blocks the ego's lane and the adversary stands at the right kerb beyond it."
#: rephrasings = [
#:   "At the right edge, just past the vehicle that stands in the way of the ego.",
#:   "once we're round the blocked bit there's another one parked on the right",
#:   "parked veh, right kerb, beyond blocked lane",
#:   "Vehicle 2 was parked along the right curb past the disabled vehicle obstructing lane 1.",
#:   "The target is at rest on the nearside beyond the obstacle which the VUT avoids.",
#:   "After the blocking auto stays one more on right side.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["AdvBehavior", "blockedLane", "egoRoute"]
#: provides = ["AdvAgent", "advKerb", "advRoom"]
#: origin = "own code"
#: [slots]
#: side = "right"
#: position = "kerb"
#: blocker = true
#: maneuver = "bypass"
#: [[parameters]]
#: name = "OPT_BLOCKER_Y"
#: low = -3.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far along the middle of the bypass the parked vehicle stands"
#: [[parameters]]
#: name = "OPT_GEO_Y"
#: low = 28.0
#: high = 38.0
#: unit = "m"
#: meaning = "how far beyond the middle of the bypass it stands"

param OPT_BLOCKER_Y = Range(-3, 3)
param OPT_GEO_Y = Range(28, 38)

new Car at pointOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),
    facing directionOn(blockedLane, egoRoute.eventAt + globalParameters.OPT_BLOCKER_Y),
    with label "blocker"
advKerb = blockedLane.offset(-3.1)
advRoom = 12  # [m], free behind it along the kerb
AdvAgent = new AdvClass at pointOn(advKerb, egoRoute.eventAt + globalParameters.OPT_GEO_Y),
    facing directionOn(advKerb, egoRoute.eventAt + globalParameters.OPT_GEO_Y),
    with behavior AdvBehavior()
