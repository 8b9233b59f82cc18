#: description = "The car behind sticks to the ego's rear bumper."
#: rephrasings = [
#:   "Some impatient sod is glued to our bumper.",
#:   "Vehicle 2 followed vehicle 1 at an unsafe distance.",
#:   "Rear veh tailgating, gap below 1 s.",
#:   "The target follows the VUT with a time headway far below the legal one.",
#:   "He drives too much near behind us, no distance at all.",
#:   "A lorry's grille fills our mirror and won't go away.",
#:   "The bus rides our tail so close that we can't see its lights.",
#:   "A motorcyclist slipstreams us within touching range.",
#:   "some white van glued himself to my backside and wouldn't drop back an inch",
#:   "Suspect vehicle was following too closely, maintaining less than one car length to the rear of the victim.",
#:   "HGV rides our bumper. Gap 2-3 m. Doesn't pass.",
#:   "The target vehicle follows the VUT at the same speed with an insufficient time gap (0.3 s).",
#:   "The bus is all time very near to my back, I see only his face in the mirror.",
#:   "Add a pushy follower: locks on to the SUT's tail with tiny headway and stays there, whatever the SUT does.",
#:   "She slowed, she sped up, and still the motorbike hung there on her tail light as though towed.",
#:   "You've got a fire engine right up your chuff, love; he's breathing down your neck and not giving you any room.",
#:   "this guy is literally in our boot rn, back OFF bro",
#:   "Police are warning of drivers who hound the vehicle in front, after a coach hugged a pensioner's rear for miles",
#:   "For the whole of that stretch, you could not have slid a newspaper between your front and the plaintiff's rear, could you?",
#:   "The bus behind damn near lah, can count his nose hair, never give space one",
#:   "I'm doing the limit and there's this muppet so far up my rear end he could read my meter",
#:   "Insufficient following distance of rear traffic, persistent",
#:   "Ambulance REFUSES to back off my bumper (rear view)",
#:   "The motorbike leeched onto our tail.",
#:   "Two feet off our back end, that coach, mile after mile.",
#:   "Simulate a bully in the rear-view mirror who never drops back.",
#:   "Cab following nose to tail, refuses to leave a gap.",
#:   "Mum, why is that police car nearly touching us from behind?",
#:   "Biker practically sitting on my boot lid for the entire ride",
#:   "Headway of the trailing HGV to the robotaxi was measured at under half a second, and it was held constant throughout the run.",
#:   "My instructor always said two seconds; the estate behind me was allowing perhaps a fifth of one, and kept it that way.",
#:   "For my test I need a rear vehicle which is hanging at the AV without safety distance and simply goes on like this.",
#:   "\"He was so close I couldn't make out his number plate,\" the pensioner said of the pickup that shadowed her through the village.",
#:   "Why does the guy behind think that sitting on my exhaust pipe will make the thirty limit go away?",
#:   "Control, we have got a minibus trailing that saloon with no daylight between them, and he's content to stay put there.",
#:   "I was doing a steady forty with the baby in the back when a transit came up and settled itself a yard off my rear screen. It stayed there the whole way down the dual carriageway, and I dared not touch the pedal.",
#:   "V1 was proceeding within the posted limit. V2, a pickup, was traveling immediately to the rear of V1 with virtually no separation, and witnesses stated this spacing did not change over a distance of approximately one mile.",
#:   "Look in your mirror: see how big that lorry is? He ought to be a good way back, and instead he's crowding you. He won't ease off either, so we leave more room in front and keep calm.",
#:   "Rain was drumming on the roof and the headlamps of the thing filled the car with white light. However she drove, it clung on behind, a hand's breadth away, patient as a dog at heel.",
#:   "Honestly, chat, look at the back camera. This school bus has its nose pretty much inside our trunk, we're at the limit, there's nowhere for me to go, and he just keeps pushing up on us like that, block after block.",
#:   "Nothing in my mirror but the badge on that jeep's radiator.",
#:   "Whoever's back there is driving off our number plate.",
#:   "Shuttle hunted by a minibus that leaves itself no room to stop.",
#:   "Have a coach come right up to the ego's back end and stay planted there, matching every change of speed we make.",
#:   "Rear camera showed the following HGV's number plate cropped at the lower edge, so close was it, and the picture was the same for four minutes.",
#:   "Please put a motorcyclist behind the subject vehicle at a spacing no sane person would ride with, and keep him at it till the end.",
#:   "For three kilometres he was hanging at my trailer hitch, this police car, no blue light, no overtaking, only pressing.",
#:   "The complainant could feel, she said, that if she so much as lifted her foot the gritter at her back would be in her parcel shelf.",
#:   "Grandma, the lady behind us could read our newspaper from there, and she is coming with us like that round every bend!",
#:   "We had my father's ashes on the back seat, so I wasn't going to hurry for anyone. All the way from the crematorium a builder's flatbed was so tight against us that its headlamps had vanished below our rear window, and neither of us mentioned it until we were home.",
#:   "I put it to you that if the plaintiff had stopped for the kitten, as any of us might, you would have been in her boot before your foot had left the pedal. There were, by your own dash camera, some two metres between the cars, and that was so from the bakery to the bridge.",
#:   "Why were my knuckles white? Because at sixty miles an hour, with sleet on the road, a lorry driver had decided that the space I'd like behind me was his. I couldn't see his wheels, his bumper or his plate, only the maker's name, back to front, in the glass. It stayed that way until my exit.",
#:   "Trip note, safety driver: on the ring road in the morning peak I kept my hand near the wheel throughout. If the AV had needed to brake even moderately, the bus at our rear would have hit us, as it held about a car door's length from us the entire run and showed no interest in passing.",
#:   "You ask me what I remember of the drive? The glare. Somebody's full beams were inside my car, on the dashboard, on my daughter's hair, and when I went a little quicker to get rid of them they came along, as if tied on with a short string. I never found out what make it was.",
#:   "Listeners, picture it: single-lane roadworks, average-speed cameras, nothing anybody can do. And there's a fella in a people carrier who's crept so far into my personal space that my parking sensors go off. Beeping. At fifty. For six miles, beeping, because he would not give me a yard.",
#:   "Vehicle 1, an automated shuttle with eleven passengers, was proceeding at 24 mph in a school zone. An occupant of the rear seat told investigators she could have touched the hood of Vehicle 2 had the window opened. The spacing between the two did not increase at any time before the recording ended.",
#:   "My husband is a calm man, but that day he said words I did not know he knows. It was because of a scooter rider, who had parked himself so to say under our spoiler. We wanted to stop for the pharmacy and did not dare it, since he had no chance to brake.",
#:   "Lesson nine, and the pupil asks me why the back seats have gone dark. Well, that's a dustcart, love, and it has moved up until it's blotting out the daylight. We can't shake it off, it means to live there, so you plan everything early and touch that brake like an egg.",
#:   "He'd smelled the diesel before he noticed the shape. There was no longer any road behind him, merely chrome, a great grinning wall of it, keeping the same handspan from his tail lamps uphill and down. He thought of his brakes, how good they were, and how little that would help.",
#:   "rode home from my nans with the trailer on the back of the car n this taxi was SO far up it i thought he'd hitched himself on, couldnt see his lights, 20 mins of that, nan's dresser was in there",
#:   "Nothing but radiator in the back window, street after street.",
#:   "Unwanted company, one metre astern, permanently.",
#:   "A lorry wearing us like a hat, mile after mile.",
#:   "If I had so much as sneezed on the brake, the horsebox following us would have been in the children's laps; it kept it like that all the way to Ludlow.",
#:   "Kindly arrange that some impatient cab fills the rear view from the first second to the last, without ever touching us and without trying to get by.",
#:   "Back ultrasonic sensors reported an object at 0.8 m during the entire cruise at 50 km/h, which turned out to be the front end of a coach.",
#:   "For a whole quarter of an hour the ambulance driver behind was so near that I could count his teeth when he yawned, and he never fell back.",
#:   "We've a complaint from a robotaxi passenger, she says some fella on a motorbike has been breathing on her rear screen since the flyover and won't drop off.",
#:   "You know that two-second rule I taught you? The gentleman in the pickup astern of you has never heard of it, and he means to stay where he is.",
#:   "I could not see the road behind me because there was none to see. Where it should have been, from the first traffic island to the last, there stood a windscreen with two faces in it, and they were arguing. I heard nothing, of course, but I could have told you what it was about.",
#:   "It was the sticker I remember, \"How's my driving?\", with a phone number in small print. I could read the small print. In my mirror. Backwards. For nine miles on the A12 I rehearsed that number aloud, and when at last the artic had gone its own way at the docks I rang it.",
#:   "Why did the AV begin to leave more and more space in front? Because it had none at the back. The rear lidar showed a minibus at a time headway of 0.25 s, constant to within a few centimetres through all our speed changes, as if coupled to us by a drawbar. It neither hit us nor went by.",
#:   "My wife, who hates driving, said: \"The sun has gone in.\" It hadn't. There was simply a furniture lorry at our back, and whenever I gave it a bit more or a bit less the shadow stayed precisely over the rear seats. I was longing for a lay-by the way others long for the sea.",
#:   "Officer, nobody was hurt, I only want it written down. I'd my grandson aboard and held to thirty. Where you'd expect to see the lamps of the one that follows, I saw just the top of a bonnet, and it was so at the school, at the bridge and at the church. One cat in the road and we'd have been one car.",
#:   "In our country we say, he is sitting in my neck. The taxi was sitting in my neck since the airport. I was driving seventy, he also; I was driving ninety, he also; between us you couldn't park a bicycle. My mother-in-law has prayed two full rosaries and then it was our exit.",
#:   "The subject vehicle was fitted with a trailer hitch, and it's the hitch that gave the figure. Frame by frame, the hitch ball is within 1.2 metres of the following van's grille for the whole sequence of 94 seconds, at speeds from 38 to 61 km/h. There was no contact, nor did the van leave the lane at any point.",
#:   "She had the feeling of being pushed, although nothing pushed her. It was only a light, too large, too low in the glass, and it rounded each bend when she rounded it, so that the motorbike's rider and she might have shared one umbrella. She kept her foot as level as a full cup. It didn't leave her until the town.",
#:   "Lorry driver here, and I'll say it against my own lot. Bloke in a tipper was shoved so far up that little driverless thing he couldn't have seen its roof over his dashboard. Any road I looked, there he was, no gap, mile on mile. If it stops for a pheasant he's wearing it, I says to the wife.",
#:   "Would you have dared to brake? There was a dog by the verge, off its lead, and I ought to have slowed for it. But the police car at the back, no lights, no hurry, was hanging on so tight that I could make out the pattern on the constable's tie. He kept me company like that to the county boundary.",
#:   "looked up from my sandwich cos the shuttle got dark. theres a bus behind us and i mean BEHIND us, driver couldve leant out and wiped our window. thought hes gonna go round. nope. thought hes gonna hit us. nope. just stayed there like a magnet the whole way to the uni lol",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: following too closely; own code"
#: [slots]
#: actions = ["tailgate"]
#: position = "behind"
#: [[parameters]]
#: name = "OPT_ADV_GAP"
#: low = -0.6
#: high = 2.5
#: unit = "m"
#: meaning = "how much room it means to leave; below 0 it will touch"

param OPT_ADV_GAP = Range(-0.6, 2.5)

behavior AdvBehavior():
    do PaceOnPath(advTrajectory, ego, -(ego.length + self.length) / 2 - globalParameters.OPT_ADV_GAP, 12)
