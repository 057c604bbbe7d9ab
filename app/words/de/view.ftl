view-menu = Ansicht
    .hint = Ansicht: dunkel, Beamer, Hilfe und mehr
view-help = So benutzt du softrod
view-help-drag = <b>Ziehe</b> eine Masse. Festgehaltene bleiben, wo du sie loslässt, freie fallen. Ziehe das Papier, um es zu verschieben; mit Mausrad oder zwei Fingern zoomst du.
view-help-change = <b>Ändere</b> Steifigkeit, Dämpfung, Längen und Winkel unter „Spielen“, oder zeichne mit „Bearbeiten“ einen eigenen Körper.
view-help-measure = <b>Miss</b> mit Diagrammen, an denen du Periode und Dämpfung abliest, mit Pfeilen, Lineal, Winkelmesser und Stoppuhr.
view-help-time = Die Leiste unter dem Körper geht zu jedem Augenblick des Laufs zurück. „Abspielen“ geht von dort aus weiter; was vorher geschah, bleibt als dünne Linie. Klicke oder tippe eine Masse an, um ihr Gelenk abzulesen.
