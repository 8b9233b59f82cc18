"""Questions asked of the pipeline, with the sentences and tables that belong to them."""
