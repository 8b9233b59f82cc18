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
