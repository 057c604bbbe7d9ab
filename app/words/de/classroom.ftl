class-title = softrod: eine Klasse
class-needs-javascript = Für eine Klasse ist JavaScript nötig; hier ist es ausgeschaltet.
class-blocked = Die Seite ist geladen, aber ihre Verbindung kommt nicht zustande: Etwas auf dem Weg sperrt WebSockets. Versuche ein anderes Netz, etwa den Hotspot des Rechners der Lehrkraft.
class-over = Die Stunde ist zu Ende.
class-why = Warum? Antworte in einem Satz.
class-hand-in = Gib ab, was du gefunden hast.
class-goal = Ziel: { $goal }
class-goal-met = Erreicht: { $goal }
class-found = Was die Klasse gefunden hat
class-qr-code = QR-Code von { $address }
class-plot = { $what } über { $over }: { $count ->
    [one] 1 Punkt
   *[other] { $count } Punkte
  }
  .law = { $what } über { $over }: { $count ->
    [one] 1 Punkt
   *[other] { $count } Punkte
  }; { $law }
class-plot-you = du: { $value }
class-grip = Masse { $mass } deiner Vorhersage: mit den Pfeiltasten bewegen
class-grips = Deine Vorhersage
class-moved-mass = Masse { $mass }: { $moved }
class-moved =
  .lower = { $length } tiefer
  .higher = { $length } höher
  .left = { $length } nach links
  .right = { $length } nach rechts
class-where-put = eure Vorhersagen

## Die Seite einer Schülerin oder eines Schülers.

seat-region = Klasse
seat-nothing-kept = Nichts, was du abgegeben hast, bleibt hier gespeichert.
seat-away-alone = Nicht verbunden: Dein Körper bewegt sich hier weiter, aber das zählt nicht. Verbindung wird wieder aufgebaut …
seat-hand-up = Melden
seat-hand-is-up = Gemeldet
seat-on-page = Eine andere Seite dieses Browsers hat jetzt deinen Platz.
seat-on-device = Ein anderes Gerät hat jetzt deinen Platz.
seat-come-back = Hierher zurückholen
seat-who = Wer bist du? Gib deinen Namen ein, damit deine Lehrkraft weiß, wessen Antworten das sind.
seat-your-name = Dein Name
seat-name-me = Das bin ich
seat-on-wall = Deiner ist jetzt auf der Leinwand.
seat-follow = Zum Körper der Lehrkraft
seat-own-body = Zurück zu meinem Körper
seat-about = Dieser Platz
seat-why = Die Frage und die Begründung
seat-waiting = Noch nicht bei der Lehrkraft: Es bleibt hier und wird gesendet, sobald das geht.
seat-letters = Die vier Buchstaben auf der Leinwand
seat-come-in = Eintreten

seat-is-in = Du bist dabei. Gleich geht es los.
seat-look = Schau nach vorn.
seat-teacher-away = Die Seite deiner Lehrkraft ist gerade weg: Warte einen Moment.
seat-gathered = Schau nach vorn: Das ist der Körper deiner Lehrkraft. Deiner wartet.
seat-follows = Das ist der Körper deiner Lehrkraft. Deiner wartet.
seat-paused = Angehalten: Schau nach vorn.
seat-can-change = Du kannst es noch ändern. Noch sieht es sonst niemand.
seat-ask-drag = Beweg den blassen Körper dorthin, wo er { $seconds } s nach dem Start sein wird. Noch sieht es sonst niemand.
seat-ask-both = Beweg den blassen Körper dorthin, wo er { $seconds } s nach dem Start sein wird, und wähle eine Antwort. Noch sieht es sonst niemand.
seat-ask-choose = Wähle eine Antwort. Noch sieht es sonst niemand.
seat-ask-again = Wähle noch einmal. Noch sieht es sonst niemand.
seat-try = Probier es aus: Dieser Körper gehört dir.

