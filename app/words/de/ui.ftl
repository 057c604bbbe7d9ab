ui-templates = Winkelvorlage
ui-mixed = { $setting } (gemischt)
    .angles = der Regler dreht den ersten Winkel und die anderen um ebenso viel
    .numbers = der Regler setzt die größte Zahl, die anderen behalten ihr Verhältnis dazu
    .note = <b>gemischt</b>: { $what }.
ui-range = { $low } bis { $high }

key-ctrl = Strg
key-shift = Umschalt
key-space = Leertaste
key-esc = Esc
key-delete = Entf
key-backspace = Rücktaste
key-tab = Tab
key-or = { $one } oder { $other }
key-too = { $text } ({ $key })
key-of = Taste { $keys }
    .held = Taste { $keys }, gehalten

ui-panel = Bedienfeld
    .hide = Bedienfeld ausblenden
    .show = Bedienfeld einblenden
    .down = Bedienfeld ausblenden
    .up = Bedienfeld einblenden
ui-scene = { $title }: andere Szene wählen
ui-close = Schließen
ui-progress = Fortschritt
ui-on = an
    .off = aus
ui-plot-time = Zeit, s
ui-plot-said = { $label }: jetzt { $now }; am kleinsten { $low } bei { $lowAt } s, am größten { $high } bei { $highAt } s.
ui-plot-over = { $label }: jetzt { $now }; am kleinsten { $low }, wo { $across } { $lowAt } ist, am größten { $high }, wo es { $highAt } ist.
ui-plot-level = { $label }: die ganze Zeit { $now }.
ui-plot-none = { $label }: noch keine Werte.
ui-plot-keys = Pfeile nach links und rechts zeigen einen anderen Teil der Zeit, nach oben und unten einen kürzeren oder längeren, Pos1 alles
ui-plot-numbers = Zahlen
    .caption = { $count } der sichtbaren Zahlen, gleichmäßig verteilt; für neuere zu- und wieder aufklappen

ui-found = Gefunden
    .none = So heißt nichts. Was zu einer Masse, einer Feder oder einem Gelenk gehört, findest du, sobald eines ausgewählt ist.

ui-number-unclear = { $written } könnte { $one } oder { $other } sein. Schreibe eines davon.
ui-number-none = „{ $written }“ ist keine Zahl. Schreibe sie wie 20000, 2e4 oder 0,05.
ui-number-least = Mindestens { $least }.
ui-number-most = Höchstens { $most }.
ui-number-sign = Vorzeichen ändern

ui-away = Nicht verbunden: Dein Körper wartet. Verbindung wird wieder aufgebaut …
ui-blocked = Die Seite ist geladen, aber ihre Verbindung kommt nicht zustande: Etwas auf dem Weg sperrt WebSockets. Versuche ein anderes Netz, etwa den Hotspot des Rechners, auf dem softrod läuft.
ui-loading = Wird geladen …
    .later = Bei langsamem Netz dauert das erste Mal bis zu einer halben Minute.
ui-needs-javascript = Für softrod ist JavaScript nötig; hier ist es ausgeschaltet.
ui-needs-webgl = softrod zeichnet mit WebGL 2, das dieser Browser nicht hat oder das ausgeschaltet ist: Erlaube in seinen Einstellungen die Hardwarebeschleunigung, oder nimm einen anderen Browser.
ui-other-viser = Diese Seite kann nicht zeichnen: Ihre viser-Seite hat nicht die Version, die softrod unterstützt.
ui-not-loaded = Die Seite ist nicht ganz angekommen:
ui-no-canvas = Der Browser zeichnet diese Seite nicht mehr. Dein Körper ist gesichert:
    .reload = Neu laden

ui-pad = Pfeiltasten
    .up = Hoch
    .left = Links
    .down = Runter
    .right = Rechts

ui-body = { $count ->
    [one] Körper aus { $count } Masse
   *[other] Körper aus { $count } Massen
}
ui-mass = Masse { $mass }, { $place }
    .first = Masse { $mass }, { $place }. Pfeile wählen, die Leertaste greift
    .tools = Masse { $mass }, { $place }. Pfeile wählen, die Eingabetaste tut, was das Werkzeug tut, + setzt eine Masse an, X bewegt ein Kreuz
    .held = Masse { $mass } in der Hand. Pfeile bewegen sie
    .free = Masse { $mass } losgelassen
    .none = keine Masse
ui-place = x { $x }, y { $y } { $unit }
ui-opened = { $title } ist geöffnet
ui-exploded = Der Körper ist explodiert und angehalten
ui-running = Läuft
    .paused = Angehalten
ui-broken = { $count ->
    [0] Keine Feder gebrochen
    [one] { $count } Feder gebrochen
   *[other] { $count } Federn gebrochen
}

ui-too-much = Zu viel auf einmal
    .text = Die letzten Anfragen wurden nicht beachtet. Versuche es gleich noch einmal.
ui-stopped = Diese Seite ist angehalten
    .text = Auf dem Server gab es einen Fehler. Lade die Seite neu, um weiterzumachen.
ui-undo-afresh = Rückgängig beginnt von vorn
    .text = Was vor dem Verbindungsverlust geändert wurde, lässt sich nicht mehr rückgängig machen.
ui-commas = Dezimalkommas
    .hint = gespeicherte Tabellen haben 0,5 statt 0.5 und Strichpunkte zwischen den Spalten

ui-no-preset = es gibt keine Vorlage namens { $name }; wähle eine in der Galerie
ui-no-user = die Seite hat nicht gesagt, wessen sie ist; lade sie neu und versuche es noch einmal
ui-no-room = du hast hier { $count } Szenen, mehr gehen nicht; lösche zuerst einige
    .computer = auf diesem Rechner ist kein Platz für mehr Szenen von Gästen; lade sie als Datei herunter

ui-tab-play = Spielen
ui-tab-measure = Messen
ui-tab-solver = Löser
ui-tab-share = Teilen
ui-tab-lesson = Lektion

ui-unsent = Das kann nicht gesendet werden
    .text = Es ist zu groß für eine Seite: höchstens 4,7 MB, das sind etwa 11 000 Massen.
ui-unsent-resume = Das kann nicht fortgesetzt werden
ui-unsent-link = Das kann nicht geöffnet werden
ui-unsent-file = Das kann nicht geöffnet werden
ui-unsent-paste = Das kann nicht eingefügt werden
ui-unsent-rival = Dagegen kann kein Wettrennen stattfinden
ui-all-controls = Alle Bedienelemente werden gezeigt
ui-no-scene = Diese Adresse hat keine Szene
