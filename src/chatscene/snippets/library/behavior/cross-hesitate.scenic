#: description = "The pedestrian starts to cross, hesitates in the lane, and goes on."
#: rephrasings = [
#:   "A person steps out, pauses on the carriageway in doubt, and then finishes crossing.",
#:   "The pedestrian stops midway for a moment and afterwards continues over the road.",
#:   "Halfway over, the walker falters, waits briefly, and carries on.",
#:   "The cyclist sets off across, pauses, and resumes.",
#:   "The adversary enters the lane, stands undecided, then moves again.",
#:   "She sets off across, gets cold feet for a second and then keeps going.",
#:   "The pedestrian paused in the travel lane before completing the crossing.",
#:   "ped crosses, stops briefly, carries on",
#:   "This old boy set off over the road, dithered halfway across my lane, then carried on.",
#:   "Pedestrian began to cross, paused momentarily in the lane of travel, and proceeded to the other side.",
#:   "Cyclist crossing, has second thoughts mid-lane, then continues.",
#:   "The pedestrian dummy starts crossing, stops briefly once within the lane, then resumes in the same direction.",
#:   "She starts to go over, in the middle she is not sure, then she goes further.",
#:   "Crosser does a single short wait in our lane, then finishes the crossing.",
#:   "He had got as far as her lane when his courage failed; he wavered for a heartbeat, then pressed on to the far side.",
#:   "She's stepping out, she's in two minds about it, wait for her, okay now she's off again.",
#:   "she was crossing then was like uhh do i go or not and then went",
#:   "A cyclist appeared to falter in the middle of the lane before completing the crossing.",
#:   "She set out, she wavered once, I stress once, and then she completed her passage.",
#:   "Crossing halfway he got confused for two seconds, then he continued only.",
#:   "Make your mind up, love! Starts over, has a little think in front of my cab, then off she trots.",
#:   "Momentary indecision of crossing person in lane, followed by completion of crossing",
#:   "PEDESTRIAN LAGS MID-CROSSING then reconnects",
#:   "The man stepping over falters and then proceeds.",
#:   "Walks out, freezes for a second before us, walks on over.",
#:   "Moped crossing, stalls with doubt in our lane, then clears it.",
#:   "Jogger halts in mid-lane, unsure, then finishes going across.",
#:   "Ped X-ing, brief stop in lane, continued other side.",
#:   "The deer-in-headlights moment: kid crosses, locks up, crosses on.",
#:   "A woman with a pram left the pavement, came to a halt in front of our bonnet as if wondering, then pushed on to the opposite kerb.",
#:   "The pedestrian target shall interrupt its crossing inside the VUT's lane for a short interval and subsequently resume in the original direction.",
#:   "Let the old man come over the road, lose his nerve when he's right in the AV's lane, and after a moment keep walking to the other side.",
#:   "Midway she remained standing and looked at me, I looked at her, nobody knew what to do, and then she did walk the rest of the way.",
#:   "Caller says a lad pushing a bike across the road stood still for a second right in his lane before making his way to the far pavement.",
#:   "The person is crossing, inside of our lane he is stopping because he does not know if the car will brake, then he is going to end.",
#:   "I was coming down past the church when an elderly gentleman started across from the left. Right in line with my car he pulled himself up and looked both ways, clearly wondering if he had time. Then he made up his mind and carried on to the other kerb.",
#:   "The cyclist had already come half the distance when she caught sight of us and put her feet on the ground, not knowing whether to trust our brakes. A breath later she pushed off again and disappeared between the parked cars on the opposite side.",
#:   "According to the transcript, the witness set out over the carriageway, ceased walking once within the lane of the subject vehicle because she doubted whether it had seen her, and after an interval of perhaps one second proceeded the remaining distance to the other footway.",
#:   "See this lady here, she's committed to crossing, so you ease off. But look, now she has planted herself in our lane, she's doubtful about you. Don't wave, don't hoot, just hold back; there, she's walking again and she's nearly across.",
#:   "The interesting thing about this clip is the pause. The man doesn't turn round and he doesn't run; he gets into our lane, his feet stop, you can see him weigh it up, and then he simply completes the trip over to the bus stop.",
#:   "Gran set off over the road, wavered before us, then finished.",
#:   "Mid-lane he clean forgot himself, briefly, before walking the remainder.",
#:   "Moped crossing; dithers once on our path; gets across.",
#:   "Schoolgirl came over from the left, her feet stuck for a second right in line with the bonnet, then they took her to the other pavement.",
#:   "At trial the cyclist admitted that he had checked himself in the lane for an instant, torn between the two kerbs, and thereafter gone over.",
#:   "Could you do a jogger that runs over the road, is briefly rooted to the spot ahead of the ego, and afterwards continues to the opposite kerb?",
#:   "The uncle is crossing nicely, in front of our vehicle he is getting doubt and standing, two seconds only, after that he is reaching other side.",
#:   "Because the lad with the scooter lost heart in front of us for a breath before pushing on over, I had to brake harder than I'd planned.",
#:   "Pedestrian trajectory: start at left kerb, one zero-velocity interval inside the ego lane, same heading resumed, end at right kerb.",
#:   "I'd have gone behind her if she had only kept walking. She came down off the pavement by the chemist's, got as far as my half of the road, and there her legs wouldn't do what she told them. It lasted no longer than a blink or two. Then she tucked in her chin and went on to the other side.",
#:   "There was a rhythm to it, three steps, four steps, and then no step where the fifth should have been. I was on my brakes by that time. The man's hat turned towards us and back, and the fifth step came after all, and the sixth, and so on till he was among the bins on the far pavement.",
#:   "The crossing child entered the roadway ahead of V1 and was observed to stand within V1's lane for roughly one second. When asked, she said she hadn't known whether the car would stop. She went on in the direction she had been going and attained the opposite sidewalk unhurt.",
#:   "Cyclist here. I was halfway over on my way to the greenway when I spotted the robotaxi and froze with one foot on the tarmac, since you never know with those things. It was slowing, so I clipped back in and rolled the rest of the way over. No drama, but I'd like to know what it saw.",
#:   "Right, the pram lady, she's set out from your left and she's going over, fine, so you hold back for her. Then you thought she'd be clear by now, didn't you? She isn't, she's in your lane with her mouth open. And there we are, wheels turning, she's off to the far kerb.",
#:   "Our footage from the tram stop is odd. In frame 200 the man is a stride inside our lane, in frame 230 he's at precisely the same spot, and in frame 260 he is three strides further on, with his back to the side he came from. He ended up across, as he meant to.",
#:   "My husband never wavered in his life, but that pigeon of a motorcyclist did. He came trundling across from the farm track, and in front of our car he put the brake on and gaped at us as though we'd asked him a riddle. Presently the answer came to him and he trundled on into the field opposite.",
#:   "We propose a crossing actor with a single lapse of confidence. It leaves the kerb as any other would, it becomes stationary for a short while when it is before the vehicle under test, and it then carries through the crossing as originally intended. It neither turns nor repeats the halt.",
#:   "Dad was talking about the football. A boy with a schoolbag was going over the street and Dad was slowing for him already, but the boy suddenly stood like in musical statues, right where our car wanted to go. Then the music must have started again, because he went over to his friends on the far side.",
#:   "In my taxi I have a golden rule, never trust the ones who look at you. This señora came from the right side to cross, she looked at me, and her shoes remained glued, exactly in my lane. I waited, she made a little smile, and she ended the crossing to where the pharmacy is.",
#:   "It was the gap in the footfalls on the wet road that made him raise his head. A figure was in the lane before the van, one hand half lifted, as though it had mislaid the purpose of its journey. Then the footfalls took up again, went on across, and were lost under the trees of the other side.",
#:   "Lost her nerve for a second mid-lane, then completed her crossing.",
#:   "Jogger's footsteps: many, none, many. He reached the far side.",
#:   "Two steps from safety, the lad stalled before us, then took them.",
#:   "I had expected her to be past our bonnet by then; for a second she simply wasn't, and then, on the same course, she was.",
#:   "The crossing time came out one point four seconds too long, all of it spent upright and motionless in the ego's lane before the walk went on.",
#:   "Cyclist from right to left, trackstanding briefly in front of V1 with an uncertain look, thereafter onward to the left verge; one pause, no return.",
#:   "My dog pulled, and that is what got me going again; I'd stuck fast in the lane, unsure of the white car, on my way over.",
#:   "Could the pensioner please be given a moment of doubt, about when he is in line with our radiator, prior to finishing his way to the other kerb?",
#:   "Grandma says it was her shoe, but I saw, she looked at the cars and stopped in the lane and thought, and then went to the shop side.",
#:   "The lights of the van lit one half of her and left the other dark, and for a heartbeat neither half moved. She had been coming over so briskly. Behind the windscreen he was saying go on, go on, and as if she'd heard she took up her bag and went on, as far as the railings opposite.",
#:   "Should you brake for someone who'll be out of your way before you get there? Case in point: this student, left to right, nicely timed, no conflict. Except that he isn't out of your way, he is bang in it, doing a statue. A breath later he's a pedestrian again and he gains the other pavement.",
#:   "I lost an egg. That's how hard I braked, and all because my sums went wrong: at the pace he was pushing that bicycle over he'd have been gone. But his wheels quit turning as he came before my bumper and he gave me a stare. The wheels then remembered, carried him to the kerb he was bound for, and there was egg all over the mat.",
#:   "The insured states that the third party would have been well clear had she maintained her progress. She did not. Upon noticing the insured's car she faltered, remaining for an instant in its path with one hand upon her hat, whereafter she resumed and attained the footway she had originally been making for.",
#:   "There's a hole in the middle of the distance-time plot. From zero to two seconds the child covers three metres; from two to three it covers none, at a point that is on our centreline; from three to five it covers the remaining four. Sign of velocity never changes. We logged it as \"one doubt, no retreat\".",
#:   "My horn is very weak, it makes like a duck. The gentleman with the newspaper was passing over the street, I gave the duck, and it was the wrong idea, because he took root right where I must go. He folded the newspaper. Only when that was done he has continued, same direction, until the kiosk.",
#:   "Moped at walking speed, coming out of the nursery and over to the farm shop. I'd already lifted off for it. Its little stop lamp came on in the middle of my lane and so, in sympathy, did mine. He put the visor up. Down went the visor, out went the lamp, and off he puttered to his potatoes.",
#:   "Passengers, apologies for the sharp stop. A lady was nearly across and I was nearly past, as I thought; then she went and had an attack of the what-ifs in my lane. It's over now. She's standing safe on the opposite side, having walked the last bit, and giving us all a nice wave.",
#:   "He wanted to be on the other side, that was never in question, since on the other side was the dog. He got there as well. Between leaving the gate and hugging the dog, though, came that dreadful second in which he saw the lorry and it saw him, and neither his left foot nor his right would stir out of the lane.",
#:   "Nurse cycling home, dressed in dark. In the light of the AV she shows first as a moving reflector, then as a reflector that hangs still straight ahead, wobbling slightly, then as a moving reflector, and it leaves the picture on the side it was heading for. Ride log: comfort brake became hard brake during the middle phase.",
#:   "I teach it with chalk. Here's the kerb where the toddler's mum starts, here's the other, and the line runs straight from one to the other with a fat dot on it. The dot is in your lane. That's her standing there a tick, wondering whether you have seen her. The line doesn't stop at the dot, mind.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross", "hesitate"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.2
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 26.0
#: high = 58.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_STOP_DISTANCE"
#: low = 0.2
#: high = 2.0
#: unit = "m"
#: meaning = "how far from the ego's line it pauses"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.5
#: high = 2.0
#: unit = "s"
#: meaning = "how long it pauses"

param OPT_ADV_SPEED = Range(1.2, 4)
param OPT_ADV_DISTANCE = Range(26, 58)
param OPT_STOP_DISTANCE = Range(0.2, 2)
param OPT_STOP_TIME = Range(0.5, 2)

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * (headway(egoRoute, ego, self) / 8 - globalParameters.OPT_STOP_TIME - 1))
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_STOP_DISTANCE)
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
