stage-away = Cisim görüş alanının dışında. Bütün sahneyi göster
stage-drag = beni sürükle
stage-empty = Burada henüz hiçbir şey kurulmadı.
    .draw = Bir cisim çiz
    .tap = Kütle için dokun. Yay için bir kütleden başlayarak sürükle.
    .click = Kütle için tıkla. Yay için bir kütleden başlayarak sürükle.
    .taps = Kütle için dokun. Yay için önce bir kütleye, sonra bir başkasına dokun.
