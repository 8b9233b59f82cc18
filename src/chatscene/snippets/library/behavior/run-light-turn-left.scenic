#: description = "The vehicle runs the red light and makes an abrupt left turn."
#: rephrasings = [
#:   "A car ignores the signal and swings sharply to the left inside the junction.",
#:   "Jumping the lights, the adversary turns left in front of the ego.",
#:   "The other driver crosses on red and suddenly cuts left.",
#:   "Against the red a vehicle enters and hauls the wheel over to the left.",
#:   "The motorcyclist disregards the lights and sweeps round leftward.",
#:   "he jumps the red and yanks it left",
#:   "Vehicle 2 entered against the signal and turned sharply to the left.",
#:   "runs red, late hard left",
#:   "He went through the red and then wrenched it left all of a sudden.",
#:   "Vehicle 2 disregarded the red signal and made a sharp left turn.",
#:   "Red jumped, then snap L-turn.",
#:   "The target passes the red signal and executes an abrupt left turn in the junction, without halting.",
#:   "The bus ignores red and turns very sudden to left.",
#:   "Red-light runner who hooks a hard left instead of going straight; completes the turn.",
#:   "The light was red, but through he came, and without a blink he threw it round to the left.",
#:   "He's jumped the lights and he's slinging it left, watch him come round!",
#:   "ran the red AND whipped a left, just casually",
#:   "The van ignored the stop signal and wheeled suddenly to the left, keeping going.",
#:   "It was against a red signal that you threw your vehicle to the left, was it not?",
#:   "Red signal, still he turned left suddenly, one shot, gone.",
#:   "Doesn't fancy waiting on the red, so it's hard over to the left and away.",
#:   "Abrupt left turn by vehicle in violation of red signal.",
#:   "BLOWS RED LIGHT WITH A CRAZY LEFT TURN",
#:   "The bus defied red and whirled left.",
#:   "Lights against him, biker flings it left through the junction.",
#:   "Coach: red disregarded, sudden left, drives off.",
#:   "He was meant to wait, red and all, but shot in and veered left.",
#:   "Hatchback barges past the red and jerks away to the left",
#:   "Signal violation by crossing truck; sharp leftward turn, no halt.",
#:   "I want a van that comes over the line although it has red and, inside the intersection, is pulled hard to the left without slowing to a stop.",
#:   "According to the traffic camera the bus passed a signal that had been red for four seconds, and then hooked away abruptly leftwards.",
#:   "V2 failed to obey the red, entered, and changed direction to the left so suddenly that its load shifted against the side of the trailer.",
#:   "The motorcycle does not respect the red light, he passes it, and of a sudden he lies down to the left and goes.",
#:   "Not only has the pickup treated the stop light as decoration, it's also thrown itself left in the middle of the junction like a rally car.",
#:   "Left, and violently so, went the lorry, which by rights ought to have been standing at its red light all that time.",
#:   "We had the green and the robotaxi was rolling. From the side comes a minicab that's got the red, doesn't so much as dab the pedal, and once he's in the middle he lobs it to the left with the tyres squealing, and off down the road he goes.",
#:   "Infringement one: the driver did not comply with the red signal. Infringement two: having entered the junction, he made a turn to the left of such abruptness that no other user could have anticipated it. He completed the turn and left the scene.",
#:   "I drive a tram, I see everything. This lady in the big SUV looked at the red light, I mean she looked straight at it, and drove in anyway. Then she must've realised it was her street, as she whirled the wheel to the left all at once and went round.",
#:   "Actor ignores its signal phase (red) and enters the box at constant speed as if going straight on. Late in the box, at the given distance from our path, its heading steps to the left by about ninety degrees, and it departs along that new direction.",
#:   "The scooter's lights were red. I know they were because mine had gone to green. Through it came all the same, wobbly little thing with a huge parcel on the back, and then it heeled over and darted left, quick as a fish, and kept going.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenario red-light-running; own code"
#: [slots]
#: actions = ["run-light", "turn-left"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 18.0
#: high = 42.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_SWERVE_DISTANCE"
#: low = 0.0
#: high = 5.0
#: unit = "m"
#: meaning = "how far before the place where their ways meet it turns"

param OPT_ADV_DISTANCE = Range(18, 42)
param OPT_ADV_SPEED = Range(5, 10)
param OPT_SWERVE_DISTANCE = Range(0, 5)

advTurn = "straight"

behavior AdvBehavior():
    # Where no way goes straight on, it leaves its way before that bends.
    start = self.pose[2]
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < globalParameters.OPT_SWERVE_DISTANCE or abs(self.pose[2] - start) > 0.15
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 1.5708)
