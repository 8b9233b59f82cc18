#: description = "The oncoming car starts to turn left across the ego's path, pauses, and then goes on."
#: rephrasings = [
#:   "he starts his left turn, sees us, stops, and then goes anyway",
#:   "Vehicle 2, approaching from the opposite direction, began a left turn, halted momentarily, and completed it.",
#:   "opposing left-turner dithers in the middle, then completes",
#:   "The oncoming target turns left across the path of the VUT with a short standstill in the turn.",
#:   "The car in front of us from the other side turns left but he is not sure, makes a pause and continues.",
#:   "A lorry facing the ego swings left in two goes, with a doubtful halt in between.",
#:   "The biker coming the other way wavers halfway through his left turn.",
#:   "It begins to turn off leftward against the traffic, loses its nerve, and then finishes.",
#:   "she began to turn over in front of me, lost her nerve for a second and then finished it anyway",
#:   "The oncoming vehicle initiated a left turn across V1's path, paused mid-turn, and then completed the turn.",
#:   "Opp. bus: starts L, stops short, then on.",
#:   "The oncoming target begins a left turn across the VUT's path, interrupts it briefly and then completes it.",
#:   "The car from front starts to go left before me, waits a little in the middle, and then goes.",
#:   "LTAP/OD with dwell: turn start, short pause in the conflict zone, resume.",
#:   "The ambulance had begun its turn before them, checked as if in doubt, and then went through with it.",
#:   "He's turning left over you, he's stopped, is he letting you by? No, he's carrying on with it.",
#:   "car from the other way started turning left, froze for a sec, then went anyway",
#:   "An approaching driver began his left turn, wavered in front of traffic, and then completed it",
#:   "You set out upon the left turn, you paused in the path of the claimant, and thereafter you resumed?",
#:   "Opposite car turning left in front of us, then stop to think, then go again, aiyah",
#:   "Starts his left over me, bottles it, has a breather, and then he finishes the job",
#:   "Interrupted left turn of opposing traffic: start, pause, continuation",
#:   "Oncoming ambulance starts a left, FREEZES, then goes",
#:   "The motorbike facing us began to peel left, faltered, and finished.",
#:   "Opposite us a van goes left, sticks halfway, eventually clears our path.",
#:   "Opposite bus half-turns left in our path, waits, resumes.",
#:   "Make the approaching motorbike turn left, freeze briefly, then carry on.",
#:   "In front of the AV the oncoming cab's left turn stalls momentarily, then continues.",
#:   "He set off left over my road, stopped to think, then went.",
#:   "A fire engine facing us swung its nose left through our path, held there as if unsure, and eventually rolled on out of it.",
#:   "The truck against me starts with turning to the left, after two metres it stands, thinks, and then it makes the turn until the end.",
#:   "Left-turning opposing traffic is to stop briefly with its front in the conflict area before clearing it at the original speed.",
#:   "She's turning left over us from the other side, she's had second thoughts, wait for it, and now she's changed her mind again and gone.",
#:   "The left turn took place in two helpings: the saloon coming toward me put its front over, took fright, then finished the manoeuvre.",
#:   "Is he coming or isn't he, this lorry opposite, half into his left and at a stand, ah, now he goes?",
#:   "I was going straight and a hatchback came up on the other side, wishing to go to its left. Out it came; it must have seen me, since it stuck in the mouth of the turn a moment before pushing on over my lane.",
#:   "V2, oncoming, entered a left turn toward Mill Lane. Its driver applied the brakes and paused in front of V1's lane for an estimated two seconds, reportedly to assess V1's distance, whereupon V2 was driven on to complete its turn.",
#:   "Some turners commit, some don't. The motorcyclist meeting us here starts to his left, brakes to a stop with the wheel already over, dithers like a hen, and when you believe he's letting you by, he goes over after all.",
#:   "Negotiation ticket. The ambulance comes opposite, initiates a left through our trajectory, halts for a random dwell of one to three seconds so the planner thinks it yields, and then it does proceed across and away.",
#:   "The bus driver from the opposite side put his indicator and was taking left across my lane. Then he stopped half way, he looked at me, I looked at him, and only afterwards he completed his turning.",
#:   "The facing cab turns left, freezes over our path, then finishes.",
#:   "He began his left, stuck halfway, and went after all.",
#:   "Left-turner from ahead: out, dead stop, a think, off again.",
#:   "From the other direction a tram-replacement bus put its nose leftward over our lane, stood a moment, and only then took the rest of the turn.",
#:   "Let the approaching motorcycle enter its left turn in front of us, check to a standstill, dither for a second or so, and resume.",
#:   "The driver facing me started round to his left, got cold feet with his bumper in my lane, and then gathered his courage.",
#:   "He wanted left from opposite, he drove a bit, he stayed, I thought he lets me, and then he drove all the rest before me.",
#:   "Is she turning left or isn't she? That estate opposite has swung at us, pulled up dead, and, hang on, now it's going through with it.",
#:   "An ambulance, coming the other way, commenced a left across unit four, came to rest partway, waited, and subsequently cleared to the side road.",
#:   "I had the eyes of that lorry driver on me throughout. He'd been coming toward me with his left flasher on and had turned in as far as the crown of the road, and there the lorry knelt. We studied one another. When I eased off the brake to go, so did he, and all eighteen wheels followed him round over my lane.",
#:   "A hearse has no business being undecided. This one, which we were about to meet, veered off leftwards for the cemetery lane, so that its flowers were nearly on our bonnet; then it stayed there, purring; then, when we had come to a stand out of respect or fright, it resumed and slid off between the gates.",
#:   "Scenario 31, description of the conflict: actor comes from opposite, heading for the road on its left-hand side. It gets roughly a third of the arc done. Zero speed, two seconds. The remainder of the arc. I've seen planners that take the two seconds as an invitation, and they all hit it in the rear door.",
#:   "There's a kind of courtesy that kills. The coach coming our way had made to cut over to its left, into the hotel, and pulled up short when it saw us. \"He'll wait,\" says my pupil. He did, for about as long as it took her to say it. And he carried on, so it's as well I've got a brake too.",
#:   "Half of a fire engine stood in my lane, the front half. It had been facing me as it came, it had leaned over to go left to the dock road, and there the crew had evidently disagreed about the address. One of them pointed. With that it was in motion once more, and in the end the back half passed me as well.",
#:   "V2, westbound, began a left turn in front of V1 and halted after its front had entered V1's lane. The operator of V1 reports he understood V2 to be yielding. Following a pause estimated at two seconds, V2 proceeded with the turn. The point of impact was the right rear quarter panel of V2.",
#:   "He who hesitates, the proverb says, and I was thinking of it when this scooter, coming the opposite way with a cake tied on behind, tipped to its left into the lane I was in and stopped there as if somebody had whistled. The cake wobbled. A second or two later both were off again, over to the bakery street.",
#:   "If you fast-forward to 3:40: minivan coming at me, blinker, begins to go left over my lane. I'm on the brakes. At 3:42 it's not moving. I'm thinking cheers pal. At 3:44 it is moving, same direction as before, and it completes the whole turn with me sliding at it. So who's at fault?",
#:   "On a bike you read front wheels. The saloon that I and the taxi were about to meet turned its wheels left and came out over the taxi's lane, and the wheels stopped; they didn't straighten, though, so I thought, don't trust that. And truly, when it'd finished making up its mind it rolled on round.",
#:   "Grandmother was telling it with her cake fork. \"Here am I. There, in face, he comes, and he makes so, to left, through me. And then?\" The fork stood still upon the tablecloth. \"Nothing! He is thinking. I'm praying.\" It moved on, in the same curve, to the edge of the plate. \"And then he goes, the donkey.\"",
#:   "By the second standstill of the day our robotaxi had learnt nothing. A post van came along the other carriageway and turned left for the sorting office, over our path, or partly; it stopped short, so did we; it stayed, so we edged; it set off again to finish its turn, and we stood on everything.",
#:   "Opposite lorry: half a left turn, a think, the rest.",
#:   "She set off left through us, froze, then finished it.",
#:   "Turning across from ahead: go, no, go after all.",
#:   "The cab facing us cut its wheels over for its left and came, then knelt on its brakes before our bumper; I thought it was yielding, and it slid on by.",
#:   "For one whole second a police bike stood in my path, halfway through its left from the opposite direction, and then the rider gave a shrug and completed it.",
#:   "Make the opposing minibus leave its side for the left-hand road, come to a stand while only its front half is in the way, dwell, and take itself off.",
#:   "He comes opposite, he goes into his left, in the middle he is standing like a donkey, and when I want to go he goes also, on, into the small street.",
#:   "Two gestures I got from the driver who wished to turn over my lane from ahead: a raised palm, as the van halted halfway, and a wave as it moved off again to finish.",
#:   "Opposing coach has commenced a left-hander ahead of unit nine and stuck there; disregard, it's going again, it is clear into the side road now.",
#:   "It was a matter of three noises. An engine, taking its chance from the other side, with the tyres squirming over to its left. A hush, with that big blunt bonnet planted in the lane I was about to use. I filled the hush by swearing. And then the engine anew, and all the rest of the fire tender going by, left, to the quay.",
#:   "If it hadn't been for the stop in the middle we'd never have touched. A saloon that comes toward you and cuts left over your road in one go, well, you brake, it's gone. This one's brake lights I couldn't see, but its nose went down and stayed down; I read it as \"after you\". I went. It went, the way that it had been going.",
#:   "The test person's diary: 14:10, bus from the opposite direction swings in front of us, we brake. 14:10 and two seconds, bus has its front wheels in our lane and isn't turning them. Driver drinks. 14:10 and four seconds, our taxi decides it has been let through. 14:10 and five, it hasn't, the bus is off round the rest of its corner.",
#:   "You're right that he stopped. You're wrong that he stopped for you. He'd been coming the other way, he'd started to cross over for Mill Lane, and what pulled him up was a pushchair at the far end of it. So when it's gone, off he'll go. And there you are, the horsebox is on the move again, round and away. Patience costs nothing.",
#:   "On the sketch which I enclose, position 1 shows the motorcycle facing me, beginning to lean. Position 2 shows it upright, both boots down, on my half of the road; I've marked that one twice because it was there for a good two seconds. Position 3 is the mouth of Abbey Street, to the rider's left. I am the dent between 2 and 3.",
#:   "When the hearse began to come round before us, the coffin was pointing at the opposite kerb. It then pointed at us for a while, or rather at our radiator, since the driver had lost faith and brought everything to a halt halfway. My uncle took off his hat. The coffin moved, turned its end to us, and was borne off along the left-hand street.",
#:   "Is it yielding? That's a question that planners put by means of speed, and the speed of this oncoming pickup says yes: zero, halfway into its left. The wheels say no, they're still at thirty degrees. The history says no, it came off its lane without slowing. After 1.7 seconds the pickup gives the answer itself and clears our path under power.",
#:   "My brother is a great man for courtesy and he took the pause as a courtesy. That a laundry van had come from the other way and put half of itself in his lane, to get over into the hospital road, he forgave; it'd stopped, hadn't it? He lifted his hand to thank it. It carried on into the hospital road, with his wing mirror.",
#:   "Deposition, page 4. A. She was coming toward me. She went to turn left. Q. In front of you? A. In front of me. And she changed her mind. Q. She went back? A. No, she just sat, turned-in like. Q. How long? A. Long enough I thought I'd go. Q. And what did she do? A. Changed it again. Went on through. Q. Like before? A. Like before.",
#:   "In the mirror of the shop I watched the ambulance, because I cut hair and I was bored. It arrives from the right, it bends over the street, so the little car that's coming from the left must brake. It stands with the snout in the little car's way. One snip, two snips. It completes its bend and goes down past the church, and I've cut too much.",
#:   "yo why do left turners do this. suv coming at us, blinker on, goes, so we brake. then it STOPS, like fully parked across half our lane, blinker still goin. we wait. it waits. we start to roll and obviously thats when it goes the rest of the way. mind games",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "Euro NCAP car-to-car front turn across path; own code"
#: [slots]
#: actions = ["oncoming", "turn-left", "hesitate"]
#: position = "oncoming"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 10.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when the adversary gets there"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 8.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = -1.0
#: high = 3.0
#: unit = "m"
#: meaning = "how far beyond where their ways meet it pauses"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.4
#: high = 1.0
#: unit = "s"
#: meaning = "how long it pauses"

param OPT_ADV_DISTANCE = Range(10, 30)
param OPT_ADV_SPEED = Range(5, 8)
param OPT_STOP_DISTANCE = Range(-1, 3)
param OPT_STOP_TIME = Range(0.4, 1)

advTurn = "left-turn"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 8.5 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED)
