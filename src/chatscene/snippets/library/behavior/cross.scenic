#: description = "The pedestrian crosses the road without stopping."
#: rephrasings = [
#:   "A person walks straight across the carriageway from one side to the other.",
#:   "The pedestrian goes over the street right in front of the ego.",
#:   "A jaywalker passes through the lane at an even pace and carries on.",
#:   "The cyclist rides across the lane of the ego and leaves it on the far side.",
#:   "The adversary traverses the roadway at right angles, never pausing.",
#:   "The motorcyclist shoots over the road ahead of the ego.",
#:   "A guy on a pushbike rolls over the road and off the other side.",
#:   "The pedestrian crossed the roadway in front of Vehicle 1 at a constant walking speed.",
#:   "Someone just strolled straight over the road in front of me without breaking stride.",
#:   "A pedestrian traversed the roadway at a steady walk and did not halt for oncoming traffic.",
#:   "Ped walks kerb-to-kerb, const spd, no stop.",
#:   "The cyclist target moves perpendicular to the VUT's path at constant velocity from one side to the other.",
#:   "A man on bicycle goes over the street, he does not wait.",
#:   "Plain crossing VRU: constant speed, no reaction to ego, no pause midway.",
#:   "She stepped off the kerb and went over to the far side at her own even pace, never once stopping.",
#:   "Lady coming over from the pavement, she's walking right across and she won't be stopping for you.",
#:   "lady just walked over like no cars exist",
#:   "Shopper stepped over the busy street without a pause, onlookers said.",
#:   "The man proceeded from one pavement to the other and at no point did he halt; do I have that right?",
#:   "Uncle just walk across steady steady, never stop also.",
#:   "Off he trots to the other side, doesn't hang about, doesn't wait for me neither.",
#:   "Uninterrupted pedestrian crossing movement in ego path.",
#:   "PEDESTRIAN WALKS OVER ROAD LIKE IT'S HIS LIVING ROOM",
#:   "A cyclist traversed the street ahead of us.",
#:   "Kid on a bike comes straight over the road, no stopping.",
#:   "He crosses, plain and simple, kerb to kerb in one go.",
#:   "Simulate a jogger who crosses our street without a break.",
#:   "Old gentleman made his way to the opposite pavement without halting once.",
#:   "Moped traverses the road before us and keeps right on rolling.",
#:   "A woman pushing a pram leaves the left-hand pavement, passes in front of the ego at a constant walk and reaches the right-hand one without interruption.",
#:   "As I was coming down Mill Lane a schoolboy walked out and went clean over to the other side, and he didn't slow or stop at any point.",
#:   "The dummy is propelled perpendicular to the lane from the nearside to the farside, maintaining its speed of 5 km/h throughout; no stop within the path of the VUT.",
#:   "I want somebody to step off the kerb and get to the opposite side in one uninterrupted movement, straight across, while our robotaxi is approaching.",
#:   "Die Frau, sorry, the lady, she goes from the right side to the left side of the street, always the same tempo, and does not stand still for us.",
#:   "Because he was wearing headphones, the student simply carried on to the other kerb at the pace at which he had started, cutting our path at a right angle.",
#:   "It was getting dark and the wipers were on. From between the market stalls a man in a grey coat set out for the opposite pavement; he walked neither fast nor slow, he didn't look up and he didn't pause until he was there.",
#:   "Pedestrian 1 entered the roadway mid-block from the west kerb. He continued due east on a line square to the street, his gait unchanged, and was clear of the far edge when V1 came to a halt. He told officers he never noticed the car.",
#:   "Funny thing, I've cycled across that road at the same place for twenty years. That day too I rolled off the cycle path, straight over in front of this self-driving thing, and up the dropped kerb opposite, no foot down, nothing. It coped all right.",
#:   "ok so small clip from the mornig commute, girl with a yellow umbrella comes off the kerb by the bakery walks straight over in front of me like its nothing, doesnt stop doesnt hurry and goes into the tube station oposite",
#:   "When the AV is thirty metres away, let a person begin to walk from one edge of the road to the other. The motion should be uniform and at right angles to the traffic, with no halt anywhere on the way, until the opposite edge has been reached.",
#:   "Boy on scooter-bike passes from gutter to gutter, nonstop, before us.",
#:   "Let a nun traverse our road at one even pace.",
#:   "From verge to verge, unhurried and unbroken, went the hiker.",
#:   "At an unaltered walking pace and square to the traffic, the insured's neighbour made her way from her gate to the mailbox across the road.",
#:   "Can you put in a man with a ladder who walks from this side to that side directly in front of the car, no halts?",
#:   "Chinese whispers aside, what I saw was plain: a woman left the tram stop, kept walking straight over the tarmac and disappeared in the arcade.",
#:   "Subject moves at right angles to the lane, 1.4 m/s all along, and is not to linger, run or turn within the conflict zone.",
#:   "A trail bike came over the road from one farm track to another, bang straight, and the rider didn't so much as lift his wrist.",
#:   "jogger w/ headphones goes right over our street like its a park, same tempo start to finish, gone",
#:   "The robotaxi had braked to nothing and we wondered why, because the street looked empty. A cat, said Tom. It was a very small old lady in black, who had come from the church side and was already passing our left headlamp, and with the same little steps she went on till she stood at the bakery.",
#:   "Officer, I wasn't speeding. What I recall is a pair of white trainers, first at the right edge of my lights, then in the middle, then at the left edge, tick, tick, tick, like a metronome. They never paused and they never ran. Then it was dark again.",
#:   "From the cab you look down on them, so I saw the crown of his hat the whole way. It started by the skip and it travelled in a straight line over my two lanes to the phone box. No stop, no change of pace, no glance up at forty tons of tomatoes.",
#:   "Pedestrian 1, a male age fifty-four, departed the east curb about ninety feet ahead of V1. His path was perpendicular to the roadway and video shows a uniform gait until he mounted the west curb. V1 skidded to avoid contact and was rear-ended by V2.",
#:   "I'd got the pupil up to thirty for the first time and he was so proud. So of course a student had to come off the pavement with her nose in a book. I said let her have it, she won't stop, and she didn't, she read her way clean over to the other side.",
#:   "In the demonstration the shuttle lost eleven seconds at one place only. There a cyclist who had been standing in a side path rode out, held one speed and one direction square over the lane, and rolled up the ramp opposite. We had expected him to wait, and he expected us to.",
#:   "My gran tells it every Christmas. She was nine, she'd got a jug of milk, and she had to carry it to the cottage over the way. So over she went, one foot, other foot, not fast because of the milk and not stopping because of the milk, and the first car in the village came along.",
#:   "The horn was no use. He had earphones in, that jogger, and he came out of the park gate on our left and was out of sight through the gate on our right, at precisely the speed at which, I suppose, he had run the previous five miles. We sat there with smoking tyres.",
#:   "Please create the most ordinary conflict there is. When we are some forty metres off, somebody with a dog leaves one pavement and walks, evenly, by the shortest way, to the other. He shouldn't freeze when he sees the car and he shouldn't speed up either.",
#:   "At the market place there is no zebra. Therefore people are going as they want, and this gentleman with the two bags has gone from left hand to right hand in front of my taxi, straight, with one speed. I have stood on the brake, and he has not even turned the head.",
#:   "What the inquest must picture is a lane with a hedge on either side and a gap in each. Through the first gap came the motorcyclist, and through the second he went out again, having been on the road no more than two seconds. He neither checked nor hastened, and his course lay at right angles to hers.",
#:   "Walked over, kerb to kerb, no pause: a man with a ladder.",
#:   "One steady line from the bakery to the bank, past our bumper.",
#:   "The boy on the bike just kept pedalling till he'd reached the far side.",
#:   "The dog stopped to sniff, the owner did not, and at a constant walk both of them, the dog dragged, got from our right to our left.",
#:   "Nothing about my horn or my lights made the nun alter her step; she had begun on one pavement and she finished, evenly, on the other.",
#:   "In this run the cyclist target shall leave the near edge, keep one speed and one perpendicular heading, and be clear at the far edge, no dwell.",
#:   "You'd expect some flinch from a person with a car bearing down, but she went over the road like a clock hand, tick, tick, and was gone.",
#:   "I want the traveller with the trolley case to roll it straight over the street, wheels rattling without a break from one kerb to the next.",
#:   "By the time V1's brakes had taken hold, the pedestrian, who neither paused nor hurried, was stepping up onto the opposite kerb.",
#:   "The ball of light from his bicycle lamp came out of the lane on the left. I watched it pass along our windscreen, frame to frame, at an unvarying rate, and go out among the trees on the right. It was only when Vera let go of the dashboard that I understood we'd all but stopped.",
#:   "I was at the sink. There's a gate opposite mine, and a path between them if you ignore the road, and he always does ignore it, old Bert. Out of his gate, over, into mine with the newspaper. You could set a watch by his step. The car in the road had to do all the thinking.",
#:   "Test note: distance between pedestrian and far kerb falls linearly from 7.2 m to zero, at 1.3 m per second, with no plateau. Lateral direction only. Our planner had put a forty per cent chance on him giving way in the middle, and it lost that bet, so the brake came late and hard.",
#:   "There was a sound of flip-flops. Slap, slap, slap from the beach side, slap, slap, slap in front of the bonnet, slap, slap, slap to the ice-cream kiosk, and not one slap missing or early. That is how I know that the lady didn't wait for anyone. I'm blind, I was in the passenger seat.",
#:   "My lord, the pram went first and so it was the pram I saw. It came off the kerb by the chemist's. I thought, she'll halt at the middle, they all do, or she will run. She did neither, but pushed on at the same walk, square over my lane, until its wheels bumped up by the post office.",
#:   "Could you put someone in who simply wants to be on the other side? No phone, no doubts, no show. As we draw near he leaves the pavement at a normal walking pace, takes the shortest way over, right through where we're headed, and keeps that pace until he's on the other pavement.",
#:   "Coming in to the village with a full load of sheep I saw the postie on his red bike at the end of the farm track. I took it he'd wait. He took it he'd go. Out of one track, over the road at right angles, into the other, legs turning like always, whistling, and my sheep all up one end.",
#:   "Nobody was hurt, says the newspaper, though an elderly jogger owes his life to a robotaxi's brakes. He'd left the park by the east gate and entered the cemetery by the west gate, as he does each morning. Between these lies the ring road, which took him, he reckons, four seconds, just like any other four seconds.",
#:   "Dispatcher's log, 22:41. Caller says male walked over the A6 \"as if he was in his own corridor,\" central reservation to verge, didn't look, didn't stop, didn't speed up. Caller's car and two others had to pull up hard. Male last seen continuing down the embankment.",
#:   "In a mirror of a hairdresser's I saw it first, so the wrong way round. A woman with a tray of cakes was going over the street, quick little even steps. In the mirror was also a car. Neither the steps nor the tray took notice of it; they arrived at the café's door, and the car was lying on its nose.",
#:   "Lo que pasó, I tell you how it was. On the border stands a boy with a motor scooter, pum, he goes. He goes not fast and not slow, he goes straight from the one border to the other as a line on the paper, and me with both feet on the pedal. In the middle he did not even blink.",
#: ]
#: adversaries = ["pedestrian", "bicycle", "motorcycle"]
#: requires = ["egoRoute"]
#: provides = ["AdvBehavior"]
#: origin = "base scenario straight-obstacle; own code"
#: [slots]
#: actions = ["cross"]
#: [[parameters]]
#: name = "OPT_ADV_SPEED"
#: low = 1.5
#: high = 5.0
#: unit = "m/s"
#: meaning = "how fast it goes"
#: [[parameters]]
#: name = "OPT_ADV_DISTANCE"
#: low = 18.0
#: high = 54.0
#: unit = "m"
#: meaning = "how far the ego still has to go when the adversary starts to move"

param OPT_ADV_SPEED = Range(1.5, 5)
param OPT_ADV_DISTANCE = Range(18, 54)

behavior AdvBehavior():
    # Earlier where it has farther to go, and briskly where the ego would be gone otherwise.
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_ADV_DISTANCE + 8 * max(0, abs(offsetFrom(egoRoute, self)) - 3) / globalParameters.OPT_ADV_SPEED
    do MoveAhead(5) until abs(offsetFrom(egoRoute, self)) < max(2.5, globalParameters.OPT_ADV_SPEED * headway(egoRoute, ego, self) / 8)
    do MoveAhead(globalParameters.OPT_ADV_SPEED)
