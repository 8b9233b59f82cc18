#: description = "The crossing car runs the red light, loses its drive, and rolls to a stop in the junction."
#: rephrasings = [
#:   "he jumps the red and then his engine dies, he just coasts to a halt in the middle",
#:   "Vehicle 2 disregarded the red signal, lost power and came to rest within the intersection.",
#:   "runs red, stalls, rolls out slowly, dead in the crossing",
#:   "The target crosses the stop line on red, decelerates without braking and stands still on the VUT's path.",
#:   "A truck is passing on red and then the motor goes off, so it gets slower and slower until it stands.",
#:   "The old van ignores the signal, gives up the ghost halfway and drifts to a standstill.",
#:   "The scooter slips over on red, splutters, and runs out of momentum.",
#:   "Having entered against the lights, the car gradually peters out and stays there, broken down.",
#:   "The old banger jumped the red, conked out and rolled to a halt in the middle.",
#:   "Cross vehicle entered on red, apparently lost engine power, and coasted to a stop in the intersection.",
#:   "MC over red, engine dies, coasts, stuck mid junction.",
#:   "The crossing vehicle passes the red signal, loses propulsion and coasts to rest within the junction.",
#:   "The truck goes over red, then motor is off and it stays in the crossing.",
#:   "Red-light runner loses drive torque in the box, coasts to zero with no braking and remains.",
#:   "He was through the red and feeling clever when the engine died on him and he drifted to a stop in everybody's way.",
#:   "Car's run the red and died, he's coasting, he's broken down in the middle of the intersection.",
#:   "bro ran the red and then his car died in the middle of the intersection karma",
#:   "A car that went through on red broke down and trundled to rest in the middle of the crossroads.",
#:   "He passed the red, whereupon his engine failed him, and the vehicle ran on of its own motion until it stopped.",
#:   "Jumped red light then car off in the middle of the junction, cannot start.",
#:   "Nips the red and then his motor gives up the ghost, rolls on a bit and that's him stuck in the middle.",
#:   "Propulsion loss of red-running vehicle with roll-out to standstill in the junction",
#:   "INSTANT KARMA: runs red, engine CUTS OUT mid-intersection",
#:   "The red-running bus expires and drifts to rest in the crossing.",
#:   "Crosses on red, engine quits, rolls to nothing mid-junction.",
#:   "Bus jumps its red, loses power, trickles to a standstill there.",
#:   "Truck through red, no drive left, drifting to rest on crossing.",
#:   "Let the crossing scooter run the red and die halfway.",
#:   "RED LIGHT RUNNER BREAKS DOWN MID-JUNCTION, rolls to a stop",
#:   "Coming from the left, the old Transit didn't heed its red, and then in the middle the power went and it just ran out slowly till it stood.",
#:   "The crossing vehicle shall violate the red signal, thereupon lose its drive torque, and slow without appreciable braking to a standstill on the VUT's path.",
#:   "He'd got past the red all right, but his motorbike had other ideas: it coughed, went silent and freewheeled to a standstill amid the crossroads.",
#:   "There is in the crossing a car which is finished; it has passed by red and then without motor it only rolled until it stood.",
#:   "The lorry that is now sitting lifeless on the junction had ignored the lights, after which its engine failed and it slowed gently until nothing moved.",
#:   "Bad luck for the coach driver who disregarded his red: the engine expired under him and he came softly to rest on the crossing before us.",
#:   "I had green and was nearly at the crossroads when a little car came over from the right on red. I expected it to fly past, but you could hear the engine cut. It rolled slower and slower and at last stood still, plumb in my way.",
#:   "Vehicle 2 proceeded past a signal that had been red for two seconds. Inside the intersection it suffered a loss of propulsion; no brake lights are visible on the recording. It coasted at falling speed and came to a stop across the path of Vehicle 1.",
#:   "We combine two faults in this one: first the violation, second the breakdown. A crossing minibus takes no notice of its red light, drives in, then its motor quits, so it decelerates gradually on its own momentum and ends up as a dead obstacle inside the junction.",
#:   "God is watching, as my mother says. This auto came from the side with red signal against him, full confidence, and exactly in the middle his engine has gone off. Slowly, slowly it was rolling, and then it stopped there, and he is pressing the starter for nothing.",
#:   "They both heard it, the shout of the motor as the bike ignored the red and came in from the river side, and then the silence. It ran on without a sound, with less and less life in it, and stood at last on the crossing before them.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "slow", "stop"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 18.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 7.5
#: unit = "m/s"
#: meaning = "how fast it comes in"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.08
#: high = 0.15
#: unit = "1"
#: meaning = "how fast it loses its way"

param OPT_ADV_DISTANCE = Range(0, 18)
param OPT_ADV_SPEED = Range(5, 7.5)
param OPT_BRAKE = Range(0.08, 0.15)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) / globalParameters.OPT_BRAKE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
