#: description = "The rider comes into the ego's lane, makes a U-turn in it and rides back to the side it came from."
#: rephrasings = [
#:   "A cyclist rides out, loops right round in front of us and goes home again.",
#:   "The bicyclist entered the roadway, executed a U-turn in the travel lane, and returned to the shoulder.",
#:   "bike out, loops in lane, back",
#:   "The two-wheeler enters the VUT's path, turns through 180 degrees and leaves on the same side.",
#:   "The scooter comes on the lane, makes a circle and drives back.",
#:   "A teenager circles on his BMX through our lane.",
#:   "The moped rider has forgotten something and wheels about before our bumper.",
#:   "She pedals off the kerb, does an about-turn and vanishes where she came from.",
#:   "A lad on a bike swung into my lane, did a loop in it and pedalled off to the same side he'd come from.",
#:   "The cyclist rode into Unit 1's lane, reversed direction within it and returned to the side of the road from which he came.",
#:   "Bike in from side, 180 in ego lane, back to same side.",
#:   "The cyclist target enters the VUT's lane, turns through 180 degrees in it and leaves towards its side of origin.",
#:   "The bicycle comes in my lane, makes a round and rides again to his side.",
#:   "VRU loops: enters our lane, turns about inside it and exits where it came from; never reaches the far kerb.",
#:   "She rode out before him, described a neat half circle, and went back to the pavement she'd left.",
#:   "He's only circling round, that kid on the bike; into your lane, about-turn, and back to his own pavement.",
#:   "kid rode into our lane, did a donut basically, and went back where he came from",
#:   "A young cyclist wheeled about in the traffic lane and made for the kerb he had left.",
#:   "You entered the lane, described a half circle in it, and regained the side from which you set out?",
#:   "Scooter came into my lane, took one round there, and went back to same side again.",
#:   "Comes out in front of me, does a twirl like he's on the ice, back to the same kerb.",
#:   "Turnaround of two-wheeler inside ego lane with return to side of entry.",
#:   "BIKER DOES A U-TURN IN MY LANE AND GOES BACK",
#:   "The rider curled about in our lane and homed to his kerb.",
#:   "Kid cycles out, pirouettes in my lane, cycles back.",
#:   "Two-wheeler enters VUT lane laterally, reverses heading therein, exits same side.",
#:   "Moped pops in from the side, wheels round, off home again.",
#:   "Is that scooter only using my lane to turn round in?",
#:   "Out of the driveway, round in our lane, into the driveway.",
#:   "I want a boy on a bike to ride from the edge into the ego's lane, come about inside it and return to the edge he started from.",
#:   "She never went right across; she came as far as our lane on her bicycle, bent it round, and made for the same pavement again.",
#:   "The rider of V2 left the shoulder, turned about within the lane V1 was using, and was heading for that same shoulder when struck.",
#:   "From the right side a motorino comes into my lane, makes half turn inside of it and goes to the right side another time.",
#:   "They're practising turning circles, those two: see, the moped swings in before us, round he goes, and he's back by his gate.",
#:   "Half a circle was drawn on the tarmac of our lane by a biker who'd emerged from the petrol station and who went back into it.",
#:   "Our street's where the kids try their new bikes out. This little lass came off the pavement into the lane in front of the robotaxi, did a wide turn in it with her tongue sticking out, and pedalled straight back to her dad, who was on that same pavement.",
#:   "The manoeuvre of the bicycle target has three phases: it enters the lane of the vehicle under test at right angles; it then describes an arc of about 180 degrees without leaving that lane; finally it moves away to the side from which it entered.",
#:   "Wrong address, I thought, because the courier had barely ridden his scooter off the forecourt and into my lane when he looked up at the house numbers, slapped his helmet, swung the bars full lock and rode back round onto that forecourt.",
#:   "When it gets to our lane the cyclist doesn't keep going to the far kerb like every other crosser in the dataset. He curves round inside the lane, spends about two seconds going more or less along with us, then heads for the kerb he set off from.",
#:   "I was eating my sandwich in the cab. There's a track on the right, and out of it comes this motocross lad, into my lane, throws the bike round in a U right there under the windscreen and disappears up the track again. Didn't even look at the lorry.",
#:   "Cyclist in from the left, circles in our lane, out left.",
#:   "Trial rider uses our lane as turning circle, returns to driveway.",
#:   "Enters our lane, swivels about in it, regains her own kerb.",
#:   "Only one half of the road was ever used by the moped: it came off the pavement, arced about in our lane and climbed the same pavement again.",
#:   "Let a schoolboy pedal from the side into the ego's lane, go right about without leaving it, and get back to the side he started from.",
#:   "The moto entered from my right, she has made in my lane a demi-cercle, and she went away on my right, like she was lost.",
#:   "Kid on a BMX, off the kerb into lane one, wheeled about in lane one, back on the kerb he came from, nobody hurt.",
#:   "Did that old fellow on the tricycle honestly ride out before us just to come about in our lane and trundle back to his bench?",
#:   "A pizza moped turned out of the takeaway, swept round in the width of my lane and was swallowed by the takeaway again. Forgot the pizza.",
#:   "My mate had just fixed the gears on his bike and wanted to try them. So he shot out of his front gate, got as far as the lane the bus was in, swept it round in a curve there with the bus driver having kittens, and came whizzing back in at the gate, very pleased with his gears.",
#:   "Where the tyre print leaves the grass verge and where it joins the grass verge again are no more than seven metres apart, and on the same side of the road. Between these points it forms a U. The closed end of this U lies in the lane that V1 was using, about two thirds of the way over.",
#:   "I was waiting for her to get across. That's what you do with a cyclist who sets off from the kerb in front of you, isn't it, you wait till she's on the far side. She never went there. In my lane she stuck her inside foot out, bent the bike about it, and made for the kerb she'd come from.",
#:   "Kindly be careful at the petrol pump on the highway. The boys there are repairing scooters, and for testing they are coming out into our lane, taking one full turn inside it only, and going back to the pump. Yesterday one did it ten feet before my bumper. He was not even wearing chappals.",
#:   "The rider target performs three consecutive movements, all in front of the test vehicle. First, lateral entry into its lane. Second, a turn through approximately 180 degrees which is confined to that lane, and whose first half is in the direction of traffic. Third, exit at the side of entry. The far lane stays empty throughout.",
#:   "We'd reckoned with a crossing. The scooter had come from the right, it was in our lane, and by all the laws of motion it ought to have left by the left. When the robotaxi eased off to let it do so, it was swinging round in front of us; and by the right it went, past the same hedge as before.",
#:   "Out on the ranger's quad... no, not a quad, it was his old trail bike. He'd seen that the gate he'd ridden out of was standing open behind him. He was by then in my lane. So he came right about on the tarmac before my bonnet, waved an apology, and rode to the gate to close it.",
#:   "I said to the wife, look, a circus. There were balloons, there was a chap juggling, and from among them a girl on a unicycle, no, a small bicycle, came into the road. In our lane, and nowhere else, she executed a perfect half of a ring. Then back she rode to the balloons, to great applause.",
#:   "As an exercise in observation, tell me which way that biker is looking. Over his shoulder, back at the café. So when he comes into our lane like that, is he crossing? He isn't. He's left his gloves on the table. Round he goes right here in our lane, and off to the café where he started.",
#:   "The footage is eleven seconds long. In the second of them a bicycle rolls off the left-hand pavement. From the fourth to the seventh it's in the AV's lane, its front wheel cramped over, changing its heading until it has been reversed. In the tenth it bumps up the left-hand pavement. The AV had halted three metres short.",
#:   "so theres this toddler on the pavement crying his balloon flew off. his big brother jumps on the bike to chase it, straight into our lane, sees it go over the rooftops, gives up. does like a tight loop in the lane, not even over the line, and rides back to the toddler. nearly cried myself tbh",
#:   "Bike: our lane, hairpin in it, same hedge again.",
#:   "Scooter drew a hairpin on our lane, ends at his kerb.",
#:   "lad cycles in, comes about infront of us, pedals home",
#:   "Both ends of the moped's loop were at the bus shelter; the bend of it was in our lane, right before our bumper.",
#:   "Let a motorcycle enter from the edge, swing round through a hundred and eighty degrees within the ego's lane, and leave by the edge it entered from.",
#:   "She'd gone as far as my lane on her bicycle when she hung it round in there, and the next I saw was her wheeling up her own garden path.",
#:   "The bicycle stopped being our problem on the side on which it had started, for it had curled right about inside our lane and gone home.",
#:   "What's the good of riding out in front of a bus just to go round in its lane and toddle back to your own pavement?",
#:   "The moto he enters in my line, gives there the entire turn like around a coin, and returns to the same sidewalk from where he came.",
#:   "I kept looking at the far pavement for him, that's my whole excuse. A boy on a bike who comes off the left and into your lane will be on the right next, I thought. He was on the left. He'd got halfway over my lane, wheeled about through every point of the compass that matters, and ridden back to his mates.",
#:   "On the thermal camera there is a hot spot that moves out of the lay-by into our lane, slides along with us for a metre or so in a bend, and moves back into the lay-by. It's the exhaust of a trail bike. It was turned about, as the colour film shows, without ever leaving the lane on the other side.",
#:   "Oh, the paper boy? Every morning. He flings number twelve's paper from the road, and to get to the road he comes off the pavement into whichever lane's nearest, mine today. He wheels around in it, steering with his knees, lets fly, and goes back to the pavement for number fourteen. I've learned to crawl down Elm Grove.",
#:   "I've drawn his route with a pencil for the insurers, it's got the shape of a hairpin. The prongs of the hairpin rest on the grass verge on the nearside. Its bend lies in my lane. There's nothing of it in the opposite lane, and nothing on the opposite verge, since he'd turned his scooter about and was heading for home.",
#:   "Because her basket had tipped on the way, and its oranges were rolling about back at the stall, the lady on the Dutch bike never got beyond my lane. She'd ridden into it from the stall. In it, with me at a standstill and my heart in my mouth, she brought that long bicycle right round, and rode out of it to the stall.",
#:   "Is it a crosser? For one and a half seconds it is. Is it a cyclist going along with us? For one second, while it bends round in front, its back wheel to our radar, it is that also. Is it a crosser the other way? Yes, finally, to the kerb from which we first picked it up. Three classes, one child.",
#:   "In the yard next to the main road the mechanic tests the motorbikes. The yard is small, so the testing is made with our lane. He comes out, he takes the curve in the lane, all of it, to the point he sees his yard again, and he goes in his yard. We are braking each day, he is waving each day.",
#:   "Our coach must've been thirty feet off. A fellow on a moped came out of the chip shop's alley and into our lane, patted his pocket, and laid the moped over. I thought he'd fallen. But no, up it came, pointing at the alley, having gone about in the lane like a yacht, and into the alley it went.",
#:   "For the pupils it's a puzzle picture. Tyre print comes from the drive on the right. Tyre print goes to the drive on the right. Between them, in our lane, a curve like the handle of a cup. \"He crossed twice?\" No, he didn't cross at all. He came for a turn in our lane, and he turned, and he left.",
#:   "What I'd have given for him to simply ride over. I had allowed for that, I'd braked my lorry just enough. Instead of clearing my lane at the far end, the young man put his mountain bike through a tight bend inside it, so that it was in front of me twice as long, and cleared it at the near end, where he'd come from.",
#:   "The target shall remain on one side of the road save for its excursion into the lane of the subject vehicle. This excursion consists of an entry, a reversal of heading carried out within the lane's width and initially bending in the direction of travel of the subject vehicle, and an exit opposite in sense to the entry. Vehicle type: e-bike.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "u-turn", "turn-back"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.2
#: high = 3.2
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 2.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary reaches its line"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 1.8
#: high = 3.0
#: unit = "m"
#: meaning = "how far from the ego's line it begins to turn"
#: [[parameters]]
#: name = "OPT_TURN_RADIUS"
#: low = 1.6
#: high = 2.4
#: unit = "m"
#: meaning = "the radius of its turn"

param OPT_ADV_SPEED = Range(2.2, 3.2)
param OPT_ADV_DISTANCE = Range(2, 20)
param OPT_ADV_REACH = Range(1.8, 3)
param OPT_TURN_RADIUS = Range(1.6, 2.4)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH + 2
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    # Round to the left or right, so that it first goes with the ego's direction.
    do TurnOff(3.1 if offsetFrom(egoRoute, self) > 0 else -3.1, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_TURN_RADIUS)
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