seat-home-drag = Beweg den blassen Körper dorthin, wo er { $seconds } s nach dem Start sein wird. Dann läuft es.
seat-home-both = Beweg den blassen Körper dorthin, wo er { $seconds } s nach dem Start sein wird, und wähle eine Antwort. Dann läuft es.
seat-home-choose = Wähle eine Antwort. Dann läuft es.
seat-late-now = Was du jetzt abgibst, gilt als verspätet.
seat-home-own = Jetzt bist du dran: Dieser Körper gehört dir.
seat-step = Schritt { $number }
seat-step-done = Schritt { $number }, erledigt
seat-next-step = Weiter: Schritt { $number } von { $steps }
seat-to-do = { $count ->
    [one] Noch zu tun: Schritt { $steps }.
   *[other] Noch zu tun: Schritte { $steps }.
  }
seat-all-done = Alle Schritte sind erledigt. Du kannst diese Seite schließen.
seat-told-on = Die richtige Antwort siehst du am { $date }.

seat-watch = Beobachte:
seat-chose-before = Zuvor hast du gewählt: { $choice }
seat-chose = { $late ->
    [yes] Du hast gewählt: { $choice } (verspätet: nachdem die Antworten gezeigt waren).
   *[no] Du hast gewählt: { $choice }.
  }
seat-right = Die richtige Antwort: { $choice }.

seat-predict = Dort wird er sein
  .place = Abgeben: { $place }
seat-predicted = Deine Vorhersage ist abgegeben
  .place = Deine Vorhersage ist abgegeben: { $place }
seat-handed-moved = Die Antworten werden gezeigt: Deine Vorhersage ist so abgegeben, wie du sie gezogen hattest.
seat-step-left = Ein wenig nach links
seat-step-right = Ein wenig nach rechts
seat-step-up = Ein wenig nach oben
seat-step-down = Ein wenig nach unten

seat-because = Weil
seat-send = Senden
seat-change = Ändern
seat-sent = Gesendet ✓
seat-pause = Pause
seat-play = Start
seat-reset = Zurücksetzen
seat-slow = Mit einem Viertel der Geschwindigkeit
seat-reading = { $what }: { $reading }
seat-no-reading = Noch nichts abzulesen: Lass ihn sich eine Weile bewegen.
seat-hand-in = { $reading } abgeben
  .instead = Stattdessen { $reading } abgeben
seat-hand-in-it = Abgeben
  .instead = Stattdessen dies abgeben
seat-hand-in-run = Diesen Lauf abgeben
  .instead = Stattdessen diesen Lauf abgeben
seat-handed = { $late ->
    [yes] Abgegeben (verspätet: nachdem die Antworten gezeigt waren).
   *[no] Abgegeben.
  }
  .text = { $late ->
    [yes] Abgegeben: { $text } (verspätet: nachdem die Antworten gezeigt waren).
   *[no] Abgegeben: { $text }.
  }

seat-first = Nummer eins von euch
seat-second = Nummer zwei von euch
seat-another-name = Anderer Name
seat-two = Wir sind zu zweit
seat-move = An einem anderen Gerät weitermachen
seat-move-digits = Am anderen Gerät { $digits } eingeben
seat-had = Ich hatte meinen Platz an einem anderen Gerät. Seine zwei Ziffern:
seat-take-over = Übernehmen

## Was die Lehrkraft in jeder Phase der Klasse sagt und (.do) tut.

guide-lobby = Öffnet die Adresse, die auf der Leinwand steht, und gebt die vier Buchstaben ein.
  .do = Zeigen Sie die Leinwand-Seite mit dem Beamer. Weiter geht es, wenn alle da sind.
guide-show = Seht euch den Körper an: Was hält ihn, und was zieht an ihm?
  .before = Zeigen Sie auf die Teile. Drücken Sie noch nicht auf „Start“: Erst kommt die Frage, dann der Lauf.
  .do = Zeigen Sie auf die Teile. Lassen Sie ihn mit „Start“ los: Wonach gefragt wird, kommt erst später.
guide-drag = Zieht den blassen Körper dorthin, wo er { $seconds } s nach dem Start sein wird.
guide-ask = Warten Sie, bis alle geantwortet haben. Sagen Sie nicht, was richtig ist.
guide-again = Überzeugt eine Minute lang eure Nachbarn. Dann antwortet noch einmal.
  .do = Hören Sie zu. Sagen Sie nicht, was richtig ist.
