"""What a text says, as typed facts with the words that each was read from (paper, section 3.2)."""
