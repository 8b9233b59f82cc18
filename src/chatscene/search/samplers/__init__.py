"""Who says where to look next: one file each, which says its own name; `chatscene.search.sampler` has the Protocol."""
