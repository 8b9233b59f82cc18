#: description = "The parked car shoots out from the kerb and speeds off in the ego's lane."
#: rephrasings = [
#:   "The parked car launches itself out of its space and tears away.",
#:   "Vehicle 2 accelerated rapidly from the curb into the lane of vehicle 1.",
#:   "Parked veh, full throttle, into our lane and gone.",
#:   "The target departs from the parking strip with maximum acceleration in front of the VUT.",
#:   "He was parked and suddenly starts like in a race.",
#:   "A getaway car leaps from the roadside with squealing tyres.",
#:   "The courier kicks his motorbike off the stand and rockets out.",
#:   "From standing at the side, the taxi bursts into our lane and bolts.",
#:   "Some boy racer shot out from where he was parked and tore off down the road ahead of me.",
#:   "Unit 2 left the curb at a high rate of acceleration and continued ahead in Unit 1's lane.",
#:   "Parked MC launches out, full gas, gone down our lane.",
#:   "The parked target departs with strong acceleration into the lane of the test vehicle and continues at increasing speed.",
#:   "Police car stands at the side, then suddenly out and very quick away.",
#:   "Parked actor: hard launch into our lane, keeps pulling away from us.",
#:   "It had seemed asleep by the pavement until it leapt out with squealing tyres and raced away before him.",
#:   "Patrol car's coming off the side like a rocket, let him go, he's already away up the road.",
#:   "car parked on the side just launched out and sped off in front of me like fast n furious",
#:   "A parked sports car burst into the traffic lane and roared off down the street.",
#:   "From a state of rest at the roadside he flung his car into the lane and was away down it at a gallop.",
#:   "Parked bike suddenly came out full throttle and just flew ahead in my lane only.",
#:   "One minute he's parked, next minute he's out and halfway to Brighton with his tyres smoking.",
#:   "Rapid departure of parked vehicle into own lane with continuing acceleration away",
#:   "GETAWAY DRIVER? Parked car BLASTS OFF into my lane",
#:   "The parked motorbike catapults out and streaks off ahead.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "accelerate"]
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 8.0
#: high = 26.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.75
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(8, 26)
param OPT_THROTTLE = Range(0.75, 1)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do ThrottleOnPath(ownLane(egoRoute), globalParameters.OPT_THROTTLE, 0, 12)
