#: description = "The car behind sticks to the ego's rear bumper."
#: rephrasings = [
#:   "Some impatient sod is glued to our bumper.",
#:   "Vehicle 2 followed vehicle 1 at an unsafe distance.",
#:   "Rear veh tailgating, gap below 1 s.",
#:   "The target follows the VUT with a time headway far below the legal one.",
#:   "He drives too much near behind us, no distance at all.",
#:   "A lorry's grille fills our mirror and won't go away.",
#:   "The bus rides our tail so close that we can't see its lights.",
#:   "A motorcyclist slipstreams us within touching range.",
#:   "some white van glued himself to my backside and wouldn't drop back an inch",
#:   "Suspect vehicle was following too closely, maintaining less than one car length to the rear of the victim.",
#:   "HGV rides our bumper. Gap 2-3 m. Doesn't pass.",
#:   "The target vehicle follows the VUT at the same speed with an insufficient time gap (0.3 s).",
#:   "The bus is all time very near to my back, I see only his face in the mirror.",
#:   "Add a pushy follower: locks on to the SUT's tail with tiny headway and stays there, whatever the SUT does.",
#:   "She slowed, she sped up, and still the motorbike hung there on her tail light as though towed.",
#:   "You've got a fire engine right up your chuff, love; he's breathing down your neck and not giving you any room.",
#:   "this guy is literally in our boot rn, back OFF bro",
#:   "Police are warning of drivers who hound the vehicle in front, after a coach hugged a pensioner's rear for miles",
#:   "For the whole of that stretch, you could not have slid a newspaper between your front and the plaintiff's rear, could you?",
#:   "The bus behind damn near lah, can count his nose hair, never give space one",
#:   "I'm doing the limit and there's this muppet so far up my rear end he could read my meter",
#:   "Insufficient following distance of rear traffic, persistent",
#:   "Ambulance REFUSES to back off my bumper (rear view)",
#:   "The motorbike leeched onto our tail.",
#: ]
#: adversaries = ["car", "truck", "bus", "motorcycle", "emergency-vehicle"]
#: requires = ["advTrajectory"]
#: provides = ["AdvBehavior"]
#: origin = "NHTSA pre-crash typology: following too closely; own code"
#: [slots]
#: actions = ["tailgate"]
#: position = "behind"
#: [[parameters]]
#: name = "OPT_ADV_GAP"
#: low = -0.6
#: high = 2.5
#: unit = "m"
#: meaning = "how much room it means to leave; below 0 it will touch"

param OPT_ADV_GAP = Range(-0.6, 2.5)

behavior AdvBehavior():
    do PaceOnPath(advTrajectory, ego, -(ego.length + self.length) / 2 - globalParameters.OPT_ADV_GAP, 12)
