#: description = "The oncoming car crawls against the traffic in the ego's lane."
#: rephrasings = [
#:   "an old chap is pottering toward us on the wrong side of the road",
#:   "Vehicle 2 was proceeding slowly in the wrong direction in lane 1.",
#:   "wrong-way, walking pace, our lane",
#:   "The target moves at less than 13 km/h in the lane of the VUT against its direction.",
#:   "A bus goes slowly in the contrary direction in the lane of the ego.",
#:   "A sightseeing coach rolls leisurely the wrong way up our lane.",
#:   "A confused motorist trundles toward the ego on the ego's own side.",
#:   "The lorry inches toward us, facing the wrong way in our lane.",
#:   "some pensioner was inching along towards me on my side of the road, going against everybody",
#:   "V2 was traveling against the flow of traffic in V1's lane at a very low speed.",
#:   "Truck in our lane, wrong dir., creeping twd us.",
#:   "The oncoming target proceeds at very low speed in the VUT's lane against the permitted direction.",
#:   "The bus comes in my lane in false direction, very slow.",
#:   "Ghost driver, crawl version: head-on in the ego lane at ~1-2 m/s, keeps coming and never stops.",
#:   "It came on against the stream, in their own lane, no faster than a man might walk, and it would not give way.",
#:   "Reports of a car on the wrong side, heading into traffic, he's only doing walking pace but he's still coming.",
#:   "theres a car coming the wrong way in our lane but like super slow",
#:   "A lost coach inched up the lane in the face of traffic",
#:   "You were in the wrong lane, facing my client, and advancing at a mere crawl?",
#:   "Lorry coming wrong side in our lane, slowly slowly, as if correct only",
#:   "Wrong way up my lane, and he's in no hurry about it either, tiptoeing along like it'll make it all right",
#:   "Low-speed opposing traffic in own lane, continuous wrong-way travel",
#:   "Bus drives the WRONG WAY in my lane at 5 km/h",
#:   "The pickup sneaked along against the flow toward us.",
#:   "Crawling head-on in our lane: a lorry, wrong direction.",
#:   "lost bus dribbles along our lane agianst the flow towards us",
#:   "Slow ghost driver: car toward us, our lane, walking speed.",
#:   "WRONG-WAY GRANDAD at 8 km/h, in my lane, still coming",
#:   "Have a van creep toward the AV in the AV's own lane.",
#:   "There's an estate car on our side of the road, pointing at us, and it keeps coming at a dawdle, as if reading house numbers.",
#:   "The opposing target occupies the VUT's own lane and advances in it contrary to the direction of traffic, at no more than 10 km/h.",
#:   "A tractor would have been quicker than that pickup, which was on my half of the road, coming at me, and simply didn't stop.",
#:   "The truck is driving in my lane in the inverse sense, so slow that one can walk next to it, but it advances always against me.",
#:   "At a snail's pace, and with a queue of hooting people before its radiator, a coach made its way up the lane reserved for those coming down.",
#:   "Attention all cars, elderly male in a saloon facing oncoming traffic in their lane, going dead slow but not stopping, he's still rolling towards them.",
#:   "I came round the bend and there was a car in my lane, front to front with me. The dear lady was hardly moving, I should say five or six miles an hour, but she was moving, and she carried on towards me as though it was her side.",
#:   "V2 was travelling eastbound in the westbound lane occupied by V1. Its speed, as determined from the video, was between 6 and 9 km/h and did not change. It came ever nearer to V1 in that lane, and its driver said she believed the road was one-way.",
#:   "Scenario wish: a bus driver has lost his way and is on our side of the carriageway, head-on to the vehicle under test. He's cautious about it, so he only inches along, but he goes on inching towards us and at no point comes to a standstill.",
#:   "Listen, I've seen wrong-way drivers doing a hundred; this one's the opposite. He trickled along in my lane with his face to me, in a big box lorry, first gear, warning lights going, and I could do nothing but watch him get bigger, very gradually.",
#:   "The fog had hidden it, and when they made it out it was a car in their own lane with its lamps upon them. It was creeping; it felt its way along the verge like a blind man along a wall, and it was creeping towards them.",
#:   "Coach faces us in our lane, dribbling forward, never halting.",
#:   "Contraflow at a crawl: one lost hatchback, our lane, still advancing.",
#:   "Snail with headlamps, wrong direction, our half, closing.",
#:   "A furniture lorry had got itself into our lane facing us and was nosing along in it at the speed of a milk float.",
#:   "Opposing target occupies the ego lane contrary to its permitted direction and keeps approaching at 1.5 to 2.5 m/s without coming to rest.",
#:   "Why is there a school bus on our side with its face towards us, and why does it keep on inching this way?",
#:   "The uncle has brought his Ambassador wrong side in my lane, and dead slow he is coming, but coming he is, not stopping at all.",
#:   "Put a saloon head-on in the AV's lane and let it trundle towards the AV, against the flow, no quicker than a pram is pushed.",
#:   "By inches, as it were, a tanker made headway against the traffic in the lane my client was lawfully using, and it bore down on her.",
#:   "You know how a glacier is said to move? I thought at first the thing was parked, facing me, in my own lane. I stopped, got my glasses, and looked at it against a lamp post. It was moving all right, a walking pace at most, and it was moving towards me, and it went on doing so.",
#:   "V1 was stationary by the time contact seemed likely. V2, a box truck which had strayed into V1's lane in the opposite direction, was still rolling at some 7 km/h, as it had been for the preceding sixty metres. The driver explained that in looking for a depot he had missed the one-way sign.",
#:   "The first lesson is that wrong-way doesn't have to mean fast. There's a people carrier up ahead in our lane, pointing at us. He's barely ticking over, you could outrun him in flip-flops, but he's not pulling up and he's not going away. So we stop now and give him every chance to see us.",
#:   "Nothing happened for so long that I could study the driver. She was sitting bolt upright, with her chin above the wheel, coming along my lane from the wrong end of it, and so gently that the pigeons didn't trouble to fly. The distance between our bumpers went down like the level in a bath.",
#:   "Requirement: deal with a slow ghost driver. The actor comes down the road toward the ego, takes the ego's own lane, and drives in it against the traffic at a speed below ten kilometres per hour. It is to go on rolling for as long as the run lasts, so waiting is no remedy.",
#:   "Base, I've got a single-decker nose-on to me in my lane. He must've come the wrong side of the bollards. He's in first gear with his hazards on, crawling, and no, he has not stopped, he's still coming at me. Can someone ring his depot and tell him to back out?",
#:   "It was the coach for the pilgrims and the driver was not from here. He drove on the side where I drive, in front of me, with the eyes to me. He had fear, I think, because he went with the speed of a procession; but like a procession he did not stop, he always came.",
#:   "Two lamps in the drizzle, low down and far apart, and in a place where lamps had no right to be: before us, in the very lane we were driving in. They grew. It took them a full minute to grow from pinheads to saucers, and behind them there was a lorry, feeling its way along.",
#:   "Dad had stopped and turned off the music. There was a car with its front to us, on our side where the arrows on the road point the other way. It came as slow as my tortoise. I asked if it was going to stop and Dad said it doesn't look like it, does it.",
#:   "That van driver's had a long day, bless him, or he's foreign; either way he's plodding up the lane I'm supposed to be going down, straight for me, at four miles an hour. I've flashed him, I've hooted him. He's waved. He's still plodding, and I've forty-four tonnes that don't reverse.",
#:   "The lane was as it should be, broad and straight, the markings fresh, and the oncoming traffic stayed on its half of the road with one exception. The exception was a bus. It had our half, it met us face to face, and it approached so sluggishly, yet so steadily, that nobody aboard seemed alarmed.",
#:   "Bus in our lane, nose to us, snailing nearer.",
#:   "Head-on lorry, our side, tortoise speed, won't stop",
#:   "contraflow Fiat, my lane, jogging pace, still coming at me",
#:   "The hearse coming down our lane the wrong way did so at a hearse's speed, and at that speed it ate up the room in front of us.",
#:   "He could have been parked in our lane, facing us, if it weren't that each time I looked he was a little less far away.",
#:   "Object in ego lane, heading 180 degrees to ours, speed 1.7 m/s; the ego being stationary the range decreases by 1.7 metres each second, without end.",
#:   "An army truck from the front side is sitting in my lane, no, not sitting, coming, but so slow that chickens are crossing in front.",
#:   "Set a minibus in the ego's own lane with its face to it, and let it ooze forward all the while, slower than a cyclist.",
#:   "We had the leisure to halt, to argue and to pour out tea, and throughout it the coach on our side kept trickling toward us, headlamps first.",
#:   "I'd have taken it for a breakdown: a van, in my lane, pointing at me, hardly moving if at all. So I put the hazards on and waited to be waved round. There's a crack in the tarmac thereabouts. His front wheel was beyond the crack when I arrived, was on it presently, and had it well behind him in a minute's time.",
#:   "Lost, he was, you only had to look at his face, and I had plenty of chance to look. He'd come up the wrong half of the road, our half, since the fork, with his chin on the wheel, reading the house numbers. Walking, you'd have got to us before him. But he did get to us. He never left off coming.",
#:   "Pick a lamp post, I said, and watch his mirror against it. Is he moving? Just. Is he in our lane? He is. Facing us? As you see. That's all you've got to know, dear, never mind that he's a doctor. He'll be here in twenty seconds if nobody does anything, and it won't be him that does it.",
#:   "The tram bell was rung, the postman's whistle was blown. The removal van paid them as little heed as it had the arrow on the road. It was in the lane of those who went down, and it was going up, at a foot's pace, straight into the faces of them all; and what was dreadful about it was the patience with which it came.",
#:   "The collision, had there been any, would have been at six kilometres per hour. That was V2's speed as it advanced, against the direction of travel, in the lane where V1 had stopped. The operator of V2 was of the opinion that the other carriageway was closed. He'd covered some fifty metres in this manner and had not halted at any point.",
#:   "Hold your fire on the horn, driver, he can't hear it. Big blue artic, French plates, he's come off the ferry and he's on the left, er, right, he's in your lane, whichever it is. He's doing four, five mile an hour at you. I've been flashing him from the bridge. He's waving. He's still doing four, five.",
#:   "Two suns were coming up over the hill, said Mia, and they were on our side of the road. Daddy said it was a car which had got mixed up. They were slow suns. We stopped and I counted to forty before they were so near that I had to shut my eyes. Daddy said it hadn't stopped yet even then.",
#:   "A slow car isn't news, and a car on the wrong side is, though not every day. What I had was both in one: a white Kia, in the lane reserved for me, facing me, being driven as though over eggs. I pulled up. The eggs came on. We'd have met quite gently, bumper to bumper, if I had not gone on to the grass.",
#:   "To the planner a stationary obstacle looks much the same. The point of this actor is that it isn't stationary. It occupies our lane head-on and bears down at one to two metres per second, for as long as we care to watch, so that the space we need for steering out gets less with every second of indecision.",
#:   "My clutch foot went to sleep. There's a bend, then there's three hundred metres of single lane for our direction, and at the far end of it was a bus, for the other direction, in ours. I shut off the engine. I rolled a cigarette and smoked it. By the filter I could see what he'd had for breakfast, and his wheels were still turning.",
#:   "She held the estate car in the middle of the lane, as her late husband had taught her, and at ten miles an hour, as he had too. It wasn't her lane, that was all. It belonged to the startled people in front, who had now stopped and got out. They seemed to be growing. She wondered, mildly, rolling on, what they wanted.",
#: ]
#: adversaries = ["car", "truck", "bus"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "slow"]
#: position = "oncoming"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.5
#: high = 3.5
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_OFFSET"
#: low = 0.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far toward its own side it keeps when it meets the ego"

param OPT_ADV_SPEED = Range(1.5, 3.5)
param OPT_ADV_OFFSET = Range(0, 3)

behavior AdvBehavior():
    do DrivePath(advTrajectory, 8) until gap(self, ego) < 75
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 1 and gap(self, ego) < 30
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED, -globalParameters.OPT_ADV_OFFSET)