guide-results = Wer möchte seine Wahl begründen?
  .do = Hören Sie zwei an, die verschieden geantwortet haben. Nennen Sie die richtige Antwort noch nicht.
guide-changed = Wer hat die Meinung geändert, und warum?
  .do = Nennen Sie die richtige Antwort noch nicht: Der Lauf wird sie zeigen.
guide-run = Beobachtet, was geschieht.
  .do = Lassen Sie es laufen, bis alle gesehen haben, was geschieht.
guide-run-new = Beobachtet, was geschieht. Das ist neu: { $runs }
guide-run-stops = Der Lauf hält bei { $seconds } s an. Vergleichen Sie ihn mit den Vorhersagen.
guide-reveal = Das ist die Antwort. Erklärt euren Nachbarn, warum.
  .predicted = Die Leinwand zeigt die Vorhersagen neben dem Körper, dann die richtige Antwort. Lassen Sie ihr einen Moment, bevor Sie sprechen.
  .do = Die Leinwand zeigt die richtige Antwort. Lassen Sie ihr einen Moment, bevor Sie sprechen.
guide-explain = Versehen Sie zwei Antworten mit einem Stern: Sie kommen in der nächsten Phase auf die Leinwand. Erklären Sie es dann mit eigenen Worten: { $because }
guide-try = Gehen Sie herum. Wer sich meldet, ist rechts zu sehen.
guide-collect = Gebt ab: { $collects }.
guide-plot = Wenn die meisten abgegeben haben, sehen Sie sich gemeinsam das Diagramm der Klasse an: Was sagt es? Drücken Sie auf „Gesetz zeigen“, falls es das gibt.
guide-collected = Wenn die meisten abgegeben haben, zeigen Sie eines davon auf der Leinwand.

## Was der Server einer Seite der Klasse sagt.

class-refuse-together = Die Klasse geht gemeinsam weiter.
class-refuse-no-home-step = Diesen Schritt gibt es in der Hausaufgabe nicht.
class-refuse-no-place = Diese Stelle gibt es in der Stunde nicht.
class-refuse-sealed = Niemand sieht die Antworten, bevor alle gezeigt werden.
class-refuse-no-bodies = Die Plätze haben gerade keine eigenen Körper.
class-refuse-gathered = Alle sehen gerade den Körper der Lehrkraft.
class-refuse-begun = Die Stunde hat begonnen: Ihre Lektion lässt sich nicht mehr wählen.
class-refuse-steps = Eine Stunde hat höchstens { $most } Schritte; diese Szene hat { $steps }.
class-refuse-closed = Die Stunde hat begonnen; bitte deine Lehrkraft, die Tür zu öffnen.
class-refuse-network = Aus deinem Netz sind schon { $seats } Plätze belegt, mehr gibt es für ein Netz nicht; deine Lehrkraft kann welche entfernen.
class-refuse-removed = Die Lehrkraft hat diesen Platz geschlossen.
class-refuse-full = Die Klasse ist voll: Sie hat { $seats } Plätze.
class-refuse-names = In dieser Klasse werden die Namen vergeben.
class-refuse-no-name = Ein Name braucht mindestens einen Buchstaben.
class-refuse-same-name = Diesen Namen hat schon jemand.
class-refuse-digits = Zu diesen Ziffern gehört gerade kein Platz.
class-refuse-own-answers = Dieses Gerät hat schon einen Platz mit eigenen Antworten.
class-refuse-not-yours = Diese Antwort ist von jemand anderem.
class-refuse-one = Hier sitzt nur eine Person.
class-refuse-no-step = Diesen Schritt gibt es in der Stunde nicht.
class-refuse-not-asked = Danach ist die Klasse nicht gefragt worden.
class-refuse-has-run = Du hast es laufen sehen: Deine erste Antwort zählt.
class-refuse-shown = Die Antworten sind gezeigt worden; deine bleibt, wie sie war.
class-refuse-answers = Ein Platz kann { $most } Antworten abgeben.
class-refuse-no-seat = Diesen Platz gibt es nicht.
class-refuse-no-answer = Diese Antwort gibt es nicht.
class-refuse-no-choice = Diese Antwortmöglichkeit gibt es bei der Frage nicht.
class-refuse-no-such-place = Das ist keine Lage für diesen Körper.
class-refuse-no-letter = Ein Satz braucht mindestens einen Buchstaben.
class-at-goal = Ziel erreicht
class-not-at-goal = Ziel nicht erreicht
class-refuse-tries = Das waren zu viele Versuche; lade die Seite neu, um weiterzumachen.
class-refuse-begin = Dieser Schritt kann nicht beginnen: { $reason }.
class-refuse-other-page = Eine andere Seite hat jetzt diesen Platz.
class-refuse-cannot-begin = Dieser Schritt kann nicht beginnen.
class-refuse-no-run = Gerade gibt es keinen Lauf, den du abgeben kannst.
class-refuse-replay = Gerade läuft eine Aufzeichnung; es gibt nichts abzugeben.
class-refuse-code = Eine Klasse { $code } gibt es hier gerade nicht.
seat-try-again = Probiere andere Werte und setze zurück.
class-told-at = { $day }. { $month ->
    [1] Januar
    [2] Februar
    [3] März
    [4] April
    [5] Mai
    [6] Juni
    [7] Juli
    [8] August
    [9] September
    [10] Oktober
    [11] November
   *[12] Dezember
  } um { $time } Uhr

