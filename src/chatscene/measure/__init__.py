"""Step 8 of 9: how an ego fared."""
