#: description = "The car goes through the intersection in bursts of throttle and brake."
#: rephrasings = [
#:   "A vehicle crosses the junction with a pace that keeps rising and falling.",
#:   "The adversary accelerates, brakes, and accelerates again on the crossroads.",
#:   "The crossing driver cannot settle on a speed.",
#:   "Jerking forward and checking itself, the car passes before the ego.",
#:   "The other car alternates gas and brake while it crosses.",
#:   "gas, brake, gas, brake, he can't get across in one go",
#:   "Vehicle 2 alternately accelerated and braked while crossing.",
#:   "The target traverses the junction with repeated phases of acceleration and deceleration.",
#:   "He kangarooed through the crossroads, on and off the gas like a learner.",
#:   "Unit 2 passed through the intersection in a jerky manner, alternately speeding up and braking.",
#:   "Moto thru junction: gas, brake, gas, brake.",
#:   "The target vehicle traverses the junction with alternating acceleration and deceleration phases.",
#:   "The car goes in the crossing fast, brakes, fast again, brakes again.",
#:   "Longitudinal sawtooth profile while clearing the box; path itself is straight.",
#:   "It came on in leaps, lunging and checking and lunging again until it was over.",
#:   "Look at him bunny-hopping across the junction, foot down, foot off, you can't read him.",
#:   "he was going thru the intersection like vroom stop vroom stop, made me carsick just watching",
#:   "A motorcyclist went over the crossroads by fits of speed and braking.",
#:   "His progress through the intersection was spasmodic: now pressing on, now checking, now pressing on again.",
#:   "Jerk jerk he is crossing the signal, one second race, one second brake.",
#:   "Somebody teach him what his feet are for: gas, brake, gas, brake, the whole width of the junction.",
#:   "Pulsating longitudinal speed of vehicle throughout the intersection",
#:   "LEARNER? Car HICCUPS its way through the junction",
#:   "The car stutters through the crossing in spurts.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["accelerate", "brake"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 1.0
#: high = 2.0
#: unit = "s"
#: meaning = "how long each phase lasts"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_THROTTLE = Range(0.6, 1)
param OPT_BRAKE = Range(0.4, 1)
param OPT_ADV_PERIOD = Range(1, 2)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    while True:
        do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE) for globalParameters.OPT_ADV_PERIOD seconds
        do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) for 0.5 * globalParameters.OPT_ADV_PERIOD seconds
