"""The gallery as a site: an index and a live file for each scene, which need no server."""
