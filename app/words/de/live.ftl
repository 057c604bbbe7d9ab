live-picture = Das ist ein Bild: Skripte laufen hier nicht. Öffne die Datei in einem Browser, und es bewegt sich.
live-too-old = Dieser Browser kann die Datei nicht zeigen; ein neuerer kann es.
live-play = Abspielen
live-pause = Anhalten
live-speed = Tempo

replay-again = Noch einmal abspielen
replay-time = Gezeigte Zeit
replay-too-old = Dieser Browser kann die Datei nicht abspielen; ein neuerer kann es.

live-exploded = Der Körper ist explodiert
live-back = Zurück zu dem, was davor war
live-side = Regler und Zahlen
live-lesson = Lektion
live-others = Weitere Regler
live-answers = Antworten abgeben
live-step = +1 Schritt
live-time = Zeit
live-reset = Zurücksetzen
live-follow = Folgen
    .hint = Dem Zeiger folgen
live-view = Ansicht und Tasten

live-arrow-left = Links: Ruhewinkel kleiner
    .works = Links: { $work }
live-arrow-up = Hoch: länger
    .works = Hoch: { $work }
live-arrow-down = Runter: kürzer
    .works = Runter: { $work }
live-arrow-right = Rechts: Ruhewinkel größer
    .works = Rechts: { $work }
live-work-motors = die Motoren drehen
live-work-muscles = die Muskeln anspannen
live-work-forces = Massen schieben

live-notes = In dieser Datei gilt: { $notes }.
live-note-verlet = der Körper bewegt sich nach dem Velocity-Verlet-Verfahren, ohne Fehlerkontrolle
live-note-shape = die Form des Körpers liegt fest
live-note-sliders = keinen Regler gibt es für { $settings }
live-note-controls = in der Lektion fehlt die Einstellung von { $settings }
live-note-plots = Diagramme von { $quantities } fehlen
live-note-ghost = es gibt keinen zweiten Körper zum Vergleich
live-note-arrows = es gibt keine Pfeile
live-note-goals = manche Ziele werden nicht geprüft
live-note-runs = Läufe werden nicht abgegeben

live-stopped = gestoppt
live-paused = angehalten
live-slowed = verlangsamt: { $rate } × Echtzeit
live-broken = { $count ->
    [one] { $count } Feder gerissen
   *[other] { $count } Federn gerissen
}
live-yielded = { $count ->
    [one] { $count } Feder bleibend verformt
   *[other] { $count } Federn bleibend verformt
}
live-limit = Zeitschritt { $step } ms, { $part } % der Grenze
    .over = Zeitschritt { $step } ms, { $part } % der Grenze: instabil

live-joint = Gelenk { $joint }
    .angle = Winkel
    .rest = Ruhewinkel
    .sine = Sinus
    .cosine = Kosinus
live-energy = Energie, { $unit }
    .kinetic = Bewegung
    .height = Höhe
    .linear = Federn
    .angular = Drehfedern

live-cause =
    .linear = Der Zeitschritt von { $step } s liegt über der Stabilitätsgrenze von { $limit } s, die von den Federn kommt.
    .angular = Der Zeitschritt von { $step } s liegt über der Stabilitätsgrenze von { $limit } s, die von den Drehfedern kommt.
    .small = Der Zeitschritt liegt unter der Stabilitätsgrenze, aber die gilt für kleine Bewegungen; der Körper wurde zu heftig bewegt oder eingestellt.
    .violent = Der Körper wurde zu heftig bewegt oder eingestellt.

live-downwards = { $quantity }, nach unten
live-over = über { $quantity }
live-swing = { $reading }, Schwingungsdauer { $period } s, Amplitude { $amplitude }
live-swings = Schwingungsdauern { $periods } s; Amplituden { $amplitudes }
live-at = Bei { $time } s: { $readings }

live-own-words = In deinen eigenen Worten:
live-predict = Bewege die Massen dorthin, wo sie nach { $time } s sein werden. Drücke dann den Knopf.
    .done = Dort wird es sein
    .seen = Die dünne Linie ist deine Vorhersage für { $time } s.
live-goal = Ziel: { $goal }.
    .now = Ziel: { $goal }. Jetzt: { $reading }.
    .reached = Erreicht: { $goal }.

live-leaves = Von selbst verlässt nichts diese Datei. Gib deiner Lehrkraft die Datei, oder zeige den QR-Code.
live-name = Dein Name oder Spitzname, falls deine Lehrkraft einen möchte:
live-save = Antworten als Datei speichern
live-qr = QR-Code der Antworten
    .text = Der QR-Code ist der Text darunter, { $letters } Zeichen.
    .left = Der QR-Code ist der Text darunter, { $letters } Zeichen. Kein Platz ist darin für { $left }; in der Datei steht alles.
live-left-prediction = die Vorhersage zu Schritt { $step }
live-left-line = die Zeile zu Schritt { $step }
    .end = das Ende der Zeile zu Schritt { $step }

live-dark = Dunkel
live-larger = Größer, für den Beamer
live-keys-drag = eine Masse wird gehalten, solange du sie ziehst; mehrere Finger ziehen mehrere
    .keys = ziehen
live-keys-play = abspielen oder anhalten
    .keys = Leertaste
live-keys-step = ein Schritt
live-keys-reset = zurücksetzen: der Körper beginnt von vorn, mit den Reglern, wie sie sind
live-keys-follow = die Masse mit dem Ring folgt dem Zeiger, oder nicht mehr
live-keys-longer = Federn werden länger oder kürzer
    .keys = ↑ ↓ halten
live-keys-bent = Ruhewinkel werden größer oder kleiner
    .keys = → ← halten
live-keys-motors = Motoren drehen, vorwärts und rückwärts
    .keys = Pfeile halten
live-keys-dark = dunkel oder weiß; größer, für den Beamer
live-keys-body = zum Körper: dort wählen Pfeile eine Masse, die Leertaste greift sie, Pfeile bewegen sie
    .keys = Tab
live-keys-help = diese Hilfe

live-sheet-title = { $lesson }: für die Lehrkraft
live-sheet-needs = Etwa { $minutes } Minuten. Gebraucht werden ein Computer mit Beamer, und für jeden oder je zwei ein Handy, ein Tablet oder ein Computer. Los geht es mit { $command }; { $next } führt von Phase zu Phase.
live-sheet-next = Weiter
live-sheet-how = Fragen: Alle antworten verdeckt. Nicht verraten, was richtig ist. Bei weniger als 35 % richtigen Antworten noch einmal erklären; bei bis zu 70 % zu zweit darüber reden lassen und noch einmal fragen. Laufen lassen, auflösen, alle eine Zeile schreiben lassen, warum; dann probieren sie selbst und geben ab.
live-sheet-ask = Fragen
live-sheet-predict = Vorhersagen
    .text = Alle ziehen den blassen Körper dorthin, wo er nach { $time } s sein wird.
live-sheet-run = Laufen lassen
live-sheet-reveal = Auflösen
live-sheet-try = Probieren
live-sheet-watch = Beobachten
live-sheet-goal = Ziel
    .text = { $goal }.
live-sheet-collect = Sammeln
    .text = { $reading }.
