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
#: ]
#: adversaries = ["bicycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["stop", "hesitate", "accelerate"]
#: position = "ahead"
#: leader = false
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
