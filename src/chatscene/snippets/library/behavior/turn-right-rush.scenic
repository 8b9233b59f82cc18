#: description = "The car accelerates out of the side street, turning right into the ego's lane."
#: rephrasings = [
#:   "he guns it round the corner to squeeze in ahead of us",
#:   "Vehicle 2 accelerated from the stop line into a right turn ahead of Vehicle 1.",
#:   "right turn into our lane under hard acceleration",
#:   "The target, waiting at the line, accelerates while turning right into the lane of the VUT.",
#:   "The motorcycle turns right with full gas to be before the ego.",
#:   "A biker blasts out to the right into a gap that isn't there.",
#:   "The ambulance hurries off to its right just ahead of us, picking up speed.",
#:   "Without giving way, a hatchback scoots round to the right and puts its foot down.",
#:   "Someone came flying out of the side road, turning right into my lane with his boot down.",
#:   "Vehicle 2 pulled out of the side street, turned right into Unit 1's lane and accelerated.",
#:   "Side st. moto: R-turn into ego lane, full gas.",
#:   "The target emerges from the minor road, turning right into the VUT's lane under acceleration.",
#:   "The car comes quick out of the small street and turns right in my lane.",
#:   "Right-turner from the minor road jumps into our lane at full throttle; merges ahead instead of waiting.",
#:   "He whipped round the corner out of the lane and landed right in front of her, engine screaming.",
#:   "He's not going to wait at that side turning, he's hurrying out to the right, into your lane.",
#:   "he came flying round the corner to the right into our lane",
#:   "A motorcycle hurtled out of the side street, rounding to the right into the path of a van.",
#:   "You issued from the side street, rightward, into her lane, and you were quickening as you did so?",
#:   "From the small road he came out turning right into my lane, pressing full.",
#:   "Out of the side road like a cork, right-hand turn, into my lane, and no lifting off neither.",
#:   "Accelerated right-turn entry into ego lane from side street.",
#:   "SPEEDS OUT OF SIDE STREET RIGHT INTO MY LANE",
#:   "The motorcycle vaulted from the side street rightward into our lane.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["turn-right", "accelerate"]
#: position = "crossing"
#: side = "right"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 40.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it accelerates"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.4
#: high = 0.8
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(12, 40)
param OPT_THROTTLE = Range(0.4, 0.8)

advTurn = "straight"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, 7) until abs(offsetFrom(egoRoute, self)) < 6
    do ThrottleOnPath(egoRoute, globalParameters.OPT_THROTTLE, 0, 9)
