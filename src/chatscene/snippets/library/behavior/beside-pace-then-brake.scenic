#: description = "The car keeps pace with the ego and then brakes hard in its lane."
#: rephrasings = [
#:   "He sits alongside us for ages and then drops anchor.",
#:   "Vehicle 2 ran parallel to vehicle 1 before decelerating abruptly in the adjacent lane.",
#:   "Level with us, then hard brake next lane.",
#:   "The target matches the VUT's speed abreast and then brakes strongly.",
#:   "It is going the same speed near us, then it brakes much on its lane.",
#:   "The bus beside us matches us metre for metre until it slams to a stop.",
#:   "A motorcyclist cruising abreast suddenly falls back under braking.",
#:   "Neck and neck, and then the lorry next door stands on its brakes.",
#:   "a lad in a Golf ran neck and neck with me for a bit, then dropped anchor in his own lane",
#:   "Vehicle #2 traveled abreast of Vehicle #1, matching speed, before its driver abruptly applied the brakes without leaving his lane.",
#:   "Bus abreast, same v; then sharp decel next lane.",
#:   "The target drives level with the VUT in the adjacent lane at equal speed; it then decelerates at 6 m/s² within that lane.",
#:   "The motorcycle goes with me side by side, same speed, and then he brakes strong, he stays on his lane.",
#:   "Parallel runner, matched velocity for a few secs, then panic stop in the neighbour lane. No lane change!",
#:   "They rode shoulder to shoulder with the lorry until all at once it stood on its brakes and fell away behind their window.",
#:   "The ambulance is cruising along at your elbow... now look, he's dropped away from beside you, stamped on it in his own lane.",
#:   "he was right next to us the whole time matching us n then just slammed it in his lane and vanished",
#:   "The two vehicles were travelling side by side when, according to a passenger, the coach pulled up sharply",
#:   "You maintained station beside the claimant and then, remaining in your own lane, braked with violence?",
#:   "That bike is coming along with us only, same speed same speed, then suddenly in his lane he puts full brake",
#:   "Bloke keeps me company door by door for half a mile, then chucks out the anchors next to me, no reason",
#:   "Abreast running at equal speed followed by abrupt deceleration of the adjacent vehicle",
#:   "Fire truck keeps level with me, then PANIC BRAKES one lane over",
#:   "The van twinned our speed, then dropped like a stone behind its own brake lights.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pace", "brake"]
#: position = "beside"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -22.0
#: high = 4.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 1.0
#: high = 6.0
#: unit = "m"
#: meaning = "how far ahead of the ego it stays"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(-22, 4)
param OPT_ADV_AHEAD = Range(1, 6)
param OPT_BRAKE = Range(0.5, 1)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 0.5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advLane, globalParameters.OPT_BRAKE)
