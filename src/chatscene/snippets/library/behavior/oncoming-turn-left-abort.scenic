#: description = "The oncoming car turns left across the ego's path, stops, and reverses."
#: rephrasings = [
#:   "he swings left in front of us, panics, and backs off again",
#:   "Vehicle 2 initiated a left turn from the opposite direction, stopped, and backed up.",
#:   "opposing left turn aborted, halts, reverses",
#:   "The oncoming target turns left into the path of the VUT, comes to a standstill and moves rearwards.",
#:   "The truck from the contrary direction turns left, then it stops and goes back in reverse.",
#:   "A bus facing us thinks better of its left turn and retreats.",
#:   "The van coming the other way breaks off its left turn and rolls backwards.",
#:   "Halfway through turning off to its left, it gives up and withdraws.",
#:   "He started his left turn over my path, bottled it, stopped and then backed up.",
#:   "Opposing Unit 2 began a left turn across Unit 1's path, stopped mid-turn and backed up.",
#:   "Opp. truck L-turn across ego, halts, reverses out.",
#:   "The oncoming target starts a left turn through the VUT's path, comes to rest and then moves rearward.",
#:   "The bus from the front turns left before me, stands, and drives again backwards.",
#:   "Oncoming left-turner aborts mid-turn: stop, then reverse gear back the way it came.",
#:   "He'd swung halfway across her, lost his nerve, stood there a moment and then scrambled backwards.",
#:   "He's turning across you, no, he's stopped, and now he's going back on himself, wait for him to sort it out.",
#:   "he started turning left in front of us, panicked, stopped and went backwards lol",
#:   "The approaching coach abandoned its left turn half done and retreated in reverse.",
#:   "You commenced a left turn before the oncoming plaintiff, you halted, and you then retreated backwards?",
#:   "Opposite lorry started to turn left in my path, then stopped and gostan back.",
#:   "Starts his left across me, gets cold feet, sits there, then out comes the reverse.",
#:   "Abandoned left turn of opposing vehicle with rearward withdrawal from ego path.",
#:   "STARTS LEFT TURN, CHICKENS OUT, REVERSES",
#:   "The oncoming truck bit off a left turn, halted and recoiled.",
#:   "Oncoming coach angles left over our path, halts, backs away.",
#:   "Facing SUV: left across ego, full stop, withdraws in reverse.",
#:   "It wants left through my way, stands still, then drives backward.",
#:   "Left he came, before us; stopped; and went astern.",
#:   "Let an opposing lorry cut left over us, cease, and reverse.",
#:   "The cab from the opposite direction pulled left across the nose of the AV, came to a stand and then, beeping, backed out of it again.",
#:   "A pickup that had been coming to meet us started off to its left right through our lane, stopped as though stung and went into reverse.",
#:   "Driver of V2 stated that he began turning left ahead of oncoming V1, realised his mistake, stopped his vehicle and put it into reverse gear.",
#:   "The big bus facing us hung a left into our road space, got stuck with its own doubts, and returned stern first to where it started.",
#:   "Look at that for manners: van opposite turns left before you, sees you, stops, and reverses so as to let you by.",
#:   "From straight ahead, a left turn which takes it over the ego's route; there it pauses at zero speed and retracts on the same arc backwards.",
#:   "I was heading up the high street and a removals lorry was coming down it. He swung left in front of me for the station yard, but the gate was shut, so there he stood across me. In the end he put it in reverse and drew it back.",
#:   "The opposing target awaits the VUT's approach, then follows a left-turn path that intersects the VUT's lane. It is stopped by moderate braking at the conflict point, stands for half a second, and is thereafter driven rearwards for the specified time, where it remains.",
#:   "Your Honour, the other car approached from ahead of me. It turned to its left, which put it in my path, and I braked. It then stopped, and I waited. The white lamps at the back came on, and it travelled backwards, and only then could I go on.",
#:   "Like a bear that has put its paw in the wrong hive, the huge truck which had been coming at them bent its snout left across their lane, stopped dead, and after a moment's reflection began to draw the whole of itself backwards out of it.",
#:   "pro tip if someone facing u goes left across ur bows and then just freezes, don't scoot round him. mine froze and next second the reverse lights were on and he came back the way he'd come, if I'd gone behind him he'd have hit me",
#:   "Facing van bends left over our lane, stalls out, backs away.",
#:   "Oncoming pickup: left across us, dead stop, into reverse.",
#:   "Bus opposite starts left, blocks us, stops, reverses off.",
#:   "A minibus coming the other way began to cut across to its left, came to a stand with its nose in our lane and then drew that out backwards.",
#:   "So this SUV facing me goes for the left turn right in front of me, chickens out, sits there, and then rolls back in reverse.",
#:   "The opposing target's left turn is interrupted inside the VUT's lane; after a short standstill at that point the target is moved rearwards and finally held.",
#:   "He's going left through your path, he shouldn't, now he's pulled up, and what's that, reversing lights, so give him a moment to get out backwards.",
#:   "Opposite lorry had put his face to left in my path; seeing me he halted, then slowly slowly he is taking back gear.",
#:   "I'd like the oncoming car to break off its left turn over the ego's route by coming to a stop and then backing up a bit.",
#:   "My coffee and I were going straight on. A removals truck coming from where I was bound hauled itself round to its left, all over my lane, and I stopped the car with a jerk. It stopped as well. We looked at each other, and he must've been a gentleman, since the beeper began and he gave me back my road, rear end first.",
#:   "The event was reconstructed from V2's own telemetry. V2 approached head on, initiated a left turn with 210 degrees of steering wheel angle and was at zero speed when its front axle lay within V1's lane. Gear selector R was engaged after 0.6 s, and V2 travelled rearward for 3.1 metres.",
#:   "I thought he'd seen me, he thought I'd seen him, and you can guess the rest. He swung his taxi to his left from the opposite lane, right over my way. When our eyes met he'd his brakes on and was standing there; when I'd breathed out he was retreating, one arm over the passenger seat.",
#:   "The gates were locked, but he wasn't to know it. He'd been coming towards us up Quay Street in that long lorry, and the yard is on our side, so left he went, over us, and there he had to halt with his bumper at the chain. White lights, and inch by inch the trailer shoved itself back the way it had come.",
#:   "For the first three seconds the bus does as any left-turning bus might that meets you, filling the windscreen from left to right. It's the next three that people rewind. It is no longer moving, and then the windscreen begins to empty again from right to left, because the driver has put her into reverse.",
#:   "Don't squeeze round behind a person in two minds. That estate facing you has gone left over the front of us and frozen, right? If you'd nipped round its tail you'd have met it coming the wrong way, since see, it's going backwards now, out of your path and into the place it had left.",
#:   "In the matter of the blocked tram road, the passenger said this. \"The coach was coming against us and he turns left, before us. Then he is afraid of something and stands. We wait, he waits, and after he drives with the back forward till our lane is free.\"",
#:   "When you're small you see only roofs, and the roof I saw was yellow. It had been coming to us and then it went sideways in front of Mummy's car, to its own left, and it stuck there. Mummy said a word, and the yellow roof slid away again, backwards, like when you wind a film back.",
#:   "I've given way to a good many things in my time, though never to a person's change of heart. The small grey car that was to meet us struck off leftward across our front, and no sooner was it squarely in the road than it stood. It thought. Then it withdrew, stern foremost, with a whine, and the lady in it nodded to us.",
#:   "Please reproduce: oncoming left-turner yields too late. It enters our corridor on its turning arc, brakes to nothing there, and since that would block us for good, it must reverse out along the arc after roughly half a second. End state is the actor parked clear of our corridor, not completing its turn.",
#:   "The skid is mine, the oil stain is his. He'd come from the front and made his left-hand turn into my lane, as far as the drain, and that's where the van stood and dripped. The second stain, two yards nearer to where he'd started, is from after he'd backed up, when he waved me by.",
#:   "Facing pickup: left over our road, cold feet, halt, astern.",
#:   "He cuts left across us from ahead, freezes, then reverses out of it.",
#:   "Coach opposite noses left over our way, sits, backs out.",
#:   "A removals van that had come to meet us closed our lane with a left turn, thought for a moment in the middle of it and reopened it in reverse.",
#:   "Opposing target: left-turn path through the ego's corridor, braked to rest at the conflict point, 0.5 s dwell, reverse motion for the set time, then hold.",
#:   "mans coming at me, goes left right across my nose, panics, dead stop, then i see the white lights and he's undoing the whole thing",
#:   "From opposite side the tanker put its nose left in my way, then seeing me stood frozen, then with tun-tun-tun music it went backside and gave me road.",
#:   "The side of a bus was all I saw, it had come from in front and gone to its left; then the side stood still, then it withdrew backwards.",
#:   "If you meant to turn left through my client's lane, sir, and came from the opposite direction to do it, why did you stop there and then retreat in reverse?",
#:   "Count the letters on the side of the lorry, that's how I'd tell it. It had been coming down as we went up, face on, so no letters. Then it went off to its left over our lane, and I read R, RE, REMOV, and with REMOV it had come to a halt. I sounded my horn; a beeper answered, and it went REM, RE, R, the other way.",
#:   "He'd been heading towards me with his left blinker going, and he took his turn as though I weren't there, so that was my stop. Then he saw that I was there, so that was his. I waited for him to clear off over to the pub, but his tail came back to where it had started and his bonnet with it.",
#:   "In the overhead sequence V2 leaves the facing lane on a left-hand arc. Arc length at the moment of greatest intrusion is nine metres; speed there, nil. In the remaining pictures, which begin with the illumination of its reversing lamps, arc length goes down to five, and V1's lane, which had been shut at nine, is open.",
#:   "I was holding the bus on the hill because a great long furniture wagon, which had been coming up to us, was hung out to its left across my half, not moving. Then I saw the mate jump down and walk behind it, waving. He walked it back off my half, foot by foot, along the way it'd come on to it.",
#:   "The ambulance ran forty seconds late and this is the reason, as its attendant tells it. A taxi coming the other way had gone into its left turn ahead of them. It had got the ambulance's lane thoroughly covered when the driver lost his head and stalled. He'd the sense, then, to put it in reverse and not to finish; they went through where his bonnet had been.",
#:   "My sister is learning and I sat behind. She'd a school run mother facing her, big car, and that mother simply went for it, left, through our bit. Our brakes, her brakes, two noses a yard apart, nobody moving. The instructor said, \"Wait, she'll give it up,\" and true enough the big car rolled off backwards out of our bit and the mother mouthed something.",
#:   "In planning terms the crossing was offered, refused and withdrawn. The opposing truck committed itself to a left turn over our lane at a gap that was too small. It came to rest with four metres of chassis inside the lane. Our planner was about to route behind it when the classifier saw white lamps; the four metres became two, then nought, as it went back along its own curve.",
#:   "If one turns a page and sees it's the wrong page, one turns it back. So did this monsieur with his minibus. He came from before us, he turned to his left, I have all his flank in my windshield and I do stop. He regards his paper, he stays; it's the wrong street, and he turns back the page, the behind first, and I have my road again.",
#:   "The dent isn't from him, it's from the fellow behind me. Him I've nothing against. He was coming from the other end, he chucked a left over my lane for the tip, and when the tip was shut he could only stand there and look at the chain, and I stood there and looked at him. He'd already begun reversing out of my way when the fellow behind me arrived.",
#:   "The post van never got as far as the gate, on our side of the lane. It had driven down to meet us, had swung left over the front of us for it and had pulled up, so very nearly there. The driver shook her head at the mud. And then she went astern, blue wing and all, till we could get by.",
#:   "The coach had come round the shoulder of the hill, facing them; its whole length had begun to go by to the left, from wing to wing of their windscreen, as scenery does; the scenery stopped. For the time of a held breath it hung there across their lane. Then it was drawn off again by the way it had come, to a sound of bells.",
#: ]
#: adversaries = ["car", "truck", "bus"]
#: requires = ["advMeeting", "advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "turn-left", "stop", "reverse"]
#: position = "oncoming"
#: maneuver = "straight"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 0.0
#: high = 25.0
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
#: low = 5.5
#: high = 8.0
#: unit = "m"
#: meaning = "how far beyond where their ways meet it comes to rest"
#: [[parameters]]
#: name = "OPT_ADV_BACK"
#: low = 1.5
#: high = 3.0
#: unit = "m/s"
#: meaning = "how fast it backs up"
#: [[parameters]]
#: name = "OPT_ADV_BACK_TIME"
#: low = 0.8
#: high = 2.0
#: unit = "s"
#: meaning = "for how long it backs up"

param OPT_ADV_DISTANCE = Range(0, 25)
param OPT_ADV_SPEED = Range(5, 8)
param OPT_STOP_DISTANCE = Range(5.5, 8)
param OPT_ADV_BACK = Range(1.5, 3)
param OPT_ADV_BACK_TIME = Range(0.8, 2)

advTurn = "left-turn"

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE + 7 * distanceLeft(advTrajectory, self, advMeeting) / globalParameters.OPT_ADV_SPEED
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(advTrajectory, self, advMeeting) < brakingDistance(self) - globalParameters.OPT_STOP_DISTANCE
    do BrakeOnPath(advTrajectory) until self.pose[3] < 0.05
    do Halt() for 0.5 seconds
    do ReverseStraight(globalParameters.OPT_ADV_BACK) for globalParameters.OPT_ADV_BACK_TIME seconds
    do Halt()
