#: description = "The crossing car launches into a left turn in front of the ego, gaining speed."
#: rephrasings = [
#:   "he guns it out of the side road and swings left right across us",
#:   "Vehicle 2 accelerated from the stop line into a left turn across the path of Vehicle 1.",
#:   "from the line, full throttle, left, across our bows",
#:   "The target, waiting at the line, accelerates into a left turn that crosses the lane of the VUT.",
#:   "The motorcycle starts with much gas and turns left before the ego.",
#:   "A biker snatches a gap and storms round to the left.",
#:   "The police car sprints off to its left with squealing tyres.",
#:   "Foot to the floor, the taxi nips left ahead of us.",
#:   "He shot out of the side road, swinging left in front of me and picking up speed all the way.",
#:   "Unit 2 accelerated hard into a left turn from the cross street ahead of Unit 1.",
#:   "Side-road car floors it, L-turn ahead of ego.",
#:   "The crossing target begins a left turn in front of the VUT with increasing speed.",
#:   "The motorbike from the side street turns left before me with a lot of gas.",
#:   "Cross-traffic actor does a hard-throttle left turn out in front of us; not from the opposite direction, no stop.",
#:   "He came out of the side street like a cork from a bottle and swept round left ahead of her, faster and faster.",
#:   "That one waiting on the side's going for it, he's booting it round to the left in front of you.",
#:   "she shot outta the side street going left right in front of us n kept speeding up",
#:   "A car burst from the side road, wheeling left before traffic and gaining pace throughout.",
#:   "You emerged from the minor road, to the left, ahead of my client, with your foot hard on the accelerator?",
#:   "From the side road he came fast, taking left in my front, increasing speed some more.",
#:   "Bursts out of the side turning and slings it left under my nose, faster by the yard.",
#:   "Accelerated left turn of cross traffic ahead of ego.",
#:   "CAR LAUNCHES OUT OF SIDE STREET, LEFT TURN IN MY FACE",
#:   "The police car sprang left out of the side road, quickening.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["turn-left", "accelerate"]
#: position = "crossing"
#: side = "right"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it accelerates"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.3
#: high = 0.6
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_THROTTLE = Range(0.3, 0.6)

advTurn = "left-turn"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, 9)
