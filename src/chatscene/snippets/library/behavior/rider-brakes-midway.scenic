#: description = "The cyclist crosses and brakes suddenly in the middle of the intersection, obstructing the ego."
#: rephrasings = [
#:   "A rider comes out, pulls the brakes hard, and stays in the ego's path.",
#:   "The cyclist stops abruptly halfway over and gets off the bike.",
#:   "The motorcyclist cuts across and slams to a halt in the lane.",
#:   "A bike shoots into the junction and brakes to a standstill in its centre.",
#:   "The rider skids to a stop right before the ego and blocks the way.",
#:   "He rides out and then yanks both brakes right in the middle.",
#:   "The bicyclist braked abruptly while crossing and came to rest in the intersection.",
#:   "bike crossing, hard brake, stuck mid-way",
#:   "A cyclist was going over the crossroads and slammed his brakes on halfway, plonked right in my path.",
#:   "The bicyclist was crossing the intersection when he braked abruptly mid-way and blocked Unit 1.",
#:   "Bike X-ing jct, hard brake in centre, stands in ego path.",
#:   "The bicycle target crosses the junction and decelerates abruptly to rest at its centre, in the VUT's path.",
#:   "The bicycle drives over the crossing, in the middle he brakes suddenly and stands in my way.",
#:   "Two-wheeler stops dead mid-junction during its crossing; ego path blocked, doesn't clear.",
#:   "He pedalled out boldly, then clutched at both levers and stuck there in the very middle before her.",
#:   "That moped's halfway over the junction and he's grabbed his brakes, he's stopped slap in your way.",
#:   "kid on a bike stopped dead halfway over the intersection right in our way",
#:   "A cyclist braked to a standstill at the heart of the crossroads, blocking a car.",
#:   "Halfway over the junction he applied his brakes with force and stood in my client's road?",
#:   "The cycle uncle was crossing the junction, then middle there suddenly brake and stop.",
#:   "Pedals out, gets to the middle, pulls both levers and there he is, bang in front of me.",
#:   "Sudden mid-intersection stop of crossing two-wheeler in ego path.",
#:   "BIKE SLAMS BRAKES IN MIDDLE OF INTERSECTION",
#:   "The crossing moped rider seized up in mid-junction.",
#:   "Moped going over the intersection stops like it hit a wall, blocks us",
#:   "Cyclist halfway over, hauls on brakes, and stands right where I'm headed.",
#:   "Boy on bike crossing stop braked violently in centre stop blocking car stop",
#:   "Make the two-wheeler cross, then freeze hard in the junction's middle, obstructing the AV.",
#:   "He crosses, then nose-dive in mid-intersection, and nobody gets by.",
#:   "courier on a pushbike was riding over the crossroads, clamped both brakes on right in the centre and just stayed standing in our way",
#:   "The PTW target traverses the intersection, decelerates to zero abruptly at its midpoint and remains there as an obstacle to the vehicle under test.",
#:   "I thought she'd be over well before me, but the girl on the scooter panicked in the middle, squeezed everything and stood there, blocking my road.",
#:   "In the middle of the crossing the biker who was riding to the other side made suddenly halt, exactly there where our car wanted to pass.",
#:   "V2, a bicycle, was traversing the intersection from right to left when its rider braked heavily and stopped in the direct path of V1.",
#:   "If a kid on a bike is going over the junction, ask yourself: what if he slams to a stop bang in the middle and I can't get round?",
#:   "My chain came off, simple as that. I was two thirds of the way into the crossroads, riding over to the far side, when the pedals went, I snatched at the brakes out of fright and came to rest smack in front of an approaching taxi.",
#:   "It started as an ordinary crossing. The rider set off over the junction with plenty of time, yet in the dead centre he hit the brakes so sharply that his back wheel hopped, and there he remained, broadside to us, with nowhere for us to go.",
#:   "For the validation run we need a bicycle that invalidates the gap. It enters and rides over the intersection in a plausible way, then stops with maximum deceleration in the centre of it, inside the corridor of the ego, and doesn't move again.",
#:   "An elderly gentleman on a moped caused a long tailback on Tuesday. Reports say he was on his way over the busy crossroads when he pulled up sharply in its very middle, apparently to catch his hat, and blocked a car that was coming.",
#:   "M'lud, the motorcyclist had every opportunity to reach the other side. Instead, being squarely in the centre of the junction, he chose to brake with all his might and to remain at that spot, so that my client found her way barred.",
#:   "Cyclist rides over the crossroads, clenches up halfway, becomes our roadblock.",
#:   "Moped bound for the far side anchors mid-junction, square in my way.",
#:   "pedal pedal pedal SKREEEE and now there's a fixie parked mid intersection",
#:   "The girl on the bicycle was bound for the other side of the junction until, right in the middle of it and of our way, she jammed everything on.",
#:   "On reaching the midpoint of its traverse of the intersection, the two-wheeled target brakes at its limit, halts and obstructs the VUT's trajectory.",
#:   "He's riding across nicely, he's halfway, so you think he's as good as gone; and he's hauled it to a stand in the very centre, blocking you.",
#:   "I'd like a motorcyclist to ride out over the crossing, pull up sharply at its centre and stay there, so that the ego can't get through.",
#:   "V2, a bicycle, had covered half of the intersection when its rider made a sudden application of both brakes and came to rest in front of V1.",
#:   "Der Radfahrer would pass the crossing, all good, but in the middle he took both brakes and stood, exactly on the point where I must through.",
#:   "I'd given the paper boy all the time in the world to get over the crossroads. He used half of it. Then his magazines went on when he didn't: he had clamped his brakes so hard, slap in the centre, that the bag flew over the bars, and there he was, on my line, not moving.",
#:   "By rights the moped's track should have crossed ours and left it again. It crossed it, all right, but it stuck there, for a second and a half before the meeting point its speed fell off a cliff, and the thing was at zero in the middle of the junction with us bearing down.",
#:   "The vicar will tell you he was in no hurry, and that's true. He sailed out over the crossing on his old roadster, very upright; only when he was right out in the middle did he squeal to a halt, as if he'd recalled a funeral, and he left me nowhere to go.",
#:   "A black line of rubber, no thicker than a thumb, runs from the western mouth of the intersection to its middle, and at the end of it the motorcycle was found standing. The car that wanted to pass over that spot had stopped with its number plate a foot away.",
#:   "All these years I've told pupils to look where the cyclist's looking. This one was looking at the far side and riding for it, and then her head snapped round, she grabbed two fistfuls of brake and planted her foot in the dead centre of the junction, in our path.",
#:   "It sounded like a pig. That was his front brake, and he'd pulled it where no one pulls it, out in the middle of the crossroads when he was riding from our side to the church side. He stood there and the blue car couldn't get by and it hooted and hooted.",
#:   "I was third in the queue in my lorry, so I had a good seat. Fella on a racing bike sets off over the junction, gets as far as the middle, and then it's as though somebody's shut a door in his face. Dead stop. Car from the left had to stop for him.",
#:   "The collision was avoided, which is why this is only a letter. Nevertheless I should like the courier firm to know that its rider, halfway through crossing the intersection, braked for no reason with all his strength, and stood like a gate across the way I was going.",
#:   "Agent type is bicycle. It traverses the junction at 15 km/h until the remaining distance to our centreline is below threshold, then a hard stop, and it stays as a static obstacle at mid-intersection. The AV has to notice that the crossing isn't going to be completed.",
#:   "Her chain had been slipping since the canal. The mechanic thinks it went when she was half over the big crossing, and that in her alarm she seized both levers; however that may be, the van found her standing in its road with the bicycle between her knees.",
#:   "In our city cyclist is king. One chap was going across the four-road junction, everybody letting him, and in centre his phone rang, and on the spot he pulled brake like anything, stopped there, and started talking, and my way was fully shut.",
#:   "Halfway to the other side his wheels locked, and there he stayed, broadside.",
#:   "Scooter over the line, crossing fine, then rubber, then a roadblock mid-junction.",
#:   "She got to the centre of the crossroads and nailed herself there.",
#:   "We'd left the cyclist enough time to be over and away, but his back wheel skidded in dead centre, and after that he was our wall.",
#:   "Skid mark: 2.1 m, ending at the geometric middle of the intersection, where the bicycle stood across V1's line of travel until V1 had stopped.",
#:   "Give me a moped that sets out for the far side of the crossing and, in the very centre of it, is hauled up sharp in the AV's road for good.",
#:   "Everything said he'd be gone, his legs, his pace, his eyes; then both his levers were at the bars, in mid-crossing, and he was in your way and staying there.",
#:   "On the half of the big crossing the velo woman became afraid, pulled everything what she had, and remained standing exactly before where I must go.",
#:   "There's a lad on a pushbike at the crossroads, well, in the crossroads: was riding over, hit the anchors in the middle, and he's blocking the northbound.",
#:   "I had my eyes on the pavement where he was going to end up. That's how sure I was. He never did. I brought my eyes back along the way he'd still had to go, and at the near end of it was a motorbike with its fork squashed flat, in the middle of everything, in front of my bonnet.",
#:   "The chain was found by the drain on the western corner, and the bicycle, with its rider astride, eleven metres east of there in the centre. He says that his pedals went light, that he took fright and squeezed. A car which had the right to be passing over that spot found him planted on it.",
#:   "It's what the wheel did that I'd like you to note. It was rolling, rolling, rolling, towards the far kerb, and in between two frames it was a wheel that didn't roll, though the bike went on a foot or so. After which nothing went on. So we've an obstacle at mid-intersection, and the robotaxi a second and a half away.",
#:   "If she had turned back I'd have had room, and if she had kept on I'd have had more. She chose the one thing that left me none. Right in the middle of the crossing, her basket full of leeks, she brought the bicycle from a good twelve miles an hour to none at all, and looked at me.",
#:   "From up in my cab you could play it like chess. The courier comes out of the left-hand street, he's off to the right-hand one, he'll be clear of that blue car by ten feet. But he threw his king over. Clapped on both brakes in the exact middle, with his tail slewing, and waited there for checkmate.",
#:   "The school report says \"Tom must learn to finish things.\" He was finishing the crossroads nicely, my bike and I waiting at the corner behind him. There was a squeak like a stepped-on toy. He'd stopped, in the middle of the middle, because his sandwich had dropped out, and the car that was coming couldn't come.",
#:   "Two crossings had been modelled before; in both, the bicycle clears. The third one, then, starts out the same, so that it can't be told apart for the first three seconds. On the centreline of the ego's lane the rider demands full braking. The speed is nought by the time that the rear wheel's in our corridor, and remains so.",
#:   "The sound was out of place. One expects a squeal at a stop line, or at the far side. This one came from the navel of the junction, so to speak, and the Vespa that had uttered it was standing there when I looked, crosswise to us, its girl with both feet on the floor and her elbows locked.",
#:   "Was the way free? It had been about to be. The rider was in the act of quitting it. But having used up one half of the intersection in quitting it he made, for reasons unknown to this court, such use of his brakes that he was still in it when the plaintiff arrived, and hadn't stirred.",
#:   "Nothing behind him, nothing before him, the whole crossroads his own, and the old man on the butcher's bicycle was sailing through with his apron flying. And then in the heart of it he remembered. One saw the remembering go down his arms. The wheels bit, the basket swung, and he and it stood like a monument across her path.",
#:   "Near the clock tower all roads are meeting. One dabbawala was going from this road to that road on cycle, forty dabbas hanging. In the centre one dabba was slipping, so what brake he pulled! All forty were ringing like temple. Then he is only standing there, in front of my bumper, counting, and I'm also counting.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario turning-obstacle; own code"
#: [slots]
#: actions = ["cross", "brake", "stop"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.0
#: high = 6.0
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 4.0
#: high = 24.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.0
#: high = 1.0
#: unit = "m"
#: meaning = "how far from the ego's line it comes to rest"

param OPT_ADV_SPEED = Range(3, 6)
param OPT_ADV_DISTANCE = Range(4, 24)
param OPT_STOP_DISTANCE = Range(0, 1)

behavior AdvBehavior():
    # Earlier where it has farther to go, or on a wide road it would pass behind the ego.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED + 2 * globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()
