#: description = "The crossing car brakes too late for the red light, slides over the line, and stops with its nose in the junction."
#: rephrasings = [
#:   "he sees the red way too late and ends up sticking out into our lane",
#:   "Vehicle 2 failed to stop in time for the signal and came to rest beyond the stop bar.",
#:   "late braking at red, overshoots line, stands partly in lane",
#:   "The target brakes fully after the signal has turned red and comes to a standstill past the stop line, protruding into the junction.",
#:   "The truck wants to stop for the red but the brake distance is not enough, so it stops after the line.",
#:   "A van skids past the stop bar and is left jutting into cross traffic.",
#:   "The biker grabs the brakes too late at the lights and halts just short of the ego's way.",
#:   "Unable to pull up at the signal, the bus stands with its front over the line.",
#:   "he braked for the red miles too late and slithered over the line, ended up with his nose poking out in the junction",
#:   "V2 failed to brake in time for the red signal, skidded past the stop line and came to rest protruding into the intersection.",
#:   "Truck: late brk on red, slides past line, nose in jct, stands.",
#:   "The crossing target initiates braking too late for the red signal, passes the stop line and stops with its front in the junction.",
#:   "The bus sees the red too late, he brakes but slides over the line and the front stays in the crossing.",
#:   "Overshoot case: NPC does try to obey the red, but ends ~3 m beyond the stop line, v=0, front overlapping our path.",
#:   "The tyres had wailed, and the car came to rest with its bonnet over the line, thrust out into the way like a tongue.",
#:   "Left his braking too late for that red, hasn't he, he's skidded right over the line and he's hanging out into the junction.",
#:   "he braked way too late for the red and slid half into the crossroads oops",
#:   "A lorry skidded past the marking at a red signal and ended with its cab out in the junction",
#:   "You did brake, but too late, so that the front of your vehicle was left out in the junction?",
#:   "Red light he late brake, gone past the line, head sticking out inside the junction",
#:   "He's noticed the red about a week late, tyres smoking, and he's finished up with his snout in my road",
#:   "Late braking at red signal with line overrun and residual front protrusion",
#:   "Bus SLIDES past the red light and stops half in the intersection",
#:   "The motorbike skated over the line on red and stuck its nose out.",
#:   "Crossing cab brakes for red too late, ends bonnet-deep in junction.",
#:   "Lorry misjudges red, skates beyond the line, halts poking into crossing.",
#:   "Make the bus on the side road overrun its red and stop protruding.",
#:   "He did want to stop for red, but his nose came in.",
#:   "Tardy braking on red, line overrun, vehicle now static, front out.",
#:   "By the time the motorcyclist had seen that his light was red there wasn't road enough left, so he slithered across the line and stood half out.",
#:   "Owing to a delayed brake application at the red signal, the crossing target passes its stop line under braking and remains with its front part in the intersection.",
#:   "Look left: his light's gone red, he's left it late, the wheels are locked, over the paint he goes, and there's his bumper sticking out at you.",
#:   "The coach came from the cross street, it has braked in the last second for the red, glided over the line and stayed with its mouth inside.",
#:   "The bonnet of a saloon was jutting out into the junction, having come to rest there after late braking and a skid past its line on red.",
#:   "Do you accept that you applied the brakes too late for the red lamp, slid beyond the marking and were left standing with your cab in the crossroads?",
#:   "It had rained for the first time in weeks. I saw the van on the other road, I saw that his light was red, and I heard the tyres give up. He tobogganed over the white line and finished with his grille a good two metres inside the crossing, looking very sheepish.",
#:   "Vehicle 2 did attempt to comply with the red signal. Its braking, however, commenced only nine metres before the stop line; it therefore overran the line by some three metres and came to a standstill, its front end in the path of Vehicle 1, where it remained until the light changed.",
#:   "Please build the late braker at red. Cross-traffic pickup decelerates hard but from too close, crosses its stop line with wheels sliding and stops with hood and front axle inside the box. It does not go on, it does not back off. Ego must get by the nose or wait behind its own line.",
#:   "When you've got forty tonnes behind you and the lights drop, you learn humility. My mate on the ring road had been fiddling with the radio. On went everything, the whole rig juddered and slid across the line, and when it finally stood, his cab was out in the crossroads under a red light.",
#:   "From the cycle lane I had a fine view of a young man in a hot hatch who found out that red means now. He braked, oh yes, but a second too late; the car glissaded across the line and then just sat there, with its chin out where all the others wanted to go.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advMeeting", "advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "brake", "stop"]
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
#: low = 7.0
#: high = 11.0
#: unit = "m/s"
#: meaning = "how fast it comes in"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = -4.5
#: high = -1.5
#: unit = "m"
#: meaning = "how far beyond where their ways meet it comes to rest"

param OPT_ADV_DISTANCE = Range(0, 22)
param OPT_ADV_SPEED = Range(7, 11)
param OPT_STOP_DISTANCE = Range(-4.5, -1.5)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory)
