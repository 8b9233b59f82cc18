#: description = "The car ahead swings out around something, comes back into its lane and brakes."
#: rephrasings = [
#:   "The car in front jinks round a pothole, ducks back in and hits the brakes.",
#:   "Vehicle 1 steered left to avoid debris, returned to its lane and decelerated sharply.",
#:   "Lead dodges object, returns, brakes.",
#:   "The target performs an avoidance manoeuvre, realigns with the path of the VUT and brakes.",
#:   "It goes around an obstacle in front of us and comes again and makes a brake.",
#:   "The motorbike ahead flicks round a manhole, straightens and grabs the brake.",
#:   "A bus before us sidesteps something on the tarmac, then checks hard once back in line.",
#:   "The driver we follow wrenches the wheel to miss a dog, rights himself and anchors.",
#:   "The one in front jinked round a pothole or something, tucked back in and hit the brakes.",
#:   "The lead vehicle steered around an object in the roadway, returned to its lane, and slowed abruptly.",
#:   "Van ahead swings out round sth, back in line, brakes.",
#:   "The lead vehicle performs an evasive lateral manoeuvre, returns to the lane and decelerates.",
#:   "Truck before me goes around a thing on the road, comes back and brakes.",
#:   "Lead: out-and-in lateral bump as if avoiding debris, followed by decel in lane.",
#:   "It skirted something she could not see, slipped into line again, and its tail lights blazed.",
#:   "Ambulance ahead's dodged something, he's back in front of you and he's braking, ease off.",
#:   "the car ahead swerved round smth on the road came back n then hit the brakes",
#:   "The car in front skirted an object, resumed its place and slowed sharply, catching the follower off guard.",
#:   "He circumvented the thing, he regained his lane, and having regained it he checked his speed hard.",
#:   "Front vehicle took a cut to avoid something, came back in line and put sudden brake.",
#:   "Skips round some bit of rubbish, hops back in line and then anchors up, make your mind up mate.",
#:   "Avoidance excursion of preceding vehicle, return to lane and consequent deceleration",
#:   "CAR DODGES DEBRIS, TUCKS IN, BRAKES - was not ready",
#:   "The bus in front sidesteps something, slots back in and brakes.",
#:   "Motorbike ahead skirts a pothole, realigns, squeezes the lever.",
#:   "Around something, back in line, brakes: that's our leader today.",
#:   "Lead SUV: lateral evasion, lane regained, deceleration.",
#:   "The bus we were behind went round a box, came back and braked.",
#:   "What was that lorry avoiding, and why brake after coming back?",
#:   "Let the vehicle in front of the ego steer around a thing lying in the road, resume its lane, and only then slow down sharply.",
#:   "The police car I was following bulged out round a dead badger, settled back into its lane and immediately had its brake lights on.",
#:   "V2, preceding V1, deviated to the left of a mattress, re-entered its lane, and applied its brakes, reducing the gap at an unexpected rate.",
#:   "The van in front makes a Bogen about a thing on the street, comes into the Spur again, and there it brakes strongly.",
#:   "He'd recovered his line nicely after ducking round that cone, our pickup, so why he went for the brakes then I can't say.",
#:   "Keep your distance: the artic ahead has bent his way past some timber, straightened up in our lane, and now his stop lamps are glowing.",
#:   "We'd been tailing a coach for miles. Something like a burst tyre was lying there, the coach eased its bulk out past it, and eased back, and I thought good driver. Then the whole rear of it lit up crimson and it was braking hard in front of us.",
#:   "Given a lead vehicle in the same lane, the following sequence is executed: a short excursion to the side, such as drivers make to miss an object; a return to the original lateral position; and finally a brisk braking manoeuvre, whilst the subject vehicle follows.",
#:   "My claim form had a box for \"what did the other vehicle do\", and I ran out of room. The ambulance before me went out round a ladder in the road, it came in again in front of me, and when it was straight its driver braked.",
#:   "I blame myself a bit, since I'd sped up the moment the scooter flicked out of my way. He was only dodging a drain cover, you see, and in he came again, bang in line with my front wheel, and squeezed on his brakes.",
#:   "Ticket: lead goes round debris and we drop it as a target, that's wrong. It's back in our lane two seconds afterwards and braking, and the AV has to find it all over again with far too little time left. Please see the attatched log.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["swerve", "brake"]
#: position = "ahead"
#: leader = false
#: blocker = false
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -5.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.5
#: high = 2.6
#: unit = "m"
#: meaning = "how far it swerves"
#: [[parameters]]
#: name = "OPT_SWERVE_TIME"
#: low = 0.8
#: high = 1.5
#: unit = "s"
#: meaning = "for how long it swerves"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(-5, 30)
param OPT_SWERVE = Range(1.5, 2.6)
param OPT_SWERVE_TIME = Range(0.8, 1.5)
param OPT_BRAKE = Range(0.5, 1)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do SwerveOnPath(advTrajectory, 7, globalParameters.OPT_SWERVE) for globalParameters.OPT_SWERVE_TIME seconds
    do DrivePath(advTrajectory, 6) until abs(offsetFrom(advTrajectory, self)) < 0.6
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.3
    do DrivePath(advTrajectory, 3)
