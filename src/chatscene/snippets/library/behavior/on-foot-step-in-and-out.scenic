#: description = "The oncoming pedestrian strays into the ego's lane and withdraws to the edge again."
#: rephrasings = [
#:   "A walker heading our way veers in front of us for a second, then jumps clear.",
#:   "A pedestrian walking against traffic entered the travel lane momentarily and returned to the shoulder.",
#:   "oncoming ped into lane, then out again",
#:   "The target approaches, enters the VUT's lane and leaves it on the same side.",
#:   "The person comes to us, goes into the lane and goes out again to her side.",
#:   "Somebody skirts an obstacle on the pavement by a short detour through our lane.",
#:   "The jogger we meet pops round a puddle and back onto the verge.",
#:   "A rambler lurches out to overtake a friend and tucks himself away again.",
#:   "some bloke walking towards us wandered off the edge into my lane and then took himself back to the side",
#:   "A pedestrian walking against traffic stepped into V1's lane momentarily and returned to the shoulder.",
#:   "Ped facing us on verge: in our lane briefly, then out again.",
#:   "The oncoming pedestrian deviates laterally into the VUT's lane and subsequently returns to the lane edge.",
#:   "A man comes against me on the side, he goes a little in my lane, after he goes back to the side.",
#:   "Walker heading towards SUT: lateral excursion into the lane and back to the shoulder, no crossing.",
#:   "She had been coming along the roadside towards them; her feet carried her out into their path a while, then she drew in again.",
#:   "Lady walking towards you there, she's come out a bit into your side... it's fine, she's tucked herself back in.",
#:   "some guy walking towards us wandered into the road then hopped back to the side",
#:   "A rambler facing traffic drifted off the verge before thinking better of it and regaining the edge",
#:   "You were walking towards the car, you entered its lane, and you then took yourself off it again?",
#:   "Uncle walking opposite side to us came inside the lane, then went back to the side again",
#:   "Geezer walking at me wanders off the verge, sees my face and hops back on it",
#:   "Transient lane incursion by opposing pedestrian with return to the edge",
#:   "Man walks AT my car, steps in the lane, steps out again",
#:   "The walker coming our way dipped a toe in the lane and retreated.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior", "advFacing"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "turn-back"]
#: position = "oncoming"
#: place = "road"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.0
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 16.0
#: high = 32.0
#: unit = "m"
#: meaning = "distance to the ego at which it enters the lane"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 0.4
#: high = 1.6
#: unit = "m"
#: meaning = "how far from the ego's line it withdraws"

param OPT_ADV_SPEED = Range(2, 4)
param OPT_ADV_DISTANCE = Range(16, 32)
param OPT_ADV_REACH = Range(0.4, 1.6)

# It faces against the ego's direction.
advFacing = 3.14159

behavior AdvBehavior():
    do Halt() until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE + 2 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 1) until restsWithin(egoRoute, self, globalParameters.OPT_ADV_REACH)
    do MoveAhead(globalParameters.OPT_ADV_SPEED, -2) until abs(offsetFrom(egoRoute, self)) > 3
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 1)
