modes-strip = Titreşim biçimleri
modes-close = Titreşim biçimlerini kapat
    .hint = Kapat
modes-how = Biçimini görmek için bir çubuğun üzerine gel veya Tab ile ona git. Çubuğu yükselt: cisim öyle titreşir. Onu veya boşluk tuşunu basılı tut: cisim öyle titreşmeye zorlanır.
modes-looking = Titreşim biçimleri aranıyor.
modes-none = Titreşim biçimi yok: { $why }.
modes-still = cisim, hareketsiz hâli çevresinde titreşmiyor
modes-shown = Titreşim biçimleri zaman çubuğunun üzerinde gösteriliyor
modes-reading = { $swings ->
    [no] Titreşim { $number }: { $frequency } Hz, { $amplitude }, salınmıyor, enerjideki payı { $share }
   *[yes] Titreşim { $number }: { $frequency } Hz, { $amplitude }, sönüm oranı { $damping }, enerjideki payı { $share }
}
modes-reading-driven = { $swings ->
    [no] Titreşim { $number }: { $frequency } Hz, { $amplitude }, salınmıyor, zorlanıyor
   *[yes] Titreşim { $number }: { $frequency } Hz, { $amplitude }, sönüm oranı { $damping }, zorlanıyor
}
modes-others = Bunların hiçbirinde: daha hızlı titreşimler ve büyük bir hareketi küçük olanlardan ayıran; enerjideki payı { $share }
    .lacks = Bunların hiçbirinde: daha hızlı titreşimler ve büyük bir hareketi küçük olanlardan ayıran; titreşimlerin enerjisi tek başına daha fazla olurdu, fark { $share }
    .word = diğer
modes-share = %{ $percent }
    .least = %0,1 değerinden az
modes-bar = Titreşim { $number }, { $frequency } hertz
    .others = Hiçbir titreşim biçiminde
modes-value = { $amplitude }, enerjideki payı { $share }
modes-driven = Titreşim { $number } zorlanıyor
modes-level = Titreşim { $number }: dolu bir çubuğun yüzde { $percent } kadarı
modes-volume = Ses düzeyi
modes-sound = Titreşim biçimlerinin sesi
    .on = Ses: açık
    .off = Ses: kapalı
