#: description = "The pedestrian runs into the lane and charges along it straight at the ego."
#: rephrasings = [
#:   "A madman runs into our lane and comes sprinting at the bonnet.",
#:   "The pedestrian ran in the lane of travel toward the front of Vehicle 1.",
#:   "ped charges us head-on in our lane",
#:   "The target enters the lane and runs toward the VUT.",
#:   "The person runs to our car from front in our own lane.",
#:   "A furious protester storms up the carriageway to confront us.",
#:   "Someone pelts down the tarmac to flag us down, arms waving.",
#:   "The jogger swings into the road and hurtles to meet us.",
#:   "A madman ran out into the road and came sprinting straight at my bonnet.",
#:   "Subject ran into the lane and rushed head-on at Unit 1.",
#:   "Ped runs in, sprints along lane at us, head-on.",
#:   "The pedestrian target enters the lane and runs longitudinally towards the front of the test vehicle.",
#:   "A man runs on my lane directly to my car, very fast.",
#:   "Walker actor at running speed, aims at ego front along the lane, doesn't sidestep.",
#:   "He put his head down like a bull and came pelting up the road at them.",
#:   "There's a fella sprinting right at you, down your own lane, stop the vehicle.",
#:   "this crazy guy ran into the road and straight up CHARGED my car",
#:   "A man rushed into the lane and hurled himself toward the front of an oncoming car.",
#:   "He did not run across, my lord; he ran in and then ran full tilt at the car itself.",
#:   "Siao one, run into the road then run straight to my car like want to fight.",
#:   "Comes pelting down the lane at me like a bull at a gate.",
#:   "Running frontal approach of pedestrian along own lane",
#:   "PEDESTRIAN BULL-RUSHES MY CAR",
#:   "The woman storms down the lane at our grille.",
#:   "Runs out, swings toward us and rushes our front bumper.",
#:   "Pedestrian: enters lane at run, continues longitudinally into VUT's face.",
#:   "Some lunatic in the road is sprinting to meet my bonnet!",
#:   "RAGING MAN TAKES ON SUV HEAD-FIRST",
#:   "Who runs into a lane and then straight at the traffic in it?",
#:   "Let a person rush from the side into the ego's lane, turn to face it, and come racing along that lane right up to its front.",
#:   "He wasn't trying to get over the road at all; once he was in my lane he turned my way and hared towards my headlights.",
#:   "The non-motorist ran into the northbound lane and then southward within it, directly toward the front of V1, at full speed.",
#:   "One man runs on our lane and then he comes by running, frontally, to the car, with the arms high, I thought he is drunk.",
#:   "Units be aware, female in the carriageway, she's going for the cars, running in lane one straight at the front of them.",
#:   "The yelling protester bore down upon the robotaxi from the front, having burst into its lane from among the placards on the pavement.",
#:   "You learn to read people in this job. This lad came off the pavement at a run, and I waited for him to go over. He didn't. He turned up the lane, towards my bus, and flew at me as though he intended to knock it backwards.",
#:   "A dash across the lane must not be confused with this case. Here the pedestrian target leaves the kerb running, turns through about ninety degrees on reaching the middle of the lane, and advances at running speed along it, on a collision course with the front of the test vehicle.",
#:   "Through the windscreen she saw him vault the barrier. She saw him land in the lane, saw his face swing round to her, and then he was growing, his coat streaming behind him, coming down the middle of that lane as fast as his legs would carry him, at her.",
#:   "I want to see what the AV does with an attacker. So: someone hurtles out from between the parked cars, and rather than crossing, pounds down our lane in the opposite direction to ours, aiming for the badge on the bonnet, and doesn't step out of the way.",
#:   "My window was open so I heard him roar. He'd had words with my mate in the lorry ahead, and now it was my turn: out into the road, a quarter turn, and up the lane he galloped, dead centre, like he would headbut my radiator.",
#:   "Out he rushes, swivels to face us, gallops at our headlights.",
#:   "Protester bursts into our lane and pelts down it, towards us.",
#:   "Woman sprints up my lane, against me, aiming for the bumper.",
#:   "He'd got the lane to himself, having dashed in from the pavement, and he used all of its length to hurl himself at my windscreen.",
#:   "Simulate an attacker who runs from the kerb to the middle of the ego's lane, turns towards the ego and rushes it from the front.",
#:   "There's a naked gentleman who's run on to the carriageway, he's in lane one and he's tearing along it at the front of the cars.",
#:   "He runs in but instead of going across, he turns in my lane and makes a sprint exactly on my car, from front, like the bull to the red.",
#:   "Pedestrian entered on foot at a run, aligned himself with the lane, and advanced upon the oncoming V1 with undiminished speed until V1 stopped.",
#:   "\"Brake, he's not crossing,\" I told her, for the man who'd just run in had wheeled round in our lane and was racing up it, eyes on us.",
#:   "I'd cut him up at the island, he says. I hadn't noticed. What I did notice was a big chap springing off the traffic island into my lane and, where you or I would've carried on to the pavement, swinging round. After that I saw the top of his head, as he'd put it down, and it got bigger very fast.",
#:   "The distance trace has two slopes. To begin with it falls at our own speed. At the point where the walker, who's just run in from the right, turns to face the AV, it steepens by some five metres per second; and that is her, sprinting along the lane in our direction. Even after we've come to rest the trace falls to zero.",
#:   "I'm not being funny but the zombies at the Halloween do were very good. One of them took it too far. He came lurching off the pavement at a run and got himself in the middle of the lane we were on. Then up the lane at us he came, top speed, arms out, groaning, and slapped on to our bonnet.",
#:   "Six weeks into my new career as a bus driver I had a passenger left behind at the stop. She overtook me through the park, it seems. What I saw was a lady vault a flower bed, land in my lane in front of me, and storm down it to meet the bus, hat in fist, head-on, with no thought of getting aside.",
#:   "A threat, in the sense of this guideline, is a person who approaches the vehicle on purpose. For the test the person enters the lane running and, having got to its centre, makes a quarter turn against the flow of traffic. He then goes on running within the lane straight towards the vehicle's front until contact or the end of the trial.",
#:   "It was a child who saw him first. \"Why's he running at us?\" And he was: not over the road, as the boys did who'd been with him on the bank, but down it, with our lane for his track and our number plate, by the look of him, for the tape. We'd stopped long before he breasted it.",
#:   "Court of Appeal, summary. The appellant had left the footway at speed. He had then \"changed course through a right angle\", as the judge below put it, and had run at the respondent's car, in that car's lane and contrary to its direction. It could not be said that a motorist should foresee being charged, as if by a rhinoceros.",
#:   "You know how hens run at the feed bucket. That was him. I drive the vaccine lorry, and the village lad whose job it is to open the barrier wanted to be first to greet me. So he runs from his hut into my lane, and he runs up the lane at me as fast as he can go, grinning. I'd to stop dead.",
#:   "She didn't want to be rescued from the rain, nor did she want to reach the other side. The young woman who rushed off the verge, all mud, spun to face the robotaxi and sprinted towards it, along its lane, between its headlights, wanted only to stop it; and it did stop, with her palms flat upon its bonnet.",
#:   "In my village there is one man, his head is not right. When he sees a white car he thinks it's his brother who owes him. Yesterday he came out running, stood not, turned in my lane to my side, and full speed he ran to my car from the front only. I took reverse gear, what else.",
#:   "bodycam and dashcam synced, its wild. suspect jumps the barrier running, officers think hes gonna cross. nope. he hooks a 90 in the cop car's own lane and SPRINTS at it, right down the middle, dead at the pushbar. officer driving just goes \"hes coming at us\" super calm and stops. thud",
#:   "Off the kerb running, then down our lane at our badge.",
#:   "Turned to face us mid-lane and came, full pelt.",
#:   "Runner in lane, course reversed onto us, sprinting, closing.",
#:   "I'd have understood if he had run over the road, but he ran in, squared up to me and came hammering along the lane.",
#:   "Make the woman dash from the pavement to the centre of the lane, swivel towards the ego, and tear up the lane to meet it.",
#:   "We were doing nothing, we'd stopped, and still the distance shrank, for the runner in our lane had turned and was rushing us.",
#:   "V1's front was approached on foot, at speed and from straight ahead, by a person who'd run from the roadside into V1's lane.",
#:   "Who leaves a perfectly safe verge to get in your lane at a run, and then thunders down it with his eyes on your number plate?",
#:   "He jumps in the road courant, he turns himself against me, and he arrives in the axis of my voiture, always more big, the knees high.",
#:   "There are two palm prints in the dust on my bonnet, one each side of the star. They've been put there by somebody coming from the front, and coming fast. He'd been at the edge of the field with the others. He ran down into the road, and then along the road, my lane of it, with the prints ahead of him.",
#:   "I've thought since of all the ways he could've gone. Across. Back. Along with us, if he fancied a run. Having rushed out into my lane he picked the remaining one, which is to put his face to the traffic, that is to say me, and gallop at it. I reversed the van. He was gaining on it.",
#:   "The lads call it a pitch invader. Gate opens, bloke in a bobble hat legs it onto the tarmac. Stewards reckon he's making for the away end over the road. Next minute he's hung a sharp one, he's in our bus lane and he's steaming up it at our windscreen, shirt off, and the driver says quietly, \"I don't believe this.\"",
#:   "It's nothing personal, he wanted our taxi. At the airport they don't wait their turn. Out he came from the rank at a trot, then he had my lane under his feet, then he bent his course to suit, and the trot was a sprint, tie over the shoulder, suitcase bouncing, dead for my bonnet till I'd brought her to a halt.",
#:   "Relative speed 6.2 m/s, own speed 0. The AV had come to a stop as soon as the man, running in from the left, reached our lane. A crosser, we'd labelled him. The label was withdrawn on the next frame, for his velocity vector had swung through ninety degrees and pointed along the lane into our front camera. There it stayed.",
#:   "Ever been run at by a man in a gorilla suit? Students. He's out of the bushes and on the road, bounding. I stop the Corsa to let him over, it's rag week. Over? He gets in the middle of my lane and does a quarter turn and comes right at me, on all fours, growling, right up my lane.",
#:   "In the matter of whether he was hit or did the hitting: the claimant emerged from the garage forecourt at a run. He didn't persevere towards the other side. He took to the lane in which the stationary lorry stood, faced it, and ran its way as hard as he could, at the end of which he met with its bumper.",
#:   "He had my dinner in his hand. That I learned later. What I, at the wheel, could see was a cook with a chopper, as I thought, bursting onto the street, wheeling round towards me in the middle of my lane and coming on at a dead run, white hat gone, headlamps on his teeth, with nothing between us but tarmac.",
#:   "For this attack scenario the order is: run in from the roadside; upon reaching the ego's lane, rotate by a quarter turn so as to oppose the ego; advance along the lane centre, at the sprint parameter, upon the ego's front. The pedestrian doesn't leave the lane sideways and doesn't stop short. The ego has to cope.",
#:   "Feet, heavy ones, louder and louder, though I was standing on the brake and nothing of ours was moving. They'd started on the left, on gravel. They'd gone onto asphalt, quick as you like. And from there on they came out of the fog exactly ahead of me, in my own lane, with a big woman on top of them, hallooing.",
#:   "Children who want to say hello to the fire engine run beside it. Leo is three. Leo ran down off the lawn and into the lane, the fire engine's lane, and as he loves it, he turned to it and ran to hug it, at the top of his speed, arms out, in the middle of the road. We've moved to a cul-de-sac.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["wrong-way", "fast"]
#: place = "road"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.5
#: high = 6.0
#: unit = "m/s"
#: meaning = "how fast it runs"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 32.0
#: high = 50.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 1.5
#: high = 2.6
#: unit = "m"
#: meaning = "how far from the ego's line it turns into the lane"

param OPT_ADV_SPEED = Range(3.5, 6)
param OPT_ADV_DISTANCE = Range(32, 50)
param OPT_ADV_REACH = Range(1.5, 2.6)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 5
    do MoveAhead(2.5) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    # A quarter turn against the ego's direction, from whichever side it comes.
    do MoveAhead(globalParameters.OPT_ADV_SPEED, -1.57 if offsetFrom(egoRoute, self) > 0 else 1.57)
