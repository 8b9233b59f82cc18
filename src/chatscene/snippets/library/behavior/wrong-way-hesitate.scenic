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
#:   "Ghost bus in our lane: comes at us, baulks, comes at us anew.",
#:   "Oncoming in the wrong lane, the pickup froze briefly, then advanced again.",
#:   "Make a cyclist ride at us in our lane, halt, think, ride on.",
#:   "Contraflow truck, ego lane, two-second standstill, onward toward AV.",
#:   "After a moment's stop the wrong-way taxi resumed bearing down on us.",
#:   "A camper van was approaching on my side of the road, dead ahead of me, and although it did stop for a breath or two, the driver then let it roll towards me again.",
#:   "Opposing target travels in the VUT's lane against its permitted direction, decelerates to rest, dwells for the specified stop time and proceeds once more in the direction of the VUT.",
#:   "The driver of V2 admitted to having been in the northbound lane while heading south, to having stopped there from uncertainty, and to having continued southbound in it all the same.",
#:   "I want an SUV meeting us head-on in our own lane, and it should brake to a halt as though it had noticed the mistake, and then keep coming anyway.",
#:   "Lorry is coming wrong side, straight in my lane, stops for small time, I am thinking thank God, and again he has started coming towards me only.",
#:   "ok hes in our lane facing us, hes stood still, so is he going back?? no he isnt hes moving up on us again the clown",
#:   "Tourists, by the plates. They were driving on the left, which was my side, and were coming straight up my lane. They pulled up, I could see them arguing over the map, and then, to my horror, the car began to come at me again in that same lane.",
#:   "All units, wrong-way vehicle on the A14, a blue artic, coming at traffic in the inside lane. It did stop, I repeat it did stop for a few seconds at marker twelve, but it has now moved off and is again running towards the oncoming cars in that lane.",
#:   "You sit in a quiet robotaxi and there's this motorbike coming up your own lane with its headlamp in your eyes. It brakes, a boot goes down, and you breathe out. The boot comes up, and there's the headlamp growing again, because he's carrying on the same way.",
#:   "It isn't the wrong-way drive as such that trips our stack up but the pause in it. The actor is in our lane, against us; it brakes to zero, which the planner reads as yielding; and just as we begin to move, it starts rolling at us again.",
#:   "For an instant reason seemed to have got the better of the old gentleman. He had been steering his Rover towards them in the lane that was theirs; he stopped it; he looked about him through the glass. And then, with a little nod, he came on towards them as before.",
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
