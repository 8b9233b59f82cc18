#: description = "The pedestrian crosses in fits and starts, stopping again and again."
#: rephrasings = [
#:   "A person moves over the road in short bursts with a pause after each.",
#:   "The walker repeatedly halts and sets off while crossing the lane.",
#:   "The pedestrian jerks across: a few steps, a stop, a few steps more.",
#:   "Someone crosses the carriageway stop-and-go, impossible to predict.",
#:   "The cyclist pedals over in spurts, standing still between them.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "hesitate"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.5
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it goes in a burst"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 10.0
#: high = 45.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_BURST"
#: low = 0.6
#: high = 1.2
#: unit = "s"
#: meaning = "how long a burst lasts"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.3
#: high = 0.8
#: unit = "s"
#: meaning = "how long it stands between bursts"

param OPT_ADV_SPEED = Range(1.5, 4)
param OPT_ADV_DISTANCE = Range(10, 45)
param OPT_ADV_BURST = Range(0.6, 1.2)
param OPT_STOP_TIME = Range(0.3, 0.8)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    while True:
        do MoveAhead(globalParameters.OPT_ADV_SPEED) for globalParameters.OPT_ADV_BURST seconds
        do Halt() until self.pose[3] < 0.1
        do Halt() for globalParameters.OPT_STOP_TIME seconds
