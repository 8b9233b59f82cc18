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
#:   "Something silver tore over the crossroads like a cruise missile.",
#:   "Have a motorbike belt over the crossroads, full chat.",
#:   "V2 took the junction at more than twice the limit.",
#:   "He thundered across the junction as if it were a runway.",
#:   "Ambulance going hell for leather through the intersection, no lifting.",
#:   "The saloon came through the crossing with such a velocity that my passenger only felt the wind and asked me what it had been.",
#:   "Simulate a crossing hatchback whose speed in the intersection is eighty kilometres per hour or above, held without any deceleration.",
#:   "Never assume they'll slow for the junction, Priya; that biker bombed through there as though the side roads didn't exist.",
#:   "\"It was like a plane taking off,\" said the florist, who saw the sports car zip over the crossroads outside her shop.",
#:   "Is it your evidence that the police car was through the intersection in well under a second, travelling at a quite furious rate?",
#:   "mate the crossroads by the chippy, some golf just went straight thru it absolutely caning it, must of been doing 90",
#:   "I have driven that way for forty years and never saw the like. A red car burst out from behind the hedge and was over the junction and gone before I could lift my foot from the pedal.",
#:   "Data from the event recorder put V2 at 71 mph as it entered the intersection and 73 mph as it left. Its driver, 19, told officers he was late for his shift and hadn't noticed the crossroad.",
#:   "She heard it before she saw it, a rising whine from behind the houses. Then the motorcycle was in the crossroads and out of it again, all in one breath, leaving a smell of petrol and a dog barking.",
#:   "The fire truck, it was in a big hurry, I understand this. But he passed the crossing with a speed like on the Autobahn, and our automatic car had nearly no time for seeing him.",
#:   "For the next run, set up crossing traffic that doesn't respect anything. One car, coming at a right angle, goes pedal to the metal over the junction, and the AV should spot early how quickly it is arriving.",
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