## Die Leinwand: was alle mit dem Beamer sehen.

class-answered = { $done ->
    [one] { $done } von { $all } hat geantwortet
   *[other] { $done } von { $all } haben geantwortet
  }
class-wrote = { $done ->
    [one] { $done } von { $all } hat einen Satz geschrieben
   *[other] { $done } von { $all } haben einen Satz geschrieben
  }
class-handed-in = { $done ->
    [one] { $done } von { $all } hat abgegeben
   *[other] { $done } von { $all } haben abgegeben
  }
wall-nobody = Noch niemand da? Netze halten Geräte manchmal voneinander fern: Versuchen Sie den Hotspot dieses Rechners.
wall-way-in = { $address } öffnen und { $code } eingeben
wall-scan = Scannen, oder { $address } öffnen und diese Buchstaben eingeben:
wall-here = { $count ->
    [one] { $count } ist da
   *[other] { $count } sind da
  }
wall-step = Schritt { $number } von { $steps }
wall-now = Jetzt: { $runs }
wall-where = Wo ist der Körper { $seconds } s nach dem Start?
wall-next = Jetzt: Erklärt euren Nachbarn, warum.
wall-trying = { $count ->
    [one] probiert
   *[other] probieren
  }
wall-exploded = { $count ->
    [one] ist explodiert
   *[other] sind explodiert
  }
wall-untouched = { $count ->
    [one] hat noch nichts verändert
   *[other] haben noch nichts verändert
  }
wall-at-goal = { $count ->
    [one] ist am Ziel
   *[other] sind am Ziel
  }

## Die Seite der Lehrkraft.

desk-lead = Was Sie sagen und tun
desk-room = Die Klasse
desk-over = Die Stunde ist zu Ende
desk-nothing-kept = Nichts, was abgegeben wurde, bleibt auf diesem Rechner gespeichert.

desk-here = { $count } da
desk-wall = Leinwand
desk-controls = Regler
  .label = Regler meines eigenen Körpers
desk-not-kept = nicht gespeichert
desk-saving = speichert …
desk-pupils-type = Die Klasse gibt { $address } und { $code } ein.
desk-more = Mehr
desk-come-in = Wie die Klasse hereinkommt

desk-lobby = Hereinkommen
desk-show = Alle zu mir schauen
desk-ask = Fragen
  .again = Noch einmal fragen
desk-results = Antworten zeigen
  .again = Antworten noch einmal zeigen
