#: description = "The pedestrian sprints across the road on a slant."
#: rephrasings = [
#:   "He cuts the corner at a flat-out run, slanting away over the road in front of us.",
#:   "The pedestrian ran diagonally through the roadway at a high rate of speed.",
#:   "ped sprints diagonally over",
#:   "The target crosses obliquely at running speed, not perpendicular to the VUT's path.",
#:   "The person is running very fast over the street, but in an oblique way.",
#:   "A fare dodger pelts across at an angle with somebody after him.",
#:   "Late for the bus, she charges slantwise through traffic.",
#:   "The young runner takes the long diagonal over the tarmac at full tilt.",
#:   "This lad legged it over the road at an angle, taking the long way across instead of straight over.",
#:   "The male subject ran at full speed across the roadway in a diagonal direction.",
#:   "Ped sprinting, slantwise X-ing, kerb to kerb.",
#:   "The adult pedestrian target runs on an oblique trajectory, at an angle to the VUT's path, at sprint speed.",
#:   "A boy runs very fast over the street, not straight but crooked, like from corner to corner.",
#:   "Ped trajectory is oblique, not perpendicular, at 5+ m/s; predictor assumes a 90 degree crossing and fails.",
#:   "He was late for his bus and tore across cornerwise, making for a point far down the opposite pavement.",
#:   "Runner! He's cutting the road cornerways, full pelt, so he'll be in your path longer than you'd think.",
#:   "some guy sprinting corner to corner over the road like its a 100m final",
#:   "A young man raced over the carriageway on the bias, heading for a waiting bus.",
#:   "He did not go straight over, did he; he ran, at full pelt, on an oblique line to the far pavement?",
#:   "One boy ran very fast across, not straight also, slanting slanting to other side.",
#:   "Can't go the short way, this one, he has to gallop over cornerways in front of me.",
#:   "High-speed pedestrian crossing on oblique trajectory.",
#:   "GUY SPRINTS ACROSS ROAD DIAGONALLY, DOESN'T LOOK",
#:   "A runner slashed cornerwise across the street.",
#:   "Teenager bombing over the road slantways, hood up.",
#:   "Jogger at full speed cuts over the street obliquely.",
#:   "Have somebody race across at an angle, flat out.",
#:   "Lady legging it slantwise through traffic, lane to far corner.",
#:   "Subject fled over both lanes obliquely at top speed.",
#:   "A kid with a football under his arm came haring over, not the short way but aiming for the ice-cream van further along.",
#:   "The woman was running how you run from a dog, and she made a crooked line over the whole avenue in front of my car.",
#:   "V1's camera recorded the pedestrian traversing the lane at a dead run on a heading some forty-five degrees off perpendicular.",
#:   "Did you see that man shoot over the street on the cross, heels flying, as if the shortest way did not interest him?",
#:   "For scenario 12 the walker shall be replaced by a sprinter, whose track over the carriageway forms an acute angle with it.",
#:   "From the cab I saw him go like a hare, kerb to kerb, but skewed, so he was in front of me twice as long.",
#:   "It was pouring and a fellow with a newspaper over his head came belting over the road. He didn't take the straight way, he bore off toward the tube entrance down the street, so our two paths met for ages.",
#:   "Officer, she never looked. She flew off the pavement as fast as her legs would carry her and took the carriageway on the slant, heading for the tram shelter, and my car had to stop very hard.",
#:   "Now this one is nasty for the tracker. The pedestrian bolts, around six metres per second, and the line she takes over the road is angled along it, so the predicted exit point keeps sliding away from you.",
#:   "The boy is chased by his friends in the play. He runs very quick over the street and he goes like the line from one corner of a box to the other one, and the robot car must see him.",
#:   "From the saddle I watched a suited man launch himself over the road, tie over his shoulder. Rather than going square he slanted away up the street at a gallop, towards the closing doors of a bank.",
#:   "Somebody bolted over the street, corner to corner, coat flying.",
#:   "Kid. Full gallop. On the skew. Right over our lane.",
#:   "Whoosh, a barefoot lad, haring slantways to the other kerb!",
#:   "The jogger went into a flat run and aimed at the far traffic island instead of straight over, so that she was ages in front of us.",
#:   "Pedestrian track runs at roughly forty degrees to the lane marking, five to six metres per second, no pause from kerb to kerb.",
#:   "I'd like a teenager who flies over the street as fast as he can go, with a bearing well off square.",
#:   "The boy did run so fast like a dog with a sausage, and he took the crooked way to the bus, not the short way.",
#:   "In an instant the woman had shot off her doorstep and was racing over the carriageway in a line that leaned away up the hill.",
#:   "dashcam vid: guy late for train does a full-on sprint over 2 lanes, bottom left of screen to top right",
#:   "We were first on the scene because it happened in front of our ambulance. A shop alarm had gone, and a figure with a carrier bag was pounding over the high street, not to the pavement opposite but to the alley thirty yards further along, so his line and ours ran together far too long.",
#:   "The sensor first saw feet, very quick, below the parked van. Then he was out, a tall lad in football kit, legs going like pistons, and each frame put him not only farther over the road but farther up it too, right until he vaulted the railings by the chip shop.",
#:   "Asked by counsel why she hadn't simply steered behind him, the defendant said there was no behind. He was tearing over at such a rate, and so much aslant, that wherever she pointed the car he was still before it; and by the time he'd reached the far gutter he was level with the post office.",
#:   "My little sister saw the puppy on the other side by the playground and we were at the sweet shop. She didn't look, she just ran and ran as fast as she could, and it's not opposite, the playground, it's down a bit, so she ran sort of like the stripe on a no-entry sign... no, on a sash!",
#:   "Some of you will say he jaywalked. Fine. But my beef is with the geometry: if he'd run straight over, he'd have been gone in a second and a half. Instead this marathon man picks the longest line he can, kerb here, kerb way down there, absolutely legging it, and I'm on the brakes for three.",
#:   "Test 14b differs from 14a in two respects. The dummy's propulsion is set to sprint, and its rail isn't laid square to the lane but turned so that start and end points lie twelve metres apart lengthwise. As before, it's released when the vehicle under test comes within the trigger distance.",
#:   "It was hailing and the whole queue at the tram stop had run for it already, all but the cellist. With her case on her back like a beetle she came charging over, not square, far from it; she steered for the awning of the Café Mozart, down the road, and I saw every stone bounce off her.",
#:   "Dispatch to all units, suspect on foot, last seen leaving the bookmaker's at a dead run. He's gone over Mill Street cornerwise, from the bookie's to the canal steps, and a motorist had to stand on everything not to hit him. No idea why he didn't take the crossing.",
#:   "The smell of her perfume came through the vents, that is how near it was. A woman in one shoe had pelted over my bonnet's path on the bias, bound for a taxi with its door open twenty metres away, and all I could do was to sit there and breathe, my foot shaking on the pedal.",
#:   "As lorry driver I know the ones who walk straight, I give them two seconds. But here was one, he was fleeing from a wasp I believe, arms over head, with full speed, and he was fleeing slantwise, so after my two seconds he was still before my lorry, only more far.",
#:   "Our pupil stopped beautifully, so well done him. A boy had dropped everything and was streaking over toward his mum, who stood a good six houses on at the other side, which meant that he was cutting along the road as much as over it. You don't get long with a runner, do you?",
#:   "A red tracksuit streaking slantwise from our kerb to theirs.",
#:   "Full gallop, corner to corner, right over our road.",
#:   "Lad on foot, flat out, aslant over both lanes.",
#:   "He was heading for the bus shelter up the road on the other side, and he took the straight line to it, as fast as two legs will carry anyone.",
#:   "Subject left the store at a dead run and traversed the avenue cater-corner, forcing an automated shuttle to brake until he had reached the far sidewalk.",
#:   "The lady with the hat flew from one side to the other, not square like you must, but crooked, and her shoes she has lost.",
#:   "Set the dummy to its highest speed and turn its track to some fifty degrees off square, so that it eats up road in both directions.",
#:   "What looks like a shadow sliding from lower right to upper left of the picture is a schoolboy who'd heard the last bell, belting over on the bias.",
#:   "Have you noticed how a person who pelts over at an angle is harder to brake for than one who goes straight, since he stays in your way?",
#:   "I never saw his face, I saw the soles of his trainers, one, two, one, two, like a sewing machine. They were pointed at me a bit, that's because he was making off up the street as well as over it. By the time he'd hopped the far kerb he was level with the third lamp post, and I'd gone past none.",
#:   "Two things we got wrong. We took him to be as quick as a walker, and the tracker had him doing 6.4 m/s from the first frame; and we took it that he'd leave our lane by the shortest way. The way he chose had a good fifteen metres of our lane in it, lengthwise, as it led from the kiosk to the station door.",
#:   "The ice cream was still in the air, if you see what I mean, and she was gone. A wasp, I gathered. There went this girl, arms up, hair straight out behind her, from the bench on my side to the fountain on the other, which is a fair step down the road. She cut it like a pair of scissors. I'd stopped by then.",
#:   "My instructor said, \"Look where he looks.\" The man at the kerb was looking not opposite but far to the left, at a taxi with its lamp lit. So when he went, and he went like a sprinter off the blocks, I knew that he'd take the hypotenuse. It meant staying off the gas for longer than you'd think.",
#:   "They've measured it for the inquest. From the bloodstain, thank God only a nosebleed, on the near kerb to the railings he leapt on the other side it is nineteen metres, whereas the road's eight wide. The bakery camera has him cover them in under three seconds. The car's driver had no business expecting that, I'd say.",
#:   "It was like in football when the ball goes behind the defender. I look where the boy will be and he's not any more there. He ran with all what he has over the street but always also away from me in the direction of the bridge, and my car was running after him with the brakes on.",
#:   "The bells had begun, so the verger ran. Cassock hitched to the knee, he came off the almshouse steps and went over the road at such a pace, and so much askew, that the driver of the hearse, braking, seemed to be chasing him down the street. He gained the lychgate, forty yards along, on the last stroke.",
#:   "In the log there's a box labelled pedestrian, and its arrow is as long as those of the cars. That's the speed. The arrow isn't at right angles to our own either; it leans forward so heavily that it stays over our lane for eight whole frames. Nothing slows, nothing stops, until the box is on the far pavement.",
#:   "Granny held my hand so I didn't do it. It was a big boy. He wanted the bus and the bus was not opposite, it was there, at the tree. And he went wheeee, so fast his rucksack was bouncing, slanty like a slide, all over the road, and our taxi had to squeak.",
#:   "A shoplifter with a leg of lamb delayed the number 6 yesterday. \"He shot out in front of us like a rabbit,\" said its driver, \"and I thought he'd be over in a jiffy. But he was making for the alley by the bank, so he went corner-ways. Fastest thing I've seen on two legs, and in my road all the while.\"",
#:   "lmao did anyone else see the guy in the bathrobe on the high st this morning. towed car obv. hes legging it after the truck, proper sprinting, slippers gone, right over the road on a massive slant, and the waymo thing just sat there bowing to him",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "diagonal", "fast"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 7.0
#: unit = "m/s"
#: meaning = "how fast it runs"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 6.0
#: high = 18.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary reaches its line"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.5
#: high = 0.95
#: unit = "rad"
#: meaning = "how far its way turns from straight across"

param OPT_ADV_SPEED = Range(4, 7)
param OPT_ADV_DISTANCE = Range(6, 18)
param OPT_ADV_ANGLE = Range(0.5, 0.95)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 3.5
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE if offsetFrom(egoRoute, self) > 0 else -globalParameters.OPT_ADV_ANGLE)
