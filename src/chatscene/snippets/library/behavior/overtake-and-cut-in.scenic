#: description = "The car overtakes the ego and cuts in close in front of it."
#: rephrasings = [
#:   "He blows past us and tucks in right under our nose.",
#:   "Vehicle 2 passed vehicle 1 and returned to the lane with insufficient clearance.",
#:   "Overtakes, then tight merge before us.",
#:   "The target passes the VUT in the adjacent lane and cuts in at small longitudinal distance.",
#:   "He overtakes and comes in too early, almost touching our front.",
#:   "A lorry grinds by us and pulls back in before its tail is clear.",
#:   "The coach passes and crowds us off as it returns.",
#:   "A motorbike comes from behind, gets by and drops in at arm's length.",
#:   "some BMW flew past me and chopped right back in under my nose",
#:   "The vehicle passed V1 and moved back in directly ahead with minimal clearance.",
#:   "MC passes, tucks in v. close.",
#:   "The target passes the VUT and returns to the lane at a very small longitudinal distance, keeping its speed.",
#:   "The motorbike goes by me and comes back very near before my car, then drives on.",
#:   "Pass-and-tuck: overtaker re-enters the ego lane with almost no clearance; no braking required.",
#:   "It had drawn by on the outside and then shouldered in so close that they could read its tax disc.",
#:   "He's gone by you and pulled back in far too early, he's nearly clipped your wing, but he's away.",
#:   "he overtook us and pulled in SO close i could read his stickers",
#:   "A motorcyclist swept by a learner and tucked in barely a foot ahead of her",
#:   "You passed my client and regained the lane with scarcely any room before her bonnet, but you did not brake?",
#:   "He overtake us then squeeze in front so near, almost kiss my bumper",
#:   "Comes round me, tucks in with a fag paper between us and swans off",
#:   "Overtaking with insufficient clearance on return to lane",
#:   "Motorbike overtakes and nearly clips my FRONT BUMPER",
#:   "The coupe leapfrogged us and shaved our nose.",
#:   "goes by us and drops back in waaay too tight",
#:   "Motorcyclist passed, then squeezed himself between us and nothing.",
#:   "Overtaker returns to our lane with barely a car's length.",
#:   "CLOSE SHAVE: SUV passes and chops across our nose",
#:   "The cab went past and folded in hard on our bumper.",
#:   "The saloon came up on the outside, passed the AV and returned to the lane so early that its rear bumper all but brushed the AV's wing.",
#:   "I'd like a fast car to come from behind, go past us in the next lane, and then take our lane again with next to no clearance.",
#:   "Having gone past, the target vehicle re-enters the lane of the VUT at a time gap of less than half a second and maintains its speed.",
#:   "Why did he have to come back in so soon, when he had the entire road ahead of me to finish his pass in?",
#:   "A motorbike which was behind has doubled us and has folded back just before our bumper, I could have touched it with the hand, and it continued.",
#:   "Two feet, no more, was what the van left us when it slid over in front of our bonnet after it had gone by.",
#:   "A people carrier came past me on the motorway with its box on the roof. Most people would have waited till they could see both my headlamps. She didn't, she pulled over into my lane the moment her tail was clear, and then carried on at speed.",
#:   "Vehicle 2 passed Vehicle 1 in the adjoining lane at a speed difference of some 20 km/h. It then moved laterally into the lane of Vehicle 1 with a bumper-to-bumper distance of about two metres, did not brake, and continued along the lane ahead of it.",
#:   "For the cut-in series please vary the clearance. The car approaches from the rear in the left-hand lane, gets ahead of the test vehicle and immediately comes across in front of it, close enough to violate the safety distance; after that it just drives on.",
#:   "You've done nothing wrong there. That motorcyclist went round you, which is his right, but then he came in on you when he was hardly past your front wheel. Ease off a touch and let your gap grow again; he's away up the road now.",
#:   "So there I am, bimbling along, and this Golf comes by me. Fair enough. Only he's still about half alongside in my head when he's already over in my lane, and I am staring straight at his tailgate. Never slowed, never waved, just trundled off ahead.",
#:   "Passed us, then folded into our lane with inches to spare.",
#:   "Motorbike comes by, drops in against our bumper, keeps on going.",
#:   "Squeezed on completion: he'd barely cleared us before taking our lane.",
#:   "The sports car ran past us and reclaimed the lane so soon that I'm surprised the paint on my front wing is still there.",
#:   "Overtaking target re-enters at 0.3 s headway with no deceleration; the ego must restore its gap while the target continues at speed.",
#:   "A whole empty road, and he has to slot in on the end of my bonnet the moment he's gone past, what is the hurry?",
#:   "This taxi has crossed me from side and immediately he came inside, between his boot and my bumper not even a goat can go.",
#:   "Let a motorcycle go round the robotaxi and merge back practically on top of its front bumper, then ride on without braking.",
#:   "passed me, pulled in, i could of leaned out and touched his exhaust, and off he went down the bypass",
#:   "The collision warning is what woke the baby. An estate had come by on our outside, perfectly legal, and I thought no more of it. A moment later its roof box was hanging over our bonnet, or so it looked, because it had come across as soon as its rear door was past. It sped on.",
#:   "Vehicle 2 approached from the rear in the adjacent lane at approximately 70 mph. Upon gaining a lead of some two metres on Vehicle 1 it steered into Vehicle 1's lane. No brake lamps were observed. Vehicle 2 proceeded ahead and Vehicle 1's driver reduced speed in order to regain a safe interval.",
#:   "Two headlamps in the inside mirror before you come back in, I always say. That girl who's just gone past us couldn't have seen so much as one. She's come in on us so tight that I reached for my own brake. Drop back, she's pulling on ahead anyway, and breathe out.",
#:   "My handlebars shook. The black saloon had been behind, then it was next to my knee, then without a pause it was in front of my wheel, and I mean the very next thing in front, nothing between us but spray. It carried on up the hill at the pace it had come with.",
#:   "The desired metric is the minimum gap at lane re-entry. A faster car passes the subject vehicle in the neighbouring lane, and at a configurable lead of one to four metres it slides into the subject vehicle's lane. It holds speed from there on, so the gap afterwards grows by itself.",
#:   "There was a thing like a shadow on the left, and the thing like a shadow was a motorbike. It should have gone on a bit. Instead, hardly had its back wheel drawn level with our front one than it had slipped in before us, so near that its tail lamp lit the inside of our car.",
#:   "When one is eighty-four one likes a little room. A young lady in a jeep did not give me any; when she had got by she simply drew the jeep across, like a curtain, right before my bonnet. She didn't slow down and I didn't hit her, and that was all there was to it.",
#:   "The radar showed zero metres for one cycle, which the supplier swears is impossible. It isn't, given a coupe that comes up from behind in the left lane, gets its tail just past our nose and tucks in at once. The reading rose again from then on because the coupe was the faster of us.",
#:   "Forty-four tonnes don't stop for manners. This hatchback comes alongside, creeps past my cab, and I lose him. Under the screen he was, in my lane, right where I can't see. First I knew was the roof coming out from beneath my wipers as he pulled away again.",
#:   "I have nothing against to be overtaken. But the rider of the Kawasaki came after the passing so sharply back to the right that he has cut the way before my front wheel; I mean there were not two metres. Then he was going on, with the same speed, like if I did not exist.",
#:   "What the witness on the bridge described was a zip being closed. The grey car came up the outer lane, its nose moved ahead of the blue one's, and as soon as its tail was clear it was in the blue one's lane, without any daylight between the two. It then drew away northward.",
#:   "Motorbike: past us, in on us, off ahead. Hairbreadth.",
#:   "Passing car reclaims our lane with its tail still on our nose",
#:   "A pass, then a shave, and he drove right on.",
#:   "Once level, then ahead by the thickness of a coat of paint, then in our lane; the cab had gone on before I found the brake.",
#:   "Lateral move of the passing scooter into the VUT's lane commences at a lead of 1.6 m; its speed is thereafter maintained.",
#:   "He went by me and was in my lane so quick I saw his back tyre go under my bonnet, or it looked so, and away he rode.",
#:   "When somebody overtakes you and there's no gap at all between his tail and your front at the end of it, he hasn't finished overtaking, he has barged.",
#:   "The large SUV does overtake of us, then it makes our front its own front with one hand of space, and continues without any brake.",
#:   "Have the sports car come by on the outside, fold in across the ego's bumper with barely a length of daylight, and keep its foot in.",
#:   "The bug I'd been watching walk up the windscreen fell off, that's how suddenly I lifted. For the whole of the view was brown. A brown van had been on its way by us, and had not bothered to get all the way by before taking our lane. Then the brown shrank to the size of the bug, and went round a bend.",
#:   "My trailing leg was out for balance, as it is after the roundabout, and I whipped it in again. A car had been drawing along my right and had got its boot to about my knee when it came over. Not braking or anything, he just wanted the left lane and wanted it there. And on he went, quite happily.",
#:   "Let's do the arithmetic of that one. He's a car length, four metres, and he needed to be a car length and two seconds clear before coming back in. He came back in when he was a car length and nothing. No harm's done, since he's faster than you and it's opening up by itself. But you'd to lift, hadn't you?",
#:   "Distance to the object in front was displayed as \"none\" the entire morning, the road being empty. It was displayed as \"one metre\" at 10:42, for the object that had come from our rear via lane two and gone straight from lane two to our bumper. It was displayed as \"twenty\" a few breaths later and soon as \"none\" once more.",
#:   "When the driver of the minibus was asked whether he'd been overtaken before the incident, he said yes, that was the incident. The motor cycle passed him on the off side. \"Then it wanted to be in front, sooner than there was a front.\" He had to swerve an inch or two. It never slackened, and he lost sight of it.",
#:   "She felt, rather than saw, that the thing alongside would not leave her room. It was long and low and had been stealing forward past her elbow. As soon as its last inch was by, it leaned in, and the red eye of its tail was right upon her; she could have spat on it. Then the eye fled, small and unashamed.",
#:   "A tail lift has a sticker on it that says, if you can read this you're too near. I read it. I hadn't done anything, I'd sat in my lane doing fifty-four, and there'd been a pickup with one of those lifts on my outside, and next there was a sticker, dead ahead. By and by I couldn't read it again.",
#:   "The manoeuvre consists of two parts, and the fault lies in the second alone. Part one: from a position at the rear, the hatchback proceeds in the left lane until its rear bumper is just beyond the front bumper of the AV. Part two: it enters the AV's lane at once. It doesn't decelerate, so the AV merely has to wait for the gap to regrow.",
#:   "I'd have preferred him to brake, so that I'd something to be angry about. But no. He whooshed up by my right shoulder, he nicked the six feet of road I was about to drive on, with my bonnet as good as under his spoiler, and he whooshed off along it as though nothing could be more natural.",
#:   "It cost us a pair of eyebrows, figuratively. The test driver had just logged \"motorcycle, left, overtaking, no issue\". He'd not finished typing \"issue\" when its rear mudguard was inside the closest ring of the display and in our lane. The motorcyclist shifted up, stretched the distance to ring two, to ring three, and left the display.",
#:   "Overtakings are free in my autobahn country, but after it one shall see the overtaken in the mirror! This gentleman in the Porsche hasn't seen me in the mirror, he has had me on his exhaust. He was left of me, he was before me by one arm, he was in my lane. Then with the same two hundred he was gone.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: passing; own code"
#: [slots]
#: actions = ["overtake", "cut-in"]
#: leader = false
#: maneuver = "straight"
#: position = "behind-beside"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 11.0
#: high = 14.0
#: unit = "m/s"
#: meaning = "how fast it overtakes at most"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 0.5
#: high = 6.0
#: unit = "m"
#: meaning = "how far ahead of the ego it is when it moves over"

param OPT_ADV_SPEED = Range(11, 14)
param OPT_ADV_AHEAD = Range(0.5, 6)

behavior AdvBehavior():
    do DrivePath(advLane, globalParameters.OPT_ADV_SPEED) until headway(egoRoute, ego, self) > globalParameters.OPT_ADV_AHEAD
    do DrivePath(egoRoute, 8)
