#: description = "The oncoming emergency vehicle races down the middle of the road."
#: rephrasings = [
#:   "ambulance with the blues on coming right down the centre line at us",
#:   "An emergency vehicle responding to a call approached at high speed, straddling the centreline.",
#:   "oncoming emergency veh, siren, fast, in the middle",
#:   "An oncoming emergency vehicle on duty passes with an offset toward the lane of the VUT at 45 km/h or more.",
#:   "The fire truck with siren is coming fast in the middle of the two lanes.",
#:   "A fire engine thunders toward us, half on our side.",
#:   "A police car forces its way through the traffic opposite, using a slice of our lane.",
#:   "The ambulance tears along between the lanes and expects us to squeeze over.",
#:   "a fire engine came at me straddling the white line, going hell for leather",
#:   "An ambulance responding at high speed traveled toward V1 along the center of the roadway.",
#:   "Oncoming police on centre line, fast, both sides squeezed.",
#:   "An oncoming emergency vehicle travels at high speed astride the centre line.",
#:   "The ambulance comes from front very fast and goes in the middle of the street.",
#:   "Blue-light NPC opposite direction: lateral offset onto the road centre, high v, doesn't swerve.",
#:   "It had taken the crown of the road for itself and came thundering at them, siren going, with a wheel on either side of the line.",
#:   "Engine's coming towards you right up the middle, going like the clappers; get yourself well in to the side.",
#:   "ambulance absolutely flying at us down the middle of the road aaaa",
#:   "A fire engine took the crown of the road at full tilt, scattering those it met",
#:   "The police car was travelling neither on its side nor on yours but along the centre, and very rapidly?",
#:   "Ambulance from opposite coming full speed in centre of road, everybody please move aside",
#:   "Blues and twos, bang down the white line at me, eighty if he's a day",
#:   "High-speed opposing emergency vehicle occupying the road centre",
#:   "Fire truck SPLITS THE ROAD coming at me full speed",
#:   "The police car bisected the road at full pelt against us.",
#: ]
#: adversaries = ["emergency-vehicle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "fast", "follow"]
#: position = "oncoming"
#: maneuver = "straight"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 12.0
#: high = 17.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.2
#: high = 2.2
#: unit = "m"
#: meaning = "how far towards the ego's side it keeps"

param OPT_ADV_SPEED = Range(12, 17)
param OPT_SWERVE = Range(1.2, 2.2)

behavior AdvBehavior():
    do ThrottleOnPath(advTrajectory, 1, globalParameters.OPT_SWERVE, globalParameters.OPT_ADV_SPEED)
