#: description = "The oncoming car overtakes in the ego's lane and swerves back to its own side very late."
#: rephrasings = [
#:   "he's overtaking straight at us and only just tucks back in",
#:   "Vehicle 2 was passing in the oncoming lane and returned abruptly to its own lane ahead of Vehicle 1.",
#:   "opposing overtaker, our lane, cuts back late",
#:   "The target occupies the lane of the VUT while overtaking and steers back at short distance.",
#:   "A motorcycle makes an overtaking in our lane and it returns in the last moment.",
#:   "A biker playing chicken dives back over the centre line at the death.",
#:   "The lorry passing somebody on the far side squeezes back in with a jerk.",
#:   "It stays on our side until the very end, then flicks away.",
#:   "He was overtaking straight at me and only nipped back in when I could count his teeth.",
#:   "Opposing vehicle was passing in Unit 1's lane and swerved back to its own lane just before impact.",
#:   "Truck oncoming, overtakes on our side, cuts back last sec.",
#:   "The opposing vehicle overtakes in the lane of the test vehicle and returns to its own lane at minimal time-to-collision.",
#:   "The bus from the front overtakes on my side and goes back in its lane very late.",
#:   "Opp. overtaker in our lane, jerks back to its own at very low TTC, so near miss.",
#:   "She had made up her mind that they would meet, when at the last gasp he wrenched it in front of the car he had passed.",
#:   "He's overtaking into you, he's cutting it fine, he's cutting it very fine, phew, he's back in.",
#:   "he was overtaking on my side and only swerved back when we were abt to crash",
#:   "An overtaking driver regained his own side with barely a car's length to spare before the oncoming vehicle.",
#:   "You persisted in my client's lane until the last possible instant and only then wrenched your car back.",
#:   "Opposite lorry overtaking in my lane, at the very last moment he cut back to his side, just miss.",
#:   "Overtakes right at me, cool as a cucumber, and chucks it home when I've already got my eyes shut.",
#:   "Belated return of opposing overtaking vehicle from own lane",
#:   "CLOSEST OVERTAKE EVER - swerves home with inches to spare",
#:   "The oncoming van overtakes on our side and ducks home barely in time.",
#:   "Oncoming saloon passes others in our lane, returns at the last gasp.",
#:   "Facing biker, mid-overtake, our side: yanks it home desperately late.",
#:   "He overtakes against me, and only before the crash he jumps back.",
#:   "Head-on overtaking coach ducks into its own lane with nothing to spare.",
#:   "An oncoming overtaker hogs our lane, then darts home, far too late.",
#:   "A tipper from the other direction was getting past a tractor on our half of the road and flung itself back over the line when I'd given up hope.",
#:   "Make the opposing car use the AV's lane for its overtaking, and don't let it swing back to where it belongs until a collision seems certain.",
#:   "The motorcyclist who'd been coming at us in our lane, past a string of cars, jerked back among them with perhaps a bonnet's length left.",
#:   "The opposing target, engaged in passing, remains in the VUT's lane down to a TTC of about 1 s, then steers sharply back to its own side.",
#:   "That fool's passing the caravan straight towards us, there's no room, there's no room, and now he slings it back over, with you already on the verge.",
#:   "What saved me was a twitch of his wheel: he'd been overtaking in my lane, coming at me, and at the eleventh hour he threw the van home.",
#:   "Both of my passengers will confirm it. The bus came round the bend on our side of the line as it was passing a lorry. It kept coming on our side. I could read the destination board when at last its driver wrenched it back in front of the lorry.",
#:   "V2 was southbound in the northbound lane for the purpose of overtaking a slower vehicle. V1 was northbound in that lane. V2 persisted until the vehicles were approximately fifteen metres apart, at which point V2 veered back into the southbound lane. There was no contact between V1 and V2.",
#:   "There is a straight beyond Salas where young men go to prove things. This one came at her in her lane, beside the truck that he wished to have behind him, and he did not fall back, and he did not brake; he whipped in ahead of it with a second left him.",
#:   "Thirty-one years on artics and I've never shut my eyes before. A little red hatchback's overtaking a horsebox, coming the other way, on my side, where I am. I'm flashing, I'm hooting. He leaves it and leaves it, then he flicks back onto his half and he's by my mirror.",
#:   "Please add a near miss to the rural set. The other vehicle comes towards the ego in the ego's lane, since it is out overtaking, and stays there longer than any sane driver would; the swerve to its proper lane happens so late that the ego must have braked already.",
#:   "Oncoming overtaker, our side, leaves swerving home till the last inch.",
#:   "Pickup meets us head-on while passing, flings itself back just in time.",
#:   "bus overtaking in MY lane, dives back with like 2 metres left",
#:   "A tanker was coming at me in my own lane, alongside the tractor it was overtaking, and only swung over to its half when I'd begun to pray.",
#:   "The opposing motorcycle completes its passing manoeuvre in the lane of the VUT and steers abruptly to its own lane shortly before a frontal impact.",
#:   "He's on your side, he's getting past that caravan, he's not going in, he's still not going in, and now, with a yank, he's gone in.",
#:   "Towards us that jeep was coming on our side, overtaking one cycle rickshaw, and when I was closing my eyes he cut to his side.",
#:   "Let the oncoming lorry use our lane for getting ahead of slower traffic and have it wrench itself to its own side far later than is decent.",
#:   "so this genius is overtaking a whole row of cars straight at me and whips back into his lane when i can literally read his air freshener",
#:   "The verge has two ruts in it, and they're ours. We put them there because a coach was coming down our side of the line, passing a horse-drawn cart, and wasn't giving any sign of leaving it. It did leave it; it was slung in ahead of the cart when all that remained was about the length of our own bonnet.",
#:   "My instruments say that there were 0.9 seconds left. For the preceding six the opposing saloon had been in our lane, drawing past a slower van that had the proper lane beside it. In the 0.9 it was steered, with something close to full lock, into the space before that van, and its mirror struck ours.",
#:   "I am asked why I didn't brake sooner. One assumes, Your Honour, that a man who's overtaking towards one will go in when he sees one coming. He could have gone in at two hundred yards; he could have gone in at one; he kept to my lane, beside the lorry, until I could see his tie, and then threw the car to his own side.",
#:   "Unit 2 was westbound in the eastbound lane in the act of passing two vehicles. Unit 1 was eastbound. At a separation which the dash video shows to have been about forty feet Unit 2 swerved into the westbound lane ahead of the second vehicle, and Unit 1, under full braking, continued without contact.",
#:   "I've the window seat on the bus every Thursday and never have I got such a view. It was of the front of another bus. It was on our half of the road because it fancied getting by a combine, and it grew till I could see the driver's moustache; then with a heave that laid it over on its springs it was snatched out of our way.",
#:   "You know that game where the first to turn is the loser? My oncoming friend on the sports bike was playing it with me, and I hadn't been told. There was a string of cars on his side and he was coming past the lot of them on mine. He lost, thank God, by darting in between two of them when my horn had been going for an age.",
#:   "The little girl drew it afterwards for the policeman. Here's our car, here's the slow blue truck on the other side, and here's the naughty one that was next to it and coming at us, on our side, with big eyes. And this squiggly arrow, right by our nose, is where he went quick into his own bit.",
#:   "As lorry man from Poland I see this every week on small roads. A van wants to pass a camion, so he takes my lane and he comes to me. I give light, I give horn, he doesn't go back, he doesn't go back. When I have already the hands before the face he jumps in front of that camion and is away.",
#:   "A late swerve is the last argument of an overtaker. This one had run out of the others: there was no more room to gain on the milk lorry, none to fall back behind it, and in the lane that he'd borrowed from me there was me. He jerked the pickup to his own half, and the wind of it shut my mirror.",
#:   "Robotaxi incident review, frontal near miss. The other party's motorbike was facing us within our lane for the duration of its overtaking of a cyclist group. Our vehicle had stopped altogether, hazards on, and had counted down to one second to impact when the motorbike flicked over to the side of the road on which it should have been all along.",
#:   "For some moments there were two sets of headlamps abreast, and one pair was in our lane. Anybody would have said they couldn't all get by. The wrong pair kept swelling, and I'd my arm across my wife; and then, so near that we heard his tyres, it leapt sideways in front of the other pair, and what went past us was only a shriek.",
#:   "Meeting us mid-overtake on our side, it leaves it, leaves it, darts in.",
#:   "Facing coach, past a tractor, ours till inches, then flung home.",
#:   "Our lane, his overtake, our doom, his last-gasp swerve.",
#:   "All I saw was radiator, in my lane and getting taller, next to the milk tanker it was drawing past; and then, at the very end, a yank and tarmac.",
#:   "Opposing actor overtakes in the ego's lane, facing it; hold there until the gap has fallen to a minimal value, then steer sharply to its own lane.",
#:   "mans overtaking a bus straight at me, i'm flashing, he's not going in, im braking, hes NOT GOING IN, and he whips in so late my mirror's gone",
#:   "On my side only he was overtaking the bullock cart, face to face with me, and when between us nothing was left, one jerk he gave to his own side.",
#:   "My brakes got me stopped for that oncoming motorbike in my lane; what got me home was his twitch in past the van he was overtaking, absurdly late.",
#:   "Had he thrown the pickup back in front of the caravan he was passing one blink later than he did, the two of us would've shared my lane for good.",
#:   "There were two number plates facing us, one above the other, and only the lower belonged where it was. The upper was on a bus; it had come out to get by a dumper truck and it was in our lane. I'd read the letters, I'd read the figures, I'd read the name of the dealer, before bus and plate were hauled over in front of the dumper.",
#:   "I sang. We were going down the one side of the valley and a white van was coming up the same side, ours, because there was a timber lorry on the other that he'd had enough of. I sang for about two hundred yards. I stopped singing when he shot across in front of the timber, and he'd taken my door handle with him.",
#:   "In the time-to-collision plot there are seven seconds of straight descent. It's the opposing saloon, head on, in our lane, alongside a column which it's passing. Five, four, three, no change in its heading. The line ends at 0.8 in a spike, as the saloon's yaw rate goes through the roof and it lands in its own lane before the first of the column; and we'd been braking since five.",
#:   "The bench will have noticed that there isn't a scratch on either vehicle. My client asks for her nerves. The motorcyclist was abreast of the hay cart, which is to say in my client's lane, he was coming towards her, and he had three separate occasions for going back. He availed himself of none. She could see his teeth when he ducked in before the horse.",
#:   "It was an artic, it was on my half, overhauling something with a flashing lamp, and I was in a Fiat. I'd stopped, there was a ditch, I'd the door open. It went over at that, cab first, with a shriek, into its own half ahead of the flashing lamp; and its trailer, following, closed my door for me.",
#:   "Listeners, if it's in your lane, and facing you, and there's a queue of caravans beside it, don't imagine that it'll tuck in when it sees you. Mine had seen me, he was waving. He went on coming till I'd my seat belt off, I don't know why, and then he chucked that cab sideways in between two caravans as if it were nothing.",
#:   "From the top of the coach it was like a board game. There was a slow blue lorry on the far lane and a red car that wanted to be past it, in ours. It was coming at us, square by square. Everyone thought it must go in now, or now. On the last square but one somebody snatched it over in front of the blue.",
#:   "Vehicle 1's black box stored five seconds. In all of these Vehicle 1 is braking, and the driver's explanation is that Vehicle 2, northbound, was using the southbound lane to pass a farm tractor. Vehicle 2's steering trace shows no correction until 0.9 seconds before the closest approach. It then shows ninety degrees to the right, which took it into the northbound lane ahead of the tractor.",
#:   "My godmother has one word for it. A minibus was bearing down on her, in her own lane, side by side with a combine that it had set its heart on passing. She kept straight and slowed and kept straight and stopped. When he'd swerved in ahead of the combine, and he did it under her very chin, she said the word.",
#:   "The radio plays, the road is empty on my side, this is Andalucía. Then on my side there's a truck. He's coming to pass another truck, the two together like a wall. I brake, I go to the stones; the wall comes. When I could already touch it, the half of it which was mine jumped to the other side before its brother, and the radio was still playing.",
#:   "Between the poplars two pairs of lights had been climbing towards her, one pair behind the other. Now they were abreast, and the near pair stood in her own lane. It would fall back; it didn't. It drew ahead, and did not go in. Her wheels had locked, the lights were as broad as a house, and only then did they tear themselves away into the lane that was theirs.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "swerve"]
#: position = "oncoming"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 11.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 8.0
#: high = 26.0
#: unit = "m"
#: meaning = "distance to the ego at which it goes back to its own lane"

param OPT_ADV_SPEED = Range(6, 11)
param OPT_ADV_DISTANCE = Range(8, 26)

behavior AdvBehavior():
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 0.8 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
