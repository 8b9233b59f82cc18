#: description = "The car drives along its lane at a steady speed."
#: rephrasings = [
#:   "A vehicle keeps to its lane and its pace.",
#:   "The adversary simply goes on straight ahead.",
#:   "The car follows the road without changing anything.",
#:   "The driver cruises on, neither faster nor slower.",
#:   "The truck stays in lane at constant speed.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["follow"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it drives"

param OPT_ADV_SPEED = Range(4, 9)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
