#: description = "The cyclist ahead brakes hard and stops in the lane."
#: rephrasings = [
#:   "The bike in front slams on and stands there.",
#:   "The bicyclist ahead of Vehicle 1 braked abruptly and stopped in the travel lane.",
#:   "cyclist ahead, hard brake, full stop",
#:   "The bicyclist target decelerates at its limit to standstill in front of the VUT.",
#:   "The cyclist before us makes an emergency stop.",
#:   "A bike courier up front yanks the levers and halts dead.",
#:   "Both wheels locked, the lady on the city bike stops before our bumper.",
#:   "The kid on the BMX skids to a halt in our lane.",
#:   "The cyclist in front of me grabbed a fistful of brake and stopped dead.",
#:   "Bicyclist ahead of Unit 1 braked suddenly and came to a halt in the travel lane.",
#:   "Bike ahead, sharp brake, stands in lane.",
#:   "The bicyclist target travelling ahead decelerates strongly to rest and remains in the lane.",
#:   "The bicycle before me brakes strong and stands on the road.",
#:   "Leading bicycle v -> 0 with high decel, stays upright and stays in lane.",
#:   "She had been following the girl on the bike for a street or two when the girl clamped both levers and put her feet down.",
#:   "Pushbike in front's just slammed to a stop in the lane, don't run him over.",
#:   "the bike in front of me just stopped. like full stop. no warning",
#:   "A cyclist came to a sudden halt in front of a following car.",
#:   "The bicycle ahead ceased its progress in an instant and remained where it stood.",
#:   "Cycle uncle in front suddenly brake and stop in the lane, never signal also.",
#:   "Lycra boy in front yanks both levers and stands there, lucky I had my wits about me.",
#:   "Emergency stop of preceding cyclist with standstill in lane",
#:   "CYCLIST SLAMS TO A HALT IN FRONT OF ME",
#:   "The cyclist in front skids to rest.",
#:   "Girl cycling ahead hauls both brakes on, stops, blocks the way.",
#:   "Make the bike in front emergency-stop and remain in the lane.",
#:   "Commuter on a racer, dead ahead: squeal, standstill, no way by.",
#:   "Bike messenger we trailed clamped the discs and stood there.",
#:   "Cyclist stationary before the AV after violent braking, lane obstructed.",
#:   "The tandem in front of us went from twenty to nothing in a couple of metres and stood in the road like a gate.",
#:   "The boy rides his bicycle before my car, abruptly he pulls the two brakes and then he is standing and doesn't go away.",
#:   "When the trigger distance is reached, the preceding pedal cyclist brakes with the maximum possible force and stays at rest ahead of the ego.",
#:   "She's stopped, right there in front of you, see how little warning a cyclist gives when she grabs the levers like that?",
#:   "Because a pigeon flew up, the postman on his bike in front of our car jammed everything on and came to a stand.",
#:   "lad on a fixie ahead of us locks up the back wheel, bike stops, he stops, whole lane stops",
#:   "I had been pottering behind an elderly gentleman on his bicycle since the church. Without so much as a glance behind he squeezed the brakes for all they were worth and planted both shoes on the tarmac right ahead of me.",
#:   "The bicyclist preceded V1 in the same lane at about 12 mph. A loose dog ran out, the bicyclist braked to the limit of traction, and he was standing astride the frame in the lane when V1's operator reacted.",
#:   "From up in my cab you lose a pushbike under the windscreen if he's close. So when that delivery kid in front chucked out the anchors and just stood, I'd no more than a helmet to go by.",
#:   "The little family rode in single file, Mum last, and we rolled along after her. A shoe came off, so she braked so sharply that her basket emptied itself, and she remained there in the middle of our lane, laughing.",
#:   "Requirement for the bicycle scenario: the cyclist rides ahead of the robotaxi on the same line. He makes a panic braking and comes to complete stop. He doesn't move to side, he's not continuing, the lane is closed by him.",
#: ]
#: adversaries = ["bicycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["brake", "stop", "block"]
#: position = "ahead"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 25.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.7
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(0, 25)
param OPT_BRAKE = Range(0.7, 1)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego, 4) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
