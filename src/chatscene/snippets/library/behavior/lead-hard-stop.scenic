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
#:   "Anchors out, nose down, and the lorry in front was furniture.",
#:   "The leading bike stood on its front wheel, stopped, and stayed.",
#:   "Make our leader crash-stop and then never release it.",
#:   "The tail of the pickup went up, the speed went out of it, and an hour later a tow truck had to be sent for, as it hadn't left the spot.",
#:   "Whatever the cab driver saw, it made him stop us both within a car's length, and there he sat plugging the lane and staring at it.",
#:   "I kept waiting for the brake lights in front to go out, but from the moment the ambulance had screeched to a stand they were on for good.",
#:   "The lead target, at matched speed, goes to full deceleration at the cone, attains zero, and serves from that instant as a stationary obstruction.",
#:   "Our own stop was the hardest I've made in thirty years of buses, and then there was all the time in the world, the van ahead had become a wall.",
#:   "Brake! Right, well done, he's nailed it to a dead stop and he's showing no sign of going, so we're here for the duration.",
#:   "Smell first: rubber, so strong it came through the vents. Sound next, like a pig. Then sight, because I'd been looking at the sat nav, and what I saw was a hatchback that had been doing fifty along with me and was now doing nought. It did nought till the police came. I can still draw you that number plate.",
#:   "We measured twenty-one metres of black on the road, two stripes. Where they leave off, the lorry's rear wheels are standing on them. It was leading the subject vehicle by a good margin until it drew those stripes, and since the air had gone from its lines it wasn't going to make way for the subject vehicle or anyone else.",
#:   "Perhaps I should have kept walking to work. I'm on the back seat of this robot cab and there's a motorbike ahead, minding its business. Its rear wheel leaves the ground. We stop so hard I lose a shoe. \"Waiting for the obstacle to move,\" says the screen, and that's what it said till I got out and walked.",
#:   "The reason I don't tailgate fire engines can be seen at 0:31. All calm at 0:30. By 0:33 she's gone from full chat to nothing, you can see the ladders jump, and we've stopped with her hose reels over our bonnet. Then skip on as much as you like; at 9:50 the same hose reels, the same lane, the same us.",
#:   "A stop-sign would've been kinder. The saloon we'd been following for a fortnight, as it seemed, sank on its front springs with a shriek, and the road, which had been flowing, was solid. Nobody got out of it. It didn't roll on. Marguerite walked round it at last and found the driver praying, both feet on the pedal.",
#:   "Item three in the test plan concerns the last thirty seconds rather than the first two. The first two are the familiar ones: leader goes from cruise to zero with everything it's got. In the last thirty nothing happens, by design. The leader is dead in the lane, and we log what the ego makes of it.",
#:   "Heard about the queue at the tunnel? I'm the cause of the cause, I was second. The minibus before me had a wasp. You'd never believe a minibus could stop like that, I'd scarcely time to. And you'd never believe that twelve grown people could be so long about one wasp, for it didn't turn a wheel afterwards.",
#:   "Your honour will observe that there's no dispute about distance. My client had forty metres. The coach ahead used up its speed in rather less, by means of what its driver calls \"everything,\" and it then remained in the carriageway, where it was photographed at noon, at one, and at half past two, on the same four patches of tar.",
#:   "It's a thing with lead birds and with lead cars. If the first one drops, you drop. I saw his bonnet go down and his boot go up and I stood the van on its nose, and we both ended up still. I set off again in my mind several times, but he never did, he was across the way like a cork in a bottle.",
#:   "I am small and sit low, so all I see of the car ahead is the rear bumper. It was far, then it was under my chin with much noise, because she has braked as for the death. I waited that it becomes far again. It didn't. She has remained on this place, in the middle of our lane, until her husband came.",
#:   "Post-incident note by remote operator. Took over at 09:12, vehicle at rest 0.9 m behind a truck. History shows the truck leading at 14 m/s, then shedding the whole of it in under two seconds. I watched it for six minutes. Its wheels did not turn, the hazard lights never came on, and there was no room beside it.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "Euro NCAP CCRb, UN R152; own code"
#: [slots]
#: actions = ["brake", "stop", "block"]
#: position = "ahead"
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
