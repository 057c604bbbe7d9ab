edit-tools = Bearbeiten
edit-bar = Was ausgewählt ist
edit-waits-build = Tippe für eine Masse, ziehe für eine Feder
edit-waits-joint = Tippe eine Masse an, dann einen Winkel an ihr
edit-waits-select = Tippe ein Teil an, oder ziehe um mehrere
edit-waits-cut = Ziehe quer durch Federn
edit-paste = Einfügen
edit-done = Fertig
edit-rests = Verschobenes ruht
    .hint = Federn und Gelenke von Verschobenem nehmen ihre neuen Längen und Winkel als Ruhelängen und Ruhewinkel oder behalten die alten
edit-stiffen = Halten, { $times }-mal so steif
edit-undo = Rückgängig machen: { $what }
    .none = Nichts rückgängig zu machen
    .done = Rückgängig gemacht: { $what }
edit-redo = Wiederholen: { $what }
    .none = Nichts zu wiederholen
edit-masses = { $count ->
    [one] { $count } Masse
   *[other] { $count } Massen
}
edit-springs = { $count ->
    [one] { $count } Feder
   *[other] { $count } Federn
}
edit-joints = { $count ->
    [one] { $count } Gelenk
   *[other] { $count } Gelenke
}
edit-parts = { $count ->
    [one] { $count } Teil
   *[other] { $count } Teile
}
edit-mass = Masse { $number }
edit-spring = Feder { $number }
edit-joint = Gelenk { $number }
edit-selected = { $parts } ausgewählt
    .none = Nichts ausgewählt
edit-open = Werkzeuge offen: { $tool }
    .closed = Werkzeuge geschlossen
edit-begins = Eine Feder beginnt bei Masse { $mass }: Eingabe bei einer anderen verbindet sie und geht dort weiter, Esc beendet das
    .ended = Die Feder ist aufgegeben
edit-cross = Kreuz bei { $place }. Pfeile bewegen es, mit Umschalt um ein Zehntel; Eingabe drückt dort, Esc nimmt es weg
    .gone = Das Kreuz ist weg
edit-cross-on = { $place }: { $part }
edit-rests-at = Ruhewinkel { $angle }
edit-moved = Verschobene Massen
    .text = Federn und Gelenke von dem, was du verschoben hast, können so ruhen, wie sie jetzt sind, oder ihre Ruhelängen und Ruhewinkel behalten: Dann ziehen sie zurück, sobald die Uhr läuft.
    .take = Neue Längen nehmen
    .keep = Ruhelängen behalten
    .once = Das wird einmal gefragt. Ändern kannst du es mit „Verschobenes ruht“.
edit-texts = Name und Beschreibung dieser Szene
    .name = Name
    .description = Was sie zeigt
    .done = Fertig
    .cancel = Abbrechen
edit-picture = Bild
    .hint = Ein Bild hinter dem Körper, zum Nachzeichnen; es bleibt in diesem Browser
    .size = Größe
    .opacity = Deckkraft
    .move = Verschieben
    .drag = Ziehe es, oder nimm die Pfeiltasten, bis du Esc drückst
    .another = Anderes Bild
    .remove = Wegnehmen
edit-no-picture = { $name } ist kein Bild, das dieser Browser zeigen kann

edit-not-pasted = Das kann nicht eingefügt werden
edit-not-copied = Das kann nicht kopiert werden
edit-sags = Hängt der Körper durch?
    .text = Setze ihn zurück und drücke dann „Diese Form halten“ neben den Werkzeugen: Er bleibt so, wie du ihn gezeichnet hast.

number-mixed = gemischt
number-middle = Mitte
number-note = { $number } ({ $note })
number-proportions = Verhältnisse behalten
    .hint = eine Zahl setzt dann den größten Wert, und die anderen ändern sich im gleichen Verhältnis
number-holding = Massen
    .pin = Festhalten
    .release = Loslassen
number-rest = Ruhe wie jetzt
    .hint = Ruhelängen und Ruhewinkel werden die jetzigen
