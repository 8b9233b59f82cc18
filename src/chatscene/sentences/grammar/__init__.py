"""The grammar of step 1: tables of phrases, and what joins them into clauses."""
