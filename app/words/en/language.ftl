# What those who speak this language call it, and the direction of its text: ltr, or rtl from right to left.
language-name = English
language-direction = ltr
# A name or what was typed, in quotation marks.
language-quoted = '{ $text }'
