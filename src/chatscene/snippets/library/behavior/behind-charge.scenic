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
#:   "Mirror full of grille, foot flat down, no lifting.",
#:   "Emergency vehicle from astern, gaining madly, not scrubbing any speed, over.",
#:   "the golf behind is coming WAY too fast and isnt slowing for anyone",
#:   "Give the follower a lead foot: it should sweep in from far back at twice our speed and treat our tail as though it weren't there.",
#:   "My instructor says a driver who ignores what is ahead is worse than a drunk; the one in our mirror was proving it, gaining speed with every lamp post.",
#:   "Closing rate 18 m/s and rising, measured on the rear lidar; the trailing vehicle showed no deceleration phase in any of the twelve repetitions.",
#:   "A scooter rider had wound his throttle to the stop somewhere back there, and the shrinking gap behind the robotaxi interested him not in the least.",
#:   "What would you have made of it, a police car looming ever quicker in your back window, its driver evidently with no notion of easing up?",
#:   "Vehicle 1 was about to be caught by a pickup whose operator, per the event data recorder, had the accelerator at 100 percent and the brake at zero.",
#:   "We were towing my uncle's boat, so naturally I was watching what was behind. There was a black coupé, a dot at first, and then there wasn't a dot any more, there was a bonnet filling the whole glass. I waited for its nose to dip. It never did.",
#:   "I heard it before I saw it. A motor at the top of its voice, somewhere to our rear, and no change in the note, none, all the while it grew louder. My wife had hold of the door handle and told me to get off the road because he plainly wasn't going to spare us.",
#:   "The statement of Mr Okafor reads as follows: the biker had plenty of distance in which to moderate his pace and used none of it. He was last seen by me in the rear-view camera, flat on the tank, going at a speed I would put at three times my own and still gathering more.",
#:   "Ticket 4410, rear threat. Ego holds 60 in the middle lane. At T minus four the trailing actor gets full pedal and it keeps full pedal right through T zero; any controller that makes it yield to us, match us or back off in the last metres is a fail.",
#:   "Ich fahre mit meine Familie nach Hause, everything is normal, radio plays. Then my son on the back seat says, Papa, the ambulance there wants to eat us. It comes from behind with enormous tempo, and the driver, he takes the foot never from the gas, not one moment.",
#:   "You're doing fine, thirty on the dot. Now have a peep in the centre mirror. Do you see that white hatch? It was by the church a second ago and now it's by the pub, so it's shifting, and the front isn't diving at all. He thinks we'll vanish.",
#:   "Only nine tenths of a second separated our tail from the bonnet of the SUV when the recording stops. At the start of it the distance had been seventy metres, and between those two moments the other driver did nothing except squeeze the right-hand pedal harder.",
#:   "The thing with sirens is you assume they know you're there. This fire engine had the whole road behind our minibus to think about it, but it swelled in the window like a red wall on wheels, quicker and quicker, and the lads in the back row started to shout for me to move.",
#:   "Lorry forum, rear-cam thread: clip three is the best. Forty seconds of nothing. Then a pair of xenon lamps at the horizon, and they go from pinpricks to dinner plates in about four seconds flat. Count the frames, there's no dip, no flicker, nothing to say the bloke saw a trailer.",
#:   "Nobody at the inquest could explain it. The road was dry, the rear lights of the family's car were working, the man was sober; and yet he had driven at their tail with his speed mounting all the time, as a moth goes at a lamp, and the brake pads were found cold.",
#:   "In the second phase of the trial the subject vehicle is threatened from the rear. The chase car starts eighty metres behind, goes to wide-open throttle and uses up the interval without any regard to the subject. Participants are asked afterwards when they first understood that it would not slow for them.",
#:   "Astern of us, a cab at warp speed, brakes never touched.",
#:   "Rear radar: police car, 40 over, zero lift-off, eating our gap.",
#:   "she's right up my exhaust in a blink and STILL hasnt lifted",
#:   "By the time the coffee lid had stopped rolling, the hatchback that used to be a speck in the mirror took up all of it, nose level, engine roaring.",
#:   "Whatever its siren was for, the fire engine at our back behaved as if the lane were vacant, piling on knots the whole length of the bridge.",
#:   "What unnerved the passengers was not that the motorbike to our rear was quick but that, with us plainly in the way, its engine note only rose.",
#:   "The following vehicle shall be released 70 m aft of the AV at wide-open throttle; its longitudinal controller shall contain no term for the AV's presence.",
#:   "Make the saloon at our tail come on like an express train that has no stop at our station, its bonnet level from first to last.",
#:   "My back seat was suddenly lit up as bright as day, brighter every second, by a driver who hadn't the faintest interest in keeping off my bumper.",
#:   "I was changing the radio station, so I know how little time it took. One glance in the glass: a pair of lamps by the water tower. One tune later: no tower, no road, just lamps, and that whine of an engine held at the red line. I put two wheels on the grass, because nobody back there was going to do anything about it.",
#:   "If you watch the rear camera with a stopwatch, the motorcycle halves its distance to us in two seconds and halves it again in one. A rider who meant to stay back would have sat up and let his fork dip at some point. His chin remained on the tank and his wrist remained turned.",
#:   "Claim ref 88-213. The insured was stationary in her thoughts, so she says, though not on the road; she was doing forty. She heard what she took for an aeroplane. It was an Audi, directly to her rear, and in the time left to her she looked for the nose to drop, the lamps to hang back, anything, and there wasn't any of it.",
#:   "The gap to the car at the back had been steady since the roundabout, forty metres or so, and my daughter was making faces at its driver. Then she stopped making faces. The forty metres had become ten and the man was looking down at something in his lap, she said, with his engine bellowing.",
#:   "Ticket: rear TTC alarm does not fire early enough. Reproduce with an ambulance that has been sitting well back in our lane and then gets full pedal. Interval falls from 3.1 s to 0.4 s in a straight line, with the slope getting steeper; there must be no flattening near the end, which is what a considerate follower would give you.",
#:   "We do twenty-five through the village, always have, on account of the ducks. On Friday the windows rattled, and I said to Arthur that's thunder, and Arthur, who had the mirror, said no, that's a young man in a Subaru and he thinks we are not here. I braced my feet. You could tell from the sound that his never left the pedal.",
#:   "In der Ausbildung they tell you: the one from the rear is responsible. Good, but this one on the Yamaha had not heard it. Where before I had empty asphalt in the mirror, I had at once a helmet, and it grew like a balloon that somebody blows, and his brake lever, I could even see the fingers, they were not on it.",
#:   "It was the lad on the tailgate of the removal lorry who saw it first, and he pulled his legs up. A squad car, no lights, no noise but its engine, was covering the ground at our rear so fast that the white lines went under it in one ribbon. He waved both arms. The ribbon didn't get any slower.",
#:   "Put yourself in the place of V1's driver. She cannot go left, she cannot go right, and she notes that the pickup to her rear has used four fifths of the distance in three seconds. The crash data from the pickup give throttle 98, brake switch off, and a speed still climbing in the last sample.",
#:   "I told the learner to ease on to the hard strip and she asked why. Because, I said, the road at our back has a Mercedes in it that's closing by a house length every time you blink, and if he'd been going to ease off on our account he would've done it by the church. Hear that? He's just changed up.",
#:   "\"It filled the back window,\" the boy kept repeating, \"it just filled it.\" His mother had thought the biker far off and sensible. But the buzzing had climbed to a shriek behind their seats and had not once wavered, as one waits for it to waver, and she'd had nothing left to do but take hold of his hand.",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["accelerate", "fast"]
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
