#: description = "The vehicle cuts off the ego vehicle at the intersection and slows in front of it."
#: rephrasings = [
#:   "A car forces its way before the ego and stays there.",
#:   "The adversary dives in ahead, leaving the ego no room.",
#:   "The other driver barges into the ego's lane.",
#:   "Coming from the side, a vehicle takes the ego's way from it.",
#:   "The crossing car slots in right before the ego's bonnet.",
#:   "he shoves in front of us out of the side road and then dawdles",
#:   "Vehicle 2 entered the lane of Vehicle 1 at the intersection and proceeded slowly.",
#:   "takes our lane at crossing, then slow ahead",
#:   "Some clown chopped me up at the crossroads and then dawdled right in front of me.",
#:   "At the intersection the defendant's vehicle pulled in directly ahead of the victim's vehicle and reduced speed.",
#:   "X-traffic barges ahead of ego at jct, then drops speed.",
#:   "The crossing target enters the VUT's path within the junction at low TTC and decelerates ahead of it.",
#:   "On the crossing a motorbike takes my way and goes slower directly before me.",
#:   "Actor steals our right of way in the intersection, then lifts off in front of us; expects an AEB response.",
#:   "He came from the side, thrust himself in ahead of her in the middle of the crossing, and then, of all things, slackened off.",
#:   "That biker's going to carve you up at the lights and then slow right down under your nose.",
#:   "got cut off at the crossroads and then he slows DOWN like wtf",
#:   "A motorcyclist forced his way ahead of the car at the junction, then eased his pace under its nose.",
#:   "At the junction you usurped my client's path, and having done so you slackened your speed; correct?",
#:   "At the signal junction he put his car in my front and then going slow slow.",
#:   "Steals the road off me at the crossing, then takes it easy right on my nose.",
#:   "Path usurpation at intersection with subsequent speed reduction ahead of ego.",
#:   "CUT OFF AT THE INTERSECTION THEN HE SLOWS DOWN",
#:   "The car poached our gap at the junction and then slackened.",
#:   "From the cross street he nabs our lane and idles along it.",
#:   "Biker enters from side at x-roads, ahead of ego, reduces to crawl.",
#:   "You are robbed of your path at the junction, then held up.",
#:   "He come from side road, block my road in cross, after go slowly slowly.",
#:   "Taxi jumps in from the side at the junction, then won't hurry.",
#:   "At the crossroads a coupe coming from the left planted itself in the lane that belonged to the AV and went on at a bicycle's pace.",
#:   "A scooter that should have let us by at the intersection pushed in under our front and then took its own sweet time.",
#:   "Let the crossing car take the ego's path away inside the intersection and continue along the ego's lane at a much lower speed.",
#:   "The insured had priority; the third party joined her lane from the side road in the junction, immediately ahead, and then proceeded at a dawdle.",
#:   "Being in such a hurry to be first at the crossing, why did the man on the motorbike then potter along in our way?",
#:   "Vehicle 1 had to slow because Vehicle 2, arriving from the intersecting road, usurped its lane within the junction and kept to a low speed there.",
#:   "I was on the main road and well into the crossing when this estate came from the right, and instead of going over it turned its nose down my road, right in front of my car. Then it could hardly be persuaded to move.",
#:   "Over to our reporter at the Elm Street lights. A motorcyclist arriving from the side street pinched the way from a driverless cab in the middle of the junction, and for the next fifty yards the cab was obliged to trail after him at jogging pace.",
#:   "The cutting-in vehicle waits in the intersecting arm. It departs when the ego is close, occupies the ego's route within the junction area at a short distance ahead, and follows that route at a constant low speed, so that the ego must slow down behind it.",
#:   "I'm fourteen stone on a pushbike and even I'd have got away quicker. This car comes out of the side arm, slap across my bows in the crossroads, straightens up ahead of me in my own lane and then mooches along as if it had a puncture.",
#:   "Rule for today, friends of the show: the person who steals your path at an intersection never wants to use it. My guy swooped in from the cross street, took the spot before my hood, and then he was sightseeing, ten miles an hour.",
#:   "From the side he pinches our road at the crossing, then dawdles.",
#:   "Cuts across into my lane at the intersection and idles there.",
#:   "junction, hatchback muscles in from the side road, does 8 mph in front",
#:   "Why barge into the ego's lane out of the cross street in the middle of the intersection if all you do there is trundle?",
#:   "The motorcycle left its arm of the junction just as we arrived, curled into our lane right ahead, and proceeded as if it had all day.",
#:   "You've priority, but here's a Micra from the side that's stolen it; in it goes in the crossing, bang before you, and now it's going at a stroll.",
#:   "From the left road one car comes in the crossing, he puts before my nose in my lane and after he drives like with the grandmother.",
#:   "Actor departs the intersecting leg late, occupies the ego route inside the junction with minimal lead and then holds a very low set speed.",
#:   "Robotaxi blocked in: a driver from the intersecting street took its path at the lights and then slackened to a snail-like pace ahead of it.",
#:   "I was already under the traffic lights when the nose of a grey saloon came in from the right. It didn't go over, it bent round in front of me and into the lane I was bound along, as close as you please. And that, it seemed, was the end of its ambition: we went up Market Street at ten miles an hour.",
#:   "The third party was standing in the side road as our insured approached. When she was almost at the crossing it moved off and placed itself in her lane within the junction, leaving her some five metres. It did not pick up but stayed at jogging pace, and the following taxi ran into our insured.",
#:   "I want you to notice what your right foot had to do. You were going over the crossroads with the right of way, a moped squirmed out of the side street and planted itself in your lane dead ahead, so you braked once. It then refused to go any faster than a milk float, so you've braked ever since.",
#:   "My lane was mine till the middle of the junction. From there on it belonged to a lady with a roof box, who had been waiting at the side and who thought, evidently, that there was room for one more ahead of me. She drove as though the box were full of eggs, and I admired it in second gear.",
#:   "At junction J3 the lead distance drops from infinite to 6.1 m in a single frame. The cause is a car from the cross street whose trajectory joins ours inside the box. The relative speed is strongly negative for the next four seconds, because it merely rolls along ahead of us, and ACC had to brake twice.",
#:   "Down our way people call that a Sunday steal. He comes out from the side when you're as near as damn it in the crossing, he swings round so he's pointing your way, in your lane, under your chin. And once he's got it he lets it roll along at tractor speed and looks at the houses.",
#:   "All units be aware, slow mover on Grange Road. Black motorcycle, he came off the side street at the Grange junction straight in front of a delivery van, took the van's lane in the crossing. He's now plodding along with the van on his rear wheel and a tail building up.",
#:   "The other bike messenger and I were betting on the lights, so we saw it well. A coupe out of the cross street had itself a place in the van's lane before the van could get to it, right there on the manhole in the middle. Then the coupe all but went to sleep, and the van's driver was on his horn and his brakes.",
#:   "Madam says to court that she had the green. It is so, but that fellow was standing in the cross road, and when her car came he entered from the side and fitted himself exactly in front of her in her own lane. After that he was moving like wedding procession, and she had to press brake.",
#:   "They had her lane taken away from them at the crossroads, she and the baby and the dog. What took it was a small blue car out of a small side street, which inserted itself so near that she could read the dealer's sticker. She read it for a quarter of a mile, at the speed of a man with a barrow.",
#:   "My mum went eek and we all fell forward. There was a car at the side of the crossing, and it didn't wait for us, it came into where we were going and stayed there in front of our car. Then it went so slow that my brother could have run next to it in his socks.",
#:   "Side-street saloon grabs our lane mid-junction, then goes for a stroll.",
#:   "In the crossing, under our nose, into our lane, and then slow.",
#:   "He bags my road at the crossroads and won't hurry along it.",
#:   "The lead that I hadn't had when I entered the junction was a mauve hatchback out of the cross street, right on my bumper and doing twelve.",
#:   "Crossing motorcycle: launch late, merge onto ego path inside the intersection at short range, then set speed to slow and keep it there ahead of ego.",
#:   "guy waits at the side street for ages, waits till im nearly in the junction, bends in right in front of me and then does 9mph, why",
#:   "From cross road that lady scooter has entered in my way inside the junction, so near, and after that she's driving like she's searching for a ring.",
#:   "After the crossing the taxi had a companion on its bonnet, so to speak, one which had swept in from the side and saw no need to get going.",
#:   "If you're so keen to have our bit of road that you'll snatch it from the side in mid-junction, then use it, don't amble along before us.",
#:   "There's a mark on my windscreen where my nose met it, and that's level with the middle of the crossroads. From the right-hand road a car had appeared and wheeled round into the lane that lay ahead of me, nearly brushing me. There's no second mark, though it was a near thing, for the car that I was now following might as well have been towing a boat.",
#:   "Ego speed over time: 13 m/s up to the entry of the box, a notch down to 6, and from there a plateau at 3. The notch is a coupe which leaves the intersecting leg at the last moment and joins our path right before us. The plateau is the same coupe, eight metres ahead in our lane and in no hurry.",
#:   "Ladies and gentlemen, this is your driver, sorry about that. You felt me brake twice. Once was because a motorcyclist from the side road pushed himself in front of us right under the lights there, and once because, having got our lane, he's decided to see how slowly a motorcycle will go without falling over. He's still deciding.",
#:   "I had the right of way, I had the green. What I hadn't got, as of the centre of that crossing, was the lane I was going to use. A fellow with a surfboard on his roof had peeled into it out of the other street, with a foot to spare, and we set off for the beach at the pace of the surfboard.",
#:   "The third party emerged from the left-hand arm after my insured had passed the give-way line. It did not cross to the opposite arm, but took up the insured's lane immediately in front of him, in the junction itself. The cyclist who ran into the insured's boot did so because the third party then dragged along at some 8 mph.",
#:   "Our delivery robot rides behind a pilot car and everyone was told so. Somebody hadn't been. He stood in the side street until the pilot was almost on him, then he came in and made himself the new pilot, there in the crossing, so near that ours had to brake hard. And as a pilot he was hopeless, he just mooched.",
#:   "You'll laugh, but I waved. I thought a person who comes at you out of a side turning like that, right into the middle of the crossroads and round into your lane with your bumper at her plate, must have a baby coming. I took back the wave by the bakery. No one with a baby coming drives past a bakery at that speed.",
#:   "Tanja says it is like somebody takes the last cake and then eats it very slowly. We come to the crossing, it is our turn. A Fiat from the side jumps into our lane directly before the motor hood, I brake hard. After that he is not jumping more; he rolls, twelve, fifteen, and we must look how he eats.",
#:   "In plan the two paths should have formed a cross. They form a Y: V2's begins at the stop line of the minor street and flows into V1's a mere car length before V1 reaches that point. Downstream the intervals between V2's position marks are less than a third of V1's earlier ones, and V1's, from there on, no longer than V2's.",
#:   "Old Bassett drives as he farms, he takes what's next to him and then he does nothing with it. You're in the crossroads with every right to be, here's his pickup from the lane at the side, and now there's his tailgate where your road was. And you can put your feet up, because he'll be looking at everyone's wheat at a walking pace till the church.",
#:   "She pressed the imaginary pedal, as passengers do, when the dark shape broke from the side street and took the middle of the crossing from them. It stood in the way of nothing, it had turned its back and was going where they were going. But she kept her foot on the imaginary pedal, for it went there so slowly that they all but leaned upon it.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: position = "crossing"
#: actions = ["cut-in"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 11.0
#: unit = "m/s"
#: meaning = "how fast it comes in"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 1.0
#: high = 5.0
#: unit = "m/s"
#: meaning = "how fast it goes on in front of the ego"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(6, 11)
param OPT_SLOW_SPEED = Range(1, 5)

advTurn = ("straight", "right-turn", "left-turn")

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 3.5
    do DrivePath(egoRoute, globalParameters.OPT_SLOW_SPEED)
