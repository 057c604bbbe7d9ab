language-name = Türkçe
language-direction = ltr
language-quoted = “{ $text }”
