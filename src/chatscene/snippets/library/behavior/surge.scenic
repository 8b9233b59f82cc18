#: description = "The car speeds up and slows down by turns."
#: rephrasings = [
#:   "A vehicle alternates between throttle and brake.",
#:   "The adversary's pace rises and falls erratically.",
#:   "The driver accelerates, brakes, and accelerates once more without reason.",
#:   "The car next to the ego keeps changing its speed unpredictably.",
#:   "The motorbike lunges forward and checks itself again and again.",
#:   "On the gas, off the gas, on the gas: the guy drives like a yo-yo.",
#:   "Vehicle 2 was accelerating and decelerating repeatedly.",
#:   "The target follows a sawtooth speed profile.",
#:   "the bloke couldn't keep a steady speed to save his life, fast, slow, fast, slow, all the way along",
#:   "The driver repeatedly increased and decreased speed for no apparent reason.",
#:   "Truck speed up/down/up/down, yo-yo.",
#:   "The target's longitudinal speed alternates cyclically between acceleration and deceleration phases.",
#:   "The bus makes faster, slower, again faster, again slower, all the time.",
#:   "Oscillating velocity profile, several periods; no lateral motion, no full stop.",
#:   "The car ran on and hung back, ran on and hung back, like a dog on a walk.",
#:   "He's got a foot like a yo-yo, that biker: on the gas, off the gas, on again, off again. Makes you seasick.",
#:   "this car keeps going fast slow fast slow its making me ill",
#:   "A bus whose pace rose and fell like the tide perplexed those about it",
#:   "Your speed climbed, it fell, it climbed anew, and so it went on, did it not?",
#:   "This driver one time fast one time slow, one time fast again, cannot predict",
#:   "On the gas, off it, on it, off it, like he's pumping up a lilo",
#:   "Cyclic speed fluctuation of neighbouring traffic",
#:   "Motorbike can't hold a speed: fast, slow, FAST, SLOW",
#:   "The truck pulsed along.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["accelerate", "brake"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -15.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.35
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 1.2
#: high = 2.2
#: unit = "s"
#: meaning = "how long each phase lasts"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_THROTTLE = Range(0.6, 1)
param OPT_BRAKE = Range(0.35, 1)
param OPT_ADV_PERIOD = Range(1.2, 2.2)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    while True:
        do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) for 0.6 * globalParameters.OPT_ADV_PERIOD seconds
        do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE) for globalParameters.OPT_ADV_PERIOD seconds
