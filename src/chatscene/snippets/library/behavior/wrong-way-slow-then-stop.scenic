#: description = "The oncoming car comes slowly along the ego's lane the wrong way and stops."
#: rephrasings = [
#:   "she creeps toward us in our lane and then just stops there, nose to nose",
#:   "Vehicle 2 was moving slowly the wrong way and came to rest facing Vehicle 1.",
#:   "wrong-way, slow, then halts facing us",
#:   "The target approaches slowly in the lane of the VUT against its direction and comes gently to a standstill.",
#:   "The bike comes slow in the wrong direction and at the end it stands before us.",
#:   "A lost driver dawdles toward the ego in the wrong lane and gives up there.",
#:   "The cyclist riding up our lane eases off and puts a foot down.",
#:   "A bus trundles at us on our side of the road and rolls to a halt.",
#:   "A van came crawling at me on my side of the road and pulled up facing me.",
#:   "Unit 2 proceeded slowly the wrong way in Unit 1's lane and came to a final stop facing it.",
#:   "Wrong-way, slow, ego lane, then halts nose to nose.",
#:   "The target approaches at low speed in the VUT's lane contrary to traffic and comes to rest.",
#:   "The truck comes slowly on my lane in false direction and then stands.",
#:   "Contraflow creeper: slow head-on approach in our lane ending at zero; stays as an obstacle.",
#:   "It came up her side of the road at a crawl, and there it stopped, facing her, lamp to lamp.",
#:   "Lost tourist coming up your lane the wrong way, nice and slow, and he's pulled up in front of you.",
#:   "this van was slowly coming at us in our lane and then stopped right in our face",
#:   "A lost motorist felt his way up the wrong side and pulled up facing the traffic for good.",
#:   "You came slowly along her lane from the opposite direction, and you ended at a standstill before her?",
#:   "Opposite truck came slowly in my lane wrong side, then stopped face to face, now how.",
#:   "Dawdles up my lane at me the wrong way, stops dead, and now we're having a staring match.",
#:   "Slow contraflow approach in ego lane ending in face-to-face standstill.",
#:   "WRONG WAY DRIVER CRAWLS UP AND STOPS IN FRONT OF ME",
#:   "The wrong-way bus trickled up our lane and moored there facing us.",
#:   "Minibus tiptoes up our lane against us, then comes to rest.",
#:   "Old boy on a bike wobbles slowly at us, contraflow, and stops.",
#:   "Have a lorry inch the wrong way along my lane, then halt.",
#:   "Facing us in our lane: a hatchback, dawdling, then gently stationary.",
#:   "Wrong-direction cyclist in the AV's lane, very slow, finally at a stand.",
#:   "The cab was in my lane, pointing at me, coming along at no more than a jog, and little by little it stopped altogether.",
#:   "An old man drives his car on the false side, in my lane, quite slow towards me, and after some metres he stays standing.",
#:   "The wrong-way target, having moved over into the VUT's lane, approaches at low constant speed and is gently brought to zero.",
#:   "It came to rest with its headlamps facing mine, after a slow progress up my side of the street, which is no place for a coach.",
#:   "That's your lane he's in, the milkman, and he's coming at you at a crawl; steady, he's running out of puff, he's stopped.",
#:   "Did the saloon you met in your own lane, travelling contrary to you and scarcely faster than a walker, end up at a standstill?",
#:   "I think the lady in the motorhome was a visitor here and had forgotten which side we use. She rolled along my lane toward me, very timidly, slower and slower, and at last she halted and put her hands over her face.",
#:   "V2 was in V1's lane, oriented opposite to the direction of travel and moving at an estimated 6 mph. V2's speed decayed smoothly to nothing; V2 was stationary, facing V1, at the time V1's own brakes were applied.",
#:   "The cyclist had his shopping on both handlebars and the whole street to choose from. He picked our lane, wrong way, pedalled up it as gently as you please, and finally got down off the saddle right where he was, facing the van.",
#:   "I'm asking for an easy one for our new operators. A bus has strayed into the shuttle's lane, headed the wrong way; it approaches us at a jogger's speed and, well before we meet, softly pulls up and doesn't move again.",
#:   "Look at this delivery driver, people. He's in my lane, he's coming straight at me, and he's doing maybe five miles an hour, like a cat that's been caught. And now he's just stopped there, nose to me, engine on.",
#: ]
#: adversaries = ["car", "truck", "bus", "bicycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "slow", "stop"]
#: position = "oncoming"
#: maneuver = "straight"
#: leader = false
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 2.0
#: high = 3.6
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 8.0
#: high = 25.0
#: unit = "m"
#: meaning = "distance to the ego at which it stops"

param OPT_ADV_SPEED = Range(2, 3.6)
param OPT_ADV_DISTANCE = Range(8, 25)

behavior AdvBehavior():
    do DrivePath(advTrajectory, 8) until gap(self, ego) < 60
    do DrivePath(against(egoRoute), globalParameters.OPT_ADV_SPEED) until abs(offsetFrom(egoRoute, self)) < 0.8 and gap(self, ego) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(against(egoRoute), 0.3)
