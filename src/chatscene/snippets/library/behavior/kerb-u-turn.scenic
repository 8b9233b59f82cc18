#: description = "The parked car pulls out and makes a U-turn across the road."
#: rephrasings = [
#:   "The parked car whips out and does a U-turn right across us.",
#:   "Vehicle 2 departed the curb and attempted a U-turn in front of vehicle 1.",
#:   "Parked veh, U-turn from roadside.",
#:   "The target starts from the parking strip and turns through 180 degrees across the VUT's path.",
#:   "It was parked and turns back on the street in front of us.",
#:   "A taxi at the stand spins round for a fare on the other side.",
#:   "The police car by the roadside wheels about to go after somebody.",
#:   "From his parking spot the biker loops over the whole road and heads back.",
#:   "Bloke parked at the side swung straight out and spun right round over the road without looking.",
#:   "Vehicle 2, parked curbside, pulled away and executed a U-turn across all lanes.",
#:   "Parked cab: off kerb -> 180 across road.",
#:   "The target leaves its kerbside position and immediately turns through 180 degrees across the VUT's path.",
#:   "The parked police car goes out and turns around on the street to other direction.",
#:   "From parked straight into a U-ey: actor sweeps across both directions from the kerb.",
#:   "He'd been sitting at the side; then he heaved the wheel over and brought it all the way about across the street in front of her.",
#:   "Watch him at the kerb, he's leaving his spot and going to flip round the other way right across you.",
#:   "parked car just pulled a uey straight off the curb across everyone",
#:   "A cab left the rank and turned about over the full width of the road, forcing traffic to halt.",
#:   "From a parked position you went directly into a turn that took you to the opposite side facing the other way?",
#:   "The parked lorry came out and straight away made U-turn on the whole road, no patience.",
#:   "Parked one second, facing the other way the next, and me with my foot through the floor.",
#:   "Full-width turnaround by vehicle departing kerbside position.",
#:   "PARKED CAR PULLS INSTANT U-TURN ACROSS TRAFFIC",
#:   "The parked motorbike looped from the kerb to face the other way.",
#: ]
#: adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: making a U-turn; own code"
#: [slots]
#: actions = ["pull-out", "u-turn"]
#: side = "right"
#: position = "kerb"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 14.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.5
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it turns round"
#: [[parameters]]
#: name = "OPT_TURN_RADIUS"
#: low = 6.0
#: high = 7.0
#: unit = "m"
#: meaning = "the radius of its turn"

param OPT_ADV_DISTANCE = Range(14, 30)
param OPT_ADV_SPEED = Range(2.5, 4)
param OPT_TURN_RADIUS = Range(6, 7)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 4) for 0.4 seconds
    do TurnOff(3.1, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_TURN_RADIUS)
    do MoveAhead(6)
