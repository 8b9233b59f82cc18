#: description = "The oncoming car turns left across the ego's path at walking pace."
#: rephrasings = [
#:   "this guy opposite crawls through his left turn as if we weren't there",
#:   "Vehicle 2, travelling in the opposite direction, made a slow left turn across the lane of Vehicle 1.",
#:   "opposing left turn, very slow, our lane blocked for long",
#:   "The oncoming target turns left across the path of the VUT at not more than 14 km/h.",
#:   "A bus from the front turns left so slowly that the crossing is occupied long time.",
#:   "A cyclist coming the other way meanders left over our lane.",
#:   "The long lorry facing the ego needs ages to drag itself round to the left.",
#:   "Unhurried, it rolls leftward through the gap against the oncoming stream.",
#:   "He came from the other direction and crawled left through the junction right under my nose, slow as treacle.",
#:   "Opposing unit made a left turn at a very low rate of speed across the path of Unit 1.",
#:   "Oncoming bus, L turn at x-ing, snail pace.",
#:   "The opposing vehicle turns left across the path of the test vehicle at the junction at approximately 5 km/h.",
#:   "The car from the front turns left before me but so slow.",
#:   "LTAP/OD at crawl speed: conflict area is occupied for ages.",
#:   "It began its turn and then seemed to run out of will, inching across her way while she bore down on it.",
#:   "Lorry opposite is turning left over you and he's barely moving, he'll be in your way a good while.",
#:   "he turned left in front of me at the intersection soooo slow like grandpa pls",
#:   "A van from the opposite direction made its left turn so gradually that it was still in the way when the car arrived.",
#:   "The turn was to the left, across my client, and it was executed with no more speed than a stroll.",
#:   "Opposite lorry turning left at junction, but so slow like bullock cart, I have to brake.",
#:   "Turns left over me at the crossing as if he's towing a piano.",
#:   "Left turn of opposing vehicle at intersection with extended dwell in own path due to crawl speed",
#:   "LEFT TURN IN SLOW MOTION across my path",
#:   "The oncoming bus crawls leftward through the crossing before us.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "turn-left", "slow"]
#: position = "oncoming"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 15.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 2.5
#: high = 3.8
#: unit = "m/s"
#: meaning = "how fast it turns"

param OPT_ADV_DISTANCE = Range(0, 15)
param OPT_SLOW_SPEED = Range(2.5, 3.8)

advTurn = "left-turn"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED)
