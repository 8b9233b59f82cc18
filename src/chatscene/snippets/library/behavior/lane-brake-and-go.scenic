#: description = "The car brakes suddenly and then drives off again."
#: rephrasings = [
#:   "A vehicle decelerates hard for a moment and afterwards picks up speed.",
#:   "The adversary brake-checks the ego and accelerates away.",
#:   "The car next to the ego slows sharply, then resumes its pace.",
#:   "The driver stamps on the brake and shortly after on the gas.",
#:   "The motorbike dabs the brakes violently and pulls away once more.",
#:   "He brake-tests us once and takes off again.",
#:   "Vehicle 2 decelerated abruptly, then resumed its travel speed.",
#:   "Hard brake pulse, then acceleration to prior speed.",
#:   "Chap jumped on the brakes for no reason and then off he went again.",
#:   "Vehicle 2 braked abruptly without cause, then resumed its speed.",
#:   "Car: hard brake, brief, then away again. No full block.",
#:   "The target applies sudden braking and, after a short interval, accelerates back to speed.",
#:   "The bus brakes suddenly and then goes on again.",
#:   "One brake event then recovery: decel spike, then throttle back up, keeps its lane.",
#:   "He stamped on the pedal out of the blue, seemed to come to his senses, and got going again.",
#:   "He's thrown the brakes on, wait, no, he's pulling away again, carry on.",
#:   "he braked outta nowhere and then just drove off like nothing happened",
#:   "For no evident cause the driver checked his car violently, then picked up his pace once more, a resident said.",
#:   "You braked with violence, released, and resumed your journey, all within a couple of seconds?",
#:   "Car suddenly put brake, then again started going, I don't know what for.",
#:   "Whacks his brakes on, thinks better of it, picks up again. Like driving behind a yo-yo.",
#:   "Unexpected short braking event with subsequent recovery of speed.",
#:   "RANDOM BRAKING THEN DRIVES OFF LIKE NOTHING HAPPENED",
#:   "The bus choked its speed and then revived.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["brake", "accelerate"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -15.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_BRAKE_TIME"
#: low = 0.7
#: high = 1.6
#: unit = "s"
#: meaning = "for how long"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 7.0
#: high = 12.0
#: unit = "m/s"
#: meaning = "how fast it drives afterwards"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_BRAKE = Range(0.4, 1)
param OPT_BRAKE_TIME = Range(0.7, 1.6)
param OPT_ADV_SPEED = Range(7, 12)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) for globalParameters.OPT_BRAKE_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
