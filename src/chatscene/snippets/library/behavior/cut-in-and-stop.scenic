#: description = "The car moves in front of the ego, rolls to a stop and stands in the ego's lane."
#: rephrasings = [
#:   "A taxi squeezes in ahead of us, rolls out and parks itself in our lane to drop somebody.",
#:   "Vehicle 2 entered the lane of vehicle 1, slowed and came to rest there.",
#:   "Cut-in, soft stop, stationary obstacle.",
#:   "The target merges in front of the VUT, decelerates comfortably to standstill and remains.",
#:   "He changes to our lane and then he only stands there, we cannot go.",
#:   "The bus pushes over before us and eases to a halt at its stop.",
#:   "A van from beside takes our space, fades to nothing and plugs the road.",
#:   "The motorbike filters in front, runs out of go and leaves us nowhere.",
#:   "The bus drifted over ahead of me, coasted down to nothing and just sat there in my lane.",
#:   "Unit 2 moved over in front of Unit 1, gradually came to a halt, and remained standing in the lane.",
#:   "Taxi changes lane ahead, rolls out, parks itself there.",
#:   "After the lane change the target decelerates gently to zero and remains stationary ahead of the test vehicle.",
#:   "Lorry goes in my lane before me, gets slower and slower, and stays there.",
#:   "Merging actor coasts to v=0 and never clears, lane stays occupied; not a hard brake.",
#:   "She watched it slide across into her lane, lose its pace little by little and come to rest there as if it had arrived home.",
#:   "He's pulling over in front of you, he's rolling to a halt, and now he's staying put right in your lane.",
#:   "he came into my lane, slowed down n down til he just parked there lmaooo",
#:   "A bus slid over into the lane, lost way and was left standing there with traffic stacked up behind.",
#:   "And once in my client's lane you let your car run out of speed and left it there, did you not?",
#:   "Taxi changed to my lane, then slow slow slow and full stop, he is not moving at all.",
#:   "Drifts over in front of me, dribbles to nothing and plonks himself there, picking up a fare I bet.",
#:   "Lane occupation by merging vehicle after gradual loss of speed to rest",
#:   "He merges in front... then just DIES there",
#:   "The coach sidles into our lane and settles there.",
#:   "Slots in ahead of the AV, fades out, stays put.",
#:   "coach nosed acros into our lane, dawdled to nothing, didnt budge",
#:   "Have the cab merge before us, glide to rest and remain.",
#:   "He came in front, slowly slowly no more moving, blocked.",
#:   "Veh 2 entered lane, gentle decel to nil, remains stationary.",
#:   "An ambulance worked its way over from the next lane into the space before me, let its speed drain away and then simply occupied the road.",
#:   "Once the hatchback was in front of you, having changed lanes to get there, it ran itself down softly and you were left looking at its boot.",
#:   "The artic indicated, came across ahead of our car, and without any sharp braking whatever lost its speed till the wheels ceased turning, and there it stood.",
#:   "I want a motorbike that changes into the ego's lane just ahead, trundles down to zero without drama, and stands there as an obstacle.",
#:   "Pupil, what do you do when somebody takes the gap ahead of you, eases up until he's not moving at all, and then makes no move to go?",
#:   "Sir, my lane was plugged by a pickup, which had first crossed over to it before my bonnet and then gradually gone to sleep on the spot.",
#:   "The recording starts with the van abreast of us in the other lane. It eases over into our space, and you expect it to carry on, but it loses way bit by bit until it is standing, hazards on, and that is where it was when we gave up.",
#:   "There was nothing violent about it, I must tell you. The little saloon put itself before me, and I watched the gap shrink as it grew slower and slower, as if it had used up its last drop; and at the end it was at rest and I was stuck.",
#:   "A parcel van had come to a stand in the lane of Vehicle 1, about fifteen metres ahead. Seconds earlier it had been in the lane next to it, from where the driver changed over and permitted the van to run out gently to a full stop.",
#:   "my bus is late bc of this taxi: shifts across in front of us from the lane next door, drops its speed nice and soft, then it's stopped, then it's just there. No reason, no passenger, nobody gets out. We wait behind it like idiots",
#:   "Dispatch, we've got a bus sitting in lane two for no reason I can see. Caller says it came across from lane one just ahead of her, took its speed off nice and easy until it was at nothing, and it's been a roadblock ever since.",
#:   "Scooter comes over in front, peters out, and camps in our lane.",
#:   "Make the SUV take the gap ahead, ease to zero and remain.",
#:   "MERGES, FADES, PARKS: van blocks my lane for no reason",
#:   "From the neighbouring lane a coach came over before our bonnet, bled away its pace quite gently, and then would not budge from where it had come to rest.",
#:   "The lorry changes into my lane close in front, it rolls out without real braking until the wheels are quiet, and there it remains like a house.",
#:   "Police car shifts across from the next lane to sit ahead of you, lets itself run down, and you're behind a stationary light bar with nowhere to go.",
#:   "A lane change by the target to a position directly in front of the VUT is followed by mild deceleration down to a lasting standstill in that lane.",
#:   "The motorcyclist, once he had come across to the place in front of my client, allowed his machine to lose way until it stood, and there he left it standing.",
#:   "Did the cab at least brake hard, as a warning? No: it stole over into our lane, wilted gradually, and was in the end just an object there.",
#:   "You could set an egg on the dash and it wouldn't have rolled. The bus drifts in from the next lane along, takes the place in front of me, and starts to go slower, and slower, and you think, well, it's got to go again. It hasn't. We counted eleven cars stuck behind it and me first among them.",
#:   "The obstruction to Vehicle 1 consisted of a delivery van at rest in lane two. It had not been there long: it had been ahead in lane one, had been steered over to lane two shortly in front of Vehicle 1, and had there coasted to a halt. Its driver was consulting a parcel list and did not move on.",
#:   "Repro for the blocked-lane case. NPC is beside and a bit ahead, changes into the ego lane, and its speed then decays at perhaps one to two m/s² until it reads nought. It never leaves again. Ego should not slam on anything, it should stop behind and, after a while, plan a way round.",
#:   "My grandson calls it \"doing a tortoise\". A young woman in one of those tall cars put herself in front of us from the other lane, and it was quite neatly done. But by and by she ran out of puff, and there was her tail, perfectly still, and we sat behind it till the end of the afternoon play.",
#:   "I thought he'd seen the turning. He came across to my side of the dashes, right ahead, fine; I gave him room. But the pickup merely got lazier, without any fuss, until I was creeping, then it wasn't moving and I wasn't either, and he'd got his phone out.",
#:   "From the top deck one has a good view. An ambulance, no siren, glided over from the middle lane and settled in front of our driver. Then the thing seemed to run out of wishes; it slackened, it dawdled, it came to a rest as softly as a leaf, and no one got out and nothing more was done.",
#:   "The gap I was keeping for safety got filled, that's where it began. A moped had come out of the lane next door and planted itself in it. Its tail lamp glowed only faintly, yet my speedo sank and sank behind it until we'd both got our feet on the ground, and he didn't look like going any farther.",
#:   "Telegram from the ring road: we late stop artic came over from slow lane stop took spot ahead of us stop no hard brakes but less and less speed stop now it stands and we stand stop send sandwiches",
#:   "Here is what the Chinese colleague wrote in the form: \"Taxi from the side lane go into front of our car, distance short but okay. Then its speed become small, small, finally zero. Taxi do not leave. Our car wait forty seconds behind and operator take over.\"",
#:   "It had come to rest by the time Lotte looked up from the map: a yellow hatchback, motionless in their lane, filling the view. \"It wasn't there before,\" she said. \"It came over from beside us,\" said her father, \"and then it sort of gave up, ever so slowly. Now it's stopping there, apparently.\"",
#:   "Forum, towing section. Had a fire engine do this to me on Sunday with the caravan on. Moves over from the lane alongside into mine, lifts off, keeps on rolling gentler and gentler until there's no roll left. Crew just sat there. Ten minutes I had to study the back of a ladder.",
#:   "Scooter slips in before us, runs down, stays there like furniture.",
#:   "Ahead of me, mine own lane, gently parked. Thanks, cabbie.",
#:   "Coach swaps into our lane, wilts to zero, does not budge.",
#:   "From the lane alongside an ambulance settled in before my nose, bled off its speed as a kettle goes off the boil, and was thereafter simply an obstacle.",
#:   "I had fifteen metres to the van which had just come over. Then ten, with no brake lights to speak of, then five, and then the two of us were a queue going nowhere.",
#:   "Target enters the lane of the SUT from the adjacent one, decelerates at a comfortable level, and persists at v = 0 in that lane until the run is terminated.",
#:   "What do you do, pupil mine, when a hatchback pops in ahead of you and then fizzles out? You stop as softly as he does, because he's staying put.",
#:   "Car 12, we're stuck, a tipper has come across into our lane and sort of expired in front of us. No, no crash, it just isn't going anywhere.",
#:   "Neither the coming over nor the slowing was rude. Only that at the end of it the lady's estate stood square in our lane and that she got out her crossword.",
#:   "By rights the story should have a skid in it, but there's none. A saloon that had been beside us was, after a flick of its indicator, before us. My cruise control nibbled a bit off, then a bit more, then all of it. We stood. He stood. My cruise control asked politely whether I wished to take over.",
#:   "The delay is owed to a delivery van. It had been in the lane alongside until it wanted ours, and we made it a present of the room in front. We then learned why it wanted it: our lane was the one with the bakery. It lost speed evenly, hazard lamps on, and became part of the street.",
#:   "I was counting the rivets on that lorry's tail, which I'd no business doing, since a minute earlier it was in the other lane. It'd come across to mine without any drama. The rivets got bigger, the hum of my tyres deeper and deeper until it was no longer there. Then I'd leisure to count them all.",
#:   "Sir, what is the fault of mine? One motorcycle fellow is on side lane. He is putting himself in front, okay, I am adjusting. Then he is becoming slow, little by little, as if petrol is finishing, and then he's standing in the exact middle of my lane, and still he is standing when I'm phoning you.",
#:   "We replayed it, and the brake pressure in the ego never exceeded what you'd use for a traffic light. First event, a neighbour laterally enters at eleven metres. Second event, its speed ramps down to nothing. There's no third event. It is that absence which breaks the behaviour planner, which waits behind it for ever.",
#:   "Had she hit him, one would have said he slammed on. She didn't, and he hadn't. There had simply been, in Miriam's lane, an empty place; a bus from next door had filled it; and little by little the bus had stopped being a thing that moves. She read the advertisement on its back four times before she understood that it wasn't going to.",
#:   "The scene I'm after ends with a roadblock, but a civil one. At first the way ahead of the robotaxi is clear and there's a police car in the lane next to it. In the last picture the police car is stationary, dead ahead, in the robotaxi's own lane. In between: a lane change, and a deceleration nobody would spill tea over.",
#:   "Our bikes were on the roof, so I braked early. Good thing too. The camper van that'd come over in front of us hadn't put anchors on or anything, you merely noticed that you were reeling it in. When we had reeled it in altogether it was at a dead stand and a man climbed out to look at a map.",
#:   "Maman, why does the taxi sit there? He was next to us, and then he came to be in front of us, on our stripe. And then he went like a toy when the battery is going, slow, slower, and now he is finished and the lady is searching her money.",
#:   "To whom it may concern: the first sign of trouble was a gap that I'd left for safety, and which a pickup from the adjoining lane understood as an invitation. The second was that this gap, once he had it, grew shorter while my speedometer went from fifty to thirty to nil. There was no third sign, as nothing moved after that.",
#:   "V2 occupied lane 2 until approximately 200 feet before the scene, at which point it entered lane 1 ahead of V1. The GPS trace of V2 shows 34, 29, 21, 12, 4 and 0 mph at one-second steps, followed by forty seconds of 0. The point of rest lies in the center of lane 1. V1 stopped behind without contact.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["cut-in", "stop"]
#: leader = false
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = 3.0
#: high = 9.0
#: unit = "m"
#: meaning = "how far its rear is ahead of the ego's front before it moves over"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.2
#: high = 0.4
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(0, 30)
param OPT_ADV_AHEAD = Range(3, 9)
param OPT_BRAKE = Range(0.2, 0.4)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD + (ego.length + self.length) / 2, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE and headway(egoRoute, ego, self) > 4
    do DrivePath(egoRoute, 7) until abs(offsetFrom(egoRoute, self)) < 1
    do BrakeOnPath(egoRoute, globalParameters.OPT_BRAKE)
