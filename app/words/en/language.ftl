# What those who speak this language call it, and the direction of its text: ltr, or rtl from right to left.
language-name = English
language-direction = ltr
# A name or what was typed, in quotation marks.
language-quoted = '{ $text }'
# A list, one item after the other; of sentences, or of what has commas itself.
language-comma = { $before }, { $after }
language-semicolon = { $before }; { $after }
