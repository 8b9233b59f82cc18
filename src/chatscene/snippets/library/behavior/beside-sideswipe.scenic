#: description = "The car keeps level with the ego and suddenly swerves at it."
#: rephrasings = [
#:   "The psycho next to us pulls level and rams sideways at us.",
#:   "Vehicle 2 was alongside and abruptly steered toward vehicle 1 before resuming its lane.",
#:   "Level, lateral jab at us, back in lane.",
#:   "The target travels abreast of the VUT and makes a sudden lateral incursion.",
#:   "He drives near us and then he throws the wheel to us and again away.",
#:   "The coach beside us jerks over at our doors and recovers.",
#:   "A motorcyclist rides shoulder to shoulder and veers into our side.",
#:   "A lorry running abreast gets a gust and lunges across the dashes at us.",
#:   "The van was running side by side with me and out of the blue he chucked it over at me.",
#:   "Unit 2, traveling parallel in the adjoining lane, abruptly veered into the side of Unit 1.",
#:   "Car alongside, neck and neck, then jerks wheel into us.",
#:   "The adjacent vehicle travels at equal speed next to the test vehicle and then performs a sudden lateral move towards its flank.",
#:   "The bus is beside me, same speed, and suddenly steers into my side.",
#:   "Parallel actor locks to our speed, then steers hard at our doors, not a cut-in, a side hit.",
#:   "They had been rolling along shoulder to shoulder when he lurched across the line and went for her doors.",
#:   "Mind the motorbike next to you, he's dead level, whoa, he's just lunged at us.",
#:   "car next to me was chillin at the same speed then just yanked it into my door???",
#:   "A bus that had been running level with the car lurched sideways at it without warning.",
#:   "He drew even with us, he stayed even with us, and then, counsel, he threw his vehicle against our flank.",
#:   "That lorry was going parallel parallel, then all of a sudden he has turned his steering onto my side.",
#:   "He's rubbing along next to me for half a mile and then bosh, tries to put me in the hedge.",
#:   "Abrupt lateral incursion into own vehicle's flank by abreast-running neighbour",
#:   "TRUCK TRIES TO SHOVE ME OFF THE ROAD (side slam)",
#:   "The van alongside barges us in the ribs.",
#:   "Van cruising right next to us, then wham, lurches into our side.",
#:   "Door to door we go, until the SUV flings itself sideways at us.",
#:   "He matched my speed alongside only to fling his bike at me.",
#:   "Neighbour in the next lane, equal pace, sudden jink toward the AV.",
#:   "Make the pickup hold station abreast of the ego and then lash out sideways.",
#:   "Two lanes, same speed, mirrors nearly kissing: then the horsebox beside me took a violent swing in my direction.",
#:   "The ambulance was exactly next to us for a while, and without any reason it makes a strong jump to our side.",
#:   "After travelling for several seconds in parallel with the subject vehicle, the adjacent truck shall execute one abrupt steering input toward it.",
#:   "You'll have a bus level with your shoulder; watch him, because he may suddenly heave across at you like this one just did.",
#:   "I remember the cab's passenger looking over at me as they rolled along at my elbow, and next thing their wing was coming for mine.",
#:   "What is the driver of that hatchback thinking, shadowing us door handle to door handle and then hurling it in our direction?",
#:   "On the motorway a blue coupé settled in next door and went exactly as fast as I did, for a minute or more. Then the man wrenched the wheel in my direction as though he meant to flatten me against the barrier.",
#:   "The claimant states that the lorry had been keeping pace at her nearside. Its tractor unit then came at her without any signal, scraping paint from both doors, and she is certain it had neither been passing nor merging.",
#:   "Ticket 4471: actor sits abreast with a zero speed difference in the neighbouring lane. At the trigger it should veer violently at our flank, once, and we want to see whether the planner gives way sideways or freezes.",
#:   "We were riding in the taxi without driver, my wife and me, and a motorcycle was accompanying us at the side window always. Suddenly he threw himself over toward our door and my wife was screaming.",
#:   "A fire engine had been running wheel to wheel with us, siren off, all quite friendly. Whether he fainted or dodged something I can't say, but he all at once came slewing at my doors.",
#:   "Mirror to mirror, then a sudden heave of his wing at mine.",
#:   "Wheel by wheel with us, till it pounced at our flank.",
#:   "Lorry level with cab, same pace. Then abrupt lunge at cab's side.",
#:   "Can we get a coach that travels exactly abeam of the robotaxi and, on cue, gets hurled at it by one brutal turn of the wheel?",
#:   "After four hundred metres at my elbow, neither gaining nor losing an inch, the silver estate was flung without a warning at my rear door.",
#:   "Cyclist's mate says the van had been alongside our car like a partner in a dance, and then it went for us shoulder first.",
#:   "The van that hit our mirror had not been passing anybody; it had hung by our side at our own speed, and then hopped sideways at us.",
#:   "A neighbouring motorbike, its front wheel constantly in line with the ego's, has to be thrown at the ego's flank in a single quick jerk.",
#:   "He was driving at my height, madame, always at my height, and suddenly he has given a big stroke of steering wheel against me.",
#:   "There is a dent the shape of a wheel nut in my passenger door, and this is how I came by it. A horse lorry and I had been rolling down the bypass window to window, as people do when the lanes are equally full, and all at once its whole flank jumped at me.",
#:   "My wife was counting the sheep in it, that's how long the livestock truck had been next to us, deck by deck at our windows. \"Forty-one,\" she said, and then the sheep were coming in on us sideways and I was up on the verge, two wheels in the nettles.",
#:   "The yaw trace of the adjacent vehicle is flat for eleven seconds, its relative longitudinal position near zero. Then comes one violent spike with the sign pointing to us. Our lateral clearance fell from 1.6 m to 0.2 m in under a second, and the planner, in my view, reacted too late.",
#:   "Have you had your neighbour at a party suddenly shove you? Well, it was like that. I'm in the inside lane minding my business, this convertible's purring along right by my ear, same speed as me exactly, and bang, a hard flick of his wheel at me. Not past me, not in front. At me.",
#:   "Our reporter was a passenger in the driverless taxi when the incident took place. A scooter had accompanied it door by door along the quay, its rider peering in. He then pitched the machine over toward the taxi's side with such force that she dropped her coffee, while the taxi leaned away.",
#:   "Scenario note: what's under test isn't the merge logic. Nothing merges here. The neighbour sits precisely at our B-pillar, in its lane, at our velocity; some seconds later its steering is thrown toward us, a single savage twitch. If there's room on our far side, I expect us to use it.",
#:   "It's the last thing I'd have expected from an ambulance. There they were, driver and mate, chatting away, level with my window since the roundabout, their blue light off. Next moment the great yellow box had bulged right over at me and I heard the mirrors clap together.",
#:   "Two boys were pulling faces at me from the back seat of the people carrier in the next lane, and for a mile I pulled faces back, because they never got ahead and never dropped away. I saw their faces change first. Then their door was where my door ought to be.",
#:   "Old as I am I can still tell an accident from a fit of temper. That gentleman held his car beside mine, nose by nose, looking across at me, whatever I did with my speed; and when I wouldn't look back at him he gave the wheel a wrench and came at my wing.",
#:   "According to the toll-road operator, \"the two had been running in formation\" before the road-sweeper \"took a sudden dive at its neighbour's ribs\". The driver of the smaller car, a midwife, was forced against the rail. She told us she'd had no inkling, for it had been purring along at her side so peacefully.",
#:   "In the exam a police car came along my side, same speed like me, and I was so nervous that I only looked forward. Sir shouted. The police car had thrown itself sideways to us, very sudden, one hit of the steering, and only because Sir pulled the wheel we are not married with it.",
#:   "Shoulder to shoulder for ages, then a sudden body-check.",
#:   "Our neighbour, nose by nose, made a lunge for our doors.",
#:   "Same speed, next lane, then one vicious twitch at us.",
#:   "The scrape on my front wing comes from a coach that had shared the road with me like a twin until, with no warning, it flung its flank my way.",
#:   "We request an actor abreast of the AV with zero relative speed which, at the marker, is jerked sideways toward it as though the driver had been stung.",
#:   "He was neither faster nor slower than me, the biker, we could have held hands; and then he has thrown himself against my side, like that.",
#:   "You could have handed a cup of tea from my window to theirs for a good half mile, and then the whole ambulance came at me sideways in one go.",
#:   "What startled our test passenger was the suddenness: a pickup whose door handle had been opposite hers since the bridge was all at once about to come through it.",
#:   "Patrol reports a tanker running dead level with a saloon on the dual carriageway; caller says it's just made a grab at the saloon, sideways, no signal.",
#:   "The reflection was how I noticed. In the polished side of the milk lorry there was my own car, keeping pace with me, upside down and rather handsome. I was admiring it when it leapt. In a blink the car in the steel and the car I sat in were the same size, and I was up on the rumble strip.",
#:   "There's a thing you do on the training ground where someone drives parallel with you, no faster, no slower, until you've forgotten he's there. Then his front wheels snap toward you. My candidate screamed and braked; you don't brake for that, you make room on the other side, because it's your ribs he's after and not your bumper.",
#:   "Ask yourself why his mirror glass was on my passenger seat. He didn't clip me going by, he wasn't going by; he'd sat at my elbow since the toll plaza with the speedo needles matched. He didn't merge either, there was no slow squeezing. One heave of the wheel and that mirror came in through my window.",
#:   "Between kilometre 4 and kilometre 6 the distance along the road between the two vehicles was, for all practical purposes, nil. The distance across was 1.9 m. At kilometre 6.02 the latter went to 0.3 m within eight tenths of a second, the bus having received what its driver calls \"a tug\". Our AV shifted away.",
#:   "I'm eighty-three and I like company, so I didn't mind the young fellow on the motorcycle who'd been riding along by my window, at my own gentle speed. I nodded. He nodded. The next thing was his knee, handlebar and all, flying at my door like a swung gate, and me with nowhere to go but the cones.",
#:   "First there was the bang of air that a big vehicle makes when it jumps. I had smelled its tyres. Only later did I put it in order: the livestock lorry had been alongside, exactly alongside, nose to nose with the shuttle for the whole of the viaduct, and something, a gust perhaps, had made it dart at us broadside.",
#:   "The little girl was drawing the fire engine that was driving beside us. She had a lot of time for it because it didn't overtake and didn't stay back, it was always there where her window was. In the drawing it's suddenly very big at one edge. \"That's when it came at us,\" she explained, \"all in one jump.\"",
#:   "Radar on that side is boring to watch: a blob at three o'clock, range constant, bearing constant, for thirty seconds. We call it the lodger. Then the blob tries to get into the car with you. It doesn't creep in as in a lane change; there's just one savage sideways hop, and that's the thing our reflexes were to be tested on.",
#:   "Bhai, I was going in middle lane and one taxi was going adjacent, bumper to bumper line, speed same to same. I am thinking he wants to talk something. Suddenly without reason he has given full cut towards my door only! By God's grace the left side was empty, otherwise both doors finished.",
#:   "ok so everyone in the comments says he was changing lanes. he WASNT. look at 0:20 to 0:48, hes glued level with my window the entire time. 0:49 his front wheel literally flicks at me and his whole van jumps my way. u can hear my nan go \"ooh you bugger\"",
#:   "Two horses are sometimes driven like this, she thought, in harness, eye to eye; for the black saloon had been trotting next to her own car since the river and would be neither left nor lost. Then the other horse shied. It shied toward her, with its whole gleaming side, and the road was suddenly half as wide.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["pace", "swerve"]
#: maneuver = "straight"
#: leader = false
#: position = "beside"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -25.0
#: high = 5.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_AHEAD"
#: low = -4.0
#: high = 5.0
#: unit = "m"
#: meaning = "how far ahead of the ego it stays"
#: [[parameters]]
#: name = "OPT_SWERVE"
#: low = 1.5
#: high = 2.5
#: unit = "m"
#: meaning = "how far it swerves"
#: [[parameters]]
#: name = "OPT_SWERVE_TIME"
#: low = 1.0
#: high = 1.6
#: unit = "s"
#: meaning = "for how long it swerves"

param OPT_ADV_DISTANCE = Range(-25, 5)
param OPT_ADV_AHEAD = Range(-4, 5)
param OPT_SWERVE = Range(1.5, 2.5)
param OPT_SWERVE_TIME = Range(1, 1.6)

behavior AdvBehavior():
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 2.5) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do SwerveOnPath(advLane, 7.5, -globalParameters.OPT_SWERVE if offsetFrom(egoRoute, self) > 0 else globalParameters.OPT_SWERVE) for globalParameters.OPT_SWERVE_TIME seconds
    do PaceOnPath(advLane, ego, globalParameters.OPT_ADV_AHEAD, 16, 2.5)
