#: description = "The car cuts into the ego's lane and at once goes back to where it came from."
#: rephrasings = [
#:   "Somebody darts in ahead of us, changes his mind and hops back to his own lane.",
#:   "Vehicle 2 encroached fully on the lane of vehicle 1 and then returned to its original lane.",
#:   "Cut-in aborted: in, then out again to same side.",
#:   "The target enters the path of the VUT and reverts to its initial lane.",
#:   "It comes in, it goes out again, he cannot decide.",
#:   "The truck starts to take our lane, gets honked at and withdraws.",
#:   "A scooter rider swoops across our nose and then peels back out.",
#:   "The indecisive neighbour moves over, thinks better of it and retreats.",
#:   "He nipped into my lane, then changed his mind and popped straight back to his own.",
#:   "Vehicle 2 merged in front of Vehicle 1 and immediately returned to its original lane.",
#:   "Bus into ego lane, instantly back out to own lane. In-out.",
#:   "Target performs a lane change into the VUT's lane followed at once by a return to its initial lane.",
#:   "The truck comes in my lane and at the same moment he goes again to his old lane.",
#:   "Aborted merge: neighbour enters our lane fully, then bails back to where it started; the tracker flips targets twice.",
#:   "He darted in ahead of her and just as quickly thought better of it and slid back to where he'd been.",
#:   "He's in, no, he's out again; can't decide which lane he wants, that biker, just let him go back.",
#:   "he came in my lane for like half a sec then noped out again",
#:   "The van darted in front of the bus and, just as fast, withdrew to the lane it had left.",
#:   "So your client came over into her lane and forthwith withdrew to his own; what was the purpose of that?",
#:   "He came inside my lane and immediately went back to his own lane only, confused fellow.",
#:   "In he comes, out he goes. Make your mind up, mate, which lane d'you want?",
#:   "Momentary incursion into ego lane with immediate withdrawal to lane of origin.",
#:   "CHANGES LANE... NOPE, CHANGES BACK",
#:   "The motorcycle dipped into our lane and ricocheted home.",
#:   "Over into ours, and over into his again, in one breath.",
#:   "Bus joins our lane, un-joins it immediately.",
#:   "Hello goodbye: scooter visits my lane for one second",
#:   "Let the lorry swap into my lane and instantly revert.",
#:   "Has the pickup honestly come across just to leave again?",
#:   "The fire engine slid in front of the robotaxi, saw the lane was no quicker, and in the same movement steered home to its own.",
#:   "Unit 2 transitioned laterally into the path of Unit 1, then without delay transitioned the other way, regaining the lane in which it had been travelling.",
#:   "I want that a motorcycle from the neighbour lane comes before the ego and directly, without staying, changes again to the lane where it was.",
#:   "He was back in his own lane before I'd even lifted off; a moment earlier the hatchback had jumped across in front of me.",
#:   "The artic's tractor and trailer both swung across ahead of us, someone must have yelled at him, and the whole lot swung away whence it came.",
#:   "Two lane changes in quick succession by the same van, the first into the subject vehicle's lane, the second undoing it: that's the test.",
#:   "Dear Sirs, I was proceeding along the dual carriageway when a coach moved over from the nearside lane and put itself before me. It did not remain. No sooner was it in than the driver steered to the left once more and resumed his previous lane.",
#:   "Ticket reopened. The tracker creates a new lead vehicle when the sedan crosses into our lane, which is right, but the sedan bounces straight out to the lane it came from and our ACC goes on braking for it several seconds after it has gone.",
#:   "When I was teaching my nephew, there was this ambulance next to us, no siren or anything. It hops in ahead of him, he panics, and I say relax, look, he's already leaving, because by then its wheel was turned and it was sliding back to its old place.",
#:   "The biker must've spotted a gap in front of my cab and gone for it, then realised there was a tailback further along. He'd hardly got his wheels in my lane before he flicked the bike the other way and rejoined the lane he'd just left.",
#:   "It happened so quick I thought I dreamt it: white van on the left, white van in front, white van on the left again. Took my lane and gave it back in about the time it takes to say so, an my tea was all over the seat.",
#:   "In front of us for one blink, then home again.",
#:   "Scooter swaps into ours, un-swaps, carries on next door.",
#:   "Ambulance steps into our lane, steps straight out, same side.",
#:   "A coach committed itself wholly to the space in front of me and then, with no pause whatever, renounced it for the lane it had just quitted.",
#:   "Make the hatchback take the slot before the ego from the neighbouring lane and directly afterwards give it up again, going home to that lane.",
#:   "The motorcycle made me a visit of one second: in from the left, out to the left, and he continued in his line like before.",
#:   "Lorry on my nearside. It pulls over ahead of me. I lift off. Before the needle's even dropped it has tucked itself away on my nearside again.",
#:   "Radio check, that white pickup has hopped into lane one in front of us, no, cancel, he's returned to lane two where he was.",
#:   "Why would anyone take the trouble of coming in before you if he's going to leave by the door he came through?",
#:   "The claimant's vehicle was being driven in the nearside lane at about 45 mph. The third party's van changed into that lane from the offside one, a car's length in front. The claimant braked and was struck from behind; by the time of that impact the van had already resumed its course in the offside lane.",
#:   "It's the sort of driving that I'd call window shopping. You're bowling along, there's a minicab in the lane beside you, he fancies yours so he comes and has a look, all four wheels of it, and he doesn't like what he sees and goes directly back to his own. Keep calm and keep your gap.",
#:   "I nearly wrote it up as two vehicles. At 14:02:11 there is a bus in the left lane, at :13 there is a bus dead ahead of the AV, at :15 there is a bus in the left lane once more, same fleet number. So one bus, then, that came over and didn't care to stay.",
#:   "Grandpa let me sit up front, so I saw. The big lorry with the cow on it came into our bit of road, whoosh, and Grandpa said a word. And then it didn't want our bit any more and it slid straight back to the bit where it was before. The cow was still smiling.",
#:   "Purpose: to establish that the system under test resumes its set speed promptly. The target performs a full lane change from the adjacent lane into the path of the VUT; upon reaching the lane centre it initiates without dwell a second lane change in the opposite sense, and thereafter remains in the lane of origin.",
#:   "All I can tell you is that I braked for a gap. When I pressed the pedal there was a Nissan filling it, and that Nissan had arrived from my right without so much as a wink. When my pedal reached the floor the gap was empty, and the Nissan was on my right again, driving along like an angel.",
#:   "Traffic was heavy by the stadium and everybody was jockeying. The motorcyclist nipped across the front of our minibus, spotted, I suppose, the brake lights of the whole queue further up, and was out of it in the same breath, back into the very lane he had tried to abandon. My passengers hardly looked up from their phones.",
#:   "German driver's report: I drive with ACC set at 110. From the left track a Kombi pulls in before me, so my ACC brakes. But the Kombi does not remain. As soon as he is in, he steers already to the left and is again on the track from where he came, and I am standing there with 85.",
#:   "Her first thought was that the police car meant to pull her over, for it had slipped out of the lane alongside and planted its stripes in front of her. She had hardly time to feel guilty. Whatever the two men wanted, it wasn't her; the stripes swung away, and there they were alongside as before.",
#:   "dashcam title said \"indecisive artic\" and for once the title wasnt lying. watch the trailer: it crosses the dashes towards the cammer, all of it, tractor too, and then watch it cross the same dashes the other way, no gap between the two at all. comments think his sat nav recalculated",
#:   "Vehicle 1's following distance fell from 31 to 9 metres in no time and was 31 metres again three seconds later. The cause of the dip was Vehicle 2, a fire department SUV, which had entered the lane ahead of it, found that it was not the one for its exit, and instantly reverted to its former one.",
#:   "Van was ours for one second, then next door's again.",
#:   "In front of us, un-in-front of us: that scooter.",
#:   "Bus borrowed our lane and returned it on the spot.",
#:   "My cruise control braked for an ambulance that was already back beside me by the time I'd noticed the braking.",
#:   "Let the pickup take the place before the ego and surrender it in the same breath, so that it drives next to the ego like before.",
#:   "Left mirror, windscreen, left mirror: that is where I saw the same coach within some three seconds, and I had held my lane throughout.",
#:   "As soon as the lorry's trailer had finished coming across in front of us, its tractor was on the way out to the lane they'd both left.",
#:   "hatchback came for a look at our lane evidently didnt like what it saw and was back in its own before i could hoot",
#:   "Did that biker really dive in front of you only to dive out to the very same side?",
#:   "I'd already lifted my hand to swear at him. There'd been a clear forty metres ahead of me, then a Transit's back doors where the forty metres had been, and by the time my hand was up there were forty metres again, and the Transit was trundling along on my right as if butter wouldn't melt.",
#:   "Two blinks of the indicator one way and two the other. Between them the big red fire truck had come over from the lane alongside, sat dead centre in ours for no longer than it takes to say so, and gone back to the lane alongside. My instructor laughed; I'd stalled by then.",
#:   "Finding: ghost lead. ACC target appears at 11 m from the adjacent lane, the AV brakes at 0.4 g, ACC target disappears to the same adjacent lane 1.2 s after it was centred. Video confirms it wasn't a ghost, it was a school bus that joined us and unjoined us. Braking was kept up far too long afterwards.",
#:   "The shadow of the horsebox fell across my bonnet and went off it again. Looking up, I could make out what had cast it: the thing had moved over into my lane from the left, all of it, found perhaps a queue there, and was moving over to the left once more. I never had to do more than lift.",
#:   "If you'd painted his tyres you would have drawn a hump on the road: starting in lane one, up into lane two where we were, no flat bit at the top to speak of, and down into lane one again. He was a courier on a Vespa. Nobody had waved to him and nothing was in either lane.",
#:   "Señor, I don't know what he wanted. The taxi was on my side, he puts himself before me so I must push the brake, and when I am pushing he is not there. He is on my side again, the same side, and looking at me like I am the crazy one.",
#:   "We said goodbye to that coach twice. Once when it slipped over from the next lane in front of us and we thought, well, now we have its backside to look at till Bristol; and once, in the selfsame moment, when the backside slid away to the lane it had come out of. Odd.",
#:   "Oi oi, from the cab of an eighteen-tonner: they do it when they see the sign for the services too early. Car on my nearside nips across my front, all four wheels, so I'm off the gas. \"Not this one,\" you can hear the missus telling him. And he's all four wheels on my nearside again, no harm done.",
#:   "The manoeuvre comprises two lateral movements without dwell. The first brings the target from the adjacent lane to the centre of the VUT's lane ahead of the VUT. The second, initiated the instant the centre is attained, restores the target to the adjacent lane on the same side. The longitudinal speed is not altered by either.",
#:   "Not one witness agrees on which lane the police motorcycle was in, and all of them are right. The flower seller saw it in the outer lane. The claimant braked for it in the inner lane. The boy on the bridge, a second later, had it in the outer lane again. It had, in short, come in and gone straight out.",
#:   "Expected: once the intruder is in, it stays and I follow it. Got: full brake application, an airbag of shopping in the footwell, and then an empty lane before me, with the Nissan that had leapt into it from next door back next door. Would that I had indecision insurance. Nobody touched anybody.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: changing lanes; own code"
#: [slots]
#: actions = ["cut-in", "turn-back"]
#: leader = false
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -10.0
#: high = 25.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = -1.0
#: high = 8.0
#: unit = "m"
#: meaning = "how far its rear is ahead of the ego's front before it moves over"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 7.0
#: unit = "m/s"
#: meaning = "how fast it drives"

param OPT_ADV_DISTANCE = Range(-10, 25)
param OPT_ADV_AHEAD = Range(-1, 8)
param OPT_ADV_SPEED = Range(5, 7)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD + (ego.length + self.length) / 2, 16, 5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(egoRoute, globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 0.8
    do DrivePath(advLane, globalParameters.OPT_ADV_SPEED)
