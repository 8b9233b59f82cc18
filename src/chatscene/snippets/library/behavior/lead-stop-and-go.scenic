#: description = "The car ahead moves in stop-and-go: it halts, rolls a little, halts again."
#: rephrasings = [
#:   "We're stuck behind somebody who stops, rolls a bit, stops again, like in a jam.",
#:   "Vehicle 2 advanced in short movements with a standstill between them, as in congested traffic.",
#:   "Lead vehicle in queue mode: stop, few metres, stop, few metres.",
#:   "The target alternates between standstill and low speed in front of the VUT, traffic jam profile.",
#:   "The car before us goes and stands, goes and stands, all the time.",
#:   "The bus in front creeps up, pauses, creeps up, pauses.",
#:   "Queueing traffic: the taxi ahead keeps nudging forward and halting.",
#:   "Start, halt, start, halt: our leader concertinas along the lane.",
#:   "the one in front kept stopping and rolling on, stopping and rolling on, like it was rush hour on the M25",
#:   "V2, preceding V1, made repeated stops, advancing only a short distance between each one.",
#:   "Bus ahead: halt - inch fwd - halt - inch fwd.",
#:   "The lead vehicle alternates between standstill and short low-speed movements.",
#:   "The truck in front stands, goes two metres, stands again, all the time so.",
#:   "Jam-style lead profile: v=0, creep a few metres, v=0, repeat.",
#:   "The car before her crept forward, stood, crept again and stood again, and there was no end to it.",
#:   "It's crawl a bit and wait, crawl a bit and wait with this motorbike ahead; keep your foot over the brake.",
#:   "car in front keeps stopping then going like 2 metres then stopping again im so carsick",
#:   "A delivery van advanced by fits and starts, stopping every few yards to its followers' fury",
#:   "It stood, it moved a short way, it stood again, and this repeated itself throughout?",
#:   "Front bus stop, move little bit, stop again, move little bit, give me headache",
#:   "Go a yard, stop. Go a yard, stop. I've burnt my clutch out behind this geezer",
#:   "Intermittent motion of lead vehicle with repeated standstills",
#:   "Car ahead moves 3 metres, STOPS, repeat x10",
#:   "The fire engine ahead hiccuped along from halt to halt.",
#:   "Coach ahead shuffles, stands, shuffles, stands; all morning like this",
#:   "Give the ego a leader that stops, trundles a few feet, stops anew, endlessly.",
#:   "The red car in front goes a teeny bit, then no, then a teeny bit.",
#:   "Front moped again and again stopping, then small small moving.",
#:   "Why won't he make up his mind: stand, roll, stand, roll?",
#:   "The ambulance we were following never got going properly; it would come to rest, advance by the length of a parked car and be at rest again.",
#:   "The lead actor's speed trace should be a comb: zero, a brief bump, zero once more, for as long as the scene lasts.",
#:   "I told the constable that the lorry in front had been lurching on a yard or two at a time, with a dead halt after each of those yards.",
#:   "Follow the van through a jam profile, in which standstills of a couple of seconds alternate with short spells of crawling, and see whether the ACC copes.",
#:   "He halts, you halt; he dribbles on a bit, you dribble on a bit, he halts again, and so it'll go, so don't get bored back here.",
#:   "In front of me the motorcyclist puts his feet down, lifts them for some metres, puts them down, lifts them, always the same music.",
#:   "My left knee is not what it was, and this didn't help. The saloon before me kept coming to rest, then it would roll forward as far as a garden gate, then come to rest once more, and I was on the clutch the entire time.",
#:   "V2 was immediately ahead of V1 in heavy congestion. Witnesses describe its progress as a succession of halts separated by rolls of no more than a few metres, and it was during one of the later halts that contact between bumpers occurred.",
#:   "Comment under the video: I can't watch this without feeling sick. The pickup in front stands still, then it nudges up, stands still, nudges up, stands still, and the robotaxi copies each one of those with a little nod of its nose.",
#:   "Nothing in front of the police car explained it, but the police car itself moved like a caterpillar. It would bunch itself up to a halt, stretch forward a little, and halt; and behind it she did likewise, wondering when it would end.",
#:   "We took forty minutes for the last mile into town. The bus ahead set the rhythm: brakes hiss, nothing moves, it eases on maybe ten feet, brakes hiss again, nothing moves. I know every rivet on the back of that thing by now.",
#:   "Bus ahead: park, shuffle, park, shuffle, and I'm ageing fast.",
#:   "Ambulance in front keeps dying and twitching, never a proper run.",
#:   "gone about nine metres in four goes, thanks to this van in front",
#:   "The motorcyclist ahead would paddle up by a bike's length and plant his boots, and a moment later he'd do precisely the same again.",
#:   "The preceding target cycles between standstill of some seconds' duration and brief displacement at low speed until the end of the run.",
#:   "A tanker was leading our little procession, and its progress consisted of naps with a stagger after each one of them.",
#:   "Give us a school bus in front that can't get going: dead stand, a tiny roll, dead stand, a tiny roll, for as long as the test lasts.",
#:   "The vehicle before me is behaving like a shy bridegroom, he comes two steps and stands, again comes two steps and again stands.",
#:   "Feel that? He's let you move up a yard and he's shut the shop again; that'll be the fourth time for that lorry, and not the last.",
#:   "I finished a whole crossword behind that cab. Its brake lamps would go out, it would amble over a drain cover or two, and they'd come on again and everything would be still for a clue and a half. Out, amble, on. All the way along the seafront.",
#:   "When we studied the log, the range to the vehicle in front looked like a staircase. Every riser was one of its short hops at a couple of metres per second, every tread one of the pauses in which it wasn't moving at all, and there were thirty-one of them.",
#:   "My client followed a fire engine which, there being a marathon on, could only advance in morsels. It would be at rest, it would gain perhaps a car's length and be at rest again; at the seventh such halt he failed to halt with it.",
#:   "The dog was sick at the third stop and I was nearly sick at the tenth. The pickup ahead never got out of first gear; it heaved itself on a bit, it sat, it heaved itself on a bit, it sat, and every time it sat our heads nodded.",
#:   "You know a learner by his clutch leg, and mine's trembling. It isn't his fault, it's the coach we're behind, which has been coming to a stand, easing up to the next lamp post and coming to a stand since we left the test centre.",
#:   "V1 was behind V2 in the approach to the toll plaza. Over the last four minutes before contact V2 had been stationary on at least eleven occasions, and between any two of them it had not advanced farther than its own length.",
#:   "Why is my dash cam clip so dull, you ask? Because the star is a motor scooter. It goes, feet up, for as long as it takes to say go; then feet down. Then go; then feet down. We sat in the back of the robotaxi and made a drinking game of it.",
#:   "The brown lorry in front of her had a painted cow on its tailgate. She watched the cow draw off a little and stop, draw off a little and stop, until it seemed to her that it was grazing its way into town.",
#:   "From our side we've tuned the restart delay to one second, and it makes passengers ill. What the lead vehicle does is simple: full halt, roll on for two or three seconds, full halt, and so forth without end, and each time we copy it too eagerly.",
#:   "Officer, you can't call that driving. The saloon in front came on by a foot and it packed up, came on by a foot and it packed up, as if some child were pulling it along on a string and kept forgetting. It's no wonder that somebody touched somebody.",
#:   "I haul milk, so I feel every one of those. The artic ahead lets its brakes off, psst, we both get ten feet nearer home; psst, brakes on, nobody gets anything. Psst, ten feet. Psst, nothing. By the depot I'd practically made butter.",
#:   "Ten feet, nothing, ten feet, nothing; welcome to life behind this ambulance.",
#:   "Brake lights on, off for a car's length, on. Repeat till dark.",
#:   "Lead scooter's feet: down, up, down, up, down, every few metres.",
#:   "Between the bridge and the church the lorry before us was at a stand fourteen times, and in between it never got beyond a couple of lengths.",
#:   "I knitted half a sleeve: the bus in front would give me a row while it stood, then shift up by a door, then give me another row.",
#:   "The ego shall be led by a car whose motion consists of crawls of two or three seconds, each of them ended by a complete standstill, without limit.",
#:   "Whenever you'd got the lever into first he'd got his brake lamps on again, that coach ahead; a few yards were all it ever let us have.",
#:   "V2, ahead of V1 in the same lane, was repeatedly at rest, its successive advances amounting to no more than a vehicle length on each occasion.",
#:   "The taxi before us breathes like an old man on the stairs: some steps he makes, he stands, some steps, he stands, up to the top.",
#:   "It was the nodding dog that I hated in the end. It sat in the back of the estate ahead of us, and it nodded each time the estate came to a halt and nodded each time it left off halting, which was a door's length later. I must have been nodded at two hundred times before the tunnel.",
#:   "Our bumper sensors beeped like a heart monitor. Beep: the van in front had stopped. Silence: it was creeping on for a couple of seconds and we were allowed to creep as well. Beep. It never got away properly, it never stayed put either, and my passenger asked if we might walk.",
#:   "Would the witness describe the speed of the fire engine? He could not, he said, since it hadn't had one. It had had a place, then after a while another place, three or four yards farther on, then a third; it had been perfectly still at each, and the defendant's car had followed it from place to place.",
#:   "The battery people love this trace. The vehicle ahead takes up its brake, holds it for a second or two, lets go, rolls for two and a half, takes it up again; and since the AV does what its leader does, the current looks like a picket fence, gap and post and gap and post, right across the page.",
#:   "Don't chase him. He'll move off, look, he's moved off, and before you've found the bite he'll be standing there again with his lights on. That's the sixth. He goes as far as the next parked car and not a yard more, so let him have three or four of those and then creep up in one go.",
#:   "My granddaughter sings a song about a snail that stops at every flower. I'd never thought about it until Thursday, behind a motorbike with a sidecar. Its rider had a flower every ten feet. Down went both his boots, up they came for the length of a hedge root or so, and down they went anew.",
#:   "What broke was the tow rope. A breakdown truck has no business towing on such a day, with the truck itself forever coming to a dead stand, giving a heave of a couple of metres and coming to a dead stand; I was behind all this and saw the rope go slack, tight, slack, tight, until it parted.",
#:   "It's tidal. Somewhere up the hill a light changes, and a wave of brake lamps going out comes down to the pickup in front of us. It moves up by its own length. The lamps come back, it stands; then the next wave; and so on for an hour, the robotaxi lapping at its heels.",
#:   "We logged a hundred and six zero crossings of the lead vehicle's speed in one test drive. Taken singly every one is harmless, a gentle stop, then a roll of three metres. The trouble is the hundred and five others, at which our controller shows an ever larger overshoot behind it.",
#:   "Grumble of the day. If the lorry in front just stopped, I could eat my pie. If it just went, I could go home and eat it there. But it's a bite's worth of standing and a crumb's worth of rolling, a bite, a crumb, and I've gravy on my steering wheel and I'm nowhere.",
#:   "In Silk Board junction one can become philosopher. The bus before me was giving darshan: two feet moving, full stop, two feet moving, full stop. I finished phone battery, I finished groundnuts. Conductor got down, drank tea, got in again; the bus was by then only three of these hops farther.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "UN R157 traffic jam; own code"
#: [slots]
#: actions = ["stop", "hesitate", "slow"]
#: position = "ahead"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 2.0
#: high = 28.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.2
#: high = 0.5
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.8
#: high = 2.0
#: unit = "s"
#: meaning = "how long it stands"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.5
#: high = 3.5
#: unit = "m/s"
#: meaning = "how fast it rolls between two halts"

param OPT_ADV_DISTANCE = Range(2, 28)
param OPT_BRAKE = Range(0.2, 0.5)
param OPT_STOP_TIME = Range(0.8, 2)
param OPT_ADV_SPEED = Range(1.5, 3.5)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    while True:
        do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 0.05
        do Halt() for globalParameters.OPT_STOP_TIME seconds
        do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) for 2.5 seconds
