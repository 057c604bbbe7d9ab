session-cannot = Das geht nicht
session-busy = die Szene ist beschäftigt; versuche es noch einmal
session-not-resumed = konnte nicht fortgesetzt werden: { $why }

session-exploded = Der Körper ist explodiert
    .setting = Der Zeitschritt { $step } s liegt über der Stabilitätsgrenze { $limit } s bei { $setting } { $value }. Gezeigt wird der letzte gute Zustand. Gehe bis kurz davor zurück, senke eins von beiden, und mache weiter; oder drücke „Zurücksetzen“.
    .part = Der Zeitschritt { $step } s liegt über der Stabilitätsgrenze { $limit } s bei dieser Steifigkeit: { $part }. Gezeigt wird der letzte gute Zustand. Gehe bis kurz davor zurück, senke sie oder wähle das Rechenverfahren Auto, und mache weiter; oder drücke „Zurücksetzen“.
    .otherwise = Angehalten vor Schritt { $step }: { $what }; { $why }. Gezeigt wird der letzte gute Zustand. Gehe bis kurz davor zurück, { $remedy }, und mache weiter; oder drücke „Zurücksetzen“.
session-what-number = Masse { $mass } bekäme einen Ort oder eine Geschwindigkeit, die keine endliche Zahl ist
session-what-position = Masse { $mass } ist zu weit gelangt (über { $limit } px)
session-what-step = kein Schritt von hier ist kurz genug
session-what-speed = Masse { $mass } wurde zu schnell (über { $limit } px/s)
session-why-law = das Kraftgesetz des Tutorials hat keine Energie und kann einen Körper immer schneller machen
session-why-violent = der Körper wurde zu heftig bewegt oder aufgestellt
session-why-violent-step = der Körper wurde für diesen Zeitschritt zu heftig bewegt oder aufgestellt
session-why-small = der Zeitschritt liegt unter der Stabilitätsgrenze, aber die gilt für kleine Bewegungen um eine Haltung; große oder schnelle können sie überschreiten
session-why-small-law = der Zeitschritt liegt unter der Stabilitätsgrenze, aber die gilt für kleine Bewegungen um eine Haltung; große oder schnelle können sie überschreiten, und das Kraftgesetz des Tutorials hat keine Energie und kann einen Körper immer schneller machen
session-remedy-law = bewege ihn sanfter, erhöhe die Dämpfung oder wähle ein anderes Kraftgesetz
session-remedy-gently = bewege ihn sanfter oder erhöhe die Dämpfung
session-remedy-step = verkürze den Zeitschritt, wähle das Rechenverfahren Auto, erhöhe die Dämpfung oder bewege ihn sanfter
session-cause-linear-stiffness = Dehnsteifigkeit
session-cause-linear-damping = Dehndämpfung
session-cause-angular-stiffness = Drehsteifigkeit
session-cause-angular-damping = Drehdämpfung
session-cause-air-friction = Luftreibung
session-cause-one-sided = einseitige Federn
session-cause-resistance = Widerstand
session-cause-walls = Wände
session-cause-fillings = Füllungen
session-cause-contact = Kontakt
session-cause-motors = Motoren
session-cause-pushes = Stöße
session-cause-rails = Schienen

session-shape = Diese Form lässt sich nicht halten
    .line = { $why } Die Linie zeigt, wohin sie sich bewegt.
    .button = { $why } Die Schaltfläche „Halten, { $times }-mal so steif“ sorgt dafür.
    .both = { $why } Die Linie zeigt, wohin sie sich bewegt. Die Schaltfläche „Halten, { $times }-mal so steif“ sorgt dafür.
    .text = { $why }

session-back-to = Zurück zu „{ $scene }“
    .undo = „Rückgängig“ führt wieder zu „{ $scene }“.
    .redo = „Wiederholen“ führt wieder zu „{ $scene }“.
session-opening = Öffnen von { $scene }
session-own-body = eigene Werte des Körpers
session-own-solver = eigene Werte des Lösers

session-replay-ended = Die Wiedergabe ist zu Ende
    .taken = Du hast die Wiedergabe übernommen.
    .stuck = Sie kann nicht weitergehen: { $why }.
    .agrees = Sie stimmt mit dem Protokoll überein: { $verdict }.
    .differs = Sie stimmt nicht mit dem Protokoll überein: sie { $verdict }.
session-replayed = { $checks ->
    [one] { $steps } Schritte wiederholt; die Prüfung stimmt
   *[other] { $steps } Schritte wiederholt; alle { $checks } Prüfungen stimmen
}
    .digest = { $checks ->
    [one] { $steps } Schritte wiederholt; die Prüfung stimmt, Prüfwert { $digest }
   *[other] { $steps } Schritte wiederholt; alle { $checks } Prüfungen stimmen, Prüfwert { $digest }
}
session-differs = weicht zuerst bei Schritt { $step } ab, t = { $time } s (Prüfung { $check } von { $checks }; bei Schritt { $agreed } stimmt sie), { $how }
    .elsewhere = weicht zuerst bei Schritt { $step } ab, t = { $time } s (Prüfung { $check } von { $checks }; bei Schritt { $agreed } stimmt sie), { $how }; aufgezeichnet wurde auf { $machine }, dies ist { $here }
session-differs-hidden = nicht in Orten und Geschwindigkeiten, sondern in dem, was Tasten, Schäden oder Reibung taten
session-differs-apart = größter Abstand einer notierten Masse { $distance }
session-differs-unknown = größter Abstand unbekannt
session-too-heavy = dieses Bild ist zu aufwendig, um in einer Seite abgespielt zu werden; `softrod run --inputs` kann es
session-log-plays = ein Protokoll wird abgespielt; sonst gibt es nichts zu speichern

session-awaited = bewegt sich mit NumPy, bis { $what } kompiliert ist: { $ready } von { $count } Teilen fertig
session-preparing = Vorbereitung ({ $what }): { $ready } von { $count } Teilen fertig

session-errors-kept = Fehler wachsen nicht: eine Toleranz von { $tolerance } wird eingehalten.
    .grow = Fehler wachsen auf das { $factor }-Fache in einer Sekunde: eine Toleranz von { $tolerance } wird eingehalten.
session-errors-step = Fehler wachsen nicht: ein kürzerer Zeitschritt verkleinert sie.
    .grow = Fehler wachsen auf das { $factor }-Fache in einer Sekunde: ein kürzerer Zeitschritt verkleinert sie.
session-errors-lost = Fehler wachsen auf das { $factor }-Fache in einer Sekunde: keine Toleranz kann versprechen, wo er in { $seconds } s ist.
    .step = Fehler wachsen auf das { $factor }-Fache in einer Sekunde: kein Zeitschritt kann versprechen, wo er in { $seconds } s ist.

session-plot-many = ein Diagramm hat Platz für { $count } Größen
session-plot-units = ein Diagramm hat Platz für zwei Einheiten, aber nicht für { $units }
session-mode-fast = Eigenschwingung { $mode } hat eine Periodendauer von { $period } s, weniger als vier Zeitschritte
