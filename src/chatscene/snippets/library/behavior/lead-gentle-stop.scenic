#: description = "The car ahead slows down gradually, comes to a stop and stands in the lane."
#: rephrasings = [
#:   "The car in front eases off little by little until it isn't moving any more, and then it blocks us.",
#:   "Vehicle 1 reduced its speed smoothly and ended up stationary in the through lane.",
#:   "Lead veh decelerates softly to zero, remains in lane.",
#:   "The target brakes at a comfortable rate to standstill ahead of the VUT.",
#:   "The truck before us is getting slower and slower and at the end it stands.",
#:   "A coach ahead glides to a halt, no drama, and stays put in our way.",
#:   "The motorbike in front rolls out softly and waits there in the middle of the lane.",
#:   "We watch the lead vehicle lose pace bit by bit until it is an obstacle at rest.",
#:   "the car ahead just eased off bit by bit till it wasn't moving at all, and stayed put",
#:   "The vehicle preceding V1 reduced speed gradually, came to a complete stop in the lane and remained there.",
#:   "Truck ahead loses speed smoothly -> v=0, stays in lane.",
#:   "The lead vehicle decelerates mildly (1.5 m/s²) to standstill and remains stationary in the lane.",
#:   "The bus in front goes slower and slower, soft, and then stands and doesn't move more.",
#:   "Lead: comfort-level decel to zero, then hold. No panic stop.",
#:   "Little by little the motorbike in front had lost its pace, until it stood quite still on the road before them.",
#:   "Nice progressive braking from the one in front, all the way to a standstill, and he's not going anywhere, so wait behind.",
#:   "car in front just slowly slowly slowed down and now its just parked in our lane",
#:   "Without any drama, a bus let its speed ebb away and came to stand in the road, holding up followers",
#:   "There was no sharp braking; the vehicle before you simply lost speed by degrees and stood?",
#:   "The car in front reduce slowly slowly, then stop there nicely like his father's road",
#:   "He's tapering off, tapering off, and now we're both sat here going nowhere",
#:   "Gradual lead-vehicle deceleration to standstill; stationary lead in lane",
#:   "Motorbike ahead slows down... and down... and just STAYS there",
#:   "The lorry ahead petered out and stood.",
#:   "Bus in front: losing way, losing way, stationary. Remains in lane.",
#:   "Lead motorbike fades to nothing and plants itself before you.",
#:   "Have the ambulance we follow ease down softly and then simply stand there.",
#:   "Devant nous the truck brakes very soft until zero, and there it rests.",
#:   "The saloon ahead bled off its speed, halted, and has stayed halted.",
#:   "With the gentleness of a chauffeur carrying a bishop, the driver in front took the way off his limousine until it stood, and stand it did.",
#:   "At trigger, the vehicle preceding the ego applies no more than 1 m/s², reaches zero velocity in lane and remains so until the end of the test.",
#:   "There it was, immobile in the lane ahead of the robotaxi, having got there by a long, even, unhurried braking that nobody could have called sudden.",
#:   "When the truck in front of me runs out of diesel it doesn't jerk, it just dwindles, and so it did till it was a roadblock.",
#:   "No harsh pedal from him up ahead, feel how he's squeezing it off. Now his wheels have stopped turning, and we're stopping too, because there he sits.",
#:   "My car was following a police car which became slower by small steps, came to rest in the middle of our lane and did not move again.",
#:   "I had been behind the same coach since the market town. Round about the mill its driver began to brake, only so lightly that I hardly noticed, and he kept that up until the coach stood still in the lane. We were all still sitting behind it ten minutes later.",
#:   "To whom it may concern: the vehicle in front of mine did not stop abruptly, whatever the other side claims. It slackened its pace over a hundred metres or more, became stationary in the carriageway, and was standing there, lights on, when I was struck from the rear.",
#:   "For a baseline ACC check we want nothing dramatic. The lead car cruises, then coasts into mild braking, its velocity trickling down to nothing, and once it has come to rest it occupies the lane for good. Anything with a panic brake, or with a restart, is a different ticket.",
#:   "From up in the cab you see everything early, and I could see the biker ahead of me rolling the throttle off. He drifted down through forty, thirty, twenty, ten, put both boots on the tarmac, and there he was, planted in the lane with half a mile of lorries at his back.",
#:   "The queue was still out of sight when the van preceding the test vehicle began shedding speed, tenderly, the way one sets a cup on a saucer. By the time we reached it there was no motion left in it, and it sat squarely in the lane for the remainder of the recording.",
#:   "Ambulance in front: velvet braking down to zero. Standing. Still standing.",
#:   "The lead coach dies away gently and parks itself across our hopes.",
#:   "Front bike slower, slower, feet down, staying there.",
#:   "No one spilled so much as a drop as the lorry in front coasted softly down to nothing, and there in the lane it has remained.",
#:   "What we were following turned by imperceptible stages from a moving bus into a stationary one, and it was as a stationary one that it blocked us.",
#:   "Target ahead of SV: linear reduction from 50 km/h to 0 over twelve seconds, no steering input, and standstill in lane until manual termination of the run.",
#:   "Let the motorcyclist that leads us lose way as a boat does when the wind drops, come to rest in the lane, and wait there for good.",
#:   "First the police car before us sat at thirty, then it sat at twenty, then at ten, and now it just sits, bang in the lane.",
#:   "The ego must stop behind it because the leading saloon, having eased off with great smoothness, is by then a fixed object in the middle of our lane.",
#:   "You know what a lift feels like just before the ground floor? That was the car ahead. There was no dip, no squeal, only that soft sinking, until I noticed that its wheel nuts had stopped turning. The chap inside unwrapped his lunch. I turned off my own engine and got out mine.",
#:   "When the engine of the truck which I follow gave out, its driver did everything gently. He let it become slow by itself, twenty, fifteen, five, with the hand out of the window to warn me. Then it was standing in our lane and it could not be started again, so we are drinking tea together.",
#:   "I've been asked to explain why my boss's limousine was forty minutes late. We were behind a coach. At some point on the hill the coach began to lose interest. You could hardly call it braking, it was more a kind of fading, and it faded until it wasn't going anywhere. It was in that position when we missed the flight.",
#:   "Don't brake yet. Feel how little you need, since the van ahead's only using a breath of pedal. Keep matching him. Now he's rolled to a halt, no bump, and so have we. He's got his handbrake on, I expect, since his lights have gone out, and he clearly means to occupy that spot.",
#:   "The stop itself was exemplary. V2 was leading V1 by approximately ninety feet when it commenced a light, even deceleration that took it to rest with no deviation from the lane. It was what followed that led to complaint: V2 stood, for reasons unknown, through the arrival of eleven vehicles behind V1 and was standing when police came.",
#:   "Something was missing, thought the boy in the back seat. The trees had slowed and then they had stopped. Between his parents' heads was the rear of the fire engine they'd been trailing for miles. It had gone down and down in pace, so tenderly that his mother had never woken, and now it stood before them like a house.",
#:   "Ticket closed as \"works for me\", reopened by me. The existing lead-stop scene uses 0.6 g, and that isn't what annoys customers. What annoys them is somebody ahead who dwindles from cruising to nil at a tenth of that, so our car keeps creeping up, and who then stays planted in lane, forcing the bypass decision.",
#:   "I'm a poor sleeper, so I often take the first bus, the one that follows the milk lorry. Well, this morning the milk lorry went slower, and we went slower, and the milk lorry went slower still. It was like a lullaby. I opened my eyes at the end because it was so quiet. It stood there, we stood there. Dawn came up.",
#:   "Half the drivers further back thought there had been a crash. There was none, only a motorcyclist at the head of things who, feeling faint, had very sensibly wound his speed down by degrees and brought his machine to a stand where he was. He stayed astride it, in the lane, head on the tank, and we waited in line.",
#:   "Gap to lead 32 m, 30, 29, 29. There's no spike in its acceleration channel, just a shallow slope that begins at second forty and lasts until second fifty-five, when its speed is nil. From second fifty-five to the end of the file nothing about the lead changes at all: same lane, same metre of road.",
#:   "My wife is of the opinion that I fell asleep and ran into a parked lorry. It was not parked. I'd been following it since Crewe. It slackened off ahead of me so gradually that, I admit, I didn't take it in, and by the time I did, the thing had come to a complete rest in my lane and had no plans to leave.",
#:   "Lead van: whisper of brakes, whisper of brakes, statue.",
#:   "bus up front just kinda faded out and now its furniture",
#:   "Fire engine before us gliding down, down, nil. It's staying put. Over.",
#:   "Nothing fell off the back seat, nothing squealed, and still there came a moment when the lorry we'd been behind for miles was no longer going anywhere.",
#:   "The only change in the picture was that the number plate before us grew by a hair each second and, after twenty such seconds, had quit growing, ours and its wheels being at rest alike.",
#:   "Our speed was whatever the motorbike ahead allowed, and it allowed forty, then thirty, then twenty, then, with its rider's boots on the road, none from there on.",
#:   "Lead target: deceleration not above 0.12 g, duration until zero, lane position unchanged; after which it serves as a stationary obstacle for the remainder of the trial.",
#:   "We'd never have been late if the police car in front had merely been slow, but its slowness ended, very softly, in a halt from which it did not stir.",
#:   "Give me a lead car that runs down like a clockwork toy, no drama, and that, once it has run down, is left where it is, in our way.",
#:   "It began with my cruise control murmuring, as it does, that the coach was now doing fifty-one and not fifty-three. I paid no heed. Forty-four, it said, thirty-five, twenty-two, all in the same polite voice. By the end it had nothing to say, since the coach was doing zero, and for the half hour I sat there it had no occasion to speak again.",
#:   "The plaintiff's theory of a sudden stop is contradicted by an egg. The egg lay loose on the shelf above the van's rear doors, in full view of V1, and it was lying there unbroken when the police reached the van, which had by then been at a standstill in the lane before V1 for eleven minutes.",
#:   "Watch the exhaust, not the lamps. He's off the gas, can you tell? It's gone from a plume to a thread. He's not on the brakes to speak of. Now there's no thread, his tyres have a leaf stuck to them that isn't going round any longer, and that's where he lives from now on. So we've a stationary car in our lane.",
#:   "A gap can close without anyone rushing. For the whole of that avenue ours to the truck in front went on closing, a foot here and a foot there, with me lifting and lifting, and it would've closed altogether if I hadn't noticed that the weeds by its mudflaps weren't sliding by. It had come to be parked, you'd say, in the middle of the lane, without anybody parking it.",
#:   "My children have a game of shouting out when they feel the brakes. They never shouted. So light was the foot of the man whose Citroën we were following that he'd brought himself and us from sixty to nothing between two nursery rhymes. Twelve more rhymes were sung behind his bumper, which was not moving then and isn't, for all I know, now.",
#:   "For a complacent follower. The thing ahead sheds its speed so evenly that there's never a moment which calls for action, one metre per second, each second. Then it has none left to shed, and there it sits for good on the centre of the lane. Vary only the vehicle: bus, bike, ambulance. If the ego's jerk exceeds two, it's been late.",
#:   "In our place, when the petrol is finishing, the engine speaks first: puk, puk. The tempo lorry before me spoke so. He was going down little by little, like an old man sitting down, no brake at all, and then he was sitting. Not on one side, full middle. Driver got down, locked it, and went with a can. I also switched off.",
#:   "Strange, how one can be made to stop and not know it. The hearse in front had been our guide since the chapel. Its wheels turned, one could see the chrome wink, at every wink a longer wait for the next; and then one waited, and there was no next. It was some time before my uncle said, from under his hat, that we had arrived nowhere.",
#:   "So the tyre detectives looked for skid marks and found not one. Naturally. The motorcyclist we'd been trailing felt his chain go, and he let her run, hand on the tank, getting slower as kindly as you please, until he had a foot down either side. He stood so in the lane with his hand up to warn us, and it's him you see standing in picture two.",
#:   "In the hall of residence we have a saying, slow like Sunday. On Sunday I am on my bicycle behind a bus. First he's faster than me, then he's the same as me, then I must brake, softly, softly, to not touch him. At last I take one foot off, and the driver his cap off. No bus stop, nothing. He remained standing in our lane, me behind.",
#:   "What the passenger complained of in the AV was boredom. It had followed a street sweeper's lorry, which let its speed trickle away over about a hundred and fifty metres, and had let its own trickle away in sympathy. It had then waited, correctly, at three metres' distance, as the lorry did precisely nothing in the lane ahead for the remainder of the ride.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: lead vehicle decelerating; own code"
#: [slots]
#: actions = ["slow", "stop"]
#: position = "ahead"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 5.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.17
#: high = 0.24
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(5, 30)
param OPT_BRAKE = Range(0.17, 0.24)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
