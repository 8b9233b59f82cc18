#: description = "The oncoming car comes slowly along the ego's lane the wrong way and stops."
#: rephrasings = [
#:   "she creeps toward us in our lane and then just stops there, nose to nose",
#:   "Vehicle 2 was moving slowly the wrong way and came to rest facing Vehicle 1.",
#:   "wrong-way, slow, then halts facing us",
#:   "The target approaches slowly in the lane of the VUT against its direction and comes gently to a standstill.",
#:   "The bike comes slow in the wrong direction and at the end it stands before us.",
#:   "A lost driver dawdles toward the ego in the wrong lane and gives up there.",
#:   "The cyclist riding up our lane eases off and puts a foot down.",
#:   "A bus trundles at us on our side of the road and rolls to a halt.",
#:   "A van came crawling at me on my side of the road and pulled up facing me.",
#:   "Unit 2 proceeded slowly the wrong way in Unit 1's lane and came to a final stop facing it.",
#:   "Wrong-way, slow, ego lane, then halts nose to nose.",
#:   "The target approaches at low speed in the VUT's lane contrary to traffic and comes to rest.",
#:   "The truck comes slowly on my lane in false direction and then stands.",
#:   "Contraflow creeper: slow head-on approach in our lane ending at zero; stays as an obstacle.",
#:   "It came up her side of the road at a crawl, and there it stopped, facing her, lamp to lamp.",
#:   "Lost tourist coming up your lane the wrong way, nice and slow, and he's pulled up in front of you.",
#:   "this van was slowly coming at us in our lane and then stopped right in our face",
#:   "A lost motorist felt his way up the wrong side and pulled up facing the traffic for good.",
#:   "You came slowly along her lane from the opposite direction, and you ended at a standstill before her?",
#:   "Opposite truck came slowly in my lane wrong side, then stopped face to face, now how.",
#:   "Dawdles up my lane at me the wrong way, stops dead, and now we're having a staring match.",
#:   "Slow contraflow approach in ego lane ending in face-to-face standstill.",
#:   "WRONG WAY DRIVER CRAWLS UP AND STOPS IN FRONT OF ME",
#:   "The wrong-way bus trickled up our lane and moored there facing us.",
#: ]
#: adversaries = ["car", "truck", "bus", "bicycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "slow", "stop"]
#: position = "oncoming"
#: maneuver = "straight"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.0
#: high = 3.6
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 8.0
#: high = 25.0
#: unit = "m"
#: meaning = "distance to the ego at which it stops"

param OPT_ADV_SPEED = Range(2, 3.6)
param OPT_ADV_DISTANCE = Range(8, 25)

behavior AdvBehavior():
    do DrivePath(advTrajectory, 8) until gap(self, ego) < 60
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 0.8 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(against(egoRoute), 0.3)
