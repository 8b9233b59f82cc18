#: origin = "own code"
#: [slots]
#: maneuver = "right-turn"
#: [variants]
#: right-turn                                  = { place = "junction", crossed = ["left"], origin = "base scenario right-turn; own code" }
#: right-turn-four-way                         = { place = "four-way", crossed = ["left", "oncoming"] }
#: right-turn-signalised                       = { place = "four-way", crossed = ["left", "oncoming"], control = "signal", origin = "base scenario right-turn; own code" }
#: right-turn-stop-sign                        = { place = "four-way", crossed = ["left", "oncoming"], control = "stop-sign" }
#: right-turn-unsignalised                     = { place = "four-way", crossed = ["left", "oncoming"], control = "none", origin = "base scenario right-turn; own code" }
#: right-turn-junction-signalised              = { place = "junction", crossed = ["left"], control = "signal" }
#: right-turn-junction-stop-sign               = { place = "junction", crossed = ["left"], control = "stop-sign" }
#: right-turn-junction-unsignalised            = { place = "junction", crossed = ["left"], control = "none" }
#: right-turn-three-way                        = { place = "three-way", origin = "base scenario right-turn; own code" }
#: right-turn-three-way-from-stem              = { place = "three-way", crossed = ["left"] }
#: right-turn-three-way-from-stem-signalised   = { place = "three-way", crossed = ["left"], control = "signal" }
#: right-turn-three-way-from-stem-stop-sign    = { place = "three-way", crossed = ["left"], control = "stop-sign" }
#: right-turn-three-way-from-stem-unsignalised = { place = "three-way", crossed = ["left"], control = "none" }
#: right-turn-three-way-into-stem              = { place = "three-way", crossed = ["oncoming"] }
#: right-turn-three-way-into-stem-signalised   = { place = "three-way", crossed = ["oncoming"], control = "signal" }
#: right-turn-three-way-into-stem-stop-sign    = { place = "three-way", crossed = ["oncoming"], control = "stop-sign" }
#: right-turn-three-way-into-stem-unsignalised = { place = "three-way", crossed = ["oncoming"], control = "none" }
#: [descriptions]
#: right-turn                                  = "The ego turns right at an intersection."
#: right-turn-four-way                         = "The ego turns right at a four-way intersection."
#: right-turn-signalised                       = "The ego turns right at a four-way intersection with traffic lights."
#: right-turn-stop-sign                        = "The ego turns right at a four-way intersection with stop signs."
#: right-turn-unsignalised                     = "The ego turns right at a four-way intersection without traffic lights."
#: right-turn-junction-signalised              = "The ego turns right at an intersection of any kind with traffic lights."
#: right-turn-junction-stop-sign               = "The ego turns right at an intersection of any kind with stop signs."
#: right-turn-junction-unsignalised            = "The ego turns right at an intersection of any kind without traffic lights or signs."
#: right-turn-three-way                        = "The ego turns right at a three-way intersection."
#: right-turn-three-way-from-stem              = "The ego turns right at a three-way intersection, coming from the road that ends there."
#: right-turn-three-way-from-stem-signalised   = "The ego turns right at a three-way intersection with traffic lights, coming from the road that ends there."
#: right-turn-three-way-from-stem-stop-sign    = "The ego turns right at a three-way intersection with stop signs, coming from the road that ends there."
#: right-turn-three-way-from-stem-unsignalised = "The ego turns right at a three-way intersection without traffic lights or signs, coming from the road that ends there."
#: right-turn-three-way-into-stem              = "The ego turns right at a three-way intersection, leaving the through road for the side road."
#: right-turn-three-way-into-stem-signalised   = "The ego turns right at a three-way intersection with traffic lights, leaving the through road for the side road."
#: right-turn-three-way-into-stem-stop-sign    = "The ego turns right at a three-way intersection with stop signs, leaving the through road for the side road."
#: right-turn-three-way-into-stem-unsignalised = "The ego turns right at a three-way intersection without traffic lights or signs, leaving the through road for the side road."

param signals = 'ego-green'  #: if control signal
crossSignal = "red"  #: if control signal
egoRoute = selectRoute(maneuver="right-turn", place="$place")  #: unless crossed
egoRoute = selectRoute(maneuver="right-turn", place="$place", crossed=$crossed)  #: if crossed  #: unless control
egoRoute = selectRoute(maneuver="right-turn", place="$place", control="$control", crossed=$crossed)  #: if control
egoSpawnPt = startOf(egoRoute)
junctionExit = egoRoute.exitAt
trafficFromLeft = trafficFrom(egoRoute, "left")  #: if crossed left
trafficFromRight = trafficFrom(egoRoute, "right")  #: if crossed right
oncomingTraffic = trafficFrom(egoRoute, "oncoming")  #: if crossed oncoming
