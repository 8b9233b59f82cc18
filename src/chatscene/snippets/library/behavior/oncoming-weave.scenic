#: description = "The oncoming car weaves from side to side as it approaches."
#: rephrasings = [
#:   "A vehicle from ahead swings about its lane toward the ego.",
#:   "The opposing driver slaloms over the centre line and back.",
#:   "The adversary comes on in a wavering course.",
#:   "The approaching motorbike snakes to and fro.",
#:   "Opposing traffic sways erratically and keeps coming.",
#:   "the one coming toward us is swaying all over the road",
#:   "Vehicle 2 approached from the opposite direction on a weaving course.",
#:   "opposing veh, zigzag about its lane",
#:   "There was someone coming the other way snaking all over the place.",
#:   "The approaching vehicle was weaving left and right as it neared Unit 1.",
#:   "Opp. veh zigzag, L-R-L, closing.",
#:   "The oncoming target approaches with repeated alternating lateral deviations.",
#:   "The motorbike comes against me and makes zig-zag all the time.",
#:   "Opposite-direction actor with oscillating path; continuous, doesn't settle; lateral prediction jitters.",
#:   "He came tacking down the road to meet her, first one side, then the other, like a dinghy in a squall.",
#:   "See the headlights coming swinging about? He can't hold a line, keep well over to the edge.",
#:   "the car coming at us was going all squiggly",
#:   "An approaching van wound along the road from edge to edge, alarming drivers.",
#:   "The vehicle bearing toward you swung to one side, then the other, and so on until it reached you?",
#:   "Opposite bus was coming left-right, left-right, I don't know where to go.",
#:   "One's coming at me like he's dodging bullets, this side, that side, take your pick.",
#:   "Oscillating lateral path of approaching opposing vehicle.",
#:   "ONCOMING CAR ALL OVER THE ROAD",
#:   "The oncoming motorcycle slithered from side to side.",
#:   "Oncoming HGV snaking left and right as it nears, exercise caution.",
#:   "Moped from ahead, tipsy-looking, swaying one way then the other.",
#:   "Generate an approaching bus which keeps wandering left and right.",
#:   "El camión comes to me doing \"eses\", all time left, right, left.",
#:   "That car coming at us is wiggling like a worm, Mum!",
#:   "The lorry coming the other way couldn't hold a straight course for two seconds together; it lolled to one edge, then to the other, the whole way up to us.",
#:   "Was he drunk, asleep, or wrestling a wasp, the motorist whom we met swinging his saloon alternately towards the verge and towards the line as he came on?",
#:   "The opposing target follows a sinusoidal path with an amplitude of 0.8 m and a period of 4 s while closing on the subject vehicle.",
#:   "Several motorists phoned in about a coach making its way towards them in a series of lazy curves, first rightward, then leftward, mile after mile.",
#:   "Keep left and keep slow, because the motorbike up there that's heading for us is slaloming, and you can't tell which side he'll be on when we meet.",
#:   "By the time the van had passed me I'd watched it drift over, correct, drift back and correct again so often that I was feeling seasick.",
#:   "Driving home from the nativity play, we noticed the lights of a vehicle in the distance that seemed to be dancing. It turned out to be a pickup coming our way, meandering to the right, then to the left, then to the right again, never once settling, until it had gone by.",
#:   "The opposing actor must not keep to a line. It should come towards the ego while swinging to and fro across its lane in a regular rhythm, at an ordinary speed, and go on doing so all the way. No stopping, please, and no sudden single swerve at us.",
#:   "For the record: I had Vehicle 2 in view for around two hundred metres. During that whole time it was heading in my direction on an undulating line, now near its kerb, now near the centre, and I counted no fewer than five such swings before it drew level with my cab.",
#:   "I'd been on the motorway for nine hours, so at first I blamed my eyes. But no, the artic on the opposite side really was waltzing, its trailer going one way as the cab went the other, and back again, and again, and it waltzed its way right up to me.",
#:   "Comment under the clip: that's not avoiding potholes, that's a fella who's glued to his phone. See how the oncoming car drifts to the line, jerks back, drifts to the kerb, jerks back? He does it on repeat from the moment he's on camera till he goes past the cammer.",
#:   "Truck towards us rolling left, right, left, like a ship.",
#:   "Coach from ahead can't keep straight, swaying the entire way to us.",
#:   "That scooter coming our way is drawing wiggly lines!",
#:   "First it leaned to the verge, then to the paint, then back to the verge, and so the bus made its way up the road to meet us.",
#:   "Lateral trace of the opposing actor: near-sine, period three seconds, amplitude well under a lane, present from first detection until it leaves the field of view behind us.",
#:   "The saloon driver approaching the plaintiff steered now this way and now that, never for long in either, and had not found a straight line when they met.",
#:   "Keep it from being too simple: the lorry we're going to meet should wander about in its lane, over and back, over and back, at everyday speed.",
#:   "I was giving way to a motorbike I hadn't met yet, for its lamp was swinging from side to side like a lantern on a windy quay as it came.",
#:   "Was it her shoes, her phone or her gin that made the woman in the oncoming jeep steer a course like a dog's on a scent?",
#:   "You look for the wheels when someone's coming, that's what I learned on the milk. And the wheels on this van were never still. They'd point at the hedge and I'd relax; they'd point at me and I'd grab the rail; they'd point at the hedge again. I must have relaxed and grabbed six times before he was by.",
#:   "The road is straight there for a mile, and so was everything on it except for one pair of headlamps on the other side. Those described, my passenger said, \"the course of a drunk going home\". By the time they were on us we'd watched them swim to the left and swim to the right more often than either of us cared to count.",
#:   "A load of logs will do that to you if it's not strapped right. I met him on the flat past Inverness. The trailer would shove him over and he'd catch it, and then it would shove him the other way and he'd catch it, and it was still going on when his mirror went past mine. Credit to him, he stayed in his half. Just.",
#:   "From a report on the automated shuttle: \"An opposing motorcycle caused the shuttle to slow repeatedly. The prediction switched between 'will encroach' and 'will not encroach' a total of seven times, in step with the rider's excursions to one side and the other. These continued without a break for the whole approach.\"",
#:   "I'm not saying the coach was drunk. The driver might've been perfectly sober and the road perfectly straight and the steering perfectly well. I'm only saying that as it drew nearer I could see the one side of it, then the other side, then the one side again, and the children in the back window all lolling like seaweed.",
#:   "Señor policía, I made the sign with my lights but he did not wake. He was coming to me in his furgoneta and he went a little to here, a little to there, as one who dances with himself. Each time I thought, now he goes straight. Each time no. I stayed on my edge and I prayed, and he danced past.",
#:   "The old doctor had a theory that a man's gait and his driving are the same. Here, down the avenue towards us, came the curate's car, and it walked as the curate walked after the harvest supper: a few yards to the right, with a correction; a few yards to the left, with a correction; and all at a most reasonable pace.",
#:   "Hazard clip 31. Candidates should respond as soon as the vehicle in the opposing lane begins to oscillate. It doesn't leave its lane in any decisive manner, nor does it stop. The clue is the repeated back-and-forth, first visible at about eighty metres, and getting no less as the distance closes. One click is enough.",
#:   "Spilled my tea all down the dash getting over. There's this fella coming at me in a sleeper cab and I can see his marker lights going tick, tock, tick, tock, across and back across, like a metronome. He kept perfect time as well. Tick, he was on my side of his lane, and, thank God, it was tock when we passed.",
#:   "Visibility excellent, wind nil, that much is agreed. The cyclist puts it down to a soft tyre. What she saw from the towpath was an estate car bearing down on the AV from the front, its bonnet nosing towards the kerb, then the cat's eyes, then the kerb, then the cat's eyes, with never three seconds of plain straight driving.",
#:   "I've a boy of three who steers like that on his pedal car, round one puddle and then round the next. But there wasn't a puddle. This was a grown woman in a people carrier, on her way towards us, and she steered round nothing to the left and nothing to the right, all down the bypass, until we'd met and parted.",
#:   "Oncoming scooter sewing a zigzag down its lane towards us.",
#:   "that truck coming at us is doing slalom with no cones lol",
#:   "Bus inbound, tail wagging: verge, line, verge, line. Keep well in.",
#:   "I couldn't tell you which side of the oncoming van I saw more of, since it showed me its left flank and its right one alternately until it had gone by.",
#:   "Its lamps went from the hedge to the middle and back to the hedge like a man looking for his keys, and all the time they were getting nearer.",
#:   "The AV's prediction for the pickup from the opposite direction changed sides eleven times, which is a fair description of what the pickup itself was doing on its way to us.",
#:   "Opposing vehicle follows a sinusoid about its lane centre with constant forward speed, approaching and passing the subject vehicle without any halt or departure from the pattern.",
#:   "Never mind which way the approaching biker's leaning now, because in a second he'll be leaning the other way, and so on until he's behind you.",
#:   "Let the coach we meet have a drunk's walk: a bit to the left, a bit to the right, over and over, at everyday speed, until it's past.",
#:   "Its washing line of flags told us from far off. They streamed out to the one side, then to the other, and to the one again, though there was no wind, and beneath them the charabanc that wore them was getting on for us at a fair steady trot. I pulled right in. There was no telling which side it'd have its turn on when we met.",
#:   "Like everybody on that bus I was looking out front, and the man with the beard said \"he'll hit the wall\". Then he said \"he'll hit us\". The wall; us; the wall; us; it went on for the length of the bridge. In the end the little lorry passed by without hitting anything, on the beat that belonged to the wall.",
#:   "From a hill you get the pattern of it. I was having my lunch up there. Down on the straight was a grey car going north and a red car going south, and the grey one drew a ruler line. The red one was knitting. In, out, in, out, the same stitch at the same speed, all the way up to the grey car and past it.",
#:   "Q. How can you say that the motorcycle was not under proper control? A. By its headlight, sir. It was coming towards me and it was never where it ought to be next. Q. You mean that it swerved at you? A. No, sir. I mean that it did so, and then the contrary, and then so again, as you would wave a lantern, for a quarter of a mile.",
#:   "The learner wanted to know when to pass him, and I said you don't pass him, he passes you, he's coming at us; you only choose where you'd like to be. Look at him. Line, kerb, line, kerb. He's texting, I'd say. So we want a spot where, whichever half of the swing he's in when he gets here, there's a hand's breadth over.",
#:   "Was glaubt ihr, I have met the drunkest milk truck of Bavaria. It came me opposite and one could hear it before seeing, all the cans fell to the left, cling, then all the cans to the right, clang. Cling, clang, always nearer, normal tempo. I've waited on the bicycle path with my Opel until the last clang was past.",
#:   "For the steering-noise set: an opposing bus with a worn tie rod. Its position in its lane is to oscillate, about eight tenths of a metre either side of the middle, one full swing in three seconds. Longitudinally it's dull, forty all the time, straight through to the end. It's the ego's side clearance that should never be dull.",
#:   "When the rain let up one could read the whole story off the road, because the thing had been dripping oil. The drops came from the south, as the caravan had, and they made a ribbon, beautifully regular, swinging over to the verge and in to the line and over to the verge. At the spot where it had met us the ribbon had just been swinging in.",
#:   "My knuckles are still white. You see, if someone's coming at you on one side, you go to the other. But this estate car had no side. I'd moved over for it, and it'd moved over; I moved back, it'd gone back by itself. It kept swaying like that, the whole way up to me, not fast, and I went by it with my eyes on the ditch.",
#:   "Somewhere on the steppe two vehicles will always meet. Ours was a straight-minded jeep. The other, a speck for a long time, then a lorry with a sleepy Kazakh at the wheel, had the entire earth to be straight on, and yet it approached us as a fish swims, with its whole body, now to this side and now to that. Its driver lifted two fingers as he undulated by.",
#:   "Breaking: Mill Road reopened. Police had closed it after eleven callers in ten minutes described the same cab. They'd all met it, each of them going the other way. \"Bouncing between two invisible walls,\" said one; \"like a dog that's got two smells,\" said another. It held about thirty throughout. The last to meet it was a patrol car.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "weave"]
#: position = "oncoming"
#: place = "road"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_AMPLITUDE"
#: low = 0.8
#: high = 1.4
#: unit = "m"
#: meaning = "how far it swings to either side"
#: [[parameters]]
#: name = "OPT_ADV_PERIOD"
#: low = 2.5
#: high = 4.5
#: unit = "s"
#: meaning = "how long a full swing takes"

param OPT_ADV_SPEED = Range(4, 8)
param OPT_ADV_AMPLITUDE = Range(0.8, 1.4)
param OPT_ADV_PERIOD = Range(2.5, 4.5)

behavior AdvBehavior():
    do WeaveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_AMPLITUDE, globalParameters.OPT_ADV_PERIOD)
