#: description = "The crossing car brakes for the red light at the last moment, then changes its mind and accelerates through."
#: rephrasings = [
#:   "looks like he's stopping for the red, then he floors it after all",
#:   "Vehicle 2 braked for the red signal but then accelerated into the intersection.",
#:   "brakes at red, reconsiders, full throttle through",
#:   "The target decelerates at the stop line as if to comply with the red signal and then accelerates across the VUT's path.",
#:   "The motorcycle first is braking because of the red, but suddenly it gives gas and passes.",
#:   "A driver slams the brakes on for the lights and a heartbeat later guns it over the crossing.",
#:   "The rider checks his speed at the signal, thinks better of it, and blasts off on red.",
#:   "It slows sharply for the red, only to speed up and run it.",
#:   "he stood on the brakes for the red, then thought sod it and booted it through",
#:   "The driver braked late for the red signal, then reconsidered and sped up through the intersection.",
#:   "MC: brakes for red at last sec, then nope, full gas over.",
#:   "The crossing target brakes late at the red signal, aborts the stop and accelerates across the junction.",
#:   "The car has red, he brakes in last moment, but then he thinks other and goes with full gas.",
#:   "Red-light NPC with aborted stop: late decel, then release and throttle up across the box before reaching v=0.",
#:   "The biker had dipped his front wheel as if to obey the light, but the temptation got him and he roared over.",
#:   "He's stopping for the red... no he isn't! Dabbed the brakes, had second thoughts and gone for it.",
#:   "he was braking for the red n then was like nah and gunned it",
#:   "A motorist who looked set to obey the red signal reconsidered and shot over",
#:   "You had begun to brake for the signal, belatedly I grant, and then you resolved to defy it at full power?",
#:   "Red light he brake already, then suddenly don't want to stop, press oil and dash across",
#:   "Nose goes down, good lad, he's stopping for the red... no he ain't, foot down and through",
#:   "Revoked stopping decision at red signal: late braking, then acceleration through",
#:   "Biker brakes for the red light, then CHANGES HIS MIND",
#:   "The coupe balked at the red, then bolted over it.",
#:   "starts stoping for the red then reconsiders and zooms over the crossing",
#:   "Crossing biker brakes late at red, then rushes the junction.",
#:   "Cross traffic: red, hard brake, change of heart, full power.",
#:   "HE WAS STOPPING! ...then he floors it through the red",
#:   "Have the crossing coupe brake on red and then go for it.",
#:   "The van coming from the side had its nose right down for the red light, but before it stood still he let go and shot over the intersection.",
#:   "Against a red signal the crossing target applies its brake shortly ahead of the stop line, releases it prior to standstill and accelerates through the junction.",
#:   "Late on the brakes for his red, and nearly stopped, the motorcyclist must have decided that stopping was for others, and he tore over in front of us.",
#:   "I believed he will respect his red light because he braked, finally, at the last metre; but no, he put the gas again and crossed.",
#:   "The grey estate on the side road was obliged by the red to wait, and for one second looked as if it would, before it leapt across.",
#:   "Caller reports a taxi that was slowing for the red from the cross street, decided against it at the line and belted straight over the junction.",
#:   "My light was green, so his was red. I watched the SUV on my right dip under braking as it reached the line, rather late, and I relaxed. Then its nose came up, the engine howled, and it flew across the intersection just in front of me.",
#:   "According to the data recorder of V2, which faced a red signal, the brake was applied 1.6 seconds before the junction and released at a speed of 7 km/h. The accelerator was then fully depressed and V2 entered the intersection at increasing speed from V1's left.",
#:   "This actor should look obedient and then betray us. It comes along the cross street to a red light, gets on its brakes at the very last moment as if to stop, and while still rolling abandons that idea and powers through the junction.",
#:   "Never go by the first thing you see. The motorbike in the side road is braking for his red, yes, he's nearly at walking pace, you think he's done; and look, he can't be bothered to wait after all, he's opened it up and he's through.",
#:   "I know the type from forty years on the road. Comes belting up to the lights from the side, they're against him, so he stamps on the brake, front end goes down. Then you can see him think, ah, the hell with it, and he boots it over.",
#:   "Crossing van anchors for its red, recants, hammers through.",
#:   "He'd all but obeyed the red when he booted it over.",
#:   "Red for the side street; biker brakes, reneges, roars across.",
#:   "The cabriolet from the left was down to a crawl at its red when the driver, evidently bored with obedience, shot over the junction.",
#:   "Cross-traffic target: late braking toward a red signal, abort at roughly walking speed, subsequent full-throttle passage of the conflict zone.",
#:   "What made you take your foot off the brake again, the signal still being against you, and launch the vehicle over the crossing?",
#:   "The bike from side was having red, at the last he braked, I felt okay good boy, then he opened full throttle and crossed.",
#:   "Have the side-road motorbike get on its brakes at the line for the red light and then, not yet stopped, surge across after all.",
#:   "She braked for her red far too late and then, instead of finishing the job, trod on the other pedal and flew over our road.",
#:   "You learn to watch the nose of a car and not its driver. The Golf's nose, on my right at its red, went down like a good dog's. I took my foot off the brake. But it came up again, up and up, and the whole Golf came after it, across the junction at a rate of knots.",
#:   "For the jury's benefit I'll put the sequence plainly. The light controlling the accused was red. He braked, belatedly, and had very nearly brought the motor car to rest; at that point, with a change of heart he's been unable to explain, he accelerated as hard as he could and traversed the crossroads.",
#:   "I watched two things, my green and his speed. His speed was dropping, thirty, twenty, ten, as it should with a red in your face. I looked back to my green, for half a second, and when I looked at him again he was under full power in the middle of the crossing with his exhaust crackling.",
#:   "The deceleration of the crossing object was textbook, if on the late side, so the arbiter classified it as complying with the red signal. At 6 km/h it changed sign. The object gained speed all the way across the ego's path, and the arbiter was left with egg on its face.",
#:   "Listen, I teach this for a living and he'd have had me fooled. He's got a red, that motorcyclist on the left, he's clamped on the brakes a bit late, front forks right down. But he never put a foot to the ground, see, and that's the giveaway. Twist of the wrist, and across he's gone.",
#:   "Dear Sir, the junction by the post office wants a policeman. On Monday a green car, coming to it from the side against the red, slowed with such a jerk that one thought it had repented. It hadn't. Before its wheels had ceased turning the man gave it the spur and it tore across before us.",
#:   "The rubber on the road tells you the story, two kinds of it. The first marks, short of the stop line, come from locked wheels: our friend in the pickup has noticed his red. The second kind begin just after, from wheels that are spinning, and they go clean over the crossroads.",
#:   "Daddy said, look, he stops because his light is red. The motorbike man did a big brake and was nearly standing. But I think that he was in a hurry after all, for he made brrrm and whizzed over in front of us, and Daddy said he takes it back.",
#:   "In this run the actor must give a false promise. Approaching from the cross street on red, it begins its braking at the last possible instant so that the ego has every reason to go on. When its speed is under two metres a second it withdraws the promise and powers over the intersection.",
#:   "When the signal is red by me at home, one stops, and there ends it. The lady in the Mini from the side street has at the very last made a strong braking. She rolled yet a little. And while she rolled, she has thought differently and has pressed the gas, and with much noise she was across.",
#:   "Maybe he'd seen the camera, then seen it was a dummy. I can only say that the crossing taxi was braking for the red, late but properly, with its tail in the air. It was hardly rolling. The tail went down, there was a bark from the engine and it had gone through in front of our bus.",
#:   "Biker's red: braking, braking... no he isn't, he's through!",
#:   "Crossing Golf squats for red, un-squats, rockets over",
#:   "Red. Late brakes. Almost nil. Sod it. Full power across.",
#:   "His tail came up for the red light as it should, and then, hardly rolling, it went down again and the coupe shot over the crossing.",
#:   "Our green was safe for as long as the motorcyclist from the left was slowing for his red, which he was until, with a howl, he wasn't.",
#:   "The lady in the crossing hatchback first obeyed the red, late and violently, and then at walking pace she disobeyed it, just as violently.",
#:   "Taxi to the right of us, red against him: stop lamps on at the last yard, off again before he'd stopped, rear wheels smoking, gone across.",
#:   "He has the red, he brakes so that it whistles, one thinks good, he stands soon, and then he presses through with everything the motor gives.",
#:   "Make it look like a stop: hard, late braking at the red on the cross street, a change of heart at a crawl, and full throttle over.",
#:   "The pram was halfway on to the crossing, and I'd nodded to the mother that it was all right. It was all right, look, he'd got his brakes on. They were late, but they were on, and his light was red. It was when they went off that I grabbed her. He went between us and the robotaxi with his engine screaming.",
#:   "My green had gone stale and I was asking myself about the van on the left, as one does. Its bumper dived at the line. Well, that answered that. I put my eyes back in front and my foot down, and when my eyes next had anything to do with the van it was across my bows, in second gear, bellowing, with the red behind it.",
#:   "Telemetry of the crossing motorbike, for those who asked. Signal red throughout. Speed 12, brake front and rear from two metres before the line, speed 6, speed 2. At two the brake's released, and the throttle goes to full; speed 5, 9, 13, this being inside the junction. The rider's explanation reads \"thought I might as well\".",
#:   "Decide, man, we all shouted, my whole tram, I think. He had decided to jump the light, by the look of his speed; then at the line he'd decided against, and stood that little sports car on its nose; and as it was about to come to rest he decided a third time. It was the second decision we liked.",
#:   "Two signals reach you from a car on the side road, and you want to weigh them both. One's his traffic light, and it is red, and you'd say that settles it. The other's his bonnet. It was down a moment ago, braking. It's up now, and it's up before he ever stopped, so he's coming. Wait. What did I say?",
#:   "A long whine, a silence, a long roar: I have these on my telephone as I was recording birds. The whine is the tyres of a motor car arriving much too fast at a red lamp on Hill Street. The silence is when he'd nearly stopped. And the roar's him on his way over the crossing after all, with us in the middle.",
#:   "Your honour, the prosecution calls it inattention. I call it a bargain that he struck with himself. He saw the red, he braked for the red, late, leaving rubber. With the car all but stationary at the line, he looked at the rubber and the empty road and floored it. My client's lorry was on that empty road.",
#:   "Reason for hard stop at 08:31: crossing taxi. Our prediction had it classed \"yielding\" from the moment it braked, since its light was red and it was down to seven km/h at its line. Nothing short of standstill should count as yielding. It powered up from those seven km/h and passed ahead of us at forty.",
#:   "As a lollipop man I have two eyes for brake lights. The blue one's were burning all right, and his nose was scraping, because he'd left it till the last second with the light at red against him. I lifted my stick. Off went the burning. I put my stick down again pretty sharp, and he was over and up Station Road like a scalded cat.",
#:   "Somewhere between the white line and the middle of the street, honour died in him. It had been alive at the line. One had seen the front wheel of his motorcycle judder, one had seen his boot reach for the stones, beneath that red lamp. The boot was drawn up again, the wrist turned; and with a shriek he was amongst the carriages.",
#:   "Passenger of V1: \"I said to the driver go, since the other one was stopping.\" Other one, V2, was on the intersecting road facing a red signal, and did show heavy braking, begun late. It never reached zero. \"Then it changed its mind and so did my driver.\" V2 cleared the intersection under full acceleration one length in front of V1.",
#: ]
#: adversaries = ["car", "motorcycle"]
#: requires = ["advTrajectory", "crossSignal", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["run-light", "brake", "accelerate"]
#: position = "crossing"
#: control = "signal"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 18.0
#: high = 50.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it comes in"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.6
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(18, 50)
param OPT_ADV_SPEED = Range(6, 10)
param OPT_BRAKE = Range(0.5, 1)
param OPT_THROTTLE = Range(0.6, 1)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until crossSignal == "red" and distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until self.pose[3] > 4.5 and distanceLeft(advTrajectory, self, advTrajectory.entry) < 2
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE) until self.pose[3] < 2
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE)
