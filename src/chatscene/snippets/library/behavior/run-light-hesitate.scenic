#: description = "The crossing car runs the red light, pauses halfway, and then goes on."
#: rephrasings = [
#:   "she goes over the red, gets cold feet, stops for a second and then carries on anyway",
#:   "Vehicle 2 entered on a red indication, halted briefly, and then continued across.",
#:   "red-light runner stops for a moment, then continues",
#:   "The target passes the stop line on red, comes to a temporary standstill and resumes its course.",
#:   "The car crosses by red, then it makes a little pause because the driver is not sure, and then continues.",
#:   "A bus pulls over the line on red, dithers and moves off again.",
#:   "The biker sneaks through on red but wavers in the middle before setting off once more.",
#:   "Against the signal a lorry comes out, waits an instant in doubt, and drives on.",
#:   "He jumped the red, stopped to think about it slap in the middle, then carried on.",
#:   "Cross vehicle entered on red, paused midway, and continued through the intersection.",
#:   "Truck thru red, half way stop, then on.",
#:   "The crossing vehicle passes the red signal, halts briefly in mid-junction and proceeds.",
#:   "The car goes over red, waits in the middle little bit, and goes more.",
#:   "Red-light runner with a short dwell at mid-box, then clears.",
#:   "It had run the light, and in the middle its nerve went; a breath later it plucked up courage and finished.",
#:   "Bus has gone through his red, he's stopped halfway, unsure, okay he's going again, let him out.",
#:   "he ran the red stopped halfway like oh no and then just finished it lol",
#:   "A driver passed the red signal, faltered midway over the junction and then resumed.",
#:   "Against the red you went; in the midst you paused; and then, reflection notwithstanding, you continued.",
#:   "Jumped the signal, in middle he stopped for one second, again he started.",
#:   "Through on red, gets cold feet bang in the middle, and then carries on regardless.",
#:   "Red-signal violation with momentary halt in mid-intersection and continued crossing",
#:   "RED LIGHT RUNNER BUFFERS HALFWAY, then goes",
#:   "The crossing van violates the red, balks midway and resumes.",
#:   "On red the cab enters, baulks in the middle, then completes its crossing.",
#:   "Crossing bus disobeys red, wavers mid-junction, drives on across.",
#:   "It passes by red, in the half it stays a moment, it continues.",
#:   "Moto from side: through red; brief halt centre; off and over.",
#:   "Red was no obstacle; doubt was, for a second; then on he drove.",
#:   "A crossing SUV took the red, seemed to notice us when it was in the middle, stood for a breath and then drove on out of the junction.",
#:   "Make the truck from the side disobey its light, stand a moment half over the junction, as if unsure, and then finish going over.",
#:   "The scooter had ridden out against the red; midway she put both feet down, looked at us, looked at the lamp, and rode over after all.",
#:   "The lorry's passage on red was interrupted once: it was at rest in the centre of the crossing for about a second before it was driven on.",
#:   "Entering on a red aspect, the crossing target shall halt temporarily at the midpoint of the intersection and then resume its original course at its original speed.",
#:   "Did he go through? Well, by instalments: over the line on red, a pause slap bang halfway while he plucked up courage, and then the rest.",
#:   "I was about to move off on my green when a hatchback came from the left in spite of its red. It got as far as the middle. There the driver must have thought better of it, since he stopped, but he thought worse again and carried on across.",
#:   "V2 failed to obey the red signal and entered the intersection. At about the centre V2 was observed to stop. After an interval of one to two seconds V2 proceeded in its original direction and cleared the intersection. V1 had entered on green and was braking throughout.",
#:   "With a bus it looks like a whale losing heart. It had passed the red lamp with a great sigh, come to the heart of the crossroads, and there it hung, rocking a little on its springs; then the sigh came again and it bore its passengers over to the far side.",
#:   "You should have seen my wife's face. This motorbike jumps the lights on the other road, no shame at all, then he loses his bottle and he's sat there halfway over, wobbling, and I'm waiting, he's waiting, and then, right, on he goes, off over the other side.",
#:   "Twelve seconds in you get the van in from the right, light's red for him, check the reflection in the bank window. Then he stops in the middle. I reckon he's going to sit there and block us, but no, he gets going again and clears it.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "hesitate"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 22.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = -5.0
#: high = 0.0
#: unit = "m"
#: meaning = "how far beyond where their ways meet it pauses"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.4
#: high = 1.5
#: unit = "s"
#: meaning = "how long it pauses"

param OPT_ADV_DISTANCE = Range(0, 22)
param OPT_ADV_SPEED = Range(5, 8)
param OPT_STOP_DISTANCE = Range(-5, 0)
param OPT_STOP_TIME = Range(0.4, 1.5)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
