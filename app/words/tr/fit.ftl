fit-about = Sayfaya bırakılan bir tablo cismin üzerine çizilir ve sahne ona uydurulabilir. Tablo yapmak için: { $link }.
    .link = Bir videoda ölç
fit-table = { $count ->
   *[other] <b>{ $name }</b>: { $count } satır. Her sütun hangi büyüklük?
}
fit-run = Ölçüm dizisi
fit-column = mass1.x, -mass1.y, 90 - spring0.direction gibi veya bir formül; sütunu atlamak için boş bırak
fit-scale = Bir metredeki { $unit } sayısı
    .hint = tablonun bir metresinin sahnedeki büyüklüğü
fit-sought = Ne aranıyor?
fit-start = Başlangıç (yerler, hızlar)
fit-origin = Tablonun başlangıç noktası
fit-length-scale = Uzunluk ölçeği
fit-fit = Uydur
fit-forget = Tabloyu kaldır
fit-begins = Uydurma başlıyor…
fit-goes-on = Uyduruluyor: { $what }…
fit-cannot = <b>Uydurulamıyor</b>: { $why }.
fit-error = Sunucuda bir hata oldu.
fit-no-table = tablo yok
fit-many-masses = bir sayfa en çok { $count } kütleyi uydurur; softrod fit daha fazlasını kabul eder
fit-many-numbers = bir sayfa en çok { $count } sayıyı uydurur; softrod fit daha fazlasını kabul eder
fit-no-scale = bir metrenin sahnede kaç { $unit } olduğunu yaz, 0.000001..1e9, veya uzunluk ölçeğini arat
fit-choose = aranan sayılardan { $count } değil, en az 1, en çok { $most } tanesini seç
fit-compiling = çözücü hâlâ derleniyor; biraz sonra yeniden dene
fit-changed = sahne bu sırada değişti; yeniden uydur
fit-left = { $column }: geriye kalan { $noise }.
