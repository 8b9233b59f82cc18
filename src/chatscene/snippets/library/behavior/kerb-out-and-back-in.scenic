#: description = "The parked car pulls out into the ego's lane and at once pulls in again at the kerb."
#: rephrasings = [
#:   "He pulls out, drives two car lengths and tucks back into the side.",
#:   "Vehicle 2 left the curb, occupied the lane briefly and returned to the roadside.",
#:   "Parked veh out, then in again further on.",
#:   "The target merges ahead of the VUT and returns to the parking strip.",
#:   "It comes out and goes again to the border, only changes the place.",
#:   "The bus leaves one bay and dives into the next.",
#:   "A van hops out round something and parks up anew.",
#:   "The rider ventures off the roadside and ducks back to it.",
#:   "A parked car nosed out into my lane, thought better of it and tucked itself back in.",
#:   "Unit 2 left the parking lane, entered the travel lane, and immediately returned to the curb.",
#:   "Van out of bay, into lane, back to kerb at once.",
#:   "The parked target moves off into the lane of the test vehicle and forthwith steers back to its parking position further on.",
#:   "The bus goes out from its place and right away again to the side.",
#:   "Parked actor: out, then straight back to the edge, forward motion throughout, net zero.",
#:   "It slid away from the pavement into her path, and as quickly it ducked back to the side as if ashamed.",
#:   "That ambulance is coming off the side, no, he's changed his mind, he's tucked back in by the pavement.",
#:   "parked car came out infront of me then was like nvm and went back to the side",
#:   "A van left its parking place only to dive back to the roadside a few metres further on.",
#:   "You quitted the roadside, entered my client's lane and, all in one movement, resumed the roadside?",
#:   "That parked car came out on the road, then immediately went back to side, simply confusing me.",
#:   "Out of his bay, into my lane, back by the pavement again, what was that, a lap of honour?",
#:   "Brief excursion of parked vehicle into own lane with immediate return to the roadside",
#:   "PARKED CAR FAKES ME OUT - out and straight back in",
#:   "The standing bus bobs out and snuggles back to the side.",
#:   "Moped leaves the kerb, enters our lane, promptly slots back in.",
#:   "Parked taxi: into ego lane, no dwell, kerb again farther along.",
#:   "It comes out from parking, and in the same moment again in parking.",
#:   "Out pops the ambulance from the roadside, and in it goes again.",
#:   "Why swing out from the kerb just to return to it directly?",
#:   "The delivery lorry left its place by the pavement, stuck its whole length into our lane and, a few yards on, was by the pavement once more.",
#:   "Make the parked car drive off into the ego's lane, then have it steer straight back to the side of the road without stopping.",
#:   "A police van that was standing at the edge came out before me, made a sort of bow in my lane and resumed its place at the edge.",
#:   "He's signalled, he's left the side, now he's in front of you, and look, he's already steering in for the next free space.",
#:   "The coach relocated by two bays: it emerged from the kerb ahead of the AV and, with no pause in the lane, tucked itself against the kerb anew.",
#:   "Standing vehicle departs from the roadside, transits laterally into the subject's lane, and reverts to the roadside forthwith on a forward path.",
#:   "I was coming past the parade of shops when a parked saloon drove out into the lane I was in. I'd hardly touched my brakes before it had gone in again, two cars farther up, and its driver got out and went into the bakery.",
#:   "Test run 12: the target, initially stationary along the kerb, sets off ahead of the vehicle under test, reaches the middle of the lane and is thereupon steered back to the kerb line in one continuous forward movement, leaving the lane free again.",
#:   "Like a fish coming up for a fly, the motorbike rose out of the row of parked vehicles, broke the surface of our lane for the space of a breath, and sank down again among the others a little farther along. It never turned round; it just rejoined the kerb.",
#:   "Drivers, beware of him at Church Road, he does it every morning. The bus stands at the side, off he goes into your lane, you're already hard on the brake, and he's at the side again by the next lamp post, as he only wanted to make room.",
#:   "The witness was walking her dog. She saw the grey SUV move away from the kerb into the path of the robotaxi and thought there would be a bump, but it carried on in a curve and was up against the kerb again before the robotaxi got there.",
#:   "Out of its parking space, one wiggle in our lane, parked again.",
#:   "Bus leaves kerb, visits our lane, rejoins kerb directly.",
#:   "Fire engine comes off the side and straightaway goes back in.",
#:   "The scooter parked along the road set off into my lane, and before I could even hoot it had been steered in at the edge again.",
#:   "V2 departed its parking space, occupied the lane of V1 for less than two seconds and, without stopping, resumed a parked position farther along the curb.",
#:   "the UPS van pulled out of a spot into my lane and then literally straight back into the next spot, bro why not walk",
#:   "Careful of that parked car, he's coming out. No need to stop, though, he only wanted the space in front and he's snuggling in by the kerb again.",
#:   "Have the taxi at the kerb swing into the ego's lane and, in the same flowing curve, return to the roadside a little farther down.",
#:   "Standing lorry was coming out on my side of road, and immediately, without any halt, again he has gone to the footpath side and parked.",
#:   "It's the widow's Volvo, she moves it for the street sweeper. She started it up by the kerb and out she came in front of my car, the whole of it, right in my lane, and I'd one foot on the brake. There was no need, she was already bending in again beyond the skip, and by the time I drew level she'd locked it.",
#:   "There's a gap in the log of lane occupancy, and it's 1.8 seconds long. Before it the parked ambulance is outside our lane, touching the kerb, and after it it's outside our lane, touching the kerb, nine metres farther on. During it the thing is smack in the middle ahead of us, and our AEB fires.",
#:   "I was eating a sandwich on the wall when the robotaxi came by. A van which had stood in front of the bank all morning made off from the pavement, right into its way. It was like a man stepping off to go round a lady: two seconds in the lane, and he was hugging the pavement again past the bollards.",
#:   "In this scenario the parked target sets out along a shallow arc into the ego's lane. The apex having been reached, the arc is completed towards the kerb, where the target ends its run. At no instant does it stand in the lane or travel backwards.",
#:   "By the time my horn had sounded, the reason for it was gone. I had sounded it at a motorcyclist who came out from between the parked cars along the edge and was in my lane as large as life. He'd tucked himself away along that same edge, a couple of cars up, and he looked quite hurt.",
#:   "Look, he's got his indicator going the wrong way for what he does next. It says out, and out he comes from the kerb, that coach, and you quite rightly ease off. But he's never going to stay: he's sweeping in at once, to the bay ahead, and there you are with a clear road again.",
#:   "Insured's account: a parked people carrier moved out from the nearside into my path. I braked sharply and my dog fell off the seat. When I looked up the people carrier was no longer in my path, as it had swung in to the nearside once more, its driver having, he told me, merely wished to be nearer his gate.",
#:   "He got cold feet, I reckon, that copper. Off from the kerb he comes with his wheels over, he's in my lane and my load's shifting, and then maybe his mate says not this one, Dave. The wheels go the other way, he rolls along into the side and sits there as if nothing had happened.",
#:   "The lane lay open before her; it was closed by a green bus that had been dozing at the edge of it; it lay open again. She could not have said which astonished her more, the bulk swaying out before her or the meekness with which, hardly out, it leaned away and settled against the pavement a little farther on.",
#:   "I go on my bicycle behind a car and we both see the lorry by the border, with flowers painted on it. The lorry goes out, the car before me brakes, I brake. But hop, the lorry is already going in to the border, ten metres more far, only for to have shade.",
#:   "Weirdest parking move I've seen. He's against the kerb, there's loads of room, and he drives it out into our lane. Then he's carrying on round in a bow and kissing the kerb again one car length up, all in the time it took us to go \"what's he do-\".",
#:   "Kerb, lane, kerb, all in one swoop of a coach.",
#:   "The parked van bows out before us and bows in again.",
#:   "Out of one bay, into the next, with our lane between.",
#:   "My brakes were on for an ambulance no longer there, it had come off the edge, been in my way for a breath, and gone to the edge again.",
#:   "The parked target's lateral offset shall rise to the centre of the ego's lane and fall at once to the kerb line, forward speed being positive throughout.",
#:   "why tho. you're parked. you come out, you're in my lane, my heart stops, and you slot straight back in at the kerb two cars up. why tho",
#:   "The lorry that stood by the pavement outside the bank stands by the pavement outside the baker's now, and it used our lane for a moment to get there.",
#:   "From the parking he has come in my front, full, and before I can give one horn he is already going back in parking a little ahead.",
#:   "You were right to slow, as the bike left the kerb into your lane, and right to pick up again, because there he is, kerbside, further on.",
#:   "There are two wet patches by the kerb in our street, one dry rectangle where the Volvo had been in the rain, one where it was now dripping. In between is the place where the lady in the cab screamed. He'd brought it out right before her and was tucking it in again, a bay farther up, before the scream was finished.",
#:   "I watched a loop being drawn on the tracker. It starts on the right-hand edge of the road, with a stationary bus; it comes out to our centre line nineteen metres before us; and it goes home to the right-hand edge thirty metres before us. The bus never stopped on the loop and it never went backwards.",
#:   "A fire engine takes a lot of getting out of the way, and I was trying to. It had rumbled off from the roadside, every ton of it, and was squarely in front of my little car. My wheels were all but in the ditch when I found I needn't have troubled, since it had rumbled in again by the next hydrant, where they wanted it.",
#:   "It's on the doorbell camera, your worship, you can see how long I was in the lady's lane. You see me leave my space, and that's at nine seconds. You see my front wheels turn in towards the pavement at ten, and at eleven and a half I'm against it again, ten yards along. I only wished to be out from under the pigeons.",
#:   "Somebody had chalked a hopscotch on the road, and I think that's what did it, they were playing. One car off the kerb, hop, slap in front of the robotaxi; same car on to the kerb, hop, in front of the next house. No pause in the middle at all. The robotaxi stood there with its lights flashing at a perfectly free lane.",
#:   "The dispatcher asked me was the obstruction still there, and I had to say, love, I don't know that it ever was one. A motorcyclist stood at the edge of my road. He chugged out till he was straight ahead of my wagon, I dropped my flask, and all in the same go he'd chugged in to the side again, past the hydrant.",
#:   "Tester remark on run 40: AEB fired although the lane was free at the time of standstill. Cause: parked pickup, moves off with ego at 21 m, reaches a lateral overlap of 100 %, and reduces it to zero again within two seconds by continuing its arc into the following bay. A comfort brake would've been enough.",
#:   "Tell you what gets me, and I've twenty years on the buses. He signals out, he comes out, I give it him, I've even flashed him. And then he doesn't want it! A car's length in my lane, if that, and he's swung in at the kerb again and is switching off. I've three standing passengers on their backs.",
#:   "On the market street everything is moving a little. So I didn't make big eyes when the white van goes from his place into our lane, I only braked. But then he makes the curve to end, he doesn't stay with us even five metres, and puts himself at the border once more, behind the fish, and takes out the boxes.",
#:   "It was a movement like that of a man who rises to greet a lady, sees that it's not she, and sits down in the nearest chair. The police car rose from the kerb into their lane. They had begun to stop for it; and by then it was sitting again, a little farther up the kerb, looking as though it had never risen.",
#:   "Between the moment I shut my eyes and the one I opened them there was no collision, though I'd have bet on it. What I'd seen before shutting them was a parked people carrier that had come right out across my bonnet. And what I saw on opening them was the same people carrier, parked, next to the same pavement, at a different gate.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advKerb", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pull-out", "turn-back"]
#: position = "kerb"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 15.0
#: high = 34.0
#: unit = "m"
#: meaning = "how far the ego still has to go to it when it moves off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.0
#: high = 5.5
#: unit = "m/s"
#: meaning = "how fast it drives"

param OPT_ADV_DISTANCE = Range(15, 34)
param OPT_ADV_SPEED = Range(3, 5.5)

behavior AdvBehavior():
    do Park() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advKerb, 3) for 0.3 seconds
    do DrivePath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(ownLane(egoRoute), self)) < 0.9
    do DrivePath(advKerb, globalParameters.OPT_ADV_SPEED)
