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
