#: description = "The emergency vehicle threads its way past the ego, swinging from side to side."
#: rephrasings = [
#:   "The ambulance zigzags through and past us.",
#:   "The emergency vehicle maneuvered left and right while passing vehicle 1.",
#:   "EMS snakes by, overtaking.",
#:   "The emergency vehicle overtakes the VUT with lateral oscillations.",
#:   "The police goes left and right between the cars and passes.",
#:   "A fire engine sways by with its siren on, nudging at our side.",
#:   "Paramedics slalom past everybody, us included.",
#:   "A patrol car in pursuit whips to and fro and gets ahead.",
#:   "A fire engine came slaloming through the traffic with its siren on and wriggled past me.",
#:   "The responding squad car negotiated traffic in a zigzag fashion as it went around Unit 1.",
#:   "Amb. on blue lights snaking L-R-L, gets by ego.",
#:   "The emergency vehicle target passes the VUT while executing repeated alternating lateral displacements.",
#:   "The ambulance with siren goes zig-zag and passes me, left and right and left.",
#:   "EV doesn't hold a lane while passing: sways left-right-left through gaps around us, lights on.",
#:   "It came up with its lights whirling, jinked one way, jinked the other, and somehow squirmed by her.",
#:   "Medic unit is picking its way round you, ducking left and right, so keep dead straight and predictable.",
#:   "cop car was zigzagging round everyone and squeezed by me, actual GTA",
#:   "An ambulance picked a crooked path around queueing motorists, tacking left and right to get ahead.",
#:   "The ambulance did not pass in a straight line, did it; it went first to one side and then the other until it was by?",
#:   "Fire engine was going left right left right in between and somehow got past me.",
#:   "Ambulance is dancing round the lot of us like a needle through cloth, finally squirms by me.",
#:   "Serpentine passing of ego by emergency vehicle on active response.",
#:   "AMBULANCE SLALOMS PAST ME IN TRAFFIC",
#:   "The siren-blaring patrol car snaked around us.",
#:   "Fire crew zigzagged by us, all lights going",
#:   "Police motorcycle, sirens on, wriggles through and leaves us behind.",
#:   "Have an ambulance overtake the ego on a snaking course.",
#:   "The nee-naw car went wibbly wobbly all the way past our car!",
#:   "Blue-light unit passes SV in slalom fashion, next lane.",
#:   "From behind came a paramedic's car, beacons flashing, lurching left and right in the neighbouring lane, and in that manner it got ahead of us.",
#:   "Test case: the emergency vehicle draws alongside from the rear and goes by the vehicle under test on a sinusoidal track, without ever settling on a straight course.",
#:   "I heard the siren and there was this rescue van tacking its way up to us and then on ahead, never two seconds on one line.",
#:   "When a patrol car wriggles up past you like that, swinging one way and then the other, hold steady and let it find its way.",
#:   "La police elle me double, but not in straight, she makes some zigzags next to my car until she is before me.",
#:   "The court will see an ambulance meandering quickly from one edge of its lane to the other as it draws level with the taxi and leaves it behind.",
#:   "The noise came first, then the lights in every window. The appliance was bigger than I expected and it was not driving straight at all; it swung out, swung in, swung out again, and like that it worked its way by my little Micra.",
#:   "I was on my bicycle at the kerb, so I saw it properly. The squad car came up beside the grey SUV, rocking from side to side like a skier between the gates, and it was ahead of it and gone before the driver had even looked round.",
#:   "For our perception stack the nasty bit is the lateral motion. An emergency vehicle approaches from the rear in the adjoining lane, and while it overtakes the AV it sweeps rhythmically to either side, so the tracker keeps predicting a cut-in that never happens.",
#:   "Ever see a fire truck do the cha-cha? This one did, right next to us, one step left and one step right with the air horn blaring, and when the dance was done it was in front and we were looking at its ladder.",
#:   "V2, an ambulance with warning devices active, came up in the lane next to V1. It followed a serpentine course through the traffic and in doing so passed V1, the occupants of which reported being startled by its swaying.",
#:   "Fire engine jinks its way by us, port, starboard, port.",
#:   "Ambulance got round me on a squiggle, blues going all the while",
#:   "Siren, wobbling headlights, then a paramedic bike meandering past our flank.",
#:   "Never on one line for two seconds, the patrol car came up along our side and wound its way on ahead.",
#:   "Blue-light unit gaining on your offside, driving in curves through the traffic, will be by you in a moment and then ahead.",
#:   "The emergency vehicle target shall pull ahead of the VUT from the rear, following a sinusoid of half a metre amplitude in the adjoining lane all the while.",
#:   "I request an ambulance which comes up from behind next to the robotaxi and gets in front of it along a wriggling track.",
#:   "With its horn it came, the firemen's car, and how a drunken man it danced left-right-left beside us until we saw only its back.",
#:   "V2, displaying emergency lights, passed V1 in the adjacent lane whilst continually altering its lateral position from one side to the other.",
#:   "I pulled my elbow in, as if that would help. In the side mirror the ambulance was first all there, then half there, then all there again, for it was swinging about to get through; then it swung past my door, and I watched its rear doors sway off up the road.",
#:   "Nobody told the fire crew to drive straight, I suppose. They came up from behind us in the other lane, dodging drain covers or parked bikes or goodness knows what, over a bit, back a bit, over a bit, and in that fashion they gradually left us behind.",
#:   "It was the wake that rocked us. A big red appliance had drawn up beside our little car and swept by, and because it was swerving to and fro as it did so the draught hit us three times over rather than once.",
#:   "Radar track 7 overtakes the ego in the left-hand lane with emergency lights on. Its lateral offset looks like a heartbeat: out, in, out, in, all through the pass and for as long afterwards as we could follow it. No cut-in occurs.",
#:   "The officer conceded, under questioning, that he hadn't held a steady course when he went by the defendant's taxi. The traffic, he said, obliged him to wind in and out; he had tacked to each side in turn until he was clear and in front.",
#:   "Stay where you are, both hands on the wheel. That police car's coming up on your right like a slalom skier, leaning one way and the other, and all it wants is to get ahead of you; there, it's through, so carry on as you were.",
#:   "At the bus stop we all turned our heads. Down the avenue a rescue truck was gaining on a silver car, and it did so by fits of steering, a lunge to the left, a lunge to the right, its ladder swaying on top, till the silver car was behind it.",
#:   "Ambulance driver here. People ask why we don't go by in a straight line: because of you lot, you all pick a different way to dodge. So I snake, left a touch, right a touch, all the way up alongside and all the way past, and hope you hold still.",
#:   "The noise grew behind me, ee-aw, ee-aw, and I froze. Past my window, in great swooping curves like somebody icing a cake, went a police van; by the time I had remembered to breathe, it was far in front and still writing its S's on the road.",
#:   "Passing sequence, as recorded: unit with beacons appears at the rear in the next lane at 11:03:20. It goes by the subject vehicle between :24 and :27, its roll angle alternating throughout because the driver is constantly steering to and fro.",
#:   "I thought the ambulance was going to swap paint with me each time it leaned over. It never did; it leaned away again, and in, and away, with all its bells ringing, while bit by bit it moved up from my back wheel to my front and out ahead.",
#:   "Siren behind, siren abreast, siren ahead, and never in a straight line.",
#:   "Ambulance drew swirls up the lane beside us till it led.",
#:   "Blue flashes swung in, swung out, and were ahead of us.",
#:   "A fire appliance came by on our left with its tail wagging, hunting its way round God knows what, and finished up in front still wagging.",
#:   "Let a police van come from the rear in the neighbouring lane and go by the ego on a wavy course, swaying out and back all along its length.",
#:   "It left a track like a ribbon on the wet road, that patrol car, curving to and fro in the lane next to ours from well behind us to far in front.",
#:   "Unit with beacons is coming up your right, it's lolling from one line to the other as it comes, and it'll still be doing that when it's in front.",
#:   "V2, an ambulance under lights and siren, was gaining on V1 in the adjacent lane along an undulating course and, without steadying, drew clear of it.",
#:   "The fireman car, he made beside me like a slalom man on the skis, curve here, curve there, and so he was before me and away.",
#:   "The lights came round our ceiling in the oddest way, now bright on the left, now hardly there, now bright again. I looked across. A police estate was level with us in the next lane and couldn't keep still, it dipped away from us and back towards us, and so, dipping, it forged ahead.",
#:   "I counted its leans. Two while the ambulance was still behind my shoulder, one when it was beside me and I could see the paramedic hanging on to a strap, and another three by the time that it was so far up the road that I couldn't hear it. It never used one bit of lane for long.",
#:   "Nobody need move over for this one, that's what the memo says. The appliance keeps to the lane alongside and gets ahead of the subject vehicle there. But its path isn't a line, it is a wave of half a metre either way, and our tracker raised \"possible cut-in\" at each crest. None ever came.",
#:   "He's got cones and potholes to dodge, I dare say, or he's just that sort of a driver. Anyway the paramedic's car is at your back wheel, swinging out; at your door, swinging in; at your front wheel, swinging out; and now it's well in front, and you can let your breath go.",
#:   "My wing mirror told the whole story, sir. The motorbike with the blue lamp was in it, then it wasn't, then it was, because the officer kept tilting off to one side and the other. When it wasn't in it for the third time it was in front of my windscreen, still tilting, one lane over.",
#:   "Mrs Hale remembers that her shopping fell to the left, though her own car went straight. It was fright, nothing more; she had ducked. The fire engine in the next lane was bowing towards her roof and away again like a tall ship, all the while creeping up beside her and then beyond.",
#:   "You get used to sirens on a pushbike, they mean get in. But I'd never seen one drive like that. Past the car that was next to me it went, in the outer lane, as if it was being tugged by a string from either side in turn, left, right, left, and the faster the tugs the farther ahead it got.",
#:   "Exhibit C is a still from the dashboard. The ambulance is askew in it, pointing somewhat at the van, and the prosecution asked us to think the worst. Exhibits B and D show it pointing away. It was threading its way up and past in the next lane, and it pointed in both directions by turns.",
#:   "How does one overtake without driving straight? Like a needle. A rescue truck did it to us on the boulevard; it came up along our side in bends, a small one outwards, a small one inwards, and at the end of all these bends, with the siren wailing in and out as well, it was in front.",
#:   "Old Peters, who had driven a milk float, held the wheel dead steady, and that was the right thing. The din grew at his elbow. Something vast and scarlet rocked along by him, toward, away, toward, away, and rocked on up the hill in front, until he saw only its lamp, swinging like a lantern on a cart.",
#:   "In our traffic straight line is not existing, even for ambulance. It came from behind in side lane, ooo-waa ooo-waa, little left because of scooter, little right because of cow, little left again, and in this dancing style only it went ahead of my car, and still dancing I saw it go.",
#: ]
#: adversaries = ["emergency-vehicle"]
#: requires = ["advLane"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["overtake", "weave"]
#: position = "behind-beside"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 12.0
#: high = 15.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 0.8
#: high = 1.5
#: unit = "m"
#: meaning = "how far it swings to either side"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 2.6
#: high = 3.6
#: unit = "s"
#: meaning = "how long a full swing takes"

param OPT_ADV_SPEED = Range(12, 15)
param OPT_ADV_AMPLITUDE = Range(0.8, 1.5)
param OPT_ADV_PERIOD = Range(2.6, 3.6)

behavior AdvBehavior():
    do WeaveOnPath(advLane, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD)
