"""What goes out of the page and comes back: files, links, pictures, and what the browser keeps."""
