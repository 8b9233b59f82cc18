#: description = "The rider rolls slowly out of the roadside into the ego's lane, stalls and stands across it."
#: rephrasings = [
#:   "A learner on a scooter creeps out, stalls and is stuck broadside before us.",
#:   "The motorcycle entered the travel lane at low speed, stalled, and blocked the lane.",
#:   "moto creeps out, stalls across lane",
#:   "The powered two-wheeler moves slowly onto the VUT's path and comes to rest perpendicular to it.",
#:   "The moped comes slowly and then the motor dies, it stays across on the lane.",
#:   "A rider loses his chain as he rolls off the pavement and stands there helpless.",
#:   "The e-bike gives up the ghost just as it noses into our way.",
#:   "A heavily laden cargo bike edges out and gets stuck sideways.",
#:   "an old boy on a moped trundled out off the roadside, cut out and was left standing sideways over my lane",
#:   "The motorcyclist rolled slowly from the roadside into the lane, stalled the engine, and remained across it.",
#:   "MC creeps out from side, engine dies, crosswise in lane.",
#:   "The PTW enters the lane at low speed from the roadside, loses drive and stands transverse to the VUT.",
#:   "The motorbike rolls slow from the side in my lane, then motor is off, and it stands cross.",
#:   "Rider emerges at walking pace from the shoulder, drops to v=0 by itself and stays at 90° to our heading.",
#:   "The scooter came trickling out of the verge, coughed and died, and there its rider sat, blocking the way with its length.",
#:   "She's rolled out too slow and she's stalled it, bike's lying across your bows now and she can't get it going.",
#:   "scooter rolled out rly slowly, died and is now sideways in our lane",
#:   "A trainee motorcyclist trickled into the road, lost his engine and was marooned broadside in the lane",
#:   "At a crawl you left the verge, your engine cut out, and the machine was left lying across the lane's width, upright?",
#:   "Bike slowly slowly came out from side, engine off, now standing crosswise blocking us",
#:   "Dribbles out off the side, conks out, and there he is side-on in front of me kicking the starter",
#:   "Slow roadside entry of two-wheeler with stall and transverse blockage",
#:   "Motorbike creeps out, STALLS sideways in my lane",
#:   "The moped seeped into our lane and conked out crossways.",
#:   "Pizza moped limps off the pavement, cuts out, bars our lane.",
#:   "E-bike crawls into our lane sideways and dies on the spot.",
#:   "Broadside and lifeless: the motorbike that had just dawdled off the verge.",
#:   "Make a scooter ease from the roadside into our path and conk out.",
#:   "Slow entry of bicycle, chain off, standing square across the lane.",
#:   "The pupil let the clutch up far too gently, trickled off the grass strip into the lane, felt the engine quit and sat there with the bike at right angles to us.",
#:   "A powered two-wheeler enters from beside the carriageway at 1.5 m/s, loses propulsion on the VUT's path and remains there, its longitudinal axis perpendicular to the lane.",
#:   "I had to stop because an old lady on a tricycle had rolled out of the hedge gap at a snail's pace, got stuck in my lane and couldn't move it.",
#:   "Please simulate a moped that comes off the side at hardly any speed, has its motor give out in the ego's lane and blocks it lengthwise, rider still astride.",
#:   "La moto go out very slowly from the border of the road, in my lane the engine he dies, and she remains there standing crossed.",
#:   "Careful, that scooter's inching out from the lay-by, she hasn't got the revs, and there, it's gone quiet, she's stranded sideways right where we want to go.",
#:   "I only wanted to get over to the petrol station. I let my old Honda roll gently out of the gateway, and with the front wheel about on the dotted line she coughed and gave up. There I was, side-on across the lane, kicking away like mad with a driverless car waiting.",
#:   "Vehicle 2, a 49 cc motor scooter, departed the shoulder at very low speed on a path perpendicular to the lane of Vehicle 1. Its engine ceased to run while it was in that lane, and it was standing upright and crosswise there when struck.",
#:   "It is a helpless sort of obstacle. First you see a cyclist with a loaded trailer pushing off laboriously from the roadside, hardly moving; then, in the middle of your lane, the legs give out, and bike and trailer are stuck athwart your way like a gate.",
#:   "Message to all cars, Station Road, be aware of a motorcycle obstructing. Rider came off the footway dead slow, engine failed as he got into the lane, and he's now stationary at right angles to the traffic. He can't restart and he hasn't pushed it clear.",
#:   "Did it come at you quickly, Mr Rao? No sir, very very slowly, from the mud side of the road. Then the motor went dut-dut and was finished, and the fellow was sitting on it there, handlebar to one side, back wheel to other side, my whole lane shut.",
#:   "Moped noses out at a dribble, dies crossways in our lane.",
#:   "Rider oozes off the verge, engine quits, bike bars the road.",
#:   "Let an e-bike crawl out sideways, lose power, and block us.",
#:   "At hardly more than walking speed the learner brought his motorcycle from the gutter into our lane, where the engine choked and left him standing crosswise.",
#:   "The two-wheeler, entering from beside the road at 1.5 m/s, comes to rest with its flank to the VUT after drive is lost.",
#:   "Too little gas, poor girl: she'd come gingerly out of the gateway, the scooter gave a cough, and there she sat, side-on, before our bumper.",
#:   "It was a cargo bike, it came by inches out of the roadside, its motor has made \"pfft,\" and then it lay across my lane like a ship.",
#:   "Broken chain, says the note, so the cyclist who had just started trickling over from the shoulder got no farther than V1's lane and stood athwart it.",
#:   "Bullet came from the side very slow, put-put-put, stopped by itself in middle of my lane, and uncle is kicking and kicking, bike totally horizontal.",
#:   "First we had its front wheel in our lane, next the tank, next the rider's boot, and all of it took ages. Then the noise stopped. What we had from there on was a complete motorcycle from lamp to number plate, at a right angle to us, and a man pressing the starter with his thumb.",
#:   "Nobody blames the boy. He had been sitting by the roadside on a borrowed moped; he let it roll out carefully, more carefully than was good for it, and it cut out under him in the lane. When the policyholder's car came round the corner the machine stood broadside and he was still on its saddle.",
#:   "You can tell from his left hand, he's slipping the clutch for dear life. He's coming off the gravel, slow, slow, right into our road, and he's let it up too soon. Stalled. So now we've a bike parked sideways in front of us and no amount of looking at him is going to start it.",
#:   "Operator of V2 stated he \"was going real easy on account of the sand.\" He left the shoulder at a crawl on a heading perpendicular to the lane. The engine died as the motorcycle reached the center of the lane, and V2, rider astride, was stationary in that attitude until contact.",
#:   "The shuttle gave two polite beeps. It couldn't know that the battery of Frau Huber's electric bicycle had been at one percent when she set off from the bench, and at none when the bicycle, with its heavy baskets, lay across the shuttle's lane. She had come out so slowly that the geese overtook her.",
#:   "The event is harmless by its speed and nasty by its end. A rider edges out from the side no quicker than people walk, so a planner may well decide to pass in front or behind. Then the drive fails, he's stuck where he is, and both ways are shut, because his bike spans the lane.",
#:   "I put it on the forum because somebody's bound to ask why I had one foot on the tank. Carb was flooding. I feathered her out of the lay-by, dead slow, got as far as the middle of the lane and she went blub and was dead. Sideways on, with a robotaxi sat there looking at me.",
#:   "It seemed to her that she had watched it for an hour. A man in a leather coat was bringing his motorcycle out of the yard as one brings a cow, by slow persuasion, and the motor grumbled. In the midst of the lane it gave up grumbling, and beast and man stood there across their way and wouldn't be persuaded further.",
#:   "Control from Kilo Two, I'm delayed. One motorcyclist, elderly, has come off the hard shoulder very slowly and conked out in my lane. The bike's upright, lying right across the lane if you follow me, he's sitting on it, and it won't fire. Request someone to help push.",
#:   "For obstacle set R: start the moped beside the lane at right angles to it. Release when the ego is near, speed low enough that a pedestrian could keep up. As soon as it's on the ego's path its propulsion fails, it comes to a stop and remains in place, transverse.",
#:   "My granddaughter laughed but I didn't find it funny. I was taking the bicycle over to the shop side and had only just begun to roll, ever so softly, down off the kerb and out. Something went crack in the pedals, and I could move neither forward nor back, and I was standing slap across the lane of that car.",
#:   "Scooter trickled off the verge, choked, and there it stood, crossways.",
#:   "Slow out of the gateway, dead in our lane, side-on.",
#:   "Let a moped seep out from the roadside and conk crosswise.",
#:   "He gave it so little gas coming off the gravel that it gave up in our lane, where machine and man now stood like a barrier.",
#:   "The bike's tank, saddle and back wheel were all laid out across my lane, silent, its rider having eased it out of the lay-by and lost the engine.",
#:   "At less than walking speed the two-wheeler leaves the roadside, comes onto the VUT's path, has no more drive, and remains upright and transverse.",
#:   "When the putt-putt ceased there was still half a lane to go for him, so we had the motorbike square in front of us, upright and going nowhere.",
#:   "The battery of the cargo bike said goodbye just where it should not, after she had crept from the path into my lane, and so it stood there transverse.",
#:   "Kick, kick, kick, goes the old boy, and nothing catches, and his Honda that he'd nursed out from the kerb is broadside on over our lane.",
#:   "Between his leaving the verge and his front wheel reaching my lane I'd had time to fold up the map. I needed no hurry with the brake either. And yet I was stuck there for a good four minutes, because his engine had expired with the bike at right angles to us, both wheels in our lane, no way before or behind it.",
#:   "The noise is what I'd ask you to follow on the tape. There's a low, uneven burble, that's him leaving the roadside, and you'll notice how long it goes on. At 11 seconds it stumbles. At 12 there is none. The picture shows the reason for our stopping: a scooter, in profile, from one line of our lane to the other.",
#:   "My lad had only passed on the Tuesday. I told him, gently off the grass, mind. So gently it was that a duck got over before him. He'd his head turned to see the robot car, and he let the clutch bite with no revs. And then he was a gate, sir, a gate with a helmet on, shut across that lane.",
#:   "The marks of both tyres in the dew lead from the edge of the road to V1's lane at ninety degrees, and end there. No skid, no fall. Operator 2 states the cable broke while she was \"just feathering it out.\" She was seated, engine dead, feet on the road, motorcycle spanning the lane, when V1 came to a stop against it.",
#:   "Anyone can dodge a thing that dashes out. You can't dodge one that takes its time, uses up your road inch by inch and breaks down when it has used up the most. It was a tricycle, for grown-ups. It'd come off the pavement at a shuffle; its chain went; it stood with its basket at one line and its bell at the other.",
#:   "In the depot they laugh, \"stopped by a moped,\" but look at it from the driver's seat. He comes dribbling out of the side, I think I'll let him over. Then his headlight goes yellow, and brown, and out. He's level with my badge, sideways. He's got it in gear so it won't push. And a bus is eight foot wide.",
#:   "A rider who is about to stall gives it away, and I'd like you to learn it. Too slow. See her edging from the kerb, feet paddling? Bike shaking? Now listen. There, gone. She's sitting across our lane with a dead engine, and she will press every button she has before she thinks of pulling in the clutch.",
#:   "They waited for the priest's motorcycle as one waits for the end of a sermon. It had emerged from the cypresses beside the road with dignity, at the pace of a procession. Before the car, athwart the only lane, it fell silent. The priest did not dismount; he stood astride it, his hands folded upon the tank, and looked upwards.",
#:   "Expected: rider clears lane at 1.4 m/s in 3.1 s. Observed: rider comes from off-road at 1.4 m/s as far as our centreline, exhaust plume stops, speed drops away to nothing without brake. Yaw relative to us stays at ninety. Object width for the planner is therefore 2.1 m, in a lane of 3. It's still there at the end of the recording.",
#:   "Petrol tap. It is always the petrol tap. What was in the carburettor got my Bullet off the roadside dust and, puff puff, into the lane of one empty taxi, I mean really empty, no driver also. There the puff was finished. I am standing in full width, bending down for the tap, and this empty taxi is blinking at me.",
#:   "Can we have it so that the ego has no choice but to stop? A cyclist sets off from beside the road, straight for our lane, hardly quicker than a tortoise, with a heavy trailer. In our lane the freewheel slips, and her pedals go round for nothing. She comes to a stand there, bike and trailer blocking us like a bar.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "slow", "stop"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.4
#: high = 2.6
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 30.0
#: high = 50.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.0
#: high = 1.1
#: unit = "m"
#: meaning = "how far from the ego's line it comes to rest"

param OPT_ADV_SPEED = Range(1.4, 2.6)
param OPT_ADV_DISTANCE = Range(30, 50)
param OPT_STOP_DISTANCE = Range(0, 1.1)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 4
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt()
