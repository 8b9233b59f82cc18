#: description = "The emergency vehicle feels its way over the line on red, halts to look, then accelerates across."
#: rephrasings = [
#:   "the ambulance noses out on red with its siren going, waits a tick, then puts its foot down",
#:   "An ambulance on an emergency run entered on red at low speed, paused, and then accelerated through.",
#:   "ambulance, red, slow entry, short halt, then gas",
#:   "The emergency vehicle passes the red signal at walking pace, stands briefly and subsequently accelerates across the VUT's path.",
#:   "The fire truck passes the red light carefully, makes a little stop, then it gives full gas.",
#:   "A police car edges past the stop line on red, looks both ways, and shoots off.",
#:   "Blue lights flashing, the fire engine inches into the crossing, hesitates and then surges over.",
#:   "A rescue vehicle with priority tests the traffic against the signal before it speeds up.",
#:   "ambulance nosed over the line on red, stopped for a gander both ways, then went for it",
#:   "The ambulance edged past the stop line against the red signal, halted to clear the intersection, and then accelerated across.",
#:   "Fire eng. on red: creeps over line, stops, looks, then full over.",
#:   "The emergency vehicle passes the stop line at low speed on red, pauses to check and then accelerates through the junction.",
#:   "The police car has red, it comes slow over the line, stands and looks, then goes quick across.",
#:   "Blue-light crosser at red: inch out, v=0 for a look, then accelerate through. Cautious phase first, not a flat-out blast.",
#:   "The engine had crept out beneath the red lamp, waited till every head had turned, and only then put on speed and was over.",
#:   "Ambulance is poking his nose out on red, good lad, he's having a look left and right, and now he's giving it the beans.",
#:   "ambulance kinda tiptoed out on red, stopped to check, then zoomed",
#:   "A fire crew probed its way out against the signal, stood to see the coast was clear, then hurried over",
#:   "The police driver entered on red with caution, stopped, looked, and only then applied power?",
#:   "Ambulance on red slowly slowly putting nose out, stop see left right, then go fast",
#:   "Credit where it's due, the fire engine pokes out on red, has a good look, then he's gone",
#:   "Cautious red-signal entry of emergency vehicle with check halt and subsequent acceleration",
#:   "Ambulance sneaks out on red, PAUSES, then blasts across",
#:   "The patrol car tiptoed over the red, paused, then pounced.",
#:   "Ambulance from the side: inches over against red, stops, looks, powers across.",
#:   "Fire engine peeped out on red, sat tight a sec, then legged it over.",
#:   "Have a police car sneak past a red, wait, then surge across.",
#:   "Die Ambulanz, by red, tastes forward, stands, looks, and then Vollgas over.",
#:   "Nee-naw came out tiny bit on red, stopped, then went whoosh!",
#:   "With its lights against it, the fire engine coming from our left ventured its front axle past the line, held still while the traffic froze, then thundered over.",
#:   "The crossing emergency vehicle violates red at crawl speed, comes to zero velocity beyond the stop line for observation, and clears the junction under strong acceleration.",
#:   "I'll give the police driver his due: he only trickled out against the red, made a proper stop to see who'd spotted him, then floored it to the other side.",
#:   "Not until it had probed its way past the red, halted and satisfied itself that we were all standing did the ambulance put on speed and go over.",
#:   "You hear the siren? She's on red, so she's nosing out gently, now she's stopped to check on us, and now she's off across like the clappers.",
#:   "Did the appliance, having the red signal, not proceed cautiously past the line and stand there for a look before its driver sped over the crossing?",
#:   "I was at the crossroads on my bicycle, next to one of those driverless taxis. An ambulance rolled over the line from the side street although it had red, so gingerly that it seemed to be on tiptoe; it paused, I saw the crew turn their heads, and then it stormed to the far side.",
#:   "Control, from Engine Four, regarding the complaint. We had a red at Mill Street. I eased her over the line, brought her to a stand so that my mate could call \"clear left\", and once he had I gave it full throttle across. At no time did we just charge through that signal.",
#:   "Priority-vehicle case for the AV: it comes along the cross street with siren on and a red light facing it. First it slips past the stop line barely moving, then it freezes for a second or so to see whether people give way, and after that it picks up speed hard and crosses ahead of us.",
#:   "My wife grabbed my arm, for a patrol car was easing into the junction on its red, a foot at a time. There it stood, blue lamps turning, while the young constable peered up and down. Evidently he liked what he saw, as he then put his boot down and tore over to the other road.",
#:   "What good blue-light driving looks like, in today's video: signal's red for the fire truck, so the driver doesn't trust anybody. He feeds it in beyond the line at a snail's speed, brings it to a halt, scans both ways, and only when the silver car has clocked him does he let it roar across.",
#: ]
#: adversaries = ["emergency-vehicle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "hesitate", "accelerate"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 2.0
#: high = 3.5
#: unit = "m/s"
#: meaning = "how fast it feels its way over the line"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = -8.0
#: high = -4.5
#: unit = "m"
#: meaning = "how far beyond where their ways meet it halts to look"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.3
#: high = 1.0
#: unit = "s"
#: meaning = "how long it looks"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(0, 20)
param OPT_SLOW_SPEED = Range(2, 3.5)
param OPT_STOP_DISTANCE = Range(-8, -4.5)
param OPT_STOP_TIME = Range(0.3, 1)
param OPT_THROTTLE = Range(0.6, 1)

advTurn = "straight"

behavior AdvBehavior():
    do DrivePath(advTrajectory, 9) until distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5 + brakingDistance(self)
    do BrakeOnPath(advTrajectory) until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_SLOW_SPEED) until self.pose[3] > 1 and distanceLeft(advTrajectory, self, advTrajectory.entry) < -1 and distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, 9)
