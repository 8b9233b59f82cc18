"""From a sentence about a dangerous traffic situation to scenes worth testing on."""
