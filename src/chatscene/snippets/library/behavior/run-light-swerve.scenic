#: description = "The crossing car runs the red light and swerves to its left in the junction."
#: rephrasings = [
#:   "he blows the red and yanks the wheel left when he spots us",
#:   "Vehicle 2 ran the red signal and veered abruptly to its left.",
#:   "red-light runner, sudden swerve inside crossing",
#:   "The target crosses the stop line on red and performs an evasive steering manoeuvre to the left.",
#:   "An ambulance comes on the red light and makes a fast movement to the left side.",
#:   "The biker jumps the lights and lurches aside at the last instant.",
#:   "Going through on red, a van darts off its line.",
#:   "It disregards the signal, then jinks to the left.",
#:   "he jumped the red and then jinked to his left in the middle of the junction",
#:   "V2 entered against the red signal and veered sharply to its left within the intersection.",
#:   "Police thru red, jerks to own L mid-jct.",
#:   "The crossing target passes the red signal and makes an evasive steering movement to its left inside the junction.",
#:   "The motorbike goes by red and in the crossing he pulls suddenly to his left.",
#:   "Red runner plus lateral kick: after entering the box, step in steering to its left, keeps moving.",
#:   "He had paid no heed to the light, and halfway over, the car lurched to its left hand for no reason they could see.",
#:   "Ran the red, and now he's flung the wheel over to his left in the middle; no telling where he'll end up.",
#:   "he ran the red then freaked out and swerved to his left in the middle",
#:   "A car passed the red signal and then sheered off to its left inside the crossroads",
#:   "You disobeyed the signal, and within the junction you wrenched the wheel to your left?",
#:   "Jumped the red, then inside the junction he swing to his left side, macam stunt driver",
#:   "He's come through on red, seen me, and thrown it over to his left",
#:   "Signal violation by crossing traffic with abrupt leftward evasion inside the junction",
#:   "Ambulance blows red light and VEERS to its left",
#:   "The biker burst over on red and jinked to his left.",
#:   "Crossing saloon jumps its red, then flings itself leftward mid-box.",
#:   "Have a side-road biker shoot the red and dodge to his left inside.",
#:   "Patrol car through red, sharp jink to its left in junction, be careful.",
#:   "Red was for him, he came, and inside the crossing made left jerk.",
#:   "Who runs the lights and then yanks it to his left halfway over?",
#:   "Out of the side street came a van that wouldn't stop for its red, and amid the crossroads it lurched bodily over towards its left.",
#:   "The crossing target disregards the red signal and, once within the conflict area, performs a lane-change-like steering input towards its own left-hand side.",
#:   "i had green, the motorcyclist on the cross road had red and came anyway, then midway he threw the bike to his left like dodgeing a pothole",
#:   "V2 proceeded into the intersection on a red indication from the cross street and, near its center, deviated suddenly to the left of its course.",
#:   "The ambulance ignored the red and, when it was already in the crossing, the driver gave a strong pull to his left, then went on like this.",
#:   "Add a red-light offender on the crossing road which, midway over, kicks out to its left rather than holding a straight course through.",
#:   "The grey SUV never so much as lifted for the red. It came in from the side at full speed, and when it was out there between the four corners it twitched hard over to the driver's left, the body leaning and the tyres complaining.",
#:   "What confuses the tracker is the second event. First a crossing vehicle violates its red, which we handle; then, inside the junction, it shifts its line abruptly to its left without actually making a turn, and the predicted conflict point is wrong.",
#:   "I'm a courier, I've seen folk jump lights for years. This one in the Astra went clean through his red from the cross street, got into the junction, and then wrenched the car leftwards as if a wasp had gone up his trouser leg.",
#:   "Asked to describe it, the old lady drew a line on the tablecloth. The car had come across when its lamp was red, quite straight as far as here, she said, and then, in the middle of the crossroads, it had dodged to its left, like so.",
#:   "The engine was coming from the right with its horn going and its signal at red, and the crew no doubt trusted us to wait. What we hadn't foreseen was that in mid-junction it would sheer away to its own left.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "swerve"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 7.0
#: high = 11.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.4
#: high = 3.0
#: unit = "m"
#: meaning = "how far it swerves to its left"
#: [[parameters]]
#: name = "OPT_SWERVE_DISTANCE"
#: low = 2.0
#: high = 9.0
#: unit = "m"
#: meaning = "how far before the place where their ways meet it swerves"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(7, 11)
param OPT_SWERVE = Range(1.4, 3)
param OPT_SWERVE_DISTANCE = Range(2, 9)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SWERVE_DISTANCE
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE)
