#: description = "The pedestrian runs into the lane, stops to pick something up and runs back with it."
#: rephrasings = [
#:   "The kid dashes out, grabs his ball and dashes back in.",
#:   "The child entered the roadway to retrieve an object, halted, and returned to the shoulder.",
#:   "ped runs in, picks up item, runs back",
#:   "The target runs to the VUT's path, is stationary while bending down, and returns to its origin.",
#:   "A boy runs in the road, takes the toy and goes back fast.",
#:   "Someone who dropped a wallet rushes out, stoops for it and hurries back.",
#:   "A girl darts into the lane to save the kitten and carries it home.",
#:   "He nips out for the hat that blew off, snatches it up and retreats.",
#:   "A kid legged it out after his football, scooped it up and scarpered back with it.",
#:   "A child ran into the roadway to retrieve an object and ran back with it in hand.",
#:   "Child runs in, bends, grabs ball, runs back.",
#:   "The child target runs into the lane, halts to retrieve an object and returns to its origin.",
#:   "The girl runs on the road, takes her ball and runs back home.",
#:   "Runner dashes in, short dwell (pickup anim), runs back with the object to the same side.",
#:   "Her hat had blown off; she flew after it into the road, snatched it up and fled back with it.",
#:   "Ball's come out, and where there's a ball there's a child, here he comes, he's got it, he's gone back.",
#:   "lil kid ran out to get his ball and ran back w it, heart attack",
#:   "A youngster rushed into the road after a toy, gathered it up and made it back unhurt.",
#:   "The child entered for no purpose but to recover an article, stooped for it, and bore it back.",
#:   "Small boy came running for cricket ball, picked it and ran back to gully.",
#:   "Ball first, nipper second, stoops for it in front of my wheels and off home with it under his arm.",
#:   "Child incursion for object retrieval with stop in lane and return to side of origin",
#:   "KID CHASES BALL, GRABS IT, RUNS BACK",
#:   "The girl darts in, snatches up her toy and flees back.",
#:   "Boy bolts in, halts for his kite, bolts out holding it.",
#:   "Pedestrian: run into lane, stoop, gather object, run home.",
#:   "Niña runs in the street, stays to take the doll, runs again back.",
#:   "Jogger lost an earbud, sprints in, pauses over it, sprints back.",
#:   "Have someone tear into our lane, retrieve a hat, tear back.",
#:   "A schoolgirl came running off the pavement in front of the AV, stood there bent over her spilled books, and ran back to it hugging them.",
#:   "The old man's cap had blown under our noses; he trotted out, stopped to pick it off the tarmac, and with it in hand trotted home.",
#:   "The dummy enters the lane at 3 m/s, stands still over the item for two seconds and, item attached, returns at 3 m/s to its start.",
#:   "Slow right down: that toddler's mum has raced out for the shoe he threw, she's stopped to get it, and with it she's racing back to the pram.",
#:   "He was already safe again on his side with the frisbee under his arm, having rushed into my lane and stopped there to lift it from the road.",
#:   "Running at full tilt, the market trader got into V1's lane, came to a stop to collect a fallen crate, and carried it back at the double.",
#:   "It was a teddy bear that lay there, we saw afterwards. A woman in slippers flew out of a garden gate into our lane, stopped, crouched, had it by one ear, and was flying back through the same gate before our car had come to rest.",
#:   "The pedestrian, aged nine, entered the traffic lane at a run from the north footway. He became stationary within the lane and took up a tennis ball from the surface, upon which he ran to the north footway with it. He at no time attempted to reach the south side.",
#:   "You're all eyes on a delivery round. I see something shiny in the road, and I think, that's a phone, somebody'll want that. Sure enough out pelts a lad, skids to a halt in front of my van, snatches it, and off he pelts back to his mates.",
#:   "The prediction should not extrapolate a crossing. Behaviour wanted: the person runs from the kerb to the ego's lane, makes a halt there long enough for grabbing a thing off the ground, does a 180 and runs with it to the kerb it came from.",
#:   "My ball went on the road and I ran after it. I had to stop because it was under my foot and then it wasn't, and then I got it. The car was coming so I ran back to Tom with the ball. Mummy was very cross.",
#:   "Boy races in, stops over his cap, races home with it.",
#:   "Teen runs out, halts, grabs the dropped phone, runs back.",
#:   "kid sprints into my lane stops grabs the drone sprints off home",
#:   "A woman came running into our lane after her scarf, stood still long enough to gather it up and ran with it to the pavement she'd left.",
#:   "Child pedestrian enters the lane at a run, stops to collect an item off the road surface, and departs at a run to the starting side, item in hand.",
#:   "There's a shuttlecock in the road, so you know what's next, in he tears, he's stopped for it, got it, and out he tears to his sister.",
#:   "One small girl came running in front, there she stopped for taking her slipper, and with slipper in hand again she's run to her mother's side.",
#:   "I want someone on foot to rush into the ego's lane, halt there to lift an object from the tarmac and rush with it to where they came from.",
#:   "Nurse loses papers: she dashed off the kerb in front of the bus, paused in its lane to snatch them up, and with the lot dashed to the kerb again.",
#:   "I didn't know what it was until he held it up to show his pal. He had come haring off the pavement into my lane and pulled up short right before my van. Down went his hand, up came a tin soldier, and he hared off to the pavement that he'd come from with the thing over his head.",
#:   "The insured was travelling along Acre Lane when a balloon seller ran into the lane ahead of him. The man came to a standstill there, bent down and took hold of a string. He ran off to the same footway with the balloon, leaving the insured stationary and, he states, badly shaken.",
#:   "Where she stopped there was a purse, or rather there had been one, for she'd got it now. She had flown at it from the bus shelter, into the very lane where we were, on heels like knitting needles. It was back to the bus shelter that she flew, too, clutching it to her coat, and the bus hadn't left without her.",
#:   "N1, age 7, ran from the west sidewalk into the northbound lane. N1 stopped in the lane and picked up a plastic dinosaur. N1 then ran to the west sidewalk carrying the dinosaur; the driver of V1, who had braked to zero, estimated the time in the lane at three seconds.",
#:   "My apple fell out of my bag and it rolled, and it was the big red one. I ran to get it and it was in the road where the cars go, so I stood there and picked it up. Then I ran back to the lollipop lady with my apple and she was all white.",
#:   "You'd be amazed how fast an old lady moves for a terrier's squeaky bone. The thing had landed bang in the lane I was driving along. She was out there at a gallop, she came to a stop over it, she had it; and she galloped to her garden gate, where the terrier was waiting, with me and my forty tonnes hissing at a standstill.",
#:   "For the intent dataset: label this one RETRIEVE, not CROSS. Evidence is as follows. The subject runs toward a stationary small object in our lane, is at zero velocity beside it for 1.3 s with trunk flexed, and when it runs again its heading is opposite to the first and the object is no longer on the ground.",
#:   "The wind that day would have had the milk out of your tea. It had the vicar's hat, anyhow, and rolled it in front of us. He sprinted in after it, cassock and all, he stopped it with his foot and himself along with it; and holding it down on his head with both hands he sprinted off to the church side.",
#:   "In Valencia the boys play in every street. The ball comes, so I brake, and behind the ball comes the boy, running like mad, to my lane. He stays quiet there one second for take it in his arms, he says me sorry with the eyes, and he runs with it to the same side, with his friends.",
#:   "Unit 12, stand down, the child's off the road. He'd bolted into the eastbound lane after a skateboard, stopped in the lane to get it, and a silver cab had to do an emergency stop. He's legged it to the near pavement with the board under his arm and is being spoken to.",
#:   "It had been only a letter, and she would have let anything else go. She was in the lane before she knew that she was running, and there, with headlamps on her, she stood and unpeeled it from the wet road. Then she fled with it to the doorway out of which the draught had taken it, and read the first line.",
#:   "Sprint in, pause over a mitten, sprint home with it.",
#:   "He tears out, plucks his cap from our lane, tears back.",
#:   "Girl gallops in, stands, scoops, gallops back with the kitten.",
#:   "I braked for an empty-handed boy who was pelting into my lane, and by the time I'd stopped, a boy with a kite was pelting out of it again.",
#:   "Pedestrian dummy: run from kerb to ego lane, standstill for the stop time beside the object, 180 degree turn, run back to the kerb carrying the object.",
#:   "postman drops one parcel, ONE, hares into the road for it, stops in front of my bumper, grabs it and hares straight back to his trolley w it",
#:   "His slipper came flying first in my lane, then he came flying, then for one second he stood bending, then foot and slipper both went flying home.",
#:   "The doll that lay ahead of us lay there no longer: a child had raced in from the left, halted over it and raced away left, doll under arm.",
#:   "Had the lad not stopped to grab whatever it was in front of the ambulance, he'd have been back on his pavement with it even sooner than he was.",
#:   "You could tell the story with the things alone. There's a pavement with a scooter on its side, and a glove in our lane. There's no glove; there's a girl over the place where it was, on one knee, with our headlamps on her hair. There's a pavement again, with a scooter on its side, and a girl next to that, out of breath, putting on a glove.",
#:   "I don't brake for paper bags. A man in an apron thought otherwise. He came out of the shop like a shot, straight in before us, and dropped on it with both hands, and there he was, not going anywhere. It held the day's takings, he told me after. He told me from the shop door, for that's where he'd run with it.",
#:   "The pedestrian's velocity component towards our corridor is plus 3.9 m/s for two seconds. It's zero for 1.1 s; height above ground of the head drops by half. It's then minus 3.9, to within ten centimetres of the starting point. The static object of class \"toy\", which we'd meant to straddle, has gone from the lane and is travelling with him.",
#:   "A tennis racket lies in the lane; on the near pavement a boy has seen it as well. Brake now, that's right. In he dashes, and there he sticks, fumbling, for it's got wet; don't hoot, he'll be quicker without. He's up with it and dashing to his pavement, so check, and on you go.",
#:   "\"She'd one shoe on,\" the driver of the bus said, \"and I looked for the other, and it was in front of me.\" The lady, running as one does on one heel, was out there; she stood on the bare foot and took the thing up from under his bumper. And with it in her fist she ran, no less crookedly, to the pavement where her friends were.",
#:   "Insured was stopped by a cat. To be precise, insured was stopped by a neighbour who had darted out of her front garden into insured's lane, for the cat sat there. The neighbour remained on the spot until she had got hold of it, a matter of two seconds. She darted into the same front garden with the cat over her shoulder, and insured's rear was struck by a moped.",
#:   "I was sitting in the robotaxi the wrong way round. We stopped hard. I saw the faces of the people on the left-hand pavement, they all went from left to middle like at tennis, mouths open. They stayed there; somebody screamed \"Leave it!\" Then all the faces came back to the left, and a small boy arrived among them at a run, hugging a football.",
#:   "When the wind had his mother's umbrella off him I knew he'd be after it. In front of my lorry it hung on a drain and that's where he fetched up, having come in like a hurdler; he'd to tug. I gave him all the time he wanted, I was stopped. He went off with it like a hurdler, too, to the steps he'd come from.",
#:   "N1, approximately 10 years of age, left the playground gate at a run and reached the center of V1's lane. There N1 halted and bent toward an object later identified as a shin guard. V1 had stopped eleven feet short when N1, shin guard in hand, ran through the playground gate; at no time had N1 been on the far side of the road.",
#:   "In my country we've a word for somebody who gives more for the hat than for the head. An older man, well dressed; the hat flies in my lane. He runs behind, he, with seventy years! Before my car he stands and searches the hat under his own foot, I've closed my eyes. When they were open he was running to his bench, hat on the head, head also there.",
#:   "What is a letter from the bank to a gust of wind? It lay down before the coach. She went in after it with her apron flying and all her bracelets, and she stopped, as a runner stops at the tape, with her toe upon the envelope. Then she'd the envelope at her breast, and the bracelets rang the other way, as fast, and the gate banged to.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cross", "brake", "stop", "turn-back"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.8
#: high = 5.5
#: unit = "m/s"
#: meaning = "how fast it runs"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 24.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary reaches its line"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.2
#: high = 1.25
#: unit = "m"
#: meaning = "how far from the ego's line it stops"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.6
#: high = 1.4
#: unit = "s"
#: meaning = "how long it bends down"

param OPT_ADV_SPEED = Range(2.8, 5.5)
param OPT_ADV_DISTANCE = Range(0, 24)
param OPT_STOP_DISTANCE = Range(0.2, 1.25)
param OPT_STOP_TIME = Range(0.6, 1.4)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 3.14159) until abs(offsetFrom(egoRoute, self)) > 3.5
    do Halt()
