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
#:   "Bus over on red, revs die, glides to rest mid-crossroads.",
#:   "Red jumped, engine dead, momentum spent: van's stranded in the box",
#:   "Moped sailed the red, coughed, dribbled, and stood before us.",
#:   "The lights were against the lorry from the side, and so was its gearbox, for it came over on red and ran down to nothing in the middle.",
#:   "With no brake lamp lit, the taxi that had ignored its red got slower of itself until our lane had a taxi standing in it.",
#:   "A coach on the cross street, red for him, silence where the engine had been, tyres whispering, whispering less, and then a coach in our road for good.",
#:   "Motor went off after he already cut the red, so he only can slide, slide, slide, and finally he is sleeping in the centre of junction.",
#:   "Having disregarded the signal, the motorcyclist found himself without power and paddled to a stand, where he stayed, in the path of my client.",
#:   "Specify for the crossing truck: ignore the red, lose traction torque in the junction, decay to zero speed on rolling resistance alone, and stay put.",
#:   "I'd have forgiven him the red if he'd only got to the other side. But somewhere by the first of the studs his noise left him. I saw the fellow turn the key, and turn the key, while the car ran on by itself, quick, slow, slower. He was still turning the key when it and I had both run out of road.",
#:   "It's the bit after the crime that I enjoy. Crossing pickup, red as a tomato, doesn't lift. He's a third of the way over when all his dashboard lights come on, you can see them on his face. There's no bang or skid. He just has less and less of a car under him, till it's a parked one, on my line.",
#:   "Smoke came first, then the bus. Its light had been red for some time, so it had no business to come at all. Then the smoke stopped and it was coming still, but like a boat when they've shut off the motor, carried by nothing. It drifted up to our crossing of the ways and there it went aground.",
#:   "Both my passengers, who are blind, knew at once what had happened. Somebody on the left had driven across when he shouldn't, for our own engine was already pulling and his was crossing it. And then his wasn't. They could hear the wheels, ticking round more and more slowly, and no brakes; and the ticking ended right in front of them.",
#:   "Sequence reconstructed from cell-phone video: (a) signal for V2's approach red; (b) V2 passes the stop line at undiminished speed; (c) exhaust plume ceases; (d) V2 decelerates gradually over five seconds with brake lamps unlit; (e) V2 at rest within the intersection, blocking V1. The fuel tank of V2 was found to be empty.",
#:   "Don't swear at him, he's been punished. He'd a red, and he went, and you were right to hold back for him. But see how he's rolling? He's not braking and he's not driving, he's got nothing left in there. It'll carry him as far as the middle of the junction and no further, and that is where we'll have to live with him.",
#:   "The hush was what woke me up. I'd been dozing beside the driver; there'd been this tremendous clatter of a tipper coming on us out of the side street, through its red light, with our man cursing. And the clatter was gone. When I'd got my eyes open the tipper was ghosting along, with less way on at each yard, until it had none.",
#:   "Question from the floor: why didn't your vehicle pass behind it? Because it was expected to leave. An ordinary red-runner has left the conflict area in two seconds. This motorbike's drive had quit, it freewheeled, its speed fell away of its own accord, and with five seconds gone there was no \"behind\" any more; it was standing there.",
#:   "Grandma's old Trabant, he thought, and grinned, as the thing bowled over the crossroads under a red lamp. He had stopped grinning by the time it did what Grandma's used to do. A hiccup, a blue ring of smoke; no more putt-putt; a gentle, shameful rolling out; and in the very centre, before his radiator, repose.",
#:   "Caller states that a cement truck ran the light on Lincoln and \"ran out of truck\" on the way across. I asked her to explain. She says the engine cut, it kept going a bit on its own weight without the driver braking, slower and slower, and it is sitting in the intersection in her lane. Driver's out, kicking it.",
#:   "The one time I see somebody jump that red and the good Lord's watching. A Range Rover, brand new, from the left, straight over the line. Poof. All its lamps go out. It's got no more push in it, you could see by how he bobbed back and forth at the wheel to help; it trickled, it dawdled, it stood. On my bit.",
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

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) / globalParameters.OPT_BRAKE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
