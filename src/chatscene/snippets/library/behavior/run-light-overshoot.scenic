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
#:   "Red noticed late: the lorry skids past its line, bonnet left in the crossing.",
#:   "Let the crossing scooter brake too late on red, stopping nose-out.",
#:   "FAIL: hatchback slides over the line on red, parks its face in traffic",
#:   "The van from the cross street did go for its brakes at the red, but when everything had come to rest its front end was lying in the junction.",
#:   "With braking begun at a distance shorter than its stopping distance, the crossing target overruns the line on red and ends stationary, its front overlapping the VUT's lane.",
#:   "The motorcycle from the side wanted to hold for the red, only he has braked too late, so he slipped over the line and stood with the front wheel inside.",
#:   "That bus on the left's going to try and stop for its red. Too late, it's skating, it's over the line, and there it sits with its chin out.",
#:   "Will you agree that a driver who stops for a red with half his bonnet in the crossroads has begun his stopping too late?",
#:   "Drizzle, red lamp, pickup coming from the right; brakes grabbed in panic, stop line gone under the wheels, and the thing finished up poking its snout into our way.",
#:   "There's a strip of paint at that crossing that tells you where to stand on red. The taxi on the side road hit the brakes so late that its rear wheels ended up where its front ones should have been. The rest of it, the yellow bit with the driver going \"sorry, sorry\", was in the junction, stock-still.",
#:   "V2 was approaching on the intersecting street. Its signal had turned red 2.8 seconds earlier. Skid marks from V2's tires begin nine feet before the limit line and continue twelve feet beyond it, and V2 was at rest at their end, its hood within the intersection. V1 steered around the hood.",
#:   "We carry hot soup, so I drive like there's a baby aboard. My mate on the cross street doesn't carry soup. He looked up, saw red, and stamped, but by then physics had made its mind up: his truck came slithering over the line and stopped in a cloud with its cab out where I was due to go.",
#:   "Request from the infrastructure team: we want the honest-but-late driver. Crossing car, red light, full braking from too near. It passes its stop bar with wheels locked and gets to v = 0 with about two metres of front in the junction. It's then a fixed obstacle; no backing up, no driving on.",
#:   "My knitting fell off my knee, that's how I remember. A most awful screech from the right, and a big red coach, whose lamp was as red as itself, was sliding towards the white line, and over it. It did stop. But its whole flat face was hanging out into the crossing, and we'd to creep round it.",
#:   "On the cycle course they teach you to watch the nose. The nose of the SUV over there dipped, good, he's seen the red. It stayed dipped for too long, bad, he's left it late. The line vanished beneath it. When the nose came up again it was in the junction, motionless, and I went around it.",
#:   "Nobody jumped the lights, that's the funny part. The lad on the motorbike tried to obey. Both levers, back wheel snaking, the white bar going under him with a sort of hiss, and when it was over he stood there, feet down, with his headlamp out in the crossroads and the whole of Market Street looking.",
#:   "The signal had long been red on the side of the brewery, and the brewery's wagon, coming down from there, found it out too late. All its brakes cried together. It glided majestically across the mark; it groaned and stood. Its radiator, steaming, projected into the square like a drawer that someone has forgotten to shut.",
#:   "For us the light was green and I was in third. My instructor put his arm across me, like mothers do. From the right there was a saloon with its wheels locked and the driver's mouth open; he was past the line, he was still coming, he wasn't coming any more. A metre of car stuck out into my green.",
#:   "Officer at scene: the one sticking out is the minibus. He states that he saw the signal change but misjudged the wet. Braked hard, too late, carried on over the line, and stopped with the front overhanging the intersection. He hasn't moved since for fear of making it worse. Cars are passing in front of him.",
#:   "In Shanghai I see this also. Crossing truck have red light. Driver look at phone, then look at light, then press brake to the bottom, already not enough distance. Truck slide over stop line, truck stop, head of truck is in the crossing. My car must drive around the head.",
#:   "Taxi fails to hold its red: long squeal, bonnet in crossing.",
#:   "Too late on the anchors, crossing lorry pokes into our junction.",
#:   "braked for the red, sort of. half a scooter over the line",
#:   "From the side there came first a shriek of tyres and then, past the white line it ought to have honoured on red, the front third of a coach, and no more.",
#:   "The crossing saloon did honour its red in the end, at a point where its back wheels were on the stop line and its front ones in our junction.",
#:   "Have a motorcycle on the cross road see its red too late, skate past the line with the wheel locked, and be left with its fork in the ego's road.",
#:   "The target on the conflicting approach commences full deceleration at a distance from its stop line shorter than required, and comes to rest with its front overhang inside the junction.",
#:   "What was it doing with its grille in the intersection? Sitting there, quite still, at the end of two black stripes which started short of the stop line and shouldn't have.",
#:   "He's got red, he's braking, he is not going to make it, he's over, there, he's stopped with his snout out, now steer round that.",
#:   "Red for them, green for us, and Mum was already saying \"good, they're stopping\", because you could see the van's headlights go down. They were down for a long time. They came over the thick white stripe still down. When at last they came up again, they were pointing across our bonnet, from in the crossroads, and stood.",
#:   "The man with the broom had a story to tell for the rest of the week. A pickup had come up to his corner at a fair lick with its light gone to red. It had dropped its tail gate, all its melons and most of its speed, but not enough. He swept melons from before the line, on the line and from the junction, where its bumper was.",
#:   "Item one, position of rest of V2: front axle 1.9 m beyond the stop bar, facing across V1's lane edge. Item two, tyre marks, 14 m in length, the greater part of them before the bar. Item three, signal: red to V2 during all of it. From these it follows that V2's operator meant to stop, and began to do so a car's length too late.",
#:   "I don't call that jumping a light. A jumper doesn't lean on the brake so that his lorry's cab nods like a horse. This one was trying. But forty tonnes on wet leaves are a long time trying; so it went grinding by the post with its red lamp, and by its line, till it stood with its face in where we had green.",
#:   "We had agreed on red-light violations with a clean result: through, or not. The result in this one's dirty. Braking from the crossing bus at t = 2.2, line passed at t = 3.0 with 4 m/s on the clock, standstill at t = 3.7. Occupied thereafter, until further notice: the mouth of the junction, by a metre and a half of bus.",
#:   "Driving examiner, retired. One sees the candidate's eyes first. Hers, in the car on the side street, went to the red lamp as if it had that moment been hung there. Then her hair came forward. Then the front wheels, not turning, came over the line. There they rested, with the headlights overlooking our half of the crossing.",
#:   "It made no sense to go and no sense to stay. My lamp was green. From my left an elderly Volvo had slithered out from under its red, nose first, and it had run out of slither just where I'd have liked to put my near wing. He held up both hands, the driver, and I could smell what he'd done to his tyres.",
#:   "The bang that I waited for didn't come. I'd heard the squeal at my side, I had shut my eyes, for what else squeals at a red but someone who'll be in your door a second on? I opened them. A fire-red hatchback stood over its line with its lamps and its badge hanging out at us, rocking a little, and that was all.",
#:   "For a French he was correct, he wanted to respect the red. Only, he discovered it at ten metres. The wheels were blocked, the camionnette was sliding, it passed the line, it passed the passage for the pedestrians, and when finally it was immobile, we had its beak before us in the crossroads.",
#:   "From above, on the footbridge, you could have put a ruler to it. Up to the lamp and its line belongs to them; beyond, that's the junction, and green was for the bus. The cab had all its weight on its front tyres and its line under its belly by then. It stopped. I made it as much over the line as behind it.",
#:   "It'd be silly to fine her more than for the metre. She'd got it down from fifty to nothing, after all, and at a red. But the metre, or one and a half, was the one in which our front wing would've been. In we came on our green, and there was the bonnet, stationary and steaming, put out from behind the line like a tongue.",
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

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory)