desk-run = Laufen lassen
desk-reveal = Auflösen
desk-explain = In einem Satz erklären
desk-try = Ausprobieren lassen
desk-collect = Einsammeln
desk-step = Schritt { $number }
desk-steps = Schritt
desk-phase = Phase { $number } von { $phases }
desk-minutes = bisher { $minutes } min
desk-say = Sagen
desk-do = Tun
desk-next = Weiter: { $place }
desk-last = Das war der letzte Schritt.
desk-back = Zurück
  .label = Zurück zu: { $place }
desk-all-phases = Alle Phasen

desk-teach = { $part } % richtig: noch einmal erklären.
  .some = { $part } % richtig von den { $votes }, die geantwortet haben: noch einmal erklären.
desk-pairs = { $part } % richtig: zu zweit reden lassen, dann noch einmal fragen.
  .some = { $part } % richtig von den { $votes }, die geantwortet haben: zu zweit reden lassen, dann noch einmal fragen.
desk-on = { $part } % richtig: weitergehen.
  .some = { $part } % richtig von den { $votes }, die geantwortet haben: weitergehen.
desk-replay = Noch einmal, langsam
  .now = Langsam, von Anfang an …
desk-gather = Meinen Körper allen zeigen
desk-pause = Alle anhalten
desk-reset = Alle zurücksetzen
desk-give-mine = Meinen Körper allen geben
  .confirm = Allen Ihren Körper geben, wie er jetzt ist? Was sie haben, ist dann weg.
desk-law = Gesetz zeigen
desk-open = Tür öffnen
desk-close = Tür schließen
desk-own-names = Namen eingeben lassen
desk-given-names = Namen vergeben
desk-sheet = Blatt zum Drucken speichern
desk-zip = Alles als Zip speichern
desk-end = Beenden
  .confirm = Stunde beenden? Alles, was abgegeben wurde, wird gelöscht.

desk-home-until = Hausaufgabe bis { $date }
  .about = Die Klasse kommt jederzeit herein, auch ohne Sie. Die richtigen Antworten sieht sie dann, oder sobald Sie sie zeigen.
desk-home-told = Hausaufgabe: Antworten gezeigt
  .about = Alle sehen die richtigen Antworten. Was jetzt eingeht, gilt als verspätet.
desk-tell = Richtige Antworten jetzt zeigen
  .confirm = Allen jetzt die richtigen Antworten zeigen? Was danach eingeht, gilt als verspätet.
desk-home-step = { $number }. { $title }: { $answered } geantwortet, { $handed } abgegeben

desk-lesson = Lektion
desk-which-lesson = Welche Lektion?
desk-lesson-steps = { $count ->
    [one] Sie hat { $count } Schritt.
   *[other] Sie hat { $count } Schritte.
  }
desk-address = Adresse
desk-which-network = In welchem Netz ist die Klasse?
desk-networks = Dieser Rechner ist in mehreren. Die Adressen der Geräte der Klasse beginnen gleich.
desk-lets-in = Lässt das Netz sie herein?
desk-scan = Mit einem Handy scannen, das im Netz der Klasse ist, oder { $address } öffnen
desk-finds-nothing = Wenn ein Handy unter dieser Adresse nichts findet, hält das Netz Geräte voneinander fern: Nutzen Sie den Hotspot dieses Rechners.

desk-tried-in-vain = Ein Gerät: Es kann nicht teilnehmen; es sagt, warum.
desk-tried = Ein Gerät: in Ordnung, { $ms } ms, { $rate } Bilder in der Sekunde
desk-tried-doubts = Ein Gerät: geht und sagt, was zu beachten ist, { $ms } ms, { $rate } Bilder in der Sekunde
desk-projector = Die Leinwand-Seite mit dem Beamer zeigen
desk-open-wall = Leinwand-Seite öffnen
desk-way-in = Das zeigt auch die Leinwand, groß: So kommt die Klasse herein.

desk-files = Antworten aus Dateien
desk-from-files = Von allen, die die Lektion als Datei hatten: Sie gelten als verspätete Antworten, jede einmal.
desk-lesson-file = Lektion als Datei für sie speichern
desk-their-files = Ihre Dateien
desk-codes = Oder der Text ihrer QR-Codes, gescannt oder eingefügt
desk-take = Übernehmen
desk-file-too-long = Diese Datei ist zu lang für Antworten zu einer Lektion.
desk-brought = { $name }: { $count ->
    [one] 1 Antwort
   *[other] { $count } Antworten
  }.
