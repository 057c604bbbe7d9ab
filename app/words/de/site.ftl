site-title = Seile und weiche Körper
site-about = Jedes Bild öffnet einen Körper, der sich bewegt: Ziehe an ihm, biege ihn, ändere seine Zahlen. Er läuft im Browser, und nichts wird irgendwohin gesendet.
site-own = Eigene Szenen
site-find = Szene suchen
site-count = { $count ->
    [one] { $count } Szene
   *[other] { $count } Szenen
}
site-found = { $count ->
    [one] { $found } von { $count } Szene
   *[other] { $found } von { $count } Szenen
}
site-none = Keine Szene hat alle diese Wörter.
site-unknown = Eine Szene namens { $name } gibt es hier nicht.
site-groups = Gruppen
site-dark = Dunkle Seite
site-made = Gemacht mit softrod. Diese Seiten brauchen keinen Server und kein Netz.
site-kept = Alles ist jetzt auf diesem Gerät und öffnet sich hier auch ohne Netz.

site-bar = Galerie
site-all = Alle Szenen
    .hint = Alle Szenen (O)
site-before = Davor: { $scene }
site-after = Danach: { $scene }
site-save = Diese Seite als eine Datei speichern
