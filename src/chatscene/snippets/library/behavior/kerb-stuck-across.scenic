#: description = "The parked car swings out to turn round and gets stuck across the ego's lane."
#: rephrasings = [
#:   "The parked van tries to turn round, can't make it and sits right across us.",
#:   "Vehicle 2 left the curb in a turning movement and came to rest across the lane of vehicle 1.",
#:   "Parked veh starts U-turn, stops crosswise.",
#:   "The target begins to turn out of the parking strip and comes to standstill transverse to the VUT's path.",
#:   "It wants to turn on the road but it must stop in the cross.",
#:   "A lorry starts a three-point turn from the side and bars everything.",
#:   "The bus swings out hard and jams at right angles to us.",
#:   "Mid-turn from his parking space, the driver loses his nerve and stays put sideways.",
#:   "bloke tried to turn round off the kerb, didn't have the lock for it and ended up wedged sideways over my lane",
#:   "Driver attempted to turn around from a parked position and became stuck perpendicular to the lane, obstructing traffic.",
#:   "Truck from kerb, tries 180, runs out of room, broadside in our lane.",
#:   "A parked target starts a turning-round manoeuvre from the kerb and comes to rest transverse to the VUT's lane.",
#:   "The bus wants to turn around from the parking, but it can not, and now it stands crossways before me.",
#:   "Botched U-turn from the kerbside: actor swings left, halts at ~90° with its flank facing the SUT, never finishes.",
#:   "The lorry had tried to come about from the pavement, and halfway round it jammed, lying over the lane like a fallen tree.",
#:   "Ambulance is trying to spin round from the side of the road, and he's stuck, he's broadside on and he can't get round.",
#:   "the parked lorry tried to turn around and got stuck sideways across our whole lane",
#:   "A driver's bid to turn round from his parking place left his coach lodged side-on over the road",
#:   "Attempting to face the other way, you came to rest sideways with my client's lane wholly shut off?",
#:   "He try to turn round from the parking, cannot make it, stuck horizontal in our lane, everybody wait",
#:   "Wants to spin it round off the kerb, hasn't got the lock, and now he's a gate across my road",
#:   "Failed turn-round of vehicle leaving the kerb; transverse stationary blockage",
#:   "Fire truck tries to turn around from the kerb, gets STUCK SIDEWAYS",
#:   "The parked van slewed about and jammed itself athwart our lane.",
#:   "Cab swung out from the kerb to turn about; now it's jammed sideways.",
#:   "Parked lorry, botched about-turn, stuck broadside over the AV's lane.",
#:   "Tried to U-turn off his parking spot and wedged himself across us.",
#:   "Have the parked minibus attempt a U-turn and end crosswise, unmoving.",
#:   "Police car unparks, slews left to face back, can't complete, plugs our road.",
#:   "We found the lane shut by a bus lying across it, whose driver had set off from the kerb wanting to go back.",
#:   "The camper was parked on the side, he wanted to make the half turn, and he has stayed blocked in the width of the road.",
#:   "From a parked state the vehicle shall steer out fully to reverse its direction and remain immobile, its long side across the ego lane.",
#:   "Oh, he's leaving the kerb and swinging right round, no he isn't, there isn't room, and he's stranded there sideways in your lane.",
#:   "What I saw was a fire engine hauling itself out from the pavement to go the other way and coming to grief halfway, side-on to us.",
#:   "\"It was like a cork in a bottle,\" one commuter said after a parked artic failed to turn round and got trapped over the lane.",
#:   "My husband had parked facing downhill and wished to drive home uphill. He took the car out with the wheel hard over, found the road too narrow, and there he was, lying square over the lane with me waving at people.",
#:   "V2 moved away from the curb in an attempted U-turn. The turning radius was insufficient; V2 came to rest at about a right angle to the roadway and was immobile there, occupying the full width of V1's lane.",
#:   "Ticket: kerbside truck initiates turning in the road, left lock, and freezes mid-manoeuvre with its flank toward us. It doesn't move again. Check that the AV stops short of the side panels, which the lidar sees rather badly.",
#:   "The bin lorry didn't want to go round the block. So he came off the pavement in a big left sweep to point himself the other way, and half round he'd had it, wedged, no forward, no back, me staring at his wheels.",
#:   "In my childhood this street was wider, sir. The ambulance from the kerb was trying to take a round turn for going back side, it did not come, and so it was sitting crossways in our lane like a wall.",
#:   "Parked lorry tries to swing about, jams crosswise, road shut.",
#:   "Half a U-turn off the kerb, then wedged broadside before us.",
#:   "It left the kerb to face the other way and never got round.",
#:   "Nobody's getting past here, control, a coach has pulled off the stand to go back the way it came and it's stuck at right angles over the lane.",
#:   "He was parking at the side, then he wants to turn the car in the other direction, and now he's fixed in the middle like a fish bone.",
#:   "From its place by the pavement the van is to slew hard to the left, as for a turn in the road, and end motionless, crossways, in our lane.",
#:   "The police van lay athwart our lane with both ends near a kerb; it had been parked, and had meant to double back.",
#:   "Ever watched a motorhome come away from the kerb to do an about-turn in a street that's a yard too narrow, and stick there like a barn door?",
#:   "Target departs kerb, turns left through some 90 degrees at low speed, then remains stationary transverse to the lane for the rest of the run.",
#:   "I came over the brow to find a wall across my half of the road, painted with the words \"fresh fish daily\". The wall had been at the kerb that morning. Its driver had wanted to go back to the harbour, had pulled his wheel right round to the left, and hadn't reckoned with how long a lorry is.",
#:   "We heard the power steering groan, on and on. He had eased that long estate of his away from the hedge, wanting to be pointed at the village instead of at us, and it swung and it swung and then there was a crunch of stone. So there he was, side on, like a ship in a canal, and us in front of him.",
#:   "A parking attendant told the local radio that she'd been about to write the ticket. \"He jumped in and went hard over to the left to get away up the street behind him. But it's a fire engine, isn't it, not a Mini. It got to halfway and that was that. They've had the lane closed an hour.\"",
#:   "When the dust settled, V2, previously parked legally at the curb, was situated perpendicular to V1's lane with its front wheels against the median and its rear overhanging the sidewalk. It'd been the intention of its driver to reverse his direction of travel. He was unable to complete the turn, and V1 had no way past.",
#:   "Patience, please, it isn't his first day but it's nearly his first street. What's he up to? He's off the kerb, full left lock, he fancies going home the other way. And will it go? It won't. So we sit, and you look at the side of a milk float, all the length of it, until somebody shunts him out.",
#:   "What I want from this one is a complete blockage that builds up slowly. A parked bus starts off, its front comes left and keeps coming left, as if to turn on the spot, and when it is square over our lane it gets no further. The AV mustn't try the gap behind it; there is none.",
#:   "Auntie was going to the temple and had taken out her car from the roadside. But the temple is behind side, so she cut the steering full left for coming around. Road was small, no? So she is standing there cross-wise, crying, one side drain, other side wall, and our cab in front and fifty people advising.",
#:   "In the end they had to lift it. A parked saloon, a simple saloon, but on the steepest lane in Bristol, and its owner thought she could bring it about from where it stood. The bumper dug into the bank opposite; its wheels spun; and it hung there, right across the lane, at which point our taxi had arrived.",
#:   "They watched it as one watches a bad actor. It came grandly away from the pavement; it wheeled to the left, meaning to show them its back and depart; and with its nose on one side of the lane and its tail on the other it lost the thread. No word came. The ambulance simply stood, sideways, before the audience.",
#:   "Driver's report: was following no one, road clear, sixty yards to go to depot gate. Council van standing at nearside moves off and goes round to left as if to come back at me. Can't have seen the bollards. Finishes up broadside over my lane, tight up against them, and there it stops. Engaged hazard lights.",
#:   "im 9 and i saw it from my window. the pizza car was parked at ours and it wanted to go back to the pizza shop, so it went out and turned and turned and then it coudnt turn any more, it was like a gate shut across the road and a robot car had to wait",
#:   "Off the kerb, hard left, then stranded broadside before us.",
#:   "His half a U-turn became our whole roadblock.",
#:   "Delivery van lodged crosswise: wanted to go back, couldn't.",
#:   "A hundred and eighty degrees he needed; ninety he got, so the saloon that had been parked in front of the chapel is now a fence over our lane.",
#:   "When we drew up its front tyres were against one kerb and its towbar was over the other, and the driver sat with his hands in his lap.",
#:   "Bring the kerbside minibus off its spot on full left lock, as though to head back the other way, and freeze it when it's square over our lane.",
#:   "The lane is shut by an ambulance, lying side-on; he'd been parked at number ten, tried to spin it round to face the bridge, ran out of street.",
#:   "It is, I told the children, what happens if a bus which has been standing by the pavement wants to look behind itself and has a stiff neck.",
#:   "From his parking place the truck is going for the return, all steering to left, but middle of the way it is jamming, and we only see its long side.",
#:   "I've paced it out. From hedge to ditch it's seven metres there, and that estate with its bike rack is seven and a bit. Now do you see why I got home at midnight? He had been drawn up neatly by the hedge, facing my way; he'd had a notion to be facing his own; and I came upon the bit.",
#:   "We could hear him before the bend: the engine up, down, up, tyres scrabbling, and a woman's voice, saying \"left, more left\". Once we were round it there were no headlamps and no tail lamps to be seen, just a door, a number for catering, another door. Where the van had stood by the wall there was a dry patch in the wet. It went nowhere while we watched.",
#:   "Robotaxi control called us at 07:12. One of theirs was at a halt and could give no reason other than \"wall\". It was a fire engine, of course. They'd been stood by the kerb, got a call from the opposite direction, and the lad had hauled the wheel over to bring her about. She fitted the road like a bolt fits its door.",
#:   "It is easily told backwards. At the end there's a recovery truck. Before that, a queue, and before the queue a lorry, motionless, at right angles to everyone, its nose in a privet. Before that you would see the same lorry swing out of its parking place leftwards in order to be gone the way it had come, and the driver's face, hopeful.",
#:   "What we expected was that he would go on swinging. People do turn in that street, and from the pavement too, so our system gave him eight seconds to sweep his front past our lane. The front stopped at the opposite kerbstone, and with it the rest of the taxi, square to us. After forty seconds the planner gave up. So, evidently, had he.",
#:   "My pupil wants to learn how to turn in the road, so I say: watch this gentleman. He leaves the kerb. Good. He has his wheel right round to the left. Good. He hasn't asked himself how long his car is, with the caravan mover and all. That's less good, and so is this, and here we shall be sitting till teatime, looking at a hubcap.",
#:   "V2, a school bus without passengers, was initially parked along the right curb and facing in the same direction as V1. Its operator, having passed his stop, elected to come about. V2 swung left out of the curb space, its front bumper became wedged against a utility pole opposite, and it remained perpendicular to the lane, V1 stopping 15 feet short.",
#:   "The old captain watched from his window. She had slipped her moorings at the grocer's, he noted; she'd put her helm hard over to port, as one would to stand back up the harbour; and amidships of the channel she had taken the ground at both ends. There she lay, a police van, beam on, and the whole of the traffic hove to before her.",
#:   "In our village when someone wants to go home he must turn before the church, because in front of it the street is like a trouser leg. The doctor is new. He started with his car from the church wall, all to the left, he wanted home. And so he's standing as the button in the buttonhole, across, and I with my bread van am the one who waits.",
#:   "My brake lights are what I'd like credit for. Nobody ran into me. Ahead of me was an articulated lorry, not going along the road but going over it, sort of, if it had been going. It'd been parked. I suppose the depot had rung him and told him he was wanted back. He had done the first half, the swing out, and that was all the swing there was.",
#:   "theres 200 of us on this bus n were not moving cos a removal van decided to spin round off the side of the road. google says u cant. u cant. hes across the whole lane like a door n hes just sat there on the phone. guy with a pram cant even get by",
#: ]
#: adversaries = ["car", "truck", "bus", "emergency-vehicle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "turn-left", "stop"]
#: side = "right"
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 28.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_ADV_TURN"
#: low = 0.95
#: high = 1.2
#: unit = "rad"
#: meaning = "how far it turns to the left"

param OPT_ADV_DISTANCE = Range(12, 28)
param OPT_ADV_TURN = Range(0.95, 1.2)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do TurnOff(globalParameters.OPT_ADV_TURN, 3)
    do Halt()