desk-brought-known = { $name }: { $count ->
    [one] 1 Antwort
   *[other] { $count } Antworten
  }, { $known } davor schon eingelesen.
desk-brought-goals = { $count ->
    [one] Laut der Datei selbst ist das Ziel von Schritt { $steps } erreicht.
   *[other] Laut der Datei selbst sind die Ziele der Schritte { $steps } erreicht.
  }

desk-count-handed-in = { $count ->
    [one] hat abgegeben
   *[other] haben abgegeben
  }
desk-count-trying = { $count ->
    [one] probiert
   *[other] probieren
  }
desk-count-exploded = { $count ->
    [one] ist explodiert
   *[other] sind explodiert
  }
desk-count-idle = { $count ->
    [one] hat noch nichts verändert
   *[other] haben noch nichts verändert
  }

desk-chose = Was gewählt wurde
  .now = Was bisher gewählt wurde
desk-sealed = nur Sie sehen das
desk-most = { $count ->
    [one] Eine Person hat „{ $choice }“ gewählt: Fragen Sie nach, warum.
   *[other] { $count } haben „{ $choice }“ gewählt: Fragen Sie nach, warum.
  }
desk-predicted = { $count } haben eine Vorhersage abgegeben.
  .some = { $count } von { $all } haben eine Vorhersage abgegeben.
desk-found = Was bisher gefunden wurde

desk-who = Wer da ist
desk-who-away = { $here }; { $away } weg
desk-nobody = Noch niemand.
desk-name-two = { $name } (zwei)
desk-two = zwei
desk-away = weg
desk-follows = sieht Ihren Körper
desk-done = { $done } von { $steps } Schritten
desk-moving = in Bewegung
desk-untouched = noch nichts verändert
desk-at-rest = in Ruhe
desk-paused = angehalten
desk-exploded = explodiert
desk-goal-reached = Ziel erreicht
desk-on-wall = auf der Leinwand
desk-has-predicted = hat vorhergesagt
desk-has-answered = hat geantwortet
desk-hand = meldet sich
desk-lower-hands = Meldungen löschen
desk-to-wall = Auf die Leinwand
desk-off-wall = Von der Leinwand nehmen
desk-reset-one = Diesen zurücksetzen
desk-to-all = Zurück zu allen
desk-move = Auf ein anderes Gerät umziehen
desk-move-digits = Am anderen Gerät: { $digits }
desk-move-how = Dort hereinkommen, „Dieser Platz“ wählen und { $digits } eingeben.
desk-remove = Entfernen
  .confirm = Den Platz von { $name } schließen? Was dort abgegeben wurde, wird auch gelöscht.

desk-work = Abgegeben: { $count }
desk-lines = Sätze: { $count }
desk-predictions = Vorhersagen: { $count }
desk-gave = Abgegeben: { $what }
desk-by = { $name }: { $what }
desk-a-prediction = eine Vorhersage
desk-a-run = ein Lauf
desk-late = { $what } (verspätet)
desk-doubt = { $what }: { $doubt }
desk-star = Diesen Satz auf der Leinwand zeigen, von { $name }
desk-show-body = Den Körper von { $name } auf der Leinwand zeigen
desk-show-prediction = Die Vorhersage von { $name } allein auf der Leinwand zeigen

