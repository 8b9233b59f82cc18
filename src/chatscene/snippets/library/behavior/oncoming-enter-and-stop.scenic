#: description = "The oncoming pedestrian comes along the road edge, enters the lane without warning and suddenly stops."
#: rephrasings = [
#:   "A person walking against the traffic steps into the lane and freezes.",
#:   "The pedestrian approaches from ahead, veers into the ego's way, and stands still.",
#:   "Someone who walks toward the ego slips into the carriageway and halts there.",
#:   "Facing the ego, the walker moves into its path and comes to a standstill.",
#:   "The jogger running toward the vehicle swings into the lane and stops dead.",
#:   "this guy walks toward us along the edge, steps out and just stands there",
#:   "A pedestrian walking against traffic entered the lane and stopped.",
#:   "walker facing us, steps in, halts",
#:   "A cyclist coming towards me along the verge wandered into my lane and stopped dead in it.",
#:   "The pedestrian was walking along the shoulder facing traffic, abruptly stepped into the lane and halted.",
#:   "Ped on edge, facing ego, steps into lane, stands.",
#:   "The cyclist target approaches along the carriageway edge, enters the VUT's lane without signalling and comes to a sudden halt.",
#:   "A man comes on the border of the road in my direction, suddenly he comes in my lane and stays standing.",
#:   "Oncoming VRU on the shoulder turns into our lane and freezes; no crossing afterwards.",
#:   "She had been coming up the edge of the road; then she stepped out before him and stood stock-still.",
#:   "Watch that moped coming up the edge towards you, he's swung in front of us and stopped!",
#:   "this guy walking towards us on the side just stepped in and STOOD there",
#:   "A pensioner approaching on the roadside turned into the lane with no warning and came to a standstill.",
#:   "She had been coming toward you at the margin of the road, she entered your lane, and there she stopped?",
#:   "One cyclist coming opposite side by the edge, suddenly came inside my lane and stopped, no warning.",
#:   "He's coming up the gutter to meet me, next thing he's in my lane and stopped like a lamp post.",
#:   "Unannounced lane entry and halt by oncoming road-edge user.",
#:   "MAN WALKING TOWARD ME STEPS INTO LANE AND FREEZES",
#:   "The oncoming moped rider left the edge and rooted himself in our lane.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior", "advFacing"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "stop"]
#: position = "oncoming"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.5
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 3.0
#: high = 20.0
#: unit = "m"
#: meaning = "distance to the ego at which it enters the lane"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.6
#: high = 1.0
#: unit = "rad"
#: meaning = "how sharply it turns into the lane"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.0
#: high = 1.0
#: unit = "m"
#: meaning = "how far from the ego's line it comes to rest"

param OPT_ADV_SPEED = Range(1.5, 4)
param OPT_ADV_DISTANCE = Range(3, 20)
param OPT_ADV_ANGLE = Range(0.6, 1)
param OPT_STOP_DISTANCE = Range(0, 1)

# It faces against the ego's direction.
advFacing = 3.14159

behavior AdvBehavior():
    do Halt() until gap(self, ego) < 2 * globalParameters.OPT_ADV_DISTANCE + 6 * max(0, abs(offsetFrom(egoRoute, self)) - 4) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE + 6 * max(0, abs(offsetFrom(egoRoute, self)) - 4) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else -globalParameters.OPT_ADV_ANGLE) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()
