#: description = "The oncoming car accelerates into a left turn across the ego's path."
#: rephrasings = [
#:   "he thinks he can make the left before us and floors it",
#:   "Vehicle 2, stopped opposite, accelerated into a left turn in front of Vehicle 1.",
#:   "opposing veh, left turn, full throttle, misjudged gap",
#:   "The oncoming target, waiting to turn, accelerates left across the path of the VUT.",
#:   "The motorcycle in front of us accelerates strong and turns left before the ego passes.",
#:   "A biker facing us gambles on a quick left and opens it up.",
#:   "The ambulance opposite swings left in a hurry, siren on.",
#:   "Jumping the gap, it darts leftward ahead of us with spinning wheels.",
#:   "The git coming the other way gunned it and whipped left across me to beat me through.",
#:   "The opposing vehicle accelerated and turned left in front of Unit 1, failing to yield.",
#:   "Opp. moto floors it, L-turn across ego's bow.",
#:   "The oncoming target increases speed while turning left across the trajectory of the VUT.",
#:   "The car against me gives much gas and turns quick left before me.",
#:   "Left-turn-across-path with throttle: opposite actor tries to beat us through the gap, speeds up in the turn.",
#:   "He saw a gap that wasn't there, put his foot to the floor and flung it left across her road.",
#:   "He thinks he can make it, he's going for the gap, racing his left turn in front of you!",
#:   "guy coming at us floored it to make his left before us. he barely did",
#:   "The approaching sports car put on speed to snatch a left turn ahead of traffic.",
#:   "Seeing her approach, you chose to quicken and turn left before her rather than wait?",
#:   "Opposite car wanted to turn left fast fast before me, so he raced across my front.",
#:   "Sees me coming, so he gives it the lot and slings it left over my bows.",
#:   "Accelerated left turn of opposing vehicle across ego path.",
#:   "RACES TO BEAT ME ON A LEFT TURN",
#:   "The oncoming motorbike pounced left over our path.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "NHTSA pre-crash typology: left turn across path, opposite direction; own code"
#: [slots]
#: actions = ["oncoming", "turn-left", "accelerate"]
#: position = "oncoming"
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
