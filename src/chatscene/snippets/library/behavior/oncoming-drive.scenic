#: description = "The oncoming car keeps coming along its lane."
#: rephrasings = [
#:   "A vehicle approaches from ahead and does not give way.",
#:   "The adversary drives toward the ego at a constant speed.",
#:   "Opposing traffic comes on steadily.",
#:   "The cyclist rides toward the ego and holds the line.",
#:   "The other driver, facing the ego, carries straight on.",
#:   "he just keeps on coming",
#:   "Vehicle 2 was travelling in the opposite direction at constant speed.",
#:   "The oncoming target drives at constant speed in the adjacent lane.",
#:   "The other car just carried on towards me in its own lane, nothing out of the ordinary.",
#:   "Unit 2 was proceeding in the opposite direction within its lane at a normal speed.",
#:   "Oncoming bus, steady, holds lane.",
#:   "The opposing vehicle continues in its own lane at constant speed without deviation.",
#:   "From the front comes a truck, it stays on its side and drives normal.",
#:   "Plain opposing traffic: lane keeping, no manoeuvre, just doesn't give way.",
#:   "It neither slowed nor swerved; it simply came on down its own side of the road.",
#:   "There's a cyclist coming the other way, he's on his side and he's staying there, so wait for him.",
#:   "theres a car coming the other way, just normal, nothing weird",
#:   "Traffic came from the opposite direction and kept to its proper side.",
#:   "The opposing vehicle held its lane and its pace, and did nothing to which anyone could object.",
#:   "Opposite side one bus is coming in its own lane, simply normal driving.",
#:   "Something coming the other way, keeping to his own side for once, no bother.",
#:   "Regular opposing traffic in its own lane, no deviation",
#:   "Oncoming car does... absolutely nothing wrong",
#:   "The oncoming lorry plods along its own lane.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "follow"]
#: position = "oncoming"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it drives"

param OPT_ADV_SPEED = Range(4, 10)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