desk-not-possible = Das ist nicht möglich
desk-cannot-begin = Dieser Schritt kann nicht beginnen
desk-no-zip = Das Zip ließ sich nicht erstellen
desk-no-file = Die Datei der Lektion ließ sich nicht erstellen
desk-no-sheet = Das Blatt ließ sich nicht erstellen
desk-the-run = der Lauf
desk-unkept-title = Die Stunde wird nicht gespeichert
desk-unkept = { $reason }. Was jetzt abgegeben wird, wartet auf den Seiten der Klasse und ist weg, wenn diese geschlossen werden. Schaffen Sie Platz auf der Festplatte des Rechners, auf dem die Stunde läuft, oder speichern Sie jetzt das Zip.
desk-kept-title = Die Stunde wird wieder gespeichert
desk-kept = Alles, was abgegeben wurde, ist auf der Festplatte.
desk-goes-on-title = Die Stunde geht weiter
desk-goes-on = Ihr Ordner { $folder } lässt sich nicht löschen: { $reason }.
class-refuse-no-body = Dieser Platz hat gerade keinen eigenen Körper.
class-refuse-no-replay = Es gibt keinen Lauf, der noch einmal zu sehen wäre.
class-refuse-replay-broken = Der Lauf lässt sich nicht noch einmal zeigen: { $reason }.
class-refuse-classes = Auf einem Server ist Platz für höchstens { $most } Klassen.
class-refuse-scenes = Eine Stunde hat höchstens { $most } Schritte; diese Szenen haben { $steps }.
class-refuse-no-code = Das ist kein Code von Antworten: Er beginnt mit SR1 und hat Buchstaben und Ziffern.
class-refuse-no-file = Diese Datei enthält keine Antworten zu einer Lektion.
class-refuse-misread = Der Code ist falsch gelesen worden: Scannen Sie ihn noch einmal.
class-refuse-other-steps = Diese Antworten gehören zu einer Lektion mit einer anderen Anzahl von Schritten.
class-refuse-empty = Darin ist noch keine Antwort.
class-refuse-other-lesson = Diese Antworten gehören zu einer anderen Lektion als der dieser Klasse.

class-doubt-begins = die Aufzeichnung beginnt mit { $what }.
class-doubt-goes-on = die Aufzeichnung geht weiter mit { $what }.
class-doubt-begins-other = die Aufzeichnung beginnt mit einer anderen Szene als der des Schritts.
class-doubt-goes-on-other = die Aufzeichnung geht mit einer anderen Szene als der des Schritts weiter.
class-doubt-sets = die Aufzeichnung stellt { $what } ein, wofür dieser Schritt keinen Regler hat.
class-doubt-never = die Aufzeichnung geht von dort weiter, wo der Körper nie war; neu beginnen und diesen Lauf abgeben.
class-doubt-long = die Aufzeichnung hat mehr als { $what }.

## Das Zip, das die Lehrkraft mitnimmt.

zip-readme = 
    Was eine Klasse abgegeben hat: { $steps ->
        [one] 1 Schritt
       *[other] { $steps } Schritte
      }, { $seats ->
        [one] 1 Platz
       *[other] { $seats } Plätze
      }.

    answers.csv      Stimmen, Sätze und was abgegeben wurde, je eine Zeile
    found.csv        was gefunden und was dazu eingestellt war, eine Zeile je Lauf
    predictions.csv  wo Massen vorhergesagt waren, in den Einheiten der Szene, eine Zeile je Masse
    scenes/          was die Klasse durchging; `softrod class scenes/*.json` geht es mit einer anderen durch
    logs/            die abgegebenen Läufe; `softrod run --inputs DATEI` lässt einen noch einmal laufen
    pictures/        wie die Körper waren, als sie abgegeben wurden

    Die Tabellen haben Dezimalkommas und zwischen den Spalten Semikolons.

    { $names } Wenn die Stunde beendet ist, bleibt davon nichts auf dem Rechner, auf dem sie lief.
zip-typed-names = Manche Plätze haben Namen, die von der Klasse eingegeben wurden.
zip-given-names = Die Plätze haben die Namen, die ihnen zugeteilt wurden.

zip-step = Schritt
zip-title = Titel
zip-asked = Runde
zip-seat = Platz
zip-name = Name
zip-pupil = Person
zip-kind = Art
zip-answer = Antwort
zip-right = richtig
zip-late = verspätet
zip-starred = Stern
zip-over = über
zip-over-unit = Einheit von über
zip-setting = Einstellung
zip-what = was
zip-unit = Einheit
zip-found = gefunden
zip-doubt = Zweifel
zip-mass = Masse
zip-x = x
zip-y = y

zip-vote = Stimme
zip-line = Satz
zip-work = abgegeben
zip-yes = ja
zip-no = nein
