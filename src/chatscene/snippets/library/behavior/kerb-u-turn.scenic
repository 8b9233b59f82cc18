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
#:   "Cabbie leaves the rank and swings round to face the opposite way.",
#:   "Parked truck moves off, does a one-eighty over the road.",
#:   "The motorbike at the kerb starts up, leaves it and circles back.",
#:   "PARKED AMBULANCE SPINS AROUND IN FRONT OF TRAFFIC",
#:   "Roadside departure with immediate about-turn across the carriageway.",
#:   "Simulate a parked estate car that moves away from the side and keeps its wheel hard over until it is heading where we came from.",
#:   "A police car that had been lurking in a lay-by came out and turned tail across the whole road, just as we were arriving.",
#:   "The parked vehicle shall leave the kerb ahead of the VUT and, in one continuous arc, reverse its direction of travel across both lanes.",
#:   "Without so much as a glance over her shoulder she drove off from outside the bakery and turned her little car about in the street before me.",
#:   "The van which was standing on the right border is starting and does a half-turn on all the road, to go in the inverse direction.",
#:   "The lorry no longer stood by the kerb; it was swinging its great length out and round across us, to go off the other way.",
#:   "As I came up the high street a parked SUV started to move out from the left with no signal. I thought he'd join the queue like anybody else. He carried right on turning, over my lane and the opposite one, until he was pointing back towards town.",
#:   "Claimant's vehicle was travelling at 25 mph when the defendant's van, theretofore stationary at the roadside, moved off. It did not merge with the traffic but described a full half circle across the road, so as to drive away in the direction from which the claimant was coming.",
#:   "On my commute there's a spot where the dispatch riders wait, parked up by the sandwich shop. Today one of them got a job, fired up, pulled out and flipped round right across my wheel, so as to head for the other end of the street.",
#:   "We need a parked actor for the kerb suite. Trigger when the ego is near; it drives out of its bay and goes straight into a tight turn of 180 degrees that takes it through our lane, then leaves on the opposite side of the road.",
#:   "What you did there was right. You saw the front wheels of that parked taxi begin to move and you covered the brake; because he wasn't just moving off, was he, he was turning the whole thing round over both sides of the road.",
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
