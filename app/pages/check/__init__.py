"""The page on which a device tries, before a class, whether it can take part."""
