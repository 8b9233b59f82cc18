#: description = "The car in the target lane suddenly brakes."
#: rephrasings = [
#:   "A vehicle in the neighbouring lane slams on the brakes.",
#:   "The adversary ahead decelerates hard and without warning.",
#:   "The car next to the ego performs an emergency stop.",
#:   "The driver in front hits the brake abruptly and blocks the lane.",
#:   "The lorry loses speed sharply and comes to a standstill.",
#:   "The bloke ahead stands on the brakes out of nowhere.",
#:   "Vehicle 2 decelerated suddenly without apparent cause.",
#:   "Target decelerates at 6 m/s² without warning.",
#:   "I was moving over and the motor in the lane I was heading for suddenly hit the brakes",
#:   "As V1 changed lanes, V2, already established in that lane, braked abruptly.",
#:   "Van in lane we want: sudden brk.",
#:   "The vehicle in the destination lane performs a sudden braking during the VUT's lane change.",
#:   "I want to change the lane, and the truck which is there brakes at once.",
#:   "Target-lane NPC should decelerate hard the moment the SUT commits to the merge.",
#:   "They were slipping over into the next lane when the bus that had been leading it jammed on its brakes.",
#:   "You're going for that other lane, mind the bike in there, whoops, his brake light's come on full.",
#:   "was gonna switch lanes and the car there suddenly slams the brakes",
#:   "Just as the teacher was about to move across, a bus in the lane she wanted braked without warning",
#:   "The vehicle occupying the lane you intended to enter slowed violently, is that your account?",
#:   "I want to change lane, the lorry there suddenly e-brake, lucky never go in yet",
#:   "I'm all set to slip over and matey in that lane goes and stamps on it",
#:   "Sudden hard deceleration of traffic in the intended destination lane",
#:   "Bike BRAKE SLAMS in the lane I was moving into",
#:   "The coach in the other lane clamped its wheels.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["brake"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -15.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_BRAKE = Range(0.4, 1)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
