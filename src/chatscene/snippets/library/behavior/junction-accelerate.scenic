#: description = "The car suddenly accelerates and enters the intersection."
#: rephrasings = [
#:   "A vehicle speeds up unexpectedly and rushes into the junction.",
#:   "The throttle of the other car sticks and it shoots over the crossroads.",
#:   "The adversary gains speed on entering the intersection and forces the ego to brake.",
#:   "The crossing driver floors the pedal and bursts through.",
#:   "The approaching car does not slow but surges into the junction.",
#:   "he sees us coming and still puts his foot down to get over first",
#:   "Vehicle 2 accelerated into the intersection on a conflicting path.",
#:   "slow approach, then full throttle into crossing",
#:   "He was just pottering up to the junction, then he hoofed it and went straight in.",
#:   "Unit 2 increased its speed upon reaching the intersection and entered it.",
#:   "Truck near x-ing, sudden gas, goes in.",
#:   "On approach to the junction the target vehicle abruptly raises its speed and enters the conflict area.",
#:   "The bus gives suddenly gas and drives in the crossing.",
#:   "Actor steps on it at the junction entry, single burst of throttle, no braking after.",
#:   "She thought it would wait, but it gathered itself and charged into the crossroads.",
#:   "The motorbike's opened up all of a sudden, he's going into that intersection whether you like it or not.",
#:   "he was rolling up to the intersection all slow then just gunned it in",
#:   "A saloon put on a sudden spurt and plunged into the crossroads.",
#:   "Upon nearing the junction, did you or did you not press down harder and go in?",
#:   "Near the signal he was coming normal, then full race he has entered inside the junction.",
#:   "You think he's going to hang back at the crossing, and no, he gives it the beans and in he goes.",
#:   "Unexpected speed increase of vehicle at intersection entry",
#:   "SUV SUDDENLY FLOORS IT INTO THE JUNCTION",
#:   "The truck spurts into the crossroads.",
#:   "Crossing lorry opens the taps and is in the junction.",
#:   "Where it might have waited, the hatchback picks up speed and enters.",
#:   "V2: abrupt throttle application at the mouth of the crossroads; enters.",
#:   "Il accélère d'un coup, and already he is inside the crossing.",
#:   "Instead of giving way the scooter gets a move on, into the junction.",
#:   "At the last yards before the crossroads the taxi, which had been coasting, had its accelerator pressed hard and was carried on into the junction.",
#:   "The bus driver admitted having quickened sharply on the approach so as to be in the intersection ahead of us, without lifting off at any point.",
#:   "I want the other car to approach at its usual pace and then, once we are near, give it full power into the intersection.",
#:   "You could hear the motorcycle's note go up an octave and in it shot, in among the crossing traffic, still gathering way.",
#:   "Did anybody expect that SUV to put a spurt on like that? One sudden shove of speed and it was over the line and in the crossing.",
#:   "Dash cam, Tuesday: artic nearing crossroads at walking pace until he plants his right boot, then forty tonnes of him is in the middle.",
#:   "As the pupil you must never rely on the other one waiting. See that van? He was ambling along, he has seen us, and now he has opened her up and he's driving into the junction as fast as it will pick up.",
#:   "The subject vehicle had a clear view of the pickup coming from the other road. It was going steadily and then, a few lengths short of the intersection, its speed rose sharply, and it was still rising when the pickup was inside the intersection.",
#:   "My husband said it would stop, I said it wouldn't, and I was right. The little car sort of squatted down at the back, the way they do when somebody stamps on the accelerator, and it came whizzing into the crossroads and never slackened.",
#:   "Conflict vehicle behaviour: nominal approach along its own trajectory, then a step in the accelerator demand once the distance of the test vehicle to the meeting point falls below threshold. The throttle remains applied through the junction; neither a brake nor a stop phase follows.",
#:   "Honestly I thought the coach was letting me go, he'd been so leisurely about it. Next thing there's a cloud of diesel out of the back and he's charging the intersection, and he kept building up speed the whole way in.",
#:   "Cruising up to the crossroads, he suddenly goes full gas inside.",
#:   "Motorcycle whips up speed and barrels into the intersection.",
#:   "Abrupt power at the junction's edge; in comes the lorry.",
#:   "That minibus was taking its time until the last few yards, then it lurched forward like a greyhound and entered the crossroads still picking up.",
#:   "dude sees me getting close to the intersection and instead of waiting he mashes the gas and comes flying in",
#:   "As the ego nears the conflict point, the other vehicle's drive torque is raised in a step so that it enters the intersection with growing speed.",
#:   "He was coming easy easy towards the chowk, and all of a sudden he is giving full accelerator and entering, not caring for anybody.",
#:   "Have the pickup roll up to the junction unhurriedly; when we're almost there it should put on a sudden burst and run into it under power.",
#:   "Driver of the coach, according to a passenger, \"stamped on it\" shortly before the crossing and carried them into it faster and faster.",
#:   "I only heard it, as I was bent over the pram. There was an engine purring along, the way they do when somebody's about to stop for the crossroads, and then there was a bellow. When I looked up the red car was in the middle of the junction, and the bellow was going up and up.",
#:   "V2 approached the intersection at an approximate speed of 22 mph. Four feet prior to the edge line the recorded accelerator position changed from 12 to 100 percent. V2 entered the intersection at 29 mph and was still gaining speed at the area of impact.",
#:   "What would a sensible driver have done with us so close? Lifted, I suppose. This one, a lady in a big SUV, had been ambling along until she saw us, and her answer was the right-hand pedal: up came the bonnet, and she was thrown into the intersection as from a sling.",
#:   "I make allowances for buses, I was a conductor once. They don't as a rule hurry. So when this one came loping up to the junction I was already letting in the clutch, and then it gathered itself up, people fell about in the aisle, and it was coming into the crossing at a rate of knots with its foot well in.",
#:   "The gap I'd judged was a fair one for the speed he'd been doing. It wasn't a fair one for what he did, which was to open the throttle wide just as I committed. The scooter shot into the crossroads with the rider flat on the tank, and it was I who had to find the brakes.",
#:   "Regression 88 fails on the crossing truck. It cruises along its own path at constant speed as configured, and at thirty metres of ego distance we command the accelerator to a fixed high value. The planner has assumed it'd go on at cruise; it reaches the box a second early and hasn't finished accelerating.",
#:   "In Bavaria one says he got the wild bee. The Golf is coming calm to the crossing and I think, good, he has seen me. Then the motor cries, the front goes high and he drives in with always more speed, and for me stays only the full brake.",
#:   "Listen to the recording again, members of the jury. You will hear a steady note, which is the defendant approaching the junction. You will then hear that note leap up, although the claimant's vehicle was in plain view; and it is still rising when the defendant's car has passed the mouth of the crossroads.",
#:   "A puddle the size of a tablecloth lies at that crossroads, and cars usually creep through it. The van that came that morning looked set to do so. Instead its rear wheels spun, it was hurled at the puddle and into the crossing with the throttle held down, and we on our side got the whole tablecloth.",
#:   "Coming up to the intersection I've got the tipper in sight, he's doing what I'd do with a load on, nice and steady. For some reason he then decides he's an F1 driver. Black smoke, nose up, and all eighteen tonnes is charging into the box, faster with every yard.",
#:   "Somebody's tea was on the bonnet when he set off, I should think, he was driving that gently. Then a step before the intersection he must have looked at his watch. He put his foot through the floor, and in he sailed, getting quicker, and my bicycle and I went up on the grass.",
#:   "Not slowing, no, he's found another gear and he's in.",
#:   "Bonnet up, exhaust note up, lorry into the crossing.",
#:   "Revs climb, the hatchback storms in among us.",
#:   "The sensible thing would have been to ease off at the crossing; the bus driver's right foot went the other way and her bus went in like a train.",
#:   "At the set ego distance switch the target from cruise to a fixed high throttle and keep it there while it passes the mouth of the junction and beyond.",
#:   "he was doing like 20, i could've made it easy, then i hear vtec and he's in the middle of the intersection doing 45",
#:   "He came to the crossing with the speed of a bicycle and he went inside it with the speed of a rocket, without any reason, Herr Inspektor.",
#:   "Everything told me the pickup would arrive after me, until its tailpipe coughed black and it leapt at the crossroads and was in it first, still gathering.",
#:   "Why, having trotted up so peaceably to the crossroads, did the motorcyclist twist his wrist to the stop and burst in among the cars on the other road?",
#:   "I'd done the sum in my head, so many yards for me, so many for him, at the rate he was going. The sum was right. He altered the figures, that's what he did, a stone's throw from the crossing, and there I was, halfway to where I'd be safe, with a coach bearing in on it quicker each time I looked.",
#:   "V2 had maintained 24 mph for the preceding eight seconds. With the intersection 40 feet ahead of it, V2's tachometer reading doubled. No brake input was registered from then until impact, at which time V2 was well inside the intersection and travelling at 37 mph.",
#:   "Two things about a tipper lorry, from one who drives a recovery truck. When they're going to stop at a crossing, they hiss. When they're not, the stack smokes. I was standing at the corner with a cup of tea, and there'd been neither hiss nor smoke; then there was smoke, plenty of it, and that tipper went in like the wrath of God, building and building.",
#:   "It was the flag on her aerial that I noticed, a football flag. It had been hanging down as she came up the side street. A few yards from the junction it stood out straight, flapping fit to tear, and in that condition it came over into the crossing at us, and the bonnet was high, so I knew she wasn't braking.",
#:   "Passengers in our robotaxi complain of a hard stop at Fifth and Pine. The crossing van's arrival time had been predicted from a constant 8 m/s. Shortly before the box its acceleration went from 0 to 4 m/s² and did not return to 0, so it was in the box a good second and a half before its time.",
#:   "Reader, I trusted a scooter. He was put-putting along the cross street with a pizza on the back, at a pizza's pace, and I looked away to wipe the mirror. The put-put became one long shriek. By the time my eyes were round again he was flat on his tank within the junction, and I was standing on everything I had.",
#:   "My lord, I don't complain that he came on; I complain of the manner. Had he come on as he was, I should have been through. My friend calls it \"a touch of gas\". The touch lasted from ten yards outside the intersection until he was in the midst of it, and the taxi's rear tyres left rubber for the whole of that distance.",
#:   "Grandma has a word for drivers like that one, but she won't say it. First the blue car was slow, and I said he's letting us go. Then it sort of sat down at the back and made a big lion noise, and it came out into the middle where all the roads meet, faster and faster, and Grandma said a different word.",
#:   "The needle of opportunity, my old instructor used to call it: that last second when they see you and choose. Most choose the left pedal. Watch the fellow in the estate; he has seen us, his face says so, and the front of his car isn't dipping, it's rising. He'll be in that crossroads with his engine flat out before you've said Mississippi.",
#:   "I have in my truck a camera, I show you. Here he drives, the small van, from the other street, comfortable, I think forty. Here is the beginning of the crossing. And here, look at the tyres, they turn empty, he is giving it everything; in the next picture he is in the crossing and blurred, and I'm hanging in my belt.",
#:   "It had been a contest of politeness, or so they'd supposed; the long grey car idled nearer to the crossroads, and they idled nearer, each waiting for the other to be first. All at once the long grey car had no manners. It gave a roar, it reared, and it was thrown into the crossroads with a haste that increased as it came.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoMeeting", "egoRoute"]
#: provides = ["AdvBehavior", "advTurn"]
#: origin = "base scenarios crossing-negotiation, red-light-running, unprotected-left-turn; own code"
#: [slots]
#: actions = ["accelerate"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 12.0
#: high = 48.0
#: unit = "m"
#: meaning = "how far the ego still is from where their ways meet when it accelerates"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 0.8
#: high = 2.5
#: unit = "m/s"
#: meaning = "how fast it approaches"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.5
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"

param OPT_ADV_DISTANCE = Range(12, 48)
param OPT_ADV_SPEED = Range(0.8, 2.5)
param OPT_THROTTLE = Range(0.5, 1)

advTurn = ("straight", "left-turn", "right-turn")

behavior AdvBehavior():
    do DrivePath(advTrajectory, globalParameters.OPT_ADV_SPEED) until distanceLeft(egoRoute, ego, egoMeeting) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE)
