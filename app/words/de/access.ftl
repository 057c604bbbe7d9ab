access-title = Zugang und Sprache
access-language = Sprache
    .hint = Die der Seite; eigene Szenen bleiben in ihrer. Der Körper bleibt, und alles lässt sich weiter rückgängig machen.
access-letters = Buchstaben als Tasten
    .hint = Für alle, die Texte sprechen oder aus Versehen Tasten drücken. Tasten mit Strg, Pfeile und Esc gelten immer.
    .always = immer
    .body = solange der Körper den Fokus hat
    .never = nie
access-taps = Tippen statt Ziehen
    .hint = Tippe ein Ding an, dann die Stelle, an die es soll. Mit Esc oder noch einem Tipp auf das Ding bleibt es, wo es war. Ziehen geht weiterhin.
access-larger = Größer
    .hint = Alles größer und kräftiger.
access-contrast = Mehr Kontrast
    .hint = Buchstaben und Ränder heben sich stärker ab.
access-still = Weniger Bewegung
    .hint = Wind, Ansichten und Zeichen bewegen sich nicht von selbst. Der Körper bewegt sich, wenn man ihn abspielt.
access-sound = Ton
    .hint = Von Diagrammen, von Eigenschwingungen und von dem, was berührt und reißt.
access-events = Ereignisse ansagen
    .hint = Ein Bildschirmleser sagt in wenigen Worten, was geschieht: was reißt, berührt, zur Ruhe kommt, gegriffen oder losgelassen wird. Höchstens ein Satz in zwei Sekunden.
access-kept = Dieses Gerät merkt sich diese Einstellungen.

# While something is picked up by a tap, and after that; $thing is one of the names below, or that of an instrument, a
# bar or a mark.
taps-held = Aufgenommen: { $thing }. Tippe auf die neue Stelle. Esc oder ein Tipp darauf legt es zurück.
taps-put = Abgelegt: { $thing }
taps-back = Zurückgelegt: { $thing }
taps-nothing = Hier ist nichts zum Aufnehmen; einen angehaltenen Körper trifft man leichter.
taps-button = Zurücklegen
taps-selection = Auswahl
taps-frame = Ecke eines Rahmens
taps-cut = Ende eines Schnitts
taps-turn = Ruhewinkel eines Gelenks
taps-picture = Bild
# Of a plot: the end of the part of the time that is to be shown larger.
taps-part = Ende des Teils, der größer werden soll
