"""Plain sentences for tests that are about something else than reading: short, of common words, one act or two."""

CROSSES = "A pedestrian crosses from the right in front of us."
STOPS = "A pedestrian crosses from the right and stops in front of us."
BRAKES = "the car ahead brakes hard"
PULLS_OUT = "A car pulls out from the right kerb in front of us."
CUTS_IN = "A car cuts in from the left"
RUNS_RED = "A car from the left runs the red light as we drive straight over the junction."

UNREAD = "a van ahead of us brakes hard because of a xylophone"
"""With a word that nothing is made of."""
NONE = "Please book a table for two at seven tonight."
"""No situation."""
