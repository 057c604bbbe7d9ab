"""What stands between viser and the network."""
