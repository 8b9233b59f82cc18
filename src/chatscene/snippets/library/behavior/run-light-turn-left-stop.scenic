#: description = "The crossing car runs the red light, turns left, and stops in the turn."
#: rephrasings = [
#:   "left turn on red and then he just parks it in the middle of the thing",
#:   "Vehicle 2 turned left on a red signal and came to rest before completing the turn.",
#:   "left on red, stops mid-turn",
#:   "The target turns left against the red signal and halts within the junction.",
#:   "The bus makes left turn with red and then it stands in the middle of his turn.",
#:   "A lorry jumps the lights, swings to the left and gets no further.",
#:   "The biker cuts left on red and freezes halfway round.",
#:   "Having ignored the signal, the van bends left and comes to a halt.",
#:   "He ran the red going left and then conked to a halt halfway round the bend.",
#:   "Unit 2 ran the red light, initiated a left turn and came to a stop partway through it.",
#:   "Red, L-turn, stops mid-turn. Stays.",
#:   "The crossing target passes the red signal, begins a left turn and comes to rest before completing it.",
#:   "The car goes with red, turns left and in the middle of the turn he stands.",
#:   "Left-turning red-light violator that freezes in mid-turn and blocks the box.",
#:   "He came through on red, began to swing left, and there, half round, he stuck.",
#:   "He's gone on red, turning left, and now he's stopped halfway through it, you're blocked.",
#:   "turned left on red and then just stopped halfway thru the turn like an npc",
#:   "After ignoring the signal the lorry got midway round its left turn and came to a standstill.",
#:   "You went left against the red, and you did not finish; you came to rest in the midst of the turn?",
#:   "Red light he turned left, then half turn only he stopped there, blocking.",
#:   "Left on the red, if you please, and then he gives up halfway round and sits there.",
#:   "Unfinished left turn on red with stationary vehicle in intersection.",
#:   "TURNS LEFT ON RED THEN JUST STOPS MID TURN",
#:   "The crossing car stole a left on red and stalled in the arc.",
#:   "Crossing taxi violates red, starts round to its left, gets stuck there.",
#:   "Through a red, leftward bend begun, coach comes to rest within it.",
#:   "He don't respect red, he turn on left and in the curve he stop.",
#:   "Motorcycle from side street: jumps red, lefts, stands mid-arc.",
#:   "Please: cross vehicle, red ignored, left turn begun, halted halfway.",
#:   "The van stood with its nose pointing halfway between two streets, having driven out of the side road on red and given up its left turn.",
#:   "An SUV that ought to have been waiting at its red swung out to the left ahead of the robotaxi and, half round, went no farther.",
#:   "Crossing artic, red against him, pulls round left as far as the cab will go, then the whole lot stops in the bend and blocks it.",
#:   "The defendant's motor scooter passed the red signal, was steered into a left-hand turn, and was stationary before that turn had been completed.",
#:   "With the stop signal still burning, a bus came from the side and bent to its left, and in the bend its wheels ceased to turn.",
#:   "After violating red, the crossing vehicle negotiates only part of a left turn: it decelerates and dwells on the turning arc inside the conflict zone.",
#:   "We were the first at the green. From the right a cab shot its red light and turned, to its left, so I expected to see it off down the road ahead. It wasn't to be: in mid-turn it halted, and the passenger and I looked at each other.",
#:   "The incident involved a removals truck on the intersecting street. Facing a red light, its driver nevertheless came on into the junction and began to turn left. Before the truck was straight again it had been brought to a stop, and it was standing diagonally over two lanes.",
#:   "Examiner's note: the candidate dealt calmly with a motorcyclist who, from the crossing road, went over the line on red, leant into a left turn, and then, because something was in his way or he'd stalled, pulled up with his machine still leaning halfway round.",
#:   "A lamp is red, a man is late, and the rest follows. He drove out past it, he laid the wheel over to the left, and in the very waist of the turn he saw what he was doing and stopped, and nothing in the world would make him finish it.",
#:   "anyone else had this at the Kirkgate lights? pickup comes out of the side on a solid red, goes to turn left, i mean he's properly into it, and then he's stopped. not after the turn, IN the turn. sat there like a lemon while we all went amber",
#:   "From the side, red ignored, leftward swing begun, never finished, stationary.",
#:   "Taxi violates red, peels left, dies in the curve.",
#:   "crossing bus goes left thru a red and parks mid turn",
#:   "The motorcyclist had come off the side road on red and was leaning into a left-hander when he pulled up, with the turn no more than half done.",
#:   "Prior to completing its left turn, which it had entered upon against a red signal from the cross street, the vehicle was brought to a lasting stop.",
#:   "Truck out of the side street runs its red, hooks left, and then it's just sitting there halfway round, blocking the whole intersection, wtf man",
#:   "His light's red and he's coming anyway, he's going round to his left, and he's stopped, still bent, so we're not going anywhere for now.",
#:   "In red signal the van from cross road has taken left turn, but in the turning itself he applied brake and stood, full jam.",
#:   "Make the crossing saloon drive past its red, steer into a left turn and remain stopped on the turning arc inside the intersection.",
#:   "They had to come and take it away in the end, which is why I remember how it lay. It was a brewery lorry; it had come from the side on a red, I'd seen that much. It was bound left, for its front wheels still pointed there, but its tail was in one street and its nose in none, and it didn't move again.",
#:   "The green was ours, yet there was no junction to drive into. A coach had swept out of the cross street while its own lamp was red and thrown itself round to its left. Between the beginning of that curve and the end of it the driver had come to a halt, and we looked into a row of astonished faces at an angle.",
#:   "You, at the line, with the red before you, chose to go on, and turned the wheel to your left. Had you then got clear, the claimant would have lost a second and a little temper. But you ceased in the midst of turning and stood there, and that is what she ran into.",
#:   "Scenario RL-7 has three phases for the crossing actor. In the first it passes its stop line during red; in the second it follows a left-turning path into the conflict area; and in the third it brakes on that path to zero and persists there. The ego finds its way shut by a vehicle standing at about forty-five degrees.",
#:   "I blame the phone. I could see it lit up in his hand as he came through from my right with his signal on red, one arm hauling the pickup round to his left. Halfway into that he must've dropped it, because the pickup stopped as it was, skewed, and the top of his head was all I saw of him from then on.",
#:   "Driver of V2 was on the intersecting street and facing a steady red. Driver of V2 entered the intersection and commenced a turn to the left. Driver of V2 stated that, upon seeing V1, he \"froze\", and V2 was at rest with its turn incomplete when V1, on green, skidded to within a foot of it.",
#:   "My nephew's got a tin car whose spring runs down in the middle of a bend, and that's the very thing I thought of. Out of the side street in spite of the red came a little Mini, round to the left it whirred, less and less, and then no more. It stood in the crossing, half turned, and nobody wound it up.",
#:   "What a biker must do in a left bend is look where he wants to go. This one came from the side street, on red already, so he hadn't looked much, and he tipped in to his left. And then he looks at us, doesn't he, and he's stopped, foot down, machine pointing at nobody's road, right in our way.",
#:   "For the passengers: the delay at Hauptplatz has a simple cause. A bus comes from the cross street though he has red, he curves to the left, and in the curve he does not any more continue. He stands now there, oblique, as a closed door, and our car waits before him until he is gone.",
#:   "Diagonals are rare in that part of town, where everything meets at ninety degrees. The van made one. It had slid out of the side street beneath a red light, it had started to write a curve to its left across the paving, and its driver put down the pen before the curve was done; there it rested, pointing between the streets.",
#:   "We'd a green and a clear run, we thought, me and my thirty pallets. Lad on a scooter comes out from the side, red for him, takes a sweeping left, and I'm easing off to let him get on with it. He never got on with it: he came to a stop partway round, both feet on the deck.",
#:   "Red ignored, left begun, wheels still, nose between two streets.",
#:   "Cab skips its red, bends left, and the bend never ends.",
#:   "Crossing biker, on red, lefts halfway and puts his feet down.",
#:   "Its front wheels were pointing left, its lamp behind it was pointing red, and the van itself, askew in the mouth of our road, was pointing nowhere and not going.",
#:   "Crossing car departs on red, takes the left-turn path, brakes on that path to zero before the turn is complete and holds the position.",
#:   "this minivan comes out on a red doing a left, gets like 45 degrees round and just. stays. i can see her eating crisps. still there when i left",
#:   "Red for him, still from the side street he came, left side he folded, and in the fold itself he went off, like toy when the key is over.",
#:   "Stationary at an angle when I reached it, the bus had run its red out of the side street and given up a left-hand turn at about the halfway mark.",
#:   "What you can't do now, green or not, is go, as the artic that broke his red has come to rest with half of a left turn behind him.",
#:   "The curve of its tyre marks is the start of a very decent left, out of the cross street, sweeping. It isn't carried through; there's a pickup at the end of them, parked, so to speak, on its own curve. And the lamp by which it had come out, as the sequence chart shows, had been red for four seconds.",
#:   "A left turn has a beginning, a middle and an end, and I've never had to teach anybody the end. But do look at that lady. She began on red, which is a fault, she has come round out of the side road to the middle, nice and smooth. That's her finished; she isn't moving at all now, she's slantwise over our road, and we'll be here a bit.",
#:   "From my table I see a coach slip the red in the other street, right to left from where I sit, and start to bring his front round towards the fountain, on his left. I look for the bill. When I look up he's exactly where I'd left him, stopped, slanted, and a hire car's standing at his middle door with its hands up.",
#:   "It couldn't be driven round, on account of the angle. If a scooter stands lengthwise it leaves room at the sides, and if it stands crosswise it does so before and behind. This one had come off the side street past a red lamp, heeling into a left-hander, and had been stopped by its rider bang in the middle of that. Whichever way our autonomous shuttle looked, there was scooter.",
#:   "Ticket: crossing vehicle's predicted path extends beyond its actual stop. Signal for its approach is red; it enters regardless; intention \"left\" is recognised correctly from yaw. It brakes to zero at fifty degrees of the ninety. The predictor then continues the arc for it and clears the box, and the ego, on green, starts into a lorry.",
#:   "He'd a cake on the passenger seat and was late for the party, so he took the red. He was coming round to his left out of the side street when it slid, and he clapped on his brakes to save it. He saved it; and there stood he and his estate and the cake, partway round the corner, and nobody else could get to any party.",
#:   "The plaintiff's light was green and her road blocked. What blocked it was a truck, at rest, with its cab in the one street its trailer in the other. That it had been engaged upon a left turn is plain from the angle between the two. That it had no business to be so engaged is plain from the camera, which shows it leaving its stop line under a red.",
#:   "Grandpa saved the newspaper with the picture in. It's a taxi and it's standing cornerwise in the crossing, with nobody able to go. Underneath they wrote that the man had gone through when it was red in his street, and that he was going left. I asked why he didn't go all the way left, and Grandpa said that's what the policeman had asked him.",
#:   "We're number three at the green. You could hear him change down, in the side street, and not stop for his red. You could hear the tyres sing as he pulled that motorbike round to the left. And you could hear them stop singing, much too soon, and him say a word; he was stood there, half turned, with all of us looking.",
#:   "In Graz the tram would have pushed him away. A white delivery car comes over red from the cross street and goes left, but goes only a half left, because then he sees his telephone, or God. He remains in the middle of his curve like in a photo, I've green, I've again green, and the pizza in the back of me becomes cold.",
#:   "It was to be a bold stroke, left while the lamp said no. They saw him come out from between the houses under that red eye; they saw the long car begin to lean. It never straightened. Something in him, or under the bonnet, had failed at the very height of the curve, and there, with its wheels still turned to the left, it stood.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "turn-left", "stop"]
#: control = "signal"
#: position = "crossing"
#: side = "right"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 22.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it turns"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 4.0
#: high = 8.0
#: unit = "m"
#: meaning = "how far beyond where their ways meet it comes to rest"

param OPT_ADV_DISTANCE = Range(0, 22)
param OPT_ADV_SPEED = Range(5, 8)
param OPT_STOP_DISTANCE = Range(4, 8)

advTurn = "left-turn"

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory)
