#: description = "The pedestrian steps into the lane and back out of it twice."
#: rephrasings = [
#:   "In and out, in and out: he can't decide whether to cross in front of us.",
#:   "The pedestrian twice entered the roadway and twice withdrew to the shoulder.",
#:   "ped in/out of lane, two times",
#:   "The target performs two consecutive aborted crossings.",
#:   "She goes on the road, back, one more time on the road and back again.",
#:   "A ditherer tests the road, retreats, tests it anew and gives up for good.",
#:   "The child plays hop-in, hop-out with the traffic.",
#:   "Two false starts by somebody at the roadside, both ending where they began.",
#:   "He stepped off the kerb, hopped back, stepped off again, hopped back again, like he was doing the hokey-cokey.",
#:   "The pedestrian twice entered the lane and twice retreated to the curb without crossing.",
#:   "Ped in, out, in, out, never crosses.",
#:   "The pedestrian target performs two consecutive entries into the lane, each followed by withdrawal to the edge.",
#:   "The woman goes on the road and back, and one more time on the road and back.",
#:   "Walker: two false starts, both aborted, remains at the edge.",
#:   "Two times she ventured out, and two times she lost heart and went back to the side.",
#:   "He's out, no, he's back, he's out again, and back again, he's having you on.",
#:   "she stepped out, back, out AGAIN, back again, girl pick one",
#:   "A pedestrian ventured into the lane two times and both times withdrew.",
#:   "On two occasions he came forward into the lane, and on both he retired from it; cross it he never did.",
#:   "The man came in and went back, again came in and again went back, two times he did same thing.",
#:   "In, out, in, out, and he's still on the side he started from, shake it all about.",
#:   "Repeated (two-fold) lane entry and withdrawal of pedestrian without crossing",
#:   "OUT, BACK, OUT, BACK - pedestrian trolls me twice",
#:   "The man dips into the lane and out of it, two times over.",
#:   "Two sorties into our lane, two retreats, no crossing.",
#:   "kid comes out goes home comes out once more goes home once more",
#:   "Ped: lane entry and withdrawal, same again, remains at edge.",
#:   "Have the old man venture out and go back, two times.",
#:   "HOKEY-COKEY: jogger in, out, in, out, still on the kerb",
#:   "A woman with a pram pushed it into the lane, pulled it back, tried it a second time and pulled it back a second time as well.",
#:   "The pedestrian target enters the lane and retreats to the edge, then performs the identical sequence once more and finally remains clear of the lane.",
#:   "Both times he dared to come down off the kerb our car frightened him home again, and after the second go he let it be.",
#:   "The boy makes one step in my lane and goes back, then he makes the same thing again, and at the end he stays on the sidewalk.",
#:   "She's not going to go, you know; that's twice now she has come out in front of you and twice she's taken herself back.",
#:   "Did the deceased's brother enter the road once or twice? Twice, and on each occasion he returned to the pavement that he had come from.",
#:   "There was a gentleman on the kerb who plainly couldn't judge my speed. He came out into my lane, thought better of it and went back. No sooner was he on the pavement than he came out again, and blow me if he didn't go back again.",
#:   "Pedestrian P1 moved from the sidewalk into the lane of V1 and withdrew to the curb. Some two seconds later P1 repeated the entry and likewise repeated the withdrawal. P1 was outside the lane when V1 passed and had at no point reached the opposite side.",
#:   "I want to annoy the planner with a double feint. The person walks into the robotaxi's lane, turns and leaves it to the same side, and when the robotaxi has just begun to trust that, the whole thing happens once more: in, and out again.",
#:   "A girl was fetching her ball, or wanted to. She ran down into the lane, saw us, skipped back to the grass. She gathered her courage, down into the lane a second time, and back to the grass a second time, and there she stayed crying.",
#:   "My dears, it was like watching a cuckoo clock strike two. Out he popped in front of the motor, in he went; out he popped again, in he went again; and then the little door stayed shut, for he waited on the pavement until we had gone.",
#:   "Two tries, two retreats, and Grandad stayed on his kerb.",
#:   "Out into lane, home; out anew, home anew; then nothing.",
#:   "Jogger tests our lane twice, backs off both times.",
#:   "The lady with the dog set foot in our lane, withdrew, set foot in it once more, withdrew once more, and finally let us by.",
#:   "Sequence: entry into ego lane, return to originating edge, second entry, second return, pedestrian at rest off the carriageway.",
#:   "Has she come out and gone home again two times just to tease me, or does she really not know whether she wants to cross?",
#:   "That boy was entering my lane and running back to footpath, same drama second time also, and lastly he stayed on footpath only.",
#:   "Could the kid hop into the AV's lane, hop out to where he came from, and then do precisely the same again before giving up?",
#:   "After two excursions into our lane, from each of which he beat a retreat to the pavement, the old gentleman resigned himself to waiting.",
#:   "I braked for her, I let go, I braked for her again and I let go again. That was me; what she was doing was coming off the kerb into my lane and going back up, and then, when I'd only just got into second, performing the entire dance once more. She never did get over.",
#:   "The robotaxi's speed profile for this minute has two identical dents in it. Each of them is due to one and the same man, who appeared in our lane, turned, and disappeared to the right-hand kerb whence he had come. After the second dent he is standing on the kerb, and we drive by.",
#:   "Pedestrian stepped into V1's lane and regained the sidewalk at once. The pedestrian then ventured into the lane a second time, with a like result. At no moment was the centre of the roadway reached. When interviewed she said that she had twice \"chickened out\" and had then decided to use the underpass.",
#:   "You can almost hear him think. Shall I, and he's in our lane; no, better not, and he's on the pavement. Shall I now, and he's in our lane again, you'd want to scream; no, better not, and he's back on the pavement, and this time he's got his hands in his pockets and that's your cue to go.",
#:   "A seagull does that with a wave. It was a nun, as it happens, and the wave was us: she came down to the lane, and she scuttled from it to her side; the lane looked free, and she came down to it again, and scuttled again. We passed her standing on her side.",
#:   "My mother-in-law wants her letter read out on the show, so here goes. \"I put a foot in the road twice, young man, and twice I took it back, because your listener was driving like a maniac. I never crossed. I stood on the kerb and shook my umbrella at him.\"",
#:   "Please build a double-aborted entry. The pedestrian goes from the kerb into the lane of the vehicle under test, reverses out to that kerb, pauses, repeats the trip in and the trip out, and ends up at the kerb for the rest of the run. It mustn't cross, and it mustn't stay in the lane.",
#:   "It was a wet evening and the tracks told it all, the constable said. One set of small prints led off the pavement to the middle of the lane and led back. Next to it a second set did the very same. No prints went to the other side, and the child was found on the near pavement, crying.",
#:   "The little girl had a red balloon, so I could see her well from the coach. Balloon over the road, balloon over the pavement. I think, she has learned. Balloon over the road, no, she has not learned; balloon over the pavement, yes, now she has, and there it remains until I am by.",
#:   "I saw her in my lane at sixty metres, at fifty no more, because she was turned back to her side. At forty she was inside of the lane a second time. At thirty she had left it again by where she had entered, and she stayed there, thanks to God, and I could pass.",
#:   "My mirror nearly had his nose the second time. The first time I'd been miles off when he came out into my lane and thought the better of it. So why he should come out again with a loaded lorry on top of him I can't imagine, but he did, and he jumped back to the same verge.",
#:   "In. Home. In again. Home again. And there she stands.",
#:   "Jogger pops out and withdraws; second helping; road stays uncrossed.",
#:   "Two visits to our lane, both cut short, same kerb",
#:   "One slipper on our lane and the slipper withdrawn, then both performed again: such was Grandad's morning, and he's still on the near side.",
#:   "I must make two times full brake for this boy, since two times he enters in my lane and two times he escapes to his mother.",
#:   "The second time he ventured in front of us was as brief as the first, and finished, like it, on the pavement by the letter box.",
#:   "On the roadside camera she is seen at the kerb three times and in the lane twice, and never once beyond it.",
#:   "I'd like a nervous walker who takes a run-up at the ego's lane, thinks better of it, and repeats both parts exactly once before giving up.",
#:   "The dust on the man's boots shows that he'd been in the lane, and twice, but the lane was as far as he ever got from the bank.",
#:   "She had a list of two tries, as it were. At the first try she was out as far as our headlamp before she fled to the lamp post. I let the clutch up. At the second try she was out as far as our headlamp before she fled to the lamp post. I let the clutch up once more, and she shook her head at me.",
#:   "Why are there four skid marks, the sergeant asked, when you've two front wheels? Because I had to do it twice, I said. The youngster came out. I skidded, he scampered back up. I'd begun to roll, and he came out, I skidded, he scampered back up. That's where you found him, sergeant, up there on the wall, grinning.",
#:   "It's like waiting for a cuckoo clock to finish. Out comes the gentleman with the walking frame into your lane; in he goes to his kerb. You're not to move off yet, as it's two o'clock. Out he comes; in he goes. That's the two of them, his little door's shut, and you may drive by.",
#:   "Behaviour tree: Sequence(Enter, Retreat, Enter, Retreat, Idle). Enter takes the pedestrian from the kerb into the ego lane. Retreat takes it back out by the same side. Idle is at the kerb. We noticed that planners which commit after the first Retreat come to grief at the second Enter, and this is what the case is for.",
#:   "The bus for the hospital was over there, on the other side, and he never did catch it. He'd come down off the step with his bag, seen us, and gone up again; had come down with his bag, seen that we were nearer, and gone up again. When we had gone by, the bus had as well.",
#:   "Our cyclist, who had drawn up at our side, said it was like fishing. There was a bite, as it were, a girl with a phone in the lane in front of us, and the bite let go and was ashore. There was another, the same girl, same place, and it let go also. After that the line was slack, and we left.",
#:   "What the toy dog thought of it I can't imagine. It'd been led into the roadway on a string and been whisked out of it; led into the roadway and been whisked out of it. Four tugs in all. Its mistress was on the pavement, red to the ears and telling us with both hands to pass, please, please.",
#:   "Count it with me at quarter speed. Here's the man's coat, in our lane, and here it isn't, it's at the edge. That's one. Here it comes afresh, with our bonnet already dipping, and there it goes to the edge afresh, and that's two. I've run it on for a minute. He buttons the coat, and he stays.",
#:   "A hen does this, monsieur, not a notary! In front of my delivery bicycle and of the car beside me he has jumped down; hop, he's back on the sidewalk. One thinks that it's over. He jumps down a second time; hop, the sidewalk. Then he has adjusted his hat and pretended that he looks at a shop window.",
#:   "Braking event 1, 15:02:11; braking event 2, 15:02:17. Both were triggered by the same pedestrian track entering our lane from the left, and both were released when it had left our lane on the left. Maximum penetration was 1.1 m in either case. The track terminates at the left kerb, where the pedestrian remained.",
#:   "There must be a line of courage painted on that road which I cannot see. The child came up to it, in the middle of our lane, and was driven from it to the pavement. The child gathered itself and came up to it a second time; and the second time too it was the pavement that won. The ball lay opposite, unfetched.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["hesitate", "turn-back"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.6
#: high = 4.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 30.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary reaches its line"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 0.3
#: high = 1.1
#: unit = "m"
#: meaning = "how far from the ego's line it turns back"
#: [[parameters]]
#: name = "OPT_STOP_TIME"
#: low = 0.2
#: high = 0.6
#: unit = "s"
#: meaning = "how long it waits between"

param OPT_ADV_SPEED = Range(2.6, 4)
param OPT_ADV_DISTANCE = Range(30, 48)
param OPT_ADV_REACH = Range(0.3, 1.1)
param OPT_STOP_TIME = Range(0.2, 0.6)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 7 * abs(offsetFrom(egoRoute, self)) / globalParameters.OPT_ADV_SPEED
    # Briskly as far as the ego's own lane, should there be others before it.
    do MoveAhead(4.5) until abs(offsetFrom(egoRoute, self)) < 4
    do MoveAhead(globalParameters.OPT_ADV_SPEED) until restsWithin(egoRoute, self, globalParameters.OPT_ADV_REACH + 0.6)
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 3.14159) until abs(offsetFrom(egoRoute, self)) > globalParameters.OPT_ADV_REACH + 1.4
    do Halt() until self.pose[3] < 0.1
    do Halt() for globalParameters.OPT_STOP_TIME seconds
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 3.14159) until restsWithin(egoRoute, self, globalParameters.OPT_ADV_REACH)
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 3.14159) until abs(offsetFrom(egoRoute, self)) > 3
    do Halt()
