#: description = "The rider ahead swings out slowly round something on the road and back into line."
#: rephrasings = [
#:   "The cyclist in front jinks round a pothole and back.",
#:   "The bicyclist swerved to avoid debris and then returned to the original line of travel.",
#:   "bike ahead swerves round pothole, then straight on",
#:   "The target ahead performs a single evasive lateral displacement and resumes its line.",
#:   "The cyclist before us goes around a hole in the street and comes back.",
#:   "To dodge a car door, the biker up ahead ducks out and in again.",
#:   "The scooter veers aside for a pigeon and then keeps straight.",
#:   "Around the manhole cover and back on course goes the rider we follow.",
#:   "The cyclist in front drifted out round a drain cover, nice and leisurely, and came back in.",
#:   "The bicyclist ahead moved left gradually to avoid an object and then returned to his prior position.",
#:   "Bike ahead eases out round pothole, back to edge.",
#:   "The leading two-wheeler deviates laterally at low speed around an object and resumes its line.",
#:   "The bicycle before me goes slow around a hole and comes back.",
#:   "Lead rider makes a gentle lateral detour at low speed, no braking, no fall.",
#:   "He went round the puddle in no hurry at all, out and in again, with the whole street waiting on him.",
#:   "Moped up front's going out to get round that manhole, hold back, he'll come in again.",
#:   "bike ahead went around smth real slow then back to where he was",
#:   "The cyclist moved unhurriedly around an obstruction and resumed her course.",
#:   "He gave the object a berth, gently, and fell back into his former line.",
#:   "Cycle in front went little outside to avoid the manhole, slowly, then came back in line.",
#:   "Takes a lazy loop round a puddle, God forbid he gets his socks wet, then back in.",
#:   "Gradual lateral excursion of preceding two-wheeler around object with return to line",
#:   "CYCLIST TAKES THE SCENIC ROUTE ROUND A POTHOLE",
#:   "The scooter in front arcs lazily round something and rejoins its line.",
#:   "Bike ahead wanders gently round a branch, then falls into line.",
#:   "moped infront gives a dead badger wide berth all unhurried then tucks in",
#:   "Have the rider we follow skirt a puddle slowly and line up again.",
#:   "Lead cyclist: slow bulge outward past grating, returns to former track.",
#:   "She bikes so slow around the broken glass and back again, Mummy.",
#:   "In front of us a scooter left its line at hardly more than a trot, went about a sack in the road and resumed its old one.",
#:   "At low speed, the two-wheeled target preceding the VUT performs a lateral excursion to clear an object on the surface and regains its initial path.",
#:   "There's a sunken manhole coming up, so the cyclist in front will move out for it, take her sweet time, and settle back afterwards. Sit tight.",
#:   "The man with the bicycle before my car has made a small, slow arc because of a stone and then was again where he rode before.",
#:   "Did the motorcyclist ahead pull out for good? No, he pottered round a fallen exhaust pipe and, once past it, slipped back to his old position.",
#:   "Something lay by the kerb, a mattress perhaps; the rider ahead of the AV edged outward to clear it at a crawl, then regained his line.",
#:   "I'd been following this old boy on his sit-up-and-beg for a while. There was a big wet patch, leaves and whatnot, and he steered out round it with the dignity of an ocean liner, hardly turning the pedals, then steered in again the same way. I just waited.",
#:   "Vehicle 2, a motor scooter, was preceding Vehicle 1 near the edge of the lane. Its rider noticed roadkill and, without any abrupt movement, took the scooter outward around it at perhaps 10 km/h. Having cleared it he brought the scooter back to his original distance from the kerb.",
#:   "Proposed test: leading cyclist detours round debris. Lateral offset grows smoothly to about one and a half metres, stays for a couple of seconds and returns to zero; speed is low throughout. Please check that ego neither squeezes past on the outside in the meantime nor treats this as a turn.",
#:   "I cycle, so I'll tell you why we do it. There's a drain with slots the size of a tyre. Ahead of the red car a girl saw it in good time, and she bore out little by little, rolled by it at a snail's pace, and bore in to her line.",
#:   "From the lorry you look down on everything. The fellow on the moped in front had spied some planks; out he swung, ever so lazy, like a man stepping round a sleeping dog, then in he swung, and he puttered on along the same strip of road he'd been on before.",
#:   "Scooter in front drifts out round a bin bag, drifts home again.",
#:   "Let the cyclist ahead steer gently about a puddle and resume her line.",
#:   "bike infront ambles round dead fox then back to the edge",
#:   "At little more than a trot the moped we followed bore out past a sunken grating, and once it was behind him he bore in to where he'd been.",
#:   "The preceding two-wheeler makes a single low-speed detour round a surface object, lateral offset returning to zero afterwards, and rides on along its former path.",
#:   "My pupil wanted to pass, and I said no: he's going out for that pothole, he's past it, he's back in, all in his own good time.",
#:   "The señora on the bicycle before me made slowly a small half moon because there was glass in the floor, and after it she was again at her border.",
#:   "Did the motorcyclist whom you were following not go round the fallen branch with perfect calm and regain, beyond it, the line he had been holding?",
#:   "A lump of tarmac on the road, and the fellow in front on his bike went round about it, easy-easy, then same place as earlier he came.",
#:   "The hedge-cutters had been along, and there were thorns. I was behind a schoolteacher on her bicycle, and I saw her look down, and then the bicycle stole outward by the width of a door. It rolled past the thorns barely faster than they did. When there were no more of them it stole in again, and so to school.",
#:   "V1 was following V2, a bicycle, at approximately 9 mph. V2 moved left by about four feet to clear a storm drain with a missing cover. The movement was gradual and V2's speed low throughout. Beyond the drain V2 returned to its former position near the curb and continued.",
#:   "A sofa cushion had come off somebody's van. The scooter in front, a pizza boy, didn't do anything silly. He just sort of leaned out round it, taking for ever, I could've read the menu on his box, and leaned in when it was behind him, same bit of road as before, and we all followed like ducklings.",
#:   "Test sheet \"detour\", lead bicycle. Object: cardboard on the lane, small. Rider leaves its line with a smooth arc at low speed, holds the offset until the object is passed, and comes back with a like arc. The ego should keep behind, as the room which opens on the inside is going to close again.",
#:   "Dashcam viewers, be fair. Yes, she takes her time. There's a manhole that's sunk a good four inches, so first she goes wide of it, at the speed of a person carrying soup; after that she's in by the kerb again, precisely as she was. He was held up by five seconds and he wrote a song about it.",
#:   "The tyre track of the bicycle is visible in the fresh gritting. It runs a metre from the gutter, bulges outward to avoid the dead badger, and a few yards on runs a metre from the gutter again. From the spacing of the pedal drips, as it were, the constable took the pace to be very moderate.",
#:   "He rode as he did everything, my grandfather, without haste and without explanation. I was behind him in the van. The shape of a puddle presented itself; he considered it from afar; he departed from his line to leave it on one side, and, having done it that courtesy, returned to his line and to his thoughts.",
#:   "I drive a concrete mixer and I can't stop for fun. So I watch. Motorbike before me, one of those big comfy ones, he's seen the diesel spill. He doesn't brake, he doesn't flinch; he floats out round the edge of it at a jogging pace and floats back to where he'd come from. Textbook.",
#:   "If you only look at the end you'd think nothing occurred, for the rider in front was on exactly the same strip as at the start. In the middle, though, she'd been a metre and a half farther out. There was a plank, she went round it, dead slow, and I, in the robotaxi, spilled not a drop.",
#:   "What the child in the car ahead of me shouted was \"He's going round the hedgehog!\" And he was. The man on the electric bike in front of them had throttled right down, and he carried himself in a soft bow past a hedgehog that wasn't in any hurry either. He then took up his old place at the side.",
#:   "Sir, the two-wheeler ahead was going straight at side of lane. Cow dung was there, so he took a turn out, not sharp, very slow and smooth. When dung was finished he again came into same line. I only waited behind him; it is my boss in the back seat that was shouting.",
#:   "Cyclist up front dawdles out past a drain, then in again.",
#:   "Moped ahead: lazy detour round a brick, same line after.",
#:   "front bike drifts round roadkill all slow, tucks back",
#:   "Between his wheel and the gutter there was a yard, then, alongside the sunken grating, two yards, then a yard as before, and he'd taken his time over it all.",
#:   "Some lettuces had fallen off a van; the scooter leading us went by them on the outer side at a leisurely pace and resumed the track it'd been on.",
#:   "The gentleman before you is going to want more room, there's a hole, see, wait for it, he's out, he's round, he's home, and nobody was rushed.",
#:   "A two-wheeled lead target shall leave its line so as to clear a surface defect, at reduced speed and without abrupt steering, and shall rejoin that line beyond it.",
#:   "I need the motorbike in front to amble out around a lost hubcap and in again to where it was, nothing jerky, so that the AV must wait a bit.",
#:   "The boy on the BMX preceding us took a slow bow-shaped way about a dead pigeon, as one walks about a sleeping dog, and was afterwards where he had been.",
#:   "What I noticed was water on my windscreen, then none, then water. There was a burst hydrant pipe on the road, and the moped that was leading me had no wish to ride over it. So for a little it dripped on me from farther out, at a gentle trot, and once the pipe was behind it, from the same spot as ever.",
#:   "My foot was over the pedal in case of a surprise, but surprise isn't a word I'd use of Mr Higgins and his tricycle, well, bicycle. He'd seen the ladder on the road long before I'd seen him. He described a fat, unhurried comma round it, and I saw the back of his cap return to the kerbside, ahead of me.",
#:   "No signal came from the rider, and no need. The eye went to the bag of cement that was lying in his way. Cement on the road plus a chap on a Vespa in front of you equals: he'll be further out in a moment, slowly, and he will be further in when that moment's passed. It was so. I stayed where I was till then.",
#:   "In plan view the lead bicycle's track is a straight line with one bump in it, two metres wide and some fifteen long, and what the bump goes round is a bin bag. Speed through the bump: three metres a second. On either side of it the distance from the kerb is the same to within a hand. The ego asked for a pass at the top of it.",
#:   "We all learned something. A learner learned that you don't overtake a motorcycle where there's gravel in a heap. I'd told her to hang back, and she saw why. It didn't dart or stop; it strayed out, at its ease, into precisely the bit of air that she'd wanted, skirted the heap, and strayed in again with one finger lifted to us.",
#:   "If that branch hadn't been there I'd have gone by her on Mill Bank and been on time. I could not. My bonnet would've met the back wheel of her bike as it floated outward past the twigs. It then floated inward, no quicker, and by then we were at the narrow bridge. I am not cross. I just mention it to the school.",
#:   "It's a common error of anticipation to believe the cyclist ahead is turning off. He isn't, he's got a reason lying on the asphalt: a glove, a plank, a puddle. This rider's was a car tyre. He leaned out past it at little more than a jog, and when he'd left it behind him, his wheel was again a metre from the edge.",
#:   "I followed the postie's motorbike because there was room for one in that lane and he was it. Somebody had dropped an oven, an oven! I said to the wife, \"Now then.\" He throttled down, out he leant, wide and slow, and we got the oven in full view. By the time it was level with our own bumper he'd his old furrow again.",
#:   "The leaves lay, one wet brown heap, a metre out of the kerb. For one who rides on two wheels this is like soap. So the lady on the holland bicycle, which was before me, has made with calm a curve about the heap, I behind it with calm too, and where the heap was at end she was also at her edge again.",
#:   "Clip description: twenty seconds of nothing, really, posted because of the guy in the comments who says cyclists never think. Rider ahead sees a smashed bottle. Doesn't swerve. Checks over the shoulder, eases off, takes a big soft half-moon out past the glass, and slots in again exactly where they'd been. We follow. The end.",
#:   "The dark patch he'd been making for was, he knew from yesterday, deep enough to lose a wheel in. So the paper boy, with our headlights on his back, laid his course outside of it, in no hurry, let it go by on his one hand like an island, and came home to the same pale strip beside the kerb. I had the horn under my thumb, and left it there.",
#: ]
#: adversaries = ["bicycle", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["swerve", "slow"]
#: position = "ahead"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.2
#: high = 2.6
#: unit = "m/s"
#: meaning = "how fast it rides"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 18.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.1
#: high = 1.8
#: unit = "m"
#: meaning = "how far it swings out to the left"
#: [[parameters]]
#: name = "OPT_ADV_TIME"
#: low = 2.5
#: high = 4.0
#: unit = "s"
#: meaning = "how long it stays out"

param OPT_ADV_SPEED = Range(1.2, 2.6)
param OPT_ADV_DISTANCE = Range(0, 18)
param OPT_SWERVE = Range(1.1, 1.8)
param OPT_ADV_TIME = Range(2.5, 4)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego, 4) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do SwerveOnPath(advTrajectory, globalParameters.OPT_ADV_SPEED, globalParameters.OPT_SWERVE) for globalParameters.OPT_ADV_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
