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
