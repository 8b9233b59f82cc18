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
