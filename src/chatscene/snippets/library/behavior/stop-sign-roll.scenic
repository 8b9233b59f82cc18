#: description = "The crossing car brakes for the stop line without quite stopping, and speeds up across."
#: rephrasings = [
#:   "classic rolling stop, he barely slows for the sign and then goes for it",
#:   "Vehicle 2 failed to come to a complete stop at the stop sign and accelerated into the intersection.",
#:   "rolling stop, doesn't halt, speeds up",
#:   "The target reduces its speed at the stop line without reaching a standstill and then accelerates across the path of the VUT.",
#:   "The driver brakes a bit at the STOP but he doesn't really stop, then he goes faster.",
#:   "A lorry does a California stop and pulls across.",
#:   "The biker brushes the brakes at the give-way line and nips over.",
#:   "It slows sharply, rolls past the sign, and picks up speed in front of the ego.",
#:   "He made a half-hearted dab at the stop line, never actually stopped, then gunned it over.",
#:   "The driver made a rolling stop at the stop sign and accelerated across the intersection.",
#:   "Rolling stop, then hard gas across. Wheels never at 0.",
#:   "The crossing target decelerates towards the stop line without reaching standstill and accelerates through the junction.",
#:   "The car brakes at the stop, but not to zero, and then goes quick over.",
#:   "California stop: actor dips to ~2 m/s at the line, then floors it through the conflict zone.",
#:   "He made a show of slowing at the sign, but the wheels never stood still, and off he leapt across.",
#:   "See that? He didn't stop at the sign, only rolled it, and now he's booting it over.",
#:   "he like almost stopped at the stop sign and then sped across instead",
#:   "The driver slowed for the line without ever coming to rest, then hurried over.",
#:   "You slowed, I grant, but your wheels never ceased to turn before you quickened across; yes?",
#:   "At the stop line he slowed little bit only, never fully stop, then went fast across.",
#:   "Stop means stop, doesn't it? Not to him, bit of brake, then foot down and over.",
#:   "Incomplete stop at stop line with accelerated crossing.",
#:   "CALIFORNIA STOP THEN GUNS IT ACROSS",
#:   "The crossing motorbike curtsied at the stop line and scooted over.",
#:   "Crossing cab dips its speed at the line, never halts, zips over.",
#:   "Side-road van: token braking at STOP, then a spurt across.",
#:   "Let the lorry nearly stop at its line, then hurry over.",
#:   "He only made slow at the sign, then whoosh across, cheeky!",
#:   "Biker scrubs off speed for the stop line, foot never down, blasts across.",
#:   "We watched the saloon in the side road come down to a crawl at its line, but it never quite stood, and then it sprinted over.",
#:   "The crossing target brakes towards its stop line to a residual speed above zero and then accelerates strongly so as to traverse the junction ahead of the VUT.",
#:   "A stop is when the wheels don't turn. His turned. He slowed for the line, kept it rolling, and now he's given it the beans to get across.",
#:   "The bus of the other street has braked at the line but not until the end, and afterwards he gave gas and came over quickly.",
#:   "Accident was caused as motorbike fellow did half-braking only at the stop line, did not come to halt at all, and took pickup to cross.",
#:   "Where the sign says stop, the pickup on the cross street did about three-quarters of a stop, and the missing quarter it turned into a dash over.",
#:   "I always sit on the bench by that corner, and I can tell you that nobody stops. This one, a lady in a big estate, did touch the brake by the line so that the front dipped, but she was still moving when she put her foot down and flew over the crossroads.",
#:   "Vehicle 2 was required to stop before entering the intersection from the minor road. Camera footage shows its speed falling to approximately 8 km/h at the line, at no time reaching zero, and then rising to 40 km/h as it went across in front of Vehicle 1, whose driver had taken the braking for compliance.",
#:   "Ticket: NPC on the crossing arm brakes for the stop line and we classify it as stopping. Minimum speed is around 2 m/s. Then it picks up again, more strongly than it had slowed, and clears through the junction. Planner released its own brake too early; wait for true standstill next time.",
#:   "The tipper had the decency to lower its gears for the line, so that for a second the AV's passengers believed in it. Its wheels went round slowly, then slower, but never not at all; and with that it had done its duty, growled, gathered itself and came charging over.",
#:   "From where I was on my bicycle he and I made eye contact, and that's the annoying bit. He braked, the little van nearly stood at the line, I relaxed, the woman in the robotaxi relaxed. Still rolling, he checked nobody had a badge on and shot across before the lot of us.",
#:   "Moped slows for the line, never quite halts, and zips over the road.",
#:   "Have the pickup nearly stop at its sign, then rush across.",
#:   "three mph isnt a stop mate, then he floors it across us",
#:   "The coach on the side road came down to a walk at its line, thought that was enough respect, and went pounding over the crossroads in front of us.",
#:   "Approaching the stop line on the crossing road, the target decelerates to a non-zero minimum speed and thereupon accelerates through the junction at a high rate.",
#:   "He has made a half stop, this one with the motorcycle: the brake yes, the foot on the ground no, and then full gas over the street.",
#:   "Watch her wheels, not her face. They're slowing for the line, they're slowing, they never stopped, did they, and now they're spinning up, she's coming over!",
#:   "Your van was still in motion, was it not, at its slowest point by the line, and it was from that motion that you sped across the junction?",
#:   "At the STOP he braked only for show, vehicle was rolling all the time, and after that he picked up like rocket and crossed in front of me.",
#:   "My dog knows that corner and sits down until I tell him. He must have thought the lorry had stopped, as he stood up. It hadn't, it had only got very slow by the white line, I could see the wheel nuts going round. It then dug in and ran straight over the crossroads, ahead of the electric car.",
#:   "V2 was required to stop. Surveillance video shows V2's brake lamps illuminated on approach and its speed dropping to about 5 mph at the limit line. The wheels do not cease rotating in any frame. The lamps go out, and V2 accelerates across the intersection in front of V1 at an estimated 30 mph.",
#:   "There are two sorts of idiots at give-ways: the one who doesn't brake and the one who does. I prefer the former, since you know where you are. This SUV on the side road braked so nicely at its line that I'd already stopped looking. It was never stationary, though. It got going again and tore over.",
#:   "Case for the intent module. On the crossing leg the actor slows to under 3 m/s at its line, hence \"will stop\". Residual speed remains. Two frames later its acceleration is positive and strong, and it goes over the junction before us. We need the module to wait for zero, or else say it doesn't know.",
#:   "I take this as my text: the man who keeps the letter of nothing. On my way to church a saloon drew up to the stop line, or rather it drew down to it, less and less, until a snail could have kept pace. A snail isn't a stone. It did not stand; it gathered up its skirts and scampered across.",
#:   "We bikers call it the rolling kiss. You kiss the line with your tyre, no foot down, and you're off. The lad on the 125 at Tanner's Row kissed it, scrubbed off nearly everything, and then pinned it over the main road with a robotaxi twenty metres away. The robotaxi didn't find it romantic.",
#:   "Out of the side street had come the front of a bus. It grew slower as it neared its line; Vera let out her breath. A foot short of standing still, however, it seemed to recall that it was late. It breathed in, as she had breathed out, and went bellowing over the crossing under her nose.",
#:   "\"He'd slowed down, so I took him to be obeying the sign,\" said the cyclist, 34, who was waiting behind the test car. \"But you could see that he wasn't going to give it those last two miles an hour. The hatchback never came to a standstill. He kept it moving and then went for it, right over the junction.\"",
#:   "My father in the back seat has opinions. \"Look at this fellow at the line,\" he said, \"now he'll stop.\" The truck's brakes hissed and it sank down in front. \"Now he has stopped.\" But the hubcaps were turning. \"Now he's...\" and it had stormed across ahead of us, and my father was without an opinion.",
#:   "I will explain with numbers because I'm engineer from Pune. Taxi on cross road came with forty. Near to stop line he did braking, up to seven or eight, not zero. Zero never came. Then from eight he went to forty-five, cutting the full junction before my car. So where is the stop in his stop?",
#:   "From the driver's-school blog: what does a driver see who only looks for brake lights? She sees the estate on the side street put them on at its line. She ticks it off. She misses that it's still rolling when they go off, and she'd miss the surge that takes it over the crossroads, too, if I weren't there.",
#:   "Cab dips at the stop line, never rests, zips across us.",
#:   "Crossing bus: half a halt, then a full-blooded dash over.",
#:   "he sort of slowed for the STOP then yeeted across",
#:   "The wheels of the SUV on the side road turned slower and slower at its line, not once stood, and then flung stones as it sprang across our front.",
#:   "I need a motorbike that comes down nearly to a walk at the line of the crossing street, omits the last bit, and whips over ahead of the AV.",
#:   "Was that a stop, would you say? He came down, the line went under him at a crawl, and now he's legging it over the road.",
#:   "The crossing target brakes for its stop line to a velocity that's low but distinctly greater than zero, and then passes the conflict zone at sprint speed.",
#:   "Having coaxed his lorry down till it scarcely rolled, the driver at the give-way seemed satisfied, and crossed ahead of us with all the speed he could get up.",
#:   "As the tyre never came to rest on the line it can't be called a halt; as the line was followed by a rush, it can't be called caution either.",
#:   "I know the face of a man who's counting it as a stop. It looks left, it looks right, as he's been taught, and underneath it the van's still trundling, over the words on the road, over the thick white bar. Then the face looks ahead. That was when I got on to my brakes, and not early, for he went over like a cork.",
#:   "The sign was put up after my sister's accident, so I watch what they do at it. This coach sighed, its front went down, and I counted in my head for the three seconds you ought to stand. I never got to start on one. It was rolling all the while, and next there was a roar and it was across the main road before the test car.",
#:   "Event recorder, V2. Minus 3.5 seconds to the stop bar: 31 mph. At the bar: 5 mph. The minimum, half a yard past it: 4. There's no zero. After that it reads 9, 17, 25 on the way over both lanes. V1, on the through road, had taken the fall in speed for obedience and kept its foot where it was till the 17.",
#:   "The dust tells tales. Where the farm track meets our road there's a fat line, and on Sundays the lads come down it on their motorbikes. The plume gets thin as they get to the line, so you think, good, they've read the sign. It should die. It doesn't die, it goes on as a wisp, and then it shoots out over the tarmac like a rocket's.",
#:   "My pal the taxi driver has a theory, that the law needs nose-down and nothing else. So up he comes to the line on the other street: nose down. Wheels going round? Certainly wheels going round, like a mill in summer. Nose up, and how! And he's over, and we on the main road are the ones who've stopped.",
#:   "The planner subscribes to the view that a crossing vehicle which has lost nine tenths of its speed before its stop line will lose the last tenth. In this run it keeps it. 12, 9, 5, 2 m/s, our release is given; 2, 5, 8, 10, and it's across, having used our release for its own purposes. Please don't release before zero.",
#:   "We've a word for that at the depot, \"kissing\". The lad in the pickup came to his line and kissed it. It's a slow business, a kiss, slow enough to make a coach driver think he'd be staying. But his lips, as it were, never stopped moving, and once he'd done kissing he was off over the crossing like the girl's father was behind him.",
#:   "We weren't fooled by the speed but by the politeness. It was a lady in a cream saloon. She drew her car down at the double white for so long, and so gently, that you had the impression of a curtsy. One forgot to look if she was still. She was not, and what came out of the curtsy was a leap, clean over to the far side.",
#:   "Please tell me that you got it on camera. Yes? Then see, there's the stop sign and there's him, and he's brakin', his lights are on, look. Freeze it. Next. Next. Every picture he's an inch further. There isn't two that are the same. And then these three, where he is a smear: that's him giving it the beans across you.",
#:   "In the driving school at Lyon one learns that the wheel must be dead. The wheel of the truck on the transversal way was not dead, it was a little sick. It was turning always, slowly, slowly, at the level of the band. I had pity, I continued. At once the wheel was in excellent health, and the truck passed before my nose at a gallop.",
#:   "One more and I'll close my notebook. Corner of Elm and Fifth, twenty minutes: eleven cars to the line, nine proper stops. A minibus that sank to what my lad can do on his scooter, and kept it there. The same minibus, with the line behind it, going like the clappers over Fifth and a robotaxi on Fifth being brave about it.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["brake", "accelerate"]
#: position = "crossing"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 15.0
#: high = 45.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it sets off"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 6.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it comes in"
#: [[parameters]]
#: name = "OPT_SLOW_SPEED"
#: low = 1.2
#: high = 2.4
#: unit = "m/s"
#: meaning = "to what speed it slows down at the line"
#: [[parameters]]
#: name = "OPT_ADV_SPRINT"
#: low = 6.0
#: high = 10.0
#: unit = "m/s"
#: meaning = "how fast it becomes"

param OPT_ADV_DISTANCE = Range(15, 45)
param OPT_ADV_SPEED = Range(6, 9)
param OPT_SLOW_SPEED = Range(1.2, 2.4)
param OPT_ADV_SPRINT = Range(6, 10)

advTurn = "straight"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until self.pose[3] > 4.5 and distanceLeft(advTrajectory, self, advTrajectory.entry) < 3.5
    do BrakeOnPath(advTrajectory, 0.6) until self.pose[3] < globalParameters.OPT_SLOW_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPRINT)
