#: description = "The oncoming car pulls out into the ego's lane and accelerates to overtake."
#: rephrasings = [
#:   "he swings out to overtake, foot down, straight at us",
#:   "Vehicle 2 moved into the opposing lane and accelerated in order to pass.",
#:   "opposing veh pulls out to overtake, accelerates in our lane",
#:   "The target changes into the lane of the VUT, against its direction, and accelerates.",
#:   "The truck goes out for overtaking and gives gas in our lane.",
#:   "A biker opposite pops out and winds it up, head on.",
#:   "The bus coming the other way sticks its nose out to pass and gathers speed toward us.",
#:   "An ambulance uses our lane to get past the queue, faster and faster.",
#:   "Some pillock coming the other way swung out onto my side and floored it to get past a lorry.",
#:   "Opposing vehicle entered Unit 1's lane and accelerated in an attempt to pass.",
#:   "MC oncoming pulls out to pass, full gas, in our lane.",
#:   "The opposing vehicle leaves its lane for an overtaking manoeuvre and accelerates in the lane of the test vehicle.",
#:   "The car from the front goes out on my lane and gives gas to pass another.",
#:   "Opp. overtaker enters our lane, a > 0, head-on, speeds up rather than aborting.",
#:   "He was tired of the bus ahead of him, so he came out into their side and put on all the speed he had.",
#:   "Ambulance coming the other way's pulled out to pass, he's in your lane and he's building up speed.",
#:   "oncoming car came out into MY lane n sped up to pass someone omg",
#:   "An oncoming lorry moved into the opposite lane and gathered speed to get by slower traffic.",
#:   "In order to overtake, you came over into my client's lane and pressed on the faster.",
#:   "Opposite bus came out to overtake and raised more speed in my lane itself.",
#:   "Swings out on my half to get round some dawdler, and instead of ducking back he piles on the coal.",
#:   "Opposing vehicle in own lane for overtaking under increasing speed",
#:   "OVERTAKES INTO ME AND SPEEDS UP",
#:   "The oncoming truck sallies out into our lane and pours on speed to pass.",
#:   "Oncoming coach comes out to pass someone and floors it at us.",
#:   "Biker opposite leaves his lane to overtake, accelerating head-on in ours.",
#:   "Let an approaching saloon start overtaking in my lane, gaining speed.",
#:   "Opposing van, passing manoeuvre, our side, throttle wide open.",
#:   "Police car from ahead swings onto our half, speeding up to get by.",
#:   "A lorry driver approaching me ran out of patience with a caravan, moved over to my side and wound it up to get past.",
#:   "The auto which was facing us comes out of his queue into my lane for overtaking, and on seeing me he's only going faster.",
#:   "When the gap to the ego falls below the threshold the opposing vehicle takes the ego's lane and accelerates as though passing a slower one.",
#:   "He's fed up sitting behind that tractor, so out he pops into your lane, coming at you, and he's giving it the beans.",
#:   "What possessed the motorcyclist to pull into my lane from the other direction and open the throttle, instead of tucking in again?",
#:   "Head-on! Fire engine overtaking traffic on the opposite side is now in OUR lane and getting quicker by the second",
#:   "The queue was on the other side, nose to tail behind a milk tanker. A pickup broke out of it onto my side with a puff of black smoke, and every time I blinked it was coming at me faster than before.",
#:   "V2, traveling in the opposite direction, crossed the double line to pass a slower vehicle. The event data show throttle at one hundred per cent and rising speed while V2 was wholly in V1's lane, facing V1, for the next four seconds.",
#:   "All he saw at first was the bus, far off, sensible, in its place. But it had a timetable and a horse-box before it; and it leaned out, filled their lane from hedge to hedge, and gathered itself, and came on harder.",
#:   "I need an overtaker on the opposite side who picks a gap that he doesn't have. The saloon leaves its own lane for ours, nose toward the robotaxi, and adds speed continuously, because he believes he'll be past in time.",
#:   "We were on the national road in the direction of Lyon. An ambulance which came in face has gone out of its file for doubling a camion, and in place of renouncing it has pushed the accelerator, in my lane, against me.",
#:   "Oncoming van swings into our lane to pass, foot hard down.",
#:   "Facing us on our side, overtaking, quicker by the second.",
#:   "Opposing coach pulls out, piles on pace, our lane.",
#:   "On our side of the road, and winding up like a turbine, a motorbike that had been behind a tractor came to meet us.",
#:   "Let the approaching ambulance step out from its line into the ego's lane and build up speed there, as it would to get by a cyclist.",
#:   "He was coming from front, he came out in my half for passing the camel cart, and instead of slowing he was increasing, increasing.",
#:   "Did you imagine, when you left your lane and put your foot to the floor in hers, that the plaintiff would evaporate?",
#:   "Opposing target: lateral transfer into VUT lane at gap threshold, thereupon 3 m/s² until 14 m/s, as in overtaking; no return.",
#:   "It would have been better to give up, but the lorry, already out on our side to pass, gathered pace with all its stacks smoking.",
#:   "The thing about a straight road in the Fens is how long you've got to be frightened. There was a beet lorry coming, and beside it, since a moment ago, a saloon, so I now had one for each lane. Mine was the saloon. I kept waiting for it to drop back. Its bonnet rose instead.",
#:   "From the passenger seat you press a brake which isn't there. I pressed it. Opposite, out of a whole row of cars, one had come over on our side, a people carrier, to get by the lot; and I could hear, with the window down, that he'd changed to a lower gear and that it was working.",
#:   "Closing speed is the figure to look at. While the pickup is in its own lane it's a steady 24 metres a second. Then it moves to ours, and from there on the figure won't stay put: 26, 28, 31. He's passing a gritter, and evidently he thinks more throttle is the answer. It was our AV that found the verge.",
#:   "Flash your lights by all means, but brake first. He's looked, he's seen you, and he's pulled out to overtake in your lane regardless, that green Jaguar. Now is he going to think better of it? Listen to it. He's flooring it. So it's left wheels on the grass, please, and let the fool have the lot.",
#:   "V2 and V3 were proceeding in the opposite direction to V1, V3 a farm tractor in the lead. V2 entered the lane of V1 for the purpose of passing. Recorder data indicate wide-open throttle from that time until the collision; V2's speed increased from 41 to 58 mph. V1 was nearly stationary.",
#:   "His engine note has stayed with me, more than his face. I was delivering by cargo bike, on my half. He, on a motorcycle, opposite, in a train of cars. I saw him peel out of it to my half. The note went up. And up, as mine would do, singing, if I were very happy, and he was aimed at me.",
#:   "My father, who was at the wheel, is a man who gives way. It was lucky. The bus on the other side wanted past the horses, and so it came out; it had our lane, hedge to line, from then on. I believed that it would creep by them, as one does by horses. It didn't creep, it stormed.",
#:   "You wouldn't call it overtaking, what it did to me, for it was me that it was facing. Seen from the caravan, I dare say, it was overtaking. What I saw was an estate with a canoe on top, that had left its own lane for mine and, with every telegraph pole, came on a little harder.",
#:   "Nobody denies that the fire engine was on a call. But there was a queue, and to get by it the driver moved over to the carriageway half that a hospital shuttle was using in the other direction. \"I thought he'd see sense and slow,\" its attendant told us. \"He put his boot in it. He was coming like a train.\"",
#:   "In the dream it is always a truck. It comes toward him on its own side of the poplars, there's a cart before it, and with a sort of shrug it is on his side. The horror isn't that. The horror is the black breath it lets go, and the way the gaps between the poplars start getting shorter.",
#:   "right so single carriageway, me in the robotaxi, white transit comin the other way stuck behind a learner. he pulls out onto OUR side. ok mate, bold. then u can literally see the front lift cos hes nailed it. straight at us gettin faster n faster. learner must have been well proud",
#:   "Out to pass, onto our side, winding it up.",
#:   "Opposing coach in our lane, overtaking, gathering pace.",
#:   "Two abreast facing us, ours the one speeding up.",
#:   "Whatever was in front of that SUV on the other side must have been slow, since out it came to our side, and its bonnet kept rising as it came.",
#:   "Kindly have the police car that's coming the other way peel off from behind a tractor into the ego's lane and put on more and more speed there.",
#:   "Between the lorry's leaving its own half for mine and my meeting the verge its engine note did nothing but climb, so I take it he believed he'd be past.",
#:   "He comes from opposite, he's fed up of the bus before him, he jumps to my part, sees me, and to be finished sooner he's pushing the pedal, always more.",
#:   "A motorbike was using our lane to get past a string of caravans from the other direction, and it was going quicker with each one it ticked off.",
#:   "Which of us, the counsel asked, had the throttle open? The one who'd come over to the wrong side in order to pass a hay cart, madam, and he'd it wide.",
#:   "The exhaust was what I saw, though I was in front of it. The coach had been second in a row of things that were coming along the other side; it came out to us, to be first, and I suppose I had expected that it would look, and breathe in, and hide again. But behind it there rose a cloud, bigger and bigger. It was working up to something.",
#:   "If I could draw, I'd draw you the milk lorry as he saw it, getting closer by the yard; and I'd draw you him as I saw him, who was beside it, on the half which was mine. He had two ways out. One was to lift off. His front wheels went light, you can tell that with a low car, and it was the other.",
#:   "For our closing-rate estimator here's something unpleasant. An oncoming car in a queue, same speed as the queue. It's then laterally in our lane. The estimator, from history, gives four seconds to impact. It's wrong each time it looks, three, one and a half, since the passing car has its accelerator down and holds it down. It hasn't left our lane by the end.",
#:   "\"He'll think better of it,\" my father said. He has driven since 1958 and they've always thought better of it. It was a fire engine from the front, and there was a horse box which it was getting by, and for that purpose it had all of our road and part of the hedge. It blew its horn; it changed down; and it thought nothing of the kind.",
#:   "On the col they've a sport. You follow the camper, you wait until there's a straight, you go out on the lane of those who go up, I was one of those, and you open. The one in the yellow Alpine opened so that the mountain heard. I've expected that he closes again when he saw me. He found another gear, and I found the snow pole.",
#:   "Control, HGV driver, I'm shaken. There's a Transit coming down toward me in a line of four. He's pulled out, he's in my side, and I've flashed him and give him the horn. You'd think he'd tuck in, there was room. He's seen me and he's put his boot in it! Faster and faster, straight for my cab, to get round a learner. I've had to put her in the lay-by.",
#:   "What should somebody do who's begun to overtake and meets you? Back off and slot in again. Write it down. And now look at what's being done. That green estate's abandoned its side, it's in ours, facing us, alongside a tanker, and is its nose dipping? It's lifting. He's decided to win. So let him, get over, on the grass.",
#:   "The vehicle ahead of V2 was a farm implement. V2, southbound, occupied the northbound lane for the purpose of passing it, V1 being northbound in that lane. Skid marks would indicate an aborted pass; there are none. The downloaded speed of V2 rises steadily, 44, 49, 55, 61. V1 was on the shoulder, at 4 mph, when struck.",
#:   "He loved the moment of pulling out, he was to say, and how the engine took hold of you. There was a bus before him, and beyond it that whole long lane, which belonged to other people. It had people in it, a family, in a grey car, facing him. He saw them get large. He pressed, because the bus would be behind him in a second, and they got large quicker.",
#:   "I do the ponies on Sundays, so I know about being overtaken, you hear them hold their breath and creep. This biker didn't hold anything. The ponies were on his side, the shuttle was on the other, he took the shuttle's. I was looking straight at his back. And instead of the sound staying put it went up like a kettle, all along the shuttle's lane, into its face.",
#:   "youve all seen the thumbnail so yes thats a bus. on MY side. its passing the tractor you can see behind it. now turn the sound up. hear that? thats him changing up. hes seen me and hes changing UP. every frame hes quicker. i went through a fence btw",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "accelerate"]
#: position = "oncoming"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.0
#: high = 4.5
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 35.0
#: high = 90.0
#: unit = "m"
#: meaning = "distance to the ego at which it pulls out and accelerates"
#: [[parameters]]
#: name = "OPT_ADV_OFFSET"
#: low = 0.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far toward its own side it keeps when it meets the ego"

param OPT_ADV_SPEED = Range(2, 4.5)
param OPT_THROTTLE = Range(0.5, 1)
param OPT_ADV_DISTANCE = Range(35, 90)
param OPT_ADV_OFFSET = Range(0, 3)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(against(egoRoute), globalParameters.OPT_THROTTLE, 0, 14) until abs(offsetFrom(egoRoute, self)) < 1 and gap(self, ego) < 40
    do ThrottleOnPath(against(egoRoute), globalParameters.OPT_THROTTLE, -globalParameters.OPT_ADV_OFFSET, 14)
