"""Step 4 of 9: programs that mean what was said."""
