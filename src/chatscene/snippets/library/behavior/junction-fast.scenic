#: description = "The car tears through the intersection at high speed."
#: rephrasings = [
#:   "some lunatic flies through the crossing doing eighty",
#:   "Vehicle 2 entered the intersection at a speed well in excess of the limit.",
#:   "very fast through the crossing, doesn't yield",
#:   "The target traverses the junction on a conflicting path at 45 km/h or more.",
#:   "A motorcycle comes like a rocket over the crossing and nobody can stop in time.",
#:   "A biker streaks across the crossroads.",
#:   "An ambulance hurtles over the junction.",
#:   "Going far too fast, the other driver whips past in front of the ego.",
#:   "some maniac went through the crossroads like a bat out of hell",
#:   "The suspect vehicle traversed the intersection at an estimated 70 mph.",
#:   "Ambulance: blasts thru jct at v. high spd.",
#:   "The target passes straight through the junction at excessive speed.",
#:   "The motorbike goes over the crossing with very much speed, like a rocket.",
#:   "High-velocity crosser: NPC takes the junction at way over limit, no decel.",
#:   "It had gone by before she could say what it was, a red streak hurtling over the crossing.",
#:   "All units, the bike's just blown over the crossroads doing eighty, he's flying.",
#:   "that bike went thru the crossroads at like mach 2",
#:   "Residents called for cameras after a sports car shot over the junction at breakneck speed",
#:   "Would you agree that ninety is rather more than the junction permits, Mr Shaw? You flew over it.",
#:   "That Lamborghini whoosh only through the junction, siao ah, so fast",
#:   "Couldn't tell you what colour it was, went over the crossroads like a dose of salts",
#:   "Excessive-speed traverse of the intersection by crossing traffic",
#:   "LUNATIC screams through intersection at 120 km/h",
#:   "The ambulance rocketed through the crossroads.",
#:   "Something silver tore over the crossroads like a cruise missile.",
#:   "Have a motorbike belt over the crossroads, full chat.",
#:   "V2 took the junction at more than twice the limit.",
#:   "He thundered across the junction as if it were a runway.",
#:   "Ambulance going hell for leather through the intersection, no lifting.",
#:   "The saloon came through the crossing with such a velocity that my passenger only felt the wind and asked me what it had been.",
#:   "Simulate a crossing hatchback whose speed in the intersection is eighty kilometres per hour or above, held without any deceleration.",
#:   "Never assume they'll slow for the junction, Priya; that biker bombed through there as though the side roads didn't exist.",
#:   "\"It was like a plane taking off,\" said the florist, who saw the sports car zip over the crossroads outside her shop.",
#:   "Is it your evidence that the police car was through the intersection in well under a second, travelling at a quite furious rate?",
#:   "mate the crossroads by the chippy, some golf just went straight thru it absolutely caning it, must of been doing 90",
#:   "I have driven that way for forty years and never saw the like. A red car burst out from behind the hedge and was over the junction and gone before I could lift my foot from the pedal.",
#:   "Data from the event recorder put V2 at 71 mph as it entered the intersection and 73 mph as it left. Its driver, 19, told officers he was late for his shift and hadn't noticed the crossroad.",
#:   "She heard it before she saw it, a rising whine from behind the houses. Then the motorcycle was in the crossroads and out of it again, all in one breath, leaving a smell of petrol and a dog barking.",
#:   "The fire truck, it was in a big hurry, I understand this. But he passed the crossing with a speed like on the Autobahn, and our automatic car had nearly no time for seeing him.",
#:   "For the next run, set up crossing traffic that doesn't respect anything. One car, coming at a right angle, goes pedal to the metal over the junction, and the AV should spot early how quickly it is arriving.",
#:   "A blur, a bang of air, and it had shot the crossroads.",
#:   "Flat out over the crossing, that ambulance. Never lifted.",
#:   "Bike. Junction. Ton-up. Gone before you'd blink.",
#:   "The crossing car's dwell time in the intersection came to 0.4 s, which for a box of twelve metres means well over a hundred km/h.",
#:   "I'd like the junction to be traversed by a hot hatch at a speed that leaves the ego a second at most to react.",
#:   "With full gas the motorcycle has flown over the crossing, my God, if I am there one second before I'm dead.",
#:   "Old Harry reckons the thing that went by the end of his nose at the crossroads was a Jaguar, but it could have been a jet.",
#:   "Witnesses heard the engine a long way off; none of them heard it back off before, in, or after the intersection.",
#:   "Why do they build a speed camera out of town, when people are whipping over our crossroads at double the limit, past the nursery gate?",
#:   "Leaves were still spinning in the air over the junction when we got there. The thing that had stirred them up was by then three streets off, and you could just hear it: some young man's coupé, which had come over from the left like something fired out of a gun.",
#:   "I had one wheel over the line when the noise reached me, so I grabbed both brakes. It's a good thing I did. A fire engine, no, the little one, the first responder, came storming over the crossroads at such a lick that its draught nearly took me off my bicycle.",
#:   "Rate of knots doesn't begin to describe it. We'd been chatting about football, my fare and me, rolling up to the four-way at a gentle thirty, and this motorbike goes from one side of my windscreen to the other before either of us could get the word \"watch\" out.",
#:   "The reconstruction is based upon two doorbell cameras, seventy metres apart on either side of the junction. V2 passes the first at 16:02:11.3 and the second at 16:02:13.1. That is 139 km/h. There's no tyre mark, nor any drop in pitch, to suggest that its driver thought about the cross street at all.",
#:   "You see that hedge, there on the corner? You can't look through it. So we creep, and we listen, and when we hear a howl like that one we stay put. There, did you see it? Police car, a hundred plus, right over the crossroads. Anyone who'd nosed out would have been scrap.",
#:   "We didn't hit it, or it would be a shorter story. The shuttle braked so hard that my knitting landed in the driver's seat, where there isn't a driver, of course. Before the front window there went something low and orange, at a velocity my late husband would have called criminal, and then the crossing was empty again.",
#:   "The time budget is what I'm interested in. With the crosser at fifty we have two and a half seconds from first sight to conflict; please run it at a hundred and twenty so that we have one. It doesn't slow, doesn't turn, doesn't care. Any car model will do, sports ones look better in the demo.",
#:   "In my village everyone knows the sound of the Ducati from the baker's son. On Sunday he made the crossing again like on a racecourse. I was coming from the church side in my small car, and I tell you that between hearing him on the left and hearing him on the right was nothing.",
#:   "It began as a whine beyond the houses. Then the junction before her seemed to tear from end to end like a sheet, something dark was there and was not there, and a newspaper rose from the gutter and came down on her bonnet. \"What was that?\" said the boy. \"A Porsche,\" she said, \"I think.\"",
#:   "I stop short of calling my client's neighbour a murderer, your honour. But we've heard that the limit at that intersection is thirty, that his vehicle was going at seventy-nine as it went over, and that the defendant's explanation was: \"It was late, I didn't think anyone would be about.\"",
#:   "tbh the robotaxi saved my bacon. i was about to look up from the phone n it just STOPPED and then this blue thing goes vwoooom over the crossing, proper motorway speed, right where we wouldve been. ordered a coffee to calm down",
#:   "Blink and you'd have missed it, crossing at a ton.",
#:   "Like a bullet, that bike, clean over our junction.",
#:   "Something low and loud crossed at racing pace.",
#:   "Ninety in a thirty, and straight over the crossroads with it, that's what the tachometer in the wreckage of the sports car was stuck at.",
#:   "I would like the conflicting vehicle to be over the intersection and away in well below half a second, its throttle wide open.",
#:   "My ears popped when the police motorcycle went over the crossing in front of us; the speed of it was simply indecent for a village.",
#:   "Between one swish of the wipers and the next the junction had been empty, then full of a white coupé, then empty.",
#:   "Because that ambulance was on the crossroads at a hundred and ten and not at forty, there was no question of my finishing the thought, let alone braking late.",
#:   "He's passing the crossing like the devil is behind, no foot from the gas, you have only the wind and the smell after.",
#:   "When I stepped off the brake there was nothing on the cross road as far as the trees, and the trees are a long way off. By the time I'd found the biting point something had come from the trees, gone over the junction, and blown the hat off a man at the cash machine. It was a motorbike, he said. He thought.",
#:   "The council has counted. Of two thousand cars that went over our crossroads on Sunday, one spoils the average. The loop in the tarmac could not make sense of it and printed an error; the second loop gave 131. My wife and I were about to set out from the other road, in a car that fortunately drives itself and has better eyes.",
#:   "I braked for a sound. It's all I had. There's a wall at that corner, so there was nothing to look at, only this tearing noise that got higher and higher and didn't ease off as it should if the fellow had meant to be careful. My bonnet was yet behind the line when a hatchback was flung through the crossing.",
#:   "Exposure in the conflict area lasted 0.31 seconds. Simulations with a crosser at 50 km/h gave us 0.9 and the AV coped; here it must have the vehicle recognised while it's still some eighty metres down the side arm. It keeps its foot in throughout and it goes neither left nor right, it just arrives and isn't there any more.",
#:   "You ask how fast. I'm a bus driver, I know what forty looks like, and I know sixty. With this one I saw a streak on the left, and a streak on the right, and a crisp packet standing on its end in the middle of the crossing. I'd got four wheels still behind the line and I kept them there.",
#:   "That fire chief of ours has a heavy boot. All Main Street knows it. When he gets a shout, he comes over the crossroads by the school in his red car so that the lollipop lady's skirt lifts; yesterday he was seen, or rather was not seen, by a learner who had just begun to pull forward.",
#:   "I am from the countryside and I thought such thing is only on television. Our taxi stops before the crossing for no cause. I want to ask the driver why. Then one silver car is passing there, from one side, with so much speed that the shop windows are shaking, and I closed my mouth again.",
#:   "A pheasant's feather was still coming down. \"It flew into him,\" the postman said, \"or he into it, at that lick who's to say.\" He meant the young man with the loud exhaust, who had gone over the crossroads that Saturday as if there'd been no crossroads, no pheasant, and no van with a grandmother waiting at the other arm.",
#:   "V1's automated system initiated braking while the intersection appeared clear to its passenger. Approximately 0.7 seconds thereafter V2 traversed the intersection from right to left. Surveillance footage puts V2 at 84 mph in a 35 zone, with constant engine note and no illumination of its brake lamps before or after.",
#:   "In a rally it would have been applauded. I was marshalling at the other junction and heard it through the wood: flat in third, flat in fourth, and not the tiniest lift for the crossing, where members of the public were entitled to be. It wasn't a rally, of course. It was a gentleman in an Audi on his way to choir.",
#:   "lol the seat belt locked before i even knew. then this superbike just goes EEEEOWWW across the junction infront of us, must of been doing 100+, never backed off. car waited like 3 secs then went \"continuing trip\". yeah cheers",
#: ]
#: adversaries = ["car", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "NHTSA pre-crash typology: straight crossing paths; own code"
#: [slots]
#: actions = ["fast"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 25.0
#: high = 60.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 12.0
#: high = 16.0
#: unit = "m/s"
#: meaning = "how fast it drives"

param OPT_ADV_DISTANCE = Range(25, 60)
param OPT_ADV_SPEED = Range(12, 16)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, 1, 0, globalParameters.OPT_ADV_SPEED)