number-delete = Löschen
number-position-x = Start x
number-position-y = Start y
number-mass = Masse
number-radius = Radius
number-force-x = Kraft x
number-force-y = Kraft y
number-spring-stiffness = Steifigkeit
number-spring-damping = Dämpfung
number-spring-rest-length = Ruhelänge
number-spring-strength = Festigkeit
number-spring-yield-force = Fließkraft
number-spring-hardening = Verfestigung
number-joint-stiffness = Steifigkeit des Gelenks
number-joint-damping = Dämpfung des Gelenks
number-joint-rest-angle = Ruhewinkel
number-joint-yield-torque = Fließdrehmoment
number-spring-muscle-amplitude = Amplitude des Muskels
number-spring-muscle-phase = Phase des Muskels
number-spring-muscle-per-beat = Wellen des Muskels je Takt
number-joint-muscle-amplitude = Amplitude des Gelenkmuskels
number-joint-muscle-phase = Phase des Gelenkmuskels
number-joint-muscle-per-beat = Wellen des Gelenkmuskels je Takt
number-joint-motor-speed = Drehzahl des Motors
number-joint-motor-torque = Drehmoment des Motors

way-touch = Massen berühren
    .hint = Bälle stoßen zusammen: Sie prallen voneinander ab und, wo es Kontakt gibt, auch von Federn
    .usual = keine andere Masse
    .solid = andere Bälle
way-move = Massen bewegen sich
    .hint = eine Masse auf einer Schiene bewegt sich nur an ihr entlang, wie ein Wagen
    .usual = frei
    .level = hin und her auf einer Schiene
    .upright = auf und ab auf einer Schiene
way-springs = Federn wirken
    .hint = ein Seil zieht nur, und ein Anschlag wirkt nur auf einer Seite seines Ruhewinkels
    .usual = in beide Richtungen
    .pull = nur ziehend
    .push = nur drückend
way-joints = Gelenke wirken
    .hint = { way-springs.hint }
    .usual = auf beiden Seiten
    .above = nur über ihrem Winkel
    .below = nur unter ihrem Winkel
way-turn = Gelenke drehen sich
    .hint = ein Motor dreht die zweite Feder eines Gelenks gegen die erste
    .usual = frei
    .motor = durch einen Motor
    .left-right = durch einen Motor, mit den Tasten Links und Rechts
    .up-down = durch einen Motor, mit den Tasten Auf und Ab
way-forces = Kräfte wirken
    .hint = eine Kraft auf eine Masse wirkt immer oder solange eine Pfeiltaste gehalten wird
    .usual = immer
    .left-right = mit den Tasten Links und Rechts
    .up-down = mit den Tasten Auf und Ab
way-muscles = Muskeln arbeiten
    .hint = ein Muskel arbeitet immer oder solange eine Pfeiltaste gehalten wird; ein stetiger bleibt dann, wie er ist
    .usual = im Takt
    .left-right = im Takt, mit den Tasten Links und Rechts
    .up-down = im Takt, mit den Tasten Auf und Ab
    .steady-left-right = stetig, mit den Tasten Links und Rechts
    .steady-up-down = stetig, mit den Tasten Auf und Ab
way-joint-muscles = Gelenkmuskeln arbeiten
    .hint = { way-muscles.hint }
    .usual = { way-muscles.usual }
    .left-right = { way-muscles.left-right }
    .up-down = { way-muscles.up-down }
    .steady-left-right = { way-muscles.steady-left-right }
    .steady-up-down = { way-muscles.steady-up-down }

