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
#:   "Wrong side, walking pace, facing us; then parked there.",
#:   "Toward us in our lane it dawdled, and dawdled to a stop.",
#:   "Contraflow cab, creeping at us, rolled to rest nose-on.",
#:   "Make the minibus come over to the ego's side, potter toward us against the traffic, and let itself run out until it's standing.",
#:   "A cyclist on my half came pedalling against me so slow that he nearly fell, and then he put the foot down and remained.",
#:   "Slowly, on what was undoubtedly our side, the dustcart had come on to meet us; it was at rest by the time we reached the bollard.",
#:   "Would you sound your horn at a learner who comes up your lane the wrong way at five miles an hour and gently gives up in it?",
#:   "Opposing vehicle occupies the ego lane contrary to direction, 2 m/s, soft deceleration of some 3 m/s² to standstill, remains facing the ego.",
#:   "Advise we have an elderly male in a saloon, was proceeding wrong way at very low speed toward the shuttle, now stopped, facing it, refusing to move.",
#:   "I've sat nose to nose with bulls, and this was like it. It was a grain lorry, it was in my lane, it was coming the way that nobody ought to come, and it was doing so with no more haste than a bull has. Nor did it do anything at the end. It breathed out, and stood there.",
#:   "The mystery was solved when he opened his window. \"Which side?\" he called. He'd rented the camper that morning. He had come along our side to us, out of the other direction, so timidly that I could have read out his dashboard; and gradually even that had got too fast for him, and the wheels had ceased to turn.",
#:   "Wet cobbles, fog, one lamp. It hung in our lane and hardly grew. A ghost, said my niece, though it was a baker on a bicycle, who'd got over on our side on account of the rails, and was coming along, wrong way round, at the speed of bread rising. The lamp dimmed, for it has a dynamo. He'd stopped.",
#:   "Why did the AV wait forty seconds? Look at the other actor: it came from ahead in the lane we're in, opposite to us, so slow that the planner had three chances to go round. It took none. The actor then came softly to a halt, dead centre, four metres off. Two polite cars, face to face, nobody moving.",
#:   "Don't panic. Yes, he's in your lane; yes, he's pointing at you. But look at the speed of the man. He's lost, he's peering at signs. You could walk that fast. Ease down, and down, and you'll see that he does likewise. There, he's come to rest, bless him. Now we've an obstacle with a face, that's all.",
#:   "V1 was southbound in the only southbound lane. V2 came northbound in the same lane at a speed which witnesses put at \"five, tops\". V2's approach became slower yet and ended with V2 stationary approximately twelve feet ahead of V1's bumper. The operator of V2 was found to be in diabetic shock.",
#:   "As court interpreter I give it literally. \"He was arriving in my lane, in face. I wasn't afraid, because a donkey arrives faster. It was a bus. The chauffeur was making with the hands so, excuse me, excuse me. And little by little the bus became a house, I mean by this that it was no longer moving.\"",
#:   "Someone had moved the cones in the night. Thus it was nobody's fault that the post van was heading up what we were heading down. She knew something was amiss; she had got it down to a tiptoe. Over the last few yards it went to less than a tiptoe, and then there we were, headlamp to headlamp, exchanging insurance details.",
#:   "There's videos of people going the wrong way at a hundred, with music. This isn't one of those. In this one a delivery truck's in my lane, yeah, coming at me, yeah, at the speed of a supermarket trolley. It takes for ever. It stops. He waves. He stays there. I wave. That's it, that's the video.",
#:   "Somewhere before the bend he must've got round the wrong side of an island, the gentleman in the vintage tourer. He was aware of it. He approached us in our lane as one approaches a headmaster, by inches, cap in hand; and before he'd quite got to us his courage went, and his motor, and he stayed where he was.",
#:   "mum there's a car and it's on our side!! but it's really slow, it's slower than my scooter. it's coming and coming... now it isn't coming. it's just looking at us with its lights. can robots say excuse me",
#:   "Faced us in our lane, ambled nearer, gently expired.",
#:   "Creeping contraflow, then at rest, headlamps to headlamps.",
#:   "Against us at a dawdle, then standing there for good.",
#:   "She might have been docking a ferry, so softly did the old lady bring her saloon up our lane, wrong way, and lay it to rest before our bumper.",
#:   "An oncoming bicycle ought to transfer itself to the ego's lane, dribble along it against the flow, and run down to nothing within sight of us.",
#:   "He was on my half, his face to my face, coming with the speed of a pushed pram, and after some metres even this was finished and he stood.",
#:   "Of its three lamps, the moped-car had one burning, and this came at us up our own side so gradually that we'd all stopped talking by the time it no longer came.",
#:   "Nobody need brake hard for a coach that approaches in the wrong lane at a trot, as the trot becomes a walk and the walk becomes a parked coach.",
#:   "Caller's in the tunnel mouth, says there's a hatchback facing her in her lane, it was coming up ever so slow and now it's just sat there.",
#:   "I had time to put my lipstick on, if I'd been so minded. There was a van on my side of the road which was looking at me, and it was on its way to me, but on its way as the tide is. I'd come to a stop long before. It had forty yards to go, then thirty. At six or so the tide was in, and there it lay, ticking.",
#:   "No harm was done, and I only report it because of the way it went on. The driver had, I'd say, got round a bollard by the wrong side. He was thus in our lane with his nose toward us. At a pace at which you could've changed his wheel he advanced. It became a pace at which you couldn't have told; and then he took out a map.",
#:   "The number of the bus was 14. I'd time to learn that, since from the first moment it was getting bigger in the middle of our lane, where you should only ever see the backs of buses, and yet one could have sworn that somebody was blowing it up rather than driving it. When it was as big as a bus it left off. The wipers went once.",
#:   "An AV that is good with fast threats can be helpless before slow ones. Here it's got an actor head-on in its lane, at two metres per second, for what feels like all afternoon. It stops, properly. The actor still comes. Only with some seven metres left does it go from two to one to nought, at a deceleration you'd not spill your tea by.",
#:   "My husband made an apology with the hands, he is so polite; I wouldn't have. The taxi was on the false side, not we. It was coming contrary to all the arrows, with its nose to our nose, like a person who goes in a dark room with the hands before him. And when he had touched nothing for long enough, he let it roll out and put the hand brake.",
#:   "If you get one in your lane, facing you, look for two things: how fast, and who's behind the glass. This one? Hardly moving, and she's in tears. She's gone up the slip road the wrong way and she knows. So you stop. She'll go on rolling at us a bit, I dare say, while her courage runs out. There. Neither of us is moving now.",
#:   "It was the horse that told me. I had the window down, the pony was on the verge, and its ears were following something behind my sun visor. I lifted the visor. A dustcart was in my lane, pointing the wrong way, mine, and padding up it, all quiet, like a man in socks. It padded to within a few yards and sat down.",
#:   "V1 was at rest. V2 continued toward V1, in V1's lane and contrary to the one-way designation, at a speed estimated from the video as 3 to 5 mph. The speed diminished without visible brake application, and V2 halted 14 feet short of V1. V2's driver, who spoke no English, indicated the screen of her navigation device. Neither vehicle was damaged.",
#:   "They observed each other's approach with the courtesy of two elderly bishops in a passage; only that one of the bishops, the one upon the tricycle, was on the wrong side of it. He came up their lane at a pace between prayer and sleep. It inclined to sleep. A little way before them he was quite motionless, his hand lifted, as though to bless.",
#:   "What gets me, members of the council, is that it wasn't reckless. The delivery truck came through the no-entry and up towards my shop, into the face of the school bus, slower than I sweep. It sort of wilted. By the bus stop it had wilted right down to a stand, nose to nose. That's your signage for you, when careful people do that.",
#:   "street view car but going the WRONG WAY up our lane lol. coming at us like 4mph with the camera ball on top. everyone in the shuttle waving. it just gets slower n slower n then its stopped, front to front, like two dogs. somewhere theres a photo of me eating a crisp",
#: ]
#: adversaries = ["car", "truck", "bus", "bicycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["oncoming", "wrong-way", "slow", "stop"]
#: position = "oncoming"
#: maneuver = "straight"
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
