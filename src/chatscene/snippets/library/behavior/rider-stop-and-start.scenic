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
