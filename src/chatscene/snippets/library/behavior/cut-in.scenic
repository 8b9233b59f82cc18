#: description = "The car suddenly cuts in front of the ego and drives on."
#: rephrasings = [
#:   "A vehicle from the next lane swerves into the ego's.",
#:   "The adversary changes lanes right before the bonnet.",
#:   "The neighbouring car forces its way into the lane of the ego.",
#:   "An impatient driver squeezes in from beside without signalling.",
#:   "The motorbike slips over into the ego's lane just ahead.",
#:   "Somebody barges in right in front of us without a signal.",
#:   "Vehicle 2 made an unsafe lane change into the path of vehicle 1.",
#:   "Cut-in from adjacent lane, short distance.",
#:   "some muppet nipped in front of me without so much as a glance and carried on his merry way",
#:   "The box truck abruptly changed lanes directly ahead of Vehicle 1 and continued traveling.",
#:   "MC swoops in fr. of us, tiny gap, keeps going.",
#:   "The target changes lane into the path of the VUT at short headway and maintains its speed.",
#:   "The bus jumps in my lane just before me, then he drives normal.",
#:   "Cut-in actor: abrupt lane change to just ahead of the SUT, no braking afterwards, holds speed.",
#:   "A hatchback dived into the gap before his bonnet and rolled on as if it had always been there.",
#:   "There, he's gone for your gap, squeezed himself in ahead of you. At least he's keeping his speed up.",
#:   "car just snaked our spot and drove off like nothing happened smh",
#:   "A mother of two told how a minibus stole into the space before her and sped on its way",
#:   "Without warning he appropriated the space in front of my client and proceeded as if nothing had occurred",
#:   "Lorry simply put himself in front of us, no indicator nothing, then went off only",
#:   "Leave a car's length and some chancer has it off you, in he pops and off he trots",
#:   "Sudden occupation of forward gap by adjacent vehicle, speed maintained",
#:   "Motorbike STEALS my gap and just keeps riding",
#:   "The coupe pounced into our lane and pressed on.",
#:   "White van helped himself to my braking distance and pushed on.",
#:   "Neighbour swaps into the ego's lane at tiny headway, then carries on at speed.",
#:   "A coach just swept across the line ahead of us and kept on motoring",
#:   "Moto filtered in from next lane ahead of me, no slow, only continue.",
#:   "Have a saloon swerve in ahead of the robotaxi and simply travel on.",
#:   "I was minding my own business when a people carrier muscled its way over from the next lane, landed a few feet off my bumper and kept going at normal pace.",
#:   "The offender came over from lane two, took the slot directly in front of us without warning and proceeded on his journey as though we were not there.",
#:   "Please let a motorcycle hop across the lane marking into the space before the AV's bumper at the last moment, after which it rides on steadily without slowing.",
#:   "V2 encroached into the lane of V1 at an insufficient distance and thereafter remained ahead of it, travelling at undiminished speed down the same lane.",
#:   "Why do lorries think an indicator flash gives them the right? This one shoved across, filled my windscreen, and rumbled away ahead of me.",
#:   "Señor, the car from the side lane, he puts himself in front of my nose with no warning, and after this he continues normal, very calm.",
#:   "Nobody got hurt, thank goodness, but my coffee went everywhere. A silver estate came over from the neighbouring lane with barely a hand's breadth to spare, and off it cruised down our lane as if the rest of us were scenery.",
#:   "The manoeuvre to be tested is a short-headway intrusion. The target, initially running level in the adjoining lane, transfers abruptly into the lane of the subject vehicle and then continues at its set speed; at no time does it decelerate after entry.",
#:   "I ride in every day and I left what I thought was a sensible gap to the traffic ahead. A cab in the other lane regarded it as an invitation, darted over in front of my wheel and went merrily onward.",
#:   "By the time Grandad had finished saying that it would never fit, the bus had fitted. It had simply come across out of its own lane and was trundling along ahead of us with its adverts in our faces.",
#:   "What the recording shows is quite ordinary rudeness. The hatchback is beside us, then without any signal it is in our lane, close enough to read the dealer's sticker, and from there it just drives on with the flow.",
#:   "Bus noses over into our lane ahead and simply keeps rolling.",
#:   "One lane over, then bang, in my lane, then away down it.",
#:   "Motorcycle pinches the AV's headway and motors on unbothered.",
#:   "The cabbie decided that my lane was better than his, so without a blink he planted himself before my bumper and continued along it.",
#:   "Adjacent HGV commences lateral movement at minimal clearance, completes it in front of the VUT and thereafter proceeds at an unchanged velocity.",
#:   "Suddenly there was a coach's rear window where the empty road had been; it had slid across from beside us and was bowling along at our pace.",
#:   "Request: neighbour agent gives no warning, whips over to just in front of the subject vehicle, then cruises down that lane with no lift and no brake.",
#:   "Le camion, he was at my side, he jumps over the line just before my hood, and he rolls, he rolls, like I do not exist.",
#:   "Passenger states a silver people carrier shot over from the next lane without indication, clearing the front wing by inches, then drove ahead normally.",
#:   "You get used to seeing that gap in front as yours. On the ring road last night I had about two car lengths of it, and the next second there was an estate's tailgate in there, the family dog looking out at me, and the estate cruising on as if it had been there since breakfast.",
#:   "I had just told the pupil to keep a proper distance, so of course somebody had to use it. The little van beside us didn't signal; its wheels were over the line before I could finish my sentence, and now it's pottering ahead of us at the same thirty as everyone else.",
#:   "The insured had to brake from 50 to 35 because her safe distance was taken from her. A motorcycle changed from the lane on her left directly in front of her front wheels and, having done so, rode on without any reduction of its own speed.",
#:   "What the lidar shows at t = 14.2 s is a lateral jump. The track that had been alongside for half a minute is all at once dead ahead at six metres, and from 15 s on its range is slowly opening again, since it went on at its old pace.",
#:   "Nan said a word I'd never heard from her. A lorry as long as our street had been next to us, and it came over when we were still there, or nearly, so that we got its mud flaps in our face, and then it just grumbled off down our lane.",
#:   "There's a special place for people who indicate after they've done it. Picture the hatchback: it's in its lane, it's in my lane, a hair's breadth off my bumper, then the flasher goes tick tick, and away it toddles in front of me, perfectly content.",
#:   "The sergeant asked how near. Near enough, I said, that I lost sight of its bumper under my bonnet. It had been running level with the robotaxi in the other lane until it snatched the space ahead; after that it did nothing out of the way, it only continued along the road.",
#:   "No brake lamps, no drama afterwards, that's what makes it a fair test of the gap logic. The bus simply isn't in its own lane any more from one instant to the next, it's in ours, far too near, and it goes on from there at the pace it always had.",
#:   "I drive tippers, I know what it takes to stop one. So when a chap in a coupé thinks the room I leave is there for him, leaps out of his lane into it right under my grille and then carries on his merry way, I count to ten.",
#:   "Marta saw a flash of chrome at her elbow, then a tail-light where no tail-light had any right to be. The motorcycle had taken her bit of road from under her in one hop; and it droned on ahead through the rain, steady, indifferent.",
#:   "As far as rules go, we had priority in our lane, isn't it? But the school bus from side lane came inside, no signal, one foot in front of our number plate, and after that he was driving very normally as though he has done nothing.",
#:   "Headway was two seconds; now it's a minibus, and the minibus isn't slowing.",
#:   "Was beside us, is before us, no blinker, still motoring.",
#:   "My safety gap got a tenant: one scooter, doing the same speed as everybody.",
#:   "I'd left room for a lorry, and a lorry is what I got, over from the next lane in one heave and then away in front as steady as you like.",
#:   "Let a bus in the adjoining lane take the space right ahead of the AV with no warning and continue up the AV's lane without touching the brakes.",
#:   "I'd been reading the number plate two cars up, and suddenly it was hidden by a hatchback's rear wiper, which had been level with my wing a moment earlier and now went happily on.",
#:   "At frame 212 the neighbour straddles the dashes, at frame 230 it's wholly in our lane seven metres off, and from there the distance only grows.",
#:   "My foot had left the pedal before I knew why: a motorbike from the side lane was under my front bumper, nearly, and running on.",
#:   "A coach, previously abreast of V1 in the adjoining lane, entered the space immediately forward of V1 without signal and carried on at unreduced speed.",
#:   "I only know that the road was ours and then that it wasn't. A wall of painted vegetables stood where my view had been, it had slid in from the right without so much as one tick of an indicator, and it drew me along behind it at the same forty we'd both been doing.",
#:   "The adaptive cruise did that lurch it does. It had been following the white car at fifty metres, and all at once it was following something at six. That something was the camper from lane two, come over in a single wriggle, and as it neither braked nor dawdled the cruise soon got its breath back.",
#:   "Four people want the same bit of road and one of them hasn't asked. It's the taxi. You'll have felt me touch the dual brake just now, that was for him; he's put himself where our stopping distance used to be. He's off down the lane now, no harm done, so build it up again.",
#:   "What annoyed the old gentleman wasn't the speed, for the youngster kept his speed up nicely afterwards. It was finding a motorcycle's back wheel spinning a yard beyond his own bonnet ornament, when a blink before it had been over by the next set of dashes, and nobody had so much as stuck out an arm.",
#:   "The grit on my visor came off his tyres. I was on my motorbike with a decent bit of tarmac ahead, the tipper was in the other lane, and the next thing I had his mudguards in my face and his spray in my teeth. He carried on as if I'd been a fly. I dropped back and let him.",
#:   "Did it indicate? No. Was there space? Barely a car's length. Did it brake afterwards? It did not; it went along in front of the claimant at the general pace. But she had already hit her own brakes by then, and it's the gentleman behind her who could not.",
#:   "Please reproduce the event from the Lyon drive. Someone is level with our front wheel in the neighbouring lane; from one second to the next his entire car is ahead of us instead, at a time gap of 0.4 s; the gap recovers by itself because he continues at his former velocity.",
#:   "Emma had been watching the bus driver eat a banana. He was right there, on the other side of the glass, and when he'd finished it he put both hands on the wheel and we lost him. All we had then was the back of the bus, terribly near, and it hummed off along our lane.",
#:   "The newspapers would call it a near miss. There was a yelp of our tyres, not of theirs. The SUV which had just occupied our lane from the side, with about a door's width to spare, showed no brake light then or later, and was soon part of the ordinary stream ahead of us.",
#:   "It's the rain, you see, they can't wait in it. My wipers went over once and there was road; they went over again and there was a van, out of the next lane and smack before my grille; by the third stroke it had trundled on a bit, same speed as the rest.",
#:   "We in Shenzhen say: keep distance, lose distance. I kept twenty metre for safe. A silver car from side lane saw the twenty metre, not give any lamp, one second he is inside, his back almost touch my front. Then he drive normal, very relax, and I must make new twenty metre.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle"]
#: requires = ["advLane", "egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario lane-changing; own code"
#: [slots]
#: actions = ["cut-in", "change-lane"]
#: leader = false
#: blocker = false
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = -15.0
#: high = 20.0
#: unit = "m"
#: meaning = "how far before the start of its manoeuvre the ego is when the adversary acts"
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 4.0
#: high = 9.0
#: unit = "m/s"
#: meaning = "how fast it drives then"

param OPT_ADV_DISTANCE = Range(-15, 20)
param OPT_ADV_SPEED = Range(4, 9)

behavior AdvBehavior():
    do KeepStation(advLane, ego) until distanceLeft(egoRoute, ego, egoRoute.eventAt) < globalParameters.OPT_ADV_DISTANCE
    do DrivePath(ownLane(egoRoute), globalParameters.OPT_ADV_SPEED)
