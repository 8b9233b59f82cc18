#: description = "The car behind rushes up at high speed and does not slow down for the ego."
#: rephrasings = [
#:   "The car behind comes at us like a missile and never lifts.",
#:   "Vehicle 2 approached from the rear at excessive speed without any evasive action.",
#:   "Rear veh high speed, no brake.",
#:   "The target closes on the VUT from the rear at constant high velocity without reaction.",
#:   "From behind comes a crazy fast one, he don't brake never.",
#:   "An out-of-control lorry thunders down on our back.",
#:   "The bus to our rear keeps going flat out as if we were air.",
#:   "A sleeping driver hurtles up the lane into our boot.",
#:   "Some lunatic came hammering up behind me in the mirror, flat out, and never so much as lifted off.",
#:   "Unit 2, a motorcycle, closed on the rear of V1 at a high rate of speed and made no attempt to slow.",
#:   "RR veh closing v. fast on ego tail; no decel; no lane chg.",
#:   "Target approaches the VUT from the rear with a large speed surplus and applies no braking as the gap closes.",
#:   "A ambulance comes very quick from my back and he does not brake for me.",
#:   "Rear actor ignores us completely: floors it from 80 m back and keeps its foot in right up to our rear bumper.",
#:   "She glanced up and saw the headlights swelling behind her; he was bearing down on her like a freight train and had no thought of easing off.",
#:   "Check your mirror, there's a biker coming up your backside like a rocket and he's not going to lift, so be ready for a shunt.",
#:   "bro this bmw was FLYING at my back end like it didnt even see me lol",
#:   "Motorist recalls terror as speeding car bore down on her from the rear with no sign of slackening.",
#:   "Is it your testimony that the motorcycle closed in from astern at great pace, and that its brake was at no time touched?",
#:   "That car at the back came so fast one, never slow down also, I thought sure bang already.",
#:   "So I look in the mirror and there's some hothead steaming up my backside, doesn't care a jot that I'm there.",
#:   "Rapid unchecked approach of following vehicle toward ego rear; no deceleration.",
#:   "SPEEDING CAR FILLS REAR CAMERA IN 2 SECONDS - NEVER LIFTS!!",
#:   "A motorbike torpedoed toward our tail.",
#:   "Ambulance gaining on you from astern, full chat, not backing off, over.",
#:   "Can we have a motorbike storm up on our rear without ever checking its speed?",
#:   "Grandad, the man behind is whooshing at us and he isn't braking!",
#:   "Saloon, coming from the back with 100, foot stays on the gas",
#:   "Overspeed follower; closing; brake lamps stay dark throughout.",
#:   "I was pottering home from chapel when I noticed a pair of headlamps growing ever so large in my mirror, and dear me, they didn't slow one bit.",
#:   "I want a scene in which the hatchback at our rear piles on the speed and keeps piling it on, as if the road ahead of it were empty.",
#:   "According to the dash-cam, the gap to the trailing coupé was eaten up within three seconds, because its driver kept the throttle pinned and did nothing about the car before him.",
#:   "When the robotaxi's rear radar flagged it, the police car was already doing double our speed; at no moment did it moderate its pace on our account.",
#:   "Im Rückspiegel, how you say, in the mirror I see a car that shoots nearer and nearer, and the driver makes nothing to become slower.",
#:   "Test 14: following vehicle gains on the subject vehicle under heavy acceleration and holds the throttle open regardless of the remaining distance.",
#:   "I drive forty-four tonnes, so I don't get rattled easily. But last night on the dual carriageway a motorbike came screaming up towards my trailer doors as though it had a rocket strapped to it, and the fella on it wasn't shutting the throttle for me or for anybody.",
#:   "The complainant states that she was proceeding at the limit along Marine Parade when she became aware of a loud engine. A silver estate was overhauling her from the rear at something like twice her pace, and she saw no dip of the bonnet, nothing that would suggest its driver meant to ease up.",
#:   "So on the podcast today, a listener's story. She's in the left lane, sunny day, minding her business, and a fire engine comes barrelling up from way back there, and the thing about it is it just keeps coming at that same mad rate, like her little Fiat wasn't there at all.",
#:   "For the rear-threat scenario let the follower hang back at first, then pour on power and close on the AV at a velocity far above ours. It must not respond to us in any way: no lift-off, no braking, as if the person at the wheel had nodded off.",
#:   "My instructor told me to glance at the mirror every few seconds, and that's how I caught it. Some lad in a hot hatch was eating up the road at my back, and instead of easing to match my learner's pace he only got quicker.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["accelerate", "fast"]
#: leader = false
#: position = "behind"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -12.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.8
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 12.5
#: high = 16.0
#: unit = "m/s"
#: meaning = "how fast it drives"

param OPT_ADV_DISTANCE = Range(-12, 20)
param OPT_THROTTLE = Range(0.8, 1)
param OPT_ADV_SPEED = Range(12.5, 16)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE, 0, globalParameters.OPT_ADV_SPEED)
