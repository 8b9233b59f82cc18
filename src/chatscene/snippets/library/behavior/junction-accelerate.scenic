#: description = "The car suddenly accelerates and enters the intersection."
#: rephrasings = [
#:   "A vehicle speeds up unexpectedly and rushes into the junction.",
#:   "The throttle of the other car sticks and it shoots over the crossroads.",
#:   "The adversary gains speed on entering the intersection and forces the ego to brake.",
#:   "The crossing driver floors the pedal and bursts through.",
#:   "The approaching car does not slow but surges into the junction.",
#:   "he sees us coming and still puts his foot down to get over first",
#:   "Vehicle 2 accelerated into the intersection on a conflicting path.",
#:   "slow approach, then full throttle into crossing",
#:   "He was just pottering up to the junction, then he hoofed it and went straight in.",
#:   "Unit 2 increased its speed upon reaching the intersection and entered it.",
#:   "Truck near x-ing, sudden gas, goes in.",
#:   "On approach to the junction the target vehicle abruptly raises its speed and enters the conflict area.",
#:   "The bus gives suddenly gas and drives in the crossing.",
#:   "Actor steps on it at the junction entry, single burst of throttle, no braking after.",
#:   "She thought it would wait, but it gathered itself and charged into the crossroads.",
#:   "The motorbike's opened up all of a sudden, he's going into that intersection whether you like it or not.",
#:   "he was rolling up to the intersection all slow then just gunned it in",
#:   "A saloon put on a sudden spurt and plunged into the crossroads.",
#:   "Upon nearing the junction, did you or did you not press down harder and go in?",
#:   "Near the signal he was coming normal, then full race he has entered inside the junction.",
#:   "You think he's going to hang back at the crossing, and no, he gives it the beans and in he goes.",
#:   "Unexpected speed increase of vehicle at intersection entry",
#:   "SUV SUDDENLY FLOORS IT INTO THE JUNCTION",
#:   "The truck spurts into the crossroads.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["accelerate"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it accelerates"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.8
#: high = 2.5
#: unit = "m/s"
#: meaning = "how fast it approaches"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(0.8, 2.5)
param OPT_THROTTLE = Range(0.5, 1)

advTurn = "straight"

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE)
