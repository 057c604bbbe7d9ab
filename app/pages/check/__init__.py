"""The page that checks, before a class, whether a device can take part."""
