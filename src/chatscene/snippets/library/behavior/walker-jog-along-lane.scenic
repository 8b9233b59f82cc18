#: description = "The pedestrian jogs off the pavement and runs on along the lane ahead of the ego."
#: rephrasings = [
#:   "A jogger pops out and keeps running down our lane, back turned to us.",
#:   "The pedestrian was running in the roadway with traffic, ahead of Vehicle 1.",
#:   "runner enters lane, keeps on same way as us",
#:   "The target enters the lane and moves longitudinally ahead of the VUT at running speed.",
#:   "The sportsman runs on the road in our direction before the car.",
#:   "A marathon trainee dodges the puddles by switching to the tarmac and pounding along it.",
#:   "A thief flees down the middle of the road with his loot.",
#:   "Someone breaks into a run down the carriageway as if racing us.",
#:   "a jogger hopped off the pavement and carried on running down the lane in front of me like it was a track",
#:   "The jogger left the sidewalk and continued running in the travel lane ahead of V1.",
#:   "Runner off pavement -> our lane, jogs along, same dir.",
#:   "The pedestrian target leaves the footway at running speed and continues along the lane in the VUT's direction.",
#:   "A sport man runs from the sidewalk in my lane and runs further there, before my car.",
#:   "Runner enters from footpath and then tracks the lane centre ahead of the SUT; he's a slow lead, not a crosser.",
#:   "She had come off the kerb with her earphones in, and her easy strides took her on ahead of them down the middle of their lane.",
#:   "He's out on his morning run, and he's come off the footpath and he's using your lane; he's heading the way you are.",
#:   "this runner just hopped off the pavement and is jogging in front of us like its a track",
#:   "A fitness fan forsook the pavement and ran on in the carriageway ahead of cars",
#:   "You left the footway and went running along the lane, your back to the traffic?",
#:   "Jogger uncle came down from footpath and running in our lane in front, like marathon",
#:   "Lycra's left the pavement and he's pounding along ahead of me like I'm his support car",
#:   "Pedestrian running lengthwise in own lane after leaving the pavement",
#:   "Jogger runs down MY LANE like I'm not there",
#:   "The jogger loped off the pavement and up our lane.",
#:   "runner quits the footway trots off up our lane with us behind",
#:   "Have a jogger leave the sidewalk and run ahead in ego's lane.",
#:   "He jogs down from kerb and runs away before our car, same direction.",
#:   "Kid scampers off the pavement and keeps legging it along our lane.",
#:   "Jogger off footpath, now proceeding with traffic ahead of V1, at a run.",
#:   "A woman in neon stepped up her pace, left the pavement behind her and settled into our lane, where all we saw was her ponytail bobbing on.",
#:   "The pedestrian enters from the footway at a run, aligns with the longitudinal axis of the lane and continues running ahead of the VUT in its direction.",
#:   "You can't pass this gentleman yet. He's come jogging down off the kerb and now he's using your lane as his running track, back to you.",
#:   "Suddenly the man has run from the walkway to my road, and there he did not cross, he ran always forward, and I drove behind his shoes.",
#:   "Because the pavement was full of bins, the runner moved onto the carriageway without breaking stride and carried on down it with the AV at his heels.",
#:   "Where did he go after he had left the pavement? Nowhere, officer: he kept running along the lane, the way I was driving, just ahead.",
#:   "My running club does this and I tell them off for it. Ahead of a grey minivan a tall fellow came off the pavement at a good trot and turned along the lane, the same way as the van was headed. He then ran and ran, right in the middle, deaf to its horn.",
#:   "Jira says closed, I reopened it. Pedestrian comes off the footway at roughly 10 km/h, rotates into our heading and runs on along the lane ahead of us. Never reaches the other side, never turns to face us. Ego expects a crossing to finish and is confused that the obstacle keeps moving away slowly.",
#:   "V1 was northbound. A pedestrian in athletic clothing ran from the sidewalk into the northbound lane in front of V1 and continued northbound therein at a jog. The operator of V1 followed at the jogger's speed for some distance, having first braked sharply, and stated that the jogger did not once look around.",
#:   "From my cab I saw the postman's dog first and then the reason for the postman's haste. He trotted off the kerb into the lane before me, bag flying, and instead of making for the far side he kept right on up the road, the two of us travelling in procession, me in bottom gear.",
#:   "She had run along the railings for as long as there was room. Where the scaffolding began she sprang lightly down, swung into the lane ahead of the evening traffic and ran on with it at her back, her breath white, as though all those headlamps had been lit to show her the way.",
#:   "Jogger hops down into our lane and keeps running, same way as us.",
#:   "Let a schoolboy trot off the pavement and on along the ego's lane.",
#:   "runner leaves sidewalk, uses MY lane as his treadmill, back to me",
#:   "A policeman on foot came off the pavement at a run and chased on along our lane in front of us, going where we were going.",
#:   "The pedestrian enters at jogging speed, turns parallel to the lane axis and then moves ahead of the VUT in like direction, exposing its back.",
#:   "One lady in tracksuit was jogging on footpath, then she came down and went on jogging in my lane only, before my bonnet, like she is pilot car.",
#:   "He's off the kerb and he's turned his back on you, still jogging; so he's not getting over to the other side, he's running up your lane.",
#:   "The man quitted the pavement at a jogging pace and continued so, in the carriageway, ahead of the coach and in the coach's direction; is that it?",
#:   "Running club banned from High Street after a member came down off the footway and led a bakery truck along its own lane for three hundred yards.",
#:   "I had the window open for the smell of the lilac. A young woman was running on the pavement a little way in front, with a good, quiet stride. There was scaffolding, and she dropped down into the lane without losing a beat, and from then on I had the soles of her shoes before me, left, right, left, right, up the hill.",
#:   "V1 was northbound at 25 mph. A pedestrian ran from the east sidewalk to the northbound lane and, rather than proceeding to the west side, turned north. She remained in that lane at a jog, in front of V1 and facing away from it. V1's operator slowed to the same speed, about 7 mph.",
#:   "We'd a stack of data on people who go over and none on people who go along. Hence this clip. The gentleman with the headband trots off the footway, swings into the lane's direction, and becomes, for all practical purposes, a very slow vehicle with a ponytail. The AV ought to follow at a distance and it ought not to hoot.",
#:   "It's the boy with the kite. He'd run with it along the pavement as far as the pavement went; the kite wanted more. So off he came, and on he ran, in the middle of our lane, looking up and never behind, with my lorry creeping at his heels and the tail of the kite dancing over us both.",
#:   "Which idiot wears black at night to train for a marathon? My beams caught reflective heels, nothing else. They came skipping off the kerb and into the lane before me. I waited for them to leave it on the opposite side, as heels do. They didn't: they went on hammering away from me, along it, under the lamps.",
#:   "The fellow was in a dressing gown and in a hurry. He burst from the garden path, and the pavement didn't detain him; he was in the road, and then he was bound down the road, in the same direction as ourselves, slippers flapping, with us behind him like a carriage behind its footman. \"The bus,\" he was calling, \"the bus.\"",
#:   "As the instructor I was asked what I'd have done. There's a jogger on the left, I'd have looked at him. He comes off the kerb, still at a jog, I'd have braked. He turns up the lane with his back to me and jogs on, well, then I'm jogging too, aren't I, until there's room to get by.",
#:   "It was for charity, he had a tiger costume on. The tail was what I saw first, wagging in our lane ahead of us. He had come running off the pavement because it was all prams there, and on the road it was empty, apart from me. So he ran along it, tail to my bumper, for a good minute.",
#:   "Expected by the ego: a crossing pedestrian who is out of the lane in three seconds. Delivered by the scenario: somebody who comes off the footpath at 3 m/s, makes a quarter turn into our direction, and runs on in the centre of our lane. Time in the lane is unlimited. Relative speed is small. No face visible.",
#:   "Sorry, I know the lane isn't a running track, it was me. There was ice on the pavement. I jumped down in front of the silver car and carried on with my run in the lane, in the direction of the church, so I'd got it at my back. I had music in. I thought they could simply drive slowly.",
#:   "In Barcelona the runners go where they want. This one ran on the acera, very elegant, and then he descended from it and put himself before my taxi, without to stop running. I thought, he goes to the other acera. But no: he went straight with me, showing me his shirt number, until the square.",
#:   "Runner off the footpath, now our pacemaker, soles to us.",
#:   "kid hops down the kerb n jogs up our lane ahead",
#:   "Steady trot, off the pavement, along our lane, same heading.",
#:   "The reflective patch on her back, which had been bobbing along by the shop fronts, bobbed down on to the road and went on bobbing in front of our bonnet.",
#:   "A soldier with a pack, at the double, quits the footway for the ego's lane and there keeps up his double, in the very direction the ego is going.",
#:   "I can tell you the make of his trainers, as from the moment he'd skipped off the pavement I had nothing before me in my lane but their undersides.",
#:   "From the footway the target enters the lane at a jog, aligns with the driving direction of the SUT and proceeds longitudinally ahead of it at running speed.",
#:   "He isn't crossing, dear, however long you wait for him to; he's come down off the kerb and he's out for a run on your bit, away from you.",
#:   "There was a dog walker in the way of him on the path, so he went round by the road, only the going round never ended, he kept on running up our lane.",
#:   "My speed for the next four hundred metres was eleven kilometres an hour. It wasn't the car's choice, and I had no breakdown. It was the pace of a man in yellow shorts who'd left the pavement at the scout hut without breaking his rhythm, wheeled into our direction, and whose shoulder blades I then had ample time to study.",
#:   "The tag said \"crossing\", and the planner waited for it to be over. It won't be over. The person leaves the footway at a jogger's pace, yes, but the heading comes round till it's equal with ours, and from then on there's a pedestrian with positive speed in the ego lane, at nine metres, at ten, at nine, who looks at the horizon.",
#:   "I'd like to know what became of him, is all. He burst off the pavement by the registry office in a morning coat and we thought he'd go over to the church. But he'd a longer way to go than that. His coat tails flew before the bumper of our taxi, along the lane, lamp-post after lamp-post, and not once did he turn his head.",
#:   "What one saw in the headlamps: first a girl's profile, as she came down from the sidewalk at an easy run; then a ponytail. It's the ponytail that I remember. It went left, right, left, right like a metronome, in the middle of my lane, and my coach with fifty football fans rolled behind it, singing to its beat.",
#:   "There's a lad who thinks that cars are bulls, and he lets himself be chased. He'll be on the pavement. As you get near he hops off it, takes to the middle of your lane with his back to you, and trots, at no great speed, for as long as it amuses him. I hoot. He puts up two fingers like horns and trots.",
#:   "Distance closed at first and was then constant, which in a pedestrian is rare. The explanation is to be found in frame 140. The subject had come off the pavement at a run; in that frame the toes turn through a right angle; after it they point where V1's wheels do. V1 reduced its speed to the subject's, and a convoy resulted.",
#:   "With the ice on the pavements it's we in the lorries who get them. This one took three slippery strides past the bins, thought better of it, and in a fourth was on the gritted bit, mine. I supposed she'd nip over. She'd no such plan. Off she jogged along it, and forty tonnes of turnips jogged after her as far as the pool.",
#:   "I was at the window with the baby. A fellow came down our path like somebody who's missed his bus, and the bus was there, far up the street. He took no notice of the pavement beyond putting one foot on it. The lane got the other, and the robotaxi that was in the lane got the back of him, legs going, all the way to the stop.",
#:   "The jogging gentleman wears a cap with a little lamp on the back side, red, like a bicycle. So when from the trottoir he has descended on my strip, I thought he's a bicycle that's entering. He's running, monsieur! He's running in my file and in my direction, and his little lamp says to me \"go behind\", for one kilometre.",
#:   "Please, no one who runs over the road and no one who runs at us. It's the third kind that I'd like to see. Some boy whom one notices on the pavement since he's faster than the rest; he drops off the edge at that speed, swings round until we've his rucksack in front of us, and the rucksack goes on ahead in our lane.",
#:   "Not a great view from the handlebars, but I did see legs under the van in front of me. They jumped off the kerb, they came round to the van's own heading, and they kept on, a pair of white knees, or rather the backs of them, with our whole little procession, van, me and an ice-cream cart, at a dog-trot in the rear.",
#: ]
#: adversaries = ["pedestrian"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "own code"
#: [slots]
#: actions = ["fast", "follow"]
#: leader = false
#: place = "road"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 3.4
#: high = 5.0
#: unit = "m/s"
#: meaning = "how fast it runs"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 6.0
#: high = 26.0
#: unit = "m"
#: meaning = "how far the ego still has to go when it starts to move"
#: [[parameters]]
#: name = "OPT_ADV_REACH"
#: low = 1.0
#: high = 2.4
#: unit = "m"
#: meaning = "how far from the ego's line it turns along the lane"

param OPT_ADV_SPEED = Range(3.4, 5)
param OPT_ADV_DISTANCE = Range(6, 26)
param OPT_ADV_REACH = Range(1, 2.4)

behavior AdvBehavior():
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 3 * abs(offsetFrom(egoRoute, self))
    do MoveAhead(2.5) until abs(offsetFrom(egoRoute, self)) < globalParameters.OPT_ADV_REACH
    # A quarter turn into the ego's direction, from whichever side it comes.
    do MoveAhead(globalParameters.OPT_ADV_SPEED, 1.57 if offsetFrom(egoRoute, self) > 0 else -1.57)