done-masses-removed = { $count ->
    [one] { $count } Masse entfernt
   *[other] { $count } Massen entfernt
}
done-springs-removed = { $count ->
    [one] { $count } Feder entfernt
   *[other] { $count } Federn entfernt
}
done-joints-removed = { $count ->
    [one] { $count } Gelenk entfernt
   *[other] { $count } Gelenke entfernt
}
done-muscles-removed = { $count ->
    [one] { $count } Muskel entfernt
   *[other] { $count } Muskeln entfernt
}
done-springs-cut = { $count ->
    [one] { $count } Feder durchgeschnitten
   *[other] { $count } Federn durchgeschnitten
}
done-springs-added = { $count ->
    [one] { $count } Feder hinzugefügt
   *[other] { $count } Federn hinzugefügt
}
done-joints-added = { $count ->
    [one] { $count } Gelenk hinzugefügt
   *[other] { $count } Gelenke hinzugefügt
}
done-muscles-added = { $count ->
    [one] { $count } Muskel hinzugefügt
   *[other] { $count } Muskeln hinzugefügt
}
done-masses-pinned = { $count ->
    [one] { $count } Masse festgehalten
   *[other] { $count } Massen festgehalten
}
done-masses-let-go = { $count ->
    [one] { $count } Masse losgelassen
   *[other] { $count } Massen losgelassen
}
done-masses-moved = { $count ->
    [one] { $count } Masse verschoben
   *[other] { $count } Massen verschoben
}
done-masses-mirrored = { $count ->
    [one] { $count } Masse gespiegelt
   *[other] { $count } Massen gespiegelt
}
done-masses-duplicated = { $count ->
    [one] { $count } Masse dupliziert
   *[other] { $count } Massen dupliziert
}
done-masses-pasted = { $count ->
    [one] { $count } Masse eingefügt
   *[other] { $count } Massen eingefügt
}
done-muscles-moved = { $count ->
    [one] { $count } Muskel verändert
   *[other] { $count } Muskeln verändert
}
done-muscles-changed = { $count ->
    [one] { $count } Muskel geändert
   *[other] { $count } Muskeln geändert
}
done-muscles-spread = { $count ->
    [one] { $count } Muskel verteilt
   *[other] { $count } Muskeln verteilt
}
done-springs-critically-damped = { $count ->
    [one] { $count } Feder aperiodisch gedämpft
   *[other] { $count } Federn aperiodisch gedämpft
}
done-triangulated-springs-added = { $count ->
    [one] in Dreiecke geteilt: { $count } Feder hinzugefügt
   *[other] in Dreiecke geteilt: { $count } Federn hinzugefügt
}
done-mass-added = Masse hinzugefügt
done-mass-and-spring-added = Masse und Feder hinzugefügt
done-masses-and-a-spring-added = { $count } Massen und eine Feder hinzugefügt
done-nothing-removed = nichts entfernt
done-nothing-mirrored = nichts gespiegelt
done-rest-as-it-is = Ruhe wie jetzt
done-keep-this-shape = diese Form halten
done-fitted = angepasst
done-scene-renamed = Szene umbenannt
done-scene-described = Szene beschrieben
done-mode = Schwingung { $count }
done-own-values-of-the-body = eigene Werte des Körpers
done-own-values-of-the-solver = eigene Werte des Lösers
done-number-set = { $number } gesetzt: { $parts }
done-number-scaled = { $number } skaliert: { $parts }
done-way = { $way }: { $choice }
done-lesson-deleted = Lektion gelöscht
done-step-added = Schritt { $count } hinzugefügt
done-step-duplicated = Schritt { $count } dupliziert
done-step-removed = Schritt { $count } entfernt
done-step-moved = „{ $title }“ wird Schritt { $count }
done-beginning-of-step = Beginn von Schritt { $count }
done-title-of-step = Titel von Schritt { $count }
done-task-of-step = Aufgabe von Schritt { $count }
done-what-to-watch-of-step = Beobachtung von Schritt { $count }
done-question-of-step = Frage von Schritt { $count }
done-prediction-of-step = Vorhersage von Schritt { $count }
done-goal-of-step = Ziel von Schritt { $count }
done-what-is-handed-in-of-step = Abzugebendes von Schritt { $count }
done-sliders-of-step = Regler von Schritt { $count }
done-plots-of-step = Diagramme von Schritt { $count }
done-arrows-of-step = Pfeile von Schritt { $count }
done-second-body-of-step = zweiter Körper von Schritt { $count }
done-run-of-step = Lauf von Schritt { $count }

edit-no-corner = es gibt keine Ecke ohne Drehfeder
edit-no-brace = es ist nichts mehr zu versteifen
edit-no-selection = es ist nichts ausgewählt
edit-no-move = es ist nichts ausgewählt, was sich verschieben lässt
