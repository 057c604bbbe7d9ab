"""What a browser keeps of a page, and the links that it is opened by."""
