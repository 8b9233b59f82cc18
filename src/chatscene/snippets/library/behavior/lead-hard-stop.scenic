#: description = "The car ahead slams on the brakes, comes to a dead stop and stays there."
#: rephrasings = [
#:   "The guy in front of us slams the anchors on and just sits there.",
#:   "Vehicle 2 decelerated rapidly, came to rest in the travel lane and remained stationary.",
#:   "Lead veh emergency stop, then stationary in lane.",
#:   "The target performs full braking down to standstill in front of the VUT and holds its position.",
#:   "The lorry before us makes sudden full stop and does not move any more.",
#:   "An ambulance we follow brakes to zero in an instant and plugs the lane.",
#:   "The bus ahead of the ego screeches to a halt and refuses to budge.",
#:   "Whoever leads us stands on the pedal until nothing moves, leaving an obstacle in our lane.",
#:   "The car in front slammed everything on, stopped dead and wouldn't budge.",
#:   "The lead vehicle made a panic stop and remained stationary in the travel lane.",
#:   "Lead: emergency brake to 0, stays put, lane blocked.",
#:   "The lead target brakes with maximum deceleration to standstill and remains stationary.",
#:   "The car in front makes full brake, stands and does not go more.",
#:   "CCRb variant: lead does a full-force stop and holds zero for the rest of the run.",
#:   "His tail lights blazed, the nose dipped, and there he stood in front of her and did not move again.",
#:   "Emergency stop from the lorry ahead, he's dead in the road and he's not going anywhere!",
#:   "car in front just STOPPED. like full stop. didnt move again",
#:   "The van ahead pulled up with a screech and did not stir from the spot.",
#:   "He brought his vehicle to an immediate standstill ahead of her and there it remained, blocking the lane?",
#:   "The front taxi jam brake until full stop, and then never move already.",
#:   "Bang, he's stopped, full stop, and there he sits like a garden gnome.",
#:   "Maximum-effort stop of lead vehicle with persisting lane blockage.",
#:   "CAR IN FRONT PANIC STOPS AND NEVER MOVES AGAIN",
#:   "The car ahead nailed itself to the spot.",
#:   "Fire engine ahead brakes to nothing in an instant and stays parked there.",
#:   "Full anchors from the hatchback leading us, then permanent roadblock.",
#:   "Motorbike in front of AV: sudden zero, no restart.",
#:   "Let the leading coach stop violently and remain where it is.",
#:   "Skid, silence, and the lorry ahead stood there for good.",
#:   "The driver of the car I was behind must have jumped on the brake with both feet, for it went from fifty to nothing and then stood there.",
#:   "At t0 the preceding target is brought to rest with 8 m/s² and shall not be released until the end of the measurement.",
#:   "Generate a minibus travelling ahead of the ego that makes a crash stop and from that moment on is a stationary obstacle in the lane.",
#:   "Our insured collided with the rear of a Skoda, which, having until then led him at normal speed, stopped with locked wheels and did not resume its journey.",
#:   "vor mir the truck makes a Vollbremsung, he comes to standing and there he rests, the street is closed with him",
#:   "Two seconds, I said, and now you see what for: the taxi ahead has gone down on its nose, it's stopped, and it's staying stopped.",
#:   "We were trundling along behind a patrol car, everything calm. Its tail went up in the air, the tyres howled and it was standing still before I had lifted my foot. We waited for it to go on again but it just stayed in the lane.",
#:   "Unit 2 was the lead vehicle. For reasons not determined, its operator braked to the limit of adhesion, leaving sixty feet of skid marks that end under the tires of Unit 2 where it remained at rest, occupying the lane, until police arrived.",
#:   "You're behind a big artic, all you can see is its doors. The doors come at you, fast, and there's smoke off the wheels, and by the time you've understood it's standing across the end of your bonnet with no intention of ever leaving.",
#:   "I was on the pushbike behind a motorcycle when its rider hauled on everything he'd got. He was stopped in less than a length. He put his feet down and there he remained, in the middle of our lane, helmet turning left and right.",
#:   "For the regression suite: lead actor drives ahead at the ego's speed, then full emergency deceleration to rest. No timeout after that, the actor simply keeps blocking the lane, since we want to see whether the AV goes into a safe hold.",
#:   "Bus ahead: full brake, dead stop, and there it stuck.",
#:   "We nearly climbed his boot, he'd stopped stone dead for good.",
#:   "Lead fire engine emergency-stops and remains planted in our lane.",
#:   "The rear of the coach we'd been trailing lifted, its speed vanished, and it stood where it had stopped until the recovery people came.",
#:   "Preceding target to apply maximum brake pressure at TTC marker, arrive at rest in lane, and be left there as an obstacle.",
#:   "In front the motorcyclist locks both wheels, he is stopped at once, and he makes no gesture to continue, the lane is finished for us.",
#:   "Could the van we're following throw out everything it has till it's motionless, and then never let us through again?",
#:   "MOT failed? No, mate, the saloon before me just went from sixty to nought in a heartbeat and then squatted in the lane like a toad.",
#:   "The lead driver, believing he had seen a deer, braked so violently that his lorry was brought to rest almost on the spot, whence it did not stir.",
#:   "I had the kettle between my knees, don't ask. The camper ahead had been bumbling along with us behind it for an hour. There was a shriek of rubber, its back end filled the windscreen, and then it was as still as a house and stayed as still as a house, with us inches from its bicycle rack.",
#:   "It took three of us to push it away afterwards, for its engine had cut out. The pickup had been leading our little convoy when its driver, seeing the bridge was closed, tramped on the brake so that all four wheels smoked. It finished square in the lane and that's where it lived for the next hour.",
#:   "Narrative: V1 was following V2, an ambulance not on call. V2's ABS event was triggered at 41 mph and ended at 0 mph, 2.3 seconds later. V2's speed channel reads 0 from that point to the end of the record, and photographs show it occupying the lane entirely.",
#:   "The child in the child seat was the first to speak. \"Why isn't it going any more?\" Because, her father said when he'd got his breath, the nice taxi in front wanted to stop very, very quickly. \"And why isn't it going now?\" That he couldn't answer; it just stood there, and all the lane was taxi.",
#:   "Over here you learn to watch the shadow under the car in front. When the shadow of this one got short at the front and long at the back, I was already on my pedal. He pulled it up as if there were a cliff, and he didn't budge after that, so the lane was shut and I sat and sat.",
#:   "Post-run comment from safety driver: lead lorry at 22 m ahead, uneventful for six minutes. Then it decelerated as hard as a laden lorry can, 7-something, to a standstill. Our system stopped with 1.4 m left and asked for help after sixty seconds, as the lorry had not moved and the lane was blocked.",
#:   "On the pushbike you draft, you know, it's naughty but you do. The van I was drafting hit its brakes with everything, no warm-up. I went into the doors with my shoulder. He'd come to rest and he kept at rest, he was just sitting in there with both hands on the wheel.",
#:   "You have passed your theory, so what did that bloke in front do right now? He did an emergency stop. And what's he doing after it? Nothing, precisely nothing, his wheels aren't turning and they're not going to. So we're in a blocked lane, handbrake on, and let's have the hazards.",
#:   "Respected sir, I was maintaining distance behind one Innova. All of a sudden that Innova has put such a brake that its back side went up like a goat. It became fully standing in the lane and driver was not starting again, not even after lot of honking, therefore road was jammed up to the temple.",
#:   "Episode 40, lead vehicle family, worst case of all. You follow a motorbike at matched speed. It goes to full deceleration with no warning, comes down to zero and will not set off any more, so what was your lead a second ago is now a fixed obstacle in your lane, rider standing astride.",
#:   "Glass was not involved, contrary to the first reports. The lady's injuries come from the belt, since the robotaxi had to pull up within eighteen metres. It did so because the delivery lorry it followed had slammed to a standstill, and a standstill it remained: its driver was found still in the cab, in the lane, half an hour later.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "Euro NCAP CCRb, UN R152; own code"
#: [slots]
#: actions = ["brake", "stop", "block"]
#: position = "ahead"
#: leader = false
#: blocker = false
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 5.0
#: high = 30.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_BRAKE"
#: low = 0.7
#: high = 1.0
#: unit = "1"
#: meaning = "how hard it brakes"

param OPT_ADV_DISTANCE = Range(5, 30)
param OPT_BRAKE = Range(0.7, 1)

behavior AdvBehavior():
    do KeepStation(advTrajectory, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do BrakeOnPath(advTrajectory, globalParameters.OPT_BRAKE)
