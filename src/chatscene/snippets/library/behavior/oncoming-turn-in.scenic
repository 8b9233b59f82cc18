#: description = "The oncoming car suddenly turns into the ego's path without signalling."
#: rephrasings = [
#:   "A vehicle approaching from ahead cuts across in front of the ego.",
#:   "The opposing driver turns off through the ego's lane with no indicator.",
#:   "The adversary, facing the ego, swings left right over its way.",
#:   "An oncoming vehicle makes an abrupt turn into the road space of the ego.",
#:   "The car coming the other way crosses the centre line and stays in the ego's path.",
#:   "he cuts right across in front of us and doesn't even indicate",
#:   "Vehicle 2, oncoming, turned across the centreline and stopped in the lane of Vehicle 1.",
#:   "opposing veh cuts in across our lane, no indicator",
#:   "car coming the other way just steered straight into my path, not a flicker of an indicator",
#:   "The oncoming vehicle abruptly turned into V1's path of travel without signaling.",
#:   "Opp. truck veers in front of us. No blinker.",
#:   "The oncoming target steers without indication into the trajectory of the VUT.",
#:   "The bus from front comes suddenly into my way and gives no light.",
#:   "Opposite-lane NPC should hook over into the SUT's planned path, blinkers off, short notice.",
#:   "With no sign of what he meant to do, the biker coming to meet them wheeled into the very path they were on.",
#:   "No signal from that van coming at you, and he's swinging over into where you're going regardless.",
#:   "the car coming the other way just turned right into us no indicator nothing",
#:   "A lorry on the opposite side steered, without so much as a flash of its lights, over the path of a school run",
#:   "Giving no indication whatever, you directed your approaching vehicle into my client's course?",
#:   "Opposite side bike suddenly cut into our way, signal also never give",
#:   "He's coming at me, I'm going at him, and out of the blue he steers over my front, indicator must've been extra",
#:   "Unsignalled turn of opposing traffic into own path",
#:   "Oncoming bus TURNS INTO ME without signaling",
#:   "The pickup facing us veered into our way unannounced.",
#:   "Approaching SUV slung itself into our path, indicators dead.",
#:   "Moped from the opposite direction steers into us, no signal shown.",
#:   "Have an oncoming van veer into the ego's path unsignalled.",
#:   "Coach, opposite way, turned in front of you, never winked a light.",
#:   "He came from front and all at once turned in my way, no blinker",
#:   "Without giving any signal, the lorry which had been coming towards me put its wheel over and was all at once in the piece of road I needed.",
#:   "The opposing target shall leave its lane abruptly, direction indicators off, and move into the predicted path of the VUT.",
#:   "She swore that the car opposite had shown no flashing light at all before it bent out of its own lane and barred hers.",
#:   "V2 was approaching from the opposite direction and, with no turn signal activated, abruptly steered over the center line into the space in front of V1.",
#:   "Did that biker coming at us think we could read his mind, swinging into our way like that with his indicators switched off?",
#:   "Expect the unexpected: that hatchback facing you looked as if he'd stay put, gave nothing away, and has just turned into the road under your wheels.",
#:   "I had the green lane ahead to myself, or so it seemed. Out of the stream coming the other way a pickup suddenly slewed over into my path, no indicator, no look, and when I got my breath back it was filling my windscreen.",
#:   "Note for the agent library: oncoming vehicle, nominal until very late, then an immediate steering input that brings it into the ego's lane at an angle. Turn signals must remain off, because the point is that the intent cannot be known beforehand.",
#:   "My wife says I shouted something not fit for print. A bus that had been coming towards us all along the parade just hooked over into our way, with not one bulb flashing on that whole enormous side of it.",
#:   "There's a fine irony in the footage. The lorry coming the other way has seven orange lamps on its flank, and none of them so much as blinks before it lunges over into the path of the robotaxi and ends up in front of its bumper.",
#:   "The judge wanted to know how much notice the claimant had had. None, was the answer: the motorcyclist had been heading the opposite way, he had put out neither hand nor lamp, and in an instant he was in the claimant's path.",
#:   "Facing cab hooks across into our way, not one blink first.",
#:   "Lorry comes at us, then turns in front of us, flashers dead.",
#:   "telepathy required: bike from the other direction bends into my path unindicated",
#:   "Not a lamp winked on the whole flank of that coach, which had been approaching us quietly until it put its nose into our way.",
#:   "The opposing target, direction indicators inactive throughout, initiates at short notice a turn that takes it into the trajectory of the VUT.",
#:   "It was on the other side, it was coming, it was going to pass us; and instead it bent round into us without any winker, Mummy.",
#:   "Try a pickup from the opposite direction that gives its intention away by nothing at all and, at the last moment, turns in ahead of the ego.",
#:   "If he had blinked, I would have braked; but the bus from the contrary direction blinked nothing and suddenly he came around to my side before me.",
#:   "Driver 2 conceded that, while travelling toward V1, he made an abrupt turn into its path and that he had not operated his turn signal.",
#:   "He had a stalk on the steering column like the rest of us, my learned friend will not deny it. He came towards the claimant, he said nothing with that stalk, and from one moment to the next his van had been brought round into the piece of road she was about to use.",
#:   "We were singing, I think. I know that there was a red hatchback coming the other way and that I'd stopped thinking about it, since nothing on it was flashing. When I next thought about it, it was round in front of us, side on, and Ann had her feet against the dashboard.",
#:   "Headlights pointing at you are fine; headlights sliding sideways aren't. Those on the motorcycle coming towards us began to slide without any amber to go with them, and a heartbeat later the machine was lying over into the very strip of lane we were heading for.",
#:   "Let me get this off my chest, fellow truckers. Fully freighted, forty mile an hour, and a people carrier off the opposite stream decides that it'd like to be on my side, right now, in front of me. Indicator? The bulb's probably still got its wrapper on.",
#:   "Expected event: oncoming saloon goes by. Observed event: at about twenty metres it leaves its course, turning sharply into the corridor of the AV, and it's there across our lane when we stop. The perception log lists the state of its turn lights as off from first to last.",
#:   "There's no use looking for the orange flash, because half of them won't give it. Look at the wheels. That lorry coming your way had its wheels straight, straight, straight, and then they were round, and now it's put itself where you wanted to be.",
#:   "It may be of use to other residents to know about the junctionless stretch by the park. On Sunday an approaching bus, which had shown no signal of any kind, turned so sharply into the way of our car that my sister's flask of tea is now in the carpet.",
#:   "\"I never got so much as a wink out of him,\" the taxi driver told reporters. A delivery van that he had been about to meet on the ring road curled over in front of him without notice, and its bumper was pointing at his door pillar when all was over.",
#:   "The street was wide and there were but two of them in it, drawing together at a decent pace. Then the other, for reasons he took with him, laid his motor round in a sharp curve so that her road was gone; and neither hand nor light had spoken of it.",
#:   "What I'm looking at in clip nine is the missing cue. The SUV is opposite us, there's no blinker, no drift, no dip of the bonnet; there's just this very sudden hook of the steering and, hey presto, we're aimed at its front wheel in our own path.",
#:   "Opposite side fellow was coming nicely in his line, I was going nicely in my line. No hand, no light, nothing he has shown, and all of a sudden his tempo was turning into my front, and I had to say all gods' names together.",
#:   "Amber? None. One instant he faced us, the next he barred us.",
#:   "Bus from ahead bent round into our road space, lamps all dark.",
#:   "Not so much as a wink, then a bike athwart our bows.",
#:   "Nothing blinked on the lorry that was drawing near on the other side, so nobody was ready when its cab came round and its bumper lay over our route.",
#:   "Let an oncoming hatchback keep its intentions to itself, straight as a ruler, winkers dead, until it abruptly puts its nose into the road the AV is about to use.",
#:   "The bulb was intact and the switch was at off, says the garage; and yet V2 came round, from the opposite direction, into the way of V1.",
#:   "I was looking straight into his headlights, and then, with nothing to announce it, I was looking at his front wheel, turned, and square where I meant to be.",
#:   "If you wait for the flasher you'll wait for ever: that pickup coming the other way has just hauled itself round into your way without one.",
#:   "The moto from face to me, I believed she goes past, she gave not any light, and sudden she broke in my way like somebody who forgot the house.",
#:   "There were two things that could have told us, and neither did. The orange lamps at its corners never lit, and it didn't slow. So when the van that had been about to go by on the other side came sharply round instead, and its bumper ended up in front of ours, we'd had perhaps half a second's notice.",
#:   "The groceries are against the windscreen because of a man who likes surprises. He was no concern of mine; he was on his half of the road and I on mine, and we'd have been strangers for ever. All at once he'd spun the wheel, and I was standing on everything with his radiator across my lane. The indicator? Please.",
#:   "What does the word \"signal\" mean to you, the magistrate asked. The coach driver considered it. He had been going the other way, he'd agreed to that, and then he'd steered, quite sharply, into the road in front of the claimant; and as to having told anybody, with a lamp or an arm or a toot, well, no.",
#:   "Trace: heading of the opposing agent constant at 180 degrees relative to ours up to a gap of 22 metres. From there, a step to about 140 within a second, whereby it enters our corridor. State of the left and right indicators in all frames: off. We stop with 1.8 m to spare; it's then standing across our lane.",
#:   "She'd been told that headlights which stay put in the windscreen are coming at you and ones that slide past aren't. These were sliding past, as they should. They hesitated; with no yellow beside them they slid back the other way, and fast. It was a motorbike, and it was coming round into the very place she was driving to.",
#:   "I was on the pavement with the dog. The silver car and the taxi were nearing each other, nothing in it, plenty of road. But the taxi driver must have seen his fare, because with neither a light nor a look he screwed the whole cab round in front of the silver one, and you never heard such brakes.",
#:   "We'd be rich if we had a pound for every one of these. He's coming down the far side, this box lorry, all innocence. You check him: no indicator. You check him again: no indicator. The third time there's no need to check, as his whole front's over here and it's you who's doing the stopping.",
#:   "My sister had just asked if there was any milk left. I'd just said \"half a pint.\" Between those two remarks and the third, which I won't repeat, the estate that had been approaching on the other side was no longer on the other side. It had turned in at us, and it hadn't flashed, and that's where the milk went.",
#:   "A dash of the wheel was all it took him. The great lamps that for a mile had stared at her from the opposite half of the road swept aside, like a face averted; his flank was there, his running board, his tyre, in the road before her. No arm had been put out, and no arrow had dropped from its slot.",
#:   "As a wagon driver I read tyres. Lamps lie, but tyres turn before the rest of it. So I had my foot moving when the people carrier coming at me, with not one bulb lit on either side, cramped its front wheels round; it was into my bit of road before the foot had arrived.",
#:   "For indicator people are thinking bulb will finish. This Bolero opposite to me was coming, nicely, his own side. Hand is not outside, bulb is not burning, head is not turning. And then suddenly his bonnet is in my path, like calf who saw its mother on my side. I also mooed.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario vehicle-passing; own code"
#: [slots]
#: actions = ["oncoming", "cut-in"]
#: position = "oncoming"
#: place = "road"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 5.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it drives"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far before the middle of its way the ego is when the adversary sets off"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 15.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far beyond that middle it turns"
#: [[parameters]]
#: name = "OPT_ADV_ANGLE"
#: low = 0.5
#: high = 1.1
#: unit = "rad"
#: meaning = "how sharply it turns"

param OPT_ADV_SPEED = Range(5, 9)
param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_REACH = Range(15, 30)
param OPT_ADV_ANGLE = Range(0.5, 1.1)

behavior AdvBehavior():
    do Halt() until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(egoRoute, self, egoRoute.eventAt) > -globalParameters.OPT_ADV_REACH
    do MoveAhead(globalParameters.OPT_ADV_SPEED, globalParameters.OPT_ADV_ANGLE) until abs(offsetFrom(ownLane(egoRoute), self)) < 1.5
    do Halt()
