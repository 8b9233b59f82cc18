"""Files: written whole, read within bounds, kept between runs."""
