"""Work against error: softrod, other solvers (`softrod study`) and engines (`softrod bench peers`)."""
