"""The live file: a body that moves in one HTML file, without a server."""
