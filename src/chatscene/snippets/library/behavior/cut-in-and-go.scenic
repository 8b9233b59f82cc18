#: description = "The car accelerates, forces its way in front of the ego and pulls away."
#: rephrasings = [
#:   "He floors it beside us, elbows in and is off.",
#:   "Vehicle 1 accelerated in the adjacent lane, merged with minimal clearance and left vehicle 2 behind.",
#:   "Neighbour speeds up, tight merge, opens gap.",
#:   "The target gains speed alongside, cuts in closely before the VUT and moves ahead.",
#:   "It presses the gas and pushes inside our lane, then is far.",
#:   "A motorbike zips past the wing, dives over and leaves us standing.",
#:   "The delivery van muscles in with its engine howling and disappears up the road.",
#:   "Where the lanes merge, somebody puts on a spurt to be first.",
#:   "Cheeky git floored it, barged in front of me and cleared off up the road.",
#:   "Unit 2 accelerated past, forcibly merged ahead of Unit 1 and continued away at increasing speed.",
#:   "Moto guns it, elbows in front of ego, gone. No brake.",
#:   "Target increases speed, changes lane into a short gap in front of the VUT and continues to draw away.",
#:   "A car gives gas, pushes in before me and goes away fast.",
#:   "Rude merge but the gap opens: actor speeds up, takes our slot, then keeps pulling ahead; we should not panic-brake.",
#:   "He put his foot down, wedged himself in before her and was a dot in the distance before she'd finished swearing.",
#:   "He's going to bully his way in ahead of you and clear off, so just ease back, he'll be long gone in a moment.",
#:   "he sped up cut me off and dipped, didnt even look back",
#:   "A powerful saloon bulled its way ahead of the pensioner's car and vanished up the road.",
#:   "He gathered speed, thrust himself before my client and drew off into the distance; you saw that?",
#:   "That fellow pressed full accelerator, put himself in my front and just went off.",
#:   "Boots it, bullies his way in front of me, next thing he's a dot on the horizon.",
#:   "Forced merge ahead of ego under acceleration, with opening gap thereafter.",
#:   "CUTS ME OFF AND DISAPPEARS",
#:   "The ambulance barrelled in ahead and streaked off.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cut-in", "accelerate"]
#: leader = false
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = -4.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far its rear is ahead of the ego's front before it moves over"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"
#: [[parameters]]
#: name = "OPT_THROTTLE_TIME"
#: low = 0.1
#: high = 0.8
#: unit = "s"
#: meaning = "for how long it presses the pedal"

param OPT_ADV_DISTANCE = Range(0, 30)
param OPT_ADV_AHEAD = Range(-4, 3)
param OPT_THROTTLE = Range(0.5, 1)
param OPT_THROTTLE_TIME = Range(0.1, 0.8)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD + (ego.length + self.length) / 2, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advLane, globalParameters.OPT_THROTTLE) for globalParameters.OPT_THROTTLE_TIME seconds
    do ThrottleOnPath(egoRoute, globalParameters.OPT_THROTTLE, 0, 14)
