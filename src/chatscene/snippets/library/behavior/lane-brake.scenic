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
#:   "Taxi in the adjoining lane brakes like it's hit a wall.",
#:   "Out of nowhere the coach drops its anchors.",
#:   "Target-lane lead decelerates at once, hard, no cause given.",
#:   "What did the biker see that made him pull both brakes so violently?",
#:   "NO WARNING: LORRY STOMPS THE BRAKE",
#:   "Make the pickup that occupies the lane we mean to use brake abruptly, as though a child had run out, though there is nobody.",
#:   "I had picked my spot behind the blue van over in that lane when its rear end rose and its speed collapsed.",
#:   "A sharp reduction of speed, without warning and for no apparent reason, was made by the bus in the lane to which the claimant was headed.",
#:   "Behind that truck in the other lane you'd have been all right, only he's gone and clobbered his brake pedal.",
#:   "The camion on the lane where I want to go, he pinches the brakes of one blow, I have no time to understand.",
#:   "Brake lights, tyre smoke, and the sedan in our destination lane had shed half its pace before the AV finished checking its mirrors.",
#:   "The road was dry and empty in front of him, that's what I can't get over. The motorcyclist in the lane beyond had nothing before him for two hundred metres, and yet he squeezed everything he had and the back wheel came off the ground.",
#:   "During the merge assessment, the vehicle holding the lane to be entered applies full service braking at the trigger point. There is no preceding acceleration and no lateral motion; only its velocity falls, rapidly, and the subject vehicle must revise its gap choice.",
#:   "I looked over my shoulder, everything fine, the coach in that lane was a good way up. When I looked forward again it was huge, because in that one second its driver had rammed on the brakes, and there I was with my indicator going.",
#:   "My pupils hate this one. You've chosen your lane, you've chosen the hatchback you're going to follow in it, and then without rhyme or reason that hatchback's nose dips and it's braking for all it's worth. Plan for it, leave yourself a way out.",
#:   "My granddaughter drives and I keep her company. There was a lorry in the lane she fancied, going along quite nicely, and then there came such a screeching from it, for the man had jammed his foot down, and nobody could tell us why he braked.",
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
