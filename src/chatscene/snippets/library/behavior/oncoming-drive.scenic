#: description = "The oncoming car keeps coming along its lane."
#: rephrasings = [
#:   "A vehicle approaches from ahead and does not give way.",
#:   "The adversary drives toward the ego at a constant speed.",
#:   "Opposing traffic comes on steadily.",
#:   "The cyclist rides toward the ego and holds the line.",
#:   "The other driver, facing the ego, carries straight on.",
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
