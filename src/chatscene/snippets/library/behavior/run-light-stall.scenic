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
#:   "Ignored his red, engine packed up, trickled to rest mid-crossroads.",
#:   "Crossing bus on red; power gone; coasting; finished, right there.",
#:   "Scooter sneaks the red, motor dies, glides to nothing mid-box.",
#:   "The Fiesta from the side street paid no heed to the red, and its engine paid it back by expiring halfway, leaving it to coast still.",
#:   "Crossing target enters against its signal, loses traction power, decays in speed by rolling resistance and finally obstructs the ego path at rest.",
#:   "How does one jump a red and then fail to get to the other side, unless the motor gives out and one dribbles to a halt?",
#:   "That truck fellow has broken the red signal with full style, and in the middle engine is off, slowly slowly it is rolling and stopped.",
#:   "I'd like a motorcycle which flouts the red from the cross street, has its engine fail and drifts to a stop in the junction.",
#:   "A minibus that had driven through a red was pushed off the junction by passers-by, having lost all power there and rolled to a stop.",
#:   "There was no squeal, nothing. The red was his, the green was mine, and the old Rover sailed in from the right regardless with its engine roaring. Then the roar was cut off as with scissors. It came on more and more slowly, like a toy running down, and when it had run down it was in my road.",
#:   "At the scene V2 was found stationary in the centre of the intersection with its ignition on and its engine not running. Signal phasing shows it had entered 1.8 seconds into red. Speed fell steadily from 34 km/h without any brake application, consistent with a loss of drive, until the vehicle stood in V1's lane.",
#:   "I've driven wagons with dodgy injectors and I know that sound. The tipper jumps his lights from the left, all noise, then it's all wind and tyres, as the engine's gone out like a candle. You could have walked alongside by the end. And the end was slap in the middle, and there he's stuck.",
#:   "My little one was the first to see that something was wrong with the coach. It had come over its red from the side street, quick enough, and she said, Mummy, it's falling asleep. And so it was: every yard slower than the last, not a brake light to be seen, until it slept in the crossing.",
#:   "The adversary in this case commits an offence and is punished for it. It crosses its stop line on red. Shortly afterwards its propulsion is taken away, so it rolls out, gently, without its driver touching the brake, and comes to lie on the path of the subject vehicle, where it's left.",
#:   "He reckoned he would be across before anybody noticed the colour of his light, which was red. He reckoned without his carburettor. Halfway over the motorbike hiccupped and fell dumb, and with dwindling way, his feet already feeling for the cobbles, he floated to a standstill under the eyes of us all.",
#:   "Control, junction of Station Road. White Luton van's gone through a red from the east side, lost its engine by the sound of it, and rolled out to a standstill in the middle. It's dead. Driver's turning it over and getting nothing. My lane's blocked, so I'll need recovery.",
#:   "The interesting part is what's absent from the data: no brake pressure, no skid, no steering. A crossing hatchback passes its red signal at city speed, and from a certain moment on the torque is nil. The rest is friction. It takes about five seconds until the hatchback is stationary on our line.",
#:   "I was ready to be cross with him for ignoring the red, that young man from the side road. Then I became rather sorry, because his motor car died under him. It went slower than a hearse and then slower still, and at the last he sat in the middle of the crossroads without any engine, blushing.",
#:   "So now it's stood there with its flashers on. You saw how it got there, he went past his red from the right as bold as brass. Only no engine, did you hear it cut? He's had to sit and let it roll itself out, and it has rolled itself out exactly where you want to go.",
#:   "In my street, Madam, we say the devil gives the speed but not the petrol. The taxi from the left passed the red with great speed; and in the crossing, pff, no more motor. It continued alone, by its weight, always more soft, and it died before my wheels, that is all what I saw.",
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
