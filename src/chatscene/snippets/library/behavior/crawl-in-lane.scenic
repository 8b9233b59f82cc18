#: description = "The car drives extremely slowly along its lane."
#: rephrasings = [
#:   "A vehicle crawls ahead at little more than walking pace.",
#:   "The adversary creeps along and holds everybody up.",
#:   "The driver dawdles far below the flow of traffic.",
#:   "The car inches forward and obstructs the lane.",
#:   "A cyclist trundles on at a very low speed.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["slow"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.8
#: high = 3.2
#: unit = "m/s"
#: meaning = "how fast it drives"

param OPT_ADV_SPEED = Range(0.8, 3.2)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
