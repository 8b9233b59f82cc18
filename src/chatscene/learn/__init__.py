"""Step 9 of 9, and what comes before it: egos that learn."""
