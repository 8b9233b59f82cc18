"""Step 5 of 9: where scenes run."""
