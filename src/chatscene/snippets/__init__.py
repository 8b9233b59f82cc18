"""Step 3 of 9: the library of snippets and how a sentence finds them."""
