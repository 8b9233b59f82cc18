#: description = "The car turns left from the lane beside and crosses right in front of the ego."
#: rephrasings = [
#:   "From the lane on our right he hooks left straight across our bonnet.",
#:   "Vehicle 2 attempted a left turn from the right-hand lane and crossed the path of vehicle 1.",
#:   "Left turn from wrong lane, cuts across us.",
#:   "The target turns left out of the adjacent lane through the path of the VUT.",
#:   "It turns to left but it was on right of us, so it passes before our nose.",
#:   "The taxi next to us spots an address opposite and swings over us.",
#:   "A truck in the outer lane lumbers left across everybody.",
#:   "A scooter on the kerbside lane veers over in front of us to the far side.",
#:   "The car next to me decided he wanted the left turn and just swung clean across my bonnet.",
#:   "Unit 2 executed an improper left turn from the right-hand lane, crossing the path of Unit 1 proceeding straight.",
#:   "Pickup in adj lane hooks L through ego's path; wrong lane for turn.",
#:   "Target positioned in the neighbouring lane initiates a left turn that traverses the path of the VUT.",
#:   "A car at my side turns to left and goes directly before me, he should not turn from that lane.",
#:   "Side-lane vehicle does an illegal left from the wrong lane, T-boning geometry straight in front of us.",
#:   "They were rolling along side by side when he hauled his bike round to the left, straight over her road and off down the turning.",
#:   "That fellow on your right wants to go left from the wrong lane, and he's turning right across us to do it.",
#:   "car in the other lane just decided to go left THROUGH me basically",
#:   "The taxi swung left out of the wrong lane and passed directly under the nose of the car travelling with it.",
#:   "So from the neighbouring lane, without first joining hers, you turned to the left in front of my client?",
#:   "He is in the side lane only, and suddenly takes left turn from there, full blocking my way.",
#:   "Muppet on my flank wants to go left, so he goes left. Never mind that I'm in between.",
#:   "Left turn from neighbouring lane conflicting with ego's straight path.",
#:   "WRONG LANE LEFT TURN RIGHT ACROSS MY HOOD",
#:   "The motorbike alongside scythed left past our front.",
#:   "He was next to me and took a left over my nose!",
#:   "Simulate a lorry hanging a left from the neighbouring lane, through the ego's path.",
#:   "Cab alongside, no business turning left from there, went across our bows anyway.",
#:   "Bloke in the outer lane turned left right in front of us",
#:   "Adjacent-lane left-turner sweeps over the trajectory of the subject vehicle.",
#:   "Both vehicles were travelling in parallel until the van to our right made a left-hand turn, sweeping over our lane just in front of the bumper.",
#:   "Let the pickup travel on the ego's right and then have it peel off to the left so that it shaves past the ego's front end.",
#:   "A fire engine took its left turn out of the lane beside the robotaxi, putting its whole length across the way the robotaxi was going.",
#:   "Why would anybody drive on my right-hand side and then steer to the left-hand road, passing crosswise before my bonnet?",
#:   "The motorcycle had left our right flank and was already disappearing into the side road on the left, having sliced over our lane with a metre or two to spare.",
#:   "Driver of the lorry was in lane next to mine, then he take the left street and his trailer pass across my front.",
#:   "The accident happened because the other party noticed his exit too late. He was running level with us in the next lane over, and instead of carrying on he hauled it to the left, right over our lane, to reach the side street.",
#:   "Scenario description: the target vehicle travels in the same direction as the VUT, in the lane to its right. At the trigger point it executes a left turn, whereby it passes transversely in front of the VUT and leaves the roadway on the far side.",
#:   "You know when your sat nav shouts too late? I reckon that's what did it. The woman in the Fiesta to my right suddenly went for the left-hand road, never mind that I was sitting in the lane she had to cross.",
#:   "Keep an eye on vehicles level with you, especially ones slowing a bit as if hunting for an address. This van on our right has just chucked a left through your lane, and had you been daydreaming you would have gone into his door.",
#:   "I drive an artic for a living, and what I saw from the cab was plain stupid. A motorbike on the car's right flank banked over to the left and shot across its front wheels into the side road.",
#:   "Bike on our flank peels left, clean over our front number plate.",
#:   "Wrong-lane left by squad car alongside, straight across the robotaxi's nose.",
#:   "he had no business going left from out there, I was in the way",
#:   "The truck abreast of V1 initiated a left turn from the outer lane and traversed the lane of V1 immediately forward of its front bumper.",
#:   "Children screamed on the pavement when a furniture lorry, instead of carrying on next to the taxi, bore left over the taxi's lane into Elm Grove.",
#:   "He should be sorted in the left row if he wishes to go left; instead, from the row beside me, he drew a line before my radiator.",
#:   "Let the ambulance run abreast on the right, and when the side street comes have it take that street by carving left through the lane the ego is in.",
#:   "Two hundred yards on there's a left, and that motorbike to your right wants it, so be ready for him to sweep over your bows and vanish up it.",
#:   "While keeping company with the VUT in the neighbouring lane, the target yaws to the left and passes transversely ahead of the VUT to leave the carriageway.",
#:   "My passenger had her hand on the radio. I remember that because the next thing she touched was the dashboard, when the pickup that had been sitting by her window all along hauled itself to the left, filled the windscreen from one side to the other and was off down the lane to the quarry.",
#:   "For a moment I was looking straight at the writing on the side of a removal van: name, telephone number, all of it travelling from right to left. It had been driving level with me in the next lane, and it wanted Station Road, which is on the left.",
#:   "Our damage is confined to the front corner. The other vehicle, which had been keeping pace one lane to our right, decided on a left-hand street that could only be reached through us, and its rear door caught our bumper as it went over.",
#:   "From the saddle behind them I could see it coming. The fellow in the Octavia kept craning his neck at street names on the far left, though there was a whole lane with a car in it between him and them, and at Quay Street he just took it, through the other one's bonnet space.",
#:   "Well, your honour, I had a lane to myself and she had hers. She informed the constable afterwards that her husband had said left, so left she went, from where she was, across where I was, and only my brakes kept us from meeting.",
#:   "The fire engine was level with the AV's front door with nothing to suggest it would do anything but keep straight. Then its long red flank came round, the whole appliance lay crosswise before the bonnet, and finally the tailboard slipped out of view into the left-hand side street.",
#:   "Bug or feature? Actor spawns in the lane to our right, holds the same pace, and at the mouth of the left side road it performs a full left turn from there. Its path and ours intersect about four metres in front of our bumper, which is just what I wanted.",
#:   "In my country also people forget their exit, but they make then a round. This motorcycle man rode at the right of me, and because his street was at the left he bent himself over and passed transversal before my wheels to go in there.",
#:   "Left turns are made from the left lane, I tell every pupil, and here's why. The woman who was tootling along on the right of us remembered her dentist, swung the Polo round to the left, and for a second we had her passenger door where our road should have been.",
#:   "The last thing I expected to need was the brake, seeing there was no one ahead. But the cabbie one lane over got hailed by somebody at the corner to our left and cut the corner off through my lane, so that he was already up the side street by the time I'd stopped swearing.",
#:   "It is a pity, wrote the reader from Hove, that lane arrows are treated as decoration. On Friday a minibus in the straight-on lane next to hers took the left turning all the same, slicing over in front of her so near that she could see her own headlamps on its doors.",
#:   "Its left-hand road was on our far side, so through our lane it went.",
#:   "Motorbike off our right shoulder now crosswise ahead, bound for the left-hand street.",
#:   "The artic one lane right just made a left through our front yard.",
#:   "Nobody had told the driver of the van on our right that lefts are taken from the left; it came round across us and went off down Mill Street.",
#:   "Have the police car hold a place in the lane to the right, slightly in front, and then take the street on the left, its flank passing square across the ego's bonnet.",
#:   "The last I saw of the cab was its right rear lamp going into the alley on our left; a second earlier it had been in the lane to my right.",
#:   "In lane two, a bit ahead of you, a pickup with a left-hand address; he's bringing it round across your front to get there, so let him go through.",
#:   "V2, occupying the lane to the right of V1, commenced a left-hand turning movement and, in traversing V1's lane at close range, departed via the west leg.",
#:   "She was going my way in the next row on the right, and for reaching the street at my left hand she drew a curve directly before my headlights.",
#:   "My sat nav and hers must have disagreed. Mine said straight on. Hers, in the lane to the right of me and half a car ahead, said left, I suppose, because I was suddenly shown the whole side of a Skoda from front lamp to back lamp, gliding across my windscreen towards the street by the bank.",
#:   "We had to stop so hard that the seat belts locked, and it was for something that had been no business of ours until then. It was in its own lane, on our right. But the bakery it was after stood up a street on the left, and the shortest way there was over the strip just before our bumper.",
#:   "The paint on the crash barrier isn't from us. If you follow the tyre marks back from the left-hand slip they run at an angle clean over our lane, not three metres from where we stopped, and they begin in the lane on the right of it. That's where the lorry had been.",
#:   "I asked my pupil which way the motorcycle would go. Straight, she said, since he's in the right-hand lane. Fair answer. Now look, we've stopped, he's leaning over to the left, there's his number plate sliding past our bonnet from right to left, and that's him away up the side road. So never assume.",
#:   "Fault report: crossing conflict from same-direction traffic. The agent runs parallel to the ego, one lane to the right and five metres in front. Before the junction its heading starts to rotate anticlockwise, it intersects our lane at roughly ninety degrees and leaves by the road on our left, all without ever having joined our lane.",
#:   "Whose idea was it to send the engine to Elm Road by that route? The crew was rolling along with us on the right. When they noticed they were at Elm Road already, which goes off on the left, they put the whole red length of it over, ladders and all, so that we sat looking at hoses.",
#:   "The traffic was thin and the two vehicles had gone along side by side for some time like strangers on a pavement. Then the one on the right remembered an errand. It bent away leftwards, passed before the other's very nose, and was swallowed by the lane that leads down to the ferry.",
#:   "I'm not being funny, but if you're to the right of me and the retail park's to the left of both of us, there's a queue and I'm in it. She just steered at the retail park. I had her back door, her tyre and her exhaust go by in front of me, in that order.",
#:   "Claim form, box seven. I was in the left lane and the other driver in the right. He was a little ahead of me. He intended to enter the road on the left and did so from where he was, with the result that his nearside panels crossed immediately in front of my car.",
#:   "Why did the passengers all slide forward? Because our robotaxi saw the bus lane's delivery van, to the right of it, start to present its flank. A second on, that flank blocked the lane from line to line; another second and there was only its tail, going down the turning on the left-hand side.",
#:   "On the ring road all people are doing like this. One tempo was on my right side, little bit in front, going straight like me. Then he saw his gully on left hand. Did he come behind me? No. Full across my front he went, and into the gully, with hand saying sorry.",
#: ]
#: adversaries = ["car", "motorcycle", "truck", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute", "rightLane"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "turn-left"]
#: side = "right"
#: leader = false
#: place = "road"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 25.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 7.0
#: high = 14.0
#: unit = "m"
#: meaning = "how far ahead of the ego it stays"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 5.0
#: unit = "m/s"
#: meaning = "how fast it turns"

param OPT_ADV_DISTANCE = Range(0, 25)
param OPT_ADV_AHEAD = Range(7, 14)
param OPT_ADV_SPEED = Range(4, 5)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(rightLane, ego, self) > 5
    do TurnOff(1.2, globalParameters.OPT_ADV_SPEED, 7)
    do MoveAhead(globalParameters.OPT_ADV_SPEED) for 4 seconds
    do Halt()
