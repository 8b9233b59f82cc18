#: description = "The car ahead takes its foot off the gas and coasts down to a crawl without stopping."
#: rephrasings = [
#:   "The one in front of us lets off the gas and we end up trundling along behind it.",
#:   "Vehicle 2 was observed to lose speed without application of its brakes and continued at walking pace.",
#:   "Lead vehicle lifts throttle, no brake lights, ends up at crawl speed.",
#:   "The target decelerates by engine drag only to a low constant speed in front of the VUT.",
#:   "The driver ahead don't brake, only let it roll, and then goes very slow.",
#:   "A delivery van before us drifts down to a snail's pace and keeps trickling along.",
#:   "The bus we are following sheds its momentum and creeps on from there.",
#:   "Our leader simply runs out of pace and rolls on lazily.",
#:   "The car in front just seemed to lose interest and lost more and more speed till it was barely ticking over, no brake lights or anything.",
#:   "The lead vehicle gradually lost speed, without brake application, to a very slow roll.",
#:   "Lead off throttle, rolling out, no brake lamps, to creep. No stop.",
#:   "The lead target decelerates solely by overrun, without service braking, to a low residual speed.",
#:   "The truck before me gives no gas more and rolls slower and slower, but does not stop.",
#:   "Lead lifts off: gentle decel with no brake lights until it's at ~2 m/s, never zero.",
#:   "Nobody braked; he had merely let it run on until it was hardly moving, and still it kept rolling before her.",
#:   "He's lifted right off, no brake lights to tell you, he's freewheeling down to nothing, so ease up with him.",
#:   "car in front is just.. slowly dying down to like nothing, not even braking",
#:   "The coach ahead shed its speed little by little with no brake lamp lit, until it was hardly moving.",
#:   "His brake lamps never lit, yet his speed ebbed away until he was barely in motion, without ever halting?",
#:   "Front lorry left the accelerator and went slower and slower, no brake, not stopping also.",
#:   "Him in front takes his foot off and lets her run down, no lights to warn you, just slower and slower.",
#:   "Unbraked gradual speed decay of lead vehicle to near-standstill.",
#:   "DRIVER AHEAD FORGETS THE GAS PEDAL EXISTS",
#:   "The truck ahead dwindled to a creep unbraked.",
#:   "Bus ahead just stopped pushing; now it's barely rolling, still moving.",
#:   "Let the leading lorry run out of momentum to creep speed, without ever standing.",
#:   "Tanker in front bled off speed slowly, unlit brake lamps, never quite stopped",
#:   "Grandpa's car before us got slower and slower until it nearly snoozed, but didn't stop.",
#:   "Front cab he only lets it roll, till pedestrian tempo, no standstill.",
#:   "The moped ahead of me shut its throttle, lost way bit by bit and finally dribbled along so slowly that I feared it would topple.",
#:   "From 60 km/h the preceding target reduces speed by engine braking alone until it holds a residual 6 km/h, at which it continues indefinitely.",
#:   "When the fellow in front lifts like that you get no red lights; the distance melts, he's down to a trickle, and yet he keeps on rolling.",
#:   "I request a scene in which the police car leading the ego stops accelerating, loses its way gently and afterwards goes on at a snail's pace.",
#:   "Have you ever watched a coach die in front of you, not braking, merely wilting, down to the speed of a hearse and going on like that?",
#:   "V2, the lead vehicle, was allowed to lose velocity on the overrun, with no service brake used, and then proceeded ahead of V1 at idle speed.",
#:   "I nearly ran into him because there was nothing to warn me. His brake lights stayed dark the whole time, but the van in front was fading away, forty, thirty, fifteen, and in the end it was pottering on at the pace of a milk float.",
#:   "Our follow controller reacts to brake lamps, and here there aren't any. The vehicle ahead releases the accelerator on a level road, drag does the rest, and it settles at roughly two metres per second and keeps moving, so a full stop would be wrong.",
#:   "She supposed he was looking for a house number. His pickup went along ahead of her with less and less conviction, as a ball does that nobody has kicked for a while, until it was only just creeping, and creeping it remained.",
#:   "Dear insurer, the ambulance before me was not on a call. It simply ceased to be driven, if I may put it so, letting its speed leak away along the avenue without any braking until it trundled at the pace of a tired horse.",
#:   "Truckers do this to save diesel, coming up to a red half a mile off. The one I was behind lifted his boot off the pedal and let forty tonnes run itself down till we were doing next to nothing, but he never let it come to rest.",
#:   "Lead pickup lifts, sags to a dribble, brake lights never show.",
#:   "Tail lamps dark, yet that moped ahead's hardly turning its wheels now.",
#:   "is he out of petrol?? rolling slower n slower, never parks it",
#:   "In front of me the tractor unit came off the throttle and was carried along by its own weight until a stroller could have overtaken it.",
#:   "The preceding target releases its accelerator pedal and, no friction brake being applied, its velocity decays to a residual walking speed which it then maintains.",
#:   "The chap we're following has simply stopped giving it any; feel how we're gaining on him, and he's still trickling along, so no need to halt.",
#:   "A patrol car ahead of us let its engine note drop, drifted down through the speeds and thereafter idled onward at the rate of a funeral.",
#:   "Make the leading motorbike shut off, lose pace bit by bit to something like jogging, and keep plodding forward so that it never stands.",
#:   "El coche de delante, he lifts the foot, there is no red light, and little by little he is like a turtle, but always moving.",
#:   "It had been a pleasant run out to the lakes with a caravan-less car in front for once. Then I noticed that I could read its stickers, then the small print on them; the driver wasn't braking, he'd just left off driving, and we were both ambling by the end of it.",
#:   "They'd tell you to watch the brake lights. Watch the gap instead. This lorry in front hasn't shown us a glimmer of red, but he was eighty metres away and he's now twenty, and what's pulling him along at this minute isn't much more than the slope.",
#:   "At the inquest it was asked why the following motorist had been so slow to react. The ambulance before her, said the expert, had decelerated by rolling resistance alone, its lamps unlit, and had gone on creeping forward; at no time did it stand.",
#:   "Dad was singing, so he didn't notice that the taxi in front had got tired. It didn't do the red eyes thing. It got lazier and lazier until I could have kept up on my scooter, and it went on like that the whole way past the park.",
#:   "Our ACC team wanted something gentler than the usual brake test. So the lead car's pedal is released at the trigger point, there's nothing on the CAN bus that says brake, and it bleeds away to about 5 km/h and keeps to that.",
#:   "Out of nowhere I could smell the exhaust of the thing in front, which I hadn't been near enough to do all day. The motorcycle had shut down its gas and was gliding, slower by the second, until its rider had to waggle the bars to stay upright; put a foot down he did not.",
#:   "Whoever was at the wheel of that pickup must have been dozing. The sound of its engine died away first. Its speed went after it, smoothly, the way a swing runs down, and what remained was just enough to keep the tyres turning ahead of us.",
#:   "I've been towing for thirty-five years, and I'd have sworn the low-loader in front of me had lost drive. No stop lamps, no hazard lights; the momentum went out of it between one lamp post and the next dozen, and after that it crept, and I crept with it.",
#:   "Nothing dramatic in the clip, that's why it's good. The distance readout to the lead vehicle falls from forty to eight while its rear lights never change, since the driver's only stopped feeding it, and at the end it's still inching on with us trailing behind.",
#:   "The gentleman before me, he didn't want to arrive, I think so. He took away his shoe from the gas, his Opel rolled out slow, slower, very slow, the brake he never touched, and with the tempo of a wheelchair he went further.",
#:   "A cyclist passed us, which is how we knew. We'd been sitting in the robotaxi behind a furniture van that had quit accelerating somewhere around the church, and it was now down, unbraked, to such a trickle that the girl on the bike rang her bell at it.",
#:   "No red lights, just a bumper coming nearer till we're both dribbling along.",
#:   "Leader's throttle at zero, drag does the rest, residual 6 km/h, never nil.",
#:   "Bike in front has shut the tap and runs on at a toddle.",
#:   "The exhaust of the lorry in front stopped smoking; from then on it only got slower, bit by bit, until we were both doing the speed of a lawnmower.",
#:   "We closed from sixty metres to ten on a saloon whose stop lamps stayed dark throughout, and it was still turning its wheels, just about, when we'd closed.",
#:   "Give the ego a police car to follow which at some point is no longer driven but merely rolls, its pace wearing away to a trickle that never dries up.",
#:   "There wasn't a flicker at his back end, so I had to feel it: he'd come off the pedal, he was running down, and he'd be ambling from here on.",
#:   "Driver 2 said she had released the accelerator on seeing the school sign and let the vehicle roll until it was moving at little more than idle, V1 being behind her.",
#:   "My leader on the moto, he closed the gas, and the wind took from him the speed, spoon after spoon, until we were promenading the one behind the other.",
#:   "It was the flies that told me. At fifty they hit the windscreen; I noticed that they'd begun to walk about on it. I'd been following the furniture van's back doors without a thought, no brake light having asked me for one, and those doors and I had come down together to the pace of a hay wain.",
#:   "Somebody up there had lost interest in the journey. The engine of the car in front, which I'd heard through my open window since the last village, fell to a hum. Nothing lit up. Its lead over us just evaporated, and what was left by the time we had bunched up behind it was a sort of rolling picnic.",
#:   "We plotted range against time: a long shallow curve, flattening out, no corner in it anywhere. A corner would've meant the brake. The lead truck had merely stopped pulling, and the curve flattens because at two metres per second its driver let it tick over and go on like that.",
#:   "Why did I end up so close to the hearse, Father? Because a hearse has brake lights, same as anyone, and I was waiting to see them. They never came on. It slackened as a bell stops ringing, you can't say when, and it was going on ahead of me at the pace of mourners before we'd even got to the church.",
#:   "Your right foot ought to be itching by now. Nobody's braked and nobody's going to, but count the lamp posts, they're going by slower and slower, because the taxi in front has left off feeding it. He'll get down to a crawl and he'll stay at a crawl, so match him; there's no need for the handbrake.",
#:   "When the fuel pump went, said the biker, it was like somebody letting go of your hand. He'd been leading the AV at a fair speed. He drifted, in gear to no purpose, forty, thirty, twenty, not touching a lever lest he wobble; and the last of it, about a jogger's pace, the starter motor gave him, so that he kept rolling.",
#:   "The dispute is about a rear lamp, and both sides agree that it was off. The pickup which preceded the claimant had gone from 60 to something like 7 without it. Engine drag alone, says our expert, and a long slack road. It was still under way, at those 7, when the claimant's bonnet came up to it.",
#:   "You'd never put it in a film. The camera is fixed behind the windscreen, the ambulance is ahead, small; it's a little less small; it fills a third of the picture. Not a thing has flashed. The hedges are hardly moving any more, though they are moving, and they go on doing so until the end of the reel.",
#:   "Going home from market we had a cattle truck before us, and the cows knew. They stopped leaning. There was no jolt, as with a brake, and no red on the tailboard; its speed had been let go of, and it was passing out of the thing like air from a mattress, though never quite all of it.",
#:   "Here's one for the fuel misers' forum. Fella in a Prius in front spots a light a mile off and stops paying for petrol. From then on he's a marble on a carpet. I kept waiting for the brake light so I could hate him properly. He got down to about walking and kept going, and so did I.",
#:   "My grandfather never believes in brake, brake is for wasting. He was in front with his Fiat, I was behind with family. At mango garden he took off the foot. Slowly, slowly, like the fan after current is gone, his car was becoming, no red lamp, and then like bullock it went, but went, did not stand.",
#: ]
#: adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["slow", "follow"]
#: position = "ahead"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -5.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.08
#: high = 0.17
#: unit = "1"
#: meaning = "how strongly the engine drags, as a share of full braking"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.2
#: high = 3.4
#: unit = "m/s"
#: meaning = "how fast it rolls on"

param OPT_ADV_DISTANCE = Range(-5, 30)
param OPT_BRAKE = Range(0.08, 0.17)
param OPT_ADV_SPEED = Range(1.2, 3.4)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
