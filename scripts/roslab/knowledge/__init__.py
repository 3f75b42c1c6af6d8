"""Facts about the world, as data files with a source and a date each; this package only loads them."""
