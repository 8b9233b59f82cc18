#: description = "The car suddenly accelerates and then decelerates."
#: rephrasings = [
#:   "A vehicle shoots forward and shortly after slows hard.",
#:   "The adversary gains speed abruptly, then brakes.",
#:   "The driver speeds up to get past the ego and at once hits the brakes.",
#:   "The car rushes ahead and loses its speed again.",
#:   "First full throttle, then full brake: the vehicle beside is unreadable.",
#:   "The guy next to us guns it and then straight away slams on.",
#:   "Vehicle 2 accelerated briefly, then applied hard braking.",
#:   "It gives gas first and after two seconds it brakes full.",
#:   "this Corsa up the road put a spurt on for no reason and a moment later he'd scrubbed all the speed off again",
#:   "Operator of unit 2, a Dodge Ram, gunned the engine for a short distance and then got hard on the brakes.",
#:   "Coach: burst of speed, then anchors. Once only.",
#:   "The target motorcycle performs a single acceleration phase, immediately followed by a deceleration phase.",
#:   "the lorry first goes fast suddenly, after this he makes slow",
#:   "Ticket: NPC needs one throttle pulse followed by one brake pulse; currently it only holds a constant speed.",
#:   "The biker had whipped the throttle open, and before we could make sense of it he had squeezed the lever and dropped right back.",
#:   "See that van? Foot flat to the floor, and now he's thought better of it and he's shedding it all again.",
#:   "lol that van just yeeted itself forward n then 2 secs later full on brake lights",
#:   "A motorist who put on a sprint in Mill Lane, only to haul his vehicle back down moments afterwards, baffled onlookers",
#:   "Is it not the case that you opened the throttle wide, counsel put it to him, and straight afterwards stood on the pedal?",
#:   "Uncle suddenly zoom ahead, then jialat, jam brake for what also don't know",
#:   "Makes up his mind he's Lewis Hamilton for three seconds, then bottles it and drags it all back down, beats me",
#:   "Unexpected speed peak of neighbouring vehicle with immediate subsequent loss of velocity",
#:   "BIKER floors it... then INSTANT REGRET (brakes)",
#:   "The bus spurted, then checked itself.",
#:   "Pickup puts its foot down, next thing it goes for the middle pedal.",
#:   "Target: strong positive longitudinal acceleration, then strong negative. End of event.",
#:   "The motorbike went vroom and then it went eeek and got slow.",
#:   "Why would a lorry sprint and then rein itself in straight away?",
#:   "HGV BOLTS, THEN CLAMPS ITS WHEELS",
#:   "I want a scene where the hatchback tears off with a burst of power and a couple of seconds on uses its brakes.",
#:   "Witness stated that the Transit surged as though late for something, and that its stop lamps lit up a heartbeat later as it lost way.",
#:   "Please to observe: the coach first takes up much speed, all at once, and directly afterwards it is braking.",
#:   "V2 was stated by its operator to have increased speed rapidly before he slowed it by heavy pedal application; no reason was given.",
#:   "All units, silver saloon on the ring road, keeps pace, then floors it, now he's hauling it in again.",
#:   "Notice the scooter, he winds it on as if the lights were about to change and then kills that speed with both levers.",
#:   "I was minding my own business behind the wheel of my old Volvo when the minibus took off like a scalded cat. Hardly had I tutted about it than up went his rear end and he was braking for nothing I could see.",
#:   "The brake phase seemed to come out of nowhere, but on the replay you notice what went before it: two seconds earlier the truck had pulled hard, gained maybe fifteen km/h on us, and only then did the driver press the brake.",
#:   "In my thirty years on the artics I've seen some daft things. This tanker had been plodding along, then suddenly it had the horses out and was pulling like mad, and before I'd finished swearing the air brakes were hissing and it was dropping its speed.",
#:   "Scenario intent: check that our prediction does not extrapolate the spurt of the other motorcycle. At the trigger distance it ramps up its velocity at the configured throttle for a short interval, and then it ramps it down with the configured brake pressure.",
#:   "Monsieur, I think he wanted to make the green light. The bus, he launches himself with all his motor, we hear it roar, and then he gives up this idea and one sees the red lamps and he becomes slow.",
#:   "Saloon lunges, thinks twice, and sheds its pace again.",
#:   "Van piles on the revs, then bleeds it all off.",
#:   "Quick sprint from the coach, followed by a hearty application of brake.",
#:   "The rider of the scooter, you will note, gains a good twenty kilometres an hour in a trice and gives it all away again just afterwards.",
#:   "Set the truck actor to boost for a couple of seconds once the trigger fires; when the boost ends it shall decelerate with the given brake value.",
#:   "I was only doing thirty, and the lady in the Kia made like it was a drag race and then squashed the brake.",
#:   "Claimant recalls that the lorry's engine note climbed sharply, that the lorry drew on at once, and that afterwards its brakes were plainly heard to bite.",
#:   "For no visible motive the taxi has taken a big élan, and after this élan he has braked as if he regretted it.",
#:   "DASHCAM: Merc driver shows off his horsepower for about two seconds, then has to show off his discs as well",
#:   "I told my pupil to leave the pickup well alone. It had been trundling along at our pace, perfectly dull, and then the lad in it mashed the throttle, probably for his mates on the pavement. You could see his head snap forward a moment later, because he had gone straight to the brake.",
#:   "The event data recorder of V2 shows pedal position going from 12 to 100 percent, speed rising from 41 to 58 km/h, and then brake switch ON with the speed back at 37 within three seconds. No explanation for this was offered by the operator, who was uninjured.",
#:   "There's a bit of dual carriageway by the retail park where the bikers like to play. One of them took off with his front wheel pawing the air, and we all thought that was the last of him, until his stop lamp came on and his speed was gone as quickly as he had found it.",
#:   "What stays with me is the sound. First the whine of the bus's turbo going up and up while everyone standing inside it must have staggered backwards, then a squeal, and everyone must have staggered the other way. My husband just said, make up your mind, driver.",
#:   "Our subject vehicle's speed predictor got it wrong twice in four seconds. When the hatchback spurted away it assumed a fast road user and relaxed; it had barely relaxed when the same hatchback lost all of that gain under braking. Please add this pulse to the regression suite, it happend on three of five runs.",
#:   "Sir, I am driving in India since eighteen years and such confusion I have seen daily, but this one was special. The tempo suddenly took full race, black smoke and all, and when I was thinking he is late for some delivery, he put brake and became slow again like before.",
#:   "It was a boring commute with the radio on. The Range Rover leapt away as if stung, so my foot went off the gas out of pure surprise. Good thing too, since the next thing I saw of it was three red lights and a tailgate rising, the whole hurry over as abruptly as it had begun.",
#:   "Two dark patches on the asphalt told the tale to the investigators: a short pair where the driving wheels of the coach had spun under full power, and, about thirty metres on, the longer pair which its locked wheels had left as it was hauled down again. Nobody had been hurt.",
#:   "Dispatch, can you log a silver estate on the A34, driver possibly impaired. We were holding fifty with him, he surged to about seventy out of nowhere, and no sooner had we called it in than he was hard on the anchors and losing it all. No collision, nobody else involved so far.",
#:   "For the robotaxi the difficulty lies in not over-reacting. A minibus that keeps station with it is made to produce a burst of forward thrust of limited length and, directly after that burst has ended, a firm retardation. Neither lateral motion nor a standstill of any other road user is part of the exercise.",
#:   "My gran says it was the cat that did it. The man in the little blue car had let go of its basket, so it jumped on his knee, so he jumped on the pedal and off the car flew. Then he found the other pedal, and down came the speed with a horrid screech, and gran dropped her mints.",
#:   "One great heave forward from the coach, then its nose dipped.",
#:   "Motorbike: wound up fast, wound down just as fast.",
#:   "Speed trace of the taxi looks like a shark's fin.",
#:   "The needle of that lorry must have leapt to sixty and flopped back to thirty before he could have read either figure.",
#:   "The delivery rider opened his scooter right up for three seconds or so, and then both brake levers came in and it all melted away.",
#:   "I want the SUV to lunge off on a sudden blast of engine power, and as soon as that blast is spent to retard firmly.",
#:   "Bus passengers were first pressed into their seat backs and an instant later thrown against the rail in front; the driver had no explanation for either.",
#:   "Why did the gap to that hatchback open like a concertina and close again the moment his red lamps lit?",
#:   "V2's tachograph records an abrupt climb of 22 km/h followed, without any interval of steady running, by a drop of 30 km/h under service brake.",
#:   "My ear told me before my eye did, a diesel suddenly shouting its head off. The tipper it belonged to pulled out a good four lengths on us, the shouting stopped as though someone had shut a door, and next there were the brake lights and the four lengths were gone again.",
#:   "We expected to be left behind for good. The motorcyclist had sat with us since the roundabout, then he twisted his wrist and turned into a dot; only the dot stopped shrinking, grew a red light, and came back towards us while we were holding a perfectly even forty-five.",
#:   "Complaint ref. 2210, passenger standing on the number 9. She says that all at once the driver gave it everything, so she grabbed the pole behind her, and that straight after that she was hanging from the pole the other way round because he'd stamped on the wrong pedal, or the right one, too late.",
#:   "In China we say this driver eats wrong medicine. White car goes same speed with me for long time. Suddenly his exhaust very loud, he is flying. I think okay, bye bye. Then back of his car lifts up, lights red, and his speed is finished, everything in three, four seconds.",
#:   "A boiled sweet rolled out from under the seat of the taxi in which I was the fare, hit the back of the cab while he was flooring it, and then came rolling forward past my shoes as he checked her. That, officer, is the best evidence I can give you of what he did with his feet.",
#:   "It's a game they play, lad. See the white pickup that's been dawdling along at your pace? Tyres chirp, bonnet comes up, away he goes, and you think you've got to chase him. You don't. Look, bonnet's down already and the stop lights are on. All of that just to wind you up.",
#:   "Requirement 3.4: the surrounding vehicle shall hold its distance to the subject vehicle until the trigger. It shall then impose a step of full drive torque for the parametrised time. On expiry the drive torque is replaced by brake torque. The subject vehicle's controller shall not treat the first half as permission to speed up.",
#:   "Coffee on the windscreen, says the lorry driver's mate, and coffee on the bunk behind. The bunk came first, that was when the artic was booted without warning. The windscreen came second, when the driver saw that there was nothing to hurry for and put the brakes on as rudely as he'd put the power down.",
#:   "putting my side of it on the forum since people asked. golf wasnt racing me i was doing a steady fifty. you can see his boot squat, tailpipes puff, he gains on everybody for a blink. and then the exact reverse, boot in the air 3 red lights tyres whining speed gone",
#:   "Was there any reason to brake? None, the road was as bare as a plate. But then there had been none to bolt either, and bolt he did, that young man on the blue moped, a second or two beforehand; I had to lift my own foot lest I run up his mudguard when he repented of it.",
#:   "Smell of hot clutch, then smell of hot brakes, in that order, and both from the same minibus. We'd been plodding along in its company. What the hurry had been about nobody found out, since it had been called off before any of us in the robotaxi had done asking.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario right-turn; own code"
#: [slots]
#: actions = ["accelerate", "brake"]
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -15.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_THROTTLE"
#: low = 0.7
#: high = 1.0
#: unit = "1"
#: meaning = "how far the pedal is pressed"
#: [[parameters]]
#: name = "OPT_THROTTLE_TIME"
#: low = 1.0
#: high = 2.5
#: unit = "s"
#: meaning = "for how long"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.4
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_THROTTLE = Range(0.7, 1)
param OPT_THROTTLE_TIME = Range(1, 2.5)
param OPT_BRAKE = Range(0.4, 1)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do ThrottleOnPath(advTrajectory, globalParameters.OPT_THROTTLE) for globalParameters.OPT_THROTTLE_TIME seconds
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
