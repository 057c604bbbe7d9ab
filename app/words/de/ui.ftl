ui-templates = Winkelvorlage
ui-mixed = { $setting } (gemischt)
    .angles = der Regler dreht den ersten Winkel und die anderen um ebenso viel
    .numbers = der Regler setzt die größte Zahl, die anderen behalten ihr Verhältnis dazu
    .note = <b>gemischt</b>: { $what }.
ui-range = { $low } bis { $high }
