#: description = "The car ahead bucks and stutters with a failing engine and breaks down in the lane."
#: rephrasings = [
#:   "The old banger in front of us coughs, lurches, coughs again and dies right there.",
#:   "Vehicle 1 exhibited intermittent loss of power, surged several times and became disabled in the roadway.",
#:   "Lead veh engine trouble: jerky throttle, loses drive, dead in lane.",
#:   "The target shows oscillating propulsion followed by a stall in front of the VUT.",
#:   "The motor of the truck ahead is broken, it shakes forward and back and then it remains standing.",
#:   "The bus before us splutters along in fits and finally conks out.",
#:   "A motorbike ahead misfires, hops forward, misfires and gives up the ghost.",
#:   "The driver we follow pumps the gas, the engine catches, fades, and the whole thing is stranded.",
#:   "The old banger in front started coughing and kangarooing, then conked out right there in the lane.",
#:   "The lead vehicle experienced engine trouble, proceeded in jerks and became disabled in the roadway.",
#:   "Lead misfiring, jerky, loses power, dead in lane.",
#:   "The lead target simulates a powertrain failure: surging motion followed by immobilisation in the lane.",
#:   "The car in front has motor problem, jumps jumps and then is broken in the lane.",
#:   "Lead vehicle dies on us: longitudinal surging, then stalls and never restarts.",
#:   "It hiccuped, shuddered, caught again, and then with a last cough gave up the ghost in front of her.",
#:   "Breakdown ahead, he's spluttering along, engine's packing up, and he's going to die in your lane.",
#:   "the car ahead was doing that chug chug chug thing and then it just died",
#:   "An elderly van juddered along on a failing engine before giving up the ghost in the traffic lane.",
#:   "The vehicle in front moved by fits and starts, its motor failing, until it could move no more?",
#:   "Front bus engine was giving trouble, jerking jerking, and finally it went off in the middle of the lane.",
#:   "Hers is spluttering away ahead of me, lurch, lurch, cough, and that's it, kaput.",
#:   "Progressive propulsion failure of lead vehicle ending in disabled vehicle in lane.",
#:   "ENGINE DIES LIVE ON DASHCAM, CAR AHEAD JERKS TO A HALT",
#:   "The truck ahead sputtered, hiccuped and expired.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: vehicle failure; own code"
#: [slots]
#: actions = ["accelerate", "stop"]
#: position = "ahead"
#: leader = false
#: blocker = false
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.4
#: high = 0.8
#: unit = "1"
#: meaning = "how far the pedal is pressed"
#: [[parameters]]
#: name = "OPT_THROTTLE_TIME"
#: low = 0.6
#: high = 1.2
#: unit = "s"
#: meaning = "for how long it presses the pedal"

param OPT_ADV_DISTANCE = Range(0, 30)
param OPT_THROTTLE = Range(0.4, 0.8)
param OPT_THROTTLE_TIME = Range(0.6, 1.2)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, 0.15) for 1.5 seconds
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE) for globalParameters.OPT_THROTTLE_TIME seconds
    do BrakeOnPath(advTrajectory, 0.15) for 1.5 seconds
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE) for 0.6 * globalParameters.OPT_THROTTLE_TIME seconds
    do BrakeOnPath(advTrajectory, 0.15)
