# Lengths, times and other numbers with units stand between the invisible marks U+2066 and U+2069, which keep them from left to right.
language-name = العربية
language-direction = rtl
language-quoted = «{ $text }»
# The invisible mark U+200F has a list run from right to left even where all of its items run the other way.
language-comma = { $before }‏، { $after }
language-semicolon = { $before }‏؛ { $after }
