#: description = "The car suddenly accelerates and then decelerates."
#: rephrasings = [
#:   "A vehicle shoots forward and shortly after slows hard.",
#:   "The adversary gains speed abruptly, then brakes.",
#:   "The driver speeds up to get past the ego and at once hits the brakes.",
#:   "The car rushes ahead and loses its speed again.",
#:   "First full throttle, then full brake: the vehicle beside is unreadable.",
#:   "The guy next to us guns it and then straight away slams on.",
#:   "Vehicle 2 accelerated briefly, then applied hard braking.",
#:   "It gives gas first and after two seconds it brakes full.",
#:   "this Corsa up the road put a spurt on for no reason and a moment later he'd scrubbed all the speed off again",
#:   "Operator of unit 2, a Dodge Ram, gunned the engine for a short distance and then got hard on the brakes.",
#:   "Coach: burst of speed, then anchors. Once only.",
#:   "The target motorcycle performs a single acceleration phase, immediately followed by a deceleration phase.",
#:   "the lorry first goes fast suddenly, after this he makes slow",
#:   "Ticket: NPC needs one throttle pulse followed by one brake pulse; currently it only holds a constant speed.",
#:   "The biker had whipped the throttle open, and before we could make sense of it he had squeezed the lever and dropped right back.",
#:   "See that van? Foot flat to the floor, and now he's thought better of it and he's shedding it all again.",
#:   "lol that van just yeeted itself forward n then 2 secs later full on brake lights",
#:   "A motorist who put on a sprint in Mill Lane, only to haul his vehicle back down moments afterwards, baffled onlookers",
#:   "Is it not the case that you opened the throttle wide, counsel put it to him, and straight afterwards stood on the pedal?",
#:   "Uncle suddenly zoom ahead, then jialat, jam brake for what also don't know",
#:   "Makes up his mind he's Lewis Hamilton for three seconds, then bottles it and drags it all back down, beats me",
#:   "Unexpected speed peak of neighbouring vehicle with immediate subsequent loss of velocity",
#:   "BIKER floors it... then INSTANT REGRET (brakes)",
#:   "The bus spurted, then checked itself.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario right-turn; own code"
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
#: low = 0.7
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"
#: [[parameters]]
#: name = "OPT_THROTTLE_TIME"
#: low = 1.0
#: high = 2.5
#: unit = "s"
#: meaning = "for how long"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_THROTTLE = Range(0.7, 1)
param OPT_THROTTLE_TIME = Range(1, 2.5)
param OPT_BRAKE = Range(0.4, 1)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE) for globalParameters.OPT_THROTTLE_TIME seconds
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
