#: description = "The oncoming car suddenly accelerates and closes the gap."
#: rephrasings = [
#:   "A vehicle approaching from ahead puts its foot down, leaving no time to return to the lane.",
#:   "The adversary speeds up toward the ego.",
#:   "Opposing traffic gains pace without warning.",
#:   "The other driver, coming the opposite way, floors the pedal.",
#:   "The oncoming motorbike rushes at the ego faster and faster.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "accelerate"]
#: position = "oncoming"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.5
#: high = 3.0
#: unit = "m/s"
#: meaning = "how fast it drives at first"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 10.0
#: high = 45.0
#: unit = "m"
#: meaning = "distance to the ego at which it accelerates"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_SPEED = Range(0.5, 3)
param OPT_ADV_DISTANCE = Range(10, 45)
param OPT_THROTTLE = Range(0.5, 1)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE)
