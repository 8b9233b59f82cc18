#: description = "The car tears through the intersection at high speed."
#: rephrasings = [
#:   "some lunatic flies through the crossing doing eighty",
#:   "Vehicle 2 entered the intersection at a speed well in excess of the limit.",
#:   "very fast through the crossing, doesn't yield",
#:   "The target traverses the junction on a conflicting path at 45 km/h or more.",
#:   "A motorcycle comes like a rocket over the crossing and nobody can stop in time.",
#:   "A biker streaks across the crossroads.",
#:   "An ambulance hurtles over the junction.",
#:   "Going far too fast, the other driver whips past in front of the ego.",
#:   "some maniac went through the crossroads like a bat out of hell",
#:   "The suspect vehicle traversed the intersection at an estimated 70 mph.",
#:   "Ambulance: blasts thru jct at v. high spd.",
#:   "The target passes straight through the junction at excessive speed.",
#:   "The motorbike goes over the crossing with very much speed, like a rocket.",
#:   "High-velocity crosser: NPC takes the junction at way over limit, no decel.",
#:   "It had gone by before she could say what it was, a red streak hurtling over the crossing.",
#:   "All units, the bike's just blown over the crossroads doing eighty, he's flying.",
#:   "that bike went thru the crossroads at like mach 2",
#:   "Residents called for cameras after a sports car shot over the junction at breakneck speed",
#:   "Would you agree that ninety is rather more than the junction permits, Mr Shaw? You flew over it.",
#:   "That Lamborghini whoosh only through the junction, siao ah, so fast",
#:   "Couldn't tell you what colour it was, went over the crossroads like a dose of salts",
#:   "Excessive-speed traverse of the intersection by crossing traffic",
#:   "LUNATIC screams through intersection at 120 km/h",
#:   "The ambulance rocketed through the crossroads.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "NHTSA pre-crash typology: straight crossing paths; own code"
#: [slots]
#: actions = ["fast"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 25.0
#: high = 60.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 12.0
#: high = 16.0
#: unit = "m/s"
#: meaning = "how fast it drives"

param OPT_ADV_DISTANCE = Range(25, 60)
param OPT_ADV_SPEED = Range(12, 16)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, 1, 0, globalParameters.OPT_ADV_SPEED)
