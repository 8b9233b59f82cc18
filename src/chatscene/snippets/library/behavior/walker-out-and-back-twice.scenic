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
