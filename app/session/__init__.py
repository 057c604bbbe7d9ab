"""One page's simulation without the page: commands go in, a state to draw comes out."""
