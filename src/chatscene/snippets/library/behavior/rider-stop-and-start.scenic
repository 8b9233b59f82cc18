#: description = "The cyclist ahead stops in the lane, looks about and rides off again briskly."
#: rephrasings = [
#:   "The bike in front pulls up, has a look round and gets going again.",
#:   "The bicyclist ahead stopped momentarily in the lane and then resumed at speed.",
#:   "cyclist ahead stops, then sets off again",
#:   "The bicyclist target comes to rest ahead of the VUT and restarts with full acceleration.",
#:   "The cyclist before us stops, waits a little, then goes again fast.",
#:   "A courier halts to check the map and then sprints away.",
#:   "The girl on the bike puts a foot down, thinks and pedals on with vigour.",
#:   "A cyclist we follow brakes for a cat and afterwards carries on at full speed.",
#:   "The cyclist ahead pulled up in the middle of the lane, had a good gawp round, then pedalled off sharpish.",
#:   "The bicyclist stopped in the lane ahead of Unit 1, looked around and then departed briskly.",
#:   "Bike ahead: halt, look L/R, off again quick.",
#:   "The leading cyclist target comes to rest in the lane, pauses and then moves off with brisk acceleration.",
#:   "The bicycle before me stops, he looks around, then goes quickly again.",
#:   "Leading cyclist stops to get its bearings, then resumes fast; ego shouldn't have begun passing.",
#:   "He put a foot down in front of her, peered about as if for a street name, and then was off smartly.",
#:   "Cyclist in front's stopped to look where he is; give him a second, there, he's off again at a good clip.",
#:   "the cyclist stopped in front of us looked round like a meerkat n zoomed off",
#:   "A cyclist paused in mid-lane, surveyed the street and made off at a lively pace.",
#:   "He halted in your lane, turned his head this way and that, and only then departed, rather quickly?",
#:   "Front cycle boy stopped in the lane, looking here and there, then went off fast.",
#:   "Pulls up in front of me, admires the view, then off like he's late for his tea.",
#:   "Temporary mid-lane halt of leading cyclist with brisk restart.",
#:   "CYCLIST STOPS IN THE ROAD, LOOKS AROUND, TAKES OFF",
#:   "The cyclist ahead paused, periscoped about and whizzed off.",
#:   "Bike in front halts mid-lane, glances all round, departs at pace.",
#:   "Leading cyclist: standstill, head turning, then brisk getaway.",
#:   "La cycliste before me stops, she regards left and right, restarts very rapid.",
#:   "Have the cyclist ahead stop, take stock, and whip away again.",
#:   "Ahead of us a boy stops pedalling, stands, peers, then hares off.",
#:   "The woman on the bicycle that we were following came to a stop in the lane, studied both sides of the street, and set off again with great energy.",
#:   "A rider ahead of the AV drew to a halt on the lane, craned his neck for a house number, found it wasn't there and sprinted onward.",
#:   "It was only a short stop: the courier in front braked to nothing, swivelled his head about, rose on his pedals and was on his way in a hurry.",
#:   "Ahead of the test vehicle the bicycle target is braked to standstill, dwells while its dummy head rotates, and then resumes along the lane with lively acceleration.",
#:   "Don't go round that cyclist yet; he has pulled up in your lane to see where he is, and, you see, he's pushing off again, and quickly.",
#:   "V2, a bicycle leading V1, ceased to move in the travel lane, its operator was observed to scan the surroundings, and V2 then left forward at a fast rate.",
#:   "I was behind an old gentleman on a racing bike of all things. On an open bit of road he came to a stop in my lane, one foot on the ground, turned his cap to the left and to the right, and then off he went, quicker than before.",
#:   "What puzzled the prediction module was the middle phase. The cyclist in front of us had braked to zero in the lane, and with its shoulder checks it looked like someone about to turn off; instead, after the wait, it rode straight on and got up to speed fast.",
#:   "She had lost her bearings, that was plain. The bicycle ahead of them ran out of way and stood; its rider looked up at the street sign, and over at the church, and up again; then something fell into place and she was off, standing on the pedals.",
#:   "From my cab you look down on them. This student on a bike stops dead in front of my wagon, not at the side, in the lane. Has a look over one shoulder, has a look over the other, and then he's pumping those legs and away like the Tour de France.",
#:   "When I was small my teacher said stop and look before you ride. The girl in front of our car did that, only she did it in the middle of our lane! She stopped, looked this way, looked that way, and then she whizzed on ahead of us.",
#:   "Cyclist ahead: feet down mid-lane, quick survey, off at speed.",
#:   "Bike in front stops, rider gazes round, scoots on.",
#:   "Up ahead she brakes to nothing, checks both sides, whizzes onward.",
#:   "The boy we were riding up behind brought his bicycle to a stand in the lane, twisted about in the saddle and then shot forward again.",
#:   "some deliveroo guy stops dead in the lane ahead of me, looks left looks right looks at his phone, then takes off like a rocket",
#:   "The leading cyclist dummy decelerates to zero in the lane, remains stationary for the dwell time and then resumes its path at the higher set speed.",
#:   "He's pulled up in front of you, that cyclist, he's looking for somewhere, so hold back, there you are, he's found his pedals and he's flying.",
#:   "That cycle uncle before me stopped in the middle of lane only, this side he saw, that side he saw, and then full speed he went.",
#:   "Please have the bicycle ahead of the AV halt where it is, appear undecided for a couple of seconds and then set off smartly along the lane.",
#:   "You'd have thought she had all day, the way she stood there. She'd been riding before our taxi and she'd just stopped, in the lane, with one toe on the tarmac, turning that big sun hat from the one side to the other. But when she went, she went; the hat was on her back and we could hardly keep up.",
#:   "Insured was following a bicycle at a safe distance. The cyclist stopped in the carriageway without pulling in and looked about him, presumably to find an address. As insured prepared to go round him he set off along the lane once more at considerable pace, so that insured abandoned the attempt.",
#:   "My speedometer did thirty, nothing, twenty-five, and every one of those figures was the cyclist's doing. He was ahead of me, so when he quit pedalling and stood there in the lane with his head going like a weathervane, I stood too. Then whatever it was had been settled, and he was off up the road with his elbows out.",
#:   "V1 was behind V2, a bicycle, when V2 came to a standstill within the lane. The operator of V2 looked toward the east curb and then toward the west curb. After about two seconds V2 departed northward in the same lane, accelerating sharply, and V1 proceeded behind it.",
#:   "This is what I mean by reading a back. The back in front of you on that bicycle straightened, so you slowed, and it stopped. The head on top of it turned, and turned again, so you waited; and then the back bent low, didn't it, and that told you it was about to be off like a shot.",
#:   "I am forty years lorry driver and the student in front of my truck makes me laugh. He makes a stop, not on the side, in my lane, and searches with his eyes the number of a house, here, there, up. Suddenly he knows, he stands in the pedals and he flies.",
#:   "In the swarm plot all agents drift right except one, which is the cyclist preceding us. Its dot stays put for 2.2 seconds, while its orientation estimate jitters from side to side as the rider's head and shoulders turn. Then it leaps to six metres per second, in the lane and in the same direction as before.",
#:   "Somebody must have called her name. She was cycling along ahead of us, and she drew up with a little squeak of brakes, in the middle of the lane, and hunted for the voice among the balconies on both sides. It wasn't there, or it wasn't the one she'd hoped for, and she rode away from it as hard as she could.",
#:   "When the cam boots up you can see him stationary slap in the lane in front, that's because he's only just braked. Next bit is him doing the owl, head right round one way, head right round the other. And at nineteen seconds he's out of the saddle and giving it beans down the road, no signal, no nothing.",
#:   "I used to deliver telegrams on a bicycle, so I knew what he was about. He didn't know the street, he wasn't going to admit it, and so he stopped ahead of us as though to admire the architecture, first the left-hand terrace and then the right. Having lost a minute he then made it up; I've seldom seen legs go round so.",
#:   "Robotaxi fleet note: hold the pass. In seven cases out of ten a cyclist who halts in our lane and scans around isn't giving up, merely orienting. Yesterday's is typical, stationary ahead of us for three seconds, helmet swivelling, then away down the lane at twenty-eight kilometres an hour while we'd still have been alongside.",
#:   "Bike ahead: foot on tarmac, head swivels, then pure legs.",
#:   "She pulls up before us, consults both pavements, belts onward.",
#:   "Halt in our lane, a peer about, and he's flying.",
#:   "The pannier I'd been following came to a stop, its owner looked left, right and up at the clock, and then I'd to change up to keep it in sight.",
#:   "Leading bicycle: brake to zero in the lane, dwell for the set time with head movement, resume the same path briskly; ego not to overtake meanwhile.",
#:   "i literally had my indicator on to go round her cos she'd just stopped there gazing about, and she's off like she's heard the bell for round two",
#:   "Before me the cycle boy has stood, this gali he saw, that gali he saw, and then such a speed he took that dog also was surprised.",
#:   "Stopping dead in front of a bus to look for your friends is one thing, cycling off at full tilt just as it starts round you is another.",
#:   "The front wheel pointed ahead throughout, it's only that it didn't turn while he was looking over either shoulder, and afterwards turned like a fan.",
#:   "In my wagon's camera there's a lad's rucksack, close, and not moving. Above the rucksack there's a woolly hat that shows me one ear, the back, the other ear. You can hear me say, come on then, son. And he does: up comes his backside, and rucksack and hat go off up the lane so that I'm in fourth before I've got them large again.",
#:   "She'd been riding along before me and she ran down till she stood, out in the lane, one hand on the roof of nothing, balancing. First the church had to be looked at and then the inn. I'd my flask half open when she'd seen what she wanted, which was evidently a long way ahead, from the rate at which she made for it.",
#:   "V2's operator, a food courier, had no knowledge of the neighborhood. He brought his bicycle to rest in the through lane ahead of V1 without steering toward the curb. V1's operator saw him turn his head in both directions twice. He then departed along the same lane at what V1's operator called \"a real clip\", and V1's passing maneuver was aborted.",
#:   "Please amend the rule \"stationary cyclist in lane equals obstacle, pass at once\". Yesterday's was braked to zero fourteen metres ahead of us and stayed there for two and a half seconds. In that time head pose went to minus eighty, plus eighty and minus sixty degrees. At three seconds it was under way again, briskly, straight up the lane, and we were half beside it.",
#:   "I'm the one on the bike; I'd the car behind me all along. I braked because somebody shouted \"Oi\", and I stood there and looked for him, in the windows over the road, in the yard on the other side. Couldn't see a soul. So I put my head down and rode on as fast as I'm able, out of embarrassment, and the car after me.",
#:   "There was a white-haired head above a bicycle in front of us, and it and the bicycle had both come to a stand where we should have liked to drive. It went slowly to the right, it went slowly to the left. When it went down between the shoulders my pupil put the car in gear, and he was off like a boy let out of school.",
#:   "From my window I saw a student on a bicycle waiting in the lane and, behind her, a taxi which couldn't think why. She'd squeezed her brakes at the linden tree. She held the map up and her nose went round after the street signs, this corner, that corner. Then the map went into her teeth, and the taxi had its work cut out to follow.",
#:   "He was like our hen. Our hen stops and looks with one eye, and then she looks with the other eye, and then she runs. The man on the bike in front of the car did all that, he stopped in our way and he did the one eye and he did the other. And then, whee, down the road with his coat out, and Mummy said well.",
#:   "There was a gap of two metres between me and the bicycle ahead. It had been ten; she'd stopped pedalling, stopped altogether, to hunt about for the street name, hat this way, hat that. It became twenty as suddenly as it'd become two, for she was off up the lane out of the saddle. I'd stalled; I was hit from behind.",
#:   "I had behind me eleven tons of melons and before me a cyclist, so I looked well. His brakes squeal, he stands, and not at the side, no, in my lane. He makes with the head like a man at the tennis. When I've at last all eleven tons stopped, he's seen enough, he gives everything into the pedals, and from zero I must begin with my melons.",
#:   "Nothing in that street moved except a face, above a thin bicycle which had come to rest before their bonnet; it moved across the house fronts on the one hand and back along those on the other, as if reading. What it had read there one couldn't know. It bent, the thin knees flew, and the street ahead of them was his, and he was using it.",
#: ]
#: adversaries = ["bicycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["stop", "hesitate", "accelerate"]
#: position = "ahead"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 6.0
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 25.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 0.9
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.5
#: high = 1.6
#: unit = "s"
#: meaning = "how long it stands"

param OPT_ADV_SPEED = Range(4, 6)
param OPT_ADV_DISTANCE = Range(0, 25)
param OPT_BRAKE = Range(0.4, 0.9)
param OPT_STOP_TIME = Range(0.5, 1.6)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego, 4) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.1
    do BrakeOnPath(advTrajectory, 1) for globalParameters.OPT_STOP_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
