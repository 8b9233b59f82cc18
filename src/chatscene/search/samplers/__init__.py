"""Who says where to look next: one file each; `chatscene.search.sampler` has the Protocol and the table of names."""
