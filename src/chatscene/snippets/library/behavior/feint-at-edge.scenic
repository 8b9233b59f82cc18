#: description = "The motorcyclist pretends to cross the road but brakes abruptly at its edge."
#: rephrasings = [
#:   "The rider lunges toward the carriageway and pulls up hard at the kerb.",
#:   "A motorbike feigns entering the street, then slams on the brakes at the border of the lane.",
#:   "The cyclist makes as if to go over and stops dead at the roadside.",
#:   "The adversary starts out as though it would cross and brakes sharply before the lane.",
#:   "The pedestrian runs at the road and stops short at the edge, confusing the ego.",
#:   "A fake crossing: it darts forward and halts at the very margin of the roadway.",
#:   "He makes out he's coming across and then pulls up short, the joker.",
#:   "The motorcyclist approached the edge of the roadway rapidly and stopped before entering the lane.",
#:   "lad on a pushbike made as if to come straight out, then slammed on at the edge, gave me a heart attack",
#:   "The pedestrian moved quickly toward the roadway as though to enter, then halted at the curb and did not step off.",
#:   "Cyclist rides at rd edge as if X-ing, stops dead at kerb. Never enters.",
#:   "The VRU target approaches the carriageway on a crossing trajectory and comes to a stop before the lane boundary (false positive test).",
#:   "The boy runs to the road, I think he will go, but he stops on the border and does not go.",
#:   "False alarm case: the scooter heads for our lane and brakes at the last moment; it never leaves the verge.",
#:   "She had run right up to the gutter as if to fling herself over, and there she checked and stayed.",
#:   "He's bluffing, look: charges up to the kerb like he's coming out, then on with the brakes and stays put.",
#:   "kid totally faked us out, ran at the road then stopped right at the edge haha",
#:   "A cyclist who seemed certain to dash out thought better of it at the very brink, to a driver's relief",
#:   "He made a show of crossing, your honour, yet his wheels never left the verge",
#:   "The scooter fellow acted like he will cross, but at the footpath edge itself he put brake, simply scaring us",
#:   "He shapes up to come out like a winger selling a dummy, then stops dead at the gutter",
#:   "Aborted crossing intention; road user arrests before lane boundary, spurious hazard",
#:   "Fake-out! Pedestrian charges the road and stops at the line",
#:   "The biker bluffed a crossing and balked at the brink.",
#:   "Scooter, mock charge at the road, anchored on the kerb line.",
#:   "Please simulate a pedestrian who threatens to step out but brakes himself at the edge.",
#:   "Psych! Boy sprints for the street, toes on the gutter, doesn't go.",
#:   "Bike fella dummied me, pulled both levers right on the verge.",
#:   "El chico, he makes like he will pass, stops hard before the road.",
#:   "A woman with a pram came at the road with such resolve that I stood on my brakes, only for her to haul herself back at the gutter.",
#:   "Bluff test: the powered two-wheeler moves towards the path of the VUT at 10 km/h and is arrested 0.5 m short of the carriageway boundary.",
#:   "I must have aged ten years when that moped rolled out of the alley as though for the far side and then dug in its front tyre at the kerbstone.",
#:   "Was it not the case that the cyclist gave every appearance of coming over, and yet his wheel came to a dead halt on the shoulder, outside the lane?",
#:   "Nothing happened in the end, because the jogger, who had looked certain to go over, threw out his arms and checked himself with his toecaps at the edging stones.",
#:   "Here's a prankster on a dirt bike. He aims it at your lane, gives it a rev, and then grabs the brake so he's left teetering on the brink, grinning.",
#:   "The robotaxi slowed needlessly, and I'll tell you why. A youth by the bus shelter set off towards the road with his head down like a man committed to crossing, and then stuck his heels in at the drain cover. He was never actually in our lane.",
#:   "I am seventy-nine and my nerves are not what they were. A young lady on a bicycle shot down the garden path straight for the road, and I was sure she was coming over, but she clamped on her brakes and drew up sharply with her front tyre still on the grass.",
#:   "Ticket 2291: the predictor assigned 0.94 crossing probability to a motorcyclist. He approached the road perpendicular to us from a farm track, clearly selling a crossing, then decelerated violently and held at the edge line. Ego emergency-braked for a manoeuvre that was not carried out.",
#:   "Dad says some kids do it for a dare. One ran right up to the road, pretending he'd go to the other side, and when we all yelled he skidded to a halt on the last bit of pavement and just laughed at us.",
#:   "I would like the ego to be tricked. Let a pushbike come quickly out of the park, heading for the lane at right angles as if nothing would stop it, and then have its rider brake so abruptly that it stands at the border of the road, outside our path.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario turning-obstacle; own code"
#: [slots]
#: actions = ["brake", "stop"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.5
#: high = 7.0
#: unit = "m/s"
#: meaning = "how fast it rides at the road"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 2.0
#: high = 16.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 1.4
#: high = 2.3
#: unit = "m"
#: meaning = "how far from the ego's line it comes to rest"

param OPT_ADV_SPEED = Range(3.5, 7)
param OPT_ADV_DISTANCE = Range(2, 16)
param OPT_STOP_DISTANCE = Range(1.4, 2.3)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()
