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
#: ]
#: adversaries = ["car", "truck", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["slow", "follow"]
#: position = "ahead"
#: leader = false
#: blocker = false
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
