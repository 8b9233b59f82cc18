#: description = "The crossing vehicle runs the red light at a steady speed."
#: rephrasings = [
#:   "A car ignores the signal and drives straight across.",
#:   "The adversary passes the stop line on red without slowing.",
#:   "Cross traffic disregards the lights and goes through.",
#:   "The other driver fails to stop at the red signal.",
#:   "A motorcyclist sails through on red in front of the ego.",
#:   "he just sails straight through the red",
#:   "Vehicle 2 disregarded the traffic signal and proceeded through the intersection.",
#:   "The car didn't respect the red light and passed.",
#:   "some bloke sailed through a red in front of me, didn't even slow, didn't speed up either",
#:   "V2 entered the intersection against a red signal at a constant speed.",
#:   "Truck from side: thru red, steady v.",
#:   "The crossing target disregards the red signal and passes the junction at constant speed.",
#:   "The bus has red light but he drives over, same speed as before.",
#:   "Signal violator: NPC ignores its red, constant velocity profile, straight over.",
#:   "The light stood red against him, and the cyclist pedalled by beneath it as calmly as you please.",
#:   "He's shot the lights, that van. Never touched his brakes, never touched his throttle, just carried on as if it was green.",
#:   "he just went thru the red like it was optional, didnt even slow down or speed up",
#:   "A coach ignored the stop signal and crossed at an unvarying pace, CCTV showed",
#:   "The signal stood against you, and yet you neither slowed nor quickened but went over?",
#:   "Red light also he is coming same speed only, no fear of police",
#:   "Colour blind, this fella, over he goes on red, cool as you like",
#:   "Signal violation by crossing traffic at constant speed",
#:   "Cyclist rolls right through a RED like it's nothing",
#:   "The truck waltzed over on red.",
#:   "Cross traffic: estate ignores its red, no change of pace.",
#:   "Red for him, yet over he rides, neither quicker nor slower.",
#:   "The bus drives by red through, always the same velocity.",
#:   "Let a crossing scooter pass on red, speed constant throughout.",
#:   "Stop light showing, lorry from the side rolls on over regardless.",
#:   "A taxi coming from the side street took no notice of the red lamp facing it and went over the junction at the very speed it had come with.",
#:   "Although their signal had been at stop for several seconds, the people in the minivan crossed in front of the robotaxi as evenly as a train.",
#:   "I want the cyclist from the cross street to ride over in spite of a red light, with no burst of speed and no braking.",
#:   "According to the red-light camera the motorcycle was doing 31 when it passed the stop line against the signal and 31 when it left the junction.",
#:   "You've got green, they've got red, and still you look, because here comes a coach from the left that isn't stopping, just trundling across as if alone.",
#:   "The crossing target vehicle maintains its initial velocity past a signal showing red and through the conflict area, without any longitudinal reaction.",
#:   "We had the green and I had just said how well the lights were set on this road. From the right came a woman on a bicycle. Her light was red, I could see it from where I sat, and she went on turning the pedals, click, click, across and away.",
#:   "It is the claimant's case that the signal controlling the defendant's approach was red. The defendant's van neither stopped at the line nor altered its speed in either direction; it simply proceeded over the crossroads, at about twenty-five miles an hour, into the claimant's path.",
#:   "Four of us in the car and we all saw it. Big tipper from the side road, light's as red as a tomato, and he doesn't even look as though he's thinking about it. No racing, no slowing, he just drives over, steady as you like.",
#:   "Down the avenue the lights had changed; the cross street's turned red. A motorcyclist came along it who seemed to be listening to music no one else heard, and at the same easy pace he passed beneath the lamp, over the crossing, and out of their lives.",
#:   "Bug: AEB late on red-light runner. Actor comes from the crossing arm, its own lamp is red, it is to disregard that. Keep it at the set speed from spawn to despawn, we've other tickets for the ones that brake, turn or speed up.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "bicycle"]
#: requires = ["advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenario red-light-running; own code"
#: [slots]
#: actions = ["run-light"]
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
#: low = 6.0
#: high = 13.0
#: unit = "m/s"
#: meaning = "how fast it crosses"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(6, 13)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
