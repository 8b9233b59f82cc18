#: description = "The oncoming car comes the wrong way in the ego's lane, stops for a moment, and comes on."
#: rephrasings = [
#:   "he stops in our lane facing us, and then starts coming again",
#:   "Vehicle 2, travelling the wrong way, halted briefly and then resumed its course.",
#:   "wrong-way, short stop, continues toward us",
#:   "The target approaches in the lane of the VUT against its direction with a temporary standstill.",
#:   "The car in wrong direction stops a little and then it comes again toward the ego.",
#:   "A cyclist on the wrong side puts a foot down, dithers, and pedals on at us.",
#:   "The ghost driver pauses in confusion before rolling on.",
#:   "A lorry heading at us in our lane waits a second and sets off once more.",
#:   "He was on my side coming at me, stopped for a sec like he'd twigged, and then kept coming.",
#:   "The wrong-way vehicle in Unit 1's lane paused briefly, then continued toward it.",
#:   "Wrong-way in ego lane; brief halt; resumes.",
#:   "The target approaches in the VUT's lane against the direction of traffic, halts briefly and resumes its approach.",
#:   "The bicycle comes in my lane false direction, stands one moment, then comes again.",
#:   "Head-on contraflow actor with one pause; after the pause it resumes toward us instead of clearing.",
#:   "He was on the wrong side; he pulled up a moment as if it had dawned on him, and then on he came at her.",
#:   "He's coming up your lane the wrong way, he's stopped, good, oh no, he's coming on again.",
#:   "wrong way car in our lane stopped for a sec n i thought ok good but nope it kept coming",
#:   "The wrong-way bus halted briefly in the face of traffic, then resumed its mistaken course.",
#:   "You were in her lane, facing her; you stopped for a moment, and yet you came on again?",
#:   "Wrong-side car in my lane stopped little while, I thought he understood, then again he's coming.",
#:   "He's up my lane the wrong way, stops, scratches his head, and blow me, on he comes again.",
#:   "Contraflow approach in ego lane with short interruption and resumption.",
#:   "WRONG WAY DRIVER STOPS... THEN KEEPS COMING",
#:   "The wrong-way cyclist faltered in our lane, then pressed on.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "hesitate"]
#: position = "oncoming"
#: maneuver = "straight"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 25.0
#: high = 50.0
#: unit = "m"
#: meaning = "distance to the ego at which it pauses"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.5
#: high = 1.5
#: unit = "s"
#: meaning = "how long it pauses"
#: [[parameters]]
#: name = "OPT_ADV_OFFSET"
#: low = 0.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far toward its own side it keeps when it meets the ego"

param OPT_ADV_SPEED = Range(4, 8)
param OPT_ADV_DISTANCE = Range(25, 50)
param OPT_STOP_TIME = Range(0.5, 1.5)
param OPT_ADV_OFFSET = Range(0, 3)

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until gap(self, ego) < 75
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 1 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(against(egoRoute)) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 1 and gap(self, ego) < 24
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED, -globalParameters.OPT_ADV_OFFSET)
