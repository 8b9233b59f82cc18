"""Stories: what a scenario of OpenSCENARIO XML has happen, played event by event over the bodies of a scene.

A program tells a story as nested tuples, since that is what a stranger's program may write:

    story      names, acts, stop
    name       (what it is called, how far its centre lies before its origin [m], and, if the file says them, the
               largest speed, acceleration and deceleration of its body); in the order of the scene's objects
    act        (name, start, stop, groups)
    group      (name, how often, actors, events)
    event      (maneuver, name, priority, how often, start, actions)
    action     (name, kind, …), see `actions`
    trigger    None for at once (a start) or never (a stop); else groups of conditions, of which one must hold
    condition  (edge, delay [s], kind, …), see `conditions`

Everybody is where the story says, as other players of the format have it: led along a line, at speeds that change as is
written, not as a body could. Only the ego is not, where an ego under test drives it.

Times are in s, lengths in m, angles in rad, speeds in m/s; all places are of origins, as the standard has them.
"""
