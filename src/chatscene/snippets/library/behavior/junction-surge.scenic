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
#:   "On-off, on-off with the throttle all the way over the crossroads.",
#:   "Car crosses box lurching: spurt, check, spurt, check.",
#:   "Biker revs, brakes, revs, brakes till he's through the intersection.",
#:   "Make the hatchback pulse between gas and brake while crossing.",
#:   "The taxi went over the junction nodding like a rocking horse.",
#:   "A pupil with two left feet is crossing ahead of us, and every dab of accelerator is followed by a dab of brake until she's over.",
#:   "Within the intersection the crossing vehicle's longitudinal command shall alternate periodically between positive drive torque and service braking, without its path being altered.",
#:   "hed put on a burst of speed loose his nerve and slow, put on another burst lose it again, thats how the saloon got accross the junction",
#:   "Investigators noted several short acceleration marks and several short skid marks left by V2 within the intersection, one after the other in regular turn.",
#:   "I want a motorbike coming over the crossroads with a surging speed, now twisting the grip, now squeezing the lever, over and over till it's out.",
#:   "Driver is giving race, then pressing brake, then again race, again brake, like this only he has passed the whole crossing in front of me.",
#:   "I could see the passenger's head being thrown back and forward. The little Fiat was coming over the junction from the side, and whoever drove it kept stamping first on one pedal and then on the other, so you couldn't tell when it would be gone.",
#:   "Because the speed of the crossing car rises for a second, falls for half a second and rises again for as long as it is in the junction, a constant-velocity prediction is wrong each time, and the ego must keep its estimate of arrival open.",
#:   "Comment from the cammer: no idea what was up with the bloke on the Yamaha. He comes through the crossroads in hiccups, big handful, grab of brake, big handful, grab of brake, and I'm just sitting there with my foot hovering thinking make your mind up pal.",
#:   "She had never driven the thing before, and it showed. It bounded into the crossing, was reined in, bounded again and was again reined in, and so by leaps and checks it got itself past the bonnet of our waiting car.",
#:   "Claim ref 88-102. The other motorist traversed the crossroads unevenly, pressing the accelerator and the brake in turns a good five times, with the result that our policyholder could not judge whether to wait or to proceed. No constant speed was kept at any moment.",
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
