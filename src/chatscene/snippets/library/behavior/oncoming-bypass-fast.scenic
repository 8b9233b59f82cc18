#: description = "The oncoming car flashes past at high speed while the ego goes around the obstacle."
#: rephrasings = [
#:   "just as we pull out round the thing, somebody comes flying the other way",
#:   "Vehicle 2 approached in the opposing lane at high speed while Vehicle 1 was passing an obstruction.",
#:   "opposing traffic, very fast, while we go round",
#:   "The oncoming target travels at 43 km/h or more in the lane that the VUT has to use.",
#:   "A motorcycle comes the other way with much speed when we avoid the parked car.",
#:   "A biker rockets toward us through the gap.",
#:   "An ambulance from the opposite side bombs along and won't wait for us.",
#:   "Speeding traffic comes on from ahead and does not lift off.",
#:   "I'd pulled out round a skip and some idiot coming the other way went whizzing by at about ninety.",
#:   "Opposing vehicle passed at an excessive rate of speed while Unit 1 was going around the obstruction.",
#:   "MC oncoming, v. fast, zips by during our bypass.",
#:   "During the avoidance of the obstruction the opposing vehicle passes at high speed, without yielding.",
#:   "I go around the standing car and one comes from the front very very quick.",
#:   "Opp. actor at high v while we're out for the bypass; stays in its lane, doesn't slow.",
#:   "She was half round the dustcart when the ambulance streaked by the other way and rocked her on her springs.",
#:   "Don't go out round that van yet, there's one coming the other way like a bat out of hell.",
#:   "im halfway round the parked truck and this dude coming the other way goes by at mach 10",
#:   "A speeding car tore past in the opposite direction just as the motorist was rounding a stationary vehicle.",
#:   "While my client was out beyond the obstruction, the opposing car came through at a furious pace and gave no quarter.",
#:   "I am going around the standing lorry and opposite one bike came in rocket speed and passed.",
#:   "I'm hanging out round a parked bin lorry and Stirling Moss comes the other way and nearly has my mirror.",
#:   "High-velocity passage of opposing vehicle during own avoidance of obstruction",
#:   "NEARLY HEAD-ON while passing parked truck - he did NOT slow down",
#:   "The oncoming motorbike screams by as we skirt the blockage.",
#:   "While we skirt the skip, an oncoming motorcycle howls by.",
#:   "Opposing police car, blues on, hurtles past during our detour.",
#:   "Ego bypasses blockage; opposite-direction traffic comes through extremely fast.",
#:   "Quand je contourne the works, an auto comes opposite at crazy speed.",
#:   "Imagine going round a parked bus as something blasts by, opposite way.",
#:   "We were still out beside the dead lorry when a saloon whose driver had no intention of slowing went by us the other way with a bang of air.",
#:   "Set up an obstacle the AV has to drive around, and at that very time let a car come the other way at great speed.",
#:   "The subject vehicle was passing the roadworks; in the facing lane a motorbike approached and was through at a speed well beyond the limit.",
#:   "Never start round a broken-down van on a hunch: that fire engine was upon us from ahead and gone again at seventy before you'd blinked.",
#:   "Halfway about the fallen tree I felt the whole car shudder because an ambulance coming the opposite way had torn through next to my door.",
#:   "Someone shot by in the other direction at a lunatic pace just as our driverless taxi was making its way around the stranded van.",
#:   "The bin men had left the cart in my half of the street, so I eased out to get by. No sooner was I level with it than a sports car came at me from the far end, flat out in its own lane, and was past with a crack like a whip.",
#:   "During the avoidance manoeuvre of the ego around the stationary object an opposing vehicle traverses the opposing lane under full throttle. It is not to brake, yield or leave its lane; the purpose is to see whether the ego delays or shortens its manoeuvre in view of the closing speed.",
#:   "I was on the pavement with the twins. Their car was going carefully round the hole the water people had dug, and towards it came a motorcyclist, faster than I have ever seen anybody ride on our street. He was past them and away before I could shout.",
#:   "Vehicle 1 was negotiating a disabled trailer that obstructed its lane. Vehicle 2 approached in the opposite direction at a speed estimated by two witnesses at 65 mph in a 30 zone and passed Vehicle 1 without reducing that speed, while Vehicle 1 was still beside the trailer.",
#:   "Every lorry driver knows that feeling: you've committed, you're going round some parked horsebox with your wheels over the middle, and from up ahead there's a pair of headlamps growing like mad. He went by me doing the ton, never feathered it, never flinched.",
#:   "Us round the skip; them, other direction, at warp speed.",
#:   "Ego passing a dead van; opposite motorcycle blasts by.",
#:   "As we skirt the roadworks, a sports car hurtles the other way.",
#:   "We were working our way round a tree surgeon's trailer when something low and red came up the other side of the road and was past us like a shell.",
#:   "Just as my Uber is going around this double-parked truck a cop car comes the opposite way doing easily eighty, our mirrors almost kissed",
#:   "While the VUT is circumventing the stationary obstacle, the opposing target travels past it in the facing lane at a speed far above the limit.",
#:   "Wait till you're round that skip before you relax, there's a motorbike coming up the other way and he's absolutely flying.",
#:   "One lorry was breakdown on road so we are passing him from side, that time one car from opposite came like aeroplane and crossed us.",
#:   "Put something in the ego's lane that it has to steer around, and time it so that an opposing ambulance comes pelting through at top speed just then.",
#:   "It's a wonder I've still got a wing mirror. Somebody had left a boat on a trailer in my lane and I was easing by it. I was half past the thing when two headlights at the far end of the street turned, in no time at all, into a noise and a gust at my elbow, and when I looked round there was nobody there.",
#:   "Subject: near miss at the gas main excavation. The robotaxi had started its avoidance of the barriers and was alongside them. A saloon in the opposite lane approached at upwards of seventy, in its own lane, and swept through without lifting off, passing the robotaxi with a lateral clearance of forty centimetres.",
#:   "I don't think he had seen that we were out there, going round the stranded bus, or else he had and it was all one to him. His motorbike screamed along the lane facing ours. It was a dot, it was a helmet, it was behind us, and our little car was still rocking when we'd got to the front of the bus.",
#:   "The closing speed is the test. Ego at 25 km/h, displaced laterally so as to clear a parked obstacle; opposing actor under full throttle up to its ceiling, in its lane, with no yielding logic. If the ego has begun, it should complete the bypass; if not, it should wait until the actor has gone by.",
#:   "My husband was steering us round the fallen branch as though it were asleep. I screamed, and he says that was the dangerous part. But he hadn't looked up the hill, and I had, and what was coming down the opposite side was an ambulance, going so fast that the siren arrived together with it; it had shot by before he could say a word.",
#:   "V1 had deviated to pass a delivery truck stopped in its lane. V2 was traveling in the opposite direction. Skid-free passage and video timing give a speed for V2 of 71 mph in a 35-mph zone at the moment it cleared V1, which was then alongside the truck.",
#:   "You'd think a hole in the road with cones about it would make a man go gently. It made us, we were creeping round it on tiptoe. The man in the white coupe coming the other way had perhaps no brakes, or no wife, because he went through there so fast that the last three cones fell over in his wind.",
#:   "I go with my lorry around a broken bus, slow, because I need much place. From the front comes a motorbike, I see the light and I think he has still half a kilometre. But no, in two seconds he is at my door and away, he had for sure 150, and my mirror turned itself round.",
#:   "Members of the jury, place yourselves in her seat. A mechanical digger stands in her lane, she goes around it as she must. Into that narrow moment comes the defendant, from the opposite direction, at a velocity which the expert puts at more than twice what is permitted; he was past her, he says, before he had noticed her.",
#:   "Chat log, safety driver: \"all good, going round the bin lorry.\" Four seconds on: \"jeez.\" What happened in the four seconds was a police car, no siren, on the other side of the road, heading against our direction so fast that the radar flagged it as implausible, and by the time I'd typed, it was three hundred metres astern of us.",
#:   "The old lady in the passenger seat said grace. They were out beside the hay wagon, committed to it, with the verge on one hand and the opposing traffic's half on the other; and down that half it came, headlamps blazing, ungovernable, and was gone, like an express through a country station. The hay wagon shed a few straws.",
#:   "Us skirting the bin wagon, a motorbike the other way, pure noise.",
#:   "Out round the skip, and, whoosh, opposite lane, ninety.",
#:   "While we bypass the wreck, an ambulance strafes by from ahead.",
#:   "As I drew out past the broken-down milk float, the far headlights became near headlights became a bang of wind, all in the time it takes to change gear.",
#:   "Ego displaced around a stationary object; at that time the opposing actor traverses its own lane at full throttle up to its set maximum, no yielding, no braking.",
#:   "nearly soiled myself, im next to the parked dumper and this bmw is coming at me in his lane so fast the streetlights were stretching",
#:   "We go around the tree on our half, and from the front comes one with such speed that the leaves fly up, and he's no more there.",
#:   "Going around that dead cow only I was, when from opposite side a police jeep came, and before I could see police it had become a dust cloud behind.",
#:   "You'd think anyone coming the other way would spare a touch of brake for a bus sticking out round some roadworks, but that Porsche was past like artillery.",
#:   "Our passenger was asleep with his head against the glass, and this is what woke him: the glass hitting his head. We were easing round somebody's abandoned van. In the lane to the other side of us, where a moment before there'd been two distant lights, there was now a receding scream; in between, whatever it was had come by us like a bullet and had slapped the car sideways.",
#:   "Give yourself four seconds to get round an obstacle like that trailer, and look for four seconds of empty road. You did look, and there was a dot. What you'd not considered is that a dot can do a hundred and forty; it was a motorbike facing us, in its rights as to lane, and we were still level with the trailer's axle when it blew by your elbow.",
#:   "We recorded one frame of it. The frame before shows cones, the excavator that the ego is going about, and a free opposing lane with a glint at the end. The frame after shows cones, the excavator, and dust. In the one between, a car is smeared over the left-hand third, pointing the other way; at 30 frames a second you may work out its speed.",
#:   "I'd a choir in the minibus, and they can keep time. We'd begun to go around the stuck hay wagon on the first line, and there were headlamps far up the hill on the other half. On the second line the headlamps were beside us with a noise like tearing calico, and by the third they'd become tail lamps, at the bottom of the hill.",
#:   "Witness's seat was on the upper deck and she says she pitied \"the wee car\". It was abreast of a fallen scaffold, its wheels where it'd had to put them. An unmarked police car with its blues on was coming the opposite way. It neither slackened nor moved over, it went through at what she took for a hundred, and the scaffold sheet was sucked off after it.",
#:   "I've done twenty-two years of wide loads and passing stuff is all I do. Here's me creeping by a jack-knifed horsebox, arms out of the window, folding mirrors. Lad on the escort bike says \"one coming\". That's all he'd time for, as the one coming had come. It had stayed on its own bit of road, I'll say that, but it went by me like the hammers of hell.",
#:   "Claim is for one hat. From her balcony my client could see the defendant's red convertible at the top of the avenue, coming down, and a school car at the foot of it rounding an uncovered manhole on its way up. She swears she turned her head no more than once. The convertible was by then past the school car, and the hat went with it.",
#:   "Nothing had been coming. That's to say I'd looked, and nothing was near enough to be called coming, so I told the machine that it might go round the fridge that someone had dropped. Next thing, every alarm it's got. A sports bike was coming up the other lane with the front wheel light from sheer speed, and it had passed us, with the fridge not passed yet.",
#:   "Is it the speed or is it the nearness that frightens one? We'd stopped being near, I'd say, we were well in by the broken-down camper that we were going around, and he'd the whole opposite lane to himself. But he used it as others use a runway, straight at us and by us, with that flat howl, and the children's ice creams, I swear it, bent.",
#:   "In the Sahara you see one hour before who is coming. On this road I go around a lorry with no wheel, and I see from the front an ambulance, small like a fly. I think I've my one hour. But I had two seconds, then she is big, then wind, and my door made boum, and she had not braked for us and she hadn't touched her middle line.",
#:   "The lane beyond the carcass of the burnt car was the only way round it, and she'd edged out until she could see up the road. A star, low down. It grew two horns and a voice; on its own half of the road it bore down upon her, flat out; then the voice dropped by an octave, and it was gone.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "fast"]
#: position = "oncoming"
#: maneuver = "bypass"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 12.0
#: high = 16.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 45.0
#: unit = "m"
#: meaning = "how far before the middle of its way around the ego is when the adversary sets off"

param OPT_ADV_SPEED = Range(12, 16)
param OPT_ADV_DISTANCE = Range(0, 45)

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, 1, 0, globalParameters.OPT_ADV_SPEED)
