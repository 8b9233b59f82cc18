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
#:   "Bus facing us inches round to its left, right over our path.",
#:   "Oncoming lorry left-turns across us slower than a milk float.",
#:   "Let a cyclist from ahead dawdle through a left across the ego.",
#:   "Opposing cab, left turn over subject's path, walking pace throughout.",
#:   "He came towards us and turned left before us like a snail.",
#:   "It seemed to take the coach opposite a whole minute to lug itself leftward over our side of the crossroads, so gently did it go.",
#:   "The opposing target negotiates its left turn through the path of the vehicle under test at a creeping velocity, thereby occupying the conflict zone for a prolonged time.",
#:   "See that pickup opposite with the indicator going? He's cutting left over your lane now, and at that rate you could read a book till he's clear.",
#:   "The lady in the car in face has turned on her left in front of my capot, but at the step of a man, I waited long.",
#:   "My complaint is that he swung left over my lane from the other direction with so little speed that no one could have got by.",
#:   "I want an oncoming motorbike whose rider, feet almost down, potters through a left turn in front of the robotaxi and takes his time about it.",
#:   "We had the junction to ourselves but for an artic coming the other way. It began a turn to its left, which took it over our lane, and I have seen glaciers with more urgency. By the time its rear lights had cleared us the signal had changed twice.",
#:   "Vehicle 2 approached from the opposite direction and commenced a left turn through the path of Vehicle 1. Based on the video, its speed in the turn was 5 to 6 km/h and did not rise. Vehicle 1's driver had misjudged how long the crossing would stay obstructed.",
#:   "I don't drive so well in the dark myself, so I sympathise. The old gentleman opposite wanted to go left into Elm Grove, and he did go left, straight over where I was headed, only he crawled round as if there were eggs on the roof, and I had to stop for him.",
#:   "Why did we disengage? Oncoming car, left across path, constant crawl. Our gap logic extrapolates a typical turning speed of 20 km/h and concludes it'll be out of the way; in truth it's moving like a pedestrian and is still sideways in front when we get there. No stop, no hesitation, just very slow.",
#:   "As a bike courier you come to hate this one. There's a minibus coming at the car I'm behind, and it peels off leftward, over our lane, at the speed of a shopping trolley. It's in no trouble. It never halts. It's merely being driven round as slowly as an engine will bear.",
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
